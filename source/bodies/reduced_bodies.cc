// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/reduced_bodies.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace chaindrive
{
ReducedBodies::ReducedBodies(const scene::Scene &scene, World &world, const unsigned int group)
    : ModalGroup(group)
    , material_(scene.material)
    , elements_(scene.elements)
    , kernels_(*modal_kernels(simd_width()))
    , rigid_(n_rigid_entries * n_lanes)
    , moment_(3 * n_lanes)
{
  BodyBatches        &copies = world.copies[group_];
  const scene::PartOf of     = scene.bodies[copies.bodies.front()].part();
  reference_.resize(3 * copies.n_nodes());
  for (unsigned int i = 0; i < 3 * copies.n_nodes(); ++i)
    reference_[i] = copies.nodes.position[i / 3][i % 3];
  std::vector<char> touches(copies.n_nodes(), 0);
  for (const unsigned int side : scene::sides_that_touch(scene, of))
    for (const unsigned int node :
         mesh::SurfaceNodes(*copies.part, copies.nodes, static_cast<mesh::Surface>(side)).node)
      touches[node] = 1;
  take_basis(copies.nodes, *scene.bases.at(of), touches);
  rigid_motions_ = reduction::rigid_motions(*copies.part, copies.nodes);
  for (Numbers *numbers : {&amplitude_, &rate_, &acceleration_, &modal_force_})
    numbers->resize(copies.n_batches() * per_batch(), 0.);
  copies.modes = {n_modes(), amplitude_.data(), farthest_.data()};
  in_body_.resize(node_offset(node_.size()));
  found_.resize(n_touching_);
  if (const auto measures = scene.measures.find(of); measures != scene.measures.end())
    measures_ = ForceMeasures(measures->second, copies, symmetry_, node_);
  ReadNodes nobody;
  nobody.node.resize(node_.size(), ModalNodes::none);
  nobody.placed.resize(node_.size(), 0);
  read_.assign(copies.n_batches(), nobody);
}

void ReducedBodies::take_basis(const mesh::Nodes       &nodes,
                               const reduction::Basis  &basis,
                               const std::vector<char> &touches)
{
  symmetry_                   = reduction::make_symmetry(nodes, basis.reflections);
  const unsigned int n_images = symmetry_.n_classes();

  std::vector<unsigned int> modes; // numbers in the basis
  for (unsigned int c = 0; c < n_images; ++c)
    {
      first_mode_.push_back(static_cast<unsigned int>(modes.size()));
      for (unsigned int m = 0; m < basis.size(); ++m)
        if (basis.symmetry[m] == c)
          {
            modes.push_back(m);
            class_.push_back(c);
            square_.push_back(basis.omega[m] * basis.omega[m]);
          }
    }
  first_mode_.push_back(static_cast<unsigned int>(modes.size()));
  orbit_.assign(nodes.size(), ModalNodes::none);
  image_.resize(nodes.size());
  const auto any_touches = [&](const unsigned int node) {
    for (unsigned int g = 0; g < n_images; ++g)
      if (touches[symmetry_.image(node, g)] != 0)
        return true;
    return false;
  };
  unsigned int n_orbits = 0;
  for (const bool touching : {true, false})
    for (unsigned int node = 0; node < nodes.size(); ++node)
      {
        if (orbit_[node] != ModalNodes::none || any_touches(node) != touching)
          continue;
        for (unsigned int g = n_images; g-- > 0;) // on a plane of symmetry the lowest image counts
          {
            const unsigned int image = symmetry_.image(node, g);
            orbit_[image]            = n_orbits;
            image_[image]            = g;
          }
        ++n_orbits;
        n_touching_ += touching ? 1 : 0;
        for (const unsigned int m : modes)
          for (unsigned int d = 0; d < 3; ++d)
            mode_shape_.push_back(basis.modes[m][3 * node + d]);
      }
  farthest_.assign(n_modes(), 0.);
  for (unsigned int i = 0; i < n_touching_ * n_modes(); ++i)
    {
      const double *phi     = mode_shape_.data() + 3 * std::size_t(i);
      double       &of_mode = farthest_[i % n_modes()];
      of_mode               = std::max(of_mode, std::hypot(phi[0], phi[1], phi[2]));
    }
  node_.assign(n_touching_ * n_images, ModalNodes::none);
  for (unsigned int node = 0; node < nodes.size(); ++node)
    if (touches[node] != 0)
      node_[orbit_[node] * n_images + image_[node]] = node;
}

std::size_t ReducedBodies::place_of(const BodyBatches &copies,
                                    const unsigned int copy,
                                    const unsigned int mode) const
{
  return copies.batch_of(copy) * per_batch() + mode * n_lanes + copies.lane_of(copy);
}

double &
ReducedBodies::amplitude(const World &world, const unsigned int copy, const unsigned int mode)
{
  forget_places();
  return amplitude_[place_of(world.copies[group_], copy, mode)];
}

double &ReducedBodies::rate(const World &world, const unsigned int copy, const unsigned int mode)
{
  return rate_[place_of(world.copies[group_], copy, mode)];
}

void ReducedBodies::take_frames(const World &world, const unsigned int batch)
{
  const BodyBatches &copies = world.copies[group_];
  const auto set_entry      = [this](const unsigned int entry, const unsigned int lane, double x) {
    rigid_[entry * n_lanes + lane] = x;
  };
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    {
      const unsigned int copy  = batch + lane * copies.n_batches();
      const bool         empty = copy >= copies.n_copies();
      const Frame       &frame = empty ? copies.start.front() : world.frames[copies.bodies[copy]];
      for (unsigned int i = 0; i < 3; ++i)
        {
          for (unsigned int j = 0; j < 3; ++j)
            set_entry(rigid_rotation + 3 * i + j, lane, frame.rotation[i][j]);
          set_entry(rigid_position + i, lane, frame.position[i]);
          set_entry(rigid_velocity + i, lane, empty ? 0. : frame.velocity[i]);
          set_entry(rigid_angular_velocity + i, lane, empty ? 0. : frame.angular_velocity[i]);
        }
    }
}

ModalNodes ReducedBodies::modal_nodes(const std::vector<unsigned int> &orbits,
                                      const ReadNodes                 &nodes) const
{
  return {static_cast<unsigned int>(orbits.size()),
          orbits.data(),
          symmetry_.n_classes(),
          nodes.node.data(),
          {symmetry_.reflection(0), symmetry_.reflection(1), symmetry_.reflection(2)},
          n_modes(),
          first_mode_.data(),
          reference_.data(),
          mode_shape_.data(),
          rigid_.data()};
}

void ReducedBodies::update_read(const BodyBatches &copies, const unsigned int batch)
{
  ReadNodes &nodes = read_[batch];
  if (nodes.changes == copies.reader_changes(batch))
    return;
  nodes.changes = copies.reader_changes(batch);
  nodes.known.clear();
  nodes.fresh.clear();
  const unsigned int n_images = symmetry_.n_classes();
  for (unsigned int orbit = 0; orbit < n_touching_; ++orbit)
    {
      bool any = false, all_placed = true;
      for (unsigned int i = orbit * n_images; i < (orbit + 1) * n_images; ++i)
        {
          const bool is_read = node_[i] != ModalNodes::none && copies.is_read(batch, node_[i]);
          nodes.node[i]      = is_read ? node_[i] : ModalNodes::none;
          if (is_read)
            {
              any        = true;
              all_placed = all_placed && nodes.placed[i] != 0;
            }
          else
            nodes.placed[i] = 0;
        }
      if (any)
        (all_placed ? nodes.known : nodes.fresh).push_back(orbit);
    }
}

void ReducedBodies::forget_places()
{
  for (ReadNodes &nodes : read_)
    {
      nodes.fresh.insert(nodes.fresh.end(), nodes.known.begin(), nodes.known.end());
      nodes.known.clear();
      std::fill(nodes.placed.begin(), nodes.placed.end(), 0);
    }
}

void ReducedBodies::kick(World &world, const double /*h*/)
{
  // What is about to be read for the first time is placed where the step begins, while the frames
  // are there: the step then tells its speed, whether or not a checkpoint lies between.
  const BodyBatches &copies = world.copies[group_];
  bool               known  = true;
  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    {
      update_read(copies, batch);
      known = known && read_[batch].fresh.empty();
    }
  if (!known)
    place_surface(world, 0.);
}

void ReducedBodies::drift(World &world, const Step &step)
{
  BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    if (copies.owns_batch(batch) || copies.is_shared(batch))
      {
        double            moved[n_lanes] = {};
        const std::size_t first          = batch * per_batch();
        for (std::size_t i = first; i < first + per_batch(); ++i)
          {
            rate_[i] += 0.5 * step.dt * acceleration_[i];
            amplitude_[i] += step.dt * rate_[i];
            moved[i % n_lanes] += farthest_[(i - first) / n_lanes] * std::abs(step.dt * rate_[i]);
          }
        copies.for_each_copy_of(batch, [&](const unsigned int copy, const unsigned int lane) {
          copies.moved_by_modes[copy] = moved[lane];
        });
      }
}

void ReducedBodies::place_surface(World &world, const double earlier)
{
  BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    {
      if (!copies.has_nodes(batch))
        continue;
      take_frames(world, batch);
      update_read(copies, batch);
      ReadNodes        &nodes = read_[batch];
      const std::size_t first = batch * per_batch();
      const double     *rate  = rate_.data() + first;
      const auto        place = [&](const std::vector<unsigned int> &ids, const double *speeds) {
        kernels_.place({modal_nodes(ids, nodes),
                        amplitude_.data() + first,
                        speeds,
                        earlier,
                        copies.position.begin() + copies.start_of(batch),
                        copies.velocity.begin() + copies.start_of(batch)});
      };
      place(nodes.known, earlier == 0. ? rate : nullptr);
      place(nodes.fresh, rate);
      const unsigned int n_images = symmetry_.n_classes();
      for (const unsigned int orbit : nodes.fresh)
        for (unsigned int i = orbit * n_images; i < (orbit + 1) * n_images; ++i)
          nodes.placed[i] = nodes.node[i] != ModalNodes::none ? 1 : 0;
      nodes.known.insert(nodes.known.end(), nodes.fresh.begin(), nodes.fresh.end());
      nodes.fresh.clear();
    }
}

void ReducedBodies::gather_forces(World &world)
{
  BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    {
      double *modal_force = modal_force_.data() + batch * per_batch();
      if (!copies.has_nodes(batch))
        {
          std::fill_n(modal_force, per_batch(), 0.); // others may add theirs
          continue;
        }
      take_frames(world, batch);
      const ReadNodes &nodes = read_[batch];
      kernels_.gather({modal_nodes(nodes.known, nodes),
                       copies.position.begin() + copies.start_of(batch),
                       copies.force.begin() + copies.start_of(batch),
                       copies.pressed(batch),
                       modal_force,
                       moment_.data(),
                       measures_.size(),
                       measures_.table(),
                       measures_.of_batch(batch),
                       in_body_.data(),
                       found_.data()});
      copies.for_each_copy_of(batch, [&](const unsigned int copy, const unsigned int lane) {
        for (unsigned int d = 0; d < 3; ++d)
          world.moment.local_element(3 * copies.bodies[copy] + d) += moment_[d * n_lanes + lane];
      });
    }
}

void ReducedBodies::advance(World &world, const Step &step, const ForceTimer & /*timer*/)
{
  const BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
       ++batch)
    if (!copies.is_shared(batch))
      kick_again(batch, step, 1., world.ledger);
}

std::vector<dealii::ArrayView<double>> ReducedBodies::shared_forces(const World &world)
{
  const BodyBatches                     &copies = world.copies[group_];
  std::vector<dealii::ArrayView<double>> forces;
  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    if (copies.is_shared(batch))
      forces.emplace_back(modal_force_.data() + batch * per_batch(), per_batch());
  return forces;
}

void ReducedBodies::advance_shared(World &world, const Step &step)
{
  const BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    if (copies.is_shared(batch))
      kick_again(batch, step, world.symmetry.multiplicity(), world.ledger);
}

void ReducedBodies::kick_again(const unsigned int batch,
                               const Step        &step,
                               const double       share,
                               Ledger            &ledger)
{
  const double half = step.moves ? 0.5 * step.dt : 0., drag = step.drag;
  double       kinetic[n_lanes] = {}, strain[n_lanes] = {}, dragged[n_lanes] = {};
  for (unsigned int m = 0; m < n_modes(); ++m)
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      {
        const std::size_t i = batch * per_batch() + m * n_lanes + lane;
        const double      q = amplitude_[i], before = rate_[i], square = square_[m];
        const double      acceleration = modal_force_[i] - square * q - drag * before;
        const double      now          = before + half * acceleration;
        acceleration_[i]               = acceleration;
        rate_[i]                       = now;
        kinetic[lane] += now * now;
        strain[lane] += square * q * q;
        dragged[lane] += before * before;
      }
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    {
      ledger.kinetic += share * 0.5 * kinetic[lane];
      ledger.strain += share * 0.5 * strain[lane];
      ledger.drag += share * drag * dragged[lane] * step.dt;
    }
}

void ReducedBodies::use_forces(World &world, const Step &step)
{
  const BodyBatches &copies = world.copies[group_];
  for (unsigned int batch = 0; batch < copies.n_batches(); ++batch)
    if (copies.owns_batch(batch) || copies.is_shared(batch))
      for (std::size_t i = batch * per_batch(); i < (batch + 1) * per_batch(); ++i)
        rate_[i] += 0.5 * step.dt * acceleration_[i];
}

dealii::Tensor<1, 3> ReducedBodies::mode_at(const unsigned int node, const unsigned int m) const
{
  const double        *at = mode_shape_.data() + 3 * (std::size_t(orbit_[node]) * n_modes() + m);
  dealii::Tensor<1, 3> phi;
  for (unsigned int d = 0; d < 3; ++d)
    phi[d] = symmetry_.sign(image_[node], class_[m], d) * at[d];
  return phi;
}

dealii::Tensor<1, 3> ReducedBodies::sum_of_modes(const World       &world,
                                                 const Numbers     &numbers,
                                                 const unsigned int copy,
                                                 const unsigned int node) const
{
  const BodyBatches   &copies  = world.copies[group_];
  const double        *of_copy = numbers.data() + place_of(copies, copy, 0);
  const double        *phi     = mode_shape_.data() + 3 * std::size_t(orbit_[node]) * n_modes();
  dealii::Tensor<1, 3> sum;
  for (unsigned int c = 0; c < symmetry_.n_classes(); ++c)
    {
      dealii::Tensor<1, 3> of_class;
      for (unsigned int m = first_mode_[c]; m < first_mode_[c + 1]; ++m)
        for (unsigned int d = 0; d < 3; ++d)
          of_class[d] += phi[3 * m + d] * of_copy[m * n_lanes];
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += symmetry_.sign(image_[node], c, d) * of_class[d];
    }
  return sum;
}

dealii::Tensor<1, 3> ReducedBodies::position_now(const World       &world,
                                                 const unsigned int copy,
                                                 const unsigned int node) const
{
  const BodyBatches &copies = world.copies[group_];
  const Frame       &frame  = world.frames[copies.bodies[copy]];
  return frame.position + frame.rotation * (dealii::Tensor<1, 3>(copies.nodes.position[node]) +
                                            sum_of_modes(world, amplitude_, copy, node));
}

dealii::Tensor<1, 3> ReducedBodies::velocity_now(const World       &world,
                                                 const unsigned int copy,
                                                 const unsigned int node) const
{
  const unsigned int body = world.copies[group_].bodies[copy];
  return world.velocity_at(body, position_now(world, copy, node), 0.) +
         world.frames[body].rotation * sum_of_modes(world, rate_, copy, node);
}

void ReducedBodies::nodes_now(const World                       &world,
                              const unsigned int                 copy,
                              std::vector<dealii::Tensor<1, 3>> &position,
                              std::vector<dealii::Tensor<1, 3>> &velocity) const
{
  const BodyBatches &copies  = world.copies[group_];
  const unsigned int n_nodes = copies.n_nodes(), n_classes = symmetry_.n_classes();
  const std::size_t  first = place_of(copies, copy, 0);

  // displacement and velocity in body axes by the modes of each class: images of a node have the
  // same but for signs
  constexpr unsigned int n_numbers = 6;
  const std::size_t      n_orbits  = mode_shape_.size() / (3 * std::size_t(n_modes()));
  std::vector<double>    sums(n_orbits * n_classes * n_numbers, 0.);
  for (std::size_t orbit = 0; orbit < n_orbits; ++orbit)
    for (unsigned int c = 0; c < n_classes; ++c)
      {
        double *sum = sums.data() + (orbit * n_classes + c) * n_numbers;
        for (unsigned int m = first_mode_[c]; m < first_mode_[c + 1]; ++m)
          {
            const double *phi = mode_shape_.data() + 3 * (orbit * n_modes() + m);
            const double  q   = amplitude_[first + std::size_t(m) * n_lanes],
                         rate = rate_[first + std::size_t(m) * n_lanes];
            for (unsigned int d = 0; d < 3; ++d)
              {
                sum[d] += phi[d] * q;
                sum[3 + d] += phi[d] * rate;
              }
          }
      }

  const unsigned int body  = copies.bodies[copy];
  const Frame       &frame = world.frames[body];
  position.resize(n_nodes);
  velocity.resize(n_nodes);
  for (unsigned int node = 0; node < n_nodes; ++node)
    {
      dealii::Tensor<1, 3> u, v;
      for (unsigned int c = 0; c < n_classes; ++c)
        {
          const double *sum = sums.data() + (std::size_t(orbit_[node]) * n_classes + c) * n_numbers;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double sign = symmetry_.sign(image_[node], c, d);
              u[d] += sign * sum[d];
              v[d] += sign * sum[3 + d];
            }
        }
      position[node] =
          frame.position + frame.rotation * (dealii::Tensor<1, 3>(copies.nodes.position[node]) + u);
      velocity[node] = world.velocity_at(body, position[node], 0.) + frame.rotation * v;
    }
}

double ReducedBodies::modal_energy(const World &world) const
{
  const BodyBatches &copies = world.copies[group_];
  const double      *first  = rate_.data() + copies.first_owned_batch() * per_batch(),
               *last        = rate_.data() + copies.end_of_owned_batches() * per_batch();
  return 0.5 * std::inner_product(first, last, first, 0.);
}

void ReducedBodies::rest()
{
  std::fill(rate_.begin(), rate_.end(), 0.);
  std::fill(acceleration_.begin(), acceleration_.end(), 0.);
}

void ReducedBodies::slow_modes(const World &world, const unsigned int copy, const double factor)
{
  for (unsigned int m = 0; m < n_modes(); ++m)
    rate(world, copy, m) *= factor;
}

double ReducedBodies::critical_time_step() const
{
  return 2. / std::sqrt(*std::max_element(square_.begin(), square_.end()));
}

dealii::FullMatrix<double>
ReducedBodies::modal_matrix(const std::vector<dealii::SymmetricTensor<2, 3>> &springs) const
{
  const unsigned int n = n_modes(), n_all = n + static_cast<unsigned int>(rigid_motions_.size());
  dealii::FullMatrix<double> matrix(n_all, n_all);
  for (unsigned int m = 0; m < n; ++m)
    matrix(m, m) = square_[m];
  for (unsigned int node = 0; node < springs.size(); ++node)
    {
      if (springs[node].norm() == 0.)
        continue;
      const std::vector<dealii::Tensor<1, 3>> moved = motions_of(node);
      for (unsigned int i = 0; i < n_all; ++i)
        {
          const dealii::Tensor<1, 3> force = springs[node] * moved[i];
          for (unsigned int j = 0; j < n_all; ++j)
            matrix(i, j) += force * moved[j];
        }
    }
  return matrix;
}

std::vector<dealii::Tensor<1, 3>> ReducedBodies::motions_of(const unsigned int node) const
{
  const unsigned int                n = n_modes();
  std::vector<dealii::Tensor<1, 3>> moved(n + rigid_motions_.size());
  for (unsigned int m = 0; m < n; ++m)
    moved[m] = mode_at(node, m);
  for (unsigned int m = n; m < moved.size(); ++m)
    for (unsigned int d = 0; d < 3; ++d)
      moved[m][d] = rigid_motions_[m - n][3 * node + d];
  return moved;
}

std::vector<double> ReducedBodies::amplitudes_of(const World &world, const unsigned int copy) const
{
  std::vector<double> amplitudes(n_modes());
  for (unsigned int m = 0; m < n_modes(); ++m)
    amplitudes[m] = amplitude_[place_of(world.copies[group_], copy, m)];
  return amplitudes;
}

std::vector<double> ReducedBodies::accelerations_of(const World       &world,
                                                    const unsigned int copy) const
{
  std::vector<double> accelerations(n_modes());
  for (unsigned int m = 0; m < n_modes(); ++m)
    accelerations[m] = acceleration_[place_of(world.copies[group_], copy, m)];
  return accelerations;
}

std::vector<double> ReducedBodies::measures_of(const World &world, const unsigned int copy) const
{
  const BodyBatches &copies = world.copies[group_];
  return measures_.of(copies.batch_of(copy), copies.lane_of(copy));
}

void ReducedBodies::rest_at(const World               &world,
                            const unsigned int         copy,
                            const std::vector<double> &amplitudes)
{
  forget_places();
  for (unsigned int m = 0; m < n_modes(); ++m)
    {
      const std::size_t i = place_of(world.copies[group_], copy, m);
      amplitude_[i]       = amplitudes[m];
      rate_[i] = acceleration_[i] = 0.;
    }
}

std::vector<std::unique_ptr<const element::StressRecovery>>
ReducedBodies::stress_recoveries(const World &world) const
{
  const BodyBatches         &copies = world.copies[group_];
  const element::ElasticPart part(*copies.part, copies.nodes, material_, elements_);
  std::vector<std::unique_ptr<const element::StressRecovery>> recoveries;
  for (const auto &block : part.blocks())
    recoveries.push_back(block->make_stress_recovery(*copies.part, copies.nodes, material_));
  return recoveries;
}

void ReducedBodies::serialize(const Archive &archive, World &world)
{
  if (archive.reads())
    forget_places();
  const BodyBatches &copies = world.copies[group_];
  // by body: the order in batches depends on the number of ranks
  for (unsigned int copy = 0; copy < copies.bodies.size(); ++copy)
    if (const unsigned int batch = copies.batch_of(copy);
        copies.owns_batch(batch) || (archive.reads() && copies.is_shared(batch)))
      for (const auto &[name, numbers] : {std::make_pair("amplitude ", &amplitude_),
                                          std::make_pair("rate ", &rate_),
                                          std::make_pair("acceleration ", &acceleration_)})
        archive.of_this_rank().numbers(name + std::to_string(copies.bodies[copy]),
                                       numbers->data() + place_of(copies, copy, 0),
                                       n_modes(),
                                       n_lanes);
}

std::size_t ReducedBodies::memory_consumption() const
{
  return (mode_shape_.size() + reference_.size() + 4 * amplitude_.size() + in_body_.size()) *
             sizeof(double) +
         rigid_motions_.size() * reference_.size() * sizeof(double) +
         ((1 + read_.size()) * (n_touching_ + node_.size()) +
          (2 + symmetry_.axis.size()) * orbit_.size()) *
             sizeof(unsigned int);
}
} // namespace chaindrive
