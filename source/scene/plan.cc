// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/part.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/scene/plan.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>
#include <tuple>
#include <utility>

namespace chaindrive::scene
{
namespace
{
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
      return scene.drive.sprockets.at(body.number).name + " sprocket";
    case Kind::tensioner:
      return (body.mount.kind == Mount::Kind::motor ? "arm of " : "tensioner of ") +
             scene.drive.sprockets.at(body.number).name;
    case Kind::guide:
      return "guides";
    case Kind::bearing:
      return "slides of bearings";
    case Kind::machine:
      return body.mount.kind == Mount::Kind::motor ? "motor" : "machines behind couplings";
    }
  return "";
}

std::string motion_of(const Scene &scene, const Body &body)
{
  const std::string carrier =
      body.mount.carrier && scene.bodies[*body.mount.carrier].kind == Kind::bearing ? "bearing" :
                                                                                      "tensioner";
  if (body.kind == Kind::machine)
    return body.mount.kind == Mount::Kind::motor ? "turned by the speed program" :
                                                   "one rotation against the load torque";
  if (body.kind == Kind::bearing)
    return "a way along x or y, held by springs";
  const std::string rim = body.motion == Motion::elastic ? "elastic rim, " : "rigid, ";
  if (body.mount.kind == Mount::Kind::fixed)
    return body.mount.carrier ? "carried by its tensioner" : "fixed";
  if (body.mount.kind == Mount::Kind::motor && body.kind == Kind::tensioner)
    return "an arm, turned as is prescribed";
  if (body.mount.kind == Mount::Kind::motor)
    return rim + "hub turned by the speed program" +
           (body.mount.carrier ? ", carried by its " + carrier : "");
  if (body.kind == Kind::tensioner || body.kind == Kind::guide)
    return body.mount.kind == Mount::Kind::prismatic ? "a slide, pressed by its spring" :
                                                       "an arm, turned by its spring";
  const bool coupled =
      body.kind == Kind::sprocket &&
      std::any_of(scene.couplings.begin(), scene.couplings.end(), [&](const Coupling &coupling) {
        return coupling.sprocket == body.number;
      });
  if (body.mount.kind == Mount::Kind::revolute)
    return rim +
           (coupled ? "one rotation of the hub on its coupling" :
                      "one rotation of the hub against the load torque") +
           (body.mount.carrier ? ", carried by its " + carrier : "");
  switch (body.motion)
    {
    case Motion::lumped:
      return body.inertia[2] > 0. ? "lumped, 3 translations and a spin" : "lumped, 3 translations";
    case Motion::rigid:
      return "rigid, 6 degrees of freedom";
    case Motion::reduced:
      return "reduced";
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

std::string friction_text(const ContactLaw &law)
{
  return law.friction > 0. ? ", mu " + to_text(law.friction) : ", frictionless";
}

std::string law_text(const ContactLaw &law, const bool elastic)
{
  const std::string per  = elastic ? "3" : ""; // per area
  std::string       text = "k " + to_text(law.stiffness, 4) + " N/m" + per;
  text += law.damping > 0. ? ", c " + to_text(law.damping, 4) + " N s/m" + per : ", undamped";
  return text + friction_text(law) + (elastic ? " (nodes, per area)" : " (each point)");
}

/// What meshes of rollers do to their clearance: n columns of nodes about the axis touch a plane,
/// or the nearly straight flank of a tooth, in a line. A roller of radius R one of whose columns
/// points there touches at the distance R of its axis, one with two columns on either side at R
/// cos(pi / n).
std::string columns_text(const Scene &scene, const ToothFamily &teeth)
{
  const mesh::CylinderGrid grid(*scene.parts.at(scene.bodies[teeth.slaves.front().body].part()),
                                static_cast<mesh::Surface>(teeth.slave_surface));
  const unsigned int       n     = grid.n_circumferential();
  const std::string        entry = scene.drive.bushes.empty() ? "Mesh/Roller" : "Mesh/Inner link";
  return ", on " + std::to_string(n) +
         " columns of nodes: between two of them a straight flank is met up to " +
         to_text(1e6 * grid.radius * (1. - std::cos(dealii::numbers::PI / n)), 3) + " um late (" +
         entry + "/Cells around)";
}
} // namespace

void print_plan(std::ostream &out, const Scene &scene)
{
  out << "Bodies\n";
  std::map<std::tuple<PartOf, Motion, std::string>, std::vector<const Body *>> alike;
  for (const Body &body : scene.bodies)
    alike[{body.part(), body.motion, motion_of(scene, body)}].push_back(&body);
  for (const auto &[sort, bodies] : alike)
    {
      const Body &body = *bodies.front();
      out << "  " << std::setw(4) << bodies.size() << ' ' << name_of(scene, body) << ": "
          << motion_of(scene, body);
      if (body.motion == Motion::elastic)
        out << ", " << size_of(scene, body).first << " elements and " << size_of(scene, body).second
            << " nodes each";
      const auto basis = scene.bases.find(body.part());
      if (body.motion == Motion::reduced && basis != scene.bases.end())
        out << ", 6 degrees of freedom and " << basis->second->size() << " modes each";
      out << '\n';
    }

  out << "Interfaces\n";
  for (const BoreFamily &bores : scene.bores)
    out << "  " << std::setw(4) << bores.pairs.size() << (bores.elastic ? " pairs " : " points ")
        << bores.name << ": "
        << (has_penalty(scene, bores) ? law_text(bores.law, bores.elastic) :
                                        "without penalty" + friction_text(bores.law))
        << '\n';
  for (const FaceFamily &faces : scene.faces)
    out << "  " << std::setw(4) << faces.pairs.size() << " pairs " << faces.name << ": "
        << law_text(faces.law, true) << '\n';
  for (const ToothFamily &teeth : scene.teeth)
    {
      const bool on_edges = teeth.elastic && teeth.slave_surface == mesh::plate_edges;
      out << "  " << std::setw(4) << teeth.slaves.size()
          << (!teeth.elastic             ? " points " :
              on_edges                   ? " links " :
              scene.drive.bushes.empty() ? " rollers " :
                                           " bushes ")
          << teeth.name << " (those near the sprocket are looked at): "
          << (has_penalty(scene, teeth) ?
                  law_text(teeth.law, teeth.elastic) +
                      (on_edges || !teeth.elastic ? "" : columns_text(scene, teeth)) :
                  "without penalty" + friction_text(teeth.law) + ", in strips of the profile")
          << '\n';
    }
  for (const GuideFamily &guide : scene.guides)
    out << "  " << std::setw(4) << guide.slaves.size() << (guide.elastic ? " links " : " points ")
        << guide.name << " (those near it are looked at): " << law_text(guide.law, guide.elastic)
        << '\n';
  if (!scene.bars.empty())
    out << "  " << std::setw(4) << scene.bars.size() << " bars: k "
        << to_text(scene.bars.front().stiffness, 4) << " N/m, c "
        << to_text(scene.bars.front().damping, 4) << " N s/m\n";

  out << "Effects\n";
  for (const model::Decision &effect : scene.effects)
    out << "  " << std::left << std::setw(24) << effect.name()
        << (effect.name().size() < 24 ? "" : "  ") << std::right << (effect.on ? "on   " : "off  ")
        << effect.reason << '\n';

  out << "Choices\n";
  for (const std::string &note : scene.notes)
    out << "  " << note << '\n';
}
} // namespace chaindrive::scene
