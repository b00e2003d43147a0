// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/joints.h>

#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/simd.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace chaindrive::contact
{
JointTables::JointTables(const mesh::CylinderGrid &master, const mesh::CylinderGrid &slave)
{
  if (!master.uniform() || !slave.uniform())
    throw InputError(
        "The vertices of bores, and of bushes and pins inside them, must be equally far apart.");

  grid_.half                   = master.half;
  grid_.master_circumferential = master.n_circumferential();
  grid_.master_rings           = master.n_rings();
  grid_.slave_circumferential  = slave.n_circumferential();
  grid_.slave_rings            = slave.n_rings();
  grid_.first_ring             = 0;
  grid_.end_ring               = slave.n_rings();

  // a chord of n columns is 2 R sin(pi / n) long, see packed_geometry.h
  const double sine   = std::sin(dealii::numbers::PI / master.n_circumferential());
  grid_.master_radius = master.radius;
  grid_.chord_factor  = 4. * sine * sine;

  // Six or a few more columns tell the axis. Where exactly it is does not matter much: gap and
  // direction are measured on both sides from the same line.
  unsigned int n_axis = std::min(6u, grid_.master_circumferential);
  while (grid_.master_circumferential % n_axis != 0)
    ++n_axis;
  grid_.axis_stride = grid_.master_circumferential / n_axis;

  // A node stands for half of the way to its neighbours along the axis: at an end for one half,
  // h/2, elsewhere for two. cover is one over half of that length: the force fades over it, see
  // covered().
  for (unsigned int s = 0; s < slave.n_rings(); ++s)
    {
      area_.push_back(slave.area(s, 0));
      const double from = slave.rings[s == 0 ? 0 : s - 1],
                   to   = slave.rings[std::min(s + 1, slave.n_rings() - 1)];
      const double half = s == 0 || s + 1 == slave.n_rings() ? 0.5 : 0.25;
      cover_.push_back(1. / (half * (to - from)));

      const double middle = slave.rings[s];
      const double low    = std::max(0.5 * (from + middle), master.rings.front()),
                   high   = std::min(0.5 * (middle + to), master.rings.back());
      inside_.push_back(high > low ? area_.back() * (high - low) / (0.5 * (to - from)) :
                                     area_.back());
    }
}

JointGrid JointTables::grid() const
{
  JointGrid grid = grid_;
  grid.area      = area_.data();
  grid.inside    = inside_.data();
  grid.cover     = cover_.data();
  return grid;
}

std::vector<unsigned int> node_offsets(const mesh::CylinderGrid        &grid,
                                       const std::vector<unsigned int> &vertex_of_node)
{
  std::map<unsigned int, unsigned int> node_of;
  for (unsigned int node = 0; node < vertex_of_node.size(); ++node)
    node_of[vertex_of_node[node]] = node;
  std::vector<unsigned int> offsets;
  for (const unsigned int vertex : grid.vertex)
    {
      const auto found = node_of.find(vertex);
      if (found == node_of.end())
        throw std::logic_error("node_offsets: a vertex of the side is no node");
      offsets.push_back(3 * n_lanes * found->second);
    }
  return offsets;
}

JointBatch::JointBatch(const JointTables       &tables,
                       const scene::ContactLaw &law,
                       const JointKernels      &kernels)
    : kernels_(kernels), grid_(tables.grid()), arguments_{}, window_{}, sums_{}
{
  state_.resize(std::size_t(tables.n_slave_nodes()) * n_touch_entries * n_lanes, 0.);
  gap_.resize(tables.n_slave_nodes() * n_lanes, 0.);
  covered_.resize(tables.n_slave_nodes() * n_lanes, 0.);
  ring_.assign(grid_.slave_rings * n_lanes, 0);
  cell_.assign(grid_.slave_circumferential * n_lanes, 0);
  wanted_.assign(cell_.size(), 1);
  at_least_.assign(cell_.size(), 0.);
  searched_cell_ = cell_;
  arguments_.law = law;
}

void JointBatch::set_joint(const int lane, const JointBody &master, const JointBody &slave)
{
  if (lane < 0 || lane >= n_lanes)
    throw std::logic_error("JointBatch: no such lane");
  arguments_.master_node[lane]     = master.node;
  arguments_.master_position[lane] = master.position;
  arguments_.master_velocity[lane] = master.velocity;
  arguments_.master_force[lane]    = master.force;
  arguments_.master_pressed[lane]  = master.pressed;
  arguments_.slave_node[lane]      = slave.node;
  arguments_.slave_position[lane]  = slave.position;
  arguments_.slave_velocity[lane]  = slave.velocity;
  arguments_.slave_force[lane]     = slave.force;
  arguments_.slave_pressed[lane]   = slave.pressed;
}

JointBatch::Exact::Exact(const JointFlexibility &flexibility, std::shared_ptr<JointRoom> room)
    : flexibility(flexibility), room(std::move(room)), solver(simd_width())
{
}

void JointBatch::set_flexibility(const JointFlexibility    &flexibility,
                                 std::shared_ptr<JointRoom> room)
{
  exact_ =
      std::make_unique<Exact>(flexibility, room ? std::move(room) : std::make_shared<JointRoom>());
  grid_.first_ring = flexibility.rings().front(); // no others touch
  grid_.end_ring   = flexibility.rings().back() + 1;
}

void JointBatch::connect()
{
  arguments_.grid   = &grid_;
  arguments_.state  = state_.data();
  arguments_.ring   = ring_.data();
  arguments_.cell   = cell_.data();
  arguments_.window = &window_;
  arguments_.sums   = &sums_;
}

void JointBatch::measure(const bool closing)
{
  connect();
  GapArguments gaps{wanted_.data(), closing, gap_.data(), covered_.data(), {}};
  kernels_.measure(arguments_, gaps);
  std::copy(gaps.closing, gaps.closing + n_lanes, closing_.begin());
}

const dealii::AlignedVector<double> &JointBatch::measure_gaps()
{
  std::fill(wanted_.begin(), wanted_.end(), 1);
  measure(true);
  return gap_;
}

void JointBatch::choose_columns(const double reach, const double margin, const double use)
{
  for (std::size_t i = 0; i < wanted_.size(); ++i)
    {
      const int lane = static_cast<int>(i % n_lanes);
      at_least_[i] -= used(lane) + use;
      wanted_[i] = at_least_[i] < reach + margin + deflection_[lane] ? 1 : 0;
    }
  for (int lane = 0; lane < n_lanes; ++lane)
    complete_wanted(lane);
}

// A window may hold columns that are not near, whose nodes must be where they are now: outermost
// ones, and those between near ones far from each other. If what is wanted is one run over less
// than half of the bore, a window of any part of it stays within it and its outermost columns.
void JointBatch::complete_wanted(const int lane)
{
  const unsigned int n      = grid_.slave_circumferential;
  const auto         wanted = [&](const unsigned int c) -> char         &{
    return wanted_[c % n * n_lanes + lane];
  };
  unsigned int n_wanted = 0, n_runs = 0, last = 0;
  for (unsigned int c = 0; c < n; ++c)
    if (wanted(c) != 0)
      {
        ++n_wanted;
        if (wanted(c + 1) == 0)
          {
            ++n_runs;
            last = c;
          }
      }
  if (n_wanted == 0)
    return;
  if (n_runs != 1 || 2 * (n_wanted + 2) > n)
    for (unsigned int c = 0; c < n; ++c)
      wanted(c) = 1;
  else if (!exact_)
    wanted(last + 1) = wanted(last + n - n_wanted) = 1;
}

void JointBatch::bound_gaps(const int lane, const double near_gap)
{
  const unsigned int n = grid_.slave_circumferential;
  for (unsigned int c = 0; c < n; ++c)
    if (wanted_[c * n_lanes + lane] != 0)
      {
        double &least = at_least_[c * n_lanes + lane];
        least         = near_gap + let_alone;
        for (unsigned int s = grid_.first_ring; s < grid_.end_ring; ++s)
          least = std::min(least, gap_[(s * n + c) * n_lanes + lane]);
      }
}

unsigned int
JointBatch::search(const double reach, const std::optional<double> unforeseen, const double margin)
{
  if (!(reach >= 0.) || (unforeseen && !(*unforeseen > 0.)))
    throw std::logic_error("JointBatch: a search needs a reach and a speed");
  if (unforeseen)
    std::fill(wanted_.begin(), wanted_.end(), 1);
  measure(unforeseen.has_value());
  double       fastest = 0.;
  unsigned int missed  = 0;
  for (int lane = 0; lane < n_lanes; ++lane)
    if (arguments_.master_position[lane] != nullptr)
      {
        const double near_gap = reach + margin + deflection_[lane];
        missed += search_lane(lane, near_gap);
        bound_gaps(lane, near_gap);
        fastest = std::max(fastest, closing_[lane]);
      }
  fresh_         = true;
  searched_cell_ = cell_;
  if (exact_)
    exact_->new_windows = true;
  reach_.fill(unforeseen ? 0. : reach);
  cadence_.restart(unforeseen ? holding_time(reach, fastest, *unforeseen) : reach);
  return missed;
}

unsigned int JointBatch::search_lane(const int lane, const double near_gap)
{
  // A window is one run of columns, round and round.
  // Columns are near where any of their nodes, in any ring, overlaps, is nearer than that,
  // or has touched last time.
  const unsigned int n     = grid_.slave_circumferential;
  const unsigned int first = window_.first[lane], count = window_.count[lane];
  // With a penalty the surface between a near column and the next can touch: that one is in the
  // window as well, outermost, with a neighbour that is not there. Without, nodes alone touch.
  const unsigned int outermost = exact_ ? 0 : 1;

  std::vector<bool> near(n, false);
  bool              any    = false;
  unsigned int      missed = 0;
  for (unsigned int s = grid_.first_ring; s < grid_.end_ring; ++s)
    for (unsigned int c = 0; c < n; ++c)
      {
        const unsigned int node        = s * n + c;
        const double       gap         = gap_[node * n_lanes + lane];
        const bool         penetration = gap < 0. && covered_[node * n_lanes + lane] > 0.;
        const unsigned int place       = (c + n - first) % n;
        if (penetration && cadence_.left_alone() && count < n &&
            !(place >= outermost && place + outermost < count))
          ++missed;
        // what touched last time has a spring to let go
        if (penetration || gap < near_gap ||
            state_[(node * n_touch_entries + touch_penetration) * n_lanes + lane] > 0.)
          near[c] = any = true;
      }

  // The window leaves out the longest run of columns that are not near, but for outermost ones.
  unsigned int longest = 0, end = 0, run = 0;
  for (unsigned int i = 0; any && i < 2 * n; ++i)
    {
      run = near[i % n] ? 0 : run + 1;
      if (run > longest)
        {
          longest = run;
          end     = i;
        }
    }
  const unsigned int left_out = longest > 2 * outermost ? longest - 2 * outermost : 0;
  window_.first[lane]         = left_out > 0 ? (end + 1 - outermost) % n : 0;
  window_.count[lane]         = any ? n - left_out : 0;
  return missed;
}

void JointBatch::mark_wanted(const int lane, const bool of_slave, std::vector<char> &columns) const
{
  const unsigned int n = grid_.slave_circumferential, n_master = grid_.master_circumferential;
  unsigned int       n_wanted = 0;
  for (unsigned int c = 0; c < n; ++c)
    if (wanted_[c * n_lanes + lane] != 0)
      {
        ++n_wanted;
        if (of_slave)
          columns[c] = 1;
        else
          for (unsigned int side = 0; side < 6; ++side)
            columns[(cell_[c * n_lanes + lane] + 2 * n_master - 2 + side) % n_master] = 1;
      }
  if (n_wanted == n) // nobody may know yet where they meet the bore
    std::fill(columns.begin(), columns.end(), 1);
}

void JointBatch::mark_circumferential(const int          lane,
                                      const bool         of_slave,
                                      std::vector<char> &columns) const
{
  const unsigned int n = grid_.slave_circumferential, n_master = grid_.master_circumferential;
  for (unsigned int i = 0; i < window_.count[lane]; ++i)
    {
      const unsigned int column = (window_.first[lane] + i) % n;
      if (of_slave)
        columns[column] = 1;
      else // its cell lies between two columns
        for (unsigned int side = 0; side < 4; ++side)
          columns[(searched_cell_[column * n_lanes + lane] + n_master - 1 + side) % n_master] = 1;
    }
}

void JointBatch::add_forces(const double dt, const double use)
{
  connect();
  arguments_.dt = dt;
  use_          = fresh_ ? 0. : use;
  if (exact_)
    press();
  else
    kernels_.add_forces(arguments_);
  if (!fresh_)
    cadence_.use(use);
  fresh_ = false;
}

void JointBatch::serialize(const int lane, const Archive &archive)
{
  archive.numbers("nodes", state_.data() + lane, state_.size() / n_lanes, n_lanes);
  archive.numbers("rings", ring_.data() + lane, ring_.size() / n_lanes, n_lanes);
  archive.numbers("cells", cell_.data() + lane, cell_.size() / n_lanes, n_lanes);
  archive.numbers("searched cells", searched_cell_.data() + lane, cell_.size() / n_lanes, n_lanes);
  archive.numbers("at least", at_least_.data() + lane, at_least_.size() / n_lanes, n_lanes);
  archive("reach", reach_[lane]);
  if (exact_)
    archive.numbers("gaps", gap_.data() + lane, gap_.size() / n_lanes, n_lanes);
  archive("deflection", deflection_[lane]);
  archive("deflected", deflected_[lane]);
  archive("first", window_.first[lane]);
  archive("count", window_.count[lane]);
  archive("cell", window_.cell[lane]);
  if (exact_)
    exact_->new_windows = true; // what touched is to be had from the nodes
  SearchCadence cadence = cadence_;
  cadence.serialize(archive);
  if (lane > 0)
    cadence.join(cadence_);
  cadence_ = cadence;
}

unsigned int JointBatch::n_visited() const
{
  unsigned int columns = 0;
  for (const unsigned int count : window_.count)
    columns += count;
  return columns * grid_.slave_rings;
}

void JointBatch::clear_losses()
{
  std::fill_n(sums_.damping_loss, n_lanes, 0.);
  std::fill_n(sums_.friction_loss, n_lanes, 0.);
}

std::size_t JointBatch::memory_consumption() const
{
  return sizeof(*this) +
         (state_.size() + gap_.size() + covered_.size() + at_least_.size()) * sizeof(double) +
         wanted_.size() + (ring_.size() + 2 * cell_.size()) * sizeof(unsigned int);
}
} // namespace chaindrive::contact
