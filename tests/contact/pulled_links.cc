// SPDX-License-Identifier: LGPL-2.1-or-later
// Three links pulled, an outer one between two inner ones, whole and half: joints of reduced links
// bear what those of elastic ones do under the same extension, from about 500 to 2000 N. Links keep
// their centres of mass and directions; what balances the forces on the outer ones is their
// inertia.
#include "../support/joined_links.h"

#include <chaindrive/dynamics/relaxation.h>
#include <chaindrive/scene/build.h>

#include <deal.II/base/mpi.h>

using namespace test;

namespace
{
/// The links, with pins in their bushes by @p extension [m] more than they touch.
scene::Scene pulled(const Parameters &p, const drive::Drive &drive, const double extension)
{
  scene::Scene scene    = empty_scene();
  scene.half            = p.model.half == parameters::SymmetryModel::yes;
  scene.drive.pitch     = drive.chain.pitch;
  scene.drive.n_joints  = 2;
  scene.material        = p.material;
  scene.elements        = p.elements;
  scene.prestress       = 1e4;
  const double distance = 0.5 * (drive.chain.inner_hole_pitch + drive.chain.outer_hole_pitch) +
                          drive.chain.pin_clearance() + extension;
  for (const int i : {-1, 0, 1})
    {
      scene::Body link = body(scene::Motion::elastic,
                              scene::Mount::free(),
                              1.,
                              vector(1., 1., 1.),
                              vector(i * distance, 0.));
      link.kind        = i == 0 ? scene::Kind::outer_link : scene::Kind::inner_link;
      link.number      = i + 1;
      scene.bodies.push_back(link);
    }
  for (const bool inner : {true, false})
    scene.parts[inner ? scene::Kind::inner_link : scene::Kind::outer_link] =
        scene::make_link_part({p.mesh, p.material.density, scene.half}, drive, inner);

  scene::BoreFamily pins;
  pins.name          = "bush-pin";
  pins.elastic       = true;
  pins.law.stiffness = penalty_of_pins(scene, p.material);
  for (const unsigned int joint : {0u, 1u})
    pins.pairs.push_back(
        {2 * joint,
         dealii::Point<3>((joint == 0 ? 0.5 : -0.5) * drive.chain.inner_hole_pitch, 0., 0.),
         0.5 * drive.chain.bush_bore,
         {1, dealii::Point<3>(), 0.5 * drive.chain.pin_diameter, joint},
         joint == 0 ? mesh::bush_bore_second : mesh::bush_bore_first,
         joint == 0 ? mesh::pin_outside_first : mesh::pin_outside_second});
  scene.bores.push_back(pins);
  return scene;
}

double pin_force(const scene::Scene &scene)
{
  return dynamics::Relaxation(scene, MPI_COMM_SELF, 1e-5).joint_forces().pin[0];
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool half : {true, false})
    {
      Parameters p;
      p.model.fidelity  = "full";
      p.model.half      = half ? parameters::SymmetryModel::yes : parameters::SymmetryModel::no;
      p.mesh.refinement = 1;
      const drive::Drive drive = drive::make_drive(p);
      std::cout << (half ? "half" : "whole") << std::endl;
      for (const double extension : {7e-6, 12e-6, 22e-6})
        {
          scene::Scene scene = pulled(p, drive, extension);
          const double full  = pin_force(scene);
          reduce(scene);
          const double ratio = pin_force(scene) / full;
          std::cout << "about " << 100. * std::round(full / 100.)
                    << " N, within 2 % of elastic links: " << (std::abs(ratio - 1.) < 0.02)
                    << std::endl;
          if (argc > 1)
            std::cout << full << " N, ratio " << ratio << std::endl;
        }
    }
}
