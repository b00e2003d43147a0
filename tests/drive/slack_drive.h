// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>

#include <algorithm>
#include <cmath>
#include <string>

/// An 08B chain of 90 links over 17 and 31 teeth with 1 mm of slack and no weight.
inline chaindrive::Parameters slack_drive(const std::string &fidelity)
{
  chaindrive::Parameters p;
  p.model.fidelity                    = fidelity;
  p.effects.gravity                   = chaindrive::parameters::Switch::off;
  p.drive.chain.designation           = "08B";
  p.drive.sprockets.driver().teeth    = 17;
  p.drive.sprockets.driven().teeth    = 31;
  p.drive.n_links                     = 90;
  p.drive.layout.centre_distance_from = chaindrive::parameters::CentreDistanceFrom::slack;
  p.drive.layout.slack                = 1e-3;
  return p;
}

/// Of link @p k without load, m.
inline double own_length(const chaindrive::drive::Drive &d, const bool lumped, const unsigned int k)
{
  const double kind = lumped     ? d.chain.loaded_pitch() :
                      k % 2 == 0 ? d.chain.loaded_inner_pitch() :
                                   d.chain.loaded_outer_pitch();
  return kind + d.links.of(k);
}

/// Of link @p k as it is laid, m.
inline double length(const chaindrive::drive::Drive &d, const unsigned int k)
{
  return d.layout.joints[k].bush.distance(d.layout.joints[(k + 1) % d.layout.joints.size()].bush);
}

/// The largest overlap of a roller with a tooth, m.
inline double deepest(const chaindrive::drive::Drive &d)
{
  double most = -1.;
  for (const chaindrive::drive::Layout::Joint &joint : d.layout.joints)
    for (unsigned int i = 0; i < d.sprockets.size(); ++i)
      {
        const chaindrive::drive::Layout::Sprocket &wheel = d.layout.sprockets[i];
        const dealii::Tensor<1, 2>                 arm   = joint.roller - wheel.centre;
        const double                               c     = std::cos(wheel.angle);
        const double                               s     = std::sin(wheel.angle);
        most =
            std::max(most,
                     0.5 * d.chain.roller_diameter -
                         d.sprockets[i]
                             .form.closest_point({c * arm[0] + s * arm[1], c * arm[1] - s * arm[0]})
                             .distance);
      }
  return most;
}
