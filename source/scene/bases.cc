// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/mass.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <stdexcept>

namespace chaindrive::scene
{
namespace
{
/// What @p basis of the part called @p name keeps.
std::string note_of(const std::string &name, const reduction::Basis &basis)
{
  const double highest = *std::max_element(basis.omega.begin(), basis.omega.end());
  std::string  note    = "Reduced " + name + ": " + std::to_string(basis.n_natural) +
                     " natural modes and " + std::to_string(basis.size() - basis.n_natural) +
                     " modes under load up to " +
                     to_text(highest / (2e3 * dealii::numbers::PI), 3) + " kHz";
  if (basis.n_slowed > 0)
    note += ", to which " + std::to_string(basis.n_slowed) + " of them are slowed";
  if (!basis.joints.empty())
    note += "; without inertia what " + std::to_string(basis.joints.size()) +
            " sides in joints, which have no penalty, deflect beside them";
  const auto worst =
      std::max_element(basis.errors.begin(), basis.errors.end(), [](const auto &a, const auto &b) {
        return a.relative < b.relative;
      });
  if (worst != basis.errors.end())
    note += "; of the mesh's compliance they lack at most " + to_text(100. * worst->relative, 2) +
            " % (" + worst->load + ")";
  return note;
}
} // namespace

void add_bases(const BasisOf &basis_of, Scene &scene)
{
  for (Body &body : scene.bodies)
    {
      if (body.motion != Motion::reduced)
        continue;
      const mesh::Part &part  = *scene.parts.at(body.part());
      auto             &basis = scene.bases[body.part()];
      if (!basis)
        {
          basis = basis_of(part);
          scene.notes.push_back(note_of(part.name, *basis));
          scene.notes.insert(scene.notes.end(), basis->notes.begin(), basis->notes.end());
        }
    }
}

void weigh_reduced_bodies(Scene &scene)
{
  std::map<PartOf, drive::MassProperties> properties;
  for (Body &body : scene.bodies)
    {
      if (body.motion != Motion::reduced)
        continue;
      const auto [found, is_new] = properties.try_emplace(body.part());
      if (is_new)
        found->second = mesh::lumped_properties(*scene.parts.at(body.part()));
      body.mass = found->second.mass;
      for (unsigned int d = 0; d < 3; ++d)
        body.inertia[d] = found->second.inertia[d][d];
    }
}

const reduction::RoundFlexibility *
round_flexibility(const Scene &scene, const unsigned int number, const unsigned int surface)
{
  const Body &body  = scene.bodies[number];
  const auto  basis = scene.bases.find(body.part());
  if (body.motion == Motion::reduced && basis != scene.bases.end())
    for (const reduction::RoundFlexibility &side : basis->second->joints)
      if (side.surface == surface)
        return &side;
  return nullptr;
}

std::set<unsigned int> sides_that_touch(const Scene &scene, const PartOf &of)
{
  std::set<unsigned int> sides;
  const auto             add = [&](const unsigned int body, const unsigned int side) {
    const Body  &b    = scene.bodies[body];
    const PartOf part = b.part();
    if (b.motion == Motion::reduced && !(part < of) && !(of < part))
      sides.insert(side);
  };
  for (const BoreFamily &bores : scene.bores)
    for (const BorePair &pair : bores.elastic ? bores.pairs : std::vector<BorePair>())
      {
        add(pair.master, pair.master_surface);
        add(pair.slave.body, pair.slave_surface);
      }
  for (const FaceFamily &faces : scene.faces)
    for (const FacePair &pair : faces.pairs)
      {
        add(pair.master, pair.master_surface);
        add(pair.slave, pair.slave_surface);
      }
  const auto add_slaves = [&](const auto &family) {
    for (const SlavePoint &slave : family.slaves)
      if (family.elastic)
        add(slave.body, family.slave_surface);
  };
  std::for_each(scene.teeth.begin(), scene.teeth.end(), add_slaves);
  std::for_each(scene.surfaces.begin(), scene.surfaces.end(), add_slaves);
  std::for_each(scene.tooth_sides.begin(), scene.tooth_sides.end(), add_slaves);
  return sides;
}

bool has_penalty(const Scene &scene, const BoreFamily &bores)
{
  const auto n = std::count_if(bores.pairs.begin(), bores.pairs.end(), [&](const BorePair &pair) {
    return round_flexibility(scene, pair.master, pair.master_surface) == nullptr ||
           round_flexibility(scene, pair.slave.body, pair.slave_surface) == nullptr;
  });
  if (n != 0 && n != std::ptrdiff_t(bores.pairs.size()))
    throw std::logic_error("some of the pairs " + bores.name + " have a penalty, others have not");
  return n != 0;
}

bool has_penalty(const Scene &scene, const ToothFamily &teeth)
{
  return !teeth.elastic || teeth.slaves.empty() ||
         round_flexibility(scene, teeth.slaves.front().body, teeth.slave_surface) == nullptr;
}
} // namespace chaindrive::scene
