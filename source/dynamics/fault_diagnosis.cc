// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/fault_diagnosis.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace chaindrive::dynamics
{
namespace
{
using Vector3 = dealii::Tensor<1, 3>;
using contact::Family;
using contact::Record;

std::string text_of(const Vector3 &v, const double unit)
{
  return "(" + to_text(v[0] / unit, 3) + ", " + to_text(v[1] / unit, 3) + ", " +
         to_text(v[2] / unit, 3) + ")";
}

std::string text_of(const scene::Scene &scene, const Family &family, const Record &record)
{
  return "interface " + family.name() + " at joint " + std::to_string(record.joint) + " (" +
         scene.name_of(record.slave) + " on " + scene.name_of(record.master) + ")";
}

std::string text_of(const scene::Scene &scene, const scene::Bar &bar)
{
  return "bar between " + scene.name_of(bar.first) + " and " + scene.name_of(bar.second);
}

/// Node @p node of @p copy of a group; of a rim, copies are teeth.
std::string text_of(const scene::Scene &scene,
                    const World        &world,
                    const unsigned int  group,
                    const unsigned int  copy,
                    const unsigned int  node)
{
  const BodyBatches &copies = world.copies[group];
  const unsigned int body   = copies.bodies[copy];
  return "node " + std::to_string(node) + " of " + scene.name_of(body) +
         (world.rim_of(body) != nullptr ? ", tooth " + std::to_string(copy) : "") + ", at " +
         text_of(dealii::Tensor<1, 3>(copies.nodes.position[node]), 1e-3) +
         " mm in the part's axes";
}

Vector3 value(const World::Vector &from, const unsigned int body)
{
  Vector3 v;
  for (unsigned int d = 0; d < 3; ++d)
    v[d] = from.local_element(3 * body + d);
  return v;
}

bool finite(const Vector3 &v) { return std::isfinite(v[0] + v[1] + v[2]); }

/// Calls @p visit (group, copy) for all copies of elastic bodies that this rank owns.
template <typename Visit>
void for_each_own_copy(const World &world, const Visit &visit)
{
  for (unsigned int g = 0; g < world.n_elastic_groups(); ++g)
    for (unsigned int copy = 0; copy < world.copies[g].n_copies(); ++copy)
      if (world.copies[g].owns(copy))
        visit(g, copy);
}

/// Calls @p visit (family, record, index) for all pairs; those of all ranks on the first one.
template <typename Visit>
void for_each_record(const System &system, const Visit &visit)
{
  for (const auto &family : system.contacts.families())
    for (unsigned int i = 0; i < family->records().size(); ++i)
      visit(*family, family->records()[i], i);
}

/// The places of all ranks, the worst first. Collective.
std::vector<FaultSite> gather(std::vector<FaultSite> mine, const World &world)
{
  if (n_ranks_in(world.communicator()) > 1)
    {
      std::vector<double>      sizes;
      std::vector<std::string> texts, bodies;
      for (const FaultSite &place : mine)
        {
          sizes.push_back(place.size);
          texts.push_back(place.text);
          bodies.push_back(place.of);
        }
      const auto all_sizes  = dealii::Utilities::MPI::all_gather(world.communicator(), sizes);
      const auto all_texts  = dealii::Utilities::MPI::all_gather(world.communicator(), texts);
      const auto all_bodies = dealii::Utilities::MPI::all_gather(world.communicator(), bodies);
      mine.clear();
      for (std::size_t rank = 0; rank < all_sizes.size(); ++rank)
        for (std::size_t i = 0; i < all_sizes[rank].size(); ++i)
          mine.push_back({all_sizes[rank][i], all_texts[rank][i], all_bodies[rank][i]});
    }
  std::stable_sort(mine.begin(), mine.end(), [](const FaultSite &a, const FaultSite &b) {
    return a.size > b.size;
  });
  return mine;
}

/// A force on a body that something reports.
struct Reported
{
  unsigned int body;
  Vector3      force; ///< N
  std::string  by;
};

/// All forces of contacts and bars, on both of their bodies. On the first rank only.
std::vector<Reported> reported_forces(const scene::Scene &scene, const System &system)
{
  std::vector<Reported> all;
  for_each_record(system, [&](const Family &family, const Record &record, unsigned int) {
    if (record.force.norm_square() > 0.)
      for (const double sign : {1., -1.})
        all.push_back({sign > 0. ? record.slave : record.master,
                       sign * record.force,
                       text_of(scene, family, record)});
  });
  for (unsigned int i = 0; i < system.bars.size(); ++i)
    {
      const scene::Bar &bar = system.bars.bars()[i];
      const Vector3     between =
          system.world.frames[bar.second].position - system.world.frames[bar.first].position;
      const Vector3 pull = system.bars.tension()[i] / between.norm() * between;
      all.push_back({bar.first, pull, text_of(scene, bar)});
      all.push_back({bar.second, -pull, text_of(scene, bar)});
    }
  for (const auto &element : system.forces)
    for (const auto &[body, force] : element->forces())
      all.push_back({body, force, element->name()});
  return all;
}

/// Which of the forces on a body explains that @p rest [N] is left over.
std::string
explanation(const std::vector<Reported> &forces, const unsigned int body, const Vector3 &rest)
{
  for (const Reported &reported : forces)
    if (reported.body == body)
      for (const double times : {1., 2.})
        if ((rest + times * reported.force).norm() < 1e-3 * reported.force.norm())
          return (times == 1. ? ", as if it did not get the force of the " :
                                ", as if it got the wrong sign of the force of the ") +
                 reported.by;
  return "";
}

/// The fastest node of @p copy relative to its body, and that speed [m/s].
std::pair<unsigned int, double>
fastest_node(const World &world, const unsigned int group, const unsigned int copy)
{
  const BodyBatches              &copies = world.copies[group];
  const unsigned int              body   = copies.bodies[copy];
  std::pair<unsigned int, double> fastest(0, -1.);
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    {
      const double speed =
          (NodeView(copies.velocity)[copies.index(copy, node)] - world.frames[body].velocity)
              .norm();
      if (speed > fastest.second)
        fastest = {node, speed};
    }
  return fastest;
}
} // namespace

double free_mass(const World &world, const unsigned int body)
{
  const World::Address &place = world.elastic_address[body];
  if (place.group != World::Address::none)
    return world.symmetry.whole(world.copies[place.group].mass);
  return world.inverse_mass[body] > 0. ? world.mass[body] : 0.;
}

std::string list_of(const std::vector<FaultSite> &places, const unsigned int n)
{
  std::string           text;
  std::set<std::string> named;
  for (const FaultSite &place : places)
    if (named.size() < n && named.insert(place.of.empty() ? place.text : place.of).second)
      text += (text.empty() ? "" : "; ") + place.text;
  return text.empty() ? "no place stands out" : text;
}

std::vector<FaultSite> faults_not_finite(const scene::Scene &scene, const System &system)
{
  const World           &world = system.world;
  std::vector<FaultSite> places;
  for_each_own_copy(world, [&](const unsigned int g, const unsigned int copy) {
    const BodyBatches        &copies = world.copies[g];
    std::vector<unsigned int> nodes;
    for (unsigned int node = 0; node < copies.n_nodes(); ++node)
      {
        const std::size_t at = copies.index(copy, node);
        if (!finite(NodeView(copies.velocity)[at]) || !finite(NodeView(copies.position)[at]))
          nodes.push_back(node);
      }
    if (!nodes.empty())
      places.push_back(
          {5.,
           text_of(scene, world, g, copy, nodes.front()) +
               (nodes.size() > 1 ? " and " + std::to_string(nodes.size() - 1) + " more" : "")});
  });
  if (world.is_first_rank())
    {
      // what has been added to a position was wrong a step before what is added to a velocity
      for (unsigned int b = 0; b < world.n_bodies(); ++b)
        if (world.elastic_address[b].group == World::Address::none)
          {
            if (!finite(value(world.displacement, b)))
              places.push_back({4., scene.name_of(b) + " (position)"});
            else if (!finite(value(world.velocity, b)))
              places.push_back({1., scene.name_of(b) + " (velocity)"});
          }
      for (const World::Rotation &rotation : world.rotations)
        if (!finite(rotation.momentum))
          places.push_back({4., scene.name_of(rotation.body) + " (spin)"});
      for (const World::Spin &spin : world.spins)
        if (!std::isfinite(spin.speed))
          places.push_back({4., scene.name_of(spin.body) + " (spin)"});
      for (const World::Hub &hub : world.hubs)
        if (!std::isfinite(hub.angle + hub.speed))
          places.push_back({4., scene.name_of(hub.body) + " (rotation)"});
      for_each_record(system, [&](const Family &family, const Record &record, unsigned int) {
        if (!std::isfinite(record.gap) || !finite(record.force))
          places.push_back({3., text_of(scene, family, record)});
      });
      for (unsigned int i = 0; i < system.bars.size(); ++i)
        if (!std::isfinite(system.bars.tension()[i]))
          places.push_back({2., text_of(scene, system.bars.bars()[i])});
    }
  return gather(places, world);
}

std::vector<FaultSite> faults_of_balance(const scene::Scene &scene,
                                         const System       &system,
                                         const LastStep     *last,
                                         const double        dt)
{
  const World           &world = system.world;
  std::vector<FaultSite> places;
  const double           drag = system.loads.drag(), gravity = system.loads.gravity();

  if (world.is_first_rank())
    {
      const std::vector<Reported> reported = reported_forces(scene, system);
      for (unsigned int b = 0; b < world.n_bodies(); ++b)
        {
          if (world.rim_of(b) != nullptr) // contact is with its rim, not with the body
            continue;
          Vector3 rest = value(world.force, b);
          double  size = rest.norm();
          for (const Reported &force : reported)
            if (force.body == b)
              {
                rest -= force.force;
                size += force.force.norm();
              }
          const double mass = free_mass(world, b);
          rest[1] += mass * gravity;
          rest += drag * mass * value(world.velocity, b);
          world.symmetry.cancel_across(rest);
          // drag belongs to half a step before
          if (rest.norm() > (1e-6 + drag * dt) * size)
            places.push_back({rest.norm(),
                              scene.name_of(b) + ": the force on it differs by " +
                                  text_of(rest, 1.) +
                                  " N from what contacts, bars and loads report" +
                                  explanation(reported, b, rest),
                              scene.name_of(b)});
        }
    }
  for_each_own_copy(world, [&](const unsigned int g, const unsigned int copy) {
    const BodyBatches &copies = world.copies[g];
    const unsigned int body   = copies.bodies[copy];
    if (last == nullptr || world.rim_of(body) != nullptr)
      return;
    const double mass = free_mass(world, body);
    Vector3      rest;
    double       size = 0.;
    for (unsigned int d = 0; d < world.symmetry.n_free_directions(); ++d)
      {
        const std::size_t i = 3 * body + d;
        const double change = mass * (world.velocity.local_element(i) - last->velocity[i]) / dt;
        const double mean   = 0.5 * (world.force.local_element(i) + last->force[i]);
        rest[d]             = change - mean;
        size += std::abs(change) + std::abs(mean) +
                1e-6 * mass * std::abs(world.velocity.local_element(i)) / dt;
      }
    if (rest.norm() > (1e-6 + drag * dt) * size)
      places.push_back({rest.norm(),
                        scene.name_of(body) + ": its momentum changes by " + text_of(rest, 1.) +
                            " N more than the forces on it; fastest is " +
                            text_of(scene, world, g, copy, fastest_node(world, g, copy).first),
                        scene.name_of(body)});
  });
  return gather(places, world);
}

std::vector<FaultSite> faults_of_penetration(const scene::Scene &scene, const System &system)
{
  const World           &world = system.world;
  std::vector<FaultSite> places;
  for_each_record(system, [&](const Family &family, const Record &record, const unsigned int i) {
    const auto node = family.deepest_node(i);
    if (!(record.gap < 0.) ||
        (family.is_distributed() ? !node.has_value() : !world.is_first_rank()))
      return;
    places.push_back({-record.gap / family.penetration_limit(),
                      text_of(scene, family, record) + " overlaps by " +
                          to_text(-record.gap * 1e3, 3) + " mm, where " +
                          to_text(family.penetration_limit() * 1e3, 3) + " mm is accepted" +
                          (node ? ", most at " + text_of(scene,
                                                         world,
                                                         world.node_address[record.slave].group,
                                                         world.node_address[record.slave].copy,
                                                         *node) :
                                  ""),
                      text_of(scene, family, record)});
  });
  return gather(places, world);
}

std::vector<FaultSite> extremes(const scene::Scene &scene, const System &system)
{
  const World           &world = system.world;
  std::vector<FaultSite> result, bodies, bars, contacts, nodes;
  if (world.is_first_rank())
    {
      for (unsigned int b = 0; b < world.n_bodies(); ++b)
        if (world.inverse_mass[b] > 0.)
          {
            const double a = world.inverse_mass[b] * value(world.force, b).norm();
            bodies.push_back(
                {a, scene.name_of(b) + " is accelerated by " + to_text(a, 3) + " m/s2"});
          }
      for (unsigned int i = 0; i < system.bars.size(); ++i)
        bars.push_back({std::abs(system.bars.tension()[i]),
                        text_of(scene, system.bars.bars()[i]) + " carries " +
                            to_text(system.bars.tension()[i], 3) + " N"});
      for_each_record(system, [&](const Family &family, const Record &record, unsigned int) {
        if (record.force.norm_square() > 0.)
          contacts.push_back({record.force.norm(),
                              text_of(scene, family, record) + " carries " +
                                  to_text(record.force.norm(), 3) + " N"});
      });
    }
  for_each_own_copy(world, [&](const unsigned int g, const unsigned int copy) {
    const auto [node, speed] = fastest_node(world, g, copy);
    nodes.push_back({speed,
                     text_of(scene, world, g, copy, node) + " moves with " + to_text(speed, 3) +
                         " m/s against its body"});
  });
  for (std::vector<FaultSite> *kind : {&nodes, &bodies, &bars, &contacts})
    {
      const std::vector<FaultSite> all = gather(*kind, world);
      if (!all.empty())
        result.push_back(all.front());
    }
  return result;
}
} // namespace chaindrive::dynamics
