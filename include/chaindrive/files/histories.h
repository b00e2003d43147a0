// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/archive.h>

#include <deal.II/base/array_view.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::files
{
/// What one history is: it becomes the dataset `/group/name` with one row per sample.
struct Channel
{
  std::string              group;       ///< lower-case letters, digits and underscores
  std::string              name;        ///< likewise
  std::string              unit;        ///< SI, "1" for a pure number
  std::string              description; ///< one sentence
  unsigned int             columns = 1;
  std::vector<std::string> labels  = {};    ///< of the columns, empty or one for each
  bool                     single  = false; ///< in single precision, seven digits
};

/// The time histories of a run: `<prefix>.h5`, and `<prefix>_<group>.csv` on request.
///
///     Histories histories("results/a/histories", {{"version", "0.1.0"}}, 1501);
///     const auto speed = histories.add({"driven", "speed", "rad/s", "Speed of the driven hub"});
///     histories.begin_sample(time);
///     histories.set(speed, 43.1);
///     histories.end_sample();
///
/// The HDF5 file is laid out at the first sample with room for all expected samples, so that a disk
/// too small is found before the computing and not after it; from then on only numbers change in
/// it. It can therefore be read at any instant, also after the program was killed: rows not yet
/// written hold NaN, their time too. close() cuts the datasets to the rows written; compress() then
/// makes the file smaller.
///
/// With serialize() the rows are also kept in a file of their own, `<prefix>.saved`, which is on
/// the disk before the checkpoint is and whose checksum the checkpoint holds; a resumed run makes
/// the histories anew from it. What a checkpoint counts on is so neither spoilt by a program that
/// is killed while it writes, nor damaged without anyone noticing.
///
/// Every failure to write is a RunError that names the file and the reason; rows written before
/// it stay readable.
class Histories
{
public:
  using Handle = unsigned int;

  /// @p attributes are stored with the HDF5 file as texts. @p expected_samples may be exceeded: the
  /// file grows.
  Histories(const std::string                                      &prefix,
            const std::vector<std::pair<std::string, std::string>> &attributes,
            std::size_t                                             expected_samples,
            bool                                                    csv = false);
  Histories(Histories &&) noexcept;

  /// Closes the files; a failure then is not reported.
  ~Histories();

  /// A new channel; all must be added before the first sample.
  Handle add(const Channel &channel);

  /// Starts a row at @p time [s], with NaN in every column.
  void begin_sample(double time);

  /// The columns of a channel in the current row, to be written.
  dealii::ArrayView<double> values(Handle channel);

  void set(Handle channel, double value) { values(channel)[0] = value; }

  void end_sample();

  std::size_t n_samples() const;

  /// Writes the rows kept in memory, so that the files are complete up to now.
  void flush();

  /// Into a checkpoint: saves the rows since the last one. Out of it: the histories hold again what
  /// they held then; to be called when all channels have been added, instead of the first sample.
  /// InputError when the rows are missing or damaged.
  void serialize(const Archive &archive);

  /// Whether the checkpoint @p archive can have the rows that it counts on: otherwise InputError.
  /// Changes nothing.
  static void check(const std::string &prefix, const Archive &archive);

  /// Writes what is left and closes the files.
  void close();

  /// Compresses the HDF5 file, which has been closed. Where that cannot be it stays as it is;
  /// returns why, a sentence, or nothing.
  std::string compress();

  /// Removes the file of serialize(), which the closed histories make superfluous.
  void remove_saved();

private:
  struct Data;
  std::unique_ptr<Data> data_;
};
} // namespace chaindrive::files
