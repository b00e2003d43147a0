// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/files/hdf5_object.h>
#include <chaindrive/files/history_file.h>
#include <chaindrive/files/packed_rows.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <hdf5.h>
#include <limits>
#include <memory>
#include <new>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace chaindrive::files
{
namespace
{
using Object = Hdf5Object;

/// The reason of the last failed HDF5 call: the system's error number where there was one.
int last_error_number()
{
  int error = 0;
  H5Ewalk2(
      H5E_DEFAULT,
      H5E_WALK_UPWARD,
      [](unsigned int, const H5E_error2_t *entry, void *result) -> herr_t {
        const char *found = entry->desc != nullptr ? std::strstr(entry->desc, "errno = ") : nullptr;
        if (found != nullptr)
          *static_cast<int *>(result) = std::atoi(found + std::strlen("errno = "));
        return 0;
      },
      &error);
  return error != 0 ? error : EIO;
}
} // namespace

struct HistoryFile::Data
{
  std::string               path;
  std::size_t               rows, block;
  std::vector<unsigned int> columns;
  std::vector<bool>         single;
  Object                    file;
  std::vector<Object>       tables;
  int                       descriptor = -1; ///< of the open file, owned by HDF5
  bool                      abandoned  = false;
  bool                      complete   = false; ///< opened to be read
  bool                      compressed = false;

  ~Data()
  {
    // a flush that failed leaves the library's cache in a state that only the next flush clears
    if (abandoned && file >= 0)
      H5Fflush(file, H5F_SCOPE_GLOBAL);
  }

  /// Returns what an HDF5 call returned, or gives the file up when the call failed.
  template <typename Result>
  Result check(const Result result)
  {
    if (result < 0)
      abandon(last_error_number());
    return result;
  }

  /// The library keeps what it could not write, tries again when it closes the file and crashes at
  /// the end of the program when that fails as well. From now on it writes to memory instead, which
  /// vanishes with the file; a few kilobytes, since numbers are not kept.
  [[noreturn]] void abandon(const int error)
  {
    if (complete)
      throw InputError("The histories '" + path + "' cannot be read: the file is damaged.");
    abandoned = true;
    if (descriptor >= 0)
      {
        const int memory = ::memfd_create("abandoned", MFD_CLOEXEC);
        ::dup2(memory, descriptor);
        ::close(memory);
      }
    throw RunError(write_failure(path, error));
  }

  /// Takes the disk space for @p n further rows at the end of a file, so that HDF5 will not fail to
  /// get it half-way. Returns an error number, or 0.
  int reserve(const int of_file, const std::size_t n) const
  {
    struct ::stat status;
    if (::fstat(of_file, &status) != 0)
      return errno;
    std::size_t bytes = 65536;
    for (std::size_t t = 0; t < columns.size(); ++t)
      bytes += (n / block + 1) * block * columns[t] * (single[t] ? 4 : 8) + 8192;
    const int error = ::posix_fallocate(of_file, status.st_size, bytes);
    if (error == 0 || error == EOPNOTSUPP || error == EINVAL) // not every file system can do this
      return 0;
    [[maybe_unused]] const int ignored = ::ftruncate(of_file, status.st_size);
    return error;
  }

  /// Gives back the space that was taken and not used.
  void release()
  {
    hsize_t size;
    check(H5Fflush(file, H5F_SCOPE_GLOBAL));
    check(H5Fget_filesize(file, &size));
    if (::ftruncate(descriptor, size) != 0)
      abandon(errno);
  }

  void resize(const std::size_t n)
  {
    for (std::size_t t = 0; t < tables.size(); ++t)
      {
        const hsize_t size[2] = {n, columns[t]};
        check(H5Dset_extent(tables[t], size));
      }
    rows = n;
  }

  void add_table(const TableInfo &info)
  {
    const int     rank         = info.columns == 1 ? 1 : 2;
    const hsize_t size[2]      = {rows, info.columns};
    const hsize_t unlimited[2] = {H5S_UNLIMITED, info.columns};
    const hsize_t chunk[2]     = {block, info.columns};
    const Object  space(check(H5Screate_simple(rank, size, unlimited)));

    const Object creation(check(H5Pcreate(H5P_DATASET_CREATE)));
    const double unwritten = std::numeric_limits<double>::quiet_NaN();
    check(H5Pset_chunk(creation, rank, chunk));
    check(H5Pset_fill_value(creation, H5T_NATIVE_DOUBLE, &unwritten));
    check(H5Pset_alloc_time(creation, compressed ? H5D_ALLOC_TIME_INCR : H5D_ALLOC_TIME_EARLY));
    if (compressed)
      {
        check(H5Pset_shuffle(creation));
        check(H5Pset_deflate(creation, 4));
      }

    const Object links(check(H5Pcreate(H5P_LINK_CREATE)));
    check(H5Pset_create_intermediate_group(links, 1));

    // No cache: a write that fails fails at once and leaves nothing behind to be written later.
    const Object access(check(H5Pcreate(H5P_DATASET_ACCESS)));
    check(H5Pset_chunk_cache(access, 0, 0, 1.));

    tables.emplace_back(check(H5Dcreate2(file,
                                         info.path.c_str(),
                                         info.single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE,
                                         space,
                                         links,
                                         creation,
                                         access)));
    for (const auto &[name, value] : info.attributes)
      check(write_attribute(tables.back(), name, {value}));
    if (!info.labels.empty())
      check(write_attribute(tables.back(), "columns", info.labels));
  }

  /// The spaces of @p n rows from @p first on, in memory and in table @p t.
  std::pair<Object, Object>
  select(const std::size_t t, const std::size_t first, const std::size_t n)
  {
    const hsize_t start[2] = {first, 0};
    const hsize_t count[2] = {n, columns[t]};
    Object        memory(check(H5Screate_simple(columns[t] == 1 ? 1 : 2, count, nullptr)));
    Object        space(check(H5Dget_space(tables[t])));
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr));
    return {std::move(memory), std::move(space)};
  }

  /// Writes the chunks of the block that begins with row @p first.
  void write_block(const std::size_t first, const std::vector<PackedChunk> &chunks)
  {
    constexpr unsigned not_deflated = 1U << 1; // of the filters shuffle and deflate the second
    const hsize_t      start[2]     = {first, 0};
    for (std::size_t t = 0; t < tables.size(); ++t)
      check(H5Dwrite_chunk(tables[t],
                           H5P_DEFAULT,
                           chunks[t].deflated ? 0 : not_deflated,
                           start,
                           chunks[t].bytes.size(),
                           chunks[t].bytes.data()));
  }

  void make(const Attributes &attributes, const std::vector<TableInfo> &infos)
  {
    // failures are reported by exceptions only
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    for (const TableInfo &info : infos)
      {
        columns.push_back(info.columns);
        single.push_back(info.single);
      }

    const Object access(check(H5Pcreate(H5P_FILE_ACCESS)));
    check(H5Pset_sieve_buf_size(access, 0));
    // The format of HDF5 1.8: before it an attribute, the names of many columns, has at most 64
    // KiB; a later one marks the file as being written, and nobody could read it meanwhile.
    check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
    // first without HDF5, which need not be tidied up after
    const int trial = create_anew(path);
    if (trial < 0)
      abandon(errno);
    const int error = compressed ? 0 : reserve(trial, rows);
    ::close(trial);
    if (error != 0)
      {
        ::unlink(path.c_str());
        abandon(error);
      }

    // for want of this room the library would not fail but crash
    void *volatile room = std::malloc(16 << 20);
    if (room == nullptr)
      throw std::bad_alloc();
    std::free(room);
    file = Object(check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)));
    void *handle;
    check(H5Fget_vfd_handle(file, access, &handle));
    descriptor = *static_cast<int *>(handle);
    // the file is valid at any instant: others may read it while it is being written
    ::flock(descriptor, LOCK_UN);

    if (const int now = compressed ? 0 : reserve(descriptor, rows); now != 0)
      abandon(now);
    for (const auto &[name, value] : attributes)
      check(write_attribute(file, name, {value}));
    for (const TableInfo &info : infos)
      add_table(info);
    release();
  }
};

HistoryFile::HistoryFile(const std::string            &path,
                         const Attributes             &attributes,
                         const std::vector<TableInfo> &tables,
                         const std::size_t             rows,
                         const std::size_t             block)
    : data_(std::make_unique<Data>())
{
  data_->path  = path;
  data_->block = std::max<std::size_t>(block, 1);
  data_->rows  = std::max<std::size_t>(rows, 1);
  try
    {
      data_->make(attributes, tables);
    }
  catch (const RunError &)
    {
      // without its tables it is of no use
      if (data_->descriptor >= 0)
        ::unlink(path.c_str());
      throw;
    }
}

HistoryFile::HistoryFile() : data_(std::make_unique<Data>()) {}

std::string HistoryFile::compress(const std::string            &path,
                                  const Attributes             &attributes,
                                  const std::vector<TableInfo> &tables,
                                  const PackedRows             &packed)
{
  const std::string part = path + ".part";
  std::string       why;
  try
    {
      HistoryFile from(path, tables), to;
      Data       &d = *to.data_;
      d.path        = part;
      d.compressed  = true;
      d.rows        = from.n_rows();
      d.block       = std::clamp<std::size_t>(packed.block(), 1, std::max<std::size_t>(d.rows, 1));
      d.make(attributes, tables);
      RowPacker                        packer(tables, d.block);
      std::vector<std::vector<double>> values;
      for (std::size_t first = 0; first < d.rows; first += d.block)
        if (const std::vector<PackedChunk> *chunks = packed.find(first);
            chunks != nullptr && d.block == packed.block())
          d.write_block(first, *chunks);
        else
          {
            const std::size_t n = std::min(d.block, d.rows - first);
            values.resize(tables.size());
            for (std::size_t t = 0; t < tables.size(); ++t)
              values[t].resize(d.block * tables[t].columns);
            from.read(first, n, values);
            d.write_block(first, packer.pack(n, values));
          }
      to.close(d.rows);
      sync_file(part); // its name must not be there before its content
      if (std::rename(part.c_str(), path.c_str()) == 0)
        return "";
      why = write_failure(path, errno);
    }
  catch (const RunError &error) // the disk is full
    {
      why = error.what();
    }
  catch (const InputError &error) // something else has removed, cut or locked the file
    {
      why = error.what();
    }
  ::unlink(part.c_str());
  return "Histories were not compressed: " + why;
}

HistoryFile::HistoryFile(const std::string &path, const std::vector<TableInfo> &tables)
    : data_(std::make_unique<Data>())
{
  Data &d    = *data_;
  d.path     = path;
  d.complete = true;
  d.rows     = std::numeric_limits<std::size_t>::max();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  if (::access(path.c_str(), R_OK) != 0)
    throw InputError("The histories '" + path +
                     "' cannot be read: " + std::generic_category().message(errno) + ".");
  d.file = Object(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (d.file < 0)
    throw InputError("The histories '" + path + "' cannot be read: " +
                     (last_error_number() == EAGAIN ?
                          "another program has the file open to write." :
                          "the file is damaged."));
  for (const TableInfo &info : tables)
    {
      d.columns.push_back(info.columns);
      d.tables.emplace_back(d.check(H5Dopen2(d.file, info.path.c_str(), H5P_DEFAULT)));
      const Object space(d.check(H5Dget_space(d.tables.back())));
      hsize_t      size[2] = {0, 1};
      const int    rank    = H5Sget_simple_extent_ndims(space);
      if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space, size, nullptr) < 0 ||
          size[1] != info.columns)
        throw InputError("The histories '" + path + "' are of another run: " + info.path +
                         " has not " + std::to_string(info.columns) + " columns there.");
      d.rows = std::min<std::size_t>(d.rows, size[0]);
    }
}

HistoryFile::~HistoryFile() = default;

std::size_t HistoryFile::n_rows() const { return data_->rows; }

void HistoryFile::read(const std::size_t                 first,
                       const std::size_t                 n,
                       std::vector<std::vector<double>> &values)
{
  for (std::size_t t = 0; t < data_->tables.size(); ++t)
    {
      const auto [memory, space] = data_->select(t, first, n);
      data_->check(H5Dread(
          data_->tables[t], H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values[t].data()));
    }
}

void HistoryFile::write(const std::size_t                       first,
                        const std::size_t                       n,
                        const std::vector<std::vector<double>> &values)
{
  Data &d = *data_;
  if (d.abandoned || n == 0)
    return;
  if (first + n > d.rows)
    {
      const std::size_t more = std::max(first + n - d.rows, d.rows);
      if (const int error = d.reserve(d.descriptor, more); error != 0)
        d.abandon(error);
      d.resize(d.rows + more);
      d.release();
    }
  const auto write_table = [&](const std::size_t t) {
    const auto [memory, space] = d.select(t, first, n);
    d.check(H5Dwrite(d.tables[t], H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values[t].data()));
  };
  for (std::size_t t = 1; t < d.tables.size(); ++t)
    write_table(t);
  d.check(H5Fflush(d.file, H5F_SCOPE_GLOBAL));
  // The times come last: a row that has one is whole, whoever reads it meanwhile.
  write_table(0);
  d.check(H5Fflush(d.file, H5F_SCOPE_GLOBAL));
}

void HistoryFile::close(const std::size_t rows)
{
  Data &d = *data_;
  if (d.abandoned || d.file < 0)
    return;
  if (rows != d.rows)
    d.resize(rows);
  // First the tables, then the end of the file: if one fails, the file is still as long as all it
  // refers to.
  for (const Object &table : d.tables)
    d.check(H5Dflush(table));
  d.check(H5Fflush(d.file, H5F_SCOPE_GLOBAL));
  d.tables.clear();
  d.descriptor = -1;
  if (H5Fclose(d.file.release()) < 0)
    throw RunError(write_failure(d.path, last_error_number()));
}
} // namespace chaindrive::files
