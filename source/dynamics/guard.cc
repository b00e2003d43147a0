// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/planar_bodies.h>
#include <chaindrive/dynamics/guard.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace chaindrive::dynamics
{
namespace
{
constexpr unsigned int interval = 16; // steps from one look to the next

// Largest momentum out of nowhere over the sum of the sizes of all momenta. Of all rigid models in
// prm/ the worst is 1.7e-12 (slow), of the first millisecond of full ones 1.5e-14, while 1 N
// without reaction is above the limit after a few steps.
constexpr double momentum_limit = 1e-8;

// Largest jump of the imbalance from one look to the next, and largest energy below zero, over the
// energy of springs, which is what a step that is too large and a force of wrong sign make: kinetic
// energy is much larger and closes by itself. Of all rigid models in prm/ the worst is 1.4e-3 (an
// impact), of the first millisecond of full ones 1e-4. See energy_jump_max in doc/output.md.
constexpr double energy_limit = 2e-2;

// Central differences are wrong by (w dt)^2 / 4 of the energy of a vibration, 7 % of that of the
// fastest at the automatic step of rigid models, all of it at the critical time step: what a body
// loses at most, or gets back, when a contact closes or opens between two steps. With x of a step
// v dt in the first one it gives up m v w^2 x dt / 2 and stores k x^2 / 2; k x (v dt - x) / 2 is
// missing, at most k v^2 dt^2 / 8. That much is accepted as a jump of rigid models, whose springs
// may have hardly any other energy; an unstable mode gains more than its strain energy, which is
// then most there is. Of the chain's energy at full speed start_by_step is what counts as turned
// over at least, since the first impacts are all vibration. The simple drives of hard.py at 0.5 to
// 0.9 of the critical time step come to half of it, the worn reduced one without penalty, whose
// slack span is jerked taut, to a sixtieth.
constexpr double start_by_step = 0.2;

// Length [m] whose energies are not judged: round-off of positions, 1e-16 m, does not get there.
constexpr double no_length = 1e-10;

const std::string smaller_step =
    "Most often the step is too large for what has happened: try a smaller Time/Time step in us or "
    "Time/Safety factor. If that does not help, please report it with the parameter file.";
/// @p entries: those that may get round it.
std::string error_of_program(const std::string &entries)
{
  return "No step, however small, mends this: it is an error in the program. Please report it with "
         "the parameter file. Until then, what may get round it: " +
         entries + ".";
}

struct Line
{
  const char *name;
  double Ledger::*term;
  const char     *entry; ///< that decides on it
};
constexpr Line lines[] = {
    {"kinetic energy", &Ledger::kinetic, "Time/Time step in us"},
    {"energy of bars", &Ledger::bar, "Model/Stiffness per pitch in N/m"},
    {"strain energy", &Ledger::strain, "Elements/Formulation"},
    {"hourglass energy", &Ledger::hourglass, "Elements/Hourglass coefficient"},
    {"energy of contacts", &Ledger::contact, "Contact/Tangential ratio or Effects/Friction"},
    {"friction loss", &Ledger::friction, "Effects/Friction"},
    {"contact damping loss", &Ledger::contact_damping, "Effects/Contact damping"},
    {"chain damping loss", &Ledger::chain_damping, "Effects/Chain damping"},
    {"drag loss", &Ledger::drag, "Effects/Drag"},
    {"energy of springs", &Ledger::spring, "Time/Time step in us"},
    {"loss of dampers", &Ledger::spring_damping, "Time/Time step in us"}};
} // namespace

bool EnergyGuard::closes(const Ledger &ledger, const double floor)
{
  double sum =
      std::abs(ledger.initial) + std::abs(ledger.drive_work) + std::abs(ledger.resisting_work);
  for (double Ledger::*term : Ledger::added)
    sum += std::abs(ledger.*term);
  turned_over_           = std::max({turned_over_, floor, 0.5 * sum});
  const double imbalance = std::abs(ledger.imbalance());
  largest_               = std::max(largest_, imbalance);
  return imbalance <= limit_ * turned_over_; // false when it is not a number
}

namespace
{
/// Energy that is nearly round-off: of a pitch's spring for each link, J.
double energy_of_nothing(const scene::Scene &scene)
{
  return 0.5 * scene.n_strands() * scene.drive.n_joints * scene.drive.stiffness_per_pitch *
         no_length * no_length;
}

/// Whether the critical time step is that of the smallest cells of meshes, whose vibrations impacts
/// hardly reach.
bool has_nodes(const scene::Scene &scene)
{
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const scene::Body &body) {
    return body.motion == scene::Motion::elastic;
  });
}

/// The least radial room of a bush in its roller, m.
double room_of_bushes(const scene::Scene &scene)
{
  double room = std::numeric_limits<double>::infinity();
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.interface == scene::Interface::roller_bush)
      for (const scene::BorePair &pair : bores.pairs)
        room = std::min(room, pair.radius - pair.slave.radius);
  return room;
}

/// Rollers that are too oval for contacts at one place each.
struct TooOval
{
  std::string            what; ///< in the middle of a sentence
  std::vector<FaultSite> places;
};

/// Those whose oval, a cos 2x, has an a of more than the room of their bushes over @p part.
std::optional<TooOval>
too_oval(const scene::Scene &scene, const World &world, Services &services, const double part)
{
  const double room  = room_of_bushes(scene);
  const double limit = room / part;

  const PlanarSlots   slots   = world.planar->slots();
  const double *const cosines = slots.of(planar_ring), *const sines = slots.of(planar_ring + 1);
  double most = 0.;
  for (unsigned int slot = 0; slot < slots.n_slots; ++slot)
    most = std::max(most, cosines[slot] * cosines[slot] + sines[slot] * sines[slot]);
  if (!(most > limit * limit))
    return {};

  services.update_bodies();
  TooOval result{"a roller has become an oval whose outside moves by " +
                     to_text(1e6 * std::sqrt(most), 3) + " um, more than the " +
                     to_text(1e6 * limit, 3) + " um up to which its bush, with a clearance of " +
                     to_text(1e6 * room, 3) + " um, touches it at one place",
                 {}};
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (const unsigned int slot = world.planar->slot_of(b); slot != PlanarBodies::none)
      if (const double size = world.planar->oval_of(slot).norm(); size > limit)
        result.places.push_back({size, scene.name_of(b) + " (" + to_text(1e6 * size, 3) + " um)"});
  std::sort(result.places.begin(),
            result.places.end(),
            [](const FaultSite &one, const FaultSite &other) { return one.size > other.size; });
  return result;
}

/// A bush at the angle x from its axis to the roller's touches the bore of an oval, which moves
/// outwards by bore a cos 2x, where the axes are d = room + bore a cos 2x apart. It is pushed
/// sideways by 2 a sin 2x / d times the normal force. The kernels let that be 1 at most, beyond
/// there is a second place of contact, and energy is not kept: at all x it is less where a sqrt(4 +
/// bore^2) < room.
double part_of_one_place(const drive::RollerRing &ring)
{
  return std::sqrt(4. + ring.bore * ring.bore);
}

const std::string round_rollers =
    "No step, however small, mends this: the load is too large for such rollers. Take "
    "Effects/Oval rollers = off, or Model/Fidelity = reduced, whose rollers deform everywhere; if "
    "it is the start that pulls so, a longer Loads/Ramp time in ms.";
} // namespace

Guard::Guard(const scene::Scene &scene,
             const System       &system,
             const double        limit,
             const double        critical_time_step,
             const bool          on,
             std::string         overload)
    : scene_(scene)
    , energy_(limit)
    , critical_time_step_(has_nodes(scene) ? std::numeric_limits<double>::infinity() :
                                             critical_time_step)
    , on_(on)
    , overload_(std::move(overload))
    , valid_until_(system.world.time)
    , start_time_(system.world.time)
    , before_(system.world.ledger)
{
  const World &world = system.world;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    mass_.push_back(free_mass(world, b));
  total_mass_                    = std::accumulate(mass_.begin(), mass_.end(), 0.);
  const double weight_over_pitch = total_mass_ * system.loads.gravity() * scene.drive.pitch;
  least_energy_ =
      1e-3 * (std::max(scene.nominal_energy(), world.ledger.initial) + weight_over_pitch) +
      energy_of_nothing(scene);
  looked_.fill(system.world.time);
  start_momentum_ = momentum(world, largest_momentum_);
  start_moved_    = moved(world);
  hub_force_      = force_on_hubs(world);

  largest_momentum_ = std::max(largest_momentum_, std::sqrt(2. * total_mass_ * least_energy_));
}

void Guard::serialize(const Archive &archive, const System &)
{
  energy_.serialize(archive / "energy");
  archive("calls", calls_);
  archive("valid until", valid_until_);
  archive("looked", looked_);
  archive("momentum at the start", start_momentum_);
  archive("moved at the start", start_moved_);
  archive("largest momentum", largest_momentum_);
  archive("largest error", largest_error_);
  archive("largest jump", largest_jump_);
  archive("force on hubs", hub_force_);
  archive("impulse on hubs", hub_impulse_);
  archive("ledger", before_);
  archive("last velocities", last_.velocity);
  archive("last forces", last_.force);
}

Guard::Vector3 Guard::momentum(const World &world, double &size) const
{
  Vector3 sum;
  double  sizes[3] = {};
  if (world.planar != nullptr) // all that moves freely, whose velocities World may not have yet
    {
      for (unsigned int b = 0; b < world.n_bodies(); ++b)
        if (const unsigned int slot = world.planar->slot_of(b); slot != PlanarBodies::none)
          for (unsigned int d = 0; d < 2; ++d)
            {
              const double p = mass_[b] * world.planar->velocity(slot)[d];
              sum[d] += p;
              sizes[d] += std::abs(p);
            }
      size = sizes[0] + sizes[1] + sizes[2];
      return sum;
    }
  const double *v = world.velocity.begin();
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

void Guard::remember(const World &world)
{
  last_.velocity.assign(world.velocity.begin(), world.velocity.end());
  last_.force.assign(world.force.begin(), world.force.end());
}

Guard::Vector3 Guard::force_on_hubs(const World &world)
{
  Vector3 sum;
  for (const World::Hub &hub : world.hubs)
    if (!hub.slides) // what acts there are its spring and its weight
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += world.force.local_element(3 * hub.body + d);
  return sum;
}

std::vector<FaultSite> Guard::suspects(const System   &system,
                                       const LastStep *last,
                                       const double    dt,
                                       Services       &services) const
{
  services.update_bodies();
  services.gather_records();
  std::vector<FaultSite> places = faults_of_balance(scene_, system, last, dt);
  return places.empty() ? extremes(scene_, system) : places;
}

Guard::Finding Guard::ledger_does_not_close(const System &system, Services &services) const
{
  const double imbalance = system.world.ledger.imbalance();
  if (!std::isfinite(imbalance))
    {
      services.update_bodies();
      services.gather_records();
      return {
          "The energy balance is not a number", smaller_step, faults_not_finite(scene_, system)};
    }
  return {"The energy balance does not close: imbalance " + to_text(imbalance) + " J of " +
              to_text(energy_.turned_over()) + " J turned over, more than the accepted " +
              to_text(energy_.limit() * 100.) + " % (Time/Energy limit in percent)",
          smaller_step,
          suspects(system, nullptr, 0., services)};
}

std::optional<Guard::Finding>
Guard::look_at_momentum(const System &system, const double dt, Services &services)
{
  const World &world = system.world;
  double       size;
  Vector3      rest = momentum(world, size) - start_momentum_ + hub_impulse_;
  rest[1] += total_mass_ * system.loads.gravity() * (world.time - start_time_);
  if (system.loads.drag() > 0.)
    rest += system.loads.drag() * (moved(world) - start_moved_);
  if (world.symmetry.is_active() || !scene_.plates_bend) // nodes are held across the chain
    rest[2] = 0.;
  largest_momentum_ = std::max(largest_momentum_, size);
  largest_error_    = std::max(largest_error_, rest.norm() / largest_momentum_);
  // elastic bodies feel the drag of half a step before
  const double limit = (momentum_limit + system.loads.drag() * dt) * largest_momentum_;
  if (rest.norm() <= limit)
    return {};
  return Finding{
      "Momentum of " + to_text(rest.norm(), 3) +
          " N s comes from nowhere, more than the accepted " + to_text(limit, 3) +
          " N s: a force acts without its reaction",
      error_of_program("Time/Guard = false, which looks at nothing but the energy balance"),
      suspects(system, &last_, dt, services)};
}

double Guard::smallest_turned_over(const double dt) const
{
  return std::max(least_energy_, start_by_step * error_of_step(dt) * scene_.nominal_energy());
}

double Guard::error_of_step(const double dt) const
{
  const double part = dt / critical_time_step_;
  return part <= 1. ? part * part : 0.; // larger ones are not accepted: nothing excuses them
}

std::optional<Guard::Finding>
Guard::look_at_energy(const System &system, const double dt, Services &services)
{
  const Ledger &now     = system.world.ledger;
  const double  springs = std::max(10. * least_energy_, smallest_turned_over(dt)) + now.bar +
                         now.strain + now.hourglass + now.contact;
  const double accepted = energy_limit * springs;
  const double gained = now.imbalance() - before_.imbalance(), lost = now.lost() - before_.lost();
  before_ = now;

  double worst = std::max(std::abs(gained), -lost);
  for (const Line &line : lines)
    worst = std::max(worst, -(now.*line.term));
  largest_jump_ = std::max(largest_jump_, worst / springs);

  std::optional<Finding> finding;
  const double           excused = scene_.has_elastic_bodies() ? 0. : error_of_step(dt);
  if (const double most = std::max(energy_limit, excused) * springs; std::abs(gained) > most)
    finding = {"The energy balance jumps by " + to_text(gained, 3) + " J in " +
                   std::to_string(interval) + " steps, more than the accepted " + to_text(most, 3) +
                   " J",
               smaller_step,
               {}};
  else if (-lost > accepted)
    finding = {"What has been lost falls by " + to_text(-lost, 3) + " J in " +
                   std::to_string(interval) + " steps, more than the accepted " +
                   to_text(accepted, 3) + " J",
               error_of_program("Effects/Friction, Contact damping, Chain damping or Drag = off"),
               {}};
  else
    for (const Line &line : lines)
      if (-(now.*line.term) > accepted)
        finding = {std::string("The ") + line.name + " is " + to_text(now.*line.term, 3) +
                       " J: it must not be negative",
                   error_of_program(line.entry),
                   {}};
  if (finding)
    finding->places = suspects(system, &last_, dt, services);
  return finding;
}

bool Guard::overlaps(const System &system) const
{
  for (const auto &family : system.contacts.families())
    if (family->deepest() > family->penetration_limit())
      return true;
  return false;
}

std::optional<Guard::Finding>
Guard::update(const System &system, const double dt, Services &services)
{
  // a fault takes up to 100 steps to be found: what was before that is valid
  valid_until_ = looked_.front();
  std::move(looked_.begin() + 1, looked_.end(), looked_.begin());
  looked_.back()                 = system.world.time;
  std::optional<Finding> finding = look_at_momentum(system, dt, services);
  if (!finding)
    finding = look_at_energy(system, dt, services);
  if (!finding && overlaps(system))
    services.ask(Request::alarm);
  return finding;
}

void Guard::observe(const System       &system,
                    const unsigned long step,
                    const double        dt,
                    Services           &services)
{
  if (step == 0)
    return; // what the start is like the constructor has seen
  const World           &world = system.world;
  std::optional<Finding> finding;
  if (services.asked(Request::alarm))
    {
      services.update_bodies();
      services.gather_records();
      finding = {
          "Bodies run through each other",
          "Try a smaller Time/Time step in us, or a stiffer contact: Contact/Roller-tooth "
          "stiffness in N/m, Roller-bush stiffness in N/m, of elastic bodies Penalty factor" +
              std::string(scene_.guides.empty() ?
                              "." :
                              ", of a guide its Stiffness in N/m in Drive/Wheels/.../Guide."),
          faults_of_penetration(scene_, system)};
    }
  else if (!energy_.closes(world.ledger, smallest_turned_over(dt)))
    finding = ledger_does_not_close(system, services);
  else if (on_)
    {
      const Vector3 before = hub_force_; // by the trapezoidal rule, as the bodies move
      hub_force_           = force_on_hubs(world);
      hub_impulse_ += 0.5 * dt * (before + hub_force_);
      if (++calls_ == interval)
        {
          calls_ = 0;
          if (world.planar == nullptr || system.loads.drag() > 0.) // look_at_momentum()
            services.update_bodies();
          finding = update(system, dt, services);
        }
      else if (calls_ + 1 == interval && world.has_elastic_bodies())
        {
          services.update_bodies();
          remember(world);
        }
    }
  if (world.planar != nullptr && world.planar->oval())
    {
      // the bush of a roller that is narrower than its bush touches both sides: nothing is right
      const drive::RollerRing &ring = *world.planar->oval();
      if (finding)
        {
          if (auto rollers = too_oval(scene_, world, services, part_of_one_place(ring)))
            finding = {finding->what + ": " + rollers->what, round_rollers, rollers->places};
        }
      else if (on_ && calls_ == 0)
        if (auto rollers = too_oval(scene_, world, services, ring.bore))
          finding = {"Two sides of a roller press on its bush: " + rollers->what,
                     round_rollers,
                     rollers->places};
    }
  if (!finding)
    return;

  throw Fault(
      finding->what + ", at " + to_text(world.time * 1e3, 8) + " ms, step " + std::to_string(step) +
          ". Where: " + list_of(finding->places, 4) + ". " +
          (overload_.empty() ? finding->hint : overload_ + " If that is meant: " + finding->hint) +
          " Until " + to_text(valid_until_ * 1e3, 8) + " ms nothing was wrong.",
      valid_until_);
}
} // namespace chaindrive::dynamics
