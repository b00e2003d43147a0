// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/strip_flexibility.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/std_cxx17/cmath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace chaindrive::contact
{
namespace
{
using dealii::numbers::PI;

/// The mean of cos(k t) over a strip of half width @p w about t = 0, of the harmonic @p k.
double mean_over_strip(const double k, const double w)
{
  const double x = k * w;
  return x < 1e-6 ? 1. : std::sin(x) / x;
}

/// The means of cos(k t) and sin(k t) over each strip of a @p grid, of the harmonics up to a last
/// one.
class StripHarmonics
{
public:
  StripHarmonics(const StripGrid &grid, const unsigned int last) : n_(grid.size())
  {
    for (unsigned int k = 0; k <= last; ++k)
      for (unsigned int a = 0; a < n_; ++a)
        {
          const double mean = mean_over_strip(k, grid.half_width[a]);
          cosine_.push_back(mean * std::cos(k * grid.middle[a]));
          sine_.push_back(mean * std::sin(k * grid.middle[a]));
        }
  }

  /// The mean of cos(k (t - u)) over t in strip @p a and u in @p b.
  double between(const unsigned int k, const unsigned int a, const unsigned int b) const
  {
    return cosine_[k * n_ + a] * cosine_[k * n_ + b] + sine_[k * n_ + a] * sine_[k * n_ + b];
  }

private:
  unsigned int        n_;
  std::vector<double> cosine_, sine_; ///< [k][strip]
};

/// Harmonics [k][ring][ring] of @p values [ring][ring][columns between], those of a unit force at a
/// point.
std::vector<double> harmonics_of(const std::vector<double> &values, const unsigned int n)
{
  const std::size_t   m = values.size() / n;
  std::vector<double> sums((n / 2 + 1) * m, 0.);
  for (unsigned int k = 0; k <= n / 2; ++k)
    for (std::size_t i = 0; i < m; ++i)
      for (unsigned int d = 0; d < n; ++d)
        sums[k * m + i] += values[i * n + d] * std::cos(2. * PI * k * d / n) *
                           ((k == 0 || 2 * k == n ? 1. : 2.) / n);
  return sums;
}

/// The sums of cos(k x) / k^3 over all k from either of two first ones on.
class CubedCosines
{
public:
  explicit CubedCosines(const std::array<unsigned int, 2> &first) : first_(first)
  {
    // zeta of even numbers
    for (unsigned int m = 1; m <= n_terms; ++m)
      {
        double zeta = m == 1 ? PI * PI / 6. : m == 2 ? std::pow(PI, 4) / 90. : 0.;
        for (unsigned int j = 1; m > 2 && j <= 60; ++j)
          zeta += std::pow(j, -2. * m);
        term_[m - 1] = 2. * zeta / (2. * m * (2. * m + 1.) * (2. * m + 2.));
      }
  }

  std::array<double, 2> operator()(const double angle) const
  {
    constexpr double zeta_3 = 1.2020569031595942;
    const double     x = std::abs(std::remainder(angle, 2. * PI)), square = x * x;
    // over all k: the series of the trilogarithm of exp(i x) about x = 0, up to 2 pi
    double series = 0.;
    for (unsigned int m = n_terms; m-- > 0;)
      series = (series + term_[m]) * square / (4. * PI * PI);
    double sum = zeta_3 + (x > 0. ? square * (0.5 * std::log(x) - 0.75) : 0.) - square * series;
    const double          first  = std::cos(x);
    double                before = 1., cosine = first;
    std::array<double, 2> from{};
    for (unsigned int k = 1;; ++k)
      {
        for (unsigned int i = 0; i < from.size(); ++i)
          if (k == first_[i])
            from[i] = sum;
        if (k >= first_[0] && k >= first_[1])
          return from;
        sum -= cosine / (double(k) * k * k);
        const double next = 2. * first * cosine - before;
        before            = cosine;
        cosine            = next;
      }
  }

private:
  static constexpr unsigned int n_terms = 20;

  std::array<unsigned int, 2> first_;
  std::array<double, n_terms> term_{};
};

constexpr unsigned int first_of_tooth = 4; ///< harmonic in which a tooth deflects as a half-space

/// What 1 / k in all harmonics from either of two first ones on makes of even pressures on one
/// strip in another one.
class ShortWaves
{
public:
  ShortWaves(const StripGrid &grid, const std::array<unsigned int, 2> &first)
      : grid_(grid), sum_(first)
  {
  }

  std::array<double, 2> between(const unsigned int a, const unsigned int b) const
  {
    // with sin(k v) sin(k w) cos(k d) as cosines of sums of the angles
    const double d = grid_.middle[a] - grid_.middle[b], v = grid_.half_width[a],
                 w = grid_.half_width[b];
    const auto s = sum_(d + v - w), t = sum_(d - v + w), p = sum_(d + v + w), q = sum_(d - v - w);
    std::array<double, 2> of_both{};
    for (unsigned int i = 0; i < of_both.size(); ++i)
      of_both[i] = s[i] + t[i] - p[i] - q[i];
    return of_both;
  }

private:
  const StripGrid &grid_;
  CubedCosines     sum_;
};
} // namespace

StripFlexibility::StripFlexibility(const reduction::RoundFlexibility &outside,
                                   const StripGrid                   &grid,
                                   const std::vector<unsigned int>   &rings,
                                   const std::vector<double>         &lengths,
                                   const Material                    &material,
                                   const Tooth                       &tooth)
    : grid_(grid), rings_(rings)
{
  if (rings.empty() || rings.size() != lengths.size())
    throw std::logic_error("StripFlexibility: a ring without a length");
  const unsigned int        n_columns = outside.n_columns, m = n_rings(), all = outside.n_rings();
  const std::vector<double> harmonics = harmonics_of(outside.value, n_columns);
  const auto harmonic = [&](const unsigned int k, const unsigned int r, const unsigned int s) {
    return harmonics[(std::size_t(k) * all + rings_[r]) * all + rings_[s]];
  };
  const StripHarmonics on_strips(grid_, n_columns / 2);

  // a half-space of unit length under a force per length: harmonics of 2 / (pi E' k)
  const double        of_half_space = 2. / (PI * material.plane_modulus());
  const double        length        = std::accumulate(lengths.begin(), lengths.end(), 0.);
  std::vector<double> lacking; // what makes the harmonics of the mesh up to it
  for (unsigned int k = n_columns / 4; k <= n_columns / 2; ++k)
    {
      double of_mesh = 0.; // under an even pressure in all rings, as of one of unit length
      for (unsigned int r = 0; r < m; ++r)
        for (unsigned int s = 0; s < m; ++s)
          of_mesh += lengths[r] * harmonic(k, r, s) * lengths[s] / length;
      lacking.push_back(std::max(0., of_half_space / k - of_mesh));
    }
  const ShortWaves short_waves(grid_, {{n_columns / 2 + 1, first_of_tooth}});
  const auto       in_rings = [&](const unsigned int a, const unsigned int b) {
    double of_mesh = 0.;
    for (unsigned int i = 0; i < lacking.size(); ++i)
      of_mesh += lacking[i] * on_strips.between(n_columns / 4 + i, a, b);
    const std::array<double, 2> sum = short_waves.between(a, b);
    const double factor = 0.25 * of_half_space / (grid_.half_width[a] * grid_.half_width[b]);
    return std::array<double, 3>{
        {of_mesh, factor * sum[0], tooth.stiffness > 0. ? factor * sum[1] : 0.}};
  };
  const OfPair seat = tooth.stiffness > 0. ? seat_of(tooth, length, of_half_space) :
                                             [](unsigned int, unsigned int) { return 0.; };

  // The rows of a strip up to its own, which fit into the cache: strips above are as those below,
  // rings of one as well.
  number_.resize(std::size_t(n()) * n());
  std::vector<double> rows;
  for (unsigned int a = 0; a < grid_.size(); ++a)
    {
      const std::size_t n_below = std::size_t(a + 1) * m;
      rows.assign(m * n_below, 0.);
      for (unsigned int b = 0; b <= a; ++b)
        {
          double *const block = &rows[std::size_t(b) * m];
          for (unsigned int k = 0; k <= n_columns / 2; ++k)
            {
              const double part = on_strips.between(k, a, b);
              for (unsigned int r = 0; r < m; ++r)
                for (unsigned int s = 0; s < m; ++s)
                  block[r * n_below + s] += part * harmonic(k, r, s);
            }
          for (const double of_length : in_rings(a, b))
            for (unsigned int r = 0; r < m; ++r)
              block[r * n_below + r] += of_length / lengths[r];
          const double moved = seat(a, b);
          for (unsigned int r = 0; r < m; ++r)
            for (unsigned int s = 0; s < m; ++s)
              block[r * n_below + s] += moved;
        }
      for (std::size_t j = 0; j < n_below; ++j)
        for (unsigned int r = 0; r < m; ++r)
          if (const std::size_t i = std::size_t(a) * m + r; j <= i)
            number_[i * n() + j] = number_[j * n() + i] = static_cast<float>(rows[r * n_below + j]);
    }
}

StripFlexibility::OfPair
StripFlexibility::seat_of(const Tooth &tooth, const double length, const double of_half_space)
{
  // what is left of the whole deflection in the seat, whose pressure is half of an ellipse
  double of_dents = 0.;
  for (unsigned int k = first_of_tooth; k < 1000; ++k)
    {
      const double x = k * tooth.half_angle, mean = 2. * dealii::std_cxx17::cyl_bessel_j(1., x) / x;
      of_dents += of_half_space * mean * mean / (k * length);
    }
  const auto rest = [&](const double stiffness) { return std::max(0., 1. / stiffness - of_dents); };
  if (tooth.places.empty())
    return [everywhere = rest(tooth.stiffness)](unsigned int, unsigned int) { return everywhere; };
  std::array<double, 3> at{}, compliance{};
  for (unsigned int i = 0; i < 3; ++i)
    {
      at[i]         = tooth.places.at(i).angle;
      compliance[i] = std::max(0., rest(tooth.places[i].stiffness) - tooth.of_modes[i]);
    }
  const SeatMotion seat(at,
                        compliance,
                        tooth.half_angle,
                        *std::max_element(tooth.slopes.begin(), tooth.slopes.end()));
  return [seat, &slopes = tooth.slopes](const unsigned int a, const unsigned int b) {
    return seat(slopes.at(a), slopes.at(b));
  };
}

SeatMotion::SeatMotion(const std::array<double, 3> &at,
                       const std::array<double, 3> &compliance,
                       const double                 half_angle,
                       const double                 end)
{
  // means of cos, sin and sin^3 under the pressure; with x = h sin(u) it is even in the angle u
  // after a factor of cos^2 u
  struct Means
  {
    double cosine = 0., sine = 0., cube = 0.;
  };
  std::array<Means, 3>   means;
  constexpr unsigned int n = 200;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < n; ++k)
      {
        const double u = PI * ((k + 0.5) / n - 0.5), share = 2. / n * std::cos(u) * std::cos(u),
                     a = std::clamp(at[i] + half_angle * std::sin(u), -end, end);
        means[i].cosine += share * std::cos(a);
        means[i].sine += share * std::sin(a);
        means[i].cube += share * std::pow(std::sin(a), 3);
      }
  along_ = std::sqrt(compliance[0]) / means[0].cosine;
  std::array<double, 2> wanted{}; // means of f
  for (const unsigned int i : {0u, 1u})
    wanted[i] =
        std::sqrt(std::max(0., compliance[i + 1] - std::pow(along_ * means[i + 1].cosine, 2)));
  const double determinant = means[1].sine * means[2].cube - means[2].sine * means[1].cube;
  first_                   = (wanted[0] * means[2].cube - wanted[1] * means[1].cube) / determinant;
  third_                   = (means[1].sine * wanted[1] - means[2].sine * wanted[0]) / determinant;
}

double SeatMotion::across(const double a) const
{
  const double sine = std::sin(a);
  return sine * (first_ + third_ * sine * sine);
}

double SeatMotion::operator()(const double a, const double b) const
{
  return along_ * along_ * std::cos(a) * std::cos(b) + across(a) * across(b);
}

WallFlexibility::WallFlexibility(const reduction::RoundFlexibility          &outside,
                                 const StripGrid                            &grid,
                                 const std::vector<unsigned int>            &rings,
                                 const std::vector<JointFlexibility::Place> &places)
    : n_rings_(static_cast<unsigned int>(rings.size()))
    , n_places_(static_cast<unsigned int>(places.size()))
    , n_turn_(16 * outside.n_columns)
{
  const unsigned int n_columns = outside.n_columns,
                     n_bore =
                         static_cast<unsigned int>(outside.to_bore.size() / outside.node.size());
  const std::vector<double> harmonics = harmonics_of(outside.to_bore, n_columns);
  const std::size_t         all       = std::size_t(outside.n_rings()) * n_bore;
  std::vector<double>       widths;
  for (const double w : grid.half_width)
    {
      const auto found = std::find(widths.begin(), widths.end(), w);
      width_.push_back(static_cast<unsigned int>(found - widths.begin()));
      if (found == widths.end())
        widths.push_back(w);
    }
  const unsigned int half = n_turn_ / 2; // the other half of a turn is alike
  table_.reserve(widths.size() * n_rows() * n_in_row());
  std::vector<double> of_places(n_places_), part(n_columns / 2 + 1);
  for (const double w : widths)
    for (unsigned int a = 0; a <= half; ++a)
      {
        for (unsigned int k = 0; k <= n_columns / 2; ++k)
          part[k] = mean_over_strip(k, w) * std::cos(k * PI * a / half);
        for (const unsigned int r : rings)
          {
            std::fill(of_places.begin(), of_places.end(), 0.);
            for (unsigned int k = 0; k <= n_columns / 2; ++k)
              for (unsigned int q = 0; q < n_places_; ++q)
                {
                  const JointFlexibility::Place &place = places[q];
                  const double                  *of_ring =
                      &harmonics[k * all + std::size_t(r) * n_bore + place.first];
                  of_places[q] +=
                      part[k] * ((1. - place.part) * of_ring[0] + place.part * of_ring[1]);
                }
            table_.insert(table_.end(), of_places.begin(), of_places.end());
          }
      }
}

inline double WallFlexibility::row_of(const double angle) const
{
  const double turns = angle / (2. * PI), part = turns - static_cast<int>(turns);
  return (part < 0. ? part + 1. : part) * n_turn_;
}

inline WallFlexibility::Place WallFlexibility::place_of(const double row) const
{
  const double half = 0.5 * n_turn_, folded = row > half ? n_turn_ - row : row;
  const auto   before = std::min(static_cast<unsigned int>(folded), n_turn_ / 2 - 1);
  return {before, folded - before, row > half ? -1. : 1.};
}

inline const float *WallFlexibility::table_of(const unsigned int strip) const
{
  return &table_[std::size_t(width_[strip]) * n_rows() * n_in_row()];
}

void WallFlexibility::at(const unsigned int strip, const double angle, double *value) const
{
  const Place        place = place_of(row_of(angle));
  const unsigned int n     = n_in_row();
  const float       *from  = table_of(strip) + std::size_t(place.row) * n;
  const double       rest  = 1. - place.part;
  for (unsigned int i = 0; i < n; ++i)
    value[i] = rest * from[i] + place.part * from[n + i];
}

void WallFlexibility::at(const unsigned int strip,
                         const double       angle,
                         const double       step,
                         const unsigned int n,
                         double            *value) const
{
  const unsigned int m     = n_in_row();
  const float       *table = table_of(strip);
  const double       rows = step / (2. * PI) * n_turn_, all = n_turn_, first = row_of(angle);
  double             row = first;
  for (unsigned int k = 0; k < n; ++k, value += m)
    {
      const Place  place = place_of(row);
      const float *from  = table + std::size_t(place.row) * m;
      const double rest  = 1. - place.part;
      for (unsigned int i = 0; i < m; ++i)
        value[i] = rest * from[i] + place.part * from[m + i];
      row = first + (k + 1) * rows;
      if (row >= all)
        row -= all;
    }
}

void WallFlexibility::slope(const unsigned int strip, const double angle, double *value) const
{
  const Place        place = place_of(row_of(angle));
  const unsigned int n     = n_in_row();
  const float       *from  = table_of(strip) + std::size_t(place.row) * n;
  for (unsigned int i = 0; i < n; ++i)
    value[i] = place.sign * (double(from[n + i]) - from[i]) * n_turn_ / (2. * PI);
}
} // namespace chaindrive::contact
