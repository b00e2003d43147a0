// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/tributary_area.h>

#include <deal.II/base/numbers.h>

#include <vector>

namespace chaindrive::contact
{
namespace
{
/// The nodes of the slave along the axis: where they are, what length they stand for, and over
/// which length their force falls to zero at the bore's ends (see covered() in packed_geometry.h),
/// m.
struct AxialRing
{
  double z, length, fade;
};

std::vector<AxialRing> rings_of(const mesh::CylinderGrid &slave)
{
  std::vector<AxialRing> rings;
  const unsigned int     n = slave.n_rings();
  for (unsigned int s = 0; s < n; ++s)
    {
      const bool   end = s == 0 || s + 1 == n;
      const double length =
          0.5 * (slave.rings[std::min(s + 1, n - 1)] - slave.rings[s == 0 ? 0 : s - 1]);
      rings.push_back({slave.rings[s], length, end ? length : 0.5 * length});
    }
  return rings;
}

/// The length of the slave that one ring of a bore carries.
class Carried
{
public:
  Carried(const mesh::CylinderGrid &bore, const unsigned int ring)
      : bore_(bore)
      , begin_(bore.rings.front())
      , end_(bore.rings.back())
      , low_(bore.rings[ring == 0 ? 0 : ring - 1])
      , here_(bore.rings[ring])
      , high_(bore.rings[std::min(ring + 1, bore.n_rings() - 1)])
  {
  }

  /// With the slave moved by @p shift along the axis.
  double operator()(const std::vector<AxialRing> &slave, const double shift) const
  {
    double sum = 0.;
    for (const AxialRing &s : slave)
      {
        const double z = s.z + shift;
        if (z < std::max(low_, begin_) || z > std::min(high_, end_))
          continue;
        const double side = z < here_ ? here_ - low_ : high_ - here_;
        sum += s.length * std::min(1., bore_.depth(z) / s.fade) *
               (side > 0. ? 1. - std::abs(z - here_) / side : 1.);
      }
    return sum;
  }

  /// The largest of all shifts: between those at which a node of the slave passes a kink, it is a
  /// polynomial of second degree.
  double largest(const std::vector<AxialRing> &slave) const
  {
    if (bore_.half)
      return (*this)(slave, 0.);
    std::vector<double> kinks;
    for (const AxialRing &s : slave)
      for (const double at : {low_, here_, high_, begin_ + s.fade, end_ - s.fade})
        kinks.push_back(at - s.z);
    std::sort(kinks.begin(), kinks.end());
    double most = 0.;
    for (unsigned int i = 0; i + 1 < kinks.size(); ++i)
      {
        const double a = kinks[i], b = kinks[i + 1];
        const double f = (*this)(slave, a), g = (*this)(slave, 0.5 * (a + b)),
                     h = (*this)(slave, b), bend = f - 2. * g + h;
        most            = std::max({most, f, g, h});
        const double at = bend < 0. ? 0.25 * (f - h) / bend : 2.; // of b - a, from the middle
        if (std::abs(at) < 0.5)
          most = std::max(most, g - 0.125 * (f - h) * (f - h) / bend);
      }
    return most;
  }

private:
  const mesh::CylinderGrid &bore_;
  double                    begin_, end_, low_, here_, high_;
};
} // namespace

double carried_area(const mesh::CylinderGrid &bore,
                    const unsigned int        ring,
                    const mesh::CylinderGrid &slave)
{
  constexpr double turn = 2. * dealii::numbers::PI;
  return bore.radius *
         carried_length(turn / bore.n_circumferential(), turn / slave.n_circumferential()) *
         Carried(bore, ring).largest(rings_of(slave));
}
} // namespace chaindrive::contact
