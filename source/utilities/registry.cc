// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/registry.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <tuple>

namespace chaindrive
{
namespace
{
/// What is known of all registries. A function, so that it exists before the first of them.
struct SharedRegistries
{
  std::vector<const AnyRegistry *> registries;
  std::vector<std::string>         plugins = {""}; ///< names, by batch; the first is the program
  std::vector<std::string>         problems;
};

SharedRegistries &shared_registries()
{
  static SharedRegistries all;
  return all;
}

std::string quoted(const AnyRegistry::Entry &entry)
{
  return "'" + entry.about.name + "'" +
         (entry.plugin.empty() ? "" : " of the plug-in '" + entry.plugin + "'");
}
} // namespace

AnyRegistry::AnyRegistry(std::string kind) : kind_(std::move(kind))
{
  shared_registries().registries.push_back(this);
}

const std::vector<const AnyRegistry *> &AnyRegistry::all()
{
  return shared_registries().registries;
}

void AnyRegistry::begin_plugin(const std::string &name)
{
  shared_registries().plugins.push_back(name);
}

const std::vector<std::string> &AnyRegistry::problems() { return shared_registries().problems; }

bool AnyRegistry::enter(const About &about)
{
  const std::vector<std::string> &plugins = shared_registries().plugins;
  const Entry                     entry{about, plugins.back(), plugins.size() - 1};
  for (const Entry &other : entries_)
    if (other.about.name == about.name)
      {
        shared_registries().problems.push_back(
            "The " + kind_ + " " + quoted(entry) + " has the name of another one" +
            (other.plugin.empty() ? ", which the program has." :
                                    ", of the plug-in '" + other.plugin + "'."));
        return false;
      }
  entries_.push_back(entry);
  return true;
}

std::vector<std::size_t> AnyRegistry::order() const
{
  std::vector<std::size_t> rest(entries_.size()), ordered;
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] = i;
  std::sort(rest.begin(), rest.end(), [this](const std::size_t i, const std::size_t j) {
    return std::tie(entries_[i].batch, entries_[i].about.name) <
           std::tie(entries_[j].batch, entries_[j].about.name);
  });
  for (const Entry &entry : entries_)
    for (const std::string &other : entry.about.after)
      if (std::none_of(entries_.begin(), entries_.end(), [&other](const Entry &known) {
            return known.about.name == other;
          }))
        throw InputError("The " + kind_ + " " + quoted(entry) + " is to come after '" + other +
                         "', which there is not: is the plug-in missing that brings it?");

  while (!rest.empty())
    {
      const auto waits = [&](const std::size_t i) {
        const std::vector<std::string> &after = entries_[i].about.after;
        return std::any_of(rest.begin(), rest.end(), [&](const std::size_t j) {
          return std::find(after.begin(), after.end(), entries_[j].about.name) != after.end();
        });
      };
      const auto next = std::find_if_not(rest.begin(), rest.end(), waits);
      if (next == rest.end())
        {
          std::vector<std::string> names(rest.size());
          std::transform(rest.begin(), rest.end(), names.begin(), [&](const std::size_t i) {
            return quoted(entries_[i]);
          });
          throw InputError("Each " + kind_ +
                           " of these is to come after another one of them, which is a circle: " +
                           join(names) + ".");
        }
      ordered.push_back(*next);
      rest.erase(next);
    }
  return ordered;
}
} // namespace chaindrive
