// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "joint.h"
#include "statics.h"

namespace test
{
/// The first copies of two bodies at rest in the joint of one with the other. Displacements count
/// from where they have been placed; the bore's body comes first.
class JointAtRest
{
public:
  /// Contact has the penalty @p stiffness [N/m3], neither damping nor friction.
  JointAtRest(Tubes &bore, Tubes &cylinder, const double stiffness)
      : statics({&bore.reference, &cylinder.reference})
      , bodies_{{&bore, &cylinder}}
      , tables_(bore.grid, cylinder.grid)
      , joints_(tables_, {stiffness, 0., 0., 0., 0.}, *contact::joint_kernels(1))
  {
    joints_.set_joint(0, bore.body(0), cylinder.body(0));
    for (unsigned int b = 0; b < 2; ++b)
      for (unsigned int i = 0; i < 3 * bodies_[b]->reference.n_nodes(); ++i)
        start_.push_back(bodies_[b]->batch.position[i * n_lanes]);
  }

  /// Position that node @p node of body @p b has been placed at.
  Point<3> start(const unsigned int b, const unsigned int node) const
  {
    const double *x = start_.data() + statics.first[b] + 3 * node;
    return {x[0], x[1], x[2]};
  }

  /// Solves for the displacements; @p touches tells which surface nodes can come into contact.
  /// Returns whether there is an equilibrium to @p tolerance [N].
  bool solve(const std::function<bool(const Point<3> &)> &touches, const double tolerance)
  {
    std::vector<unsigned int> touched;
    for (unsigned int b = 0; b < 2; ++b)
      for (const unsigned int offset : bodies_[b]->offsets)
        if (touches(start(b, offset / (3 * n_lanes))))
          for (unsigned int i = 0; i < 3; ++i)
            touched.push_back(statics.first[b] + offset / n_lanes + i);
    const auto contact = [&](const Vector<double> &u, Vector<double> &c) {
      for (Tubes *body : bodies_)
        body->batch.force.fill(0.);
      for (unsigned int i = 0; i < statics.size; ++i)
        entry(i, &Batch::position) = start_[i] + u[i];
      joints_.add_forces(0., 0.);
      for (unsigned int i = 0; i < statics.size; ++i)
        c[i] = entry(i, &Batch::force);
    };
    Vector<double> c(statics.size);
    for (unsigned int i = 0; i < statics.size; ++i)
      entry(i, &Batch::position) = start_[i] + statics.u[i];
    joints_.search(1e-3, 1.);
    const bool found = statics.solve(contact, touched, tolerance) > 0;
    contact(statics.u, c);
    return found;
  }

  /// Size of the force between the bodies [N].
  double force() const
  {
    return vector(
               joints_.sums().force[0][0], joints_.sums().force[1][0], joints_.sums().force[2][0])
        .norm();
  }

  /// Normal force [N] of a node of the cylinder's side.
  double normal_force(const unsigned int station, const unsigned int column) const
  {
    const unsigned int node = station * bodies_[1]->grid.n_circumferential() + column;
    return joints_.state()[(node * contact::n_touch_entries + contact::touch_normal) * n_lanes];
  }

  Statics statics;

private:
  double &entry(const unsigned int i, dealii::AlignedVector<double> Batch::*values)
  {
    const unsigned int b = i < statics.first[1] ? 0 : 1;
    return (bodies_[b]->batch.*values)[(i - statics.first[b]) * n_lanes];
  }

  std::array<Tubes *, 2>     bodies_;
  const contact::JointTables tables_;
  std::vector<double>        start_; ///< m
  contact::JointBatch        joints_;
};
} // namespace test
