// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/teeth_in_motion.h>
#include <chaindrive/contact/closed_window.h>
#include <chaindrive/contact/rigid_flanks.h>
#include <chaindrive/contact/strip_problem.h>
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/contact/tooth_strips.h>
#include <chaindrive/mesh/surface/facet_surface.h>
#include <chaindrive/scene/scene.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace chaindrive::contact
{
/// Reduced rollers on the flanks of a rigid sprocket without penalty: no overlap, and what a roller
/// deflects beside its modes has no inertia. There is one record per roller.
///
/// The profile of a tooth lies in strips that turn with the sprocket. The gap of a strip is by how
/// much farther its points are from the centre of a roller than the outside of this one, which
/// modes displace, is in their direction; on every ring of the roller's nodes it is an unknown of
/// its own. So no column of nodes tells at which angle a roller comes, and on each strip the roller
/// is the same round body. Modes are known at nodes: cubic polynomials through four columns tell
/// what is between them.
///
/// A wall that a tooth presses from outside is thin enough to move the bore, on which a bush
/// presses: forces on strips and in the bore are found together. So add_forces() measures gaps
/// alone; NodeBores::add_forces(), which must come later, finds the forces of problem_of(); and
/// finish_forces() adds them. They are the derivatives of the energy that they store: with a
/// pressure p, u being how far modes move the outside at the angle a about the axis of the roller,
/// it is pressed back along the line from the strip to its centre, and by p du/da about it.
///
/// Friction is one elastic slip per roller, as in a joint, on the sum of its normal forces, by
/// which it is shared out.
///
/// Where the rim has inertia (TeethInMotion) its modes displace the strips of each gap, whose
/// normal forces act on these modes as well; friction meets teeth that turn with the sprocket.
class RollerStrips : public SurfaceContact, public HasClosedWindows
{
public:
  /// Rollers of one part, whose basis has their outside without inertia. @p owner tells the rank
  /// that evaluates the bore of each.
  RollerStrips(const scene::Scene       &scene,
               const scene::ToothFamily &teeth,
               const World              &world,
               std::vector<unsigned int> owner);

  void search(const World &world, double reach) override;
  void announce(World &world, std::optional<double> dt) override;
  void add_forces(World &world, double dt) override;
  void finish_forces(World &world, double dt) override;
  void add_springs(const World &, std::vector<Spring> &) const override {}

  std::vector<unsigned int> own(const World &) const override { return own_; }
  std::vector<ClosedWindow> closed_windows() const override;

  bool knows_pressure() const override { return true; }
  void raise_pressures(std::vector<double> &largest) const override; ///< of strips
  void add_pressures(const World &world, std::vector<NodePressure> &pressures) const override;
  void add_patches(const World &world, std::vector<PressurePatch> &patches) const override;
  void add_massless_forces(const World &world, std::vector<NodeForce> &forces) const override;

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
  static constexpr unsigned int n_weights = 4, no_load = static_cast<unsigned int>(-1),
                                not_laid = no_load;

  /// The frame of the gap that a roller is in, and the roller in it.
  struct GapFrame
  {
    dealii::Tensor<1, 3>                x, y, z;   ///< its axes, z that of the sprocket; unit
    dealii::Tensor<1, 2>                centre;    ///< of the roller, m
    std::array<dealii::Tensor<1, 2>, 2> in_roller; ///< x and y, across the roller's axis
    double                              turned_by; ///< the roller, in the world, rad

    dealii::Tensor<1, 3> in_world(const dealii::Tensor<1, 2> &v) const
    {
      return v[0] * x + v[1] * y;
    }
  };

  /// Where a strip is now, seen from the centre of a roller; vectors are those of GapFrame.
  struct Strip
  {
    double                              gap;           ///< of a round roller, m
    double                              distance;      ///< of its middle, m
    dealii::Tensor<1, 2>                direction;     ///< of that, unit
    double                              angle;         ///< of that, in the world, rad
    dealii::Tensor<1, 2>                mean;          ///< of the directions of its points
    std::array<unsigned int, n_weights> column;        ///< of nodes
    std::array<double, n_weights>       weight, slope; ///< and by how much more per radian
  };

  /// A strip near a roller.
  struct NearStrip
  {
    unsigned int         number;
    double               gap;  ///< as in Strip
    dealii::Tensor<1, 2> mean; ///< as in Strip
    unsigned int         laid; ///< its number among the Strips of the roller, or not_laid
  };

  /// A strip and ring that may touch.
  struct Candidate
  {
    unsigned int unknown, strip; ///< as in StripProblem; among those of the roller
    double       gap;            ///< as in StripProblem
    double       turning;        ///< by how much modes move it per radian, m
  };

  /// What else than StripProblem has of an unknown: as in Candidate.
  struct Unknown
  {
    unsigned int strip;
    double       turning;
  };

  /// A strip and ring with a force.
  struct Touching
  {
    unsigned int unknown, strip; ///< as in Candidate
    double       force;          ///< N
  };

  /// The forces on strips, as a node carries its parts of them.
  struct Load
  {
    unsigned int         place = 0;  ///< of the node, [ring][column]
    double               force = 0.; ///< their sum, N
    dealii::Tensor<1, 2> normal;     ///< their resultant, towards the strips, in the GapFrame, N
  };

  /// What presses a roller.
  struct Pressed
  {
    double               sum = 0., deepest = 0.; ///< N; m
    double               couple = 0.; ///< on the roller about its centre by what deflects it, N m
    dealii::Tensor<1, 3> force;       ///< N
  };

  struct Roller
  {
    StripProblem          problem;
    std::vector<Strip>    strips;       ///< near it, of the gap that its centre is nearest to
    std::vector<Unknown>  unknowns;     ///< of the problem
    std::vector<Touching> touching;     ///< what touched last, ascending
    double                deepest = 0.; ///< overlap then, and how it had changed, m
    double                change  = std::numeric_limits<double>::max();
    Touch                 touch; ///< of its centre
    GapFrame              frame; ///< of that gap
    TeethInMotion::Points teeth; ///< by how much that is displaced; empty: no modes, m
  };

  void find_own(unsigned int rank);

  /// The strips of pair @p i and their gaps, if it is near enough.
  void measure(World &world, unsigned int i);

  /// The frame of the gap that the centre of pair @p i is nearest to.
  GapFrame frame_of_gap(const World &world, unsigned int i) const;

  /// By how much modes and tilt move the outside of pair @p i, into displacement_; the most, m.
  double find_displacements(const World &world, unsigned int i);

  /// What modes of the rim deflect at the places of @p teeth, as StripFlexibility::Tooth has it.
  std::array<double, 3> of_modes(const scene::ToothFamily &teeth) const;

  /// By how much modes of the rim have displaced a strip before a @p roller, m.
  dealii::Tensor<1, 2> displaced(const Roller &roller, unsigned int strip) const;

  /// The strips within a @p reach [m] of a round @p roller, into near_strips_. Modes of the rim
  /// have displaced them by @p displaced [m] at most.
  void find_near(const Roller &roller, double reach, double displaced);

  /// Puts the @p force [N] in the frame of a gap on a strip of a rim with modes, into on_teeth_.
  void push(unsigned int strip, const dealii::Tensor<1, 2> &force);

  /// Adds a strip to those of a @p roller, unless it is there.
  void lay(Roller &roller, NearStrip &near) const;

  /// The gap of a ring of a strip that has been laid.
  Candidate candidate(const Roller &roller, const NearStrip &near, unsigned int ring) const;

  /// Lists those of near_strips_ that may touch a @p roller: modes move its outside by @p by_modes
  /// at most, and the round roller overlaps by @p overlap, m.
  void list_unknowns(Roller &roller, double by_modes, double overlap);

  /// The pressure of the @p force [N] on an @p unknown of StripProblem, Pa.
  double pressure(unsigned int unknown, double force) const;

  /// Shares out the @p force on a strip to nodes of a @p ring, in loads_.
  void carry(const Strip &strip, unsigned int ring, double force);

  /// Adds the normal forces of pair @p i, and lists them in loads_.
  Pressed press(World &world, unsigned int i);

  /// Adds the forces of friction on the nodes of loads_, also to those of @p pressed.
  void add_friction(World &world, double dt, unsigned int i, Pressed &pressed);

  /// Strips of the profile within @p half_width [rad] about each of @p middles, as they are round a
  /// roller that rolls along it, closed together.
  ClosedStrips close(const std::vector<double> &middles,
                     double                     half_width,
                     const WallFlexibility     &wall,
                     unsigned int               n_bore_rings) const;

  /// Adds what modes of the rim move these @p unknowns by, numbered as in StripFlexibility.
  void add_rim(const std::vector<unsigned int> &unknowns, ClosedStrips &closed) const;

  /// Where the numbers of the roller of pair @p i begin in its batch.
  std::size_t first_number(const World &world, unsigned int i) const;

  std::shared_ptr<const Surface>             flanks_;
  const reduction::RoundFlexibility          outside_;
  double                                     radius_; ///< m
  std::shared_ptr<const drive::ToothForm>    form_;
  const ToothStrips                          profile_;
  std::unique_ptr<const StripFlexibility>    flexibility_;
  std::shared_ptr<const reduction::RimModes> rim_;           ///< null: it has no inertia
  std::vector<reduction::RimModes::Place>    on_rim_;        ///< per strip
  TeethInMotion::Points                      on_teeth_;      ///< room: forces on the profile, N
  unsigned int                               group_;         ///< of the rollers in World::copies
  std::vector<unsigned int>                  copy_, bodies_; ///< per pair
  std::vector<unsigned int>                  own_;  ///< those near that this rank evaluates
  std::vector<unsigned int>                  read_; ///< those announced last
  std::vector<Roller>                        rollers_;
  std::vector<dealii::Tensor<1, 2>>          displacement_; ///< room, [column][ring], m
  std::vector<unsigned int>                  near_numbers_; ///< room, of strips
  std::vector<NearStrip>                     near_strips_;  ///< room
  std::vector<Candidate>                     candidates_;   ///< room
  std::vector<Load>                          loads_;        ///< on the roller at hand
  std::vector<unsigned int>                  load_of_;      ///< [ring][column], numbers, or no_load
  std::vector<unsigned int>                  node_;         ///< of their outside, [ring][column]
  std::vector<double>                        length_; ///< that each of these rings stands for, m
  std::vector<std::array<double, 2>>         extent_; ///< from where to where along the axis, m
  double                                     half_angle_; ///< of the largest contact in a seat, rad
  double                                     half_line_;  ///< and on a flank, rad
  double                                     mobility_;   ///< as in ClosedWindow
  scene::ContactLaw                          friction_;   ///< of a whole roller
};
} // namespace chaindrive::contact
