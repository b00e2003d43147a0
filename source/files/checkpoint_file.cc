// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/checkpoint_file.h>
#include <chaindrive/files/file.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/message_tags.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace chaindrive::files
{
namespace
{
constexpr const char *magic          = "chaindrive checkpoint ";
constexpr const char *format         = "11";
constexpr std::size_t size_of_number = 8;

std::string bytes_of(const std::uint64_t number)
{
  std::string bytes(size_of_number, '\0');
  std::memcpy(bytes.data(), &number, size_of_number);
  return bytes;
}

std::uint64_t number_in(std::istream &in)
{
  std::array<char, size_of_number> bytes{};
  in.read(bytes.data(), size_of_number);
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data(), size_of_number);
  return number;
}

/// Puts an item behind @p bytes.
void append(std::string &bytes, const std::string &name, const char *item, const std::size_t size)
{
  bytes += bytes_of(name.size());
  bytes += name;
  bytes += bytes_of(size);
  bytes.append(item, size);
}

/// Sends @p bytes to the first rank, or receives there those of rank @p from; MPI counts in int.
void send(const std::string &bytes, const MPI_Comm comm)
{
  const std::uint64_t size  = bytes.size();
  constexpr size_t    piece = 1 << 30;
  MPI_Send(&size, 1, MPI_UINT64_T, 0, tag_checkpoint, comm);
  for (std::size_t i = 0; i < size; i += piece)
    MPI_Send(bytes.data() + i, int(std::min(piece, size - i)), MPI_CHAR, 0, tag_checkpoint, comm);
}

std::string receive(const unsigned int from, const MPI_Comm comm)
{
  std::uint64_t    size  = 0;
  constexpr size_t piece = 1 << 30;
  MPI_Recv(&size, 1, MPI_UINT64_T, int(from), tag_checkpoint, comm, MPI_STATUS_IGNORE);
  std::string bytes(size, '\0');
  for (std::size_t i = 0; i < size; i += piece)
    MPI_Recv(bytes.data() + i,
             int(std::min(piece, size - i)),
             MPI_CHAR,
             int(from),
             tag_checkpoint,
             comm,
             MPI_STATUS_IGNORE);
  return bytes;
}
} // namespace

Archive CheckpointItems::archive()
{
  return Archive([this](const std::string &name,
                        const char        *item,
                        const std::size_t  size) { append(bytes_, name, item, size); },
                 rank_in(comm_) > 0);
}

void CheckpointItems::write(const std::string      &path,
                            const CheckpointHeader &header,
                            const std::string      &parameters) const
{
  if (rank_in(comm_) > 0)
    {
      send(bytes_, comm_);
      return;
    }
  std::string begin = magic + std::string(format) + "\nversion " + version + "\nparameters " +
                      checksum(parameters) + "\nstep " + std::to_string(header.step) + "\ntime " +
                      to_text(header.time, 17) + "\ninterval " + to_text(header.dt, 17) + "\n\n";
  append(begin, "parameters", parameters.data(), parameters.size());
  write_file(
      path,
      [&](std::ostream &out) {
        Checksum   sum;
        const auto append_bytes = [&](const std::string &bytes) {
          sum.add(bytes.data(), bytes.size());
          out << bytes;
        };
        append_bytes(begin);
        append_bytes(bytes_);
        for (unsigned int rank = 1; rank < n_ranks_in(comm_); ++rank)
          append_bytes(receive(rank, comm_));
        out << bytes_of(sum.value());
      },
      true);
}

CheckpointFile::CheckpointFile(const std::string &path) : path_(path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(path))
    throw InputError("The checkpoint '" + path + "' cannot be read.");
  check_first_line(in);
  const auto header = in.tellg();
  check_sum(in);
  in.seekg(header);
  read_header(in);
  find_items(in);
}

void CheckpointFile::check_first_line(std::istream &in) const
{
  std::string line;
  std::getline(in, line);
  if (line.compare(0, std::strlen(magic), magic) != 0)
    throw InputError("'" + path_ + "' is no checkpoint of chaindrive.");
  if (const std::string other = line.substr(std::strlen(magic)); other != format)
    throw InputError("The checkpoint '" + path_ + "' has the format " + other +
                     "; this program reads the format " + format + ".");
}

void CheckpointFile::read_header(std::istream &in)
{
  std::string line, written_by;
  while (std::getline(in, line) && !line.empty())
    {
      std::istringstream words(line);
      std::string        name;
      words >> name;
      if (name == "version")
        words >> written_by;
      else if (name == "step")
        words >> header_.step;
      else if (name == "time")
        words >> header_.time;
      else if (name == "interval")
        words >> header_.dt;
    }
  if (written_by != version)
    throw InputError("The checkpoint '" + path_ + "' was written by chaindrive " + written_by +
                     "; this is chaindrive " + version + ", which may compute differently.");
}

void CheckpointFile::check_sum(std::istream &in) const
{
  const std::uintmax_t size = std::filesystem::file_size(path_);
  std::uintmax_t       left = size - std::min<std::uintmax_t>(size, size_of_number);
  Checksum             sum;
  std::vector<char>    piece(1 << 20);
  in.clear();
  in.seekg(0);
  while (left > 0 && in)
    {
      in.read(piece.data(), std::streamsize(std::min<std::uintmax_t>(left, piece.size())));
      sum.add(piece.data(), std::size_t(in.gcount()));
      left -= std::uintmax_t(in.gcount());
    }
  if (number_in(in) != sum.value() || !in)
    throw InputError("The checkpoint '" + path_ +
                     "' is damaged or was cut off: its checksum is not that of its contents.");
}

void CheckpointFile::find_items(std::istream &in)
{
  const std::uint64_t end = std::filesystem::file_size(path_) - size_of_number;
  while (std::uint64_t(in.tellg()) < end)
    {
      std::string name(number_in(in), '\0');
      in.read(name.data(), std::streamsize(name.size()));
      const std::uint64_t size = number_in(in);
      items_[name]             = {std::uint64_t(in.tellg()), size};
      in.seekg(std::streamoff(size), std::ios::cur);
    }
}

Archive::Bytes CheckpointFile::bytes_at(const Place &place) const
{
  std::ifstream  in(path_, std::ios::binary);
  Archive::Bytes bytes(place.size);
  in.seekg(std::streamoff(place.begin));
  if (!in.read(bytes.data(), std::streamsize(bytes.size())))
    throw InputError("it cannot be read");
  return bytes;
}

Archive CheckpointFile::archive() const
{
  return Archive([this](const std::string &name) -> std::optional<Archive::Bytes> {
    const auto found = items_.find(name);
    if (found == items_.end())
      return std::nullopt;
    return bytes_at(found->second);
  });
}

void CheckpointFile::check_parameters(const std::string &parameters) const
{
  const Archive::Bytes bytes = bytes_at(items_.at("parameters"));
  std::istringstream   stored(std::string(bytes.begin(), bytes.end())), expected(parameters);
  std::string          in_file, asked_for;
  while (true)
    {
      const bool has_stored   = bool(std::getline(stored, in_file)),
                 has_expected = bool(std::getline(expected, asked_for));
      if (!has_stored && !has_expected)
        return;
      if (!has_stored || !has_expected || in_file != asked_for)
        throw InputError("The checkpoint '" + path_ + "' belongs to other parameters: there " +
                         in_file + ", here " + asked_for +
                         ". Only the end time and the section Output may change.");
    }
}

std::string checkpoint_path(const std::string &directory, const unsigned long step)
{
  char name[64];
  std::snprintf(name, sizeof(name), "/checkpoint-%09lu.ckpt", step);
  return directory + name;
}

std::map<unsigned long, std::string> checkpoints_in(const std::string &directory)
{
  static const std::regex              names("checkpoint-([0-9]{9,18})\\.ckpt");
  std::map<unsigned long, std::string> found;
  std::error_code                      error;
  for (const auto &entry : std::filesystem::directory_iterator(directory, error))
    {
      std::smatch       match;
      const std::string name = entry.path().filename().string();
      std::error_code   ignored;
      if (entry.is_regular_file(ignored) && std::regex_match(name, match, names))
        found[std::stoul(match[1])] = entry.path().string();
    }
  return found;
}
} // namespace chaindrive::files
