// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::statics
{
/// Results on disk that cost seconds to compute, one file each, named after a checksum of all they
/// depend on. A cache is a convenience: what cannot be read is computed anew, what cannot be
/// written is not kept, and no run fails for it.
class Cache
{
public:
  /// The folder of the environment variable CHAINDRIVE_CACHE, else chaindrive in XDG_CACHE_HOME or
  /// in .cache of HOME (XDG Base Directory Specification); none if all are empty.
  static std::string usual_folder();

  /// An empty @p folder keeps nothing.
  explicit Cache(const std::string &folder);

  /// Whether a value is of the form that its reader takes; one that is not may end in an exception.
  using Fits = std::function<bool(const nlohmann::json &)>;

  /// What was kept for @p key, if it is there, undamaged and of a form that @p fits.
  std::optional<nlohmann::json> find(const std::string &key, const Fits &fits);

  /// Keeps @p value for @p key; a file appears complete or not at all.
  void keep(const std::string &key, const nlohmann::json &value);

  /// Sentences on what could not be read or written.
  const std::vector<std::string> &notes() const { return notes_; }

private:
  std::string file_of(const std::string &key) const;

  const std::string        folder_;
  std::vector<std::string> notes_;
};
} // namespace chaindrive::statics
