// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/fidelity.h>

#include <map>
#include <stdexcept>
#include <utility>

namespace chaindrive::scene
{
namespace
{
std::map<std::string, Fidelity::Builder> &all_builders()
{
  static std::map<std::string, Fidelity::Builder> builders = {{"simple", &add_simple_chain},
                                                              {"layered", &add_layered_chain},
                                                              {"reduced", &add_full_chain},
                                                              {"full", &add_full_chain}};
  return builders;
}
} // namespace

Fidelity::Fidelity(const About                    &about,
                   const parameters::Capabilities &capabilities,
                   Builder                         builder)
{
  parameters::register_fidelity(about, capabilities);
  all_builders().emplace(about.name, std::move(builder)); // a second one of that name is refused
}

const Fidelity::Builder &Fidelity::builder_of(const std::string &name)
{
  const auto found = all_builders().find(name);
  if (found == all_builders().end())
    throw std::logic_error("the fidelity " + name + " has no builder");
  return found->second;
}
} // namespace chaindrive::scene
