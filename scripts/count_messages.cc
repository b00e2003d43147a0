// SPDX-License-Identifier: LGPL-2.1-or-later
// Counts what a rank sends through MPI, for count_messages.py, which compiles this into a library
// that is loaded before MPI's: it stands in front of MPI's functions and calls theirs (PMPI). When
// MPI ends each rank writes a file of its number, in the folder that MESSAGES_FOLDER names:
//
//     to RANK MESSAGES BYTES       from point to point, one line for each rank
//     NAME CALLS BYTES             of a function that all ranks call, bytes that this one gives
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace
{
struct Count
{
  unsigned long calls = 0, bytes = 0;

  void add(const long n, MPI_Datatype type)
  {
    int size = 0;
    PMPI_Type_size(type, &size);
    ++calls;
    bytes += n * size;
  }
};

std::vector<Count>           sent; // [rank in MPI_COMM_WORLD]
std::map<std::string, Count> collective;

Count &to(const int rank, MPI_Comm comm)
{
  MPI_Group here, world;
  PMPI_Comm_group(comm, &here);
  PMPI_Comm_group(MPI_COMM_WORLD, &world);
  int there = 0, n = 0;
  PMPI_Group_translate_ranks(here, 1, &rank, world, &there);
  PMPI_Comm_size(MPI_COMM_WORLD, &n);
  PMPI_Group_free(&here);
  PMPI_Group_free(&world);
  sent.resize(n);
  return sent[there];
}

int refuse(const char *name)
{
  std::fprintf(stderr, "%s: count_messages.cc does not count what it sends.\n", name);
  return PMPI_Abort(MPI_COMM_WORLD, 1);
}
} // namespace

#define SENDS(name)                                                                                \
  int MPI_##name(const void *data, int n, MPI_Datatype type, int rank, int tag, MPI_Comm comm)     \
  {                                                                                                \
    to(rank, comm).add(n, type);                                                                   \
    return PMPI_##name(data, n, type, rank, tag, comm);                                            \
  }
#define SENDS_LATER(name)                                                                          \
  int MPI_##name(const void  *data,                                                                \
                 int          n,                                                                   \
                 MPI_Datatype type,                                                                \
                 int          rank,                                                                \
                 int          tag,                                                                 \
                 MPI_Comm     comm,                                                                \
                 MPI_Request *request)                                                             \
  {                                                                                                \
    to(rank, comm).add(n, type);                                                                   \
    return PMPI_##name(data, n, type, rank, tag, comm, request);                                   \
  }
#define REFUSES(name)                                                                              \
  int MPI_##name(const void *, int, MPI_Datatype, int, int, MPI_Comm, MPI_Request *)               \
  {                                                                                                \
    return refuse("MPI_" #name);                                                                   \
  }

extern "C"
{
  SENDS(Send)
  SENDS(Bsend)
  SENDS(Ssend)
  SENDS(Rsend)
  SENDS_LATER(Isend)
  SENDS_LATER(Ibsend)
  SENDS_LATER(Issend)
  SENDS_LATER(Irsend)
  REFUSES(Send_init)
  REFUSES(Ssend_init)

  int MPI_Sendrecv(const void  *give,
                   int          n,
                   MPI_Datatype type,
                   int          rank,
                   int          tag,
                   void        *take,
                   int          n_taken,
                   MPI_Datatype taken,
                   int          from,
                   int          tag_of_taken,
                   MPI_Comm     comm,
                   MPI_Status  *status)
  {
    to(rank, comm).add(n, type);
    return PMPI_Sendrecv(
        give, n, type, rank, tag, take, n_taken, taken, from, tag_of_taken, comm, status);
  }

  int MPI_Allreduce(
      const void *give, void *take, int n, MPI_Datatype type, MPI_Op operation, MPI_Comm comm)
  {
    collective["Allreduce"].add(n, type);
    return PMPI_Allreduce(give, take, n, type, operation, comm);
  }

  int MPI_Reduce(const void  *give,
                 void        *take,
                 int          n,
                 MPI_Datatype type,
                 MPI_Op       operation,
                 int          root,
                 MPI_Comm     comm)
  {
    collective["Reduce"].add(n, type);
    return PMPI_Reduce(give, take, n, type, operation, root, comm);
  }

  int MPI_Bcast(void *data, int n, MPI_Datatype type, int root, MPI_Comm comm)
  {
    int rank = 0;
    PMPI_Comm_rank(comm, &rank);
    collective["Bcast"].add(rank == root ? n : 0, type);
    return PMPI_Bcast(data, n, type, root, comm);
  }

  int MPI_Allgather(const void  *give,
                    int          n_given,
                    MPI_Datatype given,
                    void        *take,
                    int          n_taken,
                    MPI_Datatype taken,
                    MPI_Comm     comm)
  {
    collective["Allgather"].add(n_taken, taken);
    return PMPI_Allgather(give, n_given, given, take, n_taken, taken, comm);
  }

  int MPI_Gatherv(const void  *give,
                  int          n_given,
                  MPI_Datatype given,
                  void        *take,
                  const int    n_taken[],
                  const int    places[],
                  MPI_Datatype taken,
                  int          root,
                  MPI_Comm     comm)
  {
    collective["Gatherv"].add(n_given, given);
    return PMPI_Gatherv(give, n_given, given, take, n_taken, places, taken, root, comm);
  }

  int MPI_Barrier(MPI_Comm comm)
  {
    collective["Barrier"].add(0, MPI_CHAR);
    return PMPI_Barrier(comm);
  }

  int MPI_Finalize()
  {
    int rank = 0, n = 0;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    PMPI_Comm_size(MPI_COMM_WORLD, &n);
    sent.resize(n);
    const char       *folder = std::getenv("MESSAGES_FOLDER");
    const std::string path   = std::string(folder != nullptr ? folder : ".") + "/";
    if (std::FILE *file = std::fopen((path + std::to_string(rank)).c_str(), "w"))
      {
        for (int other = 0; other < n; ++other)
          std::fprintf(file, "to %d %lu %lu\n", other, sent[other].calls, sent[other].bytes);
        for (const auto &[name, count] : collective)
          std::fprintf(file, "%s %lu %lu\n", name.c_str(), count.calls, count.bytes);
        std::fclose(file);
      }
    return PMPI_Finalize();
  }
}
