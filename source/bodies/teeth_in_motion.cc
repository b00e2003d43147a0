// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/teeth_in_motion.h>
#include <chaindrive/bodies/world.h>

#include <algorithm>
#include <cmath>

namespace chaindrive
{
TeethInMotion::TeethInMotion(const unsigned int                         body,
                             std::shared_ptr<const reduction::RimModes> modes)
    : body_(body), modes_(std::move(modes))
{
  const unsigned int z = modes_->teeth;
  for (unsigned int k = 0; k <= z / 2; ++k)
    for (unsigned int j = 0; j < z; ++j)
      {
        const double angle = 2. * dealii::numbers::PI * ((k * j) % z) / z;
        cosine_.push_back(std::cos(angle));
        sine_.push_back(std::sin(angle));
      }
  for (std::vector<double> *numbers : {&amplitude_, &rate_, &acceleration_, &force_})
    numbers->resize(modes_->n_modes(), 0.);
}

void TeethInMotion::drift(World & /*world*/, const Step &step)
{
  for (unsigned int m = 0; m < amplitude_.size(); ++m)
    {
      rate_[m] += 0.5 * step.dt * acceleration_[m];
      amplitude_[m] += step.dt * rate_[m];
    }
}

std::vector<dealii::ArrayView<double>> TeethInMotion::shared_forces(const World & /*world*/)
{
  return {dealii::ArrayView<double>(force_.data(), force_.size())};
}

void TeethInMotion::advance_shared(World &world, const Step &step)
{
  const double half    = step.moves ? 0.5 * step.dt : 0.;
  double       kinetic = 0., strain = 0.;
  for (unsigned int m = 0; m < amplitude_.size(); ++m)
    {
      const double square = modes_->omega[m] * modes_->omega[m], q = amplitude_[m];
      acceleration_[m] = force_[m] - square * q;
      rate_[m] += half * acceleration_[m];
      force_[m] = 0.;
      kinetic += rate_[m] * rate_[m];
      strain += square * q * q;
    }
  world.ledger.kinetic += 0.5 * world.symmetry.multiplicity() * kinetic;
  world.ledger.strain += 0.5 * world.symmetry.multiplicity() * strain;
}

double TeethInMotion::find_displacements(const unsigned int gap, Points &points) const
{
  const unsigned int z = modes_->teeth, n = 2 * modes_->n_points();
  points.assign(modes_->n_points(), dealii::Tensor<1, 2>());
  double *const sum = points.front().begin_raw();
  const double *c = modes_->cosine.data(), *s = modes_->sine.data();
  for (unsigned int m = 0; m < amplitude_.size(); ++m, c += n, s += n)
    {
      const std::size_t at     = std::size_t(modes_->waves[m]) * z + gap;
      const double      cosine = amplitude_[m] * cosine_[at], sine = amplitude_[m] * sine_[at];
      for (unsigned int i = 0; i < n; ++i)
        sum[i] += cosine * c[i] - sine * s[i];
    }
  double most = 0.;
  for (const dealii::Tensor<1, 2> &point : points)
    most = std::max(most, point.norm_square());
  return std::sqrt(most);
}

void TeethInMotion::add_forces(const unsigned int gap, const Points &forces)
{
  const unsigned int  z = modes_->teeth, n = 2 * modes_->n_points();
  const double *const f = forces.front().begin_raw();
  const double       *c = modes_->cosine.data(), *s = modes_->sine.data();
  for (unsigned int m = 0; m < force_.size(); ++m, c += n, s += n)
    {
      const std::size_t at     = std::size_t(modes_->waves[m]) * z + gap;
      double            cosine = 0., sine = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          cosine += c[i] * f[i];
          sine += s[i] * f[i];
        }
      force_[m] += cosine_[at] * cosine - sine_[at] * sine;
    }
}

void TeethInMotion::use_forces(const double dt)
{
  for (unsigned int m = 0; m < rate_.size(); ++m)
    rate_[m] += 0.5 * dt * acceleration_[m];
}

void TeethInMotion::rest() { std::fill(rate_.begin(), rate_.end(), 0.); }

void TeethInMotion::rest_as(const TeethInMotion &other)
{
  amplitude_ = other.amplitude_;
  rest();
}

double TeethInMotion::modal_energy() const
{
  double sum = 0.;
  for (const double rate : rate_)
    sum += 0.5 * rate * rate;
  return sum;
}

void TeethInMotion::serialize(const Archive &archive, World & /*world*/)
{
  archive.numbers("amplitude", amplitude_);
  archive.numbers("rate", rate_);
  archive.numbers("acceleration", acceleration_);
}

std::size_t TeethInMotion::memory_consumption() const
{
  return (modes_->cosine.size() + modes_->sine.size() + cosine_.size() + sine_.size() +
          4 * amplitude_.size()) *
         sizeof(double);
}
} // namespace chaindrive
