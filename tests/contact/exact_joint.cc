// SPDX-License-Identifier: LGPL-2.1-or-later
// Reduced rollers and links on whose bushes they are, without penalty, collide, spinning and with
// friction, in two batches: on two ranks joints reach from one rank to the other. Momentum stays,
// and its moment. The balance of energies closes with the square of the step, with friction as
// without, down to 3e-5 of what moves: normal forces act across the bore as it is deformed. Along
// the ray through a node instead they would leave 0.1 % of what friction takes. The same on any
// number of ranks and with a search at every step. The limit of the step is that of roller
// and link with the nodes of a window closed between them; it is kept for later runs of the same
// bodies.
#include "../support/reduced.h"

#include <chaindrive/contact/joint_flexibility.h>
#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/reduction/side_flexibility.h>
#include <chaindrive/stability/step_limit.h>
#include <chaindrive/statics/cache.h>
#include <chaindrive/utilities/checksum.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>

using namespace test;

namespace
{
bool with_numbers = false; ///< behind the verdicts: if there is an argument

constexpr unsigned int n = 11;

/// @p slowed: modes of rollers and links as in runs, so that the joint decides about the limit.
scene::Scene make_scene(const bool rubs, const bool slowed = false)
{
  scene::Scene scene               = empty_scene();
  const auto   chain               = drive::make_chain(parameters::Chain());
  scene.parts[scene::Kind::roller] = std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, scene.material.density, mesh::RollerGrid(2, 24, 4)));
  scene.parts[scene::Kind::inner_link] = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(chain, scene.material.density, mesh::inner_link_grid(0)));

  // roller k is on the first bush of link k + 1: some pairs lie in different batches
  const Vector3 arm = vector(-0.5 * chain.inner_hole_pitch, 0.);
  for (unsigned int k = 0; k < n; ++k)
    {
      scene::Body link      = body(scene::Motion::elastic,
                              scene::Mount::free(),
                              0.,
                              Vector3(),
                              vector(0.05 * k, 0.01 * k),
                              vector(0.3, 0.1 * k, 0.));
      link.kind             = scene::Kind::inner_link;
      link.initial.rotation = to_matrix(rotation_about_z(0.4 * k));
      scene.bodies.push_back(link);
    }
  scene::BoreFamily joint;
  joint.name       = "roller-bush";
  joint.elastic    = true;
  joint.half_angle = 0.6;
  joint.law        = {1e14, 0., 0., 0., 0.};
  if (rubs)
    joint.law = {1e14, 0., 0.3, 8e12, 0.};
  for (unsigned int k = 0; k < n; ++k)
    {
      const unsigned int on           = (k + 1) % n;
      const Frame       &link         = scene.bodies[on].initial;
      scene::Body        roller       = body(scene::Motion::elastic,
                                scene::Mount::free(),
                                0.,
                                Vector3(),
                                link.position + link.rotation * arm + vector(2e-5, 1e-5),
                                link.velocity + vector(1., 0.3 * k - 1., 0.));
      roller.initial.rotation         = to_matrix(rotation_about_z(0.1 * k));
      roller.initial.angular_velocity = vector(0., 0., rubs ? 400. : 0.);
      scene.bodies.push_back(roller);
      joint.pairs.push_back({n + k,
                             dealii::Point<3>(),
                             0.5 * chain.roller_bore,
                             {on, dealii::Point<3>(arm), 0.5 * chain.bush_diameter, k},
                             mesh::roller_bore,
                             mesh::bush_outside_first});
    }
  scene.bores.push_back(joint);
  reduction::BasisOptions options;
  options.modes_up_to      = 2. * dealii::numbers::PI * 120e3;
  options.orders.tube      = 0; // teeth do not press
  options.orders.in_joints = false;
  reduce(scene, options);
  if (slowed)
    {
      options.fastest_of_rollers = 2e3 * dealii::numbers::PI * 90.;
      options.fastest_of_links   = 2e3 * dealii::numbers::PI * 80.;
      for (auto &[part, basis] : scene.bases)
        {
          auto slower = std::make_shared<reduction::Basis>(*basis);
          slow_down(*scene.parts.at(part), options, *slower);
          basis = slower;
        }
    }
  return scene;
}

/// Of roller @p k and its link.
struct Momentum
{
  Vector3 linear, angular;
};

Momentum momentum(const World &world, const unsigned int k)
{
  Momentum sum;
  for (const unsigned int b : {n + k, (k + 1) % n})
    {
      const Vector3 p = world.mass[b] * world.frames[b].velocity;
      sum.linear += p;
      sum.angular += cross_product_3d(world.frames[b].position, p) + world.rotations[b].momentum;
    }
  return sum;
}

struct Outcome
{
  double               linear = 0., angular = 0., imbalance = 0., friction = 0., stored = 0.;
  unsigned long        missed = 0;
  std::vector<Vector3> velocity; ///< of all bodies
};

Outcome
collide(const bool rubs, const double dt, const MPI_Comm comm, const bool search_every_step = false)
{
  dynamics::System      system(make_scene(rubs), search_every_step, comm);
  const World          &world = system.world;
  std::vector<Momentum> start;
  for (unsigned int k = 0; k < n; ++k)
    start.push_back(momentum(world, k));
  Outcome outcome;
  advance(system, static_cast<unsigned long>(std::lround(1.5e-4 / dt)), dt, [&]() {
    outcome.imbalance = std::max(outcome.imbalance, std::abs(world.ledger.imbalance()));
    outcome.stored    = std::max(outcome.stored, world.ledger.contact);
  });
  for (unsigned int k = 0; k < n; ++k)
    {
      const Momentum now = momentum(world, k);
      outcome.linear =
          std::max(outcome.linear, (now.linear - start[k].linear).norm() / start[k].linear.norm());
      outcome.angular = std::max(outcome.angular,
                                 (now.angular - start[k].angular).norm() / start[k].angular.norm());
    }
  for (const Frame &frame : world.frames)
    outcome.velocity.push_back(frame.velocity);
  outcome.imbalance /= world.ledger.initial;
  outcome.stored /= world.ledger.initial;
  outcome.friction = world.ledger.friction / world.ledger.initial;
  outcome.missed   = dealii::Utilities::MPI::sum(system.contacts.n_missed(), comm);
  return outcome;
}

double difference(const Outcome &a, const Outcome &b)
{
  double largest = 0.;
  for (unsigned int i = 0; i < a.velocity.size(); ++i)
    largest = std::max(largest, (a.velocity[i] - b.velocity[i]).norm());
  return largest;
}

/// One side of the joint: its nodes, [column][ring], and how far motions of unit mass move them
/// away from the axis, 1/sqrt(kg).
struct JointSide
{
  JointSide(const scene::Scene &scene, const scene::Kind kind, const mesh::Surface surface)
  {
    const mesh::Part         &part = *scene.parts.at(kind);
    const mesh::Nodes         nodes(part);
    const reduction::FreePart free(
        part, nodes, element::ElasticPart(part, nodes, scene.material, scene.elements));
    const reduction::Basis                   &basis = *scene.bases.at(kind);
    const std::vector<reduction::SidePatches> sides = {{part, nodes, surface}};
    rigid                                           = reduction::patch_motions(sides, free.rigid());
    modes                                           = reduction::patch_motions(sides, basis.modes);
    omega                                           = basis.omega;
    for (const reduction::RoundFlexibility &side : basis.joints)
      if (side.surface == surface)
        flexibility = &side;
  }

  dealii::FullMatrix<double>         rigid, modes;
  std::vector<double>                omega;
  const reduction::RoundFlexibility *flexibility = nullptr;
};

/// The limit of a roller and a link that vibrate together, the nodes of the bush in the worst of
/// sixteen windows being closed: none of the program's step limits takes part.
double limit_together(const scene::Scene &scene)
{
  using dealii::numbers::PI;
  const JointSide bore(scene, scene::Kind::roller, mesh::roller_bore),
      bush(scene, scene::Kind::inner_link, mesh::bush_outside_first);
  const contact::JointFlexibility joint(*bore.flexibility, *bush.flexibility);
  const unsigned int n_bore = bore.flexibility->n_columns, n_bush = bush.flexibility->n_columns,
                     m = joint.n_rings(), n_gaps = n_bush * m;
  std::vector<double> omega = bore.omega;
  omega.insert(omega.end(), bush.omega.begin(), bush.omega.end());
  const auto                &matrix = joint.of_columns(n_bush);
  reduction::SideFlexibility both(n_gaps, n_gaps);
  for (unsigned int i = 0; i < n_gaps; ++i)
    for (unsigned int j = 0; j < n_gaps; ++j)
      both(i, j) = matrix.number[std::size_t(i) * matrix.stride + j];

  double limit = std::numeric_limits<double>::max();
  for (unsigned int direction = 0; direction < 16; ++direction)
    {
      const double middle = direction * PI / 8.; // in the link; 0 in the roller
      const auto   rows   = [&](const dealii::FullMatrix<double> &of_bore,
                            const dealii::FullMatrix<double> &of_bush) {
        dealii::FullMatrix<double> row(n_gaps, of_bore.n() + of_bush.n());
        for (unsigned int i = 0; i < n_gaps; ++i)
          {
            const double column =
                             std::fmod(2. * PI + 2. * PI * (i / m) / n_bush - middle, 2. * PI) *
                             n_bore / (2. * PI),
                         part  = column - std::floor(column);
            const auto  before = static_cast<unsigned int>(column);
            const auto &place  = joint.places()[i % m];
            for (unsigned int k = 0; k < of_bore.n(); ++k)
              for (const unsigned int c : {0u, 1u})
                for (const unsigned int r : {0u, 1u})
                  row(i, k) +=
                      (c == 0 ? 1. - part : part) * (r == 0 ? 1. - place.part : place.part) *
                      of_bore((before + c) % n_bore * bore.flexibility->n_rings() + place.first + r,
                              k);
            for (unsigned int k = 0; k < of_bush.n(); ++k)
              row(i, of_bore.n() + k) =
                  -of_bush(i / m * bush.flexibility->n_rings() + joint.rings()[i % m], k);
          }
        return row;
      };
      std::vector<unsigned int> closed;
      for (unsigned int i = 0; i < n_gaps; ++i)
        if (std::abs(std::remainder(2. * PI * (i / m) / n_bush - middle, 2. * PI)) <=
            0.6 + PI / n_bush)
          closed.push_back(i);
      limit = std::min(
          limit,
          2. /
              reduction::closed_frequency(
                  omega, rows(bore.rigid, bush.rigid), rows(bore.modes, bush.modes), both, closed));
    }
  return limit;
}

double limit_of(const scene::Scene &scene, statics::Cache *kept)
{
  const dynamics::System system(scene, false, MPI_COMM_SELF);
  return stability::step_limit(system.world, system.bars, system.forces, system.contacts, 0., kept);
}

/// Puts @p value in place of what the only file of @p folder keeps; false if there are others.
bool replace_kept(const std::string &folder, const double value)
{
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  if (files.size() != 1)
    return false;
  nlohmann::json all = nlohmann::json::parse(std::ifstream(files.front()));
  all["value"]       = value;
  all["checksum"]    = checksum(all["value"].dump());
  std::ofstream(files.front()) << all;
  return true;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  with_numbers         = argc > 1;
  const bool    first  = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const double  dt     = 2e-7;
  const Outcome rubbed = collide(true, dt, MPI_COMM_WORLD),
                sooner = collide(true, 2. * dt, MPI_COMM_WORLD),
                coarse = collide(false, 2. * dt, MPI_COMM_WORLD),
                fine   = collide(false, dt, MPI_COMM_WORLD),
                always = collide(true, dt, MPI_COMM_WORLD, true);
  if (!first)
    return 0;
  const scene::Scene     scene = make_scene(false, true);
  const dynamics::System system(scene, false, MPI_COMM_SELF);
  const double           limit =
      stability::step_limit(system.world, system.bars, system.forces, system.contacts, 0.);
  if (with_numbers)
    std::cerr << "limit " << limit << " together " << limit_together(scene) << ", imbalance "
              << sooner.imbalance << ' ' << rubbed.imbalance << ' ' << coarse.imbalance << ' '
              << fine.imbalance << ", stored " << coarse.stored << ", friction " << rubbed.friction
              << ", linear " << rubbed.linear << " angular " << coarse.angular << ' '
              << rubbed.angular << ", search " << difference(always, rubbed) << '\n';
  verdict("the limit is that of roller and link together to 1e-3 and above the step",
          std::abs(limit / limit_together(scene) - 1.) < 1e-3 && limit > 2. * dt);

  const std::string folder = "kept limits";
  std::filesystem::remove_all(folder);
  statics::Cache     kept(folder);
  const scene::Scene rubbing    = make_scene(true, true);
  const double       of_rubbing = limit_of(rubbing, nullptr);
  verdict("a limit is kept as it is, bit by bit", limit_of(scene, &kept) == limit);
  verdict("and read from there",
          replace_kept(folder, 0.5 * limit) && limit_of(scene, &kept) == 0.5 * limit);
  verdict("with friction it is another one, found anew",
          limit_of(rubbing, &kept) == of_rubbing && of_rubbing < limit);

  verdict("momentum kept to 1e-10", rubbed.linear < 1e-10);
  verdict("angular momentum to 1e-10, with friction to 2e-8",
          coarse.angular < 1e-10 && rubbed.angular < 2e-8);
  verdict("walls store more than 0.1 % of the energy", coarse.stored > 1e-3);
  verdict("friction takes more than 0.1 % of the energy", rubbed.friction > 1e-3);
  verdict("imbalance below 1e-3 of the energy", rubbed.imbalance < 1e-3 && coarse.imbalance < 1e-3);
  verdict("and more than 4 times smaller at half of the step",
          coarse.imbalance > 4. * fine.imbalance);
  verdict("3 times with friction, of which it is less than 1e-3",
          sooner.imbalance > 3. * rubbed.imbalance && rubbed.imbalance < 1e-3 * rubbed.friction);
  verdict("no contact missed", rubbed.missed + coarse.missed + fine.missed == 0);
  verdict("the same as with a search at every step to 1e-8 m/s", difference(always, rubbed) < 1e-8);
}
