// SPDX-License-Identifier: LGPL-2.1-or-later
// By how much CoupledModes::find_worst() underestimates the largest frequency of reduced drives.
//
// Usage: step_limit_benchmark FILE.prm < DRIVES, where each line of DRIVES has the entries of one
// drive, "Section/Entry=value", separated by tabs. Prints for each drive, in percent of the
// frequency that find_worst() finds, by how much more is found
//
//   more     by a thorough search: 24 random beginnings, then one contact after the other in all
//            its ways
//   waves    in waves between q = 0 and pi, with the ways that suit these
//   pitches  where two neighbouring pitches are closed in different ways
#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/contacts.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/reduction/kept_basis.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/stability/coupled_modes.h>
#include <chaindrive/statics/cache.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace chaindrive;

namespace
{
using stability::CoupledModes;
using Interface = CoupledModes::Interface;
using Vector    = dealii::Vector<double>;
using Ways      = CoupledModes::Ways;

/// One or more pitches that are closed somehow, for one step.
class Problem
{
public:
  /// An interface between a slave of one pitch and a master of the same or another one, whose
  /// motions are those of that pitch times exp(i phase).
  struct Contact
  {
    const Interface *interface;
    unsigned int     n_ways; ///< the first ones
    unsigned int     slave_pitch, master_pitch;
    double           phase;
  };

  /// With complex motions: real parts, then imaginary parts.
  Problem(const CoupledModes &modes,
          const double        dt,
          const unsigned int  n_pitches,
          const bool          is_complex)
      : dt_(dt), n_real_(n_pitches * modes.free().size()), is_complex_(is_complex)
  {
    for (unsigned int copy = 0; copy < n_pitches * (is_complex ? 2 : 1); ++copy)
      diagonal_.insert(diagonal_.end(), modes.free().begin(), modes.free().end());
    n_motions_ = modes.free().size();
  }

  std::vector<Contact> contacts;

  std::size_t size() const { return diagonal_.size(); }

  /// y = A x, closed in @p ways.
  void multiply(const Ways &ways, const Vector &x, Vector &y) const
  {
    for (std::size_t i = 0; i < size(); ++i)
      y[i] = diagonal_[i] * x[i];
    for (std::size_t k = 0; k < contacts.size(); ++k)
      {
        const CoupledModes::Closed &way    = contacts[k].interface->ways[ways[k]];
        const double                factor = 1. + 2. * way.time / dt_;
        gather(contacts[k], x);
        for (unsigned int c = 0; c < (is_complex_ ? 2 : 1); ++c)
          {
            product(way.matrix, part_[c], result_[c]);
            result_[c] *= factor;
          }
        scatter(contacts[k], y);
      }
  }

  /// x^T A x of the contact @p k alone, closed in @p way.
  double quotient(const std::size_t k, const unsigned int way) const
  {
    const CoupledModes::Closed &closed = contacts[k].interface->ways[way];
    double                      sum    = 0.;
    for (unsigned int c = 0; c < (is_complex_ ? 2 : 1); ++c)
      {
        product(closed.matrix, part_[c], result_[c]);
        sum += part_[c] * result_[c];
      }
    return (1. + 2. * closed.time / dt_) * sum;
  }

  /// Takes the part of @p x that a contact sees, for quotient().
  void gather(const Contact &contact, const Vector &x) const
  {
    const auto  &motions = contact.interface->motions;
    const double cosine = std::cos(contact.phase), sine = std::sin(contact.phase);
    for (unsigned int c = 0; c < 2; ++c)
      {
        part_[c].reinit(motions.size());
        result_[c].reinit(motions.size());
      }
    for (unsigned int i = 0; i < motions.size(); ++i)
      {
        const bool        slave = i < contact.interface->n_slave_motions;
        const std::size_t at    = place(contact, i);
        const double      re = x[at], im = is_complex_ ? x[n_real_ + at] : 0.;
        part_[0][i] = slave ? re : cosine * re - sine * im;
        part_[1][i] = slave ? im : sine * re + cosine * im;
      }
  }

private:
  std::size_t place(const Contact &contact, const unsigned int i) const
  {
    const bool slave = i < contact.interface->n_slave_motions;
    return contact.interface->motions[i] +
           n_motions_ * (slave ? contact.slave_pitch : contact.master_pitch);
  }

  void scatter(const Contact &contact, Vector &y) const
  {
    const double cosine = std::cos(contact.phase), sine = std::sin(contact.phase);
    for (unsigned int i = 0; i < contact.interface->motions.size(); ++i)
      {
        const bool        slave = i < contact.interface->n_slave_motions;
        const std::size_t at    = place(contact, i);
        const double      re = result_[0][i], im = is_complex_ ? result_[1][i] : 0.;
        y[at] += slave ? re : cosine * re + sine * im;
        if (is_complex_)
          y[n_real_ + at] += slave ? im : cosine * im - sine * re;
      }
  }

  /// Of a symmetric matrix: of four columns at a time.
  static void product(const dealii::FullMatrix<double> &matrix, const Vector &x, Vector &y)
  {
    const std::size_t n  = matrix.m();
    double           *to = y.begin();
    std::fill(to, to + n, 0.);
    std::size_t j = 0;
    for (; j + 4 <= n; j += 4)
      {
        const double *a = &matrix(j, 0), *b = &matrix(j + 1, 0), *c = &matrix(j + 2, 0),
                     *d = &matrix(j + 3, 0);
        const double xa = x[j], xb = x[j + 1], xc = x[j + 2], xd = x[j + 3];
        for (std::size_t i = 0; i < n; ++i)
          to[i] += (xa * a[i] + xb * b[i]) + (xc * c[i] + xd * d[i]);
      }
    for (; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        to[i] += x[j] * matrix(j, i);
  }

  double              dt_;
  std::size_t         n_real_, n_motions_ = 0;
  bool                is_complex_;
  std::vector<double> diagonal_;
  mutable Vector      part_[2], result_[2];
};

/// The largest eigenvalue, exact.
double largest(const Problem &problem, const Ways &ways)
{
  return largest_eigenvalue(
      problem.size(), [&](auto &product, const auto &x) { problem.multiply(ways, x, product); });
}

/// @p n steps of power iteration with @p x; returns a Rayleigh quotient, which is never larger than
/// the largest eigenvalue.
double iterate(const Problem &problem, const Ways &ways, const unsigned int n, Vector &x)
{
  Vector y(x.size());
  double value = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      problem.multiply(ways, x, y);
      value = x * y;
      x.equ(1. / y.l2_norm(), y);
    }
  return value;
}

/// Ascent from @p ways and @p x: the fastest motion decides, again and again, until it decides for
/// the same. Neither step makes the Rayleigh quotient smaller.
void ascend(const Problem &problem, Ways &ways, Vector &x)
{
  x /= x.l2_norm();
  unsigned int same = 0;
  for (unsigned int round = 0; round < 30 && same < 2; ++round)
    {
      iterate(problem, ways, 12, x);
      const Ways before = ways;
      for (std::size_t k = 0; k < ways.size(); ++k)
        {
          double most = -1.;
          problem.gather(problem.contacts[k], x);
          for (unsigned int w = 0; w < problem.contacts[k].n_ways; ++w)
            if (const double q = problem.quotient(k, w); q > most)
              {
                most    = q;
                ways[k] = w;
              }
        }
      same = ways == before ? same + 1 : 0;
    }
}

Vector random_vector(const std::size_t n, std::mt19937 &random)
{
  std::normal_distribution<double> normal;
  Vector                           x(n);
  for (double &entry : x)
    entry = normal(random);
  return x;
}

/// The best of @p n ascents from random beginnings, and of one from @p ways, which become its own.
double best_of(const Problem &problem, const unsigned int n, Ways &ways)
{
  std::mt19937 random(1);
  double       best  = largest(problem, ways);
  const Ways   first = ways;
  for (unsigned int start = 0; start <= n; ++start)
    {
      Ways from = first;
      for (std::size_t k = 0; k < from.size() && start > 0; ++k)
        from[k] = random() % problem.contacts[k].n_ways;
      Vector x = random_vector(problem.size(), random);
      ascend(problem, from, x);
      if (iterate(problem, from, 60, x) > 0.999 * best)
        if (const double value = largest(problem, from); value > best)
          {
            best = value;
            ways = from;
          }
    }
  return best;
}

/// The same, after which each contact in turn is closed in all its ways until none is faster.
double thorough(const Problem &problem, Ways &ways)
{
  double       best = best_of(problem, 24, ways);
  std::mt19937 random(2);
  Vector       x = random_vector(problem.size(), random);
  x /= x.l2_norm();
  iterate(problem, ways, 60, x);
  for (bool found = true; found;)
    {
      found = false;
      for (std::size_t k = 0; k < ways.size(); ++k)
        for (unsigned int w = 0; w < problem.contacts[k].n_ways; ++w)
          {
            Ways   other = ways;
            Vector y     = x;
            other[k]     = w;
            if (w == ways[k] || iterate(problem, other, 12, y) <= (1. + 1e-9) * best)
              continue;
            best  = largest(problem, other);
            ways  = other;
            x     = y;
            found = true;
          }
    }
  return best;
}

/// How many ways an interface has in one phase of the next pitch.
unsigned int n_alike(const Interface &interface)
{
  return static_cast<unsigned int>(interface.ways.size()) / (interface.closes_pitch ? 2 : 1);
}

Problem one_pitch(const CoupledModes &modes, const double dt)
{
  Problem problem(modes, dt, 1, false);
  for (const Interface &interface : modes.interfaces())
    problem.contacts.push_back(
        {&interface, static_cast<unsigned int>(interface.ways.size()), 0, 0, 0.});
  return problem;
}

/// Waves in which the next pitch moves as this one times exp(i @p q).
Problem wave(const CoupledModes &modes, const double dt, const double q)
{
  Problem problem(modes, dt, 1, true);
  for (const Interface &interface : modes.interfaces())
    problem.contacts.push_back(
        {&interface, n_alike(interface), 0, 0, interface.closes_pitch ? q : 0.});
  return problem;
}

/// Two pitches, each closed in ways of its own; the next two move alike or in opposition.
Problem two_pitches(const CoupledModes &modes, const double dt)
{
  Problem problem(modes, dt, 2, false);
  for (const unsigned int pitch : {0u, 1u})
    for (const Interface &interface : modes.interfaces())
      problem.contacts.push_back(
          {&interface,
           pitch == 0 ? n_alike(interface) : static_cast<unsigned int>(interface.ways.size()),
           pitch,
           interface.closes_pitch ? 1 - pitch : pitch,
           0.});
  return problem;
}

/// The reduced drive of @p file with @p overrides, coupled.
std::optional<CoupledModes> coupled(const std::string              &file,
                                    const std::vector<std::string> &overrides)
{
  const Parameters     p        = model::read_parameters(file, overrides).parameters;
  const drive::Drive   drive    = drive::make_drive(p);
  const scene::BasisOf basis_of = [&p, &drive](const mesh::Part &part) {
    statics::Cache cache(statics::Cache::usual_folder());
    return std::make_shared<const reduction::Basis>(
        reduction::kept_basis(part,
                              p.material,
                              p.elements,
                              reduction::options_of(p.reduction, drive.chain.pitch),
                              cache,
                              MPI_COMM_SELF));
  };
  const scene::Scene scene =
      scene::build_scene(model::make_model(p, drive), drive, {"."}, basis_of);
  World                              world = make_world(scene);
  const contact::Contacts            contacts(scene, world, false);
  std::vector<stability::ClosedKind> kinds;
  for (const auto &family : contacts.families())
    for (stability::ClosedKind &kind : stability::closed_kinds(world, *family))
      kinds.push_back(std::move(kind));
  return CoupledModes::make(world, kinds);
}

double percent(const double value, const double found)
{
  return 100. * (std::sqrt(value / found) - 1.);
}

void compare(const CoupledModes &modes)
{
  const double  dt    = modes.critical_time_step();
  Ways          ways  = modes.find_worst(modes.free_step());
  const Problem pitch = one_pitch(modes, dt);
  const double  found = largest(pitch, ways), more = thorough(pitch, ways);

  // from the worst ways, whichever phase they have
  Ways alike = ways;
  for (std::size_t k = 0; k < alike.size(); ++k)
    alike[k] %= n_alike(modes.interfaces()[k]);
  double waves = 0.;
  for (const double q : {0.25, 0.5, 0.75})
    {
      Ways of_wave = alike;
      waves        = std::max(waves, best_of(wave(modes, dt, q * dealii::numbers::PI), 1, of_wave));
    }
  Ways both = alike;
  both.insert(both.end(), alike.begin(), alike.end());
  const double pitches = best_of(two_pitches(modes, dt), 8, both);
  std::printf("%zu  %zu  %.5f  %.4f  %.4f  %.4f\n",
              pitch.size(),
              pitch.contacts.size(),
              1e6 * dt,
              percent(more, found),
              percent(waves, found),
              percent(pitches, found));
}
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 2)
    {
      std::cerr << "usage: step_limit_benchmark FILE.prm < DRIVES\n";
      return 2;
    }
  std::printf("motions  contacts  step_us  more  waves  pitches\n");
  for (std::string line; std::getline(std::cin, line);)
    {
      std::vector<std::string> overrides;
      std::istringstream       entries(line);
      for (std::string entry; std::getline(entries, entry, '\t');)
        overrides.push_back(entry);
      try
        {
          if (const auto modes = coupled(argv[1], overrides))
            compare(*modes);
          else
            std::printf("not coupled\n");
        }
      catch (const std::exception &error)
        {
          std::printf("refused: %s\n", error.what());
        }
      std::fflush(stdout);
    }
}
