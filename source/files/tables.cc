// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/files/tables.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <hdf5.h>
#include <new>
#include <ostream>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace chaindrive::files
{
namespace
{
using Object = Hdf5Object;

/// HDF5 prints nothing of what it returns.
Object open_file(const std::string &path)
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return Object(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
}

/// What a call returned that makes a part of a file in memory: there it fails for want of that
/// only.
template <typename Result>
Result made(const Result result)
{
  if (result < 0)
    throw std::bad_alloc();
  return result;
}

void add_table(const Object &file, const Table &table)
{
  const TableInfo             &info = table.info;
  const std::array<hsize_t, 2> size{{table.n_rows(), info.columns}};
  const Object space(made(H5Screate_simple(info.columns == 1 ? 1 : 2, size.data(), nullptr)));
  const Object links(made(H5Pcreate(H5P_LINK_CREATE)));
  made(H5Pset_create_intermediate_group(links, 1));
  const Object dataset(made(
      H5Dcreate2(file, info.path.c_str(), H5T_IEEE_F64LE, space, links, H5P_DEFAULT, H5P_DEFAULT)));
  made(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()));
  for (const auto &[name, value] : info.attributes)
    made(write_attribute(dataset, name, {value}));
  if (!info.labels.empty())
    made(write_attribute(dataset, "columns", info.labels));
}
} // namespace

TableFile::TableFile(const std::string &path) : path_(path), file_(open_file(path))
{
  if (file_ >= 0)
    return;
  if (::access(path.c_str(), R_OK) != 0)
    throw InputError("'" + path + "' cannot be read: " + std::generic_category().message(errno) +
                     ".");
  throw InputError("'" + path + "' cannot be read: it is no HDF5 file, or it is damaged.");
}

bool TableFile::has(const std::string &dataset) const
{
  return Object(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT)) >= 0;
}

void TableFile::refuse(const std::string &dataset, const std::string &why) const
{
  throw InputError("'" + path_ + "': the dataset " + dataset + " " + why + ".");
}

Table TableFile::read(const std::string &dataset,
                      const std::size_t  first,
                      const std::size_t  n) const
{
  const Object table(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT));
  if (table < 0)
    refuse(dataset, "is missing or damaged");
  const Object           space(H5Dget_space(table)), type(H5Dget_type(table));
  std::array<hsize_t, 2> size{{0, 1}};
  const int              rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1 || rank > 2 || H5Tget_class(type) != H5T_FLOAT ||
      H5Sget_simple_extent_dims(space, size.data(), nullptr) < 0 || size[1] == 0)
    refuse(dataset, "is no table of numbers");
  const std::array<hsize_t, 2> start{{std::min<hsize_t>(first, size[0]), 0}};
  const std::array<hsize_t, 2> count{{std::min<hsize_t>(n, size[0] - start[0]), size[1]}};

  Table result{{dataset, static_cast<unsigned int>(size[1]), {}, read_labels(table, dataset)}, {}};
  result.values.resize(count[0] * count[1]);
  if (result.values.empty())
    return result;
  const Object memory(H5Screate_simple(rank, count.data(), nullptr));
  if (H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) <
          0 ||
      H5Dread(table, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, result.values.data()) < 0)
    refuse(dataset, "is damaged");
  return result;
}

std::vector<std::string> TableFile::read_labels(const Object      &table,
                                                const std::string &dataset) const
{
  if (H5Aexists(table, "columns") <= 0)
    return {};
  const Object attribute(H5Aopen(table, "columns", H5P_DEFAULT));
  const Object type(H5Aget_type(attribute)), space(H5Aget_space(attribute));
  if (H5Tis_variable_str(type) <= 0)
    refuse(dataset, "has names of columns that are no texts");
  const hssize_t      n = H5Sget_simple_extent_npoints(space);
  std::vector<char *> texts(n > 0 ? n : 0, nullptr);
  const Object        memory(H5Tcopy(H5T_C_S1));
  H5Tset_size(memory, H5T_VARIABLE);
  H5Tset_cset(memory, H5Tget_cset(type));
  if (H5Aread(attribute, memory, texts.data()) < 0)
    refuse(dataset, "is damaged: the names of its columns cannot be read");
  std::vector<std::string> labels;
  labels.reserve(texts.size());
  for (const char *text : texts)
    labels.emplace_back(text != nullptr ? text : "");
  H5Dvlen_reclaim(memory, space, H5P_DEFAULT, texts.data());
  return labels;
}

void write_tables(const std::string        &path,
                  const Attributes         &attributes,
                  const std::vector<Table> &tables)
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Object access(made(H5Pcreate(H5P_FILE_ACCESS)));
  made(H5Pset_fapl_core(access, 1 << 20, false));
  std::vector<char> bytes;
  {
    const Object file(made(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)));
    for (const auto &[name, value] : attributes)
      made(write_attribute(file, name, {value}));
    for (const Table &table : tables)
      add_table(file, table);
    made(H5Fflush(file, H5F_SCOPE_GLOBAL));
    bytes.resize(made(H5Fget_file_image(file, nullptr, 0)));
    made(H5Fget_file_image(file, bytes.data(), bytes.size()));
  }
  write_file(path, [&bytes](std::ostream &out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}
} // namespace chaindrive::files
