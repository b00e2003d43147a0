// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/rest.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using Vector = Tensor<1, 2>;
using Matrix = Tensor<2, 2>;

/// Of the largest tension: the forces left over at which a search ends that comes no further,
/// because a roller creeps over a kink in the curvature of its seat.
constexpr double creeping = 1e-3;

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

bool positive_definite(const Matrix &m) { return m[0][0] > 0. && determinant(m) > 0.; }

/// Energy, forces and stiffness of the drive, and one step of Newton's method.
class Equilibrium
{
public:
  Equilibrium(Layout                          &layout,
              const RestingChain              &chain,
              const std::vector<RestingWheel> &wheels,
              const double                     centrifugal = 0.)
      : layout_(layout)
      , chain_(chain)
      , wheels_(wheels)
      , n_(layout.joints.size())
      , contact_radius_(chain.roller_radius - chain.bush_clearance)
      , seat_stiffness_(chain.bush_clearance > 0. ?
                            chain.tooth_stiffness * chain.bush_stiffness /
                                (chain.tooth_stiffness + chain.bush_stiffness) :
                            chain.tooth_stiffness)
      , centrifugal_(centrifugal)
      , turned_(wheels.size(), 0.)
  {
    for (unsigned int i = 0; i < wheels.size(); ++i)
      if (!wheels[i].held)
        free_.push_back(i);
    for (const Layout::Joint &joint : layout.joints)
      at_.push_back(joint.bush);
  }

  /// Moves the shaft that the layout found away from that of wheel 0, and the chain with it, as if
  /// what leads to it were stretched alike.
  void move_shaft(const double by)
  {
    Point<2>    &shaft = layout_.sprockets[layout_.moved].centre;
    const Vector arm = shaft - layout_.sprockets[0].centre, way = by / arm.norm() * arm;
    if (wheels_.size() == 2 && arm[1] == 0.)
      for (Point<2> &p : at_)
        p[0] += std::clamp(p[0] / shaft[0], 0., 1.) * by;
    else
      {
        const auto share = [this](const unsigned int k) {
          return layout_.joints[k].sprocket == static_cast<int>(layout_.moved) ? 1. : 0.;
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
        const auto before  = at_;
        const auto angles  = turned_;
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
        const double now = assemble();
        if (now <= energy + 1e-14 * std::abs(energy))
          {
            energy = now;
            shift  = shift < 1e-9 * stiffest ? 0. : 0.2 * shift;
            continue;
          }
        at_     = before;
        turned_ = angles;
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
    double largest = 0.;
    for (const double g : wheel_gradient_)
      largest = std::max(largest, std::abs(g));
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
        for (unsigned int i = 0; i < wheels_.size(); ++i)
          joint.seat_force += seat_force(k, overlap(i, at_[k], 0., normal));
        layout_.prestress = std::max({layout_.prestress, std::abs(tension(k)), joint.seat_force});
      }
    for (unsigned int k = 0; k < n_; ++k)
      {
        layout_.joints[k].bush   = at_[k];
        layout_.joints[k].roller = roller(k);
      }
    for (unsigned int i = 0; i < wheels_.size(); ++i)
      layout_.sprockets[i].angle += turned_[i];
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

  /// By how much a joint's point at @p p overlaps wheel @p i, turned on by @p turn; very negative
  /// where it is far from it. @p normal points away from the wheel.
  double overlap(const unsigned int i, const Point<2> &p, const double turn, Vector &normal) const
  {
    const path::Obstacle   &outline = *wheels_[i].outline;
    const Layout::Sprocket &wheel   = layout_.sprockets[i];
    const Vector            arm     = p - wheel.centre;
    normal                          = Vector();
    if (arm.norm() > outline.reach() + chain_.roller_radius)
      return -1.;
    const double        angle = wheels_[i].held ? wheel.angle : wheel.angle + turned_[i] + turn;
    const double        c = std::cos(angle), s = std::sin(angle);
    const path::Nearest nearest =
        outline.nearest(Point<2>(c * arm[0] + s * arm[1], c * arm[1] - s * arm[0]));
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
    for (unsigned int i = 0; i < wheels_.size(); ++i)
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
        for (unsigned int i = 0; i < wheels_.size(); ++i)
          if (overlap(i, at, 0., normal) > -clearance)
            return bush;
      }
    return at;
  }

  /// Derivatives of a contact's energy by the joint's position and the wheel's way at its lever;
  /// returns the energy.
  double contact(const unsigned int     k,
                 const unsigned int     i,
                 const Point<2>        &p,
                 const double           turn,
                 std::array<double, 3> &gradient) const
  {
    Vector       normal;
    const double force = seat_force(k, overlap(i, p, turn, normal));
    const Vector arm   = p - layout_.sprockets[i].centre;
    gradient           = {{-force * normal[0],
                           -force * normal[1],
                 wheels_[i].held ?
                               0. :
                               force * (normal[1] * arm[0] - normal[0] * arm[1]) / wheels_[i].lever}};
    return 0.5 * force * force / seat_stiffness_;
  }

  /// Of joint @p k with wheel @p i, which is free wheel @p f if it is not held.
  void add_contact(const unsigned int k, const unsigned int i, const unsigned int f)
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
    for (unsigned int j = 0; j < (held ? 2 : 3); ++j)
      {
        Point<2> moved = at_[k];
        if (j < 2)
          moved[j] += nudge;
        contact(k, i, moved, j < 2 ? 0. : nudge / wheels_[i].lever, there);
        for (unsigned int a = 0; a < 3; ++a)
          {
            const double second = (there[a] - here[a]) / nudge;
            if (a < 2 && j < 2)
              diagonal_[k][a][j] += second;
            else if (a == 2 && j == 2)
              wheel_diagonal_[f] += second;
            else if (j == 2)
              to_wheel_[f][k][a] += second;
          }
      }
  }

  /// Energy [J] at the present state; its derivatives become members.
  double assemble()
  {
    const std::size_t n_free = free_.size();
    energy_                  = 0.;
    wheel_gradient_.clear();
    for (const unsigned int i : free_)
      {
        energy_ -= wheels_[i].torque * turned_[i];
        wheel_gradient_.push_back(-wheels_[i].torque / wheels_[i].lever);
      }
    wheel_diagonal_.assign(n_free, 0.);
    gradient_.assign(n_, Vector());
    to_wheel_.assign(n_free, std::vector<Vector>(n_));
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

  /// Solves (H + shift) step = -gradient: joints 1 ... n-1 are a block tridiagonal matrix, joint 0
  /// and the free wheels, the unknowns without neighbours on one side, its border. False where the
  /// matrix is not positive definite.
  bool newton_step(const double shift)
  {
    const unsigned int               m = 2 + static_cast<unsigned int>(free_.size());
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

  Layout                          &layout_;
  const RestingChain              &chain_;
  const std::vector<RestingWheel> &wheels_;
  const unsigned int               n_;
  const double                     contact_radius_;
  double                           seat_stiffness_;
  const double centrifugal_; ///< what turning its momentum takes of the tension, N

  std::vector<unsigned int> free_;   ///< wheels that are not held
  std::vector<Point<2>>     at_;     ///< of the joints, m
  std::vector<double>       turned_; ///< per wheel, rad
  double                    energy_ = 0.;

  std::vector<Vector>              gradient_;
  std::vector<std::vector<Vector>> to_wheel_; ///< second derivatives by a free wheel and a joint
  std::vector<Matrix>              diagonal_, to_next_;
  std::vector<double>              wheel_gradient_, wheel_diagonal_; ///< per free wheel
  std::vector<Vector>              step_;
  std::vector<double>              wheel_step_;
};

/// Gives wheel @p i the @p speed, and the chain in the spans beside it its share of the change.
void set_speed(Layout &layout, const unsigned int i, const double speed)
{
  Layout::Sprocket  &wheel  = layout.sprockets[i];
  const double       factor = speed / wheel.speed;
  const unsigned int n      = layout.joints.size();
  for (const Layout::Span &span : layout.spans)
    {
      const unsigned int last  = (span.first + span.links) % n;
      const bool         leads = layout.joints[last].sprocket == static_cast<int>(i);
      if (!leads && layout.joints[span.first].sprocket != static_cast<int>(i))
        continue;
      const Vector change = (factor - 1.) * layout.joints[leads ? last : span.first].velocity;
      for (unsigned int k = 1; k < span.links; ++k)
        layout.joints[(span.first + k) % n].velocity +=
            static_cast<double>(leads ? k : span.links - k) / span.links * change;
    }
  for (Layout::Joint &joint : layout.joints)
    if (joint.sprocket == static_cast<int>(i))
      joint.velocity *= factor;
  wheel.speed = speed;
}
} // namespace

void bring_to_rest(Layout                          &layout,
                   const RestingChain              &chain,
                   const std::vector<RestingWheel> &wheels,
                   const double                     tension)
{
  const Layout::Span &tight = layout.tight();

  Equilibrium  equilibrium(layout, chain, wheels);
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
      double now = 0.;
      for (const Layout::Span &span : layout.spans)
        now += equilibrium.tension(span.first + span.links / 2);
      now /= layout.spans.size();
      found = std::abs(now - tension) < 1e-3 * tension;
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

void settle(Layout                          &layout,
            const RestingChain              &chain,
            const std::vector<RestingWheel> &wheels,
            const Operation                 &operation)
{
  // a chain that runs takes m v^2 of its tension to turn its own momentum
  const double speed = wheels[0].lever * operation.driver_speed;
  const double pitch = 0.5 * (chain.length.inner + chain.length.outer);
  const double flux  = operation.mass_per_pitch / pitch * speed * speed;

  Equilibrium equilibrium(layout, chain, wheels, flux);
  double      scale = flux;
  for (const RestingWheel &wheel : wheels)
    scale += std::abs(wheel.torque) / wheel.lever;
  if (!equilibrium.solve(1e-6 * scale + 1e-3) && equilibrium.largest_force() > creeping * scale)
    throw InputError("Drive/Layout/Start = settled: no balance of the load torque, the tension of "
                     "the chain and the forces of the teeth is found for this drive; choose taut, "
                     "which comes to speed and load in a ramp.");
  equilibrium.store();
  set_in_motion(layout, operation.driver_speed);
  // above the resonance the inertia keeps its mean speed, whatever the polygon
  if (!operation.follows_polygon && operation.driver_speed > 0.)
    for (unsigned int i = 1; i < wheels.size(); ++i)
      set_speed(layout,
                i,
                layout.sprockets[i].turn * layout.sprockets[0].speed * wheels[0].seats /
                    wheels[i].seats);
}
} // namespace chaindrive::drive
