// SPDX-License-Identifier: LGPL-2.1-or-later
// Groups of bodies that chaindrive does not have, made here and nowhere else. The first is a mass
// on a spring inside a lump: it must be called in the order that dynamics/system.cc says, vibrate
// with w^2 = k (1/m + 1/M), keep the momentum, close the ledger to second order, and go through a
// checkpoint without a bit changed. The second has no capability but to place and gather nodes that
// touch. Each is listed under what it implements, and under nothing else. Classes that lack what
// their groups need are refused.
#include "../support/scenes.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/bodies/reduced_bodies.h>

#include <map>
#include <memory>
#include <string>

using namespace test;

const double inner = 2e-3, outer = 5e-3, k = 1e6, w = std::sqrt(k * (1. / inner + 1. / outer));

class InnerMass : public BodyGroup, public ForceGroup
{
public:
  void kick(World &, const double h) override
  {
    calls += "kick ";
    speed += h * force / inner;
  }
  void drift(World &, const Step &step) override
  {
    calls += "drift ";
    position += step.dt * speed;
  }
  void add_forces(World &world, const ForceTimer &) override
  {
    calls += "add_forces ";
    force = k * (world.frames[0].position[0] - position);
    world.force.local_element(0) -= force;
    world.ledger.strain += 0.5 * force * force / k;
  }
  void   finish(World &, const Step &) override { calls += "finish "; }
  double kinetic_energy(const World &) const override { return 0.5 * inner * speed * speed; }
  void   serialize(const Archive &archive, World &) override
  {
    archive("position", position);
    archive("speed", speed);
    archive("force", force);
  }

  double      position = 1e-6, speed = 0., force = 0.;
  std::string calls;
};

class Skin : public BodyGroup, public SurfaceGroup
{
public:
  explicit Skin(std::string &to) : calls(to) {}

  void place_surface(World &, double) override { calls += "place "; }
  void gather_forces(World &) override { calls += "gather "; }

  std::string &calls;
};

class Loud : public InnerMass, public SurfaceGroup
{
  void place_surface(World &, double) override {}
  void gather_forces(World &) override {}
};

// Classes that would compile as groups, and whose bodies would stand still or never touch.
class Idle : public BodyGroup // does nothing
{
  double kinetic_energy(const World &) const override { return 1.; }
};
class Unmoved : public ElasticGroup // by nodes or by modes?
{
};
class Untouched : public ModalGroup // who places its nodes?
{
};
class Alone : public ForceGroup // is no group
{
};
template <typename Group>
constexpr bool keeps_all_rules()
{
  using Rules = GroupRules<Group>;
  return Rules::is_complete && Rules::moves_one_way && Rules::places_its_nodes &&
         Rules::does_something;
}

struct Case
{
  Case() : system(scene(), false)
  {
    group = &system.world.groups.add(std::make_unique<InnerMass>());
    system.evaluate_forces(0.);
    system.world.ledger.initial = system.world.ledger.stored();
    group->calls.clear();
  }

  static scene::Scene scene()
  {
    scene::Scene scene = empty_scene();
    scene.bodies       = {lump(outer, Vector3())};
    return scene;
  }

  double momentum() const
  {
    return inner * group->speed + outer * system.world.frames[0].velocity[0];
  }

  dynamics::System system;
  InnerMass       *group;
};

void list_capabilities()
{
  Case              c;
  const BodyGroups &groups = c.system.world.groups;
  std::string       calls;
  c.system.world.groups.add(std::make_unique<Skin>(calls));
  std::cout << "groups " << groups.all().size() << ": force " << groups.force().size()
            << ", surface " << groups.surface().size() << ", elastic " << groups.elastic().size()
            << ", nodal " << groups.nodal().size() << ", modal " << groups.modal().size() << '\n';
  c.system.world.place_surfaces(0.);
  c.system.world.gather_forces();
  std::cout << "calls of the second one: " << calls.substr(0, calls.size() - 1) << '\n';
}

void refuse_incomplete_classes()
{
  verdict("classes that do what they should are groups",
          keeps_all_rules<InnerMass>() && keeps_all_rules<Skin>() &&
              keeps_all_rules<ReducedBodies>());
  verdict("one that does nothing is none", !GroupRules<Idle>::does_something);
  verdict("nor is a class that is known by its base alone",
          !GroupRules<BodyGroup>::is_complete && !GroupRules<NodalGroup>::is_complete);
  verdict("nor one without a motion", !GroupRules<Unmoved>::moves_one_way);
  verdict("nor one with modes whose nodes nobody places", !GroupRules<Untouched>::places_its_nodes);
  verdict("nor a capability by itself", !GroupRules<Alone>::is_complete);
  World                      world   = make_world(Case::scene(), MPI_COMM_SELF);
  std::unique_ptr<InnerMass> derived = std::make_unique<Loud>();
  try
    {
      world.groups.add(std::move(derived));
      verdict("nor a class behind a pointer to its base", false);
    }
  catch (const dealii::ExceptionBase &)
    {
      verdict("nor a class behind a pointer to its base", true);
    }
}

int main()
{
  list_capabilities();
  refuse_incomplete_classes();
  double before = 0.;
  for (const unsigned int n : {100, 200})
    {
      Case         c;
      const double dt = 2. * dealii::numbers::PI / w / n, energy = c.system.world.ledger.initial;
      double       imbalance = 0., momentum = 0.;
      advance(c.system, 10 * n, dt, [&]() {
        imbalance = std::max(imbalance, std::abs(c.system.world.ledger.imbalance()) / energy);
        momentum  = std::max(momentum, std::abs(c.momentum()));
      });
      if (n == 100)
        std::cout << "the first step: "
                  << c.group->calls.substr(
                         0, std::min<std::size_t>(c.group->calls.find("kick drift", 12), 100))
                  << "...\n";
      else
        ratio("ten periods later it is where it was", c.group->position, 1e-6, 3);
      verdict("momentum is kept to 1e-12", momentum < 1e-12 * inner * w * 1e-6);
      if (before > 0.)
        std::cout << "order of the imbalance " << std::setprecision(2)
                  << std::log2(before / imbalance) << '\n';
      before = imbalance;
    }

  std::map<std::string, Archive::Bytes> items;
  Case                                  first, second;
  const double                          dt = 0.05 / w;
  advance(first.system, 30, dt, []() {});
  first.system.serialize(
      Archive([&items](const std::string &name, const char *bytes, const std::size_t size) {
        items.emplace(name, Archive::Bytes(bytes, bytes + size));
      }));
  second.system.serialize(Archive([&items](const std::string &name) {
    const auto found = items.find(name);
    return found == items.end() ? std::nullopt : std::make_optional(found->second);
  }));
  for (Case *c : {&first, &second})
    advance(c->system, 30, dt, []() {});
  verdict("it goes on from a checkpoint bit by bit",
          first.group->position == second.group->position &&
              first.group->speed == second.group->speed &&
              first.system.world.frames[0].position[0] ==
                  second.system.world.frames[0].position[0]);
}
