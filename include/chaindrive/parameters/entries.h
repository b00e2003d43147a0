// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>
#include <chaindrive/parameters/declarations.h>

#include <array>
#include <functional>
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
inline constexpr int si = 0, milli = -3, micro = -6, kilo = 3, giga = 9, percent = -2;
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

// Each of these declares the entry @p name of the open section of @p declarations with the present
// value of @p member as its default. Every value that is set goes into @p member, which must
// outlive the declarations. @p meaning becomes the entry's documentation. The entry that they
// return is good until the next one is declared.

/// A number in the unit 10^@p exponent.
Entry &add(Declarations      &declarations,
           const std::string &name,
           double            &member,
           int                exponent,
           const Range       &range,
           const std::string &meaning);

/// A number in the unit 10^@p exponent, or the word @p empty, which leaves the member empty.
Entry &add(Declarations          &declarations,
           const std::string     &name,
           std::optional<double> &member,
           int                    exponent,
           const Range           &range,
           const std::string     &meaning,
           const std::string     &empty = "auto");

/// An angle in degrees, or the word @p empty, which leaves the member [rad] empty.
Entry &add_angle(Declarations          &declarations,
                 const std::string     &name,
                 std::optional<double> &member,
                 const Range           &range,
                 const std::string     &meaning,
                 const std::string     &empty);

/// The same for one that is always given.
Entry &add_angle(Declarations      &declarations,
                 const std::string &name,
                 double            &member,
                 const Range       &range,
                 const std::string &meaning);

/// A point of the plane, x and y in mm separated by a comma, or `auto`, which leaves the member [m]
/// empty.
Entry &add_point(Declarations                         &declarations,
                 const std::string                    &name,
                 std::optional<std::array<double, 2>> &member,
                 const std::string                    &meaning);

/// A whole number, both ends of the range included.
Entry &add(Declarations      &declarations,
           const std::string &name,
           unsigned int      &member,
           unsigned int       lower,
           unsigned int       upper,
           const std::string &meaning);

/// A whole number, both ends of the range included, or `auto`, which leaves the member empty.
Entry &add(Declarations                &declarations,
           const std::string           &name,
           std::optional<unsigned int> &member,
           unsigned int                 lower,
           unsigned int                 upper,
           const std::string           &meaning);

/// A whole number, both ends of the range included, or the word @p none, which is the number 0.
Entry &add(Declarations      &declarations,
           const std::string &name,
           unsigned int      &member,
           unsigned int       lower,
           unsigned int       upper,
           const std::string &meaning,
           const std::string &none);

/// One of @p texts, which @p store puts into its member.
Entry &add_choice(Declarations                                   &declarations,
                  const std::string                              &name,
                  const std::string                              &default_value,
                  const std::vector<std::string>                 &texts,
                  const std::string                              &meaning,
                  const std::function<void(const std::string &)> &store);

/// One of the values of a choice.
template <typename Enum>
Entry &
add(Declarations &declarations, const std::string &name, Enum &member, const std::string &meaning)
{
  std::vector<std::string> texts;
  for (const Text<Enum> &choice : texts_of<Enum>)
    texts.emplace_back(choice.text);
  return add_choice(
      declarations, name, text_of(member), texts, meaning, [&member](const std::string &text) {
        member = *value_of<Enum>(text);
      });
}

/// Numbers in the unit 10^@p exponent, separated by commas; or nothing, which is none.
Entry &add(Declarations        &declarations,
           const std::string   &name,
           std::vector<double> &member,
           int                  exponent,
           const Range         &range,
           const std::string   &meaning);

/// Angles in degrees, separated by commas, for members in rad; or nothing, which is none.
Entry &add_angles(Declarations        &declarations,
                  const std::string   &name,
                  std::vector<double> &member,
                  const Range         &range,
                  const std::string   &meaning);

/// `all` or some of @p texts, separated by commas, which @p store puts into its member: none for
/// `all`.
Entry &add_choices(Declarations                                                &declarations,
                   const std::string                                           &name,
                   const std::vector<std::string>                              &texts,
                   const std::string                                           &meaning,
                   const std::function<void(const std::vector<std::string> &)> &store);

/// `all`, which is the default and leaves the member empty, or some values of a choice.
template <typename Enum>
Entry &add(Declarations      &declarations,
           const std::string &name,
           std::vector<Enum> &member,
           const std::string &meaning)
{
  std::vector<std::string> texts;
  for (const Text<Enum> &choice : texts_of<Enum>)
    texts.emplace_back(choice.text);
  return add_choices(
      declarations, name, texts, meaning, [&member](const std::vector<std::string> &chosen) {
        member.clear();
        for (const std::string &text : chosen)
          member.push_back(*value_of<Enum>(text));
      });
}

/// Any text: @p allowed says what is meant by it.
Entry &add_text(Declarations      &declarations,
                const std::string &name,
                std::string       &member,
                const std::string &allowed,
                const std::string &meaning);

/// `true` or `false`.
Entry &
add(Declarations &declarations, const std::string &name, bool &member, const std::string &meaning);

/// Whole numbers separated by commas, or `all`, which leaves the member empty. They are stored in
/// increasing order, each once.
Entry &add(Declarations              &declarations,
           const std::string         &name,
           std::vector<unsigned int> &member,
           const std::string         &meaning);

/// @p value [SI] as the shortest text that, read in the unit 10^@p exponent, gives it back exactly.
std::string to_entry_text(double value, int exponent);

/// The number that @p text, in the unit 10^@p exponent, stands for [SI]; empty if it is none.
std::optional<double> from_entry_text(const std::string &text, int exponent);
} // namespace chaindrive::parameters
