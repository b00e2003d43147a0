// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/rest.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using Vector = Tensor<1, 2>;
using Matrix = Tensor<2, 2>;

constexpr unsigned int free_sprocket = 1; // the driven one

/// Of the largest tension: the forces left over at which a search ends that comes no further,
/// because a roller creeps over a kink in the curvature of its seat.
constexpr double creeping = 1e-3;

/// What a joint has in common with joint 0 and the driven hub, the unknowns without neighbours on
/// one side.
using Border = std::array<Vector, 3>;

/// Lower triangle of the Cholesky factor of @p a; false if @p a is not positive definite.
bool cholesky(std::array<std::array<double, 3>, 3> &a)
{
  for (unsigned int i = 0; i < 3; ++i)
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

bool positive_definite(const Matrix &m) { return m[0][0] > 0. && determinant(m) > 0.; }

/// Energy, forces and stiffness of the drive, and one step of Newton's method.
class Equilibrium
{
public:
  Equilibrium(Layout                       &layout,
              const RestingChain           &chain,
              const std::vector<ToothForm> &forms,
              const double                  torque      = 0.,
              const double                  centrifugal = 0.)
      : layout_(layout)
      , chain_(chain)
      , forms_(forms)
      , n_(layout.joints.size())
      , hub_radius_(0.5 * forms[free_sprocket].pitch_diameter)
      , contact_radius_(chain.roller_radius - chain.bush_clearance)
      , seat_stiffness_(chain.bush_clearance > 0. ?
                            chain.tooth_stiffness * chain.bush_stiffness /
                                (chain.tooth_stiffness + chain.bush_stiffness) :
                            chain.tooth_stiffness)
      , torque_(torque)
      , centrifugal_(centrifugal)
  {
    for (const Layout::Joint &joint : layout.joints)
      at_.push_back(joint.bush);
  }

  /// Moves the driven shaft, and the chain with it, as if all of it were stretched alike.
  void move_shaft(const double by)
  {
    double &shaft = layout_.sprockets[free_sprocket].centre[0];
    for (Point<2> &p : at_)
      p[0] += std::clamp(p[0] / shaft, 0., 1.) * by;
    shaft += by;
  }

  /// Finds the equilibrium to @p tolerance [N]; false if there seems to be none. Stiff seats are
  /// approached from soft ones: on these, fewer rollers are about to leave their teeth.
  bool solve(const double tolerance)
  {
    const double stiff = seat_stiffness_;
    seat_stiffness_    = 0.02 * stiff;
    for (;; seat_stiffness_ = std::min(stiff, 3. * seat_stiffness_))
      {
        const bool found = minimize(tolerance);
        if (seat_stiffness_ == stiff)
          return found;
      }
  }

  /// The same from where the chain is.
  bool minimize(const double tolerance)
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
        const auto   before  = at_;
        const double angle   = turned_;
        double       longest = std::abs(hub_step_);
        for (const Vector &s : step_)
          longest = std::max(longest, s.norm());
        const double part = std::min(1., largest_move / longest);
        for (unsigned int k = 0; k < n_; ++k)
          at_[k] += part * step_[k];
        turned_ += part * hub_step_ / hub_radius_;
        const double now = assemble();
        if (now <= energy + 1e-14 * std::abs(energy))
          {
            energy = now;
            shift  = shift < 1e-9 * stiffest ? 0. : 0.2 * shift;
            continue;
          }
        at_     = before;
        turned_ = angle;
        shift   = std::max(10. * shift, 1e-9 * stiffest);
        if (shift > 1e6 * stiffest)
          return false;
        assemble();
      }
    return false;
  }

  /// By which something is out of balance, N.
  double largest_force() const
  {
    double largest = std::abs(hub_gradient_);
    for (const Vector &g : gradient_)
      largest = std::max(largest, g.norm());
    return largest;
  }

  /// Of the link from joint @p k on, N.
  double tension(const unsigned int k) const
  {
    return stiffness(k) * (at_[k].distance(at_[(k + 1) % n_]) - length(k));
  }

  /// Puts what was found into the layout.
  void store() const
  {
    layout_.prestress = 0.;
    for (unsigned int k = 0; k < n_; ++k)
      {
        Layout::Joint &joint = layout_.joints[k];
        Vector         normal;
        joint.pin_force  = std::abs(tension(k % 2 == 1 ? k : (k + n_ - 1) % n_));
        joint.seat_force = 0.;
        for (unsigned int i = 0; i < forms_.size(); ++i)
          joint.seat_force += seat_force(k, overlap(i, at_[k], 0., normal));
        layout_.prestress = std::max({layout_.prestress, std::abs(tension(k)), joint.seat_force});
      }
    for (unsigned int k = 0; k < n_; ++k)
      {
        layout_.joints[k].bush   = at_[k];
        layout_.joints[k].roller = roller(k);
      }
    layout_.sprockets[free_sprocket].angle += turned_;
    for (Layout::Span &span : layout_.spans)
      {
        const Point<2> &from = at_[span.first], &to = at_[(span.first + span.links) % n_];
        span.direction = (to - from) / to.distance(from);
        span.normal[0] = layout_.sense * span.direction[1];
        span.normal[1] = -layout_.sense * span.direction[0];
      }
    set_links(layout_);
  }

private:
  static constexpr double largest_move = 0.5e-3; // m, of a joint in one iteration
  static constexpr double nudge        = 1e-9;   // m, for differences of contact forces

  double stiffness(const unsigned int k) const
  {
    return k % 2 == 0 ? chain_.inner_stiffness : chain_.outer_stiffness;
  }

  /// Of the link from joint @p k on, without load, m. Joints are at the ends of outer links.
  double length(const unsigned int k) const
  {
    return chain_.length.of(k) +
           (k % 2 == 0 ? 0. : chain_.shifts.pin_of(k) + chain_.shifts.pin_of((k + 1) % n_));
  }

  /// Of joint @p k on a tooth from which it overlaps by @p depth, N.
  double seat_force(const unsigned int k, const double depth) const
  {
    return seat_stiffness_ * std::max(0., depth - chain_.shifts.seat_of(k));
  }

  /// By how much a joint's point at @p p overlaps sprocket @p i, the driven one turned on by
  /// @p turn; very negative where it is far from it. @p normal points away from the tooth.
  double overlap(const unsigned int i, const Point<2> &p, const double turn, Vector &normal) const
  {
    const ToothForm        &form     = forms_[i];
    const Layout::Sprocket &sprocket = layout_.sprockets[i];
    const Vector            arm      = p - sprocket.centre;
    normal                           = Vector();
    if (arm.norm() > 0.5 * form.outside_diameter + chain_.roller_radius)
      return -1.;
    const double angle = i == free_sprocket ? sprocket.angle + turned_ + turn : sprocket.angle;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto   nearest =
        form.closest_point(Point<2>(c * arm[0] + s * arm[1], c * arm[1] - s * arm[0]));
    normal[0] = c * nearest.normal[0] - s * nearest.normal[1];
    normal[1] = s * nearest.normal[0] + c * nearest.normal[1];
    return contact_radius_ - nearest.distance;
  }

  /// Where the roller of joint @p k is: a loaded one lies on the tooth, and the bush in
  /// it, along one normal; one that hangs on its bush beside the teeth takes the room that they
  /// leave.
  Point<2> roller(const unsigned int k) const
  {
    const Point<2> &bush      = at_[k];
    const double    clearance = chain_.bush_clearance;
    if (clearance == 0.)
      return bush;
    Vector   normal;
    Point<2> at   = bush;
    bool     free = true;
    for (unsigned int i = 0; i < forms_.size(); ++i)
      {
        const double depth = overlap(i, bush, 0., normal);
        if (depth > -clearance)
          at += (clearance + (depth > 0. ? seat_force(k, depth) / chain_.bush_stiffness : depth)) *
                normal;
        free = free && depth <= -clearance;
      }
    if (free && chain_.weight > 0.)
      {
        at[1] -= clearance;
        for (unsigned int i = 0; i < forms_.size(); ++i)
          if (overlap(i, at, 0., normal) > -clearance)
            return bush;
      }
    return at;
  }

  /// Derivatives of a contact's energy by the joint's position and the driven hub's way at its
  /// pitch radius; returns the energy.
  double contact(const unsigned int     k,
                 const unsigned int     i,
                 const Point<2>        &p,
                 const double           turn,
                 std::array<double, 3> &gradient) const
  {
    Vector       normal;
    const double force = seat_force(k, overlap(i, p, turn, normal));
    const Vector arm   = p - layout_.sprockets[free_sprocket].centre;
    gradient           = {{-force * normal[0],
                           -force * normal[1],
                 i != free_sprocket ?
                               0. :
                               force * (normal[1] * arm[0] - normal[0] * arm[1]) / hub_radius_}};
    return 0.5 * force * force / seat_stiffness_;
  }

  void add_contact(const unsigned int k, const unsigned int sprocket)
  {
    std::array<double, 3> here, there;
    energy_ += contact(k, sprocket, at_[k], 0., here);
    gradient_[k][0] += here[0];
    gradient_[k][1] += here[1];
    hub_gradient_ += here[2];
    if (here[0] == 0. && here[1] == 0.)
      return;
    for (unsigned int j = 0; j < 3; ++j)
      {
        Point<2> moved = at_[k];
        if (j < 2)
          moved[j] += nudge;
        else if (sprocket != free_sprocket)
          break;
        contact(k, sprocket, moved, j < 2 ? 0. : nudge / hub_radius_, there);
        for (unsigned int i = 0; i < 3; ++i)
          {
            const double second = (there[i] - here[i]) / nudge;
            if (i < 2 && j < 2)
              diagonal_[k][i][j] += second;
            else if (i == 2 && j == 2)
              hub_diagonal_ += second;
            else if (j == 2)
              to_hub_[k][i] += second;
          }
      }
  }

  /// Energy [J] at the present state; its derivatives become members.
  double assemble()
  {
    energy_       = -torque_ * turned_;
    hub_gradient_ = -torque_ / hub_radius_;
    hub_diagonal_ = 0.;
    gradient_.assign(n_, Vector());
    to_hub_.assign(n_, Vector());
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
        for (unsigned int i = 0; i < forms_.size(); ++i)
          add_contact(k, i);
      }
    for (Matrix &m : diagonal_)
      m[0][1] = m[1][0] = 0.5 * (m[0][1] + m[1][0]);
    return energy_;
  }

  /// Solves (H + shift) step = -gradient: joints 1 ... n-1 are a block tridiagonal matrix, joint 0
  /// and the hub its border. False where the matrix is not positive definite.
  bool newton_step(const double shift)
  {
    std::vector<Matrix>                  inverse(n_);
    std::vector<Border>                  border(n_);
    std::vector<Vector>                  right(n_);
    std::array<std::array<double, 3>, 3> corner{};
    std::array<double, 3>                rest{};
    for (unsigned int i = 0; i < 2; ++i)
      {
        for (unsigned int j = 0; j < 2; ++j)
          corner[i][j] = diagonal_[0][i][j] + (i == j ? shift : 0.);
        corner[2][i] = corner[i][2] = to_hub_[0][i];
        rest[i]                     = -gradient_[0][i];
      }
    corner[2][2] = hub_diagonal_ + shift;
    rest[2]      = -hub_gradient_;

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
            border[k][2][i] = to_hub_[k][i];
          }
        if (k > 1)
          {
            const Matrix factor = to_next_[k - 1] * inverse[k - 1];
            pivot -= factor * to_next_[k - 1];
            right[k] -= factor * right[k - 1];
            for (unsigned int b = 0; b < 3; ++b)
              border[k][b] -= factor * border[k - 1][b];
          }
        if (!positive_definite(pivot))
          return false;
        inverse[k] = invert(pivot);
        for (unsigned int a = 0; a < 3; ++a)
          {
            const Vector row = inverse[k] * border[k][a];
            for (unsigned int b = 0; b < 3; ++b)
              corner[a][b] -= row * border[k][b];
            rest[a] -= row * right[k];
          }
      }
    if (!cholesky(corner))
      return false;
    for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < i; ++j)
          rest[i] -= corner[i][j] * rest[j];
        rest[i] /= corner[i][i];
      }
    for (int i = 2; i >= 0; --i)
      {
        for (int j = i + 1; j < 3; ++j)
          rest[i] -= corner[j][i] * rest[j];
        rest[i] /= corner[i][i];
      }
    step_.assign(n_, Vector());
    step_[0][0] = rest[0];
    step_[0][1] = rest[1];
    hub_step_   = rest[2];
    for (unsigned int k = n_ - 1; k > 0; --k)
      {
        Vector sum = right[k];
        for (unsigned int b = 0; b < 3; ++b)
          sum -= rest[b] * border[k][b];
        if (k + 1 < n_)
          sum -= to_next_[k] * step_[k + 1];
        step_[k] = inverse[k] * sum;
      }
    return true;
  }

  Layout                       &layout_;
  const RestingChain           &chain_;
  const std::vector<ToothForm> &forms_;
  const unsigned int            n_;
  const double                  hub_radius_, contact_radius_;
  double                        seat_stiffness_;
  const double torque_;      ///< on the driven sprocket, counter-clockwise positive, N m
  const double centrifugal_; ///< what turning its momentum takes of the tension, N

  std::vector<Point<2>> at_;          ///< of the joints, m
  double                turned_ = 0.; ///< the driven hub, rad
  double                energy_ = 0.;

  std::vector<Vector> gradient_, to_hub_; ///< second derivatives by a joint and the hub
  std::vector<Matrix> diagonal_, to_next_;
  double              hub_gradient_ = 0., hub_diagonal_ = 0.;
  std::vector<Vector> step_;
  double              hub_step_ = 0.;
};

/// Gives the driven sprocket @p speed, and the chain in the spans its share of the change.
void set_driven_speed(Layout &layout, const double speed)
{
  Layout::Sprocket  &driven = layout.sprockets[free_sprocket];
  const double       factor = speed / driven.speed;
  const unsigned int n      = layout.joints.size();
  for (const Layout::Span &span : layout.spans)
    {
      const unsigned int last   = (span.first + span.links) % n;
      const bool         leads  = layout.joints[last].sprocket == free_sprocket;
      const Vector       change = (factor - 1.) * layout.joints[leads ? last : span.first].velocity;
      for (unsigned int i = 1; i < span.links; ++i)
        layout.joints[(span.first + i) % n].velocity +=
            static_cast<double>(leads ? i : span.links - i) / span.links * change;
    }
  for (Layout::Joint &joint : layout.joints)
    if (joint.sprocket == free_sprocket)
      joint.velocity *= factor;
  driven.speed = speed;
}
} // namespace

void bring_to_rest(Layout                       &layout,
                   const RestingChain           &chain,
                   const std::vector<ToothForm> &forms,
                   const double                  tension)
{
  const Layout::Span &tight = layout.span(true), &slack = layout.span(false);

  Equilibrium  equilibrium(layout, chain, forms);
  const double tolerance = 1e-6 * tension + 1e-3;
  // tension over the shaft's way: first that of two straight spans, then secants
  double slope  = 2. / (1. / chain.inner_stiffness + 1. / chain.outer_stiffness) / tight.links;
  double before = 0., moved = 0.;
  bool   found = false;
  for (unsigned int iteration = 0; iteration < 60 && !found; ++iteration)
    {
      if (!equilibrium.solve(tolerance) && equilibrium.largest_force() > creeping * tension)
        {
          // too far: with almost no tension left rollers are free to move
          if (std::abs(moved) < 1e-9)
            break;
          moved *= 0.5;
          equilibrium.move_shaft(-moved);
          continue;
        }
      const double now = 0.5 * (equilibrium.tension(tight.first + tight.links / 2) +
                                equilibrium.tension(slack.first + slack.links / 2));
      found            = std::abs(now - tension) < 1e-3 * tension;
      if (found)
        break;
      if (moved != 0. && (now - before) / moved > 0.)
        slope = (now - before) / moved;
      before = now;
      moved  = std::clamp((tension - now) / slope, -1e-3, 1e-3);
      equilibrium.move_shaft(moved);
    }
  if (!found)
    throw InputError("Drive/Layout/Pretension in N = " + to_text(tension) +
                     ": no state of rest with this tension in both spans is found; choose another "
                     "one that is well above the weight of a span, " +
                     to_text(chain.weight * tight.links, 3) +
                     " N, and below the working tension, or Centre distance from = slack or sag.");
  equilibrium.store();
}

void settle(Layout                       &layout,
            const RestingChain           &chain,
            const std::vector<ToothForm> &forms,
            const Operation              &operation)
{
  // a chain that runs takes m v^2 of its tension to turn its own momentum
  const double speed = 0.5 * forms[0].pitch_diameter * operation.driver_speed;
  const double pitch = 0.5 * (chain.length.inner + chain.length.outer);
  const double flux  = operation.mass_per_pitch / pitch * speed * speed;

  Equilibrium  equilibrium(layout, chain, forms, -layout.sense * operation.torque, flux);
  const double scale = flux + std::abs(operation.torque) / (0.5 * forms[1].pitch_diameter);
  if (!equilibrium.solve(1e-6 * scale + 1e-3) && equilibrium.largest_force() > creeping * scale)
    throw InputError("Drive/Layout/Start = settled: no balance of the load torque, the tension of "
                     "the chain and the forces of the teeth is found for this drive; choose taut, "
                     "which comes to speed and load in a ramp.");
  equilibrium.store();
  set_in_motion(layout, operation.driver_speed);
  // above the resonance the inertia keeps its mean speed, whatever the polygon
  if (!operation.follows_polygon && operation.driver_speed > 0.)
    set_driven_speed(layout,
                     layout.sprockets[0].speed * forms[0].teeth / forms[free_sprocket].teeth);
}
} // namespace chaindrive::drive
