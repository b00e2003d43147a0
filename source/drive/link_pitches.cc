// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/equilibrium.h>
#include <chaindrive/drive/link_pitches.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/random.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace chaindrive::drive
{
using Vector = dealii::Tensor<1, 2>;

namespace
{
/// The entry that gives links their own pitches, with its value in short.
std::string entry_of(const parameters::Chain &chain)
{
  return chain.pitch_deviations.empty() ?
             "Drive/Chain/Pitch tolerance in percent = " + to_text(100. * chain.pitch_tolerance) :
             "Drive/Chain/Pitch deviations in um, a list of " +
                 std::to_string(chain.pitch_deviations.size()) + ",";
}

/// Takes the mean of every @p stride th deviation from @p first on away from them.
double take_mean(std::vector<double> &deviations, const std::size_t first, const std::size_t stride)
{
  double      sum = 0.;
  std::size_t n   = 0;
  for (std::size_t k = first; k < deviations.size(); k += stride, ++n)
    sum += deviations[k];
  for (std::size_t k = first; k < deviations.size(); k += stride)
    deviations[k] -= sum / n;
  return sum / n;
}
} // namespace

ChainDimensions LinkPitches::in(ChainDimensions chain) const
{
  chain.inner_hole_pitch += inner;
  chain.outer_hole_pitch += outer;
  return chain;
}

std::string LinkPitches::in_words() const
{
  double least = 1., most = -1., sum = 0.;
  for (std::size_t k = 0; k < deviations.size(); ++k)
    {
      const double whole = deviations[k] + (k % 2 == 0 ? inner : outer);
      least              = std::min(least, whole);
      most               = std::max(most, whole);
      sum += whole;
    }
  return "Pitches of links deviate by " + to_text(least * 1e6, 4) + " to " +
         to_text(most * 1e6, 4) + " um, by " + to_text(sum * 1e6, 4) + " um in sum.";
}

LinkPitches make_link_pitches(const parameters::Drive &drive,
                              const double             pitch,
                              const bool               clearances,
                              const bool               is_elastic)
{
  const parameters::Chain   &chain     = drive.chain;
  const std::vector<double> &listed    = chain.pitch_deviations;
  const double               tolerance = chain.pitch_tolerance;
  LinkPitches                links;
  if (listed.empty() && tolerance == 0.)
    return links;
  const std::string entry = entry_of(chain);
  if (!listed.empty() && tolerance > 0.)
    throw InputError(entry + " and Pitch tolerance in percent = " + to_text(100. * tolerance) +
                     " both say what the pitches of links are; choose 0 for the tolerance, or no "
                     "list.");
  if (!listed.empty() && drive.n_links % listed.size() != 0)
    throw InputError(entry + " does not go into the chain of " + std::to_string(drive.n_links) +
                     " links a whole number of times; give one for each link, or for a part of the "
                     "chain that repeats.");
  if (is_elastic)
    throw InputError(entry + " gives links lengths of their own, but elastic links of one kind "
                             "share one mesh; choose the fidelity simple or layered, or links that "
                             "are the same.");
  if (drive.layout.start == parameters::Start::concentric)
    throw InputError(entry + " cannot be with Drive/Layout/Start = concentric, in which the "
                             "chain on the sprockets is not of the length of its links; choose "
                             "taut or settled.");
  const double sum = std::accumulate(listed.begin(), listed.end(), 0.);
  if (sum < -1e-15)
    throw InputError(entry + " has the sum " + to_text(1e6 * sum) +
                     ": a chain shorter than its nominal length, which standards do not have, does "
                     "not fit its sprockets; choose deviations whose sum is at least 0.");
  std::mt19937_64 generator(chain.pitch_seed);
  for (unsigned int k = 0; k < drive.n_links; ++k)
    links.deviations.push_back(listed.empty() ?
                                   tolerance * pitch * (2. * even_random(generator) - 1.) :
                                   listed[k % listed.size()]);
  const bool alternate = clearances || listed.empty();
  links.inner          = take_mean(links.deviations, 0, alternate ? 2 : 1);
  links.outer          = alternate ? take_mean(links.deviations, 1, 2) : links.inner;
  if (listed.empty()) // such a chain has its nominal length
    links.inner = links.outer = 0.;
  return links;
}

void shift_joints(Layout &layout, const LinkPitches &links)
{
  if (links.are_equal())
    return;
  const std::size_t   n = layout.joints.size(), n_wheels = layout.sprockets.size();
  std::vector<double> ahead(n, 0.); // of where equal pitches put them, m
  std::partial_sum(links.deviations.begin(), links.deviations.end() - 1, ahead.begin() + 1);

  std::vector<double> on_wheel(n_wheels, 0.); // mean
  for (std::size_t k = 0; k < n; ++k)
    if (const int wheel = layout.joints[k].sprocket; wheel >= 0)
      on_wheel[wheel] += ahead[k] / layout.sprockets[wheel].seats;
  std::vector<Vector> by(n);
  for (std::size_t k = 0; k < n; ++k)
    {
      const Vector along = layout.joints[(k + 1) % n].bush - layout.joints[(k + n - 1) % n].bush;
      by[k]              = (ahead[k] - on_wheel[0]) / along.norm() * along;
    }
  for (std::size_t i = 1; i < n_wheels; ++i)
    {
      Layout::Sprocket &wheel = layout.sprockets[i];
      const Vector      arm   = layout.joints[layout.spans[i].first].bush - wheel.centre;
      wheel.angle += layout.sense * wheel.turn * (on_wheel[i] - on_wheel[0]) / arm.norm();
    }
  for (std::size_t k = 0; k < n; ++k)
    {
      layout.joints[k].bush += by[k];
      layout.joints[k].roller += by[k];
    }
  set_links(layout);
}

void fit_links(Layout &layout, const RestingChain &chain, const std::vector<RestingWheel> &wheels)
{
  constexpr double         tolerance = 1e-3; // N, of 1 N/um and more
  RestingChain             unloaded  = chain;
  std::optional<Tensioner> tensioner;
  unloaded.weight = 0.;
  std::swap(tensioner, layout.tensioner);
  Equilibrium equilibrium(layout, unloaded, wheels);
  if (!equilibrium.solve(tolerance))
    throw InputError(
        "Drive: pitches of links (Chain/Pitch tolerance in percent, Pitch deviations in "
        "um) or tooth gaps (Wheels/.../Index tolerance in um, Index deviations in um) "
        "differ so much that rollers do not fit into their gaps; choose smaller ones.");
  equilibrium.store();
  std::swap(tensioner, layout.tensioner);
}
} // namespace chaindrive::drive
