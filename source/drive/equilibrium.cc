// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/equilibrium.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::drive
{
using dealii::Point;

namespace
{
/// A small square matrix.
using Rows = std::vector<std::vector<double>>;

/// Lower triangle of the Cholesky factor of @p a; false if @p a is not positive definite.
bool cholesky(Rows &a)
{
  for (unsigned int i = 0; i < a.size(); ++i)
    for (unsigned int j = 0; j <= i; ++j)
      {
        double sum = a[i][j];
        for (unsigned int k = 0; k < j; ++k)
          sum -= a[i][k] * a[j][k];
        if (i == j && !(sum > 0.))
          return false;
        a[i][j] = i == j ? std::sqrt(sum) : sum / a[j][j];
      }
  return true;
}

bool positive_definite(const Equilibrium::Matrix &m) { return m[0][0] > 0. && determinant(m) > 0.; }

} // namespace

Equilibrium::Equilibrium(Layout                          &layout,
                         const RestingChain              &chain,
                         const std::vector<RestingWheel> &wheels,
                         const double                     centrifugal,
                         const RestingGuide              *guide)
    : layout_(layout)
    , chain_(chain)
    , wheels_(wheels)
    , n_(layout.joints.size())
    , n_wheels_(wheels.size())
    , guide_(guide)
    , frames_(layout.sprockets)
    , contact_radius_(chain.roller_radius - chain.bush_clearance)
    , centrifugal_(centrifugal)
{
  if (layout.tensioner)
    moving_ = &*layout.tensioner;
  if (guide != nullptr)
    {
      const Tensioner &held = *guide->held;
      const bool       arm  = held.is_arm();
      wheels_.push_back({guide->outline, held.lever(), 0., !arm, 0., {}, guide->plates});
      frames_.push_back({arm ? held.pivot : held.centre(held.travel),
                         arm ? held.sense * held.travel : 0.,
                         0.,
                         0,
                         1});
      if (!arm)
        moving_ = &held;
    }
  turned_.assign(wheels_.size(), 0.);
  for (unsigned int k = 0; k < n_; ++k)
    of_links_.push_back(k % 2 == 0 ? chain.inner_stiffness : chain.outer_stiffness);
  of_seats_.assign(n_ * wheels_.size(),
                   chain.bush_clearance > 0. ? chain.tooth_stiffness * chain.bush_stiffness /
                                                   (chain.tooth_stiffness + chain.bush_stiffness) :
                                               chain.tooth_stiffness);
  of_bushes_.assign(n_, chain.bush_stiffness);
  for (unsigned int i = 0; i < wheels_.size(); ++i)
    if (!wheels_[i].held)
      free_.push_back(i);
  for (const Layout::Joint &joint : layout.joints)
    at_.push_back(joint.bush);
  for (unsigned int i = 0; i < n_wheels_; ++i)
    if (wheels_[i].bearing)
      on_bearings_.push_back({i,
                              static_cast<unsigned int>(free_.size() + 2 * on_bearings_.size()),
                              layout.sprockets[i].deflection});
  if (moving_ != nullptr)
    travel_ = moving_->travel;
}

double Equilibrium::travel_of_guide() const
{
  return guide_->held->travel + guide_->held->sense * turned_[n_wheels_];
}

void Equilibrium::move_shaft(const double by)
{
  const auto   wheel = layout_.clamped ? layout_.clamped->wheel : layout_.moved;
  Point<2>    &shaft = frames_[wheel].centre;
  const Vector arm   = frames_[wheel].axis() - frames_[0].axis();
  Vector       way   = (layout_.rises ? -by : by) / arm.norm() * arm;
  if (layout_.clamped)
    {
      Tensioner &clamped = *layout_.clamped;
      clamped.travel += by / clamped.lever();
      way = clamped.centre(clamped.travel) - shaft;
    }
  if (n_wheels_ == 2 && arm[1] == 0.)
    for (Point<2> &p : at_)
      p[0] += std::clamp(p[0] / shaft[0], 0., 1.) * by;
  else
    {
      const auto share = [this, wheel](const unsigned int k) {
        return layout_.joints[k].sprocket == static_cast<int>(wheel) ? 1. : 0.;
      };
      for (unsigned int k = 0; k < n_; ++k)
        at_[k] += share(k) * way;
      for (const Layout::Span &span : layout_.spans)
        for (unsigned int k = 1; k < span.links; ++k)
          at_[(span.first + k) % n_] +=
              ((span.links - k) * share(span.first) + k * share((span.first + span.links) % n_)) /
              span.links * way;
    }
  shaft += way;
}

bool Equilibrium::solve(const double tolerance)
{
  const std::vector<double> stiff = of_seats_;
  for (double &seat : of_seats_)
    seat *= 0.02;
  while (of_seats_ != stiff)
    {
      minimize(tolerance);
      for (std::size_t i = 0; i < stiff.size(); ++i)
        of_seats_[i] = std::min(stiff[i], 3. * of_seats_[i]);
    }
  constexpr double same = 1e-7; // and at a place that is so near
  for (unsigned int i = 0; i < 30; ++i)
    if (!minimize(tolerance))
      return false;
    else if (take_secants() < same)
      return true;
  return false;
}

bool Equilibrium::minimize(const double tolerance)
{
  const double stiffest = chain_.tooth_stiffness + chain_.outer_stiffness;
  double       shift = 1e-6 * stiffest, energy = assemble();
  for (unsigned int iteration = 0; iteration < 1000; ++iteration)
    {
      if (largest_force() < tolerance)
        return true;
      if (!newton_step(shift))
        {
          shift = std::max(10. * shift, 1e-9 * stiffest);
          continue;
        }
      const auto before  = at_;
      const auto angles  = turned_;
      const auto travel  = travel_;
      const auto axes    = on_bearings_;
      double     longest = 0.;
      for (const double s : wheel_step_)
        longest = std::max(longest, std::abs(s));
      for (const Vector &s : step_)
        longest = std::max(longest, s.norm());
      const double part = std::min(1., largest_move / longest);
      for (unsigned int k = 0; k < n_; ++k)
        at_[k] += part * step_[k];
      for (unsigned int f = 0; f < free_.size(); ++f)
        turned_[free_[f]] += part * wheel_step_[f] / wheels_[free_[f]].lever;
      for (OnBearing &on : on_bearings_)
        for (unsigned int d = 0; d < 2; ++d)
          on.way[d] += part * wheel_step_[on.first + d];
      if (moving_ != nullptr)
        travel_ += part * wheel_step_.back() / moving_->lever();
      const double now = assemble();
      if (now <= energy + 1e-14 * std::abs(energy))
        {
          energy = now;
          shift  = shift < 1e-9 * stiffest ? 0. : 0.2 * shift;
          continue;
        }
      at_          = before;
      turned_      = angles;
      travel_      = travel;
      on_bearings_ = axes;
      shift        = std::max(10. * shift, 1e-9 * stiffest);
      if (shift > 1e6 * stiffest)
        return false;
      assemble();
    }
  return false;
}

double Equilibrium::largest_force() const
{
  double largest = 0.;
  for (const double g : wheel_gradient_)
    largest = std::max(largest, std::abs(g));
  for (const Vector &g : gradient_)
    largest = std::max(largest, g.norm());
  return largest;
}

double Equilibrium::tension(const unsigned int k) const
{
  return stiffness(k) * (at_[k].distance(at_[(k + 1) % n_]) - length(k));
}

double Equilibrium::moment_on(const unsigned int i) const
{
  double moment = 0.;
  for (const Point<2> &at : at_)
    {
      const auto   k = static_cast<unsigned int>(&at - at_.data());
      Vector       normal;
      const double force = seat_force(k, i, overlap(i, at, 0., normal));
      const Vector arm   = at - frames_[i].axis();
      moment += force * (arm[0] * normal[1] - arm[1] * normal[0]);
    }
  return moment;
}

void Equilibrium::store() const
{
  // before frames of wheels change, on which it depends
  std::vector<double> torques;
  for (unsigned int i = 0; i < n_wheels_; ++i)
    torques.push_back(wheels_[i].held ? moment_on(i) : wheels_[i].torque);
  if (layout_.tensioner)
    layout_.tensioner->travel = travel_;
  else if (guide_ != nullptr)
    guide_->held->travel = moving_ != nullptr ? travel_ : travel_of_guide();
  layout_.prestress = 0.;
  for (unsigned int k = 0; k < n_; ++k)
    {
      Layout::Joint &joint = layout_.joints[k];
      Vector         normal;
      joint.pin_force  = std::abs(tension(k % 2 == 1 ? k : (k + n_ - 1) % n_));
      joint.seat_force = 0.;
      for (unsigned int i = 0; i < wheels_.size(); ++i)
        {
          const double force = seat_force(k, i, overlap(i, at_[k], 0., normal));
          joint.seat_force += wheels_[i].plates ? 0. : force;
          layout_.prestress = std::max(layout_.prestress, force);
        }
      layout_.prestress = std::max({layout_.prestress, std::abs(tension(k)), joint.seat_force});
    }
  for (unsigned int k = 0; k < n_; ++k)
    {
      layout_.joints[k].bush   = at_[k];
      layout_.joints[k].roller = roller(k);
    }
  for (unsigned int i = 0; i < n_wheels_; ++i)
    {
      Layout::Sprocket &wheel = layout_.sprockets[i];
      wheel                   = frames_[i];
      const Point<2> axis     = wheel.axis();
      wheel.centre            = centre(i, 0.);
      if (wheel.eccentricity != Vector())
        wheel.eccentricity = wheel.centre - axis;
      wheel.angle += turned_[i];
      wheel.torque = torques[i];
    }
  for (Layout::Span &span : layout_.spans)
    {
      const Point<2> &from = at_[span.first], &to = at_[(span.first + span.links) % n_];
      span.direction = (to - from) / to.distance(from);
      span.normal[0] = layout_.sense * span.direction[1];
      span.normal[1] = -layout_.sense * span.direction[0];
    }
  set_links(layout_);
  // Each pin of an outer link comes nearer to its bush by the shift of its own joint.
  for (unsigned int k = 1; k < n_; k += 2)
    {
      Layout::Link &link = layout_.links[k];
      link.ahead         = 0.5 * (chain_.shifts.pin_of(k) - chain_.shifts.pin_of((k + 1) % n_));
      link.centre[0] += link.ahead * std::cos(link.angle);
      link.centre[1] += link.ahead * std::sin(link.angle);
    }
}

double Equilibrium::length(const unsigned int k) const
{
  return chain_.length.of(k) + (chain_.deviations.empty() ? 0. : chain_.deviations[k]) +
         (k % 2 == 0 ? 0. : chain_.shifts.pin_of(k) + chain_.shifts.pin_of((k + 1) % n_));
}

double Equilibrium::contact_stiffness(const unsigned int k, const unsigned int i) const
{
  const double seat = of_seats_[k * wheels_.size() + i];
  return wheels_[i].plates ? std::min(seat, wheels_[i].plates->stiffness) : seat;
}

double Equilibrium::seat_force(const unsigned int k, const unsigned int i, const double depth) const
{
  const double shift = wheels_[i].plates ? 0. : chain_.shifts.seat_of(k);
  return contact_stiffness(k, i) * std::max(0., depth - shift);
}

Point<2> Equilibrium::centre(const unsigned int i, const double turn) const
{
  const Layout::Sprocket &wheel = frames_[i];
  const Vector           &e     = wheel.eccentricity;
  if (wheels_[i].held || e == Vector())
    return wheel.centre;
  const double c = std::cos(turned_[i] + turn), s = std::sin(turned_[i] + turn);
  Point<2>     at = wheel.axis();
  at[0] += c * e[0] - s * e[1];
  at[1] += s * e[0] + c * e[1];
  return at;
}

double Equilibrium::overlap(const unsigned int i,
                            const Point<2>    &p,
                            const double       turn,
                            Vector            &normal) const
{
  const path::Obstacle   &outline = *wheels_[i].outline;
  const Layout::Sprocket &wheel   = frames_[i];
  const Vector            arm     = p - centre(i, turn);
  const auto             &plates  = wheels_[i].plates;
  const double            radius  = plates ? plates->radius : contact_radius_;
  normal                          = Vector();
  if (arm.norm() > outline.reach() + (plates ? radius : chain_.roller_radius))
    return -1.;
  const double        angle = wheels_[i].held ? wheel.angle : wheel.angle + turned_[i] + turn;
  const double        c = std::cos(angle), s = std::sin(angle);
  const path::Nearest nearest =
      outline.nearest(Point<2>(c * arm[0] + s * arm[1], c * arm[1] - s * arm[0]));
  normal[0] = c * nearest.normal[0] - s * nearest.normal[1];
  normal[1] = s * nearest.normal[0] + c * nearest.normal[1];
  return radius - nearest.distance;
}

Point<2> Equilibrium::roller(const unsigned int k) const
{
  const Point<2> &bush      = at_[k];
  const double    clearance = chain_.bush_clearance;
  if (clearance == 0.)
    return bush;
  Vector   normal;
  Point<2> at   = bush;
  bool     free = true;
  for (unsigned int i = 0; i < wheels_.size(); ++i)
    {
      if (wheels_[i].plates)
        continue;
      const double depth = overlap(i, bush, 0., normal);
      if (depth > -clearance)
        at += (clearance + (depth > 0. ? seat_force(k, i, depth) / of_bushes_[k] : depth)) * normal;
      free = free && depth <= -clearance;
    }
  if (free && chain_.weight > 0.)
    {
      at[1] -= clearance;
      for (unsigned int i = 0; i < wheels_.size(); ++i)
        if (!wheels_[i].plates && overlap(i, at, 0., normal) > -clearance)
          return bush;
    }
  return at;
}

double Equilibrium::contact(const unsigned int     k,
                            const unsigned int     i,
                            const Point<2>        &p,
                            const double           turn,
                            std::array<double, 3> &gradient) const
{
  Vector       normal;
  const double force = seat_force(k, i, overlap(i, p, turn, normal));
  const Vector arm   = p - frames_[i].axis();
  gradient           = {{-force * normal[0],
                         -force * normal[1],
               wheels_[i].held ?
                             0. :
                             force * (normal[1] * arm[0] - normal[0] * arm[1]) / wheels_[i].lever}};
  return 0.5 * force * force / contact_stiffness(k, i);
}

void Equilibrium::add_contact(const unsigned int k, const unsigned int i, const unsigned int f)
{
  const bool            held = wheels_[i].held;
  std::array<double, 3> here, there;
  energy_ += contact(k, i, at_[k], 0., here);
  gradient_[k][0] += here[0];
  gradient_[k][1] += here[1];
  if (!held)
    wheel_gradient_[f] += here[2];
  if (here[0] == 0. && here[1] == 0.)
    return;
  std::array<std::array<double, 3>, 3> all{};
  for (unsigned int j = 0; j < (held ? 2 : 3); ++j)
    {
      Point<2> moved = at_[k];
      if (j < 2)
        moved[j] += nudge;
      contact(k, i, moved, j < 2 ? 0. : nudge / wheels_[i].lever, there);
      for (unsigned int a = 0; a < 3; ++a)
        {
          const double second = (there[a] - here[a]) / nudge;
          all[a][j]           = second;
          if (a < 2 && j < 2)
            diagonal_[k][a][j] += second;
          else if (a == 2 && j == 2)
            wheel_diagonal_[f] += second;
          else if (j == 2)
            to_wheel_[f][k][a] += second;
        }
    }
  if (moving_ != nullptr && i == moving_->wheel)
    add_travel(k, here, all);
  for (const OnBearing &on : on_bearings_)
    if (on.wheel == i)
      add_axis(on, k, f, here, all);
}

void Equilibrium::place_tensioner() { frames_[moving_->wheel].centre = moving_->centre(travel_); }

double Equilibrium::assemble()
{
  const std::size_t n_unknowns =
      free_.size() + 2 * on_bearings_.size() + (moving_ != nullptr ? 1 : 0);
  energy_ = 0.;
  wheel_gradient_.clear();
  for (const unsigned int i : free_)
    {
      energy_ -= wheels_[i].torque * turned_[i];
      wheel_gradient_.push_back(-wheels_[i].torque / wheels_[i].lever);
    }
  wheel_diagonal_.assign(n_unknowns, 0.);
  wheel_to_travel_ = 0.;
  between_.assign(on_bearings_.empty() ? 0 : n_unknowns, std::vector<double>(n_unknowns));
  if (!free_.empty() && is_arm(free_.back()))
    {
      const Tensioner &arm    = *guide_->held;
      const double     travel = travel_of_guide(), lever = arm.lever();
      energy_ += arm.law.energy(travel);
      wheel_gradient_.back() -= arm.sense * arm.law.elastic(travel) / lever;
      wheel_diagonal_[free_.size() - 1] = arm.law.rate(travel) / (lever * lever);
    }
  add_bearings();
  if (moving_ != nullptr)
    {
      const Tensioner &tensioner = *moving_;
      const double     lever     = tensioner.lever();
      place_tensioner();
      energy_ += tensioner.law.energy(travel_) + tensioner.weight * tensioner.centre(travel_)[1];
      wheel_gradient_.push_back(
          (tensioner.weight * tensioner.way(travel_)[1] - tensioner.law.elastic(travel_)) / lever);
      wheel_diagonal_.back() =
          (tensioner.weight * tensioner.bend(travel_)[1] + tensioner.law.rate(travel_)) /
          (lever * lever);
    }
  gradient_.assign(n_, Vector());
  to_wheel_.assign(n_unknowns, std::vector<Vector>(n_));
  diagonal_.assign(n_, Matrix());
  to_next_.assign(n_, Matrix());
  for (unsigned int k = 0; k < n_; ++k)
    {
      const unsigned int next     = (k + 1) % n_;
      const Vector       vector   = at_[next] - at_[k];
      const double       distance = vector.norm(), stretch = distance - length(k);
      const Vector       axis  = vector / distance;
      const double       force = stiffness(k) * stretch - centrifugal_;
      energy_ += (0.5 * (force - centrifugal_)) * stretch + chain_.weight * at_[k][1];
      gradient_[k] -= force * axis;
      gradient_[next] += force * axis;
      gradient_[k][1] += chain_.weight;
      Matrix along;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          along[i][j] = stiffness(k) * axis[i] * axis[j] +
                        force / distance * ((i == j ? 1. : 0.) - axis[i] * axis[j]);
      diagonal_[k] += along;
      diagonal_[next] += along;
      to_next_[k] -= along;
      for (unsigned int i = 0, f = 0; i < wheels_.size(); ++i)
        {
          add_contact(k, i, f);
          f += wheels_[i].held ? 0 : 1;
        }
    }
  for (Matrix &m : diagonal_)
    m[0][1] = m[1][0] = 0.5 * (m[0][1] + m[1][0]);
  return energy_;
}

bool Equilibrium::newton_step(const double shift)
{
  const unsigned int               m = 2 + static_cast<unsigned int>(wheel_diagonal_.size());
  std::vector<Matrix>              inverse(n_);
  std::vector<std::vector<Vector>> border(n_, std::vector<Vector>(m));
  std::vector<Vector>              right(n_);
  Rows                             corner(m, std::vector<double>(m, 0.));
  std::vector<double>              rest(m);
  for (unsigned int i = 0; i < 2; ++i)
    {
      for (unsigned int j = 0; j < 2; ++j)
        corner[i][j] = diagonal_[0][i][j] + (i == j ? shift : 0.);
      for (unsigned int f = 2; f < m; ++f)
        corner[f][i] = corner[i][f] = to_wheel_[f - 2][0][i];
      rest[i] = -gradient_[0][i];
    }
  for (unsigned int f = 2; f < m; ++f)
    {
      corner[f][f] = wheel_diagonal_[f - 2] + shift;
      rest[f]      = -wheel_gradient_[f - 2];
    }
  for (unsigned int a = 0; a < between_.size(); ++a)
    for (unsigned int b = 0; b < a; ++b)
      corner[2 + a][2 + b] = corner[2 + b][2 + a] = between_[a][b];
  if (moving_ != nullptr)
    {
      const auto wheel = std::find(free_.begin(), free_.end(), moving_->wheel);
      if (wheel != free_.end())
        {
          const auto f     = static_cast<unsigned int>(2 + (wheel - free_.begin()));
          corner[f][m - 1] = corner[m - 1][f] = wheel_to_travel_;
        }
    }

  for (unsigned int k = 1; k < n_; ++k)
    {
      Matrix pivot = diagonal_[k];
      pivot[0][0] += shift;
      pivot[1][1] += shift;
      right[k] = -gradient_[k];
      for (unsigned int i = 0; i < 2; ++i)
        {
          for (unsigned int j = 0; j < 2; ++j) // to_next_ is symmetric
            border[k][j][i] =
                (k == 1 ? to_next_[0][i][j] : 0.) + (k == n_ - 1 ? to_next_[n_ - 1][i][j] : 0.);
          for (unsigned int f = 2; f < m; ++f)
            border[k][f][i] = to_wheel_[f - 2][k][i];
        }
      if (k > 1)
        {
          const Matrix factor = to_next_[k - 1] * inverse[k - 1];
          pivot -= factor * to_next_[k - 1];
          right[k] -= factor * right[k - 1];
          for (unsigned int b = 0; b < m; ++b)
            border[k][b] -= factor * border[k - 1][b];
        }
      if (!positive_definite(pivot))
        return false;
      inverse[k] = invert(pivot);
      for (unsigned int a = 0; a < m; ++a)
        {
          const Vector row = inverse[k] * border[k][a];
          for (unsigned int b = 0; b < m; ++b)
            corner[a][b] -= row * border[k][b];
          rest[a] -= row * right[k];
        }
    }
  if (!cholesky(corner))
    return false;
  for (unsigned int i = 0; i < m; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
        rest[i] -= corner[i][j] * rest[j];
      rest[i] /= corner[i][i];
    }
  for (unsigned int i = m; i-- > 0;)
    {
      for (unsigned int j = i + 1; j < m; ++j)
        rest[i] -= corner[j][i] * rest[j];
      rest[i] /= corner[i][i];
    }
  step_.assign(n_, Vector());
  step_[0][0] = rest[0];
  step_[0][1] = rest[1];
  wheel_step_.assign(rest.begin() + 2, rest.end());
  for (unsigned int k = n_ - 1; k > 0; --k)
    {
      Vector sum = right[k];
      for (unsigned int b = 0; b < m; ++b)
        sum -= rest[b] * border[k][b];
      if (k + 1 < n_)
        sum -= to_next_[k] * step_[k + 1];
      step_[k] = inverse[k] * sum;
    }
  return true;
}
} // namespace chaindrive::drive
