// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/files/saved_rows.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <utility>

namespace chaindrive::files
{
namespace fs = std::filesystem;

namespace
{
std::string saved(const std::string &prefix) { return prefix + ".saved"; }
std::string whole(const std::string &prefix) { return prefix + ".h5"; }

std::vector<TableInfo> tables_of(const SavedMark &mark)
{
  std::vector<TableInfo> tables;
  for (std::size_t t = 0; t < mark.tables.size(); ++t)
    tables.push_back({mark.tables[t], mark.columns[t], {}, {}});
  return tables;
}

std::vector<std::vector<double>> room_for(const std::size_t rows, const SavedMark &mark)
{
  std::vector<std::vector<double>> values;
  for (const unsigned int columns : mark.columns)
    values.emplace_back(rows * columns);
  return values;
}

/// Gives the rows [first, end) of @p file to @p consume(bytes, number of bytes), row after row.
template <typename Put>
void for_each_row(HistoryFile      &file,
                  const SavedMark  &tables,
                  const std::size_t first,
                  const std::size_t end,
                  const std::size_t block,
                  const Put        &consume)
{
  auto values = room_for(std::min(block, end - first), tables);
  for (std::size_t begin = first; begin < end; begin += block)
    {
      const std::size_t n = std::min(block, end - begin);
      file.read(begin, n, values);
      for (std::size_t row = 0; row < n; ++row)
        for (std::size_t t = 0; t < values.size(); ++t)
          consume(reinterpret_cast<const char *>(values[t].data() + row * tables.columns[t]),
                  tables.columns[t] * sizeof(double));
    }
}

bool is_in_saved(const std::string &prefix, const SavedMark &mark)
{
  std::ifstream     in(saved(prefix), std::ios::binary);
  Checksum          sum;
  std::vector<char> piece(1 << 20);
  for (std::uint64_t left = mark.rows * mark.row_bytes(); left > 0;)
    {
      const std::uint64_t n = std::min<std::uint64_t>(left, piece.size());
      if (!in.read(piece.data(), std::streamsize(n)))
        return false;
      sum.add(piece.data(), n);
      left -= n;
    }
  return sum.value() == mark.checksum;
}

bool is_in_whole(const std::string &prefix, const SavedMark &mark)
{
  if (!fs::is_regular_file(whole(prefix)))
    return false;
  try
    {
      HistoryFile file(whole(prefix), tables_of(mark));
      Checksum    sum;
      if (file.n_rows() < mark.rows)
        return false;
      const std::size_t block = 1 + (1 << 23) / std::max<std::size_t>(1, mark.row_bytes());
      for_each_row(file, mark, 0, mark.rows, block, [&sum](const char *bytes, const std::size_t n) {
        sum.add(bytes, n);
      });
      return sum.value() == mark.checksum;
    }
  catch (const InputError &)
    {
      return false;
    }
}

[[noreturn]] void refuse(const std::string &prefix, const SavedMark &mark)
{
  throw InputError("its " + std::to_string(mark.rows) +
                   " samples of the histories are neither in '" + saved(prefix) + "' nor in '" +
                   whole(prefix) + "': the files are missing, cut off or damaged");
}
} // namespace

void SavedMark::serialize(const Archive &archive)
{
  archive("rows", rows);
  archive("checksum", checksum);
  archive("tables", tables);
  archive("columns", columns);
}

std::size_t SavedMark::row_bytes() const
{
  return sizeof(double) * std::accumulate(columns.begin(), columns.end(), std::size_t(0));
}

SavedRows::SavedRows(std::string                   prefix,
                     const std::vector<TableInfo> &tables,
                     const std::size_t             block)
    : prefix_(std::move(prefix)), sum_(std::in_place), block_(block)
{
  for (const TableInfo &table : tables)
    {
      mark_.tables.push_back(table.path);
      mark_.columns.push_back(table.columns);
    }
}

SavedMark SavedRows::mark() const
{
  SavedMark mark = mark_;
  mark.checksum  = sum_->value();
  return mark;
}

void SavedRows::write(std::ostream &out, HistoryFile &file, const std::size_t end)
{
  for_each_row(file, mark_, mark_.rows, end, block_, [&](const char *bytes, const std::size_t n) {
    sum_->add(bytes, n);
    out.write(bytes, std::streamsize(n));
  });
  mark_.rows = end;
}

void SavedRows::add(HistoryFile &file, const std::size_t end)
{
  if (end == mark_.rows)
    return;
  const std::string    path = saved(prefix_);
  const std::uintmax_t size = mark_.rows * mark_.row_bytes();
  std::error_code      error;
  if (const std::uintmax_t there = fs::file_size(path, error); error || there < size)
    {
      mark_.rows = 0; // someone has removed or cut it: once more from the beginning
      sum_.emplace();
    }
  if (mark_.rows == 0)
    {
      write_file(
          path, [&](std::ostream &out) { write(out, file, end); }, true);
      return;
    }
  fs::resize_file(path, size, error); // without what a run from here on has replaced
  if (error)
    throw RunError(write_failure(path, error.value()));
  File out(path, "", true);
  write(out, file, end);
  out.sync();
  out.close();
}

void SavedRows::open(const SavedMark &mark)
{
  if (mark.tables != mark_.tables || mark.columns != mark_.columns)
    throw InputError("its histories have other datasets or columns");
  if (!is_in_saved(prefix_, mark))
    {
      if (!is_in_whole(prefix_, mark))
        refuse(prefix_, mark);
      HistoryFile file(whole(prefix_), tables_of(mark));
      write_file(
          saved(prefix_), [&](std::ostream &out) { write(out, file, mark.rows); }, true);
    }
  mark_.rows = 0;
  sum_.emplace();
}

void SavedRows::read(const std::size_t n, std::vector<std::vector<double>> &values)
{
  std::ifstream in(saved(prefix_), std::ios::binary);
  in.seekg(std::streamoff(mark_.rows * mark_.row_bytes()));
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t t = 0; t < mark_.columns.size(); ++t)
      {
        const std::size_t size = mark_.columns[t] * sizeof(double);
        char *bytes = reinterpret_cast<char *>(values[t].data() + row * mark_.columns[t]);
        if (!in.read(bytes, std::streamsize(size)))
          throw RunError("Cannot read '" + saved(prefix_) + "'.");
        sum_->add(bytes, size);
      }
  mark_.rows += n;
}

void SavedRows::remove(const std::string &prefix)
{
  std::error_code error;
  if (!fs::exists(saved(prefix), error))
    return;
  sync_file(whole(prefix));
  fs::remove(saved(prefix), error);
}

void check_saved_rows(const std::string &prefix, const SavedMark &mark)
{
  if (!is_in_saved(prefix, mark) && !is_in_whole(prefix, mark))
    refuse(prefix, mark);
}
} // namespace chaindrive::files
