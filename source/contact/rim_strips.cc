// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips on teeth that modes of the rim displace: of class RollerStrips.
#include <chaindrive/contact/roller_strips.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace chaindrive::contact
{
std::array<double, 3> RollerStrips::of_modes(const scene::ToothFamily &teeth) const
{
  std::array<double, 3> compliance{};
  if (!rim_ && teeth.inert_rim)
    throw std::logic_error("RollerStrips: a rim with inertia has no modes");
  if (!rim_)
    return compliance;
  // pressure in half of an ellipse, as StripFlexibility has it: x = h sin(u), a factor of cos^2 u
  constexpr unsigned int n    = 200;
  const drive::Segment  &seat = form_->half_profile.front();
  const double           end  = seat.length() / seat.radius;
  for (unsigned int i = 0; i < 3; ++i)
    {
      std::vector<double> force(2 * std::size_t(rim_->n_points()), 0.);
      for (unsigned int k = 0; k < n; ++k)
        {
          const double u                           = dealii::numbers::PI * ((k + 0.5) / n - 0.5),
                       share                       = 2. / n * std::cos(u) * std::cos(u),
                       a                           = std::clamp(teeth.tooth_places.at(i).angle +
                                          teeth.loaded_half_angle * std::sin(u),
                                      -end,
                                      end);
          const reduction::RimModes::Place place   = rim_->place_at(a * seat.radius);
          const double                     into[2] = {-std::cos(a), std::sin(a)};
          for (unsigned int d = 0; d < 2; ++d)
            {
              force[2 * place.first + d] += (1. - place.part) * share * into[d];
              force[2 * place.first + 2 + d] += place.part * share * into[d];
            }
        }
      compliance[i] = rim_->compliance(force);
    }
  return compliance;
}

dealii::Tensor<1, 2> RollerStrips::displaced(const Roller &roller, const unsigned int strip) const
{
  if (!rim_)
    return {};
  const reduction::RimModes::Place &place = on_rim_[strip];
  return (1. - place.part) * roller.teeth[place.first] + place.part * roller.teeth[place.first + 1];
}

void RollerStrips::push(const unsigned int strip, const dealii::Tensor<1, 2> &force)
{
  on_teeth_.resize(rim_->n_points());
  const reduction::RimModes::Place &place = on_rim_[strip];
  on_teeth_[place.first] += (1. - place.part) * force;
  on_teeth_[place.first + 1] += place.part * force;
}

void RollerStrips::add_rim(const std::vector<unsigned int> &unknowns, ClosedStrips &closed) const
{
  const std::size_t n = 2 * std::size_t(rim_->n_points());
  for (unsigned int m = 0; m < rim_->n_modes(); ++m)
    for (const unsigned int unknown : unknowns)
      {
        const unsigned int                strip = unknown / flexibility_->n_rings();
        const reduction::RimModes::Place &place = on_rim_[strip];
        const ToothStrips::Strip         &along = profile_.strips()[strip];
        dealii::Tensor<1, 2>              t     = along.ends[1] - along.ends[0];
        t /= t.norm();
        const double into[2] = {-t[1], t[0]};
        double       cosine = 0., sine = 0.;
        for (unsigned int d = 0; d < 2; ++d)
          {
            const std::size_t at = m * n + 2 * std::size_t(place.first) + d;
            cosine += into[d] *
                      ((1. - place.part) * rim_->cosine[at] + place.part * rim_->cosine[at + 2]);
            sine +=
                into[d] * ((1. - place.part) * rim_->sine[at] + place.part * rim_->sine[at + 2]);
          }
        closed.rim_cosine.push_back(cosine);
        closed.rim_sine.push_back(sine);
      }
}
} // namespace chaindrive::contact
