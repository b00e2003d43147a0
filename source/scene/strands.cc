// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/text.h>

#include <type_traits>
#include <utility>
#include <vector>

// The strands of a chain of several as bodies of their own. The scene has been built of one strand
// in the middle, with its share of all that acts on the shafts.

namespace chaindrive::scene
{
namespace
{
/// What belongs to all strands: pins and outer links, which are one body, and all that is not the
/// chain.
bool is_shared(const Body &body)
{
  return body.kind != Kind::roller && body.kind != Kind::inner_link;
}

/// Gives to what is not the chain what all @p n strands make of it.
void take_all_shares(const double n, Scene &scene)
{
  for (Body &body : scene.bodies)
    if (is_shared(body) && body.kind != Kind::outer_link)
      {
        body.mass *= n;
        body.inertia *= n;
      }
  for (Shaft &shaft : scene.shafts)
    shaft.program.share *= n;
  for (Tensioner &tensioner : scene.tensioners)
    for (double *of : {&tensioner.law.preload,
                       &tensioner.law.stiffness,
                       &tensioner.law.damping,
                       &tensioner.law.retracting_damping,
                       &tensioner.law.stop_stiffness,
                       &tensioner.law.stop_damping})
      *of *= n;
  for (Coupling &coupling : scene.couplings)
    for (double *of : {&coupling.stiffness, &coupling.damping, &coupling.torque})
      *of *= n;
  for (Bearing &bearing : scene.bearings)
    {
      bearing.weight *= n;
      for (unsigned int d = 0; d < 2; ++d)
        {
          bearing.stiffness[d] *= n;
          bearing.damping[d] *= n;
        }
    }
}

/// Makes of what one strand has that of one at a place along z.
class Strand
{
public:
  /// At @p z [m], with @p number from 1 on. The strand that is in @p scene is this one if @p
  /// is_there says so; else its bodies are copied to the end of @p bodies.
  Strand(const Scene       &scene,
         const double       z,
         const unsigned int number,
         const bool         is_there,
         std::vector<Body> &bodies)
      : scene_(scene), z_(z), body_(scene.bodies.size())
  {
    for (unsigned int b = 0; b < body_.size(); ++b)
      {
        body_[b] = b;
        if (is_shared(scene.bodies[b]))
          continue;
        if (!is_there)
          {
            body_[b] = static_cast<unsigned int>(bodies.size());
            bodies.push_back(scene.bodies[b]);
          }
        Body &body  = bodies[body_[b]];
        body.strand = number;
        body.initial.position[2] += z;
      }
  }

  double       z() const { return z_; }
  unsigned int body(const unsigned int b) const { return body_[b]; }

  SlavePoint operator()(SlavePoint point) const
  {
    if (is_shared(scene_.bodies[point.body]))
      point.point[2] += z_;
    point.body = body(point.body);
    return point;
  }

  BorePair operator()(BorePair pair) const
  {
    pair.master = body(pair.master); // an inner link or a roller
    pair.slave  = (*this)(pair.slave);
    return pair;
  }

  SidePair operator()(SidePair pair) const
  {
    pair.master = body(pair.master); // an inner link
    pair.slave  = (*this)(pair.slave);
    return pair;
  }

  template <typename Item>
  std::vector<Item> operator()(const std::vector<Item> &items) const
  {
    std::vector<Item> moved;
    moved.reserve(items.size());
    for (const Item &item : items)
      moved.push_back((*this)(item));
    return moved;
  }

private:
  const Scene              &scene_;
  double                    z_;    ///< m
  std::vector<unsigned int> body_; ///< of this strand, for each of the scene's
};

/// Appends to @p families those of a @p strand with the number @p number of InterfaceOf; the @p own
/// ones are those of the strand that is there.
template <typename Family, typename Members>
void append(const Strand              &strand,
            const unsigned int         number,
            const std::vector<Family> &own,
            Members Family::*const members,
            std::vector<Family>   &families)
{
  for (Family family : own)
    {
      family.*members = strand(family.*members);
      family.strand   = number;
      if constexpr (std::is_same_v<Family, ToothFamily> || std::is_same_v<Family, ToothSideFamily>)
        family.z = strand.z();
      families.push_back(std::move(family));
    }
}

/// The strand that stands for the chain in histories: the one whose tight span is pulled most where
/// wheels lean, else the first.
unsigned int leading_strand(const drive::Drive &drive)
{
  const auto    last = static_cast<unsigned int>(drive.sprockets.size()) - 1;
  const Tensor3 lean = normal_of_wheel(drive, 0) - normal_of_wheel(drive, last);
  const auto   &way  = drive.layout.spans.back().direction;
  return lean[0] * way[0] + lean[1] * way[1] > 0. ? drive.strands - 1 : 0;
}

/// Outer links of @p n strands are one body each: their plates at the places @p z [m] on common
/// pins.
void join_outer_links(const std::vector<double> &z, Scene &scene)
{
  double squares = 0.;
  for (const double at : z)
    squares += at * at;
  for (Body &body : scene.bodies)
    if (body.kind == Kind::outer_link)
      {
        for (const unsigned int d : {0, 1})
          body.inertia[d] = z.size() * body.inertia[d] + squares * body.mass;
        body.inertia[2] *= z.size();
        body.mass *= z.size();
      }
}
} // namespace

void separate_strands(const drive::Drive &drive, Scene &scene)
{
  const unsigned int  n = drive.strands, leading = leading_strand(drive);
  std::vector<double> z;
  for (unsigned int s = 0; s < n; ++s)
    z.push_back((s - 0.5 * (n - 1.)) * drive.chain.transverse_pitch);
  // what there is becomes the leading strand, which is the first in all lists
  std::vector<unsigned int> order = {leading};
  for (unsigned int s = 0; s < n; ++s)
    if (s != leading)
      order.push_back(s);

  Scene all = scene;
  all.strands.resize(n);
  all.bores.clear();
  all.teeth.clear();
  all.sides.clear();
  all.tooth_sides.clear();
  for (GuideFamily &guide : all.guides)
    guide.slaves.clear();
  for (unsigned int number = 0; number < n; ++number)
    {
      const unsigned int s = order[number];
      const Strand       strand(scene, z[s], s + 1, number == 0, all.bodies);
      append(strand, number, scene.bores, &BoreFamily::pairs, all.bores);
      append(strand, number, scene.teeth, &ToothFamily::slaves, all.teeth);
      append(strand, number, scene.sides, &SideFamily::pairs, all.sides);
      append(strand, number, scene.tooth_sides, &ToothSideFamily::slaves, all.tooth_sides);
      for (unsigned int i = 0; i < all.guides.size(); ++i)
        for (const SlavePoint &slave : scene.guides[i].slaves)
          all.guides[i].slaves.push_back(strand(slave));
      DriveView &view = all.strands[s];
      view            = scene.drive;
      view.strand     = number;
      view.z          = z[s];
      for (std::vector<unsigned int> *of_strand : {&view.rollers, &view.links})
        for (unsigned int &body : *of_strand)
          body = strand.body(body);
    }
  join_outer_links(z, all);
  take_all_shares(n, all);
  for (Body &body : all.bodies)
    if (body.kind == Kind::outer_link || body.kind == Kind::sprocket)
      body.parts_at = z;
  all.drive         = all.strands[leading];
  all.drive.strands = 1;
  for (DriveView &view : all.strands)
    view.strands = 1;
  all.notes.push_back(
      "Strands are bodies of their own, " + to_text(1e3 * drive.chain.transverse_pitch, 5) +
      " mm apart, on common pins, which are rigid: number 1 is at the least z, and number " +
      std::to_string(leading + 1) +
      " stands for the chain in what is told of joints, links, rollers and teeth");
  scene = std::move(all);
}
} // namespace chaindrive::scene
