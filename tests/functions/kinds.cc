// SPDX-License-Identifier: LGPL-2.1-or-later
// Every kind of function: its derivative is the limit of differences, its integral that of a
// quadrature of its values, from either side and in pieces; its breakpoints are where it is not
// smooth, and nothing exceeds its largest value. What can be said in a closed form is.
#include <chaindrive/functions/function.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace chaindrive::functions;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// Simpson's rule over the pieces between breakpoints, just inside of them.
double quadrature(const Function &f, const double from, const double to)
{
  std::vector<double> ends = f.breakpoints(from, to);
  ends.push_back(to);
  double sum = 0., begin = from;
  for (const double end : ends)
    {
      constexpr int n = 2000;
      const double  h = (end - begin) / n, inside = 1e-9 * h;
      for (int i = 0; i <= n; ++i)
        {
          const double x = std::min(std::max(begin + i * h, begin + inside), end - inside);
          sum += h / 3. * f.value(x) * (i == 0 || i == n ? 1. : i % 2 == 1 ? 4. : 2.);
        }
      begin = end;
    }
  return sum;
}

/// How far the derivative is from central differences, away from breakpoints.
double derivative_error(const Function &f, const double from, const double to)
{
  constexpr double    h     = 1e-5;
  std::vector<double> sharp = f.breakpoints(from, to);
  double              worst = 0.;
  for (int i = 1; i < 1000; ++i)
    {
      const double x = from + (to - from) * i / 1000.;
      if (std::any_of(
              sharp.begin(), sharp.end(), [x](double s) { return std::abs(x - s) < 2. * h; }))
        continue;
      worst =
          std::max(worst, std::abs((f.value(x + h) - f.value(x - h)) / (2. * h) - f.derivative(x)));
    }
  return worst;
}

/// The largest jump of the second difference that no breakpoint tells of.
double unannounced(const Function &f, const double from, const double to)
{
  constexpr double    h     = 1e-4;
  std::vector<double> sharp = f.breakpoints(from, to);
  double              worst = 0.;
  for (double x = from + 2. * h; x < to - 2. * h; x += h)
    {
      if (std::any_of(
              sharp.begin(), sharp.end(), [x](double s) { return std::abs(x - s) < 2.5 * h; }))
        continue;
      worst = std::max(worst, std::abs(f.value(x + h) - 2. * f.value(x) + f.value(x - h)) / h);
    }
  return worst;
}

double largest_sampled(const Function &f, const double from, const double to)
{
  double most = 0.;
  for (int i = 0; i <= 100000; ++i)
    most = std::max(most, std::abs(f.value(from + (to - from) * i / 100000.)));
  return most;
}

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

double steepest_sampled(const Function &f, const double from, const double to)
{
  double most = 0.;
  for (int i = 0; i <= 100000; ++i)
    most = std::max(most, std::abs(f.derivative(from + (to - from) * i / 100000.)));
  return most;
}

/// @p reached: whether the largest value is one, and no mere bound.
void examine(const std::string &name, const Function &f, const bool reached)
{
  const double from = -1.3, middle = 0.7, to = 4.1;
  const double whole = f.integral(from, to);
  const double most = f.largest(from, to), sampled = largest_sampled(f, from, to);
  std::cout << name << ", integral " << whole << ", largest " << most << '\n';
  verdict("  derivative as differences to 1e-6", derivative_error(f, from, to) < 1e-6);
  verdict("  integral as a quadrature to 1e-8", std::abs(whole - quadrature(f, from, to)) < 1e-8);
  verdict("  in pieces, and backwards, to 1e-12",
          std::abs(f.integral(from, middle) + f.integral(middle, to) - whole) < 1e-12 &&
              std::abs(f.integral(to, from) + whole) < 1e-12);
  verdict("  smooth between breakpoints", unannounced(f, from, to) < 0.05);
  verdict("  nothing is larger", sampled <= most * (1. + 1e-12));
  if (reached)
    verdict("  and that is reached", sampled > most * (1. - 1e-6));
  const double steepest = f.steepest(from, to), slope = steepest_sampled(f, from, to);
  std::cout << "  steepest " << steepest << '\n';
  verdict("  nothing is steeper", slope <= steepest * (1. + 1e-12));
  if (reached)
    verdict("  and that is reached", slope >= steepest * (1. - 1e-6));
  const std::vector<double> inside = f.breakpoints(from, to);
  std::cout << "  breakpoints:";
  for (const double x : inside)
    std::cout << ' ' << x;
  std::cout << '\n';
}

template <typename T, typename... Arguments>
Pointer make(Arguments... arguments)
{
  return std::make_shared<T>(arguments...);
}

bool refused(const std::function<void()> &make_it)
{
  try
    {
      make_it();
    }
  catch (const std::invalid_argument &)
    {
      return true;
    }
  return false;
}

/// Largest error of the table of sin through n + 1 points on [0, 1.4].
double error_of_sine(const int n)
{
  std::vector<double> x, y;
  for (int i = 0; i <= n; ++i)
    {
      x.push_back(1.4 * i / n);
      y.push_back(std::sin(x.back()));
    }
  const Table table(x, y);
  double      worst = 0.;
  for (int i = 2000; i <= 8000; ++i) // away from the ends, whose slopes are of lower order
    worst = std::max(worst, std::abs(table.value(1.4 * i / 10000) - std::sin(1.4 * i / 10000)));
  return worst;
}
} // namespace

int main()
{
  const std::vector<double> x = {-1., 0., 0.5, 1., 1.1, 2., 3.5},
                            y = {2., 2., 5., 1., 0.9, -3., -2.};
  const Pointer ramp = make<Ramp>(2.5, 0.4, 1.5), cosine = make<Ramp>(-1.5, 0.2, 2., Rise::cosine);
  const Pointer table = make<Table>(x, y);
  const Pointer waves = make<Harmonics>(std::vector<Harmonic>{{2., 1., 0.3}, {5.5, 0.25, -1.}});

  examine("constant", Constant(-3.), true);
  examine("ramp", *ramp, true);
  examine("cosine", *cosine, true);
  examine("step", Ramp(2., 0.4, 0.), true);
  examine("steps", Steps(1., {-2., 0., 2., 5.}, {7., -4., 3., 9.}), true);
  examine("table", *table, true);
  examine("harmonics", *waves, false);
  examine("one harmonic", Harmonics({{3., -2., 0.1}}), true);
  examine("sum", Sum({ramp, table, waves}), false);
  examine("product", Product(table, waves), false);
  examine("product with a constant", Product(make<Constant>(-2.), cosine), true);

  const Pointer hill =
      make<Table>(std::vector<double>{-1., 0., 0.5}, std::vector<double>{1., 3., 1.});
  examine("resistance", Resistance(0.5, 0.25), true);
  examine("periodic", Periodic(hill, -1., 0.5), true);
  examine("fluctuating", Fluctuating(ramp, waves, 0.4), false);

  // closed forms
  verdict("a period is like the first",
          std::abs(Periodic(hill, -1., 0.5).value(4.5) - 3.) < 1e-14 &&
              std::abs(Periodic(hill, -1., 0.5).integral(-1., 5.) - 4. * hill->integral(-1., 0.5)) <
                  1e-13);
  verdict("what repeats itself has no last breakpoint",
          last_breakpoint(Periodic(hill, -1., 0.5), 7.) == 7.);
  verdict("a fluctuating speed has turned by the integral of its waves",
          std::abs(Fluctuating(make<Constant>(50.),
                               make<Harmonics>(std::vector<Harmonic>{{2., 0.1, 0.3}}),
                               0.2)
                       .integral(0.2, 0.9) -
                   50. * 0.7 - 0.05 * (std::sin(2. * 35. + 0.3) - std::sin(0.3))) < 1e-12);
  verdict("a ramp has covered half of what its level would have",
          std::abs(ramp->integral(0.4, 1.9) - 0.5 * 2.5 * 1.5) < 1e-15 &&
              std::abs(cosine->integral(0.2, 2.2) + 0.5 * 1.5 * 2.) < 1e-15);
  verdict("the middle of a ramp is half its level",
          std::abs(ramp->value(1.15) - 1.25) < 1e-15 &&
              std::abs(cosine->value(1.2) + 0.75) < 1e-15);
  verdict("over whole revolutions harmonics integrate to nothing",
          std::abs(Harmonics({{3., 1., 0.7}, {7., 2., 0.1}}).integral(0.2, 0.2 + 2. * pi)) < 1e-14);
  verdict("a place is of the right step",
          Steps(1., {0.5}, {2.}).value(0.5) == 2. && Ramp(2., 0.5, 0.).value(0.5) == 2.);
  verdict("constant are what is made of constants",
          Product(make<Constant>(1.), make<Constant>(2.)).is_constant() &&
              Sum({make<Constant>(1.)}).is_constant() && !Sum({ramp}).is_constant() &&
              make<Table>(std::vector<double>{1.}, std::vector<double>{2.})->is_constant());

  // tables
  bool between = true;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (int k = 0; k <= 1000; ++k)
      {
        const double v = table->value(x[i] + (x[i + 1] - x[i]) * k / 1000.);
        between &= v >= std::min(y[i], y[i + 1]) - 1e-14 && v <= std::max(y[i], y[i + 1]) + 1e-14;
      }
  verdict("a table goes through its points and not beyond them",
          between && table->value(0.5) == 5.);
  verdict("it is constant beyond its ends",
          table->value(-9.) == 2. && table->value(9.) == -2. && table->derivative(9.) == 0.);
  verdict("a straight line stays one",
          std::abs(Table({0., 1., 3., 4., 9.}, {1., 3., 7., 9., 19.}).value(6.3) - 13.6) < 1e-14);
  const double of_few  = Table({0., 1., 3.}, {0., 2., 3.}).derivative(1.);
  const double of_many = Table({-1., 0., 1., 3., 4.}, {-1., 0., 2., 3., 5.}).derivative(1.);
  verdict("three points have the slope of more", std::abs(of_few - of_many) < 1e-14);
  const double coarse = error_of_sine(40), fine = error_of_sine(80);
  std::cout << "order of a table of a sine: between 2.8 and 3.2: "
            << (std::log2(coarse / fine) > 2.8 && std::log2(coarse / fine) < 3.2 ? "yes" : "NO")
            << '\n';

  verdict("what is no function is refused",
          refused([] { Ramp(1., 0., -1.); }) && refused([] {
            Steps(0., {1., 1.}, {1., 2.});
          }) &&
              refused([] { Steps(0., {1.}, {}); }) && refused([] { Table({}, {}); }) && refused([] {
                Table({0., 0.}, {1., 2.});
              }) &&
              refused([] {
                Harmonics({{0., 1., 0.}});
              }));
}
