// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/archive.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace chaindrive::files
{
/// A checkpoint: one file with lines of text, an empty line, the items of an Archive, and the
/// checksum (Checksum) of all that. Numbers are stored as the machine has them.
///
///     chaindrive checkpoint 2
///     version 0.1.0
///     parameters 0123456789abcdef
///     step 1200
///     time 0.0003
///     interval 2.5e-07
///
///     [length of the name, name, size of the item, its bytes; both numbers in 8 bytes] ...
///     [checksum in 8 bytes]
///
/// The first number is that of the format. `parameters` is the checksum of the text that the first
/// item, `parameters`, holds: every entry that a resumed run must have as it was.
struct CheckpointHeader
{
  unsigned long step; ///< since the start
  double        time; ///< s
  double        dt;   ///< s
};

/// The items of one rank on their way into a file.
class CheckpointItems
{
public:
  explicit CheckpointItems(const MPI_Comm comm) : comm_(comm) {}

  /// Where this rank's state goes.
  Archive archive();

  /// Writes a checkpoint with the items of all ranks, which belongs to these @p parameters: under
  /// another name, and renamed when it is complete. RunError when that fails. Collective.
  void write(const std::string      &path,
             const CheckpointHeader &header,
             const std::string      &parameters) const;

private:
  MPI_Comm    comm_;
  std::string bytes_;
};

/// A checkpoint to be read, by every rank for itself.
class CheckpointFile
{
public:
  /// Checks the whole file; InputError says what is wrong with it: that it cannot be read, that it
  /// is none, of another format or version, cut off or damaged.
  explicit CheckpointFile(const std::string &path);

  /// Refuses (InputError) a checkpoint of other @p parameters, and names the first that differs.
  void check_parameters(const std::string &parameters) const;

  const std::string      &path() const { return path_; }
  const CheckpointHeader &header() const { return header_; }

  /// Its items; must not outlive this.
  Archive archive() const;

private:
  struct Place
  {
    std::uint64_t begin, size;
  };

  void           check_first_line(std::istream &in) const;
  void           check_sum(std::istream &in) const;
  void           read_header(std::istream &in);
  void           find_items(std::istream &in);
  Archive::Bytes bytes_at(const Place &place) const;

  std::string                  path_;
  CheckpointHeader             header_{};
  std::map<std::string, Place> items_;
};

/// Where the checkpoint of step @p step stands.
std::string checkpoint_path(const std::string &directory, unsigned long step);

/// The checkpoints in @p directory, by their steps.
std::map<unsigned long, std::string> checkpoints_in(const std::string &directory);
} // namespace chaindrive::files
