// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/closed_pair.h>
#include <chaindrive/contact/point_force.h>
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <array>
#include <cstddef>
#include <limits>

namespace chaindrive::contact
{
/// What slave points meet: a surface of one body, the master. It tells where a point is nearest to
/// it, how its material moves there, and takes the opposite force. Here it moves as a rigid body.
class Surface
{
public:
  explicit Surface(const unsigned int body) : body_(body) {}
  virtual ~Surface() = default;

  unsigned int body() const { return body_; }

  /// The nodes that carry the point of an elastic surface where a slave is; a rigid one has none.
  struct Projection
  {
    std::array<std::size_t, 4> nodes{}; ///< see NodeView
    std::array<std::size_t, 4> twins{}; ///< the same in the next sector, for nodes between two, see
                                        ///< Rim; else as nodes
    std::array<double, 4>               weights{};
    std::array<dealii::Tensor<1, 3>, 4> gradients;    ///< of the weights along a facet, 1/m
    dealii::Tensor<1, 3>                displacement; ///< of flanks: relative to the hub, m
    dealii::Tensor<1, 3>                arm; ///< of flanks: from the mean of the nodes to x, m
  };

  /// Where the point @p x [m, world], which carries a sphere of @p radius [m], is nearest to the
  /// surface. Only where it overlaps need there be a normal and tangents. Surfaces that must look
  /// for it do so @p within a distance [m] of x and begin with @p hint, the facet found last time,
  /// if any.
  virtual Touch project(const World                &world,
                        const dealii::Tensor<1, 3> &x,
                        double                      radius,
                        double                      within,
                        unsigned int               &hint,
                        Projection                 &projection) const = 0;

  /// Velocity [m/s] of a slave against the surface: its material at @p x [m, world], whose
  /// projection this is, moves at @p v [m/s], half a step @p dt [s] before now, as all velocities
  /// do while forces are evaluated.
  virtual dealii::Tensor<1, 3> relative_velocity(const World                &world,
                                                 const dealii::Tensor<1, 3> &x,
                                                 const Projection           &projection,
                                                 const dealii::Tensor<1, 3> &v,
                                                 double                      dt) const;

  /// The velocity on which friction works, given that @p relative one: not the same where the
  /// surface turns under the slave and takes friction elsewhere than at x.
  virtual dealii::Tensor<1, 3> slip_velocity(const World &,
                                             const Touch &,
                                             const Projection &,
                                             const dealii::Tensor<1, 3> &relative) const
  {
    return relative;
  }

  /// Adds the opposite of the force @p f on a slave that touches at @p x [m, world].
  virtual void add_opposite(World                      &world,
                            const dealii::Tensor<1, 3> &x,
                            const Touch                &touch,
                            const Projection           &projection,
                            const PointForce           &f) const;

  /// Whether there are places far away from the surface, so that a search for slaves near it pays.
  virtual bool needs_search() const { return false; }

  /// Whether a slave at @p x [m, world] with @p radius [m] may touch before anything has moved by
  /// @p reach [m].
  virtual bool is_near(const World &, const dealii::Tensor<1, 3> & /*x*/, double, double) const
  {
    return true;
  }

  /// The surface reaches that far to both sides along its body's z axis, m.
  virtual double half_width() const { return std::numeric_limits<double>::infinity(); }

  /// Whether the point @p x [m, world] is beyond that.
  virtual bool is_beside(const World &, const dealii::Tensor<1, 3> & /*x*/) const { return false; }

  /// Where its normals point.
  enum class Facing
  {
    across_axis, ///< of the master, as those of cylinders and teeth
    along_axis,
    anywhere
  };
  virtual Facing facing() const { return Facing::across_axis; }

  /// Some direction that is not the master's z axis, such as that of most of the force on @p slave,
  /// whose axis is at @p centre [m, world].
  virtual dealii::Tensor<1, 3>
  main_direction(const World &world, const Frame &slave, const dealii::Tensor<1, 3> &centre) const;

  /// The surface's nodes on springs of @p stiffness [N/m3] of the @p slaves, nodes of @p of_slaves,
  /// wherever these touch: see carried_area(). Nothing where the surface has no nodes: a rigid body
  /// is heavy beside a node, and each node of a slave is on its own spring.
  virtual ClosedSide closed_side(const World &,
                                 double /*stiffness*/,
                                 const mesh::SurfaceNodes & /*slaves*/,
                                 const BodyBatches & /*of_slaves*/) const
  {
    return {};
  }

private:
  unsigned int body_;
};

inline dealii::Tensor<1, 3> Surface::relative_velocity(const World                &world,
                                                       const dealii::Tensor<1, 3> &x,
                                                       const Projection &,
                                                       const dealii::Tensor<1, 3> &v,
                                                       const double                dt) const
{
  return v - world.velocity_at(body_, x, 0.5 * dt);
}

inline void Surface::add_opposite(World                      &world,
                                  const dealii::Tensor<1, 3> &x,
                                  const Touch &,
                                  const Projection &,
                                  const PointForce &f) const
{
  world.add_force(body_, -f.total, x);
}

inline dealii::Tensor<1, 3>
Surface::main_direction(const World &world, const Frame &, const dealii::Tensor<1, 3> &centre) const
{
  return centre - world.frames[body_].position;
}
} // namespace chaindrive::contact
