// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/model/cross_checks.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/model/without_effect.h>

namespace chaindrive::model
{
namespace
{
std::vector<std::string> check_entries(const Parameters               &parameters,
                                       const std::vector<std::string> &changed)
{
  const Effects            effects = decide_effects(parameters);
  std::vector<std::string> notes   = cross_check(parameters, effects);
  for (const std::string &note : without_effect(parameters, effects, changed))
    notes.push_back(note);
  return notes;
}

parameters::Completion completion()
{
  return {drive::number_of_links, field_interval, check_entries};
}
} // namespace

parameters::Input read_parameters(const std::string              &file,
                                  const std::vector<std::string> &overrides)
{
  return parameters::read_parameters(file, overrides, completion());
}

parameters::Input read_entries(const std::map<std::string, std::string> &values)
{
  return parameters::read_entries(values, completion());
}
} // namespace chaindrive::model
