// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/arc_flanks.h>
#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
namespace
{
/// The interval of ascending @p values that holds @p x, or the nearest one.
unsigned int interval(const std::vector<double> &values, const double x)
{
  const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, x);
  return static_cast<unsigned int>(above - values.begin()) - 1;
}

double polar_angle(const dealii::Tensor<1, 2> &p) { return std::atan2(p[1], p[0]); }

/// Half the distance between the neighbours of entry @p i in a line of points @p distance(i) [m]
/// apart; at its ends the one distance there is.
template <typename Distance>
double half_spacing(const unsigned int i, const unsigned int n, const Distance &distance)
{
  if (i == 0)
    return distance(0);
  return i + 1 == n ? distance(i - 1) : 0.5 * (distance(i - 1) + distance(i));
}
} // namespace

ArcFlanks::ArcFlanks(const scene::ToothFamily &family, const World &world, const Rim &rim)
    : ElasticFlanks(family, rim)
{
  const BodyBatches       &copies = world.copies[group_];
  const mesh::SurfaceNodes flanks(*copies.part, copies.nodes, mesh::tooth_flanks);

  // The nodes of one sector's flank form a grid: sorted by layer along the axis and by polar angle.
  for (const unsigned int n : flanks.node)
    z_.push_back(copies.nodes.position[n][2]);
  std::sort(z_.begin(), z_.end());
  const double same = 1e-6 * (z_.back() - z_.front());
  z_.erase(std::unique(z_.begin(), z_.end(), [same](double a, double b) { return b - a < same; }),
           z_.end());

  nodes_            = flanks.node;
  const auto key_of = [&](const unsigned int n) {
    const dealii::Point<3>    &x = copies.nodes.position[n];
    const dealii::Tensor<1, 2> p = dealii::Point<2>(x[0], x[1]);
    const auto layer             = std::lower_bound(z_.begin(), z_.end(), x[2] - same) - z_.begin();
    return std::make_pair(layer, polar_angle(p));
  };
  std::sort(nodes_.begin(), nodes_.end(), [&](const unsigned int a, const unsigned int b) {
    return key_of(a) < key_of(b);
  });
  for (unsigned int c = 0; c < nodes_.size() / z_.size(); ++c)
    {
      const dealii::Point<3> &x = copies.nodes.position[nodes_[c]];
      column_.push_back(dealii::Point<2>(x[0], x[1]));
      angle_.push_back(polar_angle(column_.back()));
    }
  for (unsigned int s = 0; s < copies.n_copies(); ++s)
    for (const unsigned int n : nodes_)
      place_.push_back(copies.index(s, n));
  Assert(column_.size() * z_.size() == nodes_.size(), dealii::ExcInternalError());
}

ElasticFlanks::Facet ArcFlanks::nearest(const dealii::Tensor<1, 3> &x,
                                        const double,
                                        unsigned int &,
                                        Projection &projection) const
{
  const auto                  profile  = family_.form->closest_point(dealii::Point<2>(x[0], x[1]));
  const dealii::Tensor<1, 2> &turn     = family_.form->rotations[profile.tooth_gap];
  const auto                  unturned = [&turn](const dealii::Tensor<1, 2> &p) {
    return dealii::Point<2>(turn[0] * p[0] + turn[1] * p[1], turn[0] * p[1] - turn[1] * p[0]);
  };
  const auto turned = [&turn](const dealii::Tensor<1, 2> &p, const double z) {
    return dealii::Point<3>(turn[0] * p[0] - turn[1] * p[1], turn[1] * p[0] + turn[0] * p[1], z);
  };

  // The facet in sector 0 and where the point meets it. The profile's point P is the one of the
  // arcs that is nearest to x; the facet is the one between the two columns of nodes whose polar
  // angles enclose P's. Weights are bilinear: xi along the facet's chord, where P is projected onto
  // it, eta along the axis.
  const dealii::Tensor<1, 2> local = unturned(profile.point);
  const unsigned int         c = interval(angle_, polar_angle(local)), k = interval(z_, x[2]);
  const dealii::Tensor<1, 2> chord  = column_[c + 1] - column_[c];
  const double               length = chord.norm(), height = z_[k + 1] - z_[k];
  const double xi  = std::clamp((local - column_[c]) * chord / (length * length), 0., 1.);
  const double eta = std::clamp((x[2] - z_[k]) / height, 0., 1.);

  const unsigned int s = profile.tooth_gap;
  projection.nodes     = {
          {place(s, c, k), place(s, c + 1, k), place(s, c, k + 1), place(s, c + 1, k + 1)}};
  projection.twins = {{twin(s, c, k), twin(s, c + 1, k), twin(s, c, k + 1), twin(s, c + 1, k + 1)}};
  projection.weights = {{(1. - xi) * (1. - eta), xi * (1. - eta), (1. - xi) * eta, xi * eta}};

  Facet facet;
  facet.found     = true;
  facet.distance  = profile.distance;
  facet.normal[0] = profile.normal[0];
  facet.normal[1] = profile.normal[1];
  facet.feature   = profile.tooth_gap;

  // xi changes by chord / |chord|^2 per metre, eta by 1 / height, and not at all beyond the last
  // layer
  const dealii::Tensor<1, 3> along  = turned(chord / (length * length), 0.);
  const double               across = x[2] > z_.front() && x[2] < z_.back() ? 1. / height : 0.;
  for (unsigned int i = 0; i < 4; ++i)
    {
      const bool beyond = i % 2 == 1, above = i / 2 == 1; // in the next column, in the next layer
      facet.nodes[i]        = turned(column_[c + i % 2], z_[k + i / 2]);
      facet.gradients[i]    = (beyond ? 1. : -1.) * (above ? eta : 1. - eta) * along;
      facet.gradients[i][2] = (above ? 1. : -1.) * (beyond ? xi : 1. - xi) * across;
    }
  return facet;
}

std::vector<BodyBatches::Place> ArcFlanks::nodes_of_gap(const unsigned int gap) const
{
  const unsigned int              last = angle_.size() - 1, n = place_.size() / nodes_.size();
  std::vector<BodyBatches::Place> places;
  for (unsigned int k = 0; k < z_.size(); ++k)
    {
      for (unsigned int c = 0; c <= last; ++c)
        places.push_back({gap, node(c, k)});
      places.push_back({(gap + n - 1) % n, node(last, k)});
      places.push_back({(gap + 1) % n, node(0, k)});
    }
  return places;
}

ClosedSide ArcFlanks::closed_side(const World              &world,
                                  const double              stiffness,
                                  const mesh::SurfaceNodes &slaves,
                                  const BodyBatches        &of_slaves) const
{
  const BodyBatches  &flanks    = world.copies[group_];
  const TributaryArea slave     = largest_share(slaves, of_slaves);
  const unsigned int  n_columns = column_.size(), n_layers = z_.size();
  ClosedSide          side;
  side.group   = group_;
  side.surface = mesh::tooth_flanks;
  side.stiffness.resize(flanks.n_nodes());
  for (unsigned int c = 0; c < n_columns; ++c)
    for (unsigned int layer = 0; layer < n_layers; ++layer)
      {
        TributaryArea share;
        share.across = half_spacing(c, n_columns, [&](const unsigned int i) {
          return (column_[i + 1] - column_[i]).norm();
        });
        share.along =
            half_spacing(layer, n_layers, [&](const unsigned int i) { return z_[i + 1] - z_[i]; });
        // a node between two sectors has half of its mass and of its springs in each
        const double half = c == 0 || c + 1 == n_columns ? 0.5 : 1.;
        const double k    = half * stiffness * carried_area(share, slave);
        side.add_spring(node(c, layer), k, flanks.nodes.mass[node(c, layer)]);
      }
  return side;
}
} // namespace chaindrive::contact
