// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/part.h>

#include <deal.II/base/exceptions.h>

namespace chaindrive::mesh
{
const std::string &surface_name(const unsigned int boundary_id)
{
  static const std::array<std::string, n_surfaces> names = {{"other",
                                                             "roller outside",
                                                             "roller bore",
                                                             "roller ends",
                                                             "bush outside, first joint",
                                                             "bush outside, second joint",
                                                             "bush bore, first joint",
                                                             "bush bore, second joint",
                                                             "pin outside, first joint",
                                                             "pin outside, second joint",
                                                             "pin bore",
                                                             "plate inner faces",
                                                             "plate outer faces",
                                                             "plate edges",
                                                             "tooth flanks",
                                                             "sprocket sides",
                                                             "hub",
                                                             "middle plane"}};
  AssertIndexRange(boundary_id, n_surfaces);
  return names[boundary_id];
}

const std::string &component_name(const unsigned int material_id)
{
  static const std::array<std::string, n_components> names = {
      {"roller", "inner plate", "bush", "outer plate", "pin", "rim", "hub zone"}};
  AssertIndexRange(material_id, n_components);
  return names[material_id];
}
} // namespace chaindrive::mesh
