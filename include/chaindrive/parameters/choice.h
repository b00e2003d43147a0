// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace chaindrive::parameters
{
// What the user chooses between is an enum. The texts of its values stand right below it, once:
// they are what a .prm file may say, what is read, and what is printed.
//
//   enum class SpeedRamp { linear, cosine };
//
//   template <>
//   inline constexpr Texts<SpeedRamp, 2> texts_of<SpeedRamp>{
//       {{SpeedRamp::linear, "linear"}, {SpeedRamp::cosine, "cosine"}}};

/// A value and its text.
template <typename Enum>
struct Text
{
  Enum        value;
  const char *text;
};

template <typename Enum, std::size_t n>
using Texts = std::array<Text<Enum>, n>;

/// All values of a choice, in the order in which messages list them.
template <typename Enum>
inline constexpr Texts<Enum, 0> texts_of{};

template <typename Enum>
std::string text_of(const Enum value)
{
  for (const Text<Enum> &entry : texts_of<Enum>)
    if (entry.value == value)
      return entry.text;
  throw std::logic_error("a value of a choice has no text");
}

/// Empty if no value has this @p text.
template <typename Enum>
std::optional<Enum> value_of(const std::string &text)
{
  for (const Text<Enum> &entry : texts_of<Enum>)
    if (entry.text == text)
      return entry.value;
  return {};
}

/// Whether to have something: `automatic` leaves it to the program.
enum class Switch
{
  automatic,
  on,
  off
};

template <>
inline constexpr Texts<Switch, 3> texts_of<Switch>{
    {{Switch::automatic, "auto"}, {Switch::on, "on"}, {Switch::off, "off"}}};

/// Whether what has this switch and this @p coefficient acts.
constexpr bool acts(const Switch choice, const double coefficient)
{
  return choice != Switch::off && coefficient != 0.;
}
} // namespace chaindrive::parameters
