// SPDX-License-Identifier: LGPL-2.1-or-later
// Speed of the contact of elastic bodies on one core: nanoseconds per slave node that is visited,
// for every roller on its bush and every bush on its pin of a chain under tension, and for rollers
// in the gaps of a sprocket.
//
// usage: contact_benchmark [LINKS]
#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/joints.h>
#include <chaindrive/contact/node_contact.h>
#include <chaindrive/element/hexahedra.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

using namespace chaindrive;

namespace
{
double cpu_seconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

/// Median seconds of CPU time of one call of @p work.
double time_of(const std::function<void()> &work)
{
  std::vector<double> times;
  work();
  for (unsigned int repetition = 0; repetition < 21; ++repetition)
    {
      const double start = cpu_seconds();
      for (unsigned int i = 0; i < 20; ++i)
        work();
      times.push_back((cpu_seconds() - start) / 20);
    }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// All copies of a part, with a little noise of position and velocity.
struct Batches
{
  Batches(const mesh::Part           &part,
          const parameters::Material &material,
          const unsigned int          n,
          const double                pitch,
          const double                start)
      : reference(part, material, element::Formulation::one_point)
      , stride(3 * reference.n_nodes() * n_lanes)
  {
    const unsigned int n_batches = (n + n_lanes - 1) / n_lanes;
    for (auto *values : {&position, &velocity, &force})
      values->resize(std::size_t(n_batches) * stride, 0.);
    for (unsigned int copy = 0; copy < n_batches * n_lanes; ++copy)
      for (unsigned int node = 0; node < reference.n_nodes(); ++node)
        for (unsigned int i = 0; i < 3; ++i)
          {
            const std::size_t at = index(copy) + (3 * node + i) * n_lanes;
            position[at]         = reference.position[node][i] + 5e-8 * std::sin(1. + at) +
                           (i == 0 ? start + copy * pitch : 0.);
            velocity[at] = std::sin(2. + at);
          }
  }

  std::size_t index(const unsigned int copy) const
  {
    return std::size_t(copy / n_lanes) * stride + copy % n_lanes;
  }

  contact::JointBody body(const unsigned int copy, const std::vector<unsigned int> &nodes)
  {
    return {nodes.data(),
            position.data() + index(copy),
            velocity.data() + index(copy),
            force.data() + index(copy)};
  }

  element::Hexahedra            reference;
  std::size_t                   stride;
  dealii::AlignedVector<double> position, velocity, force;
};

/// Joints of one kind, with the two sides of each body.
void measure(
    const std::string                                                                &name,
    const mesh::CylinderGrid                                                         &master,
    const mesh::CylinderGrid                                                         &slave,
    const unsigned int                                                                n_joints,
    const std::function<std::pair<contact::JointBody, contact::JointBody>(unsigned)> &joint)
{
  const contact::JointTables tables(master, slave);
  const scene::ContactLaw    law{1e14, 1e7, 0.1, 5e13, 1e7};
  std::printf("\n%s: %u joints, %u slave nodes each, %u columns in %u\n",
              name.c_str(),
              n_joints,
              tables.n_slave_nodes(),
              slave.n_circumferential(),
              master.n_circumferential());
  std::printf("%6s%12s%12s%12s%16s%16s%16s\n",
              "width",
              "visited",
              "touching",
              "us / call",
              "ns / visited",
              "search, ns",
              "us / search");
  for (const int width : {1, 2, 4, 8})
    {
      const contact::JointKernels *kernels = contact::joint_kernels(width);
      if (kernels == nullptr)
        continue;
      std::vector<std::unique_ptr<contact::JointBatch>> batches;
      unsigned int                                      visited = 0, touching = 0;
      for (unsigned int k = 0; k < n_joints; ++k)
        {
          if (k % n_lanes == 0)
            batches.push_back(std::make_unique<contact::JointBatch>(tables, law, *kernels));
          const auto [outer, inner] = joint(k);
          batches.back()->set_joint(k % n_lanes, outer, inner);
        }
      for (auto &batch : batches)
        {
          batch->search(2e-6, 1.);
          batch->add_forces(1e-9, 1e-9);
          visited += batch->n_visited();
          for (const unsigned int n : batch->sums().touching)
            touching += n;
        }
      const double call   = time_of([&] {
        for (auto &batch : batches)
          batch->add_forces(1e-9, 1e-9);
      });
      const double search = time_of([&] {
        for (auto &batch : batches)
          batch->search(2e-6, 1.);
      });
      std::printf("%6d%12u%12u%12.1f%16.1f%16.1f%16.1f\n",
                  width,
                  visited,
                  touching,
                  1e6 * call,
                  1e9 * call / visited,
                  1e9 * search / (n_joints * tables.n_slave_nodes()),
                  1e6 * search);
    }
}

/// A roller a micrometre deep in the bottom of each gap of a rigid sprocket.
scene::Scene seated_rollers(std::shared_ptr<const mesh::Part> roller,
                            const drive::ChainDimensions     &chain,
                            const unsigned int                teeth,
                            const double                      friction)
{
  scene::Scene scene;
  const auto   form = std::make_shared<const drive::ToothForm>(
      drive::make_tooth_form(teeth, chain, parameters::Sprockets(), 0));
  scene::ToothFamily family;
  family.name          = "teeth";
  family.sprocket      = teeth;
  family.form          = form;
  family.teeth         = teeth;
  family.outer_radius  = 0.5 * form->outside_diameter;
  family.half_width    = 3.6e-3;
  family.law           = {1e14, 1e7, friction, 5e13, 1e7};
  family.elastic       = true;
  family.slave_surface = mesh::roller_outside;
  for (unsigned int b = 0; b <= teeth; ++b)
    {
      scene::Body body;
      body.kind             = scene::Kind::roller;
      body.number           = 0;
      body.motion           = b < teeth ? scene::Motion::elastic : scene::Motion::rigid;
      body.mount            = b < teeth ? scene::Mount::free() : scene::Mount::motor();
      body.mass             = roller->meshed.mass;
      body.initial.rotation = to_matrix(Quaternion());
      if (b < teeth)
        {
          const double angle       = 2. * dealii::numbers::PI * b / teeth;
          const double r           = 0.5 * form->root_diameter + 0.5 * chain.roller_diameter - 1e-6;
          body.initial.position[0] = r * std::cos(angle);
          body.initial.position[1] = r * std::sin(angle);
          family.slaves.push_back({b, dealii::Point<3>(), 0.5 * chain.roller_diameter, b});
        }
      scene.bodies.push_back(body);
    }
  scene.parts[scene::Kind::roller] = std::move(roller);
  scene.teeth                      = {family};
  return scene;
}

void measure_teeth(const std::shared_ptr<const mesh::Part> &roller,
                   const drive::ChainDimensions            &chain)
{
  const unsigned int teeth  = 15;
  const scene::Scene scene  = seated_rollers(roller, chain, teeth, 0.1);
  World              world  = make_world(scene);
  const double       within = 100e-6; // the reach of the search, see node_contact.cc

  const scene::SurfaceFamily   rollers = contact::on_flanks(scene.teeth[0], world);
  contact::Surface::Projection projection;
  const BodyBatches           &copies = world.copies[0];
  const mesh::SurfaceNodes     nodes(*roller, copies.nodes, mesh::roller_outside);
  unsigned int                 visited = 0, touching = 0, hint = mesh::Projection::no_facet;
  for (unsigned int copy = 0; copy < teeth; ++copy)
    for (const unsigned int node : nodes.node)
      {
        dealii::Tensor<1, 3> x;
        for (unsigned int d = 0; d < 3; ++d)
          x[d] = NodeView(copies.position).component(copies.index(copy, node), d);
        const double gap =
            rollers.surface->project(world, x, 0., 2. * within, hint, projection).gap;
        visited += gap < within;
        touching += gap < 0.;
      }
  std::printf("\nrollers in the gaps of a sprocket: %u rollers, %u slave nodes each\n",
              teeth,
              nodes.size());
  std::printf("%6s%12s%12s%12s%16s%16s%16s\n",
              "width",
              "visited",
              "touching",
              "us / call",
              "ns / visited",
              "search, ns",
              "us / search");
  for (const int width : {1, 2, 4, 8})
    {
      if (contact::joint_kernels(width) == nullptr)
        continue;
      setenv("CHAINDRIVE_SIMD_WIDTH", std::to_string(width).c_str(), 1);
      contact::NodeContact family(rollers, world, false), every(rollers, world, true);
      for (contact::NodeContact *f : {&family, &every})
        f->search(world, 1e-3);
      const double call   = time_of([&] { family.add_forces(world, 1e-9); });
      const double search = time_of([&] { every.add_forces(world, 1e-9); }) - call;
      std::printf("%6d%12u%12u%12.1f%16.1f%16.1f%16.1f\n",
                  width,
                  visited,
                  touching,
                  1e6 * call,
                  1e9 * call / visited,
                  1e9 * search / (teeth * nodes.size()),
                  1e6 * search);
    }
}
} // namespace

int main(int argc, char **argv)
{
  const unsigned int         n     = argc > 1 ? std::stoi(argv[1]) : 110;
  const auto                 chain = drive::make_chain(parameters::Chain());
  const parameters::Material material;
  const mesh::Part roller = mesh::make_roller(chain, material.density, mesh::RollerGrid(3, 48, 10)),
                   inner = mesh::make_inner_link(chain, material.density, mesh::inner_link_grid(3)),
                   outer = mesh::make_outer_link(chain, material.density, mesh::outer_link_grid(3));

  // A straight chain: each roller and each pin has come through its clearance by a micrometre.
  const double pitch = chain.pitch, overlap = 1e-6;
  const double inner_half  = 0.5 * drive::inner_plate(chain).hole_pitch,
               outer_half  = 0.5 * drive::outer_plate(chain).hole_pitch;
  const double roller_play = chain.roller_clearance() + overlap,
               pin_play    = 0.5 * (chain.bush_bore - chain.pin_diameter) + overlap;
  Batches rollers(roller, material, n, pitch, -inner_half + roller_play),
      inners(inner, material, n / 2, 2. * pitch, 0.),
      outers(outer, material, n / 2, 2. * pitch, inner_half + outer_half - pin_play);

  const mesh::CylinderGrid roller_bore(roller, mesh::roller_bore);
  const mesh::CylinderGrid bush_outside[2] = {{inner, mesh::bush_outside_first},
                                              {inner, mesh::bush_outside_second}};
  const mesh::CylinderGrid bush_bore[2]    = {{inner, mesh::bush_bore_first},
                                              {inner, mesh::bush_bore_second}};
  const mesh::CylinderGrid pin_outside[2]  = {{outer, mesh::pin_outside_first},
                                              {outer, mesh::pin_outside_second}};
  const auto roller_nodes = contact::node_offsets(roller_bore, mesh::Nodes(roller).vertex);
  std::vector<unsigned int> outside_nodes[2], bore_nodes[2], pin_nodes[2];
  for (int side = 0; side < 2; ++side)
    {
      outside_nodes[side] = contact::node_offsets(bush_outside[side], mesh::Nodes(inner).vertex);
      bore_nodes[side]    = contact::node_offsets(bush_bore[side], mesh::Nodes(inner).vertex);
      pin_nodes[side]     = contact::node_offsets(pin_outside[side], mesh::Nodes(outer).vertex);
    }

  measure("roller on bush", roller_bore, bush_outside[0], n, [&](const unsigned int k) {
    return std::make_pair(rollers.body(k, roller_nodes), inners.body(k / 2, outside_nodes[k % 2]));
  });
  // the second bush of an inner link is on the first pin of the outer link that follows
  measure("bush on pin", bush_bore[0], pin_outside[0], n / 2, [&](const unsigned int k) {
    return std::make_pair(inners.body(k, bore_nodes[1]), outers.body(k, pin_nodes[0]));
  });
  measure_teeth(std::make_shared<const mesh::Part>(
                    mesh::make_roller(chain, material.density, mesh::RollerGrid(3, 48, 10))),
                chain);
}
