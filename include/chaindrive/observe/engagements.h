// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/scene/scene.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace chaindrive::observe
{
/// The first touch of a roller that arrives at a sprocket from the span.
struct Engagement
{
  std::string  sprocket;        ///< driver | driven
  unsigned int roller;          ///< joint number
  double       time;            ///< of the first touch, s
  double       relative_speed;  ///< of the roller's centre and the sprocket's material there, m/s
  double       normal_speed;    ///< its part along the contact normal, m/s
  double       peak_force = 0.; ///< largest normal force within 1 ms, N
  double       impulse    = 0.; ///< of the normal force in the first 0.3 ms, N s
  bool         complete   = false; ///< the run went on for 1 ms after the touch

  template <typename BoostArchive>
  void serialize(BoostArchive &archive, unsigned int)
  {
    archive &sprocket &roller &time &relative_speed &normal_speed &peak_force &impulse &complete;
  }
};

/// Finds engagements while the run goes on. A roller arrives when it has been farther than 0.15
/// pitches outside the pitch circle and without contact for at least 1 ms, and touches on the side
/// of the sprocket where the chain comes in: a roller that bounces in its seat, or meets a tooth
/// once more as it leaves, does not engage again.
class Engagements
{
public:
  Engagements(const scene::Scene &scene, const dynamics::System &system);

  /// Looks at the contacts after a step of @p dt [s].
  void observe(const dynamics::System &system, double dt);

  void serialize(const Archive &archive);

  /// All engagements so far, in the order of their first touch.
  const std::vector<Engagement> &found() const { return found_; }

  /// Mean time between consecutive engagements of the driver that began in [start, end], s; not a
  /// number with fewer than two.
  double mean_pitch_time(double start, double end) const;

private:
  struct Sprocket
  {
    std::string                    name;
    const contact::SurfaceContact *teeth;
    double                         far_radius; ///< m
    dealii::Tensor<1, 3>           entry_side; ///< from the axis, where rollers arrive
    std::vector<double>            last_touch; ///< per joint, s
    std::vector<char>              was_far;    ///< per joint, since it last engaged
    std::vector<int>               open;       ///< per joint, engagement still watched or -1
    std::vector<double>            force;      ///< per joint, this step, N
  };
  void observe(Sprocket &sprocket, const World &world, double dt);

  std::vector<Sprocket>   sprockets_;
  std::vector<Engagement> found_;
};
} // namespace chaindrive::observe
