// SPDX-License-Identifier: LGPL-2.1-or-later
// Searches by distance measure those columns alone that may be near. A bush wanders in the bore of
// a roller and turns in it, in each of two lanes its own way. Its windows must be those of searches
// that measure all columns, though nodes that a search has not announced are nowhere then.
#include "../support/joint.h"

#include <array>
#include <limits>

using namespace test;

namespace
{
constexpr unsigned int n_joints  = 2;
constexpr double       clearance = 45e-6; // m

struct Pair
{
  Pair()
      : ring(tube(3.76e-3, 5.08e-3, 7e-3, {{1, 32, 3}}), mesh::roller_bore)
      , bush(tube(2.6e-3, 3.715e-3, 6.2e-3, {{1, 40, 4}}), mesh::bush_outside_first)
      , tables(ring.grid, bush.grid)
      , joints(tables, {4e13, 0., 0., 3e13, 0.}, *contact::joint_kernels(2))
  {
    for (unsigned int lane = 0; lane < n_joints; ++lane)
      joints.set_joint(static_cast<int>(lane), ring.body(lane), bush.body(lane));
  }

  /// Bush and ring of a lane.
  void place(const unsigned int lane, const Tensor<1, 3> &at, const double angle)
  {
    ring.place(lane, Tensor<1, 3>(), turn_about_z(0.3));
    bush.place(lane, at, turn_about_z(angle));
  }

  /// Puts nodes that a search does not read to nowhere; returns the columns of bushes that it does.
  unsigned int hide_others()
  {
    unsigned int n_read = 0;
    for (unsigned int lane = 0; lane < n_joints; ++lane)
      for (const bool of_bush : {false, true})
        {
          Tubes            &tubes = of_bush ? bush : ring;
          const auto        n     = tubes.grid.n_circumferential();
          std::vector<char> read(n, 0);
          joints.mark_wanted(static_cast<int>(lane), of_bush, read);
          for (unsigned int c = 0; c < n; ++c)
            {
              n_read += of_bush && read[c] != 0 ? 1 : 0;
              for (unsigned int s = 0; s < tubes.grid.n_rings(); ++s)
                if (const bool of_axis = !of_bush && c % joints.grid().axis_stride == 0 &&
                                         (s == 0 || s + 1 == tubes.grid.n_rings());
                    read[c] == 0 && !of_axis)
                  for (unsigned int i = 0; i < 3; ++i)
                    tubes.batch.position[Batch::index(tubes.node(s, c), i, lane)] =
                        std::numeric_limits<double>::quiet_NaN();
            }
        }
    return n_read;
  }

  Tubes                ring, bush;
  contact::JointTables tables;
  contact::JointBatch  joints;
};

/// Where the bush of a lane is in step @p n: on a path that spirals in and out of contact, with a
/// pause in which nothing moves; it vibrates on it.
Tensor<1, 3> place_of(const unsigned int lane, const unsigned int n)
{
  const double t = (n < 900 ? n : n < 1000 ? 900 : n - 100) * (lane == 0 ? 1. : 1.7);
  const double distance =
                   clearance * (0.55 + 0.46 * std::sin(0.011 * t)) + 1.5e-6 * std::sin(2. * t),
               way = 0.013 * t;
  return vector(distance * std::cos(way), distance * std::sin(way));
}

double angle_of(const unsigned int lane, const unsigned int n)
{
  return lane == 0 ? 0.0005 * n : -0.004 * n;
}
} // namespace

int main()
{
  constexpr double reach = 8e-6; // m
  Pair             all, chosen;
  unsigned int n_searches = 0, n_read = 0, n_near = 0, n_different = 0, n_missed = 0, searched = 0,
               n_renewed = 0;
  bool grew              = false;
  for (unsigned int n = 0; n < 4000; ++n)
    {
      double moved = 0.; // as NodeBores::moved()
      for (unsigned int lane = 0; lane < n_joints; ++lane)
        {
          all.place(lane, place_of(lane, n), angle_of(lane, n));
          chosen.place(lane, place_of(lane, n), angle_of(lane, n));
          if (n > 0)
            {
              const double turned = std::abs(angle_of(lane, n) - angle_of(lane, n - 1));
              moved               = std::max(moved,
                               (place_of(lane, n) - place_of(lane, n - 1)).norm() +
                                   (clearance + reach * 40. / PI) * turned);
            }
        }
      if (n_searches > 0 && all.joints.search_due(moved))
        {
          double since = 0.; // the search, as NodeBores::left()
          for (unsigned int lane = 0; lane < n_joints; ++lane)
            since = std::max(since,
                             (place_of(lane, n) - place_of(lane, searched)).norm() +
                                 (clearance + reach * 40. / PI) *
                                     std::abs(angle_of(lane, n) - angle_of(lane, searched)));
          if (since < 0.75 * reach)
            {
              all.joints.renew(reach - since + moved);
              chosen.joints.renew(reach - since + moved);
              ++n_renewed;
            }
        }
      if (all.joints.search_due(moved) != chosen.joints.search_due(moved))
        throw std::runtime_error("one of the searches is due");
      if (all.joints.search_due(moved))
        {
          const double margin = 2. * moved;
          chosen.joints.choose_columns(reach, margin, moved);
          n_read += chosen.hide_others();
          n_missed += all.joints.search(reach, {}, margin);
          n_missed += chosen.joints.search(reach, {}, margin);
          ++n_searches;
          searched = n;
          for (unsigned int lane = 0; lane < n_joints; ++lane)
            {
              const contact::JointWindow &a = all.joints.window(), &b = chosen.joints.window();
              n_different += a.count[lane] != b.count[lane] ||
                                     (a.count[lane] > 0 && a.first[lane] != b.first[lane]) ?
                                 1 :
                                 0;
              n_near += a.count[lane];
              grew = grew || (n > 1000 && a.count[lane] > 4);
              chosen.place(lane, place_of(lane, n), angle_of(lane, n));
            }
        }
      all.joints.add_forces(n > 0 ? 1e-6 : 0., moved);
      chosen.joints.add_forces(n > 0 ? 1e-6 : 0., moved);
    }
  double force = 0.;
  for (unsigned int i = 0; i < all.joints.state().size(); ++i)
    force = std::max(force, std::abs(all.joints.state()[i] - chosen.joints.state()[i]));
  const double columns = double(n_searches) * n_joints * 40;
  verdict("hundreds of searches, some of which find what touches", n_searches > 300 && grew);
  verdict("windows as if all columns were measured", n_different == 0);
  verdict("forces too, to the last bit", force == 0.);
  verdict("nothing missed", n_missed == 0);
  verdict("searches that went on, since what moves had come back", n_renewed > 100);
  verdict("fewer than 0.7 of the columns measured", n_read < 0.7 * columns);
  verdict("more than are in windows", n_read > n_near);
}
