// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of bodies whose sides deflect but have no inertia, in time: central differences with the
// pressures that a complementarity problem gives at each instant. Two masses and one flexibility
// have peak and duration of their impact by the closed forms, within an error of the order of the
// step's square, and part at the speed at which they met. A closed mode is bounded just below the
// step of 2/omega and not just above; so is a roller that is held all round, at that of
// closed_frequency(), and so are two that are pressed together. A bar that meets a wall leaves it
// after 2 L/c at the speed at which it came. Over a hundred thousand steps with three sides that
// open and close the energy stays what it was to the order of the step's square.
#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/reduction/side_flexibility.h>
#include <chaindrive/reduction/slower_modes.h>
#include <chaindrive/utilities/complementarity.h>
#include <chaindrive/utilities/simd.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace chaindrive;
using namespace reduction;
using dealii::numbers::PI;

namespace
{
bool with_numbers = false; ///< behind the verdicts: if there is an argument

const char *yes(const bool good) { return good ? "yes" : "NO"; }

using Coordinates = std::vector<double>;

/// Coordinates of unit mass, each on its own spring, with gaps g = g0 + N x between sides whose
/// flexibility is C. Constant forces may act.
struct System
{
  Coordinates                x, v, square, force; ///< position, speed, W^2, constant force
  std::vector<double>        gap;                 ///< g0
  dealii::FullMatrix<double> rows, flexibility;   ///< N, C

  std::vector<double> pressure; ///< at the last step
  double              energy = 0.;

  ComplementaritySolver          solver{simd_width()};
  std::array<ClosedSet, n_lanes> sets;
  dealii::AlignedVector<double>  matrix, gaps;

  /// One step of central differences; v belongs to half a step before x.
  void step(const double dt)
  {
    const unsigned int n      = static_cast<unsigned int>(gap.size()),
                       stride = ComplementaritySolver::padded(n);
    const bool is_new         = matrix.empty();
    if (is_new)
      {
        matrix.resize(std::size_t(n) * stride, 0.);
        gaps.resize(stride, 0.);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            matrix[std::size_t(i) * stride + j] = flexibility(i, j);
      }
    for (unsigned int i = 0; i < n; ++i)
      {
        gaps[i] = gap[i];
        for (unsigned int k = 0; k < x.size(); ++k)
          gaps[i] += rows(i, k) * x[k];
      }
    std::array<ComplementarityProblem, n_lanes> problems;
    problems[0] = {n, matrix.begin(), stride, gaps.begin(), !is_new};
    solver.solve(problems, 1e-15, sets);
    pressure.assign(n, 0.);
    energy = 0.;
    for (unsigned int a = 0; a < sets[0].number.size(); ++a)
      {
        pressure[sets[0].number[a]] = sets[0].pressure[a];
        energy -= 0.5 * sets[0].pressure[a] * gaps[sets[0].number[a]]; // p C p / 2
      }
    for (unsigned int k = 0; k < x.size(); ++k)
      {
        double f = force[k] - square[k] * x[k];
        for (unsigned int i = 0; i < n; ++i)
          f += rows(i, k) * pressure[i];
        const double now = v[k] + 0.5 * dt * f;
        energy += 0.5 * now * now + 0.5 * square[k] * x[k] * x[k] - force[k] * x[k];
        v[k] += dt * f;
        x[k] += dt * v[k];
      }
  }

  /// Of all coordinates: it sways about zero where those of a rest sway about something else.
  double speed() const
  {
    double sum = 0.;
    for (const double u : v)
      sum += u * u;
    return std::sqrt(sum);
  }
};

System make_system(const unsigned int n_coordinates, const unsigned int n_gaps)
{
  System system;
  system.x = system.v = system.square = system.force = Coordinates(n_coordinates, 0.);
  system.gap.resize(n_gaps, 0.);
  system.rows.reinit(n_gaps, n_coordinates);
  system.flexibility.reinit(n_gaps, n_gaps);
  return system;
}

void two_masses()
{
  const double a = 0.003, b = 0.008, mass = a * b / (a + b), c = 5e-9, speed = 1.4;
  const double peak = speed * std::sqrt(mass / c), duration = PI * std::sqrt(mass * c);
  double       worst = 0., kept = 0., momentum = 0., time = 0.;
  for (const unsigned int n_steps : {40, 80, 160}) // while they touch
    for (const double phase : {0., 0.3, 0.7})
      {
        const double dt = duration / n_steps, sway = std::pow(PI / n_steps, 2) / 4.;
        System       s      = make_system(2, 1);
        s.gap[0]            = (2. + phase) * speed * dt;
        s.rows(0, 0)        = -1. / std::sqrt(a); // the first one moves towards the second
        s.rows(0, 1)        = 1. / std::sqrt(b);
        s.flexibility(0, 0) = c;
        s.v[0]              = speed * std::sqrt(a);
        std::vector<double> p;
        for (unsigned int n = 0; n < 2 * n_steps; ++n)
          {
            s.step(dt);
            p.push_back(s.pressure[0]);
          }
        worst = std::max(worst, std::abs(*std::max_element(p.begin(), p.end()) / peak - 1.) / sway);
        kept  = std::max(
            kept, std::abs((s.v[1] / std::sqrt(b) - s.v[0] / std::sqrt(a)) / speed - 1.) / sway);
        momentum = std::max(
            momentum, std::abs((std::sqrt(a) * s.v[0] + std::sqrt(b) * s.v[1]) / (a * speed) - 1.));
        const auto touch = std::count_if(p.begin(), p.end(), [](const double x) { return x > 0.; });
        time             = std::max(time, std::abs(double(touch) - n_steps));
      }
  std::cout << "two masses, 40 to 160 steps while they touch: peak to (omega dt)^2 / 4 "
            << yes(worst < 1.) << ", duration to a step " << yes(time <= 1.)
            << ", speed kept to (omega dt)^2 / 4 " << yes(kept < 1.) << ", momentum to 1e-12 "
            << yes(momentum < 1e-12) << '\n';
  if (with_numbers)
    std::cerr << worst << ' ' << time << ' ' << kept << '\n';
}

/// Whether a system all of whose gaps are closed is at no time in four thousand steps a hundred
/// times as fast as in the first one: below the limit central differences are 1 / sqrt(1 - r^2)
/// times as fast as the motion at the ratio r of step to limit, five times at 0.98, and above it
/// their speed grows by a factor in each step, 1.49 at 1.02. @p all_closed becomes whether all gaps
/// were closed until it ended, so that nothing but the closed system was tried.
bool is_bounded(System system, const double dt, bool &all_closed)
{
  system.step(dt);
  const double first = system.speed();
  for (unsigned int n = 0; n < 4000; ++n)
    {
      system.step(dt);
      all_closed = all_closed && system.sets[0].number.size() == system.gap.size();
      if (!(system.speed() < 100. * first))
        return false;
    }
  return true;
}

void print_limit(const System &system, const double omega)
{
  bool       closed = true;
  const bool below  = is_bounded(system, 0.98 * 2. / omega, closed),
             above  = is_bounded(system, 1.02 * 2. / omega, closed);
  std::cout << "bounded at 0.98 of 2/omega " << yes(below) << ", not at 1.02 " << yes(!above)
            << ", all closed " << yes(closed) << '\n';
}

void closed_mode()
{
  const double mass = 0.004, c = 5e-9, omega = 2. * PI * 40e3;
  System       s       = make_system(1, 1);
  s.rows(0, 0)         = 1. / std::sqrt(mass);
  s.square[0]          = omega * omega;
  s.flexibility(0, 0)  = c;
  const double highest = std::sqrt(omega * omega + 1. / (mass * c));
  s.force[0]           = -1000. / std::sqrt(mass);
  s.x[0]               = s.force[0] / (highest * highest);
  s.v[0]               = 1e-6 * highest * s.x[0];
  std::cout << "a closed mode: ";
  print_limit(s, highest);
}

/// Elastic modes of a bar that is free, up to the fortieth, and what they leave of the flexibility
/// of its end, L/(3 E A) relative to the centre of mass.
void bar_against_wall()
{
  const double       length = 0.1, area = 1e-4, modulus = 210e9, density = 7850., speed = 1.;
  const double       wave = std::sqrt(modulus / density), mass = density * area * length;
  const unsigned int n_modes = 40;
  System             s       = make_system(1 + n_modes, 1);
  double             left    = length / (3. * modulus * area);
  s.rows(0, 0)               = 1. / std::sqrt(mass);
  for (unsigned int k = 1; k <= n_modes; ++k)
    {
      s.square[k]  = std::pow(k * PI * wave / length, 2);
      s.rows(0, k) = std::sqrt(2. / mass);
      left -= 2. / (mass * s.square[k]);
    }
  s.flexibility(0, 0)   = left;
  s.gap[0]              = 1e-6;
  s.v[0]                = -speed * std::sqrt(mass);
  const double duration = 2. * length / wave, dt = duration / 4000.;
  double       first = -1., last = 0., impulse = 0., plateau = 0.;
  unsigned int n_plateau = 0;
  for (unsigned int n = 0; n < 8000; ++n)
    {
      s.step(dt);
      if (s.pressure[0] > 0.)
        {
          if (first < 0.)
            first = n * dt;
          last = n * dt;
          impulse += dt * s.pressure[0];
          const double since = (n * dt - first) / duration;
          if (since > 0.25 && since < 0.75)
            {
              plateau += s.pressure[0];
              ++n_plateau;
            }
        }
    }
  plateau /= n_plateau * area * std::sqrt(modulus * density) * speed;
  std::cout << "a bar against a wall: leaves after 2 L/c to 3 percent "
            << yes(std::abs((last - first) / duration - 1.) < 0.03) << ", turns round to 1 percent "
            << yes(std::abs(impulse / (2. * mass * speed) - 1.) < 0.01)
            << ", force between to 2 percent of that of the wave "
            << yes(std::abs(plateau - 1.) < 0.02) << '\n';
  if (with_numbers)
    std::cerr << (last - first) / duration << ' ' << impulse / (2. * mass * speed) << ' ' << plateau
              << '\n';
}

/// A mass with two modes between two walls, which three sides of it meet one after the other.
void no_drift()
{
  const double mass     = 0.004;
  System       s        = make_system(3, 3);
  s.square[1]           = std::pow(2. * PI * 25e3, 2);
  s.square[2]           = std::pow(2. * PI * 61e3, 2);
  s.gap                 = {20e-6, 23e-6, 20e-6};
  const double at[3][3] = {{1., 0.8, 0.5}, {1., -0.6, 0.9}, {-1., 0.7, -0.8}};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < 3; ++k)
      {
        s.rows(i, k)        = at[i][k] / std::sqrt(mass);
        s.flexibility(i, k) = i == k ? 4e-9 : i + k == 1 ? 1e-9 : -0.5e-9;
      }
  s.v[0]                              = -1.1 * std::sqrt(mass);
  s.v[1]                              = 0.2 * std::sqrt(mass);
  const std::vector<unsigned int> all = {0, 1, 2};
  dealii::FullMatrix<double>      rigid(3, 1), modes(3, 2);
  for (unsigned int i = 0; i < 3; ++i)
    {
      rigid(i, 0) = s.rows(i, 0);
      modes(i, 0) = s.rows(i, 1);
      modes(i, 1) = s.rows(i, 2);
    }
  const double omega = closed_frequency(
      {std::sqrt(s.square[1]), std::sqrt(s.square[2])}, rigid, modes, s.flexibility, all);
  const System start = s;
  double       sway  = 0.;
  for (const double relative : {0.2, 0.1}) // omega dt
    {
      s                  = start;
      const double bound = relative * relative / 4., dt = relative / omega;
      s.step(dt);
      const double first   = s.energy;
      double       largest = 0.;
      for (unsigned int n = 0; n < 100000; ++n)
        {
          s.step(dt);
          largest = std::max(largest, std::abs(s.energy / first - 1.) / bound);
        }
      sway = std::max(sway, largest);
      if (with_numbers)
        std::cerr << largest << '\n';
    }
  // of one oscillator that stays as it is the energy sways by (omega dt)^2 / 4
  std::cout << "a hundred thousand steps: energy stays what it was to (omega dt)^2 "
            << yes(sway < 4.) << '\n';
}

/// A roller with modes up to a frequency [rad/s] that is pressed all round on both sides, by gaps
/// which are closed from the start. Modes above the @p cap share their inertia out: what leaves
/// them is in the residual. Returns its frequency, rad/s.
double held_roller(const double modes_up_to, const double cap)
{
  const auto                 chain = drive::make_chain(parameters::Chain());
  const Material             material;
  const parameters::Elements elements;
  const mesh::Part           part =
      mesh::make_roller(chain, material.density, mesh::RollerGrid(1, 12, 4, true));
  const mesh::Nodes nodes(part);
  const FreePart    free(part, nodes, element::ElasticPart(part, nodes, material, elements));
  const double      half                = 0.5 * chain.roller_length;
  const std::vector<double>      bounds = {0., 0.5 * half, half};
  const std::vector<SidePatches> sides  = {{part, nodes, mesh::roller_outside, bounds},
                                           {part, nodes, mesh::roller_bore, bounds}};
  BasisOptions                   options;
  options.modes_up_to = modes_up_to;
  Basis basis         = make_basis(free, {}, options);
  share_inertia(basis, cap);
  const dealii::FullMatrix<double> rigid = patch_motions(sides, free.rigid()),
                                   modes = patch_motions(sides, basis.modes);
  const SideFlexibility residual =
      residual_flexibility(side_flexibility(free, sides), modes, basis.omega);
  const unsigned int n_sides = sides[0].n(), n = 2 * n_sides, n_rigid = rigid.n();

  std::vector<unsigned int> few, half_round, all;
  for (unsigned int i = 0; i < n; ++i)
    {
      all.push_back(i);
      if (i % n_sides < n_sides / 2)
        half_round.push_back(i);
      if (i < 4)
        few.push_back(i);
    }
  const auto of = [&](const std::vector<unsigned int> &closed) {
    return closed_frequency(basis.omega, rigid, modes, residual, closed);
  };
  const double highest = of(all);
  std::cout << "a roller: the frequency grows with what is closed "
            << yes(of({}) < of(few) && of(few) < of(half_round) && of(half_round) < highest)
            << '\n';

  // sides are pressed together: forces push the bore outwards and the outside inwards
  System           s    = make_system(n_rigid + basis.size(), n);
  constexpr double load = 1000.; // N
  for (unsigned int m = 0; m < basis.size(); ++m)
    s.square[n_rigid + m] = basis.omega[m] * basis.omega[m];
  for (unsigned int i = 0; i < n; ++i)
    {
      const double sign_i = i < n_sides ? -1. : 1.;
      for (unsigned int m = 0; m < n_rigid + basis.size(); ++m)
        s.rows(i, m) = sign_i * (m < n_rigid ? rigid(i, m) : modes(i, m - n_rigid));
      for (unsigned int j = 0; j < n; ++j)
        {
          s.flexibility(i, j) = sign_i * (j < n_sides ? -1. : 1.) * residual(i, j);
          s.gap[i] -= load * s.flexibility(i, j); // at rest this load on each patch
        }
    }
  // by which the modes are held as well
  for (unsigned int m = 0; m < s.x.size(); ++m)
    {
      for (unsigned int i = 0; i < n; ++i)
        s.force[m] -= load * s.rows(i, m);
      s.v[m] = 1e-7 * (1. + 0.1 * m);
    }
  std::cout << "it is ";
  print_limit(s, highest);

  // two of them pressed together on their whole outsides, all of it closed
  const unsigned int         n_one = n_rigid + basis.size();
  std::vector<double>        omega;
  dealii::FullMatrix<double> none(n_sides, 0), both(n_sides, 2 * n_one);
  SideFlexibility            sum(n_sides, n_sides);
  for (unsigned int body = 0; body < 2; ++body)
    for (unsigned int m = 0; m < n_one; ++m)
      {
        omega.push_back(m < n_rigid ? 0. : basis.omega[m - n_rigid]);
        for (unsigned int i = 0; i < n_sides; ++i)
          both(i, body * n_one + m) =
              (body == 0 ? 1. : -1.) * (m < n_rigid ? rigid(i, m) : modes(i, m - n_rigid));
      }
  std::vector<unsigned int> outside;
  for (unsigned int i = 0; i < n_sides; ++i)
    {
      outside.push_back(i);
      for (unsigned int j = 0; j < n_sides; ++j)
        sum(i, j) = 2. * residual(i, j);
    }
  const double together = closed_frequency(omega, none, both, sum, outside), alone = of(outside);
  std::cout << "two that touch are as fast as one that is held, when they move in opposition "
            << yes(std::abs(together / alone - 1.) < 1e-9) << '\n';

  System pair = make_system(2 * n_one, n_sides);
  pair.rows   = both;
  for (unsigned int i = 0; i < n_sides; ++i)
    for (unsigned int j = 0; j < n_sides; ++j)
      {
        pair.flexibility(i, j) = sum(i, j);
        pair.gap[i] -= load * sum(i, j);
      }
  for (unsigned int m = 0; m < 2 * n_one; ++m)
    {
      pair.square[m] = omega[m] * omega[m];
      for (unsigned int i = 0; i < n_sides; ++i)
        pair.force[m] -= load * pair.rows(i, m);
      pair.v[m] = 1e-7 * (1. + 0.1 * m);
    }
  std::cout << "the two, with the limit of one that is held, are ";
  print_limit(pair, alone);
  return highest;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  with_numbers = argc > 1;
  two_masses();
  closed_mode();
  bar_against_wall();
  no_drift();
  const double none = std::numeric_limits<double>::infinity(), kHz = 2e3 * PI;
  held_roller(120. * kHz, none);
  std::cout
      << "a roller with modes up to 200 kHz, as they are and with inertia shared out above 80\n";
  const double fast = held_roller(200. * kHz, none), slow = held_roller(200. * kHz, 80. * kHz);
  if (with_numbers)
    std::cerr << "slower by " << slow / fast << '\n';
  std::cout << "the step is longer by a fifth " << yes(slow < fast / 1.2) << '\n';
}
