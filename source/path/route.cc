// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/path/route.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::path
{
namespace
{
/// What is laid so far, from joint 0 against the travel: the seat on wheel 0 and the spans before
/// it.
struct Beginning
{
  Laid         laid;
  unsigned int joint; ///< in the last seat of the first wheel that has been reached
};

bool have_tangents(const std::vector<Wheel> &wheels)
{
  for (std::size_t i = 0; i < wheels.size(); ++i)
    if (!std::isfinite(tangent_angle(wheels[i], wheels[(i + 1) % wheels.size()])))
      return false;
  return true;
}

/// Entry seats of a wheel whose last seat is at @p exit, some links before it near where the
/// tangent from the wheel before touches.
std::vector<int> wraps_near_tangent(const Wheel &before, const Wheel &wheel, const double exit)
{
  const int        nominal = links_on(wheel, touching(wheel, tangent_angle(before, wheel)), exit);
  std::vector<int> wraps;
  for (int links = std::max(0, nominal - 1); links <= nominal + 1; ++links)
    wraps.push_back(links);
  return wraps;
}

/// The chain that has come to wheel 0 by the straight span @p last.
Beginning
begin(const std::vector<Wheel> &wheels, const Chain &chain, const int gap, const TautSpan &last)
{
  const std::size_t n = wheels.size();
  Beginning         result{{}, chain.n_links - last.links};
  Laid             &laid = result.laid;
  laid.route             = {gap, std::vector<unsigned int>(n), std::vector<int>(n)};
  laid.entry.assign(n, 0.);
  laid.taut.resize(n - 1);
  laid.taut.back()        = last;
  laid.route.spans.back() = last.links;
  laid.entry[0]           = last.entry;
  laid.misfit             = last.misfit;
  return result;
}

/// Lays wheel @p i and the straight span before it, with @p wrap links on the wheel.
void set_beginning(Beginning &to, const unsigned int i, const int wrap, const TautSpan &span)
{
  to.laid.route.wraps[i]     = wrap;
  to.laid.route.spans[i - 1] = span.links;
  to.laid.entry[i]           = span.entry;
  to.laid.taut[i - 2]        = span;
  to.laid.misfit += span.misfit;
  to.joint -= wrap + span.links;
}

/// What span 0 closes.
Gap gap_of(const std::vector<Wheel> &wheels, const Beginning &beginning)
{
  return {wheels[0],
          wheels[1],
          beginning.laid.entry[0],
          beginning.laid.taut.front().exit,
          beginning.joint};
}

Laid close(const std::vector<Wheel> &wheels, Beginning beginning, const SlackSpan &slack)
{
  Laid &laid          = beginning.laid;
  laid.slack          = slack;
  laid.route.wraps[0] = slack.links_before;
  laid.route.wraps[1] = slack.links_after;
  laid.entry[1]       = wheels[1].after(laid.taut.front().exit, -slack.links_after);
  laid.misfit += slack.misfit;
  return laid;
}
} // namespace

std::vector<Laid> lay_all(const std::vector<Wheel> &wheels,
                          const Chain              &chain,
                          const bool                straight,
                          const unsigned int        most)
{
  if (!have_tangents(wheels))
    return {};
  const unsigned int        n       = static_cast<unsigned int>(wheels.size());
  const std::vector<double> entries = entries_near_tangent(wheels[n - 1], wheels[0], chain.phase);
  auto lasts = taut_spans(wheels[n - 1], wheels[0], chain.taut, chain.n_links, entries);
  lasts.resize(std::min<std::size_t>(lasts.size(), most));

  std::vector<Laid> result;
  for (const TautSpan &last : lasts)
    {
      const int gap       = static_cast<int>(std::find(entries.begin(), entries.end(), last.entry) -
                                       entries.begin() - 1);
      Beginning beginning = begin(wheels, chain, gap, last);
      bool      possible  = true;
      // the wheels between, each with the span before it that fits best
      for (unsigned int i = n - 1; i > 1 && possible; --i)
        {
          const double exit = beginning.laid.taut[i - 1].exit;
          int          wrap = 0;
          TautSpan     best{};
          for (const int links : wraps_near_tangent(wheels[i - 1], wheels[i], exit))
            if (links < static_cast<int>(beginning.joint))
              for (const TautSpan &span : taut_spans(wheels[i - 1],
                                                     wheels[i],
                                                     chain.taut,
                                                     beginning.joint - links,
                                                     {wheels[i].after(exit, -links)}))
                if (best.links == 0 || span.misfit < best.misfit)
                  {
                    best = span;
                    wrap = links;
                  }
          possible = best.links > 0;
          if (possible)
            set_beginning(beginning, i, wrap, best);
        }
      if (possible)
        for (const SlackSpan &slack :
             slack_spans(gap_of(wheels, beginning), chain.slack, straight ? 0 : chain.bulge))
          result.push_back(close(wheels, beginning, slack));
    }
  std::stable_sort(result.begin(), result.end(), [](const Laid &a, const Laid &b) {
    return a.misfit < b.misfit;
  });
  return result;
}

std::optional<Laid> lay(const std::vector<Wheel> &wheels, const Chain &chain, const Route &route)
{
  if (!have_tangents(wheels))
    return {};
  const unsigned int        n       = static_cast<unsigned int>(wheels.size());
  const std::vector<double> entries = entries_near_tangent(wheels[n - 1], wheels[0], chain.phase);
  const TautSpan            last    = taut_span(wheels[n - 1],
                                  wheels[0],
                                  chain.taut,
                                  chain.n_links,
                                  entries.at(route.gap + 1),
                                  route.spans.back());
  if (last.links == 0)
    return {};
  Beginning beginning = begin(wheels, chain, route.gap, last);
  for (unsigned int i = n - 1; i > 1; --i)
    {
      const int      wrap = route.wraps[i];
      const TautSpan span = taut_span(wheels[i - 1],
                                      wheels[i],
                                      chain.taut,
                                      beginning.joint - wrap,
                                      wheels[i].after(beginning.laid.taut[i - 1].exit, -wrap),
                                      route.spans[i - 1]);
      if (span.links == 0)
        return {};
      set_beginning(beginning, i, wrap, span);
    }
  const SlackSpan slack = slack_span(
      gap_of(wheels, beginning), chain.slack, chain.bulge, route.wraps[0], route.wraps[1]);
  return close(wheels, beginning, slack);
}

std::vector<Joint> joints(const std::vector<Wheel> &wheels, const Chain &chain, const Laid &laid)
{
  std::vector<Joint> all;
  for (unsigned int i = 0; i < wheels.size(); ++i)
    {
      for (int s = 0; s <= laid.route.wraps[i]; ++s)
        {
          const double seat = wheels[i].after(laid.entry[i], s);
          all.push_back({wheels[i].roller(seat),
                         wheels[i].bush(seat, static_cast<unsigned int>(all.size())),
                         static_cast<int>(i),
                         s});
        }
      std::vector<dealii::Point<2>> between;
      if (i == 0)
        between = slack_joints(laid.slack, chain.slack);
      else
        {
          const TautSpan            &span  = laid.taut[i - 1];
          const dealii::Tensor<1, 2> along = (span.to - span.from) / span.from.distance(span.to);
          const unsigned int         first = static_cast<unsigned int>(all.size()) - 1;
          for (unsigned int k = 1; k < span.links; ++k)
            between.push_back(span.from + chain.taut.sum(first, k) * along);
        }
      for (const dealii::Point<2> &p : between)
        all.push_back({p, p, -1, -1});
    }
  return all;
}
} // namespace chaindrive::path
