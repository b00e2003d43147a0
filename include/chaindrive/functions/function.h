// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

/// What is prescribed over time or angle: speeds, torques, and all that acts as these do.
namespace chaindrive::functions
{
/// A real function of one variable, defined everywhere, that never changes: smooth but at its
/// breakpoints, from which on its limit from the right holds.
class Function
{
public:
  virtual ~Function() = default;

  virtual double value(double x) const = 0;

  /// Its slope at @p x; at a breakpoint that from the right.
  virtual double derivative(double x) const = 0;

  /// Its integral from @p from to @p to, of either order.
  virtual double integral(double from, double to) const = 0;

  /// In rising order the places in (@p from, @p to) at which value, derivative or curvature jump:
  /// between them quadrature and Newton's method may take it for smooth.
  virtual std::vector<double> breakpoints(double from, double to) const;

  /// A bound of its magnitude on [@p from, @p to], which is reached unless several terms or factors
  /// are bounded one by one (Sum, Product, Harmonics).
  virtual double largest(double from, double to) const = 0;

  /// The same of its slope between breakpoints: a jump has none.
  virtual double steepest(double from, double to) const = 0;

  /// Whether it has the same value everywhere.
  virtual bool is_constant() const { return false; }
};

/// Functions are shared between those that ask them.
using Pointer = std::shared_ptr<const Function>;

/// The last of all breakpoints of @p function; @p otherwise where there is none.
double last_breakpoint(const Function &function, double otherwise);

/// The same value everywhere.
class Constant : public Function
{
public:
  explicit Constant(const double value) : value_(value) {}

  double value(double) const override { return value_; }
  double derivative(double) const override { return 0.; }
  double integral(const double from, const double to) const override
  {
    return value_ * (to - from);
  }
  double largest(double from, double to) const override;
  double steepest(double from, double to) const override;
  bool   is_constant() const override { return true; }

private:
  double value_;
};

/// How a Ramp rises.
enum class Rise
{
  linear, ///< s
  cosine  ///< (1 - cos(pi s)) / 2, which begins and ends with slope 0
};

/// 0 up to a start, then a rise over a length, then constant. A length of 0 is a step.
class Ramp : public Function
{
public:
  /// @p level: the value at the end; @p length must not be negative.
  Ramp(double level, double start, double length, Rise rise = Rise::linear);

  double              value(double x) const override;
  double              derivative(double x) const override;
  double              integral(double from, double to) const override;
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double from, double to) const override;
  double              steepest(double from, double to) const override;

private:
  /// Its integral from minus infinity.
  double primitive(double x) const;

  double level_, start_, length_;
  Rise   rise_;
};

/// Constant between places, at each of which it takes another value.
class Steps : public Function
{
public:
  /// @p first: the value before the first of @p places, which must rise; @p values: those from each
  /// of them on.
  Steps(double first, std::vector<double> places, std::vector<double> values);

  double              value(double x) const override;
  double              derivative(double) const override { return 0.; }
  double              integral(double from, double to) const override;
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double from, double to) const override;
  double              steepest(double from, double to) const override;

private:
  std::vector<double> places_, values_; ///< values_ has one more, the first
};

/// Through points, without values beyond those of neighbouring points; before the first and after
/// the last of them constant.
///
/// Between two points a cubic with slopes that keep what is monotone so: the weighted harmonic mean
/// of the slopes of the chords on both sides, and 0 at extremes (F. N. Fritsch and J. Butland, SIAM
/// J. Sci. Stat. Comput. 5 (1984) 300-304).
class Table : public Function
{
public:
  /// At least one point; @p x must rise. std::invalid_argument otherwise.
  Table(std::vector<double> x, std::vector<double> y);

  double              value(double x) const override;
  double              derivative(double x) const override;
  double              integral(double from, double to) const override;
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double from, double to) const override;
  double              steepest(double from, double to) const override;
  bool                is_constant() const override { return x_.size() == 1; }

  const std::vector<double> &x() const { return x_; }
  const std::vector<double> &y() const { return y_; }

private:
  /// The piece that holds a place between the first and the last point, and where: 0 to 1.
  struct Place
  {
    unsigned int piece;
    double       length, s;
  };
  Place place(double x) const;

  /// Its integral from the first point.
  double primitive(double x) const;

  std::vector<double> x_, y_, slope_;
  std::vector<double> before_; ///< integral from the first point to each
};

/// One term of Harmonics: amplitude cos(order x + phase).
struct Harmonic
{
  double order;     ///< over one unit of the variable: of an angle in rad the order as it is called
  double amplitude; ///< in units of the value
  double phase;     ///< rad
};

/// A sum of cosines, none of order 0.
class Harmonics : public Function
{
public:
  /// std::invalid_argument for an order of 0: that is a Constant.
  explicit Harmonics(std::vector<Harmonic> terms);

  double value(double x) const override;
  double derivative(double x) const override;
  double integral(double from, double to) const override;
  double largest(double from, double to) const override;
  double steepest(double from, double to) const override;

private:
  std::vector<Harmonic> terms_;
};

/// What resists a motion: linear x + quadratic x |x|, of the sign of x.
class Resistance : public Function
{
public:
  Resistance(const double linear, const double quadratic) : linear_(linear), quadratic_(quadratic)
  {
  }

  double              value(double x) const override;
  double              derivative(double x) const override;
  double              integral(double from, double to) const override;
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double from, double to) const override;
  double              steepest(double from, double to) const override;

private:
  double linear_, quadratic_;
};

/// One period of another function, from @p begin to @p end, over and over.
class Periodic : public Function
{
public:
  /// std::invalid_argument unless @p end is greater than @p begin.
  Periodic(Pointer function, double begin, double end);

  double value(double x) const override { return function_->value(within(x)); }
  double derivative(double x) const override { return function_->derivative(within(x)); }
  double integral(double from, double to) const override;

  /// Between finite places; of all there is no last one.
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double, double) const override;
  double              steepest(double, double) const override;

private:
  /// The place in the first period that is like @p x.
  double within(double x) const;

  /// Its integral from the beginning of the first period.
  double primitive(double x) const;

  Pointer function_;
  double  begin_, length_, whole_; ///< whole_: its integral over a period
};

/// A speed that fluctuates with the angle that it has turned without that:
///
///   w(t) = w0(t) (1 + g(phi(t))),   phi(t) = integral of w0 from a start to t,
///
/// so that its integral is that of w0 and of g over the angle.
class Fluctuating : public Function
{
public:
  /// @p speed: w0 over time; @p of_angle: g over the angle; @p start: where phi = 0.
  Fluctuating(Pointer speed, Pointer of_angle, double start);

  double              value(double x) const override;
  double              derivative(double x) const override;
  double              integral(double from, double to) const override;
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double from, double to) const override;
  double              steepest(double from, double to) const override;

private:
  double angle(const double x) const { return speed_->integral(start_, x); }

  Pointer speed_, of_angle_;
  double  start_;
};

/// The sum of several.
class Sum : public Function
{
public:
  explicit Sum(std::vector<Pointer> terms);

  double              value(double x) const override;
  double              derivative(double x) const override;
  double              integral(double from, double to) const override;
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double from, double to) const override;
  double              steepest(double from, double to) const override;
  bool                is_constant() const override;

private:
  std::vector<Pointer> terms_;
};

/// The product of two. Its integral is exact when one of them is constant, else that of a
/// Gauss-Kronrod rule between breakpoints, to 1e-12 of the integral of its magnitude.
class Product : public Function
{
public:
  Product(Pointer first, Pointer second);

  double              value(double x) const override;
  double              derivative(double x) const override;
  double              integral(double from, double to) const override;
  std::vector<double> breakpoints(double from, double to) const override;
  double              largest(double from, double to) const override;
  double              steepest(double from, double to) const override;
  bool                is_constant() const override;

private:
  Pointer first_, second_;
};
} // namespace chaindrive::functions
