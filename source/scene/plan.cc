// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/part.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/scene/plan.h>
#include <chaindrive/utilities/pack.h>
#include <chaindrive/utilities/text.h>

#include <iomanip>
#include <map>
#include <ostream>
#include <utility>

namespace chaindrive::scene
{
namespace
{
// CPU time per object and step, s: fitted to scripts/speed.py, see doc/performance.md
constexpr double cost_of_lumped  = 15e-9;
constexpr double cost_of_rigid   = 90e-9;
constexpr double cost_of_bar     = 15e-9;
constexpr double cost_of_bore    = 45e-9;
constexpr double cost_of_tooth   = 60e-9;
constexpr double cost_of_face    = 30e-9;
constexpr double cost_of_element = 40e-9;

// share of a tooth family's pairs that the search leaves near the sprocket, roughly the wrap
constexpr double near_share = 0.25;

std::string name_of(const Scene &scene, const Body &body)
{
  switch (body.kind)
    {
    case Kind::roller:
      return "rollers";
    case Kind::inner_link:
      return "inner links";
    case Kind::outer_link:
      return "outer links";
    case Kind::sprocket:
      return scene.sprockets.at(body.number).name() + " sprocket";
    }
  return "";
}

std::string motion_of(const Body &body)
{
  const std::string rim = body.motion == Motion::elastic ? "elastic rim, " : "rigid, ";
  if (body.support == Support::prescribed_hub)
    return rim + "hub turned by the speed program";
  if (body.support == Support::loaded_hub)
    return rim + "one rotation of the hub against the load torque";
  switch (body.motion)
    {
    case Motion::lumped:
      return body.inertia[2] > 0. ? "lumped, 3 translations and a spin" : "lumped, 3 translations";
    case Motion::rigid:
      return "rigid, 6 degrees of freedom";
    case Motion::elastic:
      return "elastic";
    }
  return "";
}

/// Elements and nodes of an elastic body; of a sprocket, those of its sectors.
std::pair<unsigned int, unsigned int> size_of(const Scene &scene, const Body &body)
{
  const auto         sector = scene.sectors.find(body.part());
  const bool         is_rim = sector != scene.sectors.end();
  const mesh::Part  &part   = is_rim ? *sector->second->part : *scene.parts.at(body.part());
  const unsigned int n      = is_rim ? sector->second->n_sectors : 1;
  return {n * part.mesh->n_active_cells(), n * part.mesh->n_used_vertices()};
}

/// Lanes that are computed for each copy of the sector of a sprocket, those left empty included; 1
/// for other bodies, which are many.
double lanes_per_copy(const Scene &scene, const Body &body)
{
  const auto sector = scene.sectors.find(body.part());
  if (sector == scene.sectors.end())
    return 1.;
  const unsigned int n = sector->second->n_sectors;
  return double(n_computed_of(n)) / n;
}

std::string law_text(const ContactLaw &law, const bool elastic)
{
  const std::string per  = elastic ? "3" : ""; // per area
  std::string       text = "k " + to_text(law.stiffness, 4) + " N/m" + per;
  text += law.damping > 0. ? ", c " + to_text(law.damping, 4) + " N s/m" + per : ", undamped";
  text += law.friction > 0. ? ", mu " + to_text(law.friction) : ", frictionless";
  return text + (elastic ? " (nodes, per area)" : " (each point)");
}
} // namespace

double step_cost(const Scene &scene)
{
  double cost = cost_of_bar * scene.bars.size();
  for (const Body &body : scene.bodies)
    switch (body.motion)
      {
      case Motion::lumped:
        cost += cost_of_lumped;
        break;
      case Motion::rigid:
        cost += cost_of_rigid;
        break;
      case Motion::elastic:
        cost += cost_of_element * lanes_per_copy(scene, body) * size_of(scene, body).first;
        break;
      }
  for (const BoreFamily &bores : scene.bores)
    cost += cost_of_bore * bores.pairs.size();
  for (const FaceFamily &faces : scene.faces)
    cost += cost_of_face * faces.pairs.size();
  for (const ToothFamily &teeth : scene.teeth)
    cost += cost_of_tooth * near_share * teeth.slaves.size();
  return cost;
}

void print_plan(std::ostream       &out,
                const Scene        &scene,
                const std::size_t   memory,
                const unsigned long n_steps)
{
  out << "Bodies\n";
  std::map<std::pair<PartOf, Motion>, std::vector<const Body *>> alike;
  for (const Body &body : scene.bodies)
    alike[{body.part(), body.motion}].push_back(&body);
  for (const auto &[sort, bodies] : alike)
    {
      const Body &body = *bodies.front();
      out << "  " << std::setw(4) << bodies.size() << ' ' << name_of(scene, body) << ": "
          << motion_of(body);
      if (body.motion == Motion::elastic)
        out << ", " << size_of(scene, body).first << " elements and " << size_of(scene, body).second
            << " nodes each";
      out << '\n';
    }

  out << "Interfaces\n";
  for (const BoreFamily &bores : scene.bores)
    out << "  " << std::setw(4) << bores.pairs.size() << (bores.elastic ? " pairs " : " points ")
        << bores.name << ": " << law_text(bores.law, bores.elastic) << '\n';
  for (const FaceFamily &faces : scene.faces)
    out << "  " << std::setw(4) << faces.pairs.size() << " pairs " << faces.name << ": "
        << law_text(faces.law, true) << '\n';
  for (const ToothFamily &teeth : scene.teeth)
    out << "  " << std::setw(4) << teeth.slaves.size() << (teeth.elastic ? " rollers " : " points ")
        << teeth.name
        << " (those near the sprocket are looked at): " << law_text(teeth.law, teeth.elastic)
        << '\n';
  if (!scene.bars.empty())
    out << "  " << std::setw(4) << scene.bars.size() << " bars: k "
        << to_text(scene.bars.front().stiffness, 4) << " N/m, c "
        << to_text(scene.bars.front().damping, 4) << " N s/m\n";

  out << "Effects\n";
  for (const Effect &effect : scene.effects)
    out << "  " << std::left << std::setw(22) << effect.name << std::right
        << (effect.on ? "on   " : "off  ") << effect.reason << '\n';

  out << "Choices\n";
  for (const std::string &note : scene.notes)
    out << "  " << note << '\n';

  out << "Cost: state " << to_text(memory / 1024., 4) << " KiB; about "
      << to_text(step_cost(scene) * 1e6, 2) << " us per step, "
      << to_text(step_cost(scene) * n_steps, 2) << " s of CPU time for " << n_steps
      << " steps, outputs not counted\n";
}
} // namespace chaindrive::scene
