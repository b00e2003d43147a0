// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/programs.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace chaindrive::drive
{
namespace
{
using functions::Term;
using functions::Variable;

functions::Pointer constant(const double value)
{
  return std::make_shared<functions::Constant>(value);
}

/// Another value from the time @p place on.
functions::Pointer step(const double before, const double place, const double after)
{
  return std::make_shared<functions::Steps>(
      before, std::vector<double>{place}, std::vector<double>{after});
}

/// A ramp of speed with @p terms.
functions::Pointer
with_terms(const functions::Pointer &ramp, const std::vector<Term> &terms, const double start)
{
  std::vector<functions::Pointer> sum = {ramp}, of_angle;
  for (const Term &term : terms)
    if (term.variable == Variable::angle)
      of_angle.push_back(term.function);
    else if (!term.replaces)
      sum.push_back(term.function);
  functions::Pointer speed = sum.size() == 1 ? ramp : std::make_shared<functions::Sum>(sum);
  for (const functions::Pointer &g : of_angle)
    speed = std::make_shared<functions::Fluctuating>(speed, g, start);
  return speed;
}

void set_speed(ShaftProgram             &program,
               const functions::Shaft   &shaft,
               const std::vector<Term>  &terms,
               const functions::Pointer &ramp)
{
  program.run_up = ramp;
  for (const Term &term : terms)
    if (term.replaces)
      {
        for (const Term &other : terms)
          if (!other.replaces && other.variable == Variable::time)
            throw InputError(shaft.section + ": a speed that is a table does not change otherwise; "
                                             "give File of Table or Times in ms of Changes.");
        program.run_up = term.function;
      }
  program.speed = with_terms(program.run_up, terms, shaft.start);
}
} // namespace

ShaftProgram::ShaftProgram()
    : torque(constant(0.)), torque_share(constant(1.)), torque_added(constant(0.))
{
}

double
ShaftProgram::lasting_torque(const double turned, const double time, const double speed) const
{
  double sum = torque->value(turned);
  for (const Term &term : terms)
    switch (term.variable)
      {
      case Variable::time:
        sum += term.function->value(time);
        break;
      case Variable::angle:
        sum += (growth ? growth->value(turned) : 1.) * term.function->value(turned);
        break;
      case Variable::speed:
        sum += term.function->value(speed);
        break;
      }
  return share * sum;
}

double ShaftProgram::mean_torque(const double start, const double end, const double speed) const
{
  // over whole pairs of revolutions, in which waves of half orders come to nothing
  const double pair   = 4. * dealii::numbers::PI;
  const double turned = pair * std::max(1., std::round(speed * (end - start) / pair));
  double       sum    = torque->value(1e9); // grown to its full value
  for (const Term &term : terms)
    switch (term.variable)
      {
      case Variable::time:
        sum += term.function->integral(start, end) / (end - start);
        break;
      case Variable::angle:
        sum += term.function->integral(0., turned) / turned;
        break;
      case Variable::speed:
        sum += term.function->value(speed);
        break;
      }
  return share * sum;
}

double ShaftProgram::largest_torque(const double start, const double end, const double speed) const
{
  double sum = torque->largest(0., 1e9);
  for (const Term &term : terms)
    switch (term.variable)
      {
      case Variable::time:
        sum += term.function->largest(start, end);
        break;
      case Variable::angle:
        sum += term.function->largest(0., std::max(speed * (end - start), 1e-6));
        break;
      case Variable::speed:
        sum += term.function->largest(0., speed);
        break;
      }
  return share * sum;
}

double ShaftProgram::last_change(const double start) const
{
  double     last = start;
  const auto look = [&](const functions::Pointer &of_time) {
    if (of_time)
      last = std::max(last, functions::last_breakpoint(*of_time, start));
  };
  for (const functions::Pointer &of_time : {speed, torque_share, torque_added})
    look(of_time);
  for (const Term &term : terms)
    if (term.variable == Variable::time)
      look(term.function);
  return last;
}

ShaftProgram make_program(const parameters::Sprocket     &sprocket,
                          const parameters::Loads        &loads,
                          const double                    start,
                          const bool                      settled,
                          const std::vector<std::string> &folders,
                          const double                    share)
{
  using functions::Ramp;
  ShaftProgram program;
  program.share = share;
  std::vector<Term> terms;
  const double      ramp_time = settled ? 0. : loads.ramp_time;
  functions::Shaft  shaft{
      "Loads/" + sprocket.name, folders, start, start + ramp_time, loads.driver_speed};
  switch (sprocket.role)
    {
    case parameters::Role::driver:
      terms = make_terms(functions::Of::speed, sprocket.speed_terms, shaft);
      set_speed(program,
                shaft,
                terms,
                std::make_shared<Ramp>(loads.driver_speed,
                                       start,
                                       ramp_time,
                                       loads.speed_ramp == parameters::SpeedRamp::cosine ?
                                           functions::Rise::cosine :
                                           functions::Rise::linear));
      break;
    case parameters::Role::driven:
      {
        const double torque = sprocket.resisting_torque.value_or(loads.resisting_torque);
        terms               = make_terms(functions::Of::torque, sprocket.torque_terms, shaft);
        program.terms       = terms;
        if (settled)
          program.torque = constant(torque);
        else
          {
            program.torque = std::make_shared<Ramp>(torque, 0., loads.torque_ramp_angle);
            program.growth = std::make_shared<Ramp>(1., 0., loads.torque_ramp_angle);
          }
        if (loads.torque_step_time && !sprocket.resisting_torque)
          {
            const double time    = start + *loads.torque_step_time;
            program.torque_share = step(1., time, 0.);
            program.torque_added = step(0., time, loads.torque_after_step);
          }
        break;
      }
    case parameters::Role::idler:
      break;
    }
  for (const Term &term : terms)
    if (!term.file.empty())
      program.files.push_back(term.file);
  return program;
}
} // namespace chaindrive::drive
