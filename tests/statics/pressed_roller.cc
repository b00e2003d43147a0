// SPDX-License-Identifier: LGPL-2.1-or-later
// The ladder of fidelities: a roller that is pressed between a tooth's seat and the bush in it, as
// layered models take their stiffness from room statics, and as the full model has it. An inner
// link is pressed with both of its rollers upon the seats of two sprockets, by the approach that
// statics gives for a load; what the seats bear is compared.
#include "../support/scenes.h"

#include <chaindrive/dynamics/relaxation.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/statics/part_stiffness.h>

#include <deal.II/base/mpi.h>

using namespace test;

namespace
{
/// Numbers of cells, all along the whole part, and of the sprocket's refinement.
struct Grids
{
  std::string      name;
  mesh::RollerGrid roller;
  mesh::LinkGrid   link;
  unsigned int     sprocket;
};

double thickness(const mesh::Part &part, const mesh::Surface side)
{
  return mesh::SurfaceNodes(part, mesh::Nodes(part), side).thickness;
}

/// Two rollers, an inner link and two sprockets, of halves. The link is nearer to the hubs by the
/// sum of @p approach [m], of hub and roller, of roller and link, than where all touch.
scene::Scene bodies_of(const drive::Drive &drive, Grids grids, const std::vector<double> &approach)
{
  const drive::ChainDimensions &chain    = drive.chain;
  const drive::Sprocket        &sprocket = drive.sprockets[0];
  scene::Scene                  scene    = empty_scene();
  const double                  density  = scene.material.density;
  scene.half = grids.roller.half = grids.link.half = true;
  scene.drive.n_joints                             = 2;
  scene.drive.pitch                                = chain.pitch;

  const auto share = [](mesh::Part &&part) {
    return std::make_shared<const mesh::Part>(std::move(part));
  };
  scene.parts[scene::Kind::roller]     = share(mesh::make_roller(chain, density, grids.roller));
  scene.parts[scene::Kind::inner_link] = share(mesh::make_inner_link(chain, density, grids.link));
  const auto rim =
      share(mesh::make_sprocket(sprocket.form,
                                {sprocket.bore, sprocket.hub_diameter, drive.sprocket_width},
                                density,
                                grids.sprocket,
                                true));
  for (const unsigned int k : {0U, 1U})
    {
      const scene::PartOf part(scene::Kind::sprocket, k);
      scene.parts[part]   = rim;
      scene.sectors[part] = std::make_shared<const mesh::Sector>(*rim);
    }

  const auto add = [&scene](const scene::Kind   kind,
                            const unsigned int  number,
                            const scene::Mount &mount,
                            const Vector3      &at) {
    scene::Body it = body(scene::Motion::elastic, mount, 1., vector(1., 1., 1.), at, Vector3());
    it.kind        = kind;
    it.number      = number;
    it.mass        = scene.parts.at(it.part())->meshed.mass;
    scene.bodies.push_back(it);
  };
  // the bush from above on the roller, the roller on the seat, which is at the top of its sprocket
  const double half   = 0.5 * chain.inner_hole_pitch;
  const double height = 0.5 * (chain.roller_bore - chain.bush_diameter) + approach[1];
  const double hub =
      height + approach[0] - 0.5 * (sprocket.form.root_diameter + chain.roller_diameter);
  for (const unsigned int k : {0U, 1U})
    add(scene::Kind::roller, k, scene::Mount::free(), vector(k == 0 ? -half : half, height));
  add(scene::Kind::inner_link, 0, scene::Mount::free(), Vector3());
  for (const unsigned int k : {0U, 1U})
    {
      add(scene::Kind::sprocket, k, scene::Mount::motor(), vector(k == 0 ? -half : half, hub));
      scene.bodies.back().initial.rotation = to_matrix(rotation_about_z(0.5 * dealii::numbers::PI));
    }
  return scene;
}

/// What touches in bodies_of(): bushes in rollers, rollers on seats, with the penalty @p factor.
void add_contacts(const drive::Drive &drive, const double factor, scene::Scene &scene)
{
  const drive::ChainDimensions &chain    = drive.chain;
  const drive::Sprocket        &sprocket = drive.sprockets[0];
  const mesh::Part             &roller   = *scene.parts.at(scene::Kind::roller),
                   &link                 = *scene.parts.at(scene::Kind::inner_link),
                   &rim                  = *scene.sectors.at({scene::Kind::sprocket, 0})->part;
  const auto law                         = [&](const double first, const double second) {
    scene::ContactLaw result;
    result.stiffness = factor * scene.material.bulk_modulus() / std::max(first, second);
    return result;
  };
  scene::BoreFamily bushes;
  bushes.name    = "roller-bush";
  bushes.elastic = true;
  bushes.law = law(thickness(roller, mesh::roller_bore), thickness(link, mesh::bush_outside_first));
  for (const unsigned int k : {0U, 1U})
    {
      bushes.pairs.push_back({k,
                              dealii::Point<3>(),
                              0.5 * chain.roller_bore,
                              {2, dealii::Point<3>(), 0.5 * chain.bush_diameter, k},
                              mesh::roller_bore,
                              k == 0 ? mesh::bush_outside_first : mesh::bush_outside_second});
      scene::ToothFamily teeth;
      teeth.name          = "roller-tooth";
      teeth.sprocket      = 3 + k;
      teeth.form          = std::make_shared<const drive::ToothForm>(sprocket.form);
      teeth.teeth         = sprocket.form.teeth;
      teeth.outer_radius  = 0.5 * sprocket.form.outside_diameter;
      teeth.half_width    = 0.5 * drive.sprocket_width;
      teeth.elastic       = true;
      teeth.slave_surface = mesh::roller_outside;
      teeth.law = law(thickness(roller, mesh::roller_outside), thickness(rim, mesh::tooth_flanks));
      teeth.slaves = {{k, dealii::Point<3>(), 0.5 * chain.roller_diameter, k}};
      scene.teeth.push_back(teeth);
    }
  scene.bores.push_back(bushes);
}

/// The force [N] on one seat.
double full_force(const drive::Drive        &drive,
                  const Grids               &grids,
                  const double               factor,
                  const std::vector<double> &approach)
{
  scene::Scene scene = bodies_of(drive, grids, approach);
  add_contacts(drive, factor, scene);
  const auto seats = dynamics::Relaxation(scene, MPI_COMM_WORLD).joint_forces().seat;
  return 0.5 * (seats[0] + seats[1]);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Parameters                               parameters;
  const drive::Drive                             drive = drive::make_drive(parameters);
  statics::Library library(parameters.material, statics::Cache::usual_folder(), MPI_COMM_WORLD);

  const mesh::LinkGrid link = mesh::inner_link_grid(1);
  mesh::LinkGrid       fine = link;
  fine.wall                 = 2;
  fine.along                = 8;
  mesh::LinkGrid finer      = fine;
  finer.along               = 12;
  for (const Grids &grids : {Grids{"meshes of full.prm", {3, 32, 6}, link, 0},
                             Grids{"2 cells through and 8 along bushes", {3, 32, 6}, fine, 0},
                             Grids{"2 cells through and 12 along bushes", {3, 32, 6}, finer, 0}})
    for (const double factor : {0.5, 5., 20.})
      {
        std::cout << grids.name << ", penalty factor " << factor << ": force over that of statics"
                  << std::fixed << std::setprecision(2);
        for (const double load : {500., 1412., 3000.})
          {
            const statics::ContactSolution pressed = statics::at_force(
                [&](const unsigned int n) {
                  return library.pressed_roller(
                      drive.chain, drive.sprockets[0], drive.sprocket_width, n);
                },
                load);
            std::cout << "  " << full_force(drive, grids, factor, pressed.approach) / load;
          }
        std::cout << "  at 500, 1412, 3000 N\n" << std::defaultfloat;
      }
}
