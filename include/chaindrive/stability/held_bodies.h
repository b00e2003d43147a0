// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/stability/closed_ways.h>
#include <chaindrive/stability/coupled_modes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace chaindrive::stability
{
/// What moves on the other side of strips, all modal bodies being at rest: rigid bodies and the
/// modes of their rims. With the mobility B M^-1 B^T and the largest stiffness K of strips, g is
/// the largest eigenvalue of K^1/2 (B M^-1 B^T) K^1/2, and w the highest frequency of these modes
/// by themselves. Together with bodies that have the square L with these at rest the square is at
/// most the largest eigenvalue of
///
///   ( L           sqrt(L g) )
///   ( sqrt(L g)   w^2 + g   ),
///
/// which is L + g where w is zero.
struct Others
{
  double square    = 0.; ///< g, 1/s2
  double frequency = 0.; ///< w, rad/s

  void update_largest(const Others &other)
  {
    square    = std::max(square, other.square);
    frequency = std::max(frequency, other.frequency);
  }

  /// The limit, s, with these of bodies that have the limit @p step without.
  double with(const double step) const
  {
    const double l = 4. / (step * step);
    if (!(frequency > 0.))
      return 2. / std::sqrt(l + square);
    const double mean = 0.5 * (l + frequency * frequency + square),
                 half = 0.5 * (l - frequency * frequency - square);
    return 2. / std::sqrt(mean + std::sqrt(half * half + l * square));
  }
};

/// Bodies that are judged together, with all that holds them.
class HeldBodies
{
public:
  virtual ~HeldBodies() = default;

  virtual bool is_held() const = 0;

  /// Takes the springs that windows now have, see ClosedWindow::springs.
  virtual void take_springs() = 0;

  /// The smallest limit found, s, from several ways to close.
  virtual double critical_time_step() = 0;

  /// The limit, s, from that way alone which was found last: nearly the smallest one.
  virtual double near_critical_time_step() = 0;
};

/// One body of a group.
class HeldBody : public HeldBodies
{
public:
  explicit HeldBody(const ModalGroup &bodies) : bodies_(bodies), free_(bodies.modal_matrix({})) {}

  /// Windows must outlive this. What a side of nodes meets, of several kinds of bodies, is alike.
  void add(const ClosedWindow &window);

  /// After all windows.
  void close();

  void add(const contact::ClosedSide &side, const ClosedKind &kind);

  bool   is_held() const override { return !ways_.empty(); }
  void   take_springs() override;
  double critical_time_step() override;
  double near_critical_time_step() override;

  const ModalGroup &bodies() const { return bodies_; }

  /// Of a ring: so many ways to close it, with this one among its windows of nodes, at most; those
  /// in which it is fastest.
  std::vector<RingWay> fastest_ways(unsigned int most) const;

  /// Windows of nodes.
  const std::vector<const ClosedWindow *> &windows() const { return windows_; }

  /// Springs of contacts with a penalty, by surface.
  const std::map<unsigned int, ModalBodies::Side> &springs() const { return springs_; }

  /// What strips meet.
  const Others &of_others() const { return of_others_; }

private:
  /// Of ways that differ by one side the worst is chosen until none is worse.
  double step_from(std::vector<unsigned int> chosen);

  double step_with(const std::vector<unsigned int> &chosen) const;

  void add_way(const std::vector<Closed> &closed);

  const ModalGroup                         &bodies_;
  Matrix                                    free_;
  std::vector<const ClosedWindow *>         windows_, in_strips_;
  std::vector<std::vector<Hold>>            ways_;      ///< [side][direction]
  std::vector<RingWay>                      ring_ways_; ///< of the first side, if that is in strips
  std::vector<std::vector<Matrix>>          held_;      ///< by these, 1/s2
  std::vector<unsigned int>                 last_;      ///< the way found last
  std::map<unsigned int, ModalBodies::Side> springs_;
  Others                                    of_others_; ///< see of_others()
};

/// A link with a ring on each cylinder that has one: none of their joints is taken apart. The ring
/// is as fast wherever it is turned to, so that its own direction is that of its joint; of its ways
/// to close those are tried in which it alone is fastest. Ways are searched for by the fastest
/// motion: each side closes as is stiffest to it, which makes the fastest motion faster, and in the
/// end by trying all that differ by one number.
class HeldLink : public HeldBodies
{
public:
  explicit HeldLink(const HeldBody &link);

  /// A ring in the joint of these two windows. All must outlive this.
  void add(const HeldBody &ring, const ClosedWindow &bore, const ClosedWindow &cylinder);

  /// After all rings: the other windows of the link.
  void close();

  bool   is_held() const override { return true; }
  void   take_springs() override {}
  double critical_time_step() override;
  double near_critical_time_step() override;

private:
  /// A number of a way, of those below n.
  struct Number
  {
    unsigned int now = 0, n = 1;
  };

  /// What closes, in one of several ways.
  struct Side
  {
    std::vector<unsigned int> motions; ///< those of all that it holds
    Number                    direction, ring_way;

    const ClosedWindow                                   *window = nullptr; ///< of the link, or
    const HeldBody                                       *ring   = nullptr;
    Ringed                                                joint{};
    std::vector<RingWay>                                  ways;
    std::map<std::pair<unsigned int, unsigned int>, Hold> made;
  };

  /// What a side holds, 1/s2, closed about this direction and, of a ring, in this way.
  const Hold &closed_at(Side &side, unsigned int direction, unsigned int ring_way);

  /// All as they close now, without springs of penalties.
  Matrix matrix();

  /// The limit of @p matrix() with all springs, s.
  double step_of(Matrix &&matrix) const;

  /// Each side closes by that which is stiffest to the fastest motion, until this does not become
  /// faster.
  double step_from_here();

  /// Of ways that differ by one number the worst is chosen until none is worse.
  double step_among_neighbours(double best);

  void add_springs(const HeldBody &body, const std::vector<unsigned int> &motions);

  const HeldBody           &link_;
  std::vector<double>       free_; ///< diagonal of the matrix without what holds, 1/s2
  std::vector<unsigned int> of_link_;
  std::vector<Side>         sides_;
  std::map<unsigned int, ModalBodies::Side> springs_;
  Others                                    of_others_; ///< see HeldBody
};
} // namespace chaindrive::stability
