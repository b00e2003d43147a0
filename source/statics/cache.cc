// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/statics/cache.h>
#include <chaindrive/utilities/checksum.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace chaindrive::statics
{
namespace
{
std::string environment(const char *name)
{
  const char *value = std::getenv(name);
  return value == nullptr ? "" : value;
}
} // namespace

std::string Cache::usual_folder()
{
  if (std::string folder = environment("CHAINDRIVE_CACHE"); !folder.empty())
    return folder;
  // a relative path in XDG_CACHE_HOME is to be ignored, says the specification
  if (std::string folder = environment("XDG_CACHE_HOME"); !folder.empty() && folder[0] == '/')
    return folder + "/chaindrive";
  if (const std::string home = environment("HOME"); !home.empty())
    return home + "/.cache/chaindrive";
  return "";
}

Cache::Cache(const std::string &folder) : folder_(folder) {}

std::string Cache::file_of(const std::string &key) const
{
  return folder_ + "/" + checksum(key) + ".json";
}

std::optional<nlohmann::json> Cache::find(const std::string &key, const Fits &fits)
{
  if (folder_.empty())
    return {};
  const std::string file = file_of(key);
  std::ifstream     in(file);
  if (!in)
    return {};
  std::stringstream text;
  text << in.rdbuf();
  try
    {
      const nlohmann::json all = nlohmann::json::parse(text.str());
      if (all.at("checksum") == checksum(all.at("value").dump()))
        {
          if (all.at("key") != key)
            return {}; // another key with the same checksum
          if (fits(all["value"]))
            return all["value"];
        }
    }
  catch (const std::exception &) // of another form, whatever a reader makes of it
    {
    }
  notes_.push_back(file + " is damaged; it is computed anew.");
  return {};
}

void Cache::keep(const std::string &key, const nlohmann::json &value)
{
  if (folder_.empty())
    return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  const std::string file = file_of(key), other = file + "." + std::to_string(getpid());
  bool              good = false;
  {
    std::ofstream out(other);
    out << nlohmann::json{{"key", key}, {"checksum", checksum(value.dump())}, {"value", value}}
        << '\n';
    out.flush();
    good = bool(out);
  }
  if (good)
    std::filesystem::rename(other, file, error);
  if (good && !error)
    return;
  std::error_code ignored;
  std::filesystem::remove(other, ignored);
  notes_.push_back("Stiffnesses of parts could not be kept in " + folder_ +
                   "; the next run computes them again. Set CHAINDRIVE_CACHE to a folder that can "
                   "be written.");
}
} // namespace chaindrive::statics
