// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/closed_window.h>
#include <chaindrive/contact/rigid_flanks.h>
#include <chaindrive/contact/strip_problem.h>
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/mesh/surface/facet_surface.h>
#include <chaindrive/scene/scene.h>

#include <array>
#include <memory>
#include <vector>

namespace chaindrive::contact
{
/// Reduced rollers on the flanks of a rigid sprocket without penalty: no overlap, and what a roller
/// deflects beside its modes has no inertia. There is one record per roller.
///
/// Where the centre of a roller is nearest to the profile, a normal passes through it. Strips
/// are laid about this normal anew at every evaluation, so that no grid tells at which angle a
/// roller comes. The gap of a strip is the mean distance of its circle from the exact profile and
/// what modes displace it by; on every ring of the roller's nodes it is an unknown of its own.
/// Modes are known at nodes: cubic polynomials through four columns tell what is between them.
///
/// A wall that a tooth presses from outside is thin enough to move the bore, on which a bush
/// presses: forces on strips and in the bore are found together. So add_forces() measures gaps
/// alone; NodeBores::add_forces(), which must come later, finds the forces of problem_of(); and
/// finish_forces() adds them, along the normals of the profile, to nodes and sprocket.
///
/// Friction is one elastic slip per roller, as in a joint, on the sum of its normal forces, by
/// which it is shared out.
class RollerStrips : public SurfaceContact, public HasClosedWindows
{
public:
  /// Rollers of one part, whose basis has their outside without inertia. @p owner tells the rank
  /// that evaluates the bore of each.
  RollerStrips(const scene::Scene       &scene,
               const scene::ToothFamily &teeth,
               const World              &world,
               std::vector<unsigned int> owner);

  /// Whether the rollers of @p teeth have no penalty.
  static bool is_exact(const scene::Scene &scene, const scene::ToothFamily &teeth);

  void search(const World &world, double reach) override;
  void announce(World &world, std::optional<double> dt) override;
  void add_forces(World &world, double dt) override;
  void finish_forces(World &world, double dt) override;
  void add_springs(const World &, std::vector<Spring> &) const override {}

  std::vector<unsigned int> own(const World &) const override { return own_; }
  std::vector<ClosedWindow> closed_windows() const override { return {window_}; }

  void serialize(const Archive &archive, unsigned int rank) override;

  /// The strips of @p body as add_forces() has found them; null if it is none of this rank's.
  StripProblem *problem_of(unsigned int body);

  const std::vector<unsigned int>   &bodies() const { return bodies_; } ///< of the pairs
  const reduction::RoundFlexibility &outside() const { return outside_; }
  const StripFlexibility            &flexibility() const { return *flexibility_; }

protected:
  void serialize_pair(unsigned int i, const Archive &archive) override;
  bool within_reach(unsigned int i) const override;

private:
  static constexpr unsigned int n_weights = 4;

  /// Where a strip is now.
  struct Strip
  {
    double                        gap; ///< of the circle, in the middle plane of the roller, m
    dealii::Tensor<1, 3>          normal;
    std::array<unsigned int, 4>   column; ///< of nodes
    std::array<double, n_weights> weight;
  };

  struct Roller
  {
    StripProblem        problem;
    std::vector<double> force; ///< of all strips and rings, N: what touched last
    std::vector<Strip>  strips;
    Touch               touch; ///< of its centre
    unsigned int        hint = mesh::Projection::no_facet;
  };

  void find_own(unsigned int rank);

  /// The strips of pair @p i and their gaps, if it is near enough.
  void measure(const World &world, unsigned int i);

  /// The distance of @p x [m, world] from the profile; false if there is none near.
  bool project(const World                &world,
               const dealii::Tensor<1, 3> &x,
               Roller                     &roller,
               Touch                      &touch,
               double                     &distance) const;

  /// Lays strip @p s of pair @p i, whose middle is @p angle from the x axis of the roller and in
  /// the direction @p at [rad] in the world.
  bool lay(const World &world, unsigned int i, unsigned int s, double direction, double angle);

  std::size_t
  node(const World &world, unsigned int i, unsigned int ring, unsigned int column) const;

  std::shared_ptr<const Surface>          flanks_;
  const reduction::RoundFlexibility       outside_;
  double                                  radius_; ///< m
  std::unique_ptr<const StripFlexibility> flexibility_;
  unsigned int                            group_;         ///< of the rollers in World::copies
  std::vector<unsigned int>               copy_, bodies_; ///< per pair
  std::vector<unsigned int>               own_;           ///< those near that this rank evaluates
  std::vector<unsigned int>               read_;          ///< those announced last
  std::vector<Roller>                     rollers_;
  ClosedWindow                            window_;
  scene::ContactLaw                       friction_; ///< of a whole roller
};
} // namespace chaindrive::contact
