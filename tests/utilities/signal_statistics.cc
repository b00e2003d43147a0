// SPDX-License-Identifier: LGPL-2.1-or-later
// Statistics of a signal over a window whose ends lie inside steps of unequal length: mean,
// deviation, extremes and harmonics against their closed forms. Harmonics are taken over whole
// revolutions of the phase, so that a wave of one and a half times its frequency leaks into none of
// them over an even number of turns. A window that begins later than the run, one that is moved
// before it begins, and statistics that go on from a copy give the same.
#include <chaindrive/utilities/signal_statistics.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

using namespace chaindrive;

namespace
{
constexpr double pi = 3.14159265358979323846, frequency = 100.; // rad/s

double signal(const double phase)
{
  return 5. + 2. * std::cos(phase + 0.3) + 0.5 * std::sin(2. * phase) + 0.1 * std::cos(4. * phase);
}

struct Both
{
  Both(const double start, const double end) : turns(start, end), statistics(start, end) {}

  void add(const double time, const double duration, const double value)
  {
    statistics.add(
        time, duration, value, turns.next(time, duration, frequency * (time + duration)));
  }

  WholeRevolutions turns;
  SignalStatistics statistics;
};

/// Runs over [0, 1.2 end] in @p n steps and takes the signal @p x.
template <typename Function>
void run(Both &both, const double end, const unsigned int n, const Function &x)
{
  const double mean_step = 1.2 * end / n;
  double       time      = 0.;
  both.add(0., 0., x(0.));
  for (unsigned int i = 0; i < n; ++i)
    {
      const double duration = mean_step * (1. + 0.5 * std::sin(0.7 * i));
      both.add(time, duration, x(frequency * (time + duration)));
      time += duration;
    }
}

void print(const std::string &what, Both &both)
{
  const auto &s = both.statistics;
  std::cout << what << ": " << both.turns.n_revolutions() << " turns" << std::endl;
  const auto error =
      [](const std::string &name, const double value, const double exact, const double parts) {
        std::cout << "  " << name << " less the exact one, in parts of " << std::fixed
                  << std::setprecision(0) << parts << ": " << std::abs(parts * (value - exact))
                  << std::endl;
      };
  error("mean", s.mean(), 5., 1e4);
  error("deviation", s.deviation(), std::sqrt(0.5 * (4. + 0.25 + 0.01)), 1e4);
  const double amplitudes[] = {2., 0.5, 0., 0.1};
  for (unsigned int n = 0; n < 4; ++n)
    error("harmonic " + std::to_string(n + 1),
          s.harmonics(both.turns.n_revolutions())[n],
          amplitudes[n],
          1e6);
}
} // namespace

int main()
{
  const double turn = 2. * pi / frequency;
  const double from = 0.37 * turn; // four turns and nothing else
  Both         plain(from, from + 4. * turn);
  run(plain, 4.4 * turn, 4000, signal);
  print("four turns", plain);

  double least = 1e9, largest = -1e9;
  for (unsigned int i = 0; i < 100000; ++i)
    {
      least   = std::min(least, signal(2. * pi * i / 100000.));
      largest = std::max(largest, signal(2. * pi * i / 100000.));
    }
  std::cout << "least and largest, in parts of 1000: " << std::setprecision(0)
            << std::abs(1e3 * (plain.statistics.least() - least)) << ", "
            << std::abs(1e3 * (plain.statistics.largest() - largest)) << std::endl;

  // what lies beyond the last whole turn does not count for harmonics
  Both more(from, from + 4.9 * turn);
  run(more, 5.4 * turn, 40000, signal);
  double change = 0.;
  for (unsigned int n = 0; n < 4; ++n)
    change = std::max(change,
                      std::abs(more.statistics.harmonics(more.turns.n_revolutions())[n] -
                               plain.statistics.harmonics(4)[n]));
  std::cout << "with nine tenths of a turn more: " << more.turns.n_revolutions()
            << " turns, harmonics the same: " << (change < 1e-4 ? "yes" : "no") << std::endl;

  // no leakage, and few steps
  Both other(from, from + 4. * turn);
  run(other, 4.4 * turn, 4000, [](const double phase) { return std::cos(1.5 * phase); });
  double leak = 0.;
  for (const double amplitude : other.statistics.harmonics(4))
    leak = std::max(leak, amplitude);
  std::cout << "a wave between the harmonics leaks less than a thousandth: "
            << (leak < 1e-3 ? "yes" : "no") << std::endl;

  // the window is known only when it has begun, and half-way all is copied
  Both         late(1e9, 2e9);
  Both         copy(from, from + 4. * turn);
  const double step = 1e-5;
  Both         whole(from, from + 4. * turn);
  for (unsigned int i = 0; i * step < 5. * turn; ++i)
    {
      const double value = signal(frequency * (i + 1) * step);
      if ((i + 1) * step >= from)
        {
          late.turns.move_to(from, from + 4. * turn);
          late.statistics.move_to(from, from + 4. * turn);
        }
      late.add(i * step, step, value);
      whole.add(i * step, step, value);
      if (i < 12000)
        copy.add(i * step, step, value);
      else
        {
          if (i == 12000)
            {
              Both next(from, from + 4. * turn);
              next.turns.state() = copy.turns.state();
              std::cout << "goes on: " << next.statistics.go_on_from(copy.statistics, i * step)
                        << std::endl;
              Both wrong(0.5 * from, from + 4. * turn);
              std::cout << "of another window: "
                        << wrong.statistics.go_on_from(copy.statistics, i * step) << std::endl;
              copy = next;
            }
          copy.add(i * step, step, value);
        }
    }
  bool same = true;
  for (const Both *both : {&late, &copy})
    same = same && both->turns.n_revolutions() == 4 &&
           both->statistics.mean() == whole.statistics.mean() &&
           both->statistics.deviation() == whole.statistics.deviation() &&
           both->statistics.harmonics(4) == whole.statistics.harmonics(4);
  std::cout << "moved and copied statistics are the same: " << (same ? "yes" : "no") << std::endl;

  Both nothing(1e9, 2e9);
  run(nothing, 1., 10, signal);
  std::cout << "nothing in the window: " << nothing.statistics.mean() << ", "
            << nothing.statistics.deviation() << ", " << nothing.statistics.largest() << ", "
            << nothing.statistics.harmonics(0)[0] << std::endl;
}
