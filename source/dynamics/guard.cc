// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/guard.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <string>

namespace chaindrive::dynamics
{
namespace
{
constexpr unsigned int interval = 16; // steps from one look to the next

constexpr double momentum_limit = 1e-7;
constexpr double jump_limit     = 2e-3;
constexpr double negative_limit = 2e-3;

struct Stats
{
  double momentum = 0., jump = 0., lost = 0., neg = 0., jump_t = 0., floor_share = 0.;
  double overlap = 0., jump_e = 0.;
  ~Stats()
  {
    if (getenv("GUARD_STATS"))
      std::cerr << "STATS momentum " << momentum << " jump/stored " << jump << " jump_turned "
                << jump_t << " jump_elastic " << jump_e << " lost " << lost << " neg " << neg
                << " overlap " << overlap << "\n";
  }
} stats;

const std::string smaller_step =
    "Most often the step is too large for what has happened: try a smaller Time/Step in us or "
    "Time/Safety factor.";
const std::string error_of_program =
    "No step, however small, mends this: it is an error in the program. Please report it with the "
    "parameter file.";

struct Line
{
  const char *name;
  double Ledger::*term;
  bool            stored;
};
constexpr Line lines[] = {{"kinetic energy", &Ledger::kinetic, true},
                          {"energy of bars", &Ledger::bar, true},
                          {"strain energy", &Ledger::strain, true},
                          {"hourglass energy", &Ledger::hourglass, true},
                          {"energy of contacts", &Ledger::contact, true},
                          {"friction loss", &Ledger::friction, false},
                          {"contact damping loss", &Ledger::contact_damping, false},
                          {"chain damping loss", &Ledger::chain_damping, false},
                          {"drag loss", &Ledger::drag, false}};
} // namespace

bool EnergyGuard::closes(const Ledger &ledger)
{
  const double imbalance = std::abs(ledger.imbalance());
  turned_over_           = std::max({turned_over_, std::abs(ledger.drive_work), ledger.stored()});
  largest_               = std::max(largest_, imbalance);
  return imbalance <= limit_ * turned_over_; // false when it is not a number
}

Guard::Guard(const scene::Scene &scene,
             const System       &system,
             const double        limit,
             const double        floor,
             const bool          on)
    : scene_(scene)
    , energy_(limit, floor)
    , floor_(10. * floor)
    , on_(on)
    , sound_until_(system.world.time)
    , start_time_(system.world.time)
    , before_(system.world.ledger)
{
  const World &world = system.world;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    mass_.push_back(free_mass(world, b));
  total_mass_ = std::accumulate(mass_.begin(), mass_.end(), 0.);
  looked_.fill(system.world.time);
  floor_ += 0.01 * total_mass_ * system.loads.gravity() * scene.pitch;
  start_momentum_ = momentum(world, largest_momentum_);
  start_moved_    = moved(world);
  hub_force_      = force_on_hubs(world);

  largest_momentum_ = std::max(largest_momentum_, std::sqrt(2. * total_mass_ * floor));
}

Guard::Vector3 Guard::momentum(const World &world, double &size) const
{
  Vector3       sum;
  double        sizes[3] = {};
  const double *v        = world.velocity.begin();
  for (const double mass : mass_)
    for (unsigned int d = 0; d < 3; ++d, ++v)
      {
        const double p = mass * *v;
        sum[d] += p;
        sizes[d] += std::abs(p);
      }
  for (const Rim &rim : world.rims)
    sum += rim.momentum;
  size = sizes[0] + sizes[1] + sizes[2];
  return sum;
}

Guard::Vector3 Guard::moved(const World &world) const
{
  Vector3 sum;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      sum[d] += mass_[b] * world.displacement.local_element(3 * b + d);
  return sum;
}

Guard::Vector3 Guard::force_on_hubs(const World &world)
{
  Vector3 sum;
  for (const World::Hub &hub : world.hubs)
    for (unsigned int d = 0; d < 3; ++d)
      sum[d] += world.force.local_element(3 * hub.body + d);
  return sum;
}

std::vector<Place> Guard::suspects(System &system, const LastStep *last, const double dt) const
{
  std::vector<Place> places = places_out_of_balance(scene_, system, last, dt);
  return places.empty() ? places_of_extremes(scene_, system) : places;
}

Guard::Finding Guard::ledger_does_not_close(System &system) const
{
  const double imbalance = system.world.ledger.imbalance();
  if (!std::isfinite(imbalance))
    return {"The energy balance is not a number", smaller_step, places_not_finite(scene_, system)};
  return {"The energy balance does not close: imbalance " + to_text(imbalance) + " J of " +
              to_text(energy_.turned_over()) + " J turned over, more than the accepted " +
              to_text(energy_.limit() * 100.) + " % (Time/Energy limit in percent)",
          smaller_step,
          suspects(system, nullptr, 0.)};
}

std::optional<Guard::Finding> Guard::look_at_momentum(System &system, const double dt)
{
  const World &world = system.world;
  double       size;
  Vector3      rest = momentum(world, size) - start_momentum_ + hub_impulse_;
  rest[1] += total_mass_ * system.loads.gravity() * (world.time - start_time_);
  if (system.loads.drag() > 0.)
    rest += system.loads.drag() * (moved(world) - start_moved_);
  if (world.whole != 1.) // the middle plane holds its nodes
    rest[2] = 0.;
  largest_momentum_  = std::max(largest_momentum_, size);
  stats.momentum     = std::max(stats.momentum, rest.norm() / largest_momentum_);
  const double limit = momentum_limit * largest_momentum_;
  if (rest.norm() <= limit)
    return {};
  return Finding{"Momentum of " + to_text(rest.norm(), 3) +
                     " N s comes from nowhere, more than the accepted " + to_text(limit, 3) +
                     " N s: a force acts without its reaction",
                 error_of_program,
                 suspects(system, &last_, dt)};
}

std::optional<Guard::Finding> Guard::look_at_energy(System &system, const double dt)
{
  const Ledger &now    = system.world.ledger;
  const double  scale  = std::max(floor_, now.stored());
  const double  gained = now.imbalance() - before_.imbalance(), lost = now.lost() - before_.lost();
  before_              = now;
  const double elastic = floor_ + now.bar + now.strain + now.hourglass + now.contact;
  stats.jump_e         = std::max(stats.jump_e, std::abs(gained) / elastic);
  if (getenv("GUARD_TRACE"))
    std::cerr << "gained " << gained << " lost " << lost << " stored " << now.stored() << " bar "
              << now.bar << " strain " << now.strain << " contact " << now.contact << " kinetic "
              << now.kinetic << " floor " << floor_ << " fr " << now.friction << " cd "
              << now.contact_damping << " ch " << now.chain_damping << "\n";
  stats.jump   = std::max(stats.jump, std::abs(gained) / scale);
  stats.jump_t = std::max(stats.jump_t, std::abs(gained) / energy_.turned_over());
  stats.lost   = std::max(stats.lost, -lost / scale);
  for (const Line &line : lines)
    stats.neg = std::max(stats.neg, -(now.*line.term) / scale);

  std::optional<Finding> finding;
  if (std::abs(gained) > jump_limit * scale)
    finding = {"The energy balance jumps by " + to_text(gained, 3) + " J in " +
                   std::to_string(interval) + " steps, more than the accepted " +
                   to_text(jump_limit * scale, 3) + " J",
               smaller_step,
               {}};
  else if (-lost > jump_limit * scale)
    finding = {"What has been lost falls by " + to_text(-lost, 3) + " J in " +
                   std::to_string(interval) + " steps, more than the accepted " +
                   to_text(jump_limit * scale, 3) + " J",
               error_of_program,
               {}};
  else
    for (const Line &line : lines)
      if (-(now.*line.term) > negative_limit * scale)
        finding = {std::string("The ") + line.name + " is " + to_text(now.*line.term, 3) +
                       " J: it must not be negative",
                   error_of_program,
                   {}};
  if (finding)
    finding->places = suspects(system, &last_, dt);
  return finding;
}

bool Guard::overlaps(const System &system) const
{
  for (const auto &family : system.contacts.families())
    {
      const double accepted = family->senseless_overlap();
      for (const contact::Record &record : family->records())
        if (stats.overlap = std::max(stats.overlap, -record.gap / accepted);
            - record.gap > accepted)
          return true;
    }
  return false;
}

std::optional<Guard::Finding> Guard::look(System &system, const double dt)
{
  // a fault takes up to 100 steps to be found: what was before that is sound
  sound_until_ = looked_.front();
  std::move(looked_.begin() + 1, looked_.end(), looked_.begin());
  looked_.back()                 = system.world.time;
  std::optional<Finding> finding = look_at_momentum(system, dt);
  if (!finding)
    finding = look_at_energy(system, dt);
  if (!finding && overlaps(system))
    system.world.alarm = 1.;
  return finding;
}

void Guard::check(System &system, const unsigned long step, const double dt)
{
  const World           &world = system.world;
  std::optional<Finding> finding;
  if (world.alarm > 0.)
    finding = {"Bodies run through each other",
               "Try a smaller step, or a stiffer contact.",
               places_that_overlap(scene_, system)};
  else if (!energy_.closes(world.ledger))
    finding = ledger_does_not_close(system);
  else if (on_)
    {
      const Vector3 before = hub_force_; // by the trapezoidal rule, as the bodies move
      hub_force_           = force_on_hubs(world);
      hub_impulse_ += 0.5 * dt * (before + hub_force_);
      if (++calls_ == interval)
        {
          calls_  = 0;
          finding = look(system, dt);
        }
      else if (calls_ + 1 == interval)
        {
          last_.velocity.assign(world.velocity.begin(), world.velocity.end());
          last_.force.assign(world.force.begin(), world.force.end());
        }
    }
  if (!finding || getenv("GUARD_STATS"))
    return;

  std::string where;
  for (std::size_t i = 0; i < std::min<std::size_t>(finding->places.size(), 4); ++i)
    where += (i == 0 ? "" : "; ") + finding->places[i].text;
  throw Fault(finding->what + ", at " + to_text(world.time * 1e3, 8) + " ms, step " +
                  std::to_string(step) +
                  ". Where: " + (where.empty() ? "no place stands out" : where) + ". " +
                  finding->hint + " Until " + to_text(sound_until_ * 1e3, 8) +
                  " ms nothing was wrong. Histories up to this moment are complete.",
              sound_until_);
}
} // namespace chaindrive::dynamics
