// SPDX-License-Identifier: LGPL-2.1-or-later
// A driven inertia below that of the elastic rim alone, halves or not, is refused, and one just
// above it is accepted. The rim's is computed anew, from the lumped masses of the cells of its
// sector. Of rims that are rigid the notes say by how much impacts are too hard: what
// doc/accuracy-and-cost.md has for rims so deep, by straight lines between, and what the ends have
// outside.
#include "../support/decided.h"
#include "../support/scenes.h"

#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/utilities/errors.h>

using namespace test;

namespace
{
/// Of the rim of the driven sprocket about its axis, kg m2.
double rim_inertia(const scene::Scene &scene)
{
  const auto &sector = *scene.sectors.at(scene.bodies.back().part());
  const auto  one    = mesh::lumped_properties(*sector.part);
  return sector.n_sectors * (one.inertia[2][2] + one.mass * (one.centre[0] * one.centre[0] +
                                                             one.centre[1] * one.centre[1]));
}

void look(const std::string &what, const Parameters &p)
{
  std::cout << what << ": ";
  try
    {
      scene_of(p);
      std::cout << "accepted\n";
    }
  catch (const InputError &error)
    {
      const std::string text = error.what(); // without its digits
      std::cout << text.substr(0, text.find(" = ")) << " ... " << text.substr(text.find("; ") + 2)
                << '\n';
    }
}
/// What the notes say of the driver's rim with a rigid zone so far below its root, in pitches.
void say_of_rigid(const double deep)
{
  Parameters p;
  p.model.fidelity           = "full";
  p.model.stiffness_from     = parameters::StiffnessFrom::dimensions;
  p.model.elastic_sprockets  = parameters::Switch::off;
  p.effects.tooth_compliance = parameters::Switch::on;
  p.mesh.refinement          = 0;
  p.output.field_interval    = 0.;
  const drive::Drive usual   = drive::make_drive(p);
  p.drive.sprockets.driver().hub_diameter =
      usual.sprockets.front().form.root_diameter - 2. * deep * usual.chain.pitch;
  for (const std::string &note : scene_of(p).notes)
    if (note.find("roller-driver: tooth and rim") == 0)
      std::cout << "  " << note.substr(note.find("without inertia")) << '\n';
}
} // namespace

int main()
{
  Parameters p;
  p.model.fidelity        = "full";
  p.model.stiffness_from  = parameters::StiffnessFrom::dimensions;
  p.mesh.refinement       = 1;
  p.output.field_interval = 0.;
  for (const auto half : {parameters::SymmetryModel::no, parameters::SymmetryModel::yes})
    {
      p.model.half = half;
      p.model.driven_inertia.reset();
      const scene::Scene scene = scene_of(p);
      std::cout << (scene.half ? "halves" : "whole bodies") << '\n';
      const double rim = rim_inertia(scene);
      look("  auto", p);
      p.model.driven_inertia = 1.000001 * rim;
      look("  just above the rim's", p);
      p.model.driven_inertia = 0.999999 * rim;
      look("  just below the rim's", p);
      p.drive.sprockets.driven().elastic = parameters::Switch::off;
      look("  and with a rigid sprocket", p);
      p.drive.sprockets.driven().elastic = parameters::Switch::automatic;
    }
  std::cout << "rigid\n";
  for (const double deep : {0.2, 0.36, 0.51, 0.9, 1.3})
    say_of_rigid(deep);
}
