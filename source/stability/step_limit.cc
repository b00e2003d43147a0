// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/run.h>
#include <chaindrive/stability/closed_contact.h>
#include <chaindrive/stability/critical_time_step.h>
#include <chaindrive/stability/step_limit.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

namespace chaindrive::stability
{
std::vector<TimeStepLimit> step_limits(const World             &world,
                                       const Bars              &bars,
                                       const ForceElements     &forces,
                                       const contact::Contacts &contacts,
                                       statics::Cache          *kept)
{
  std::vector<TimeStepLimit> limits;
  std::vector<Spring>        springs;
  if (bars.size() > 0)
    {
      bars.add_springs(world, springs);
      limits.push_back({"bars", critical_time_step(world, springs)});
    }
  for (const auto &element : forces)
    {
      springs.clear();
      element->add_springs(world, springs);
      limits.push_back({element->name(), critical_time_step(world, springs)});
    }
  for (const ElasticGroup *group : world.groups.elastic())
    limits.push_back({"elements of the " + world.copies[group->copies()].part->name,
                      group->critical_time_step()});
  for (const auto &family : contacts.families())
    {
      springs.clear();
      family->add_springs(world, springs);
      const double limit = std::min(critical_time_step(world, springs),
                                    closed_contact_time_step(world, *family, kept));
      // families of rigid and of elastic bodies share a name
      const auto same = std::find_if(limits.begin(), limits.end(), [&](const TimeStepLimit &other) {
        return other.source == family->name();
      });
      if (same == limits.end())
        limits.push_back({family->name(), limit});
      else
        same->limit = std::min(same->limit, limit);
    }
  return limits;
}

double step_limit(const World             &world,
                  const Bars              &bars,
                  const ForceElements     &forces,
                  const contact::Contacts &contacts,
                  const double             drag,
                  statics::Cache          *kept)
{
  std::vector<Spring> springs;
  bars.add_springs(world, springs);
  for (const auto &element : forces)
    element->add_springs(world, springs);
  contacts.add_springs(world, springs);
  double limit = critical_time_step(world, springs);

  for (const ElasticGroup *group : world.groups.elastic())
    limit = std::min(limit, group->critical_time_step());
  limit = closed_contact_time_step(world, contacts, limit, kept);
  return drag > 0. ? 1. / (1. / limit + 0.5 * drag) : limit;
}

TimeStepChoice choose_time_step(const World             &world,
                                const Bars              &bars,
                                const ForceElements     &forces,
                                const contact::Contacts &contacts,
                                const double             drag,
                                const parameters::Time  &time,
                                statics::Cache          *kept)
{
  TimeStepChoice choice;
  choice.step_limits   = step_limits(world, bars, forces, contacts, kept);
  choice.limit         = step_limit(world, bars, forces, contacts, drag, kept);
  const double largest = time.safety_factor * choice.limit;
  if (time.step)
    {
      if (*time.step > largest)
        throw InputError(
            "Time/Time step in us = " + to_text(*time.step * 1e6) +
            " is above the critical time step: at most " + to_text_at_most(largest * 1e6, 4) +
            " us (safety factor " + to_text(time.safety_factor) + " times the limit " +
            to_text(choice.limit * 1e6, 4) + " us) is allowed; choose a smaller step or auto.");
      choice.step   = *time.step;
      choice.reason = "asked for";
      return choice;
    }
  // The fastest mode has the period pi times the limit; a twelfth of it leaves its frequency 1 %
  // wrong, and an impact of half its period six steps. With elastic bodies the fastest mode is one
  // of the mesh: what matters is slower by far.
  const double accurate =
      world.has_elastic_bodies() ? largest : dealii::numbers::PI * choice.limit / 12.;
  choice.step   = std::min(largest, accurate);
  choice.reason = accurate < largest ? "auto: a twelfth of the shortest period" :
                                       "auto: the critical time step times the safety factor";
  return choice;
}
} // namespace chaindrive::stability
