// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/observation.h>
#include <chaindrive/utilities/message_tags.h>

#include <algorithm>
#include <numeric>

namespace chaindrive::observe
{
Observation::Observation(const scene::Scene     &scene,
                         const model::Model     &model,
                         const dynamics::System &system,
                         const unsigned int      pitches_per_period)
    : scene(scene)
    , model(model)
    , system(system)
    , rollers(model.output.rollers)
    , spans_(scene, system)
    , window_(scene, model, pitches_per_period)
    , tooth_periods_(window_.start(), window_.end())
{
  const auto &hubs = system.world.hubs;
  const auto  driver =
      std::find_if(hubs.begin(), hubs.end(), [](const World::Hub &hub) { return hub.prescribed; });
  if (driver != hubs.end() && !scene.drive.sprockets.empty())
    {
      driver_ = &*driver;
      teeth_  = scene.drive.driver().sense * double(scene.drive.driver().teeth);
    }
  if (rollers.empty())
    {
      rollers.resize(scene.drive.n_joints);
      std::iota(rollers.begin(), rollers.end(), 0U);
    }
  for (const unsigned int joint : rollers)
    roller_bodies.push_back(scene.drive.rollers[joint]);
}

void Observation::next(const double dt, dynamics::Services *services)
{
  dt_          = dt;
  services_    = services;
  spans_known_ = pressures_known_ = tooth_pieces_known_ = false;
  window_.update(*this);
}

const std::vector<std::vector<double>> &Observation::pressures() const
{
  if (pressures_known_)
    return pressures_;
  std::vector<double> all; // one message for all
  pressures_.clear();
  for (const auto &family : system.contacts.families())
    {
      pressures_.emplace_back(family->knows_pressure() ? scene.drive.n_joints : 0, 0.);
      family->raise_pressures(pressures_.back());
      all.insert(all.end(), pressures_.back().begin(), pressures_.back().end());
    }
  if (!all.empty())
    on_first_rank_.max(all, system.world.communicator(), tag_pressures);
  auto next = all.begin();
  for (std::vector<double> &of_family : pressures_)
    for (double &pressure : of_family)
      pressure = *next++;
  pressures_known_ = true;
  return pressures_;
}

const std::vector<WholeRevolutions::Piece> &Observation::tooth_pieces() const
{
  if (!tooth_pieces_known_)
    {
      if (window_.settled()) // since when is not known from the start
        tooth_periods_.move_to(window_.start(), window_.end());
      tooth_pieces_ = &tooth_periods_.next(
          time() - dt_, dt_, driver_ != nullptr ? teeth_ * driver_->angle : 0.);
    }
  tooth_pieces_known_ = true;
  return *tooth_pieces_;
}

const Spans &Observation::spans() const
{
  if (!spans_known_)
    spans_.update(system);
  spans_known_ = true;
  return spans_;
}
} // namespace chaindrive::observe
