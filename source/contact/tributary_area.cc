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
struct Station
{
  double z, length, fade;
};

std::vector<Station> stations_of(const mesh::CylinderGrid &slave)
{
  std::vector<Station> stations;
  const unsigned int   n = slave.n_stations();
  for (unsigned int s = 0; s < n; ++s)
    {
      const bool   end = s == 0 || s + 1 == n;
      const double length =
          0.5 * (slave.stations[std::min(s + 1, n - 1)] - slave.stations[s == 0 ? 0 : s - 1]);
      stations.push_back({slave.stations[s], length, end ? length : 0.5 * length});
    }
  return stations;
}

/// The length of the slave that one station of a bore carries.
class Carried
{
public:
  Carried(const mesh::CylinderGrid &bore, const unsigned int station)
      : bore_(bore)
      , begin_(bore.stations.front())
      , end_(bore.stations.back())
      , low_(bore.stations[station == 0 ? 0 : station - 1])
      , here_(bore.stations[station])
      , high_(bore.stations[std::min(station + 1, bore.n_stations() - 1)])
  {
  }

  /// With the slave moved by @p shift along the axis.
  double operator()(const std::vector<Station> &slave, const double shift) const
  {
    double sum = 0.;
    for (const Station &s : slave)
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
  double largest(const std::vector<Station> &slave) const
  {
    if (bore_.half)
      return (*this)(slave, 0.);
    std::vector<double> kinks;
    for (const Station &s : slave)
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
                    const unsigned int        station,
                    const mesh::CylinderGrid &slave)
{
  constexpr double turn = 2. * dealii::numbers::PI;
  return bore.radius * carried_length(turn / bore.n_columns(), turn / slave.n_columns()) *
         Carried(bore, station).largest(stations_of(slave));
}
} // namespace chaindrive::contact
