// SPDX-License-Identifier: LGPL-2.1-or-later
// A pin in a hole of a large plate with a little clearance, pressed against its side in plane
// strain: the pressures against Persson's closed form for conforming contact (1964; Ciavarella and
// Decuzzi 2001), at two loads and on three meshes. With the half angle of contact eps and
// b = tan(eps/2),
//
//   E' dR / Q = (2 - ln(1 + b^2) - 2 b^4) / (pi b^2 (1 + b^2)),
//   R p / Q   = 2 sqrt(b^2 - y^2) / (pi sqrt(1 + b^2) (1 + y^2))
//               + ln((s + q) / (s - q)) / (2 pi b^2 (1 + b^2)),
//
// y = tan(theta/2), s = sqrt(1 + b^2), q = sqrt(b^2 - y^2), E' = E / (1 - nu^2). It takes the radii
// of pin and hole for the same, which here leaves 1.2 % open. Bodies are at rest (see
// support/statics.h), contact is that of the joints; the load per length is the one that the joint
// reports.
#include "../support/joint_statics.h"

using namespace test;

namespace
{
const double R = 3.715e-3, clearance = 45e-6, thickness = 0.2e-3;

/// The plate is half as thick again as the pin, whose ends are then well inside the bore, and its
/// modulus that much smaller: per length of the pin it is the same plate.
const double longer = 1.5;

/// A tube whose layers become thicker by the factor @p growth, from the side of contact on.
mesh::Part graded(const double contact, const double far, const double length, const unsigned int n)
{
  const double       growth = 1.3, first = contact * 2. * PI / n;
  const unsigned int layers = static_cast<unsigned int>(
      std::ceil(std::log(1. + std::abs(far - contact) * (growth - 1.) / first) / std::log(growth)));
  const double low = std::min(contact, far), high = std::max(contact, far);
  mesh::Part   part = tube(low, high, length, {{layers, n, 1}});
  dealii::GridTools::transform(
      [&](const Point<3> &x) {
        const double r   = std::hypot(x[0], x[1]);
        const double way = (std::pow(growth, layers * (r - contact) / (far - contact)) - 1.) /
                           (std::pow(growth, layers) - 1.);
        const double factor = (contact + (far - contact) * way) / r;
        return Point<3>(factor * x[0], factor * x[1], x[2]);
      },
      *part.mesh);
  return part;
}

/// Persson's contact under the load @p Q [N/m].
struct Persson
{
  Persson(const double Q, const double modulus) : Q(Q)
  {
    double low = 1e-6, high = 0.9; // b^2
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double b2 = 0.5 * (low + high);
        const double load =
            (2. - std::log1p(b2) - 2. * b2 * b2) / (PI * b2 * (1. + b2)); // falls with b
        (load > modulus * clearance / Q ? low : high) = b2;
      }
    b = std::sqrt(low);
  }
  double half_angle() const { return 2. * std::atan(b); }
  double pressure(const double theta) const
  {
    const double y = std::tan(0.5 * theta), b2 = b * b;
    if (std::abs(theta) >= half_angle())
      return 0.;
    const double s = std::sqrt(1. + b2), q = std::sqrt(b2 - y * y);
    return Q / R *
           (2. * q / (PI * s * (1. + y * y)) +
            std::log((s + q) / (s - q)) / (2. * PI * b2 * (1. + b2)));
  }
  /// The mean about @p theta with a weight that falls to zero at @p column on either side: what
  /// the force of a node stands for.
  double mean_pressure(const double theta, const double column) const
  {
    const unsigned int n   = 400;
    double             sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double t = -1. + (2. * i + 1.) / n;
        sum += (1. - std::abs(t)) * pressure(theta + t * column) * 2. / n;
      }
    return sum;
  }

  double Q, b;
};
} // namespace

int main()
{
  parameters::Material material;
  const double         E = material.youngs_modulus, nu = material.poissons_ratio;
  const double         plane_strain = E / (1. - nu * nu);
  for (const double pressed : {6e-6, 30e-6})
    for (const unsigned int n : {32u, 64u, 96u})
      {
        const mesh::Part pin_part = graded(R, 0.05 * R, thickness, n);
        Tubes            pin(pin_part, mesh::bush_outside_first);
        material.youngs_modulus     = E / longer;
        const mesh::Part plate_part = graded(R + clearance, 12. * R, longer * thickness, n);
        Tubes            plate(plate_part,
                    mesh::roller_bore,
                    element::best_kernels(),
                    Formulation::enhanced,
                    material);
        material.youngs_modulus = E;

        pin.place(0, vector(clearance, 0.), turn_about_z(0.)); // it just touches
        plate.place(0, vector(0., 0.), turn_about_z(0.));
        JointAtRest joint(plate, pin, 20. * E / (R * 2. * PI / n));
        Statics    &statics = joint.statics;
        for (unsigned int b = 0; b < 2; ++b)
          for (unsigned int i = statics.first[b]; i < statics.first[b + 1]; i += 3)
            {
              const unsigned int node = (i - statics.first[b]) / 3;
              const Point<3>    &x    = (b == 0 ? plate : pin).reference.position[node];
              const double       r    = std::hypot(x[0], x[1]);
              statics.held[i + 2]     = true;
              statics.held[i] = statics.held[i + 1] = r < 0.051 * R || r > 11.99 * R;
              if (b == 1)
                statics.u[i] = pressed;
            }
        const bool    found = joint.solve([](const Point<3> &x) { return x[0] > 0.2 * R; }, 1e-6);
        const double  Q     = joint.force() / thickness;
        const Persson persson(Q, plane_strain);

        double difference = 0., norm = 0., top = 0., greatest = 0., edge = 0.;
        for (unsigned int column = 0; column < n; ++column)
          {
            const double p        = joint.normal_force(0, column) / pin.grid.area(0, column);
            const double theta    = std::remainder(pin.grid.angles[column], 2. * PI);
            const double expected = persson.mean_pressure(theta, 2. * PI / n);
            difference += (p - expected) * (p - expected);
            norm += expected * expected;
            greatest = std::max(greatest, expected);
            top      = std::max(top, p);
            if (p > 1e-2 * persson.pressure(0.))
              edge = std::max(edge, std::abs(theta));
          }
        std::cout << "pressed in by " << 1e6 * pressed << " um, " << n << " columns: half angle "
                  << std::fixed << std::setprecision(1) << persson.half_angle() * 180. / PI
                  << " degrees; greatest pressure over Persson's " << std::setprecision(3)
                  << top / greatest << ", error of all pressures " << std::sqrt(difference / norm)
                  << std::defaultfloat << '\n';
        verdict("  at rest", found);
        verdict("  touching as far as Persson's to a column",
                std::abs(edge - persson.half_angle()) < 2. * PI / n);
      }
}
