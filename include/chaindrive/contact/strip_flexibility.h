// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/joint_flexibility.h>
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/material/material.h>
#include <chaindrive/reduction/round_flexibility.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace chaindrive::contact
{
/// Strips along the outside of a roller, side by side, wherever they are round it. Angles are about
/// the roller's axis.
struct StripGrid
{
  std::vector<double> middle;     ///< ascending, rad
  std::vector<double> half_width; ///< rad

  unsigned int size() const { return static_cast<unsigned int>(middle.size()); }
};

/// How the seat between two teeth moves as a whole without inertia, beside what it dents: by a
/// force at the bottom of the gap along the middle of this, and across it by one at the slope a
/// (ToothStrips::slopes()) of
///   f(a) = s sin a + t sin^3 a;
/// what a normal force of one newton at b moves the surface at a by along its normal is
///   r^2 cos a cos b + f(a) f(b).
/// A ring on an elastic ground has t = 0; the bending of teeth makes it larger. r, s and t are
/// those with which pressure in half of an ellipse about three places moves these by as much as is
/// given.
class SeatMotion
{
public:
  /// Compliances [m/N] at the slopes @p at [rad], the first of which is zero, under pressure up to
  /// @p half_angle [rad] on either side; slopes end at @p end.
  SeatMotion(const std::array<double, 3> &at,
             const std::array<double, 3> &compliance,
             double                       half_angle,
             double                       end);

  double operator()(double a, double b) const; ///< slopes; m/N

private:
  double across(double a) const;

  double along_ = 0., first_ = 0., third_ = 0.; ///< r, s, t, root of m/N
};

/// By how much gaps between strips of a roller and a tooth grow under even pressures on these
/// without any inertia, ring by ring of the roller's nodes. It is the same wherever round the
/// roller the strips are.
///
/// What the roller deflects beside its modes is a sum over harmonics k of its circumference, as
/// many as its mesh has nodes for. An even pressure on a strip of half width w has the part sin(k
/// w) / (k w) of each, and so has the mean of a deflection. Shorter waves do not see that the
/// roller is thin or round: a pressure p cos(x / l) on a half-space deflects it by 2 l / E' p
/// cos(x / l) (Johnson, Contact Mechanics, 13.2), E' in plane strain. These are added; and where
/// the harmonics of the mesh from a quarter of its columns on are stiffer than that they are made
/// up to it. A tooth deflects like that in waves shorter than a quarter of the roller's
/// circumference; all else of it is one number, or SeatMotion.
class StripFlexibility
{
public:
  struct Tooth
  {
    double stiffness  = 0.; ///< of tooth and rim under a roller, N/m; 0: it does not deflect
    double half_angle = 0.; ///< of the contact in the seat where it is that, rad

    /// The same at the bottom of the seat and at two places above it, upwards; empty: everywhere.
    std::vector<drive::PlacedStiffness> places = {};
    std::vector<double>                 slopes = {}; ///< with places: ToothStrips::slopes()

    /// What of these places' compliance is that of modes with inertia, m/N: it is not here.
    std::array<double, 3> of_modes = {};
  };

  /// Strips of those @p rings of the @p outside, by number, which are so long [m] as @p lengths
  /// tell.
  StripFlexibility(const reduction::RoundFlexibility &outside,
                   const StripGrid                   &grid,
                   const std::vector<unsigned int>   &rings,
                   const std::vector<double>         &lengths,
                   const Material                    &material,
                   const Tooth                       &tooth);

  const StripGrid                 &grid() const { return grid_; }
  const std::vector<unsigned int> &rings() const { return rings_; }
  unsigned int n_rings() const { return static_cast<unsigned int>(rings_.size()); }
  unsigned int n() const { return grid_.size() * n_rings(); }

  /// Of strip i / n_rings(), ring i % n_rings(), and of j the same, m/N.
  double at(const unsigned int i, const unsigned int j) const { return row(i)[j]; }

  /// The same of all j. Seven digits are more than is known of them, and half as much to read.
  const float *row(const unsigned int i) const { return &number_[std::size_t(i) * n()]; }

private:
  /// What an even pressure of one newton on one strip deflects another one by, m/N, by their
  /// numbers in the grid.
  using OfPair = std::function<double(unsigned int, unsigned int)>;

  /// What of a @p tooth, which must outlive it, moves as a whole under rings of this @p length
  /// together, m; @p of_half_space: what one of unit length deflects by in the first harmonic.
  static OfPair seat_of(const Tooth &tooth, double length, double of_half_space);

  StripGrid                 grid_;
  std::vector<unsigned int> rings_;
  std::vector<float>        number_; ///< [strip][ring] twice
};

/// By how much the outside of a roller in strips and its bore at nodes of a bush in it deflect each
/// other without any inertia: through the wall.
class WallFlexibility
{
public:
  /// With the nodes at these @p places between rings of the bore.
  WallFlexibility(const reduction::RoundFlexibility          &outside,
                  const StripGrid                            &grid,
                  const std::vector<unsigned int>            &rings,
                  const std::vector<JointFlexibility::Place> &places);

  /// What all rings of a strip move away from the axis under one newton outwards at each of the
  /// places, at the @p angle [rad] from the middle of the strip: [ring][place], m/N.
  void at(unsigned int strip, double angle, double *value) const;

  /// The same @p n times, at most a whole turn: so far, @p step > 0, from one time to the next:
  /// [time][ring][place].
  void at(unsigned int strip, double angle, double step, unsigned int n, double *value) const;

  unsigned int n_rings() const { return n_rings_; }
  unsigned int n_places() const { return n_places_; }

  /// By how much more at() is for each radian, m/N: [ring][place].
  void slope(unsigned int strip, double angle, double *value) const;

private:
  /// Where an angle is in the part of the table for one strip and ring: after a row, by a part of
  /// the way to the next one.
  struct Place
  {
    unsigned int row;
    double       part;
    double       sign; ///< -1 in the other half of a turn, where rows descend
  };
  double row_of(double angle) const; ///< from 0 to n_turn_, with what is left to the next
  Place  place_of(double row) const;

  /// The rows for one strip, each n_in_row() long.
  const float *table_of(unsigned int strip) const;
  unsigned int n_rows() const { return n_turn_ / 2 + 1; }
  unsigned int n_in_row() const { return n_rings_ * n_places_; }

  unsigned int              n_rings_, n_places_, n_turn_; ///< n_turn_: rows of a turn
  std::vector<unsigned int> width_;                       ///< of each strip, number of its table
  std::vector<float>        table_; ///< [width][angle from 0 to pi][ring][place], as row() above
};
} // namespace chaindrive::contact
