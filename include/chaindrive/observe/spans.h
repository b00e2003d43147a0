// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/forces_in_places.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/scene/scene.h>

#include <utility>
#include <vector>

namespace chaindrive::observe
{
/// Tension of every link and the state of all spans at the last update().
///
/// A link's tension is its bar's (simple fidelity) or half the difference of the joint forces on
/// its two ends along its axis (layered). A link is of the span that it travels along, whose
/// tangent points of the pitch circles it lies between, along the line of centres of the sprockets;
/// of several, of the one whose straight line is nearest. Of these links count those whose middle
/// lies between 35 % and 65 % of the way from tangent point to tangent point, or within half a
/// pitch of its middle where that is more.
class Spans
{
public:
  /// Of the strand that stands for the chain in @p scene.
  Spans(const scene::Scene &scene, const dynamics::System &system)
      : Spans(scene, scene.drive, system)
  {
  }

  /// Of the @p strand, one of those of @p scene. Both must outlive this.
  Spans(const scene::Scene &scene, const scene::DriveView &strand, const dynamics::System &system);

  void update(const dynamics::System &system);

  const std::vector<double> &link_tension() const { return tension_; } ///< N, positive: pulled

  /// Means over the links of a span.
  struct Span
  {
    double tension = 0.; ///< N
    double speed   = 0.; ///< of rollers along the direction of travel at the start, m/s
    double offset  = 0.; ///< of rollers from the driver's axis along the outward normal, m
    double inward  = 0.; ///< likewise along the mirror image of the tight span's normal, m
  };

  const Span &of(const unsigned int span) const { return spans_[span]; }

  /// The span that the driver pulls in, and the one that it lets out.
  const Span &tight() const { return spans_.back(); }
  const Span &slack() const { return spans_.front(); }

private:
  void joint_forces(const dynamics::System &system);

  /// The same of links in the plane whose pins touch in places.
  void joint_forces_in_places(const PlanarBodies &planar);

  /// The span in whose middle the link from @p first to @p second [m] is, or none, which is the
  /// number of spans. This @p holds until one of these points has moved so far, m.
  unsigned int span_of(const dealii::Tensor<1, 3> &first,
                       const dealii::Tensor<1, 3> &second,
                       double                     &holds) const;

  /// Adds link @p k to the sums over the links of @p span.
  void add_link(const World &world, unsigned int k, Span &span, const scene::Span &along) const;

  /// The same of links in the plane, in which all axes of @p along lie.
  void add_link_in_plane(const PlanarBodies &planar,
                         unsigned int        k,
                         Span               &span,
                         const scene::Span  &along) const;

  /// Brings members_ up to date. In the plane links are looked at only when they have gone far
  /// enough to be of another span.
  void find_members(const World &world);

  /// Of which span a link is, or none, and until which PlanarBodies::travelled() that holds.
  struct Member
  {
    unsigned int span  = 0;
    double       until = 0.; ///< m
  };

  struct Link
  {
    unsigned int body;
    unsigned int slot; ///< in World::planar, or none
    bool         elastic;
    double       share; ///< of the difference of the forces on its pins that is its tension
  };

  /// Where a span is, and how much of it counts.
  struct Place
  {
    dealii::Tensor<1, 3> from;        ///< centre of the sprocket from which it leads, m
    double               middle;      ///< of its straight line, along that of the centres, m
    double               half_length; ///< likewise, m
    double               half_middle; ///< of what counts, likewise, m
    double               straight;    ///< that line from the centre, along the outward normal, m
  };

  const scene::DriveView &drive_; ///< the strand
  std::vector<Place>      places_;
  dealii::Tensor<1, 3>    driver_; ///< centre of the driver, m
  dealii::Tensor<1, 3>
                    mirrored_; ///< mirror image of the tight span's normal in its line of centres
  std::vector<Span> spans_;
  std::vector<Link> links_;                                  ///< [joint]; none in simple fidelity
  std::vector<const contact::Family *> joints_;              ///< bush-pin; none in simple fidelity
  std::vector<dealii::Tensor<1, 3>>    pin_force_;           ///< on the pin of each joint, N
  const contact::ForcesInPlaces       *in_places_ = nullptr; ///< bush-pin; null unless all links
                                                             ///< are in the plane
  std::vector<unsigned int> place_; ///< [joint], and of the first one again behind the last
  std::vector<double>       force_x_, force_y_; ///< on the pin at each place, N
  std::vector<double>       tension_;
  std::vector<unsigned int> n_links_; ///< of each span, at the last update
  std::vector<Member>       member_;  ///< by link
  std::vector<unsigned int> slots_;   ///< [joint], of its roller in World::planar; none
                                      ///< if the links are not all in the plane
  std::vector<std::pair<unsigned int, unsigned int>>
         members_;               ///< links in the middle of spans, ascending, and these
  double first_to_look_at_ = 0.; ///< the earliest of Member::until, m
  double steepest_         = 0.; ///< longest of the spans' axes, which are unit vectors
};
} // namespace chaindrive::observe
