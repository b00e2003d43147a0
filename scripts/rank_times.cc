// SPDX-License-Identifier: LGPL-2.1-or-later
// A library for LD_PRELOAD: notes for each call of MPI that waits or sends between two ranks how
// much CPU time the process has spent outside of MPI since the last one. MPI_Finalize() writes them
// into the folder TIMES_FOLDER, one file per rank: CPU time [s], what kind of call, its tag. See
// rank_times.py.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <mpi.h>
#include <string>
#include <vector>

namespace
{
enum Kind
{
  exchange,   // with the other rank
  send,       // without waiting
  receive,    // waits
  collective, // waits for all
  end
};

struct Call
{
  double busy;
  int    kind, tag;
};

std::vector<Call> calls;
double            last  = 0.;
int               depth = 0, tag_of_irecv = 0;

double cpu()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

bool is_alone(const MPI_Comm comm)
{
  int size = 0;
  PMPI_Comm_size(comm, &size);
  return size == 1;
}

// MPI may call itself: only the outermost call counts.
template <typename Function>
int noted(const Kind kind, const int tag, const Function &call)
{
  if (depth++ == 0)
    calls.push_back({cpu() - last, kind, tag});
  const int result = call();
  if (--depth == 0)
    last = cpu();
  return result;
}

template <typename Function>
int together(const MPI_Comm comm, const Function &call)
{
  return is_alone(comm) ? call() : noted(collective, 0, call);
}
} // namespace

extern "C"
{
  int MPI_Sendrecv(const void  *a,
                   int          b,
                   MPI_Datatype c,
                   int          d,
                   int          tag,
                   void        *f,
                   int          g,
                   MPI_Datatype h,
                   int          i,
                   int          j,
                   MPI_Comm     k,
                   MPI_Status  *l)
  {
    return noted(
        exchange, tag, [&] { return PMPI_Sendrecv(a, b, c, d, tag, f, g, h, i, j, k, l); });
  }
  int MPI_Isend(const void *a, int b, MPI_Datatype c, int d, int tag, MPI_Comm f, MPI_Request *g)
  {
    return noted(send, tag, [&] { return PMPI_Isend(a, b, c, d, tag, f, g); });
  }
  int MPI_Recv(void *a, int b, MPI_Datatype c, int d, int tag, MPI_Comm f, MPI_Status *g)
  {
    return noted(receive, tag, [&] { return PMPI_Recv(a, b, c, d, tag, f, g); });
  }
  int MPI_Irecv(void *a, int b, MPI_Datatype c, int d, int tag, MPI_Comm f, MPI_Request *g)
  {
    tag_of_irecv = tag;
    return PMPI_Irecv(a, b, c, d, tag, f, g);
  }
  int MPI_Waitany(int a, MPI_Request *b, int *c, MPI_Status *d)
  {
    return noted(receive, tag_of_irecv, [&] { return PMPI_Waitany(a, b, c, d); });
  }
  int MPI_Allreduce(const void *a, void *b, int c, MPI_Datatype d, MPI_Op e, MPI_Comm f)
  {
    return together(f, [&] { return PMPI_Allreduce(a, b, c, d, e, f); });
  }
  int MPI_Bcast(void *a, int b, MPI_Datatype c, int d, MPI_Comm e)
  {
    return together(e, [&] { return PMPI_Bcast(a, b, c, d, e); });
  }
  int MPI_Barrier(MPI_Comm a)
  {
    return together(a, [&] { return PMPI_Barrier(a); });
  }
  int MPI_Allgather(
      const void *a, int b, MPI_Datatype c, void *d, int e, MPI_Datatype f, MPI_Comm g)
  {
    return together(g, [&] { return PMPI_Allgather(a, b, c, d, e, f, g); });
  }
  int MPI_Allgatherv(const void  *a,
                     int          b,
                     MPI_Datatype c,
                     void        *d,
                     const int   *e,
                     const int   *f,
                     MPI_Datatype g,
                     MPI_Comm     h)
  {
    return together(h, [&] { return PMPI_Allgatherv(a, b, c, d, e, f, g, h); });
  }
  int MPI_Finalize()
  {
    calls.push_back({cpu() - last, end, 0});
    int rank = 0;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const char *folder = std::getenv("TIMES_FOLDER");
    if (std::FILE *file = folder == nullptr ?
                              nullptr :
                              std::fopen((folder + ("/" + std::to_string(rank))).c_str(), "w"))
      {
        for (const Call &call : calls)
          std::fprintf(file, "%.9g %d %d\n", call.busy, call.kind, call.tag);
        std::fclose(file);
      }
    return PMPI_Finalize();
  }
}
