// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/observation.h>

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
{
  if (rollers.empty())
    {
      rollers.resize(scene.drive.n_joints);
      std::iota(rollers.begin(), rollers.end(), 0U);
    }
  for (const unsigned int joint : rollers)
    roller_bodies.push_back(scene.drive.rollers[joint]);
}

void Observation::next(const double dt)
{
  dt_          = dt;
  spans_known_ = false;
  window_.update(*this);
}

const Spans &Observation::spans() const
{
  if (!spans_known_)
    spans_.update(system);
  spans_known_ = true;
  return spans_;
}
} // namespace chaindrive::observe
