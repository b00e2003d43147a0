// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// Decimal exponent of an entry's unit in SI units. The member behind an entry holds SI units; the
/// exponent shifts the decimal point of the text, so that no rounding happens in between: 643.038
/// mm is exactly the number 0.643038.
namespace unit
{
inline constexpr int si = 0, milli = -3, micro = -6, giga = 9, percent = -2;
} // namespace unit

/// The numbers an entry accepts, in the entry's own unit.
struct Range
{
  double lower, upper;
  bool   lower_included = true, upper_included = true;

  bool        contains(double value) const;
  std::string text() const; ///< such as "a number from 0 to 1"
};

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Both ends included.
constexpr Range between(const double lower, const double upper) { return {lower, upper}; }
constexpr Range above(const double lower, const double upper = infinity)
{
  return {lower, upper, false, true};
}
constexpr Range at_least(const double lower) { return {lower, infinity}; }
constexpr Range from_to_below(const double lower, const double upper)
{
  return {lower, upper, true, false};
}

// Each of these declares the entry @p name of the current subsection of @p prm with the present
// value of @p member as its default, and stores every value that is set in @p member, which must
// outlive
// @p prm. @p meaning becomes the entry's documentation.

/// A number in the unit 10^@p exponent.
void add(dealii::ParameterHandler &prm,
         const std::string        &name,
         double                   &member,
         int                       exponent,
         const Range              &range,
         const std::string        &meaning);

/// A number in the unit 10^@p exponent, or `auto`, which leaves the member empty.
void add(dealii::ParameterHandler &prm,
         const std::string        &name,
         std::optional<double>    &member,
         int                       exponent,
         const Range              &range,
         const std::string        &meaning);

/// A whole number, both ends of the range included.
void add(dealii::ParameterHandler &prm,
         const std::string        &name,
         unsigned int             &member,
         unsigned int              lower,
         unsigned int              upper,
         const std::string        &meaning);

/// A whole number, both ends of the range included, or `auto`, which leaves the member empty.
void add(dealii::ParameterHandler    &prm,
         const std::string           &name,
         std::optional<unsigned int> &member,
         unsigned int                 lower,
         unsigned int                 upper,
         const std::string           &meaning);

/// One of the words @p choices.
void add(dealii::ParameterHandler       &prm,
         const std::string              &name,
         std::string                    &member,
         const std::vector<std::string> &choices,
         const std::string              &meaning);

/// Any text: @p allowed says what is meant by it.
void add_text(dealii::ParameterHandler &prm,
              const std::string        &name,
              std::string              &member,
              const std::string        &allowed,
              const std::string        &meaning);

/// `true` or `false`.
void add(dealii::ParameterHandler &prm,
         const std::string        &name,
         bool                     &member,
         const std::string        &meaning);

/// Whole numbers separated by commas, or `all`, which leaves the member empty. They are stored in
/// increasing order, each once.
void add(dealii::ParameterHandler  &prm,
         const std::string         &name,
         std::vector<unsigned int> &member,
         const std::string         &meaning);

/// A subsection of a ParameterHandler, open as long as this object lives.
class Subsection
{
public:
  Subsection(dealii::ParameterHandler &prm, const std::string &name) : prm_(prm)
  {
    prm_.enter_subsection(name);
  }
  ~Subsection() { prm_.leave_subsection(); }
  Subsection(const Subsection &)            = delete;
  Subsection &operator=(const Subsection &) = delete;

private:
  dealii::ParameterHandler &prm_;
};

/// @p value [SI] as the shortest text that, read in the unit 10^@p exponent, gives it back exactly.
std::string to_entry_text(double value, int exponent);

/// The number that @p text, in the unit 10^@p exponent, stands for [SI]; empty if it is none.
std::optional<double> from_entry_text(const std::string &text, int exponent);
} // namespace chaindrive::parameters
