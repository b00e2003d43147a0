// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/fidelity.h>

#include <stdexcept>

namespace chaindrive::parameters
{
namespace
{
Registry<Capabilities> &all_fidelities()
{
  struct Known : Registry<Capabilities>
  {
    Known() : Registry("fidelity")
    {
      add({"simple",
           "lumped rollers joined by elastic bars, for tensions, speeds and a first look."},
          {false, false, false});
      add({"layered",
           "rollers, inner and outer links as rigid bodies with their clearances, for contact "
           "forces and the motion of single rollers; costs about four times as much.",
           {"simple"}},
          {true, false, false});
      add({"reduced",
           "bodies whose deformation is described by a few dozen modes each, computed from their "
           "finite elements; contact is that of full, the cost a tenth.",
           {"layered"}},
          {true, true, true});
      add({"full",
           "the bodies of layered made of elastic finite elements, for the effects of their "
           "deformation; costs hundreds of times as much.",
           {"reduced"}},
          {true, true, false});
    }
  };
  static Known all;
  return all;
}

/// What is registered later belongs to plug-ins.
[[maybe_unused]] const Registry<Capabilities> &registered_before_main = all_fidelities();
} // namespace

void register_fidelity(const About &about, const Capabilities &capabilities)
{
  all_fidelities().add(about, capabilities);
}

std::vector<std::string> fidelities()
{
  std::vector<std::string> names;
  for (const auto &[entry, capabilities] : all_fidelities().in_order())
    names.push_back(entry.about.name);
  return names;
}

std::string fidelities_in_words()
{
  std::string text;
  for (const auto &[entry, capabilities] : all_fidelities().in_order())
    text += " " + entry.about.name + ": " + entry.about.documentation;
  return text;
}

const Capabilities &capabilities_of(const std::string &name)
{
  const Registry<Capabilities> &all = all_fidelities();
  for (std::size_t i = 0; i < all.items().size(); ++i)
    if (all.entries()[i].about.name == name)
      return all.items()[i];
  throw std::logic_error("there is no fidelity " + name);
}
} // namespace chaindrive::parameters
