// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of a .prm file and the SI members behind them: the decimal point is shifted in the text,
// so that nothing is rounded on the way.
#include <chaindrive/parameters/entries.h>

#include <cmath>
#include <iostream>
#include <random>

using namespace chaindrive::parameters;

int main()
{
  std::cout << "SI value as text in an entry's unit" << std::endl;
  const auto print = [](const double value, const int exponent) {
    std::cout << "  10^" << exponent << ": " << to_entry_text(value, exponent) << std::endl;
  };
  print(0.643038, unit::milli);
  print(20e-6, unit::micro);
  print(0.25e-6, unit::micro);
  print(210e9, unit::giga);
  print(0.05, unit::percent);
  print(0., unit::milli);
  print(-0.0107, unit::milli);
  print(9.88e-3, unit::si);
  print(3e8, unit::si);
  print(123456.5, unit::si);
  print(1e-9, unit::milli);

  std::cout << "the nearest double to the text: "
            << (*from_entry_text("643.038", unit::milli) == 0.643038 &&
                *from_entry_text("0.25", unit::micro) == 0.25e-6 &&
                *from_entry_text("2.5e-1", unit::micro) == 0.25e-6 &&
                *from_entry_text("+2.1E2", unit::giga) == 210e9)
            << std::endl;

  unsigned int                           n_changed = 0;
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> mantissa(-10., 10.), power(-30., 30.);
  for (unsigned int i = 0; i < 20000; ++i)
    for (const int exponent : {unit::si, unit::milli, unit::micro, unit::giga, unit::percent})
      {
        const double value = mantissa(random) * std::pow(10., std::round(power(random)));
        if (from_entry_text(to_entry_text(value, exponent), exponent) != value)
          ++n_changed;
      }
  std::cout << "changed on the way through text and back, of 100000: " << n_changed << std::endl;

  std::cout << "no numbers:";
  for (const char *text :
       {"", "+", "1,5", "1.5 mm", "0x10", "nan", "inf", "1e999", "--1", "1e", "."})
    std::cout << ' ' << from_entry_text(text, unit::milli).has_value();
  std::cout << std::endl;

  for (const Range &range :
       {between(0., 1.), above(0., 100.), from_to_below(0., 0.5), above(0.), at_least(2.)})
    std::cout << range.text() << ": holds 0 " << range.contains(0.) << ", 0.5 "
              << range.contains(0.5) << ", 1 " << range.contains(1.) << ", 1000 "
              << range.contains(1000.) << std::endl;
}
