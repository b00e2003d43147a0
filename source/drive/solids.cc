// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/solids.h>

#include <deal.II/base/numbers.h>

namespace chaindrive::drive
{
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
Tensor<2, 3> diagonal(const double x, const double y, const double z)
{
  Tensor<2, 3> result;
  result[0][0] = x;
  result[1][1] = y;
  result[2][2] = z;
  return result;
}

/// Inertia about the origin of a point mass at @p x: m (x.x 1 - x x).
Tensor<2, 3> point_inertia(const double mass, const Tensor<1, 3> &x)
{
  Tensor<2, 3> result = diagonal(1., 1., 1.);
  result *= mass * x.norm_square();
  return result - mass * dealii::outer_product(x, x);
}

/// A body of constant thickness along z whose area has the moments @p ix = int y^2 dA and
/// @p iy = int x^2 dA.
MassProperties slab(const double area,
                    const double ix,
                    const double iy,
                    const double thickness,
                    const double density)
{
  MassProperties body;
  body.mass           = density * area * thickness;
  const double across = body.mass * thickness * thickness / 12.;
  const double per    = density * thickness;
  body.inertia        = diagonal(per * ix + across, per * iy + across, per * (ix + iy));
  return body;
}

Tensor<1, 3> vector(const double x, const double z)
{
  Tensor<1, 3> v;
  v[0] = x;
  v[2] = z;
  return v;
}

MassProperties link(const MassProperties &plate,
                    const double          plate_z,
                    const MassProperties &tube,
                    const double          hole_pitch)
{
  MassProperties body;
  for (const double side : {-1., 1.})
    {
      body += plate.moved(vector(0., side * plate_z));
      body += tube.moved(vector(side * 0.5 * hole_pitch, 0.));
    }
  return body;
}
} // namespace

MassProperties &MassProperties::operator+=(const MassProperties &other)
{
  const double total = mass + other.mass;
  if (total == 0.)
    return *this;
  const dealii::Point<3> both = centre + other.mass / total * (other.centre - centre);
  inertia += other.inertia + point_inertia(mass, centre - both) +
             point_inertia(other.mass, other.centre - both);
  mass   = total;
  centre = both;
  return *this;
}

MassProperties MassProperties::moved(const Tensor<1, 3> &shift) const
{
  MassProperties result = *this;
  result.centre += shift;
  return result;
}

MassProperties
tube(const double diameter, const double bore, const double length, const double density)
{
  const double outer = diameter * diameter, inner = bore * bore;
  const double moment = PI / 64. * (outer * outer - inner * inner);
  return slab(0.25 * PI * (outer - inner), moment, moment, length, density);
}

MassProperties roller_solid(const ChainDimensions &c, const double density)
{
  return tube(c.roller_diameter, c.roller_bore, c.roller_length, density);
}

MassProperties bush_solid(const ChainDimensions &c, const double density)
{
  return tube(c.bush_diameter, c.bush_bore, c.bush_length, c.link_density_factor * density);
}

MassProperties pin_solid(const ChainDimensions &c, const double density)
{
  return tube(c.pin_diameter, c.pin_bore, c.pin_length, c.link_density_factor * density);
}

MassProperties plate_solid(const Plate &plate, const double density)
{
  return slab(
      plate.area(), plate.moment_about_x(), plate.moment_about_y(), plate.thickness, density);
}

MassProperties inner_link_solid(const ChainDimensions &c, const double density)
{
  return link(plate_solid(inner_plate(c), c.link_density_factor * density),
              c.inner_plate_z,
              bush_solid(c, density),
              c.inner_hole_pitch);
}

MassProperties outer_link_solid(const ChainDimensions &c, const double density)
{
  return link(plate_solid(outer_plate(c), c.link_density_factor * density),
              c.outer_plate_z,
              pin_solid(c, density),
              c.outer_hole_pitch);
}

MassProperties
sprocket_solid(const ToothForm &form, const double bore, const double width, const double density)
{
  // three or more teeth alike: both moments about diameters are half of the polar one
  const double square = bore * bore;
  const double moment = 0.5 * (form.polar_moment() - PI / 32. * square * square);
  return slab(form.area() - 0.25 * PI * square, moment, moment, width, density);
}
} // namespace chaindrive::drive
