// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/directory.h>
#include <chaindrive/observe/recorder.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

// What is recorded: every dataset of histories.h5, its unit and where its numbers come from.

namespace chaindrive::observe
{
namespace
{
using Row = dealii::ArrayView<double>;

std::vector<std::string> numbers(const unsigned int n)
{
  std::vector<std::string> labels;
  for (unsigned int i = 0; i < n; ++i)
    labels.push_back(std::to_string(i));
  return labels;
}

/// The smallest gap of each joint's points; not a number where none is within reach.
template <typename FamilyType>
void copy_gaps(const std::vector<const FamilyType *> &families, Row row)
{
  for (const FamilyType *family : families)
    for (const contact::Record &record : family->records())
      if (record.gap < std::numeric_limits<double>::max())
        row[record.joint] =
            std::fmin(row[record.joint], record.gap); // ignores the NaN it starts with
}

void copy(const std::vector<double> &from, Row row)
{
  std::copy(from.begin(), from.end(), row.begin());
}
} // namespace

void Recorder::add(const files::Channel &channel, Fill fill)
{
  AssertThrow(files::is_history_group(channel.group),
              dealii::ExcMessage("Histories of '" + channel.group + "' would never be removed"));
  if (histories_ != nullptr)
    sources_.push_back({histories_->add(channel), std::move(fill)});
}

void Recorder::add_channels()
{
  add_hub_channels();
  add_roller_channels();
  add_link_channels();
  add_tooth_channels();
  add_energy_channels();
  if (elastic_ != nullptr)
    add_elastic_channels();
}

void Recorder::add_hub_channels()
{
  for (const scene::Sprocket &sprocket : scene_.sprockets)
    {
      const std::string  name = sprocket.name();
      const unsigned int body = sprocket.body;
      const auto         hub  = [body](const dynamics::System &s) -> const World::Hub          &{
        return *std::find_if(s.world.hubs.begin(), s.world.hubs.end(), [body](const World::Hub &h) {
          return h.body == body;
        });
      };
      const int sense = scene_.sense;
      add({"hubs",
           name + "_angle",
           "rad",
           "Rotation since the start, positive in the sense of the drive"},
          [hub, sense](const auto &s, Row row) { row[0] = sense * hub(s).angle; });
      add({"hubs", name + "_speed", "rad/s", "Angular velocity in the sense of the drive"},
          [hub, sense](const auto &s, Row row) { row[0] = sense * hub(s).speed; });
    }
  add({"hubs",
       "driver_torque",
       "N m",
       "Torque that the drive supplies, the driver's own inertia excluded"},
      [](const auto &s, Row row) { row[0] = s.loads.driver_torque(); });
  add({"hubs", "load_torque", "N m", "Torque of the load against the driven hub"},
      [](const auto &s, Row row) { row[0] = s.loads.load_torque(); });
}

void Recorder::add_roller_channels()
{
  std::vector<std::string> labels;
  for (const unsigned int k : rollers_)
    labels.push_back(std::to_string(k));
  const unsigned int n = static_cast<unsigned int>(rollers_.size());

  for (const unsigned int d : {0U, 1U})
    {
      const std::string axis = d == 0 ? "x" : "y";
      // rollers are the bodies 0 ... N-1 in joint order
      add({"rollers", "position_" + axis, "m", "Centre of mass", n, labels},
          [this, d](const auto &s, Row row) {
            for (unsigned int i = 0; i < rollers_.size(); ++i)
              row[i] = s.world.frames[rollers_[i]].position[d];
          });
      add({"rollers", "velocity_" + axis, "m/s", "Of the centre of mass", n, labels},
          [this, d](const auto &s, Row row) {
            for (unsigned int i = 0; i < rollers_.size(); ++i)
              row[i] = s.world.frames[rollers_[i]].velocity[d];
          });
      add({"rollers", "acceleration_" + axis, "m/s2", "Of the centre of mass", n, labels},
          [this, d](const auto &, Row row) {
            for (unsigned int i = 0; i < rollers_.size(); ++i)
              row[i] = acceleration_[3 * rollers_[i] + d];
          });
    }
  if (std::all_of(rollers_.begin(), rollers_.end(), [this](const unsigned int k) {
        return scene_.bodies[k].motion == scene::Motion::rigid || scene_.bodies[k].inertia[2] > 0.;
      }))
    add({"rollers", "spin", "rad/s", "Angular velocity, counter-clockwise positive", n, labels},
        [this](const auto &s, Row row) {
          for (unsigned int i = 0; i < rollers_.size(); ++i)
            row[i] = s.world.frames[rollers_[i]].angular_velocity[2];
        });
}

void Recorder::add_link_channels()
{
  const unsigned int n = scene_.n_joints;
  add({"links",
       "tension",
       "N",
       "Tension of the bar or link from joint k to joint k+1",
       n,
       numbers(n)},
      [this](const auto &, Row row) { copy(spans_.link_tension(), row); });
  add({"links", "tension_peak", "N", "Largest tension since the last sample", n, numbers(n)},
      [this](const auto &, Row row) { copy(link_peak_, row); });
  add({"spans", "tight_tension", "N", "Mean tension of the links in the middle of the tight span"},
      [this](const auto &, Row row) { row[0] = spans_.tight_tension; });
  add({"spans", "slack_tension", "N", "Mean tension of the links in the middle of the slack span"},
      [this](const auto &, Row row) { row[0] = spans_.slack_tension; });
  add({"spans", "tight_speed", "m/s", "Mean velocity of the tight span along itself"},
      [this](const auto &, Row row) { row[0] = spans_.tight_speed; });
  add({"spans",
       "tight_offset",
       "m",
       "Mean distance of the tight span's middle from the driver's axis along the span normal"},
      [this](const auto &, Row row) { row[0] = spans_.tight_offset; });
  add({"spans",
       "slack_offset",
       "m",
       "The same of the slack span, along its own normal and towards the tight span"},
      [this](const auto &, Row row) { row[0] = spans_.slack_offset; });
}

void Recorder::add_tooth_channels()
{
  const unsigned int n = scene_.n_joints;
  for (unsigned int t = 0; t < teeth_.size(); ++t)
    {
      const std::string &name = teeth_[t].name;
      add({"rollers",
           name + "_force",
           "N",
           "Normal force of the " + name + "'s teeth on the roller",
           n,
           numbers(n)},
          [this, t](const auto &, Row row) { copy(teeth_[t].roller, row); });
      add({"rollers",
           name + "_force_peak",
           "N",
           "Its largest value since the last sample",
           n,
           numbers(n)},
          [this, t](const auto &, Row row) { copy(teeth_[t].roller_peak, row); });
      add({"rollers",
           name + "_gap",
           "m",
           "Gap to the " + name + "'s teeth, negative: overlap; NaN out of reach",
           n,
           numbers(n)},
          [this, t](const auto &, Row row) { copy_gaps(teeth_[t].families, row); });
      const unsigned int gaps = static_cast<unsigned int>(teeth_[t].in_gap.size());
      add({"teeth",
           name + "_force",
           "N",
           "Normal force in each gap between two teeth",
           gaps,
           numbers(gaps)},
          [this, t](const auto &, Row row) { copy(teeth_[t].in_gap, row); });
      add({"teeth",
           name + "_force_peak",
           "N",
           "Its largest value since the last sample",
           gaps,
           numbers(gaps)},
          [this, t](const auto &, Row row) { copy(teeth_[t].in_gap_peak, row); });
    }
  for (unsigned int b = 0; b < bores_.size(); ++b)
    {
      std::string name = bores_[b].name;
      std::replace(name.begin(), name.end(), '-', '_');
      add({"joints", name + "_force", "N", "Normal force in the joint", n, numbers(n)},
          [this, b](const auto &, Row row) { copy(bores_[b].joint, row); });
      add({"joints",
           name + "_force_peak",
           "N",
           "Its largest value since the last sample",
           n,
           numbers(n)},
          [this, b](const auto &, Row row) { copy(bores_[b].peak, row); });
      add({"joints",
           name + "_gap",
           "m",
           "Smallest gap in the joint, negative: overlap",
           n,
           numbers(n)},
          [this, b](const auto &, Row row) { copy_gaps(bores_[b].families, row); });
    }
}

void Recorder::add_energy_channels()
{
  const auto term =
      [this](const std::string &name, const std::string &description, double Ledger::*member) {
        add({"energy", name, "J", description},
            [member](const auto &s, Row row) { row[0] = s.world.ledger.*member; });
      };
  term("kinetic", "Of all bodies but the prescribed hub", &Ledger::kinetic);
  if (scene::is_on(scene_.effects, "gravity"))
    term("potential", "Of gravity, zero at the start", &Ledger::potential);
  if (scene::is_on(scene_.effects, "chain bars"))
    term("bar", "Strain energy of the bars", &Ledger::bar);
  if (scene::is_on(scene_.effects, "elastic bodies"))
    {
      term("strain", "Strain energy of elastic bodies", &Ledger::strain);
      term("hourglass",
           "In the hourglass stiffness of elastic bodies; physical bending for the enhanced "
           "elements",
           &Ledger::hourglass);
    }
  term("contact", "Stored in the contact springs", &Ledger::contact);
  if (scene::is_on(scene_.effects, "friction"))
    term("friction_loss", "Lost by friction since the start", &Ledger::friction);
  if (scene::is_on(scene_.effects, "contact damping"))
    term("contact_damping_loss",
         "Lost by contact damping since the start",
         &Ledger::contact_damping);
  if (scene::is_on(scene_.effects, "chain damping"))
    term(
        "chain_damping_loss", "Lost in the bars' dashpots since the start", &Ledger::chain_damping);
  if (scene::is_on(scene_.effects, "drag"))
    term("drag_loss", "Lost by drag since the start", &Ledger::drag);
  term("drive_work", "Of the driver on the chain since the start", &Ledger::drive_work);
  term("resisting_work", "Against the load torque since the start", &Ledger::resisting_work);
  add({"energy", "imbalance", "J", "Stored and lost less supplied: the error of the balance"},
      [](const auto &s, Row row) { row[0] = s.world.ledger.imbalance(); });
}
} // namespace chaindrive::observe
