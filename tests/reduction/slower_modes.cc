// SPDX-License-Identifier: LGPL-2.1-or-later
// Slowed modes. A link that gets mass keeps the statics of all loads to round-off, its slow modes
// bit by bit, and, held in both joints, its lowest frequencies to 1 %. A roller that shares its
// inertia out keeps the statics of pressures, on one side and through the wall, to round-off; what
// it deflects under a force of the frequency w differs from before by the fourth power of w, that
// of one with more mass by the second. A limit above all modes changes nothing.
#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/reduction/slower_modes.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <cmath>
#include <iostream>
#include <utility>

using namespace chaindrive;
using namespace reduction;
using dealii::numbers::PI;

namespace
{
bool        with_numbers = false; ///< behind the verdicts: if there is an argument
const char *yes(const bool good) { return good ? "yes" : "NO"; }

constexpr double kHz = 2e3 * PI;

/// Half a part with its natural modes up to a frequency.
struct HalfPart
{
  HalfPart(mesh::Part &&made, const double modes_up_to)
      : part(std::move(made))
      , nodes(part)
      , free(part, nodes, element::ElasticPart(part, nodes, Material(), parameters::Elements()))
  {
    BasisOptions options;
    options.modes_up_to = modes_up_to;
    basis               = make_basis(free, {}, options);
    const auto surfaces = part.mesh->get_boundary_ids();
    is_roller           = std::count(surfaces.begin(), surfaces.end(), mesh::roller_outside) != 0;
    basis.joints        = round_flexibilities(free, part, nodes, basis, is_roller);
  }

  mesh::Part  part;
  mesh::Nodes nodes;
  FreePart    free;
  Basis       basis;
  bool        is_roller;
};

/// The largest part by which the statics of contact loads change from @p before to @p after.
double changed_statics(const HalfPart &part, const Basis &before, const Basis &after)
{
  double worst = 0.;
  for (const Load &load : contact_loads(part.part, part.nodes))
    if (!part.is_roller || load.name.find("turn") == std::string::npos)
      worst = std::max(
          worst,
          std::abs(static_compliance(after, load.force) / static_compliance(before, load.force) -
                   1.));
  return worst;
}

/// The three lowest frequencies of elastic modes on springs that the pulls at both joints stretch.
std::vector<double> held_frequencies(const HalfPart &part, const Basis &basis)
{
  const unsigned int         n = basis.size();
  dealii::FullMatrix<double> matrix(n, n);
  for (unsigned int i = 0; i < n; ++i)
    matrix(i, i) = basis.omega[i] * basis.omega[i];
  for (const Load &load : contact_loads(part.part, part.nodes))
    {
      // as stiff as the part itself under this load
      const double stiffness = 1. / static_compliance(part.basis, load.force);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) += stiffness * (load.force * basis.modes[i]) * (load.force * basis.modes[j]);
    }
  const auto values = eigenpairs(matrix).values;
  return {std::sqrt(values[0]), std::sqrt(values[1]), std::sqrt(values[2])};
}

void link_with_more_mass()
{
  const auto     chain = drive::make_chain(parameters::Chain());
  const HalfPart link(mesh::make_inner_link(chain, 7800., {16, 1, 1, 1, 4, true}), 120. * kHz);
  Basis          slowed = link.basis;
  const double   cap    = 60. * kHz;
  add_mass(slowed, cap);
  bool         slow_ones = true, fast_ones = true;
  unsigned int n = 0;
  for (unsigned int m = 0; m < slowed.size(); ++m)
    if (link.basis.omega[m] > cap)
      {
        ++n;
        fast_ones = fast_ones && slowed.omega[m] == cap;
      }
    else
      slow_ones = slow_ones && slowed.omega[m] == link.basis.omega[m] &&
                  slowed.modes[m] == link.basis.modes[m];
  const double statics = changed_statics(link, link.basis, slowed);
  double       lower   = 0.;
  const auto   was = held_frequencies(link, link.basis), is = held_frequencies(link, slowed);
  for (unsigned int i = 0; i < 3; ++i)
    {
      const double change = 1. - is[i] / was[i];
      lower               = change > -1e-12 ? std::max(lower, change) : 1.;
      if (with_numbers)
        std::cerr << "held at " << was[i] / kHz << " kHz, slowed " << is[i] / kHz << '\n';
    }
  if (with_numbers)
    std::cerr << n << " of " << slowed.size() << " slowed, statics " << statics << '\n';
  std::cout << "a link with more mass: modes are slowed " << yes(n > 3 && n == slowed.n_slowed)
            << ", to the limit " << yes(fast_ones) << ", the others are as before "
            << yes(slow_ones) << ", statics to 1e-12 " << yes(statics < 1e-12)
            << ", frequencies of the link in its joints lower by up to 1 % "
            << yes(lower > 1e-6 && lower < 0.01) << '\n';
}

/// What @p to, a load on the outside, does on the way by which pressure @p from in the bore makes
/// it go, J: by modes and through the wall.
double through_wall(const Basis &basis, const Vector &from, const Vector &to)
{
  double sum = 0.;
  for (unsigned int m = 0; m < basis.size(); ++m)
    sum += (from * basis.modes[m]) * (to * basis.modes[m]) / (basis.omega[m] * basis.omega[m]);
  const RoundFlexibility &bore = basis.joints.front(), &outside = basis.joints.back();
  const unsigned int      n = bore.n_columns;
  const auto away           = [n](const Vector &f, const RoundFlexibility &side, unsigned int i) {
    const double angle = 2. * PI * (i % n) / n;
    return std::cos(angle) * f[3 * side.node[i]] + std::sin(angle) * f[3 * side.node[i] + 1];
  };
  for (unsigned int i = 0; i < outside.node.size(); ++i)
    for (unsigned int j = 0; j < bore.node.size(); ++j)
      sum += away(to, outside, i) * away(from, bore, j) *
             outside.to_bore[(i / n * bore.n_rings() + j / n) * n + (j % n + n - i % n) % n];
  return sum;
}

/// What the part deflects under @p force of the angular frequency @p w, times the force, J.
double response(const Basis &basis, const Vector &force, const double w)
{
  double sum = 0.;
  for (unsigned int m = 0; m < basis.size(); ++m)
    {
      const double along = force * basis.modes[m], omega = basis.omega[m];
      sum += along * along * (1. / (omega * omega - w * w) - 1. / (omega * omega));
    }
  return sum + static_compliance(basis, force);
}

void roller_with_shared_inertia()
{
  const auto     chain = drive::make_chain(parameters::Chain());
  const HalfPart roller(mesh::make_roller(chain, 7800., mesh::RollerGrid(1, 16, 4, true)),
                        130. * kHz);
  const double   cap    = 80. * kHz;
  Basis          shared = roller.basis, heavy = roller.basis, same = roller.basis;
  share_inertia(shared, cap);
  add_mass(heavy, cap);
  share_inertia(same, 1e3 * kHz);
  const double      statics = changed_statics(roller, roller.basis, shared);
  double            wall    = 0.;
  std::vector<Load> on_outside, in_bore;
  for (const Load &load : contact_loads(roller.part, roller.nodes))
    if (load.name.find("turn") == std::string::npos)
      (load.name.find("outside") != std::string::npos ? on_outside : in_bore).push_back(load);
  double       least = 1e3, most = 0., least_heavy = 1e3, most_heavy = 0.;
  unsigned int n_loads = 0;
  for (const Load &load : on_outside)
    {
      for (const Load &other : in_bore)
        {
          const double was   = through_wall(roller.basis, other.force, load.force),
                       scale = std::sqrt(static_compliance(roller.basis, load.force) *
                                         static_compliance(roller.basis, other.force));
          wall =
              std::max(wall, std::abs(through_wall(shared, other.force, load.force) - was) / scale);
        }
      const auto error = [&](const Basis &basis, const double w) {
        return response(basis, load.force, w) - response(roller.basis, load.force, w);
      };
      const double w = 8. * kHz;
      if (std::abs(error(heavy, w)) < 1e-6 * static_compliance(roller.basis, load.force))
        continue; // it does not press three waves on the roller, which alone are slowed
      ++n_loads;
      const double ratio       = error(shared, 2. * w) / error(shared, w),
                   ratio_heavy = error(heavy, 2. * w) / error(heavy, w);
      if (with_numbers)
        std::cerr << load.name << ": at 20 kHz "
                  << error(shared, 20. * kHz) / static_compliance(roller.basis, load.force)
                  << ", with mass "
                  << error(heavy, 20. * kHz) / static_compliance(roller.basis, load.force)
                  << ", ratios " << ratio << " and " << ratio_heavy << '\n';
      least       = std::min(least, ratio);
      most        = std::max(most, ratio);
      least_heavy = std::min(least_heavy, ratio_heavy);
      most_heavy  = std::max(most_heavy, ratio_heavy);
    }
  if (with_numbers)
    std::cerr << shared.n_slowed << " slowed, statics " << statics << ", wall " << wall << '\n';
  std::cout << "a roller with shared inertia: modes are slowed "
            << yes(shared.n_slowed == 2 && shared.omega.back() == cap) << ", statics to 1e-11 "
            << yes(statics < 1e-11) << ", through the wall to 1e-11 " << yes(wall < 1e-11)
            << ", errors grow with the fourth power of the frequency "
            << yes(n_loads == 2 && least > 16. && most < 17.) << ", with more mass with the second "
            << yes(least_heavy > 4. && most_heavy < 4.2) << '\n';
  std::cout << "a limit above all modes: nothing changes "
            << yes(same.n_slowed == 0 && same.omega == roller.basis.omega &&
                   same.modes == roller.basis.modes &&
                   same.joints.back().value == roller.basis.joints.back().value)
            << '\n';
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  with_numbers = argc > 1;
  link_with_more_mass();
  roller_with_shared_inertia();
}
