// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/files/histories.h>
#include <chaindrive/files/history_file.h>
#include <chaindrive/files/packed_rows.h>
#include <chaindrive/files/saved_rows.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <limits>
#include <optional>

namespace chaindrive::files
{
namespace
{
using Clock = std::chrono::steady_clock;

/// Rows of a slow run are written after this time, so that it can be followed and little is lost.
constexpr std::chrono::seconds longest_wait(5);

bool is_plain_name(const std::string &name)
{
  return !name.empty() && std::all_of(name.begin(), name.end(), [](const char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// One group as text: the time and every column of its channels.
struct CsvFile
{
  std::string               group;
  std::vector<unsigned int> channels;
  std::unique_ptr<File>     file;
};

void put_number(std::ostream &out, const double value, const bool single = false)
{
  // the shortest text that reads back as the same number
  char       text[32];
  const auto end = single ?
                       std::to_chars(text, text + sizeof(text), static_cast<float>(value)).ptr :
                       std::to_chars(text, text + sizeof(text), value).ptr;
  out.write(text, end - text);
}
} // namespace

struct Histories::Data
{
  std::string prefix;
  Attributes  attributes;
  std::size_t expected;
  bool        with_csv;

  std::vector<Channel>       channels; ///< the first is the time
  std::optional<HistoryFile> file;
  std::vector<CsvFile>       csv;

  std::size_t                      block      = 0; ///< rows kept in memory before they are written
  std::size_t                      written    = 0; ///< rows
  std::size_t                      kept       = 0; ///< rows in memory, complete
  Clock::time_point                last_write = Clock::now();
  std::vector<std::vector<double>> values; ///< of the rows in memory, one table per channel
  std::optional<SavedRows>         saved;
  std::optional<PackedRows>        packed;

  std::vector<TableInfo> tables() const
  {
    std::vector<TableInfo> infos;
    for (const Channel &c : channels)
      infos.push_back({(c.group.empty() ? "" : "/" + c.group) + "/" + c.name,
                       c.columns,
                       {{"unit", c.unit}, {"description", c.description}},
                       c.labels,
                       c.single});
    return infos;
  }

  void make_room()
  {
    // Blocks of at most 8 MiB and 256 rows, all of them full when the last expected row is written.
    std::size_t row_bytes = 0;
    for (const Channel &channel : channels)
      row_bytes += channel.columns * sizeof(double);
    const std::size_t rows   = std::max<std::size_t>(expected, 1);
    const std::size_t most   = std::clamp<std::size_t>(8388608 / row_bytes, 8, 256);
    const std::size_t blocks = (rows - 1) / most + 1;
    block                    = (rows - 1) / blocks + 1;
    for (const Channel &channel : channels)
      values.emplace_back(block * channel.columns);
    saved.emplace(prefix, tables(), block);
    packed.emplace(tables(), block);
  }

  void open()
  {
    file.emplace(prefix + ".h5", attributes, tables(), expected, block);
    if (with_csv)
      open_csv();
  }

  void open_csv()
  {
    for (unsigned int c = 1; c < channels.size(); ++c)
      {
        auto of_group = std::find_if(csv.begin(), csv.end(), [&](const CsvFile &file) {
          return file.group == channels[c].group;
        });
        if (of_group == csv.end())
          of_group = csv.insert(csv.end(), CsvFile{channels[c].group, {}, nullptr});
        of_group->channels.push_back(c);
      }
    for (CsvFile &group : csv)
      {
        group.file = std::make_unique<File>(prefix + "_" + group.group + ".csv");
        *group.file << "time [s]";
        for (const unsigned int c : group.channels)
          for (unsigned int i = 0; i < channels[c].columns; ++i)
            {
              *group.file << ',' << channels[c].name;
              if (!channels[c].labels.empty())
                *group.file << ' ' << channels[c].labels[i];
              else if (channels[c].columns > 1)
                *group.file << ' ' << i;
              *group.file << " [" << channels[c].unit << ']';
            }
        *group.file << '\n';
        group.file->complete();
      }
  }

  void write_csv()
  {
    for (CsvFile &group : csv)
      {
        for (std::size_t row = 0; row < kept; ++row)
          {
            put_number(*group.file, values[0][row]);
            for (const unsigned int c : group.channels)
              for (unsigned int i = 0; i < channels[c].columns; ++i)
                {
                  *group.file << ',';
                  put_number(
                      *group.file, values[c][row * channels[c].columns + i], channels[c].single);
                }
            *group.file << '\n';
          }
        group.file->complete();
      }
  }

  void write_rows()
  {
    file->write(written, kept, values);
    write_csv();
    packed->add(written, kept, values);
    written += kept;
    kept       = 0;
    last_write = Clock::now();
  }

  /// Makes the histories anew from the rows of @p mark.
  void restore(const SavedMark &mark)
  {
    if (mark.rows == 0)
      return;
    make_room();
    saved->open(mark);
    open();
    while (written < mark.rows)
      {
        kept = std::min<std::size_t>(block, mark.rows - written);
        saved->read(kept, values);
        write_rows();
      }
  }
};

Histories::Histories(const std::string                                      &prefix,
                     const std::vector<std::pair<std::string, std::string>> &attributes,
                     const std::size_t                                       expected_samples,
                     const bool                                              csv)
    : data_(std::make_unique<Data>())
{
  data_->prefix     = prefix;
  data_->attributes = attributes;
  data_->expected   = expected_samples;
  data_->with_csv   = csv;
  data_->channels.push_back({"", "time", "s", "Time of each sample", 1, {}});
}

Histories::Histories(Histories &&) noexcept = default;

Histories::~Histories()
{
  if (data_)
    try
      {
        close();
      }
    catch (...)
      {
      }
}

Histories::Handle Histories::add(const Channel &channel)
{
  AssertThrow(!data_->file, dealii::ExcMessage("Channels are added before the first sample"));
  AssertThrow(is_plain_name(channel.group) && is_plain_name(channel.name) && channel.columns > 0 &&
                  (channel.labels.empty() || channel.labels.size() == channel.columns),
              dealii::ExcMessage("Channel " + channel.group + "/" + channel.name +
                                 " is not described properly"));
  for (const Channel &other : data_->channels)
    AssertThrow(
        other.group != channel.group || other.name != channel.name,
        dealii::ExcMessage("Channel " + channel.group + "/" + channel.name + " exists already"));
  data_->channels.push_back(channel);
  return data_->channels.size() - 1;
}

void Histories::begin_sample(const double time)
{
  Data &d = *data_;
  if (!d.file)
    {
      d.make_room();
      d.open();
    }
  else if (d.kept == d.block || Clock::now() - d.last_write > longest_wait)
    d.write_rows();
  for (std::size_t c = 0; c < d.channels.size(); ++c)
    std::fill_n(d.values[c].begin() + d.kept * d.channels[c].columns,
                d.channels[c].columns,
                std::numeric_limits<double>::quiet_NaN());
  d.values[0][d.kept] = time;
}

dealii::ArrayView<double> Histories::values(const Handle channel)
{
  const unsigned int columns = data_->channels[channel].columns;
  return {data_->values[channel].data() + data_->kept * columns, columns};
}

void Histories::end_sample() { ++data_->kept; }

std::size_t Histories::n_samples() const { return data_->written + data_->kept; }

void Histories::flush()
{
  if (data_->file)
    data_->write_rows();
}

void Histories::serialize(const Archive &archive)
{
  Data     &d = *data_;
  SavedMark mark;
  if (!archive.reads() && d.file)
    {
      d.write_rows();
      d.saved->add(*d.file, d.written);
      mark = d.saved->mark();
    }
  mark.serialize(archive);
  if (archive.reads())
    d.restore(mark);
}

void Histories::check(const std::string &prefix, const Archive &archive)
{
  SavedMark mark;
  mark.serialize(archive);
  check_saved_rows(prefix, mark);
}

void Histories::remove_saved() { SavedRows::remove(data_->prefix); }

void Histories::close()
{
  Data &d = *data_;
  if (!d.file)
    return;
  d.write_rows();
  for (CsvFile &group : d.csv)
    group.file->close();
  d.file->close(d.written);
}

std::string Histories::compress()
{
  Data &d = *data_;
  return d.file && d.written > 0 ?
             HistoryFile::compress(d.prefix + ".h5", d.attributes, d.tables(), *d.packed) :
             "";
}
} // namespace chaindrive::files
