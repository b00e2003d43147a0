// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/mobility.h>
#include <chaindrive/contact/columns.h>
#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/roller_strips.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/utilities/ranks.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace chaindrive::contact
{
namespace
{
using dealii::numbers::PI;

// m: beyond what overlaps, and as much again as the deepest does, gaps are listed that forces may
// close. What closes gaps is the bush, through the wall: less than the tooth's own force deflects.
constexpr double margin = 3e-6;
// m: where a roller touches, beyond four times what forces close: at rest; more for each metre by
// which the deepest overlap changes in a step; at most. What is left out too early is a force that
// is off by 0.1 % for one step, which none was in 30 ms of seven drives.
constexpr double beside = 0.75e-6, beside_per_change = 15., most_beside = 1.5e-6;
constexpr double strip_sagitta = 1e-6; // m: more than points of a strip lie off its middle's circle
constexpr double near_centre   = 0.05; // over the radius: no modes let a circle so far away touch

/// The rings of a roller that are over teeth, by more than half of what they stand for.
struct CoveredRings
{
  CoveredRings(const mesh::CylinderGrid &grid, const double half_width)
  {
    for (unsigned int r = 0; r < grid.n_rings(); ++r)
      {
        const double z    = grid.rings[r];
        const double from = r == 0 ? z : 0.5 * (z + grid.rings[r - 1]);
        const double to   = r + 1 == grid.n_rings() ? z : 0.5 * (z + grid.rings[r + 1]);
        if (std::min(to, half_width) - std::max(from, -half_width) >= 0.5 * (to - from))
          {
            number.push_back(r);
            length.push_back(to - from);
            extent.push_back({{from, to}});
            all += to - from;
          }
      }
  }

  std::vector<unsigned int> number;
  std::vector<double>       length; ///< m

  std::vector<std::array<double, 2>> extent; ///< m

  double all = 0.;
};

} // namespace

RollerStrips::RollerStrips(const scene::Scene       &scene,
                           const scene::ToothFamily &teeth,
                           const World              &world,
                           std::vector<unsigned int> owner)
    : SurfaceContact(teeth.name,
                     {scene::Interface::roller_teeth, teeth.sprocket},
                     teeth.law,
                     pairs_on(make_flanks(teeth, world), teeth.slaves))
    , flanks_(pairs_.front().surface)
    , outside_(*scene::round_flexibility(scene, teeth.slaves.front().body, teeth.slave_surface))
    , radius_(teeth.slaves.front().radius)
    , form_(teeth.form)
    , profile_(*teeth.form, radius_)
    , rim_(teeth.rim_modes)
    , group_(world.elastic_address[teeth.slaves.front().body].group)
    , rollers_(teeth.slaves.size())
{
  if (dynamic_cast<const ElasticFlanks *>(flanks_.get()) != nullptr)
    throw std::logic_error("RollerStrips: teeth without penalty must be rigid");
  if (teeth.facets)
    throw std::logic_error("RollerStrips: teeth without penalty must be arcs");
  const BodyBatches       &copies = world.copies[group_];
  const mesh::CylinderGrid grid(*copies.part, mesh::roller_outside);
  const CoveredRings       rings(grid, teeth.half_width);
  for (unsigned int s = 0; rim_ && s < profile_.grid().size(); ++s)
    on_rim_.push_back(rim_->place_at(radius_ * profile_.grid().middle[s]));
  flexibility_ =
      std::make_unique<const StripFlexibility>(outside_,
                                               profile_.grid(),
                                               rings.number,
                                               rings.length,
                                               scene.material,
                                               StripFlexibility::Tooth{teeth.tooth_stiffness,
                                                                       teeth.loaded_half_angle,
                                                                       teeth.tooth_places,
                                                                       profile_.slopes(),
                                                                       of_modes(teeth)});

  owner_ = std::move(owner);
  for (const scene::SlavePoint &slave : teeth.slaves)
    {
      bodies_.push_back(slave.body);
      copy_.push_back(world.elastic_address[slave.body].copy);
    }
  for (Roller &roller : rollers_)
    roller.problem.flexibility = flexibility_.get();

  law_.damping = law_.tangential_damping = 0.;
  friction_                              = {1., 0., law_.friction, teeth.sticking_stiffness, 0.};

  length_ = rings.length;
  extent_ = rings.extent;
  for (const unsigned int r : rings.number)
    for (unsigned int c = 0; c < outside_.n_columns; ++c)
      node_.push_back(outside_.node[r * outside_.n_columns + c]);
  load_of_.assign(node_.size(), no_load);
  half_angle_                    = teeth.half_angle;
  half_line_                     = teeth.half_line;
  largest_force_                 = teeth.largest_force;
  const dealii::Tensor<1, 3> tip = world.frames[flanks_->body()].position +
                                   dealii::Point<3>(0.5 * form_->outside_diameter, 0., 0.);
  mobility_ = form_->teeth * dealii::trace(Mobility(world).of_point(flanks_->body(), tip));
  find_own(rank_in(world.communicator()));
}

void RollerStrips::find_own(const unsigned int rank)
{
  own_.clear();
  for (const unsigned int i : near_)
    if (owner_[i] == rank)
      own_.push_back(i);
}

bool RollerStrips::within_reach(const unsigned int i) const
{
  return std::binary_search(near_.begin(), near_.end(), i);
}

void RollerStrips::search(const World &world, const double search_reach)
{
  SurfaceContact::search(world, search_reach);
  find_own(rank_in(world.communicator()));
  for (unsigned int i = 0; i < rollers_.size(); ++i)
    if (!within_reach(i))
      {
        rollers_[i].problem.clear();
        rollers_[i].touching.clear();
      }
}

void RollerStrips::announce(World &world, std::optional<double> /*dt*/)
{
  BodyBatches &copies = world.copies[group_];
  if (!copies.counts_readers() || own_ == read_)
    return;
  for (const unsigned int i : read_)
    copies.add_readers(copies.batch_of(copy_[i]), node_, -1);
  for (const unsigned int i : own_)
    copies.add_readers(copies.batch_of(copy_[i]), node_, 1);
  read_ = own_;
}

StripProblem *RollerStrips::problem_of(const unsigned int body)
{
  for (const unsigned int i : own_)
    if (pairs_[i].slave.body == body)
      return &rollers_[i].problem;
  return nullptr;
}

std::size_t RollerStrips::first_number(const World &world, const unsigned int i) const
{
  const BodyBatches &copies = world.copies[group_];
  return copies.start_of(copies.batch_of(copy_[i])) + copies.lane_of(copy_[i]);
}

ClosedStrips RollerStrips::close(const std::vector<double> &middles,
                                 const double               half_width,
                                 const WallFlexibility     &wall,
                                 const unsigned int         n_bore_rings) const
{
  const StripGrid          &grid = flexibility_->grid();
  const unsigned int        m = flexibility_->n_rings(), n = outside_.n_columns;
  ClosedStrips              closed;
  std::vector<unsigned int> unknown;
  for (unsigned int s = 0; s < grid.size(); ++s)
    if (std::any_of(middles.begin(), middles.end(), [&](const double middle) {
          return std::abs(grid.middle[s] - middle) < half_width + grid.half_width[s];
        }))
      for (unsigned int r = 0; r < m; ++r)
        {
          const Columns columns(grid.middle[s], n);
          unknown.push_back(s * m + r);
          closed.places.push_back({grid.middle[s], {}, columns.weight});
          for (unsigned int k = 0; k < n_weights; ++k)
            closed.places.back().node[k] = node_[r * n + columns.number[k]];
        }
  const std::size_t n_bore = std::size_t(n_bore_rings) * n;
  closed.through.resize(unknown.size() * n_bore);
  std::vector<double> of_strip(m * n_bore); // [column][ring][ring of the bore]
  for (unsigned int a = 0; a < unknown.size(); ++a)
    {
      for (const unsigned int b : unknown)
        closed.flexibility.push_back(flexibility_->at(unknown[a], b));
      const unsigned int strip = unknown[a] / m;
      if (a % m == 0) // all rings of a strip come one after the other
        wall.at(strip, -closed.places[a].angle, 2. * PI / n, n, of_strip.data());
      for (unsigned int c = 0; c < n; ++c)
        std::copy_n(&of_strip[(std::size_t(c) * m + a % m) * n_bore_rings],
                    n_bore_rings,
                    &closed.through[a * n_bore + std::size_t(c) * n_bore_rings]);
    }
  if (rim_)
    add_rim(unknown, closed);
  return closed;
}

std::vector<ClosedWindow> RollerStrips::closed_windows() const
{
  ClosedWindow window;
  window.group         = group_;
  window.surface       = outside_.surface;
  window.n_columns     = outside_.n_columns;
  window.n_rings       = flexibility_->n_rings();
  window.across_middle = law_.friction > 0. ? friction_.tangential_stiffness : 0.;
  window.mobility      = mobility_;
  window.rim           = rim_.get();
  window.n_rings_of_through =
      static_cast<unsigned int>(outside_.to_bore.size() / outside_.node.size());

  std::vector<JointFlexibility::Place> places; // the rings of the bore themselves
  for (unsigned int q = 0; q < window.n_rings_of_through; ++q)
    places.push_back(q == 0 ? JointFlexibility::Place{0, 0.} : JointFlexibility::Place{q - 1, 1.});
  const WallFlexibility wall(outside_, flexibility_->grid(), flexibility_->rings(), places);
  const auto            add = [&](const std::vector<double> &middles, const double half_width) {
    window.strips.push_back(close(middles, half_width, wall, window.n_rings_of_through));
  };
  double all = 0.;
  for (const drive::Segment &segment : form_->half_profile)
    all += segment.length() / radius_;
  const double seat = form_->half_profile.front().length() / radius_, end = seat + half_line_,
               flank = std::max(end, 0.5 * (seat + all));
  // about the bottom and the end of the seat; on a flank; jammed between two
  add({0.}, std::min(half_angle_, end));
  add({std::max(0., end - half_angle_)}, std::min(half_angle_, end));
  add({flank}, half_line_);
  add({-end, end}, half_line_);
  add({-flank, flank}, half_line_);
  return {window};
}

RollerStrips::GapFrame RollerStrips::frame_of_gap(const World &world, const unsigned int i) const
{
  const Frame &frame = world.frames[pairs_[i].slave.body], &hub = world.frames[flanks_->body()];
  const auto  &turn =
      (form_->shifted.empty() ? form_->rotations : form_->shifted)[rollers_[i].touch.feature];
  const dealii::Tensor<1, 3> x({turn[0], turn[1], 0.}), y({-turn[1], turn[0], 0.});
  const dealii::Tensor<1, 3> arm = frame.position - hub.position;
  GapFrame                   gap;
  gap.x      = hub.rotation * x;
  gap.y      = hub.rotation * y;
  gap.z      = axis_of(hub, 2);
  gap.centre = dealii::Tensor<1, 2>({arm * gap.x, arm * gap.y});
  for (unsigned int d = 0; d < 2; ++d)
    {
      const dealii::Tensor<1, 3> &axis = d == 0 ? gap.x : gap.y;
      gap.in_roller[d] = dealii::Tensor<1, 2>({axis * axis_of(frame, 0), axis * axis_of(frame, 1)});
    }
  gap.turned_by = std::atan2(frame.rotation[1][0], frame.rotation[0][0]);
  return gap;
}

double RollerStrips::find_displacements(const World &world, const unsigned int i)
{
  const Frame               &frame   = world.frames[pairs_[i].slave.body];
  const GapFrame            &gap     = rollers_[i].frame;
  const BodyBatches         &copies  = world.copies[group_];
  const NodeView             at      = NodeView(copies.position);
  const unsigned int         n_rings = flexibility_->n_rings(), n = outside_.n_columns;
  const dealii::Tensor<1, 3> axis = axis_of(frame, 2),
                             x    = dealii::transpose(frame.rotation) * gap.x,
                             y    = dealii::transpose(frame.rotation) * gap.y;
  const std::size_t first         = first_number(world, i);
  displacement_.resize(std::size_t(n_rings) * n);
  double largest = 0.;
  for (unsigned int r = 0; r < n_rings; ++r)
    {
      // what is rigid, and the way of the ring's centre for a tilted axis
      const double               z = outside_.rings[flexibility_->rings()[r]];
      const dealii::Tensor<1, 2> tilt({z * (axis * gap.x), z * (axis * gap.y)});
      for (unsigned int c = 0; c < n; ++c)
        {
          const unsigned int         number = node_[r * n + c];
          const dealii::Tensor<1, 3> arm    = at[first + node_offset(number)] - frame.position,
                                     rest(copies.nodes.position[number]);
          dealii::Tensor<1, 2> &u = displacement_[c * n_rings + r];
          u[0]                    = arm * gap.x - rest * x + tilt[0];
          u[1]                    = arm * gap.y - rest * y + tilt[1];
          largest                 = std::max(largest, u.norm_square());
        }
    }
  return std::sqrt(largest);
}

void RollerStrips::find_near(const Roller &roller, const double reach, const double displaced_by)
{
  const std::vector<ToothStrips::Strip> &places = profile_.strips();
  near_strips_.clear();
  profile_.find_near(
      roller.frame.centre, radius_ + reach + strip_sagitta + displaced_by, near_numbers_);
  for (const unsigned int s : near_numbers_)
    {
      NearStrip                  strip{s, -radius_, {}, not_laid};
      const dealii::Tensor<1, 2> centre = roller.frame.centre - displaced(roller, s);
      for (const dealii::Tensor<1, 2> &point : places[s].gauss)
        {
          const dealii::Tensor<1, 2> to_point = point - centre;
          const double               distance = to_point.norm();
          strip.gap += 0.5 * distance;
          strip.mean += 0.5 / distance * to_point;
        }
      if (strip.gap <= reach)
        near_strips_.push_back(strip);
    }
}

void RollerStrips::lay(Roller &roller, NearStrip &near) const
{
  if (near.laid != not_laid)
    return;
  const GapFrame            &frame = roller.frame;
  const dealii::Tensor<1, 2> arm =
      profile_.strips()[near.number].middle - (frame.centre - displaced(roller, near.number));
  const double               distance  = arm.norm();
  const dealii::Tensor<1, 2> e         = arm / distance,
                             in_roller = e[0] * frame.in_roller[0] + e[1] * frame.in_roller[1];
  const double  angle                  = std::atan2(in_roller[1], in_roller[0]);
  const Columns columns(angle, outside_.n_columns);
  near.laid = static_cast<unsigned int>(roller.strips.size());
  roller.strips.push_back({near.gap,
                           distance,
                           e,
                           angle + frame.turned_by,
                           near.mean,
                           columns.number,
                           columns.weight,
                           columns.slope});
}

RollerStrips::Candidate
RollerStrips::candidate(const Roller &roller, const NearStrip &near, const unsigned int ring) const
{
  const Strip               &strip   = roller.strips[near.laid];
  const unsigned int         n_rings = flexibility_->n_rings();
  const dealii::Tensor<1, 2> e       = strip.direction;
  dealii::Tensor<1, 2>       moved, more;
  for (unsigned int k = 0; k < n_weights; ++k)
    {
      const dealii::Tensor<1, 2> &u = displacement_[strip.column[k] * n_rings + ring];
      moved += strip.weight[k] * u;
      more += strip.slope[k] * u;
    }
  return {near.number * n_rings + ring,
          near.laid,
          strip.gap - moved * e,
          more * e + moved[1] * e[0] - moved[0] * e[1]};
}

void RollerStrips::list_unknowns(Roller &roller, const double by_modes, const double overlap)
{
  StripProblem      &problem = roller.problem;
  const unsigned int n_rings = flexibility_->n_rings();

  // what touched last, and by how much forces close gaps there that modes leave
  bool   touched = false;
  double closed  = 0.;
  auto   found   = near_strips_.begin();
  for (const Touching &last : roller.touching)
    {
      while (found != near_strips_.end() && found->number < last.unknown / n_rings)
        ++found;
      if (found == near_strips_.end())
        break;
      if (found->number != last.unknown / n_rings)
        continue;
      lay(roller, *found);
      touched = true;
      closed  = std::max(closed, candidate(roller, *found, last.unknown % n_rings).gap);
    }

  const double by_forces =
      touched ? std::min(most_beside, beside + beside_per_change * roller.change) + 4. * closed :
                margin + 2. * overlap;
  double penetration = 0.;
  candidates_.clear();
  for (NearStrip &near : near_strips_)
    if (near.laid != not_laid || near.gap <= by_modes + by_forces)
      {
        lay(roller, near);
        for (unsigned int r = 0; r < n_rings; ++r)
          {
            candidates_.push_back(candidate(roller, near, r));
            penetration = std::max(penetration, -candidates_.back().gap);
          }
      }
  const double near = touched ? by_forces : margin + 2. * penetration;
  auto         last = roller.touching.begin();
  std::size_t  n    = 0;
  problem.resize(candidates_.size());
  roller.unknowns.resize(candidates_.size());
  for (const Candidate &candidate : candidates_)
    if (candidate.gap < near)
      {
        while (last != roller.touching.end() && last->unknown < candidate.unknown)
          ++last;
        const bool again     = last != roller.touching.end() && last->unknown == candidate.unknown;
        problem.unknown[n]   = candidate.unknown;
        problem.direction[n] = roller.strips[candidate.strip].angle;
        problem.gap[n]       = candidate.gap;
        problem.force[n]     = again ? last->force : 0.;
        roller.unknowns[n++] = {candidate.strip, candidate.turning};
      }
  problem.resize(n);
  roller.unknowns.resize(n);
}

void RollerStrips::measure(World &world, const unsigned int i)
{
  Roller &roller = rollers_[i];
  roller.problem.clear();
  roller.strips.clear();
  roller.unknowns.clear();
  const Frame &frame = world.frames[pairs_[i].slave.body];
  // a sphere that overlaps has a normal
  const double        beyond = 4. * radius_;
  Surface::Projection none;
  unsigned int        hint = mesh::Projection::no_facet;
  roller.touch    = flanks_->project(world, frame.position, beyond, 2. * radius_, hint, none);
  records_[i].gap = roller.touch.gap < 0. ? roller.touch.gap + beyond - radius_ :
                                            std::numeric_limits<double>::max();
  if (records_[i].gap > near_centre * radius_)
    return;
  roller.frame = frame_of_gap(world, i);
  const double of_teeth =
      rim_ ?
          world.teeth_of(flanks_->body())->find_displacements(roller.touch.feature, roller.teeth) :
          0.;
  // how near modes bring strips, between nodes a little nearer than these; and the deepest overlap
  const double by_modes = 1.25 * find_displacements(world, i),
               overlap  = std::max(0., by_modes + of_teeth - records_[i].gap);
  if (records_[i].gap > by_modes + of_teeth + margin)
    return;
  find_near(roller, by_modes + margin + 2. * overlap, of_teeth);
  list_unknowns(roller, by_modes, overlap);
}

void RollerStrips::add_forces(World &world, const double /*dt*/)
{
  for (const unsigned int i : own_)
    measure(world, i);
}

void RollerStrips::serialize(const Archive &archive, const unsigned int rank)
{
  SurfaceContact::serialize(archive, rank);
  if (archive.reads())
    find_own(rank);
}

void RollerStrips::serialize_pair(const unsigned int i, const Archive &archive)
{
  SurfaceContact::serialize_pair(i, archive);
  std::vector<Touching> &touching = rollers_[i].touching;
  std::vector<double>    force(flexibility_->n(), 0.);
  for (const Touching &t : touching)
    force[t.unknown] = t.force;
  archive.numbers("strips", force);
  if (!archive.reads())
    return;
  touching.clear();
  for (unsigned int a = 0; a < force.size(); ++a)
    if (force[a] > 0.)
      touching.push_back({a, not_laid, force[a]});
}
} // namespace chaindrive::contact
