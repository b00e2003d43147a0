// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/stiffness.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <limits>

namespace chaindrive::drive
{
using dealii::numbers::PI;

namespace
{
/// Right-hand side of E' clearance / q = f(b^2), b = tan(half angle / 2).
double persson(const double b2)
{
  return (2. - std::log1p(b2) - 2. * b2 * b2) / (PI * b2 * (1. + b2));
}

/// Pressure times R / q at the angle t from the middle of the contact.
double pressure(const double b2, const double t)
{
  const double y2 = std::pow(std::tan(0.5 * t), 2), s = std::sqrt(1. + b2);
  const double root = std::sqrt(std::max(0., b2 - y2));
  return 2. / (PI * s) * root / (1. + y2) +
         std::log((s + root) / (s - root)) / (2. * PI * b2 * (1. + b2));
}
} // namespace

double line_contact_stiffness(const double length, const Material &steel)
{
  return 0.25 * PI * steel.contact_modulus() * length;
}

double tooth_stiffness(const double width, const Material &steel)
{
  return 2. * line_contact_stiffness(width, steel);
}

ConformingContact conforming_contact(const double    radius,
                                     const double    clearance,
                                     const double    q,
                                     const Material &steel)
{
  // persson() falls from infinity to zero at the contact of a pin without clearance; bisection in
  // the logarithm of b^2, whose range is many decades
  const double modulus = steel.plane_modulus(), target = modulus * clearance / q;
  double       low = std::log(1e-16), high = std::log(0.8345);
  for (int i = 0; i < 100; ++i)
    {
      const double middle                               = 0.5 * (low + high);
      (persson(std::exp(middle)) > target ? low : high) = middle;
    }
  const double      b2 = std::exp(0.5 * (low + high));
  ConformingContact contact;
  contact.half_angle    = 2. * std::atan(std::sqrt(b2));
  contact.peak_pressure = q / radius * pressure(b2, 0.);

  // Under the pressure p_0 + sum p_n cos n t both surfaces together move by 4 R / E' (p_0 / 2 +
  // sum_{n >= 2} n / (n^2 - 1) p_n cos n t). At t = 0 the series sums to an integral over the
  // pressure with the kernel - cos t (ln(2 sin(t/2)) + 1/4) - 1/4. Substituting t = half_angle
  // sin^2(x) tames its logarithm and the root at the end of the contact.
  const dealii::QGauss<1> gauss(60);
  double                  sum = 0.;
  for (unsigned int i = 0; i < gauss.size(); ++i)
    {
      const double x  = 0.5 * PI * gauss.point(i)[0];
      const double t  = contact.half_angle * std::pow(std::sin(x), 2);
      const double dt = contact.half_angle * std::sin(2. * x) * 0.5 * PI * gauss.weight(i);
      sum -=
          pressure(b2, t) * (std::cos(t) * (std::log(2. * std::sin(0.5 * t)) + 0.25) + 0.25) * dt;
    }
  contact.approach = 8. * q / (PI * modulus) * sum;
  return contact;
}

double
contact_modulus(const double radius, const double clearance, const double q, const Material &steel)
{
  const ConformingContact contact = conforming_contact(radius, clearance, q, steel);
  return q / (contact.approach * 2. * contact.half_angle * radius);
}

double working_pressure(const ChainDimensions &chain, const double load)
{
  return std::min(
      breaking_pressure,
      std::max(0.25 * breaking_pressure, 4. * load / (chain.pin_diameter * chain.bush_length)));
}

double largest_half_angle(const double    radius,
                          const double    clearance,
                          const double    pressure,
                          const Material &steel)
{
  return clearance > 0. ?
             conforming_contact(radius, clearance, pressure * 2. * radius, steel).half_angle :
             0.5 * PI;
}

double foundation_of_seat(const double    radius,
                          const double    clearance,
                          const double    length,
                          const double    load,
                          const double    stiffness,
                          const Material &steel)
{
  // half an ellipse, whose mean weighted by itself is 8/(3 pi) of its peak
  const double peak = conforming_contact(radius, clearance, load / length, steel).peak_pressure;
  return stiffness * 8. * peak / (3. * PI * load);
}

double roller_bush_stiffness(const ChainDimensions &c, const double load, const Material &steel)
{
  return load / conforming_contact(
                    0.5 * c.bush_diameter, c.roller_clearance(), load / c.roller_length, steel)
                    .approach;
}

double bush_pin_stiffness(const ChainDimensions &c, const double load, const Material &steel)
{
  return load /
         conforming_contact(0.5 * c.pin_diameter, c.pin_clearance(), load / c.bush_length, steel)
             .approach;
}

double plate_stiffness(const Plate &plate, const Material &steel)
{
  // a bar of the net section from hole to hole
  const dealii::QGauss<1> gauss(4);
  const unsigned int      n      = 500; // the net section has root singularities: many intervals
  const double            length = 0.5 * plate.hole_pitch / n;
  double                  bar    = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int q = 0; q < gauss.size(); ++q)
      bar += 2. * length * gauss.weight(q) / plate.net_height(length * (i + gauss.point(q)[0]));

  // The eyes are curved beams that bend, the more the narrower the waist that holds them. The form
  // R/b (a + c (hole/waist)^2), R mean radius and b width of the strip around the hole, with two
  // constants fits converged plane-stress solutions (cosine pressure on the far half of the holes)
  // of inner and outer plates with waist and without to 3.2 percent of the plate's compliance.
  const double mean  = 0.25 * (plate.height + plate.hole_diameter);
  const double strip = 0.5 * (plate.height - plate.hole_diameter);
  const double neck  = plate.hole_diameter / plate.waist;
  const double eye   = mean / strip * (1.043 + 1.189 * neck * neck);
  return steel.youngs_modulus * plate.thickness / (bar + 2. * eye);
}

double plate_side_stiffness(const Plate &plate, const Material &steel)
{
  const double slenderness = plate.thickness / plate.hole_pitch;
  return 16. * steel.youngs_modulus * plate.waist * slenderness * slenderness * slenderness;
}

double chain_stiffness(const ChainDimensions &c, const double load, const Material &steel)
{
  const double inner = 2. * plate_stiffness(inner_plate(c), steel);
  const double outer = 2. * plate_stiffness(outer_plate(c), steel);
  const double joint = bush_pin_stiffness(c, load, steel);
  return 2. / (1. / inner + 1. / outer + 2. / joint);
}

PartStiffness
estimated_stiffness(const ChainDimensions &chain, const double load, const Material &steel)
{
  return {chain_stiffness(chain, load, steel),
          line_contact_stiffness(chain.roller_length, steel),
          chain.has_rollers ? roller_bush_stiffness(chain, load, steel) :
                              std::numeric_limits<double>::infinity(),
          {},
          {},
          {"Stiffnesses that are auto are estimates from dimensions alone."}};
}
} // namespace chaindrive::drive
