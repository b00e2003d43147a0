// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::scene
{
Tensor3 normal_of_wheel(const drive::Drive &drive, const unsigned int i)
{
  const drive::Sprocket &wheel = drive.sprockets[i];
  Tensor3                normal;
  normal[0] = std::sin(wheel.tilt) * std::cos(wheel.tilt_direction);
  normal[1] = drive.layout.sense * std::sin(wheel.tilt) * std::sin(wheel.tilt_direction);
  normal[2] = std::cos(wheel.tilt);
  return normal;
}

namespace
{
Tensor3 in_space(const dealii::Tensor<1, 2> &v)
{
  Tensor3 result;
  result[0] = v[0];
  result[1] = v[1];
  return result;
}

Tensor3 along_z()
{
  Tensor3 z;
  z[2] = 1.;
  return z;
}

Tensor3 z_of(const Frame &frame) { return frame.rotation * along_z(); }

/// The shortest rotation that takes z to @p axis, which is no opposite of it.
dealii::Tensor<2, 3> from_z_to(const Tensor3 &axis)
{
  const Tensor3 about = cross_product_3d(along_z(), axis);
  const double  sine  = about.norm();
  if (sine == 0.)
    return to_matrix(Quaternion());
  return to_matrix(rotation_by(std::atan2(sine, axis[2]) / sine * about));
}

/// The plane of a wheel: what was in that of the drive goes there.
struct WheelPlane
{
  WheelPlane(const drive::Drive &drive, const unsigned int i)
      : axis(drive.layout.sprockets[i].axis())
  {
    offset = drive.sprockets[i].axial_offset;
    normal = normal_of_wheel(drive, i);
    turn   = from_z_to(normal);
  }

  Tensor3 displacement(const dealii::Point<2> &p) const
  {
    const Tensor3 arm    = in_space(p - axis);
    Tensor3       result = turn * arm - arm;
    result[2] += offset;
    return result;
  }

  dealii::Point<2>     axis; ///< of its shaft in the plane of the drive, m
  double               offset;
  Tensor3              normal; ///< unit
  dealii::Tensor<2, 3> turn;
};

/// Where a joint has gone: all that is at it goes with it.
struct Place
{
  Tensor3 displacement, velocity; ///< m, m/s
  Tensor3 normal;                 ///< of the plane of the chain there, unit
};

Place on_wheel(const WheelPlane &plane, const drive::Layout::Joint &joint)
{
  return {plane.displacement(joint.bush), plane.turn * in_space(joint.velocity), plane.normal};
}

/// Refuses spans that run on askew by more than teeth guide.
void check_span(const drive::Drive                      &drive,
                const unsigned int                       i,
                const Tensor3                           &along,
                const std::initializer_list<WheelPlane> &planes)
{
  constexpr double most = 3. * dealii::numbers::PI / 180.;
  for (const WheelPlane &plane : planes)
    if (const double angle = std::asin(std::abs(along * plane.normal) / along.norm());
        !(angle <= most))
      throw InputError("Drive/Wheels: by Axial offset in mm and Tilt in degrees of " +
                       drive.sprockets[i].name + " and " +
                       drive.sprockets[(i + 1) % drive.sprockets.size()].name +
                       " the chain between them would run askew to a wheel by " +
                       to_text(180. / dealii::numbers::PI * angle, 3) +
                       " degrees; teeth guide it up to 3: choose smaller ones.");
}

/// Where all joints have gone.
std::vector<Place> places(const drive::Drive &drive)
{
  const drive::Layout    &layout = drive.layout;
  const auto              n      = static_cast<unsigned int>(layout.joints.size());
  std::vector<WheelPlane> planes;
  for (unsigned int i = 0; i < drive.sprockets.size(); ++i)
    planes.emplace_back(drive, i);

  std::vector<Place> all(n);
  for (unsigned int k = 0; k < n; ++k)
    if (const int wheel = layout.joints[k].sprocket; wheel >= 0)
      all[k] = on_wheel(planes[wheel], layout.joints[k]);
  for (unsigned int i = 0; i < layout.spans.size(); ++i)
    {
      const drive::Layout::Span  &span = layout.spans[i];
      const WheelPlane           &from = planes[i], &to = planes[(i + 1) % planes.size()];
      const drive::Layout::Joint &first = layout.joints[span.first],
                                 &last  = layout.joints[(span.first + span.links) % n];
      const Place   a = on_wheel(from, first), b = on_wheel(to, last);
      const Tensor3 rise  = b.displacement - a.displacement;
      const Tensor3 along = in_space(last.bush - first.bush);
      check_span(drive, i, along + rise, {from, to});
      // what the planes of the wheels ask for at the ends, over the whole span
      const auto in_plane = [&](const WheelPlane &plane, const unsigned int link) {
        const Tensor3 step =
            in_space(layout.joints[(link + 1) % n].bush - layout.joints[link % n].bush);
        return span.links * (plane.turn * step - step);
      };
      const Tensor3 leave = in_plane(from, span.first),
                    enter = in_plane(to, span.first + span.links - 1);
      for (unsigned int m = 1; m < span.links; ++m)
        {
          const drive::Layout::Joint &joint = layout.joints[(span.first + m) % n];
          const double                s     = static_cast<double>(m) / span.links;
          // Hermite's cubic polynomials and their derivatives
          const Tensor3 displacement = a.displacement + s * s * (3. - 2. * s) * rise +
                                       s * (1. - s) * ((1. - s) * leave - s * enter),
                        slope = 6. * s * (1. - s) * rise + (1. - s) * (1. - 3. * s) * leave -
                                s * (2. - 3. * s) * enter;
          const Tensor3 v      = in_space(joint.velocity);
          Tensor3       normal = (1. - s) * a.normal + s * b.normal;
          normal /= normal.norm();
          all[(span.first + m) % n] = {
              displacement, v + v * along / along.norm_square() * slope, normal};
        }
    }
  return all;
}

/// The frame of the link from @p a to @p b [m], whose joints move as their places say: its x axis
/// points from joint to joint.
Frame frame_of_link(const Tensor3 &a, const Tensor3 &b, const Place &at_a, const Place &at_b)
{
  Tensor3      x      = b - a;
  const double length = x.norm();
  x /= length;
  Tensor3 z = at_a.normal + at_b.normal;
  z -= (z * x) * x;
  z /= z.norm();
  const Tensor3 y = cross_product_3d(z, x);
  Frame         frame;
  frame.position         = 0.5 * (a + b);
  frame.velocity         = 0.5 * (at_a.velocity + at_b.velocity);
  frame.angular_velocity = cross_product_3d(x, at_b.velocity - at_a.velocity) / length;
  for (unsigned int d = 0; d < 3; ++d)
    {
      frame.rotation[d][0] = x[d];
      frame.rotation[d][1] = y[d];
      frame.rotation[d][2] = z[d];
    }
  return frame;
}

double angle_between(const Tensor3 &a, const Tensor3 &b)
{
  return std::asin(std::min(1., cross_product_3d(a, b).norm()));
}

void move_wheels(const drive::Drive &drive, Scene &scene)
{
  for (unsigned int i = 0; i < drive.sprockets.size(); ++i)
    {
      const WheelPlane plane(drive, i);
      Body            &wheel         = scene.bodies[scene.drive.sprockets[i].body];
      wheel.initial.rotation         = plane.turn * wheel.initial.rotation;
      wheel.initial.angular_velocity = plane.turn * wheel.initial.angular_velocity;
      wheel.initial.position[2] += plane.offset;
      wheel.mount.axis = plane.normal;
      if (wheel.mount.pivot)
        (*wheel.mount.pivot)[2] += plane.offset;
      if (wheel.mount.carrier)
        scene.bodies[*wheel.mount.carrier].initial.position[2] += plane.offset;
    }
}

/// How far bodies overlap that have been laid in line, m.
struct Overlap
{
  double strain = 0.; ///< pitches are so much longer
  double askew  = 0.; ///< ends of pins, bushes and rollers are so far aside
};

/// Places the strand of @p view, whose joints have gone to @p place.
void move_strand(const drive::Drive       &drive,
                 const std::vector<Place> &place,
                 const DriveView          &view,
                 Scene                    &scene,
                 Overlap                  &overlap)
{
  const drive::Layout &layout = drive.layout;
  const auto           middle = [&](const unsigned int k) {
    return in_space(layout.joints[k].bush) + place[k].displacement;
  };
  // pins are across the way of the chain, and strands beside it go along with them
  const auto pin_of = [&](const unsigned int k) {
    if (layout.joints[k].sprocket >= 0)
      return place[k].normal;
    const Tensor3 way = middle(view.next(k)) - middle(view.next(k, view.n_joints - 1));
    const Tensor3 pin = place[k].normal - (place[k].normal * way) / way.norm_square() * way;
    return Tensor3(pin / pin.norm());
  };
  const auto bush = [&](const unsigned int k, const double z) {
    return z == 0. ? middle(k) : middle(k) + z * pin_of(k);
  };
  for (unsigned int k = 0; k < view.n_joints; ++k)
    {
      const unsigned int next = view.next(k);
      Body              &body = scene.bodies[view.links[k]];
      // an outer link of several strands is one body
      const double  z    = body.strand > 0 ? view.z : 0.;
      const Tensor3 from = bush(k, z), to = bush(next, z);
      body.initial = frame_of_link(from, to, place[k], place[next]);
      body.initial.position += layout.links[k].ahead / (to - from).norm() * (to - from);
      overlap.strain = std::max(overlap.strain,
                                std::abs((bush(next, view.z) - bush(k, view.z)).norm() -
                                         layout.joints[next].bush.distance(layout.joints[k].bush)));
    }
  for (unsigned int k = 0; k < view.n_joints; ++k)
    {
      const Joint   joint = joint_of(k, drive, view);
      const Tensor3 inner = z_of(scene.bodies[joint.inner].initial),
                    outer = z_of(scene.bodies[joint.outer].initial);
      // a seated one turns in the plane of its wheel, another one on its bush
      const Tensor3 axis = layout.joints[k].sprocket >= 0 ? place[k].normal : inner;
      if (drive.chain.has_rollers)
        {
          Frame &roller   = scene.bodies[joint.roller].initial;
          roller.rotation = from_z_to(axis);
          roller.position += place[k].displacement;
          if (view.z != 0.) // it has been laid there in line
            roller.position += view.z * (pin_of(k) - along_z());
          roller.velocity         = place[k].velocity;
          roller.angular_velocity = roller.angular_velocity[2] * axis;
        }
      overlap.askew = std::max(
          {overlap.askew,
           (std::abs(view.z) + 0.5 * drive.chain.bush_length) * angle_between(inner, outer),
           0.5 * drive.chain.roller_length * angle_between(inner, axis)});
    }
}
} // namespace

void move_out_of_line(const drive::Drive &drive, Scene &scene)
{
  const std::vector<Place> place = places(drive);
  Overlap                  overlap;
  if (scene.strands.empty())
    move_strand(drive, place, scene.drive, scene, overlap);
  for (const DriveView &strand : scene.strands)
    move_strand(drive, place, strand, scene, overlap);
  move_wheels(drive, scene);
  const auto [strain, askew] = overlap;
  scene.start_overlap        = strain + askew;
  scene.notes.push_back(
      "Out of line: the chain is laid in line and then displaced with its wheels; "
      "at the start pitches are longer by up to " +
      to_text(1e6 * strain, 3) + " um, and pins, bushes and rollers askew by up to " +
      to_text(1e6 * askew, 3) + " um at their ends");
}
} // namespace chaindrive::scene
