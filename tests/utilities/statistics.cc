// SPDX-License-Identifier: LGPL-2.1-or-later
// Mean over a window that begins and ends inside steps, against its closed form; peaks between
// samples.
#include <chaindrive/utilities/statistics.h>

#include <iostream>

using namespace chaindrive;

int main()
{
  // steps of unequal length; the quantity is the number of its step: 0 on [0, 1], 1 on [1, 3], ...
  WindowMean mean(0.5, 7.), nothing(20., 30.), all(0., 100.);
  double     time = 0.;
  for (int step = 0; step < 4; ++step)
    {
      const double duration = 1. + step;
      for (WindowMean *m : {&mean, &nothing, &all})
        m->add(time, duration, step);
      time += duration;
    }
  // [0.5, 1]: 0, [1, 3]: 1, [3, 6]: 2, [6, 7]: 3
  std::cout << "mean / exact: " << mean.mean() / ((2. * 1. + 3. * 2. + 1. * 3.) / 6.5)
            << ", duration " << mean.duration() << std::endl;
  std::cout << "whole run: " << all.mean() << " over " << all.duration() << std::endl;
  std::cout << "nothing in the window: " << nothing.mean() << " over " << nothing.duration()
            << std::endl;
}
