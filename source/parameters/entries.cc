// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

namespace chaindrive::parameters
{
namespace
{
constexpr double degree = dealii::numbers::PI / 180.; // rad

/// Reads all of @p text as a T; empty if there is anything else in it.
template <typename T>
std::optional<T> read_all(const std::string &text)
{
  T           value{};
  const char *begin = text.data(), *end = begin + text.size();
  if (begin != end && *begin == '+')
    ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end)
    return {};
  return value;
}

bool is_in(const std::string &text, const Range &range)
{
  const std::optional<double> value = from_entry_text(text, unit::si);
  return value && range.contains(*value);
}

bool is_in(const std::string &text, const unsigned int lower, const unsigned int upper)
{
  const auto value = read_all<unsigned int>(text);
  return value && *value >= lower && *value <= upper;
}

std::string whole_number(const unsigned int lower, const unsigned int upper)
{
  return "a whole number from " + std::to_string(lower) + " to " + std::to_string(upper);
}

/// deal.II's description of a field for numbers of @p range, with its ends; "MAX" is none.
std::string form_of(const Range &range)
{
  const double most = dealii::Patterns::Double::max_double_value;
  return dealii::Patterns::Double(std::max(range.lower, -most), std::min(range.upper, most))
      .description();
}

constexpr auto most_in_forms = static_cast<unsigned int>(std::numeric_limits<int>::max());

std::vector<std::string> split_at_commas(const std::string &text)
{
  return dealii::Utilities::split_string_list(text, ',');
}

std::string alternatives(const std::vector<std::string> &words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}
} // namespace

bool Range::contains(const double value) const
{
  return (lower_included ? value >= lower : value > lower) &&
         (upper_included ? value <= upper : value < upper);
}

std::string Range::text() const
{
  const std::string low = to_entry_text(lower, 0);
  if (std::isinf(upper) && std::isinf(lower))
    return "a number";
  if (std::isinf(upper))
    return (lower_included ? "a number of at least " : "a number above ") + low;
  const std::string high = to_entry_text(upper, 0);
  if (lower_included)
    return "a number from " + low + (upper_included ? " to " : " to below ") + high;
  return "a number above " + low + (upper_included ? " and up to " : " and below ") + high;
}

std::string to_entry_text(const double value, const int exponent)
{
  // "d.ddde+xx" with the fewest digits that tell this number from its neighbours
  char       buffer[40];
  const auto written = std::to_chars(buffer, buffer + 40, value, std::chars_format::scientific);
  const std::string text(buffer, written.ptr);
  const std::size_t e = text.find('e');
  if (e == std::string::npos || value == 0.)
    return value == 0. ? "0" : text;

  const bool  negative = text[0] == '-';
  std::string digits;
  std::copy_if(text.begin(), text.begin() + e, std::back_inserter(digits), [](const char c) {
    return c >= '0' && c <= '9';
  });
  const int   power = std::stoi(text.substr(e + 1)) - exponent;
  const int   n     = static_cast<int>(digits.size());
  std::string result;
  if (power >= std::max(6, n) || power < -3)
    result =
        digits.substr(0, 1) + (n > 1 ? "." + digits.substr(1) : "") + "e" + std::to_string(power);
  else if (power < 0)
    result = "0." + std::string(-power - 1, '0') + digits;
  else if (n <= power + 1)
    result = digits + std::string(power + 1 - n, '0');
  else
    result = digits.substr(0, power + 1) + "." + digits.substr(power + 1);
  return (negative ? "-" : "") + result;
}

std::optional<double> from_entry_text(const std::string &text, const int exponent)
{
  const std::optional<double> plain = read_all<double>(text);
  if (!plain || !std::isfinite(*plain) || exponent == 0)
    return plain && std::isfinite(*plain) ? plain : std::nullopt;
  const std::size_t e     = text.find_first_of("eE");
  const int         power = e == std::string::npos ? 0 : *read_all<int>(text.substr(e + 1));
  return read_all<double>(text.substr(0, e) + "e" + std::to_string(power + exponent));
}

Entry &add(Declarations      &declarations,
           const std::string &name,
           double            &member,
           const int          exponent,
           const Range       &range,
           const std::string &meaning)
{
  return declarations.add(
      name,
      to_entry_text(member, exponent),
      range.text(),
      meaning,
      [range](const std::string &text) { return is_in(text, range); },
      [&member, exponent](const std::string &text) {
        member = from_entry_text(text, exponent).value_or(0.); // below the smallest double
      },
      form_of(range));
}

Entry &add(Declarations          &declarations,
           const std::string     &name,
           std::optional<double> &member,
           const int              exponent,
           const Range           &range,
           const std::string     &meaning,
           const std::string     &empty)
{
  return declarations.add(
      name,
      member ? to_entry_text(*member, exponent) : empty,
      empty + " or " + range.text(),
      meaning,
      [range, empty](const std::string &text) { return text == empty || is_in(text, range); },
      [&member, exponent, empty](const std::string &text) {
        if (text == empty)
          member.reset();
        else
          member = from_entry_text(text, exponent).value_or(0.);
      });
}

Entry &add_angle(Declarations          &declarations,
                 const std::string     &name,
                 std::optional<double> &member,
                 const Range           &range,
                 const std::string     &meaning,
                 const std::string     &empty)
{
  return declarations.add(
      name,
      member ? to_entry_text(*member / degree, unit::si) : empty,
      empty + " or " + range.text(),
      meaning,
      [range, empty](const std::string &text) { return text == empty || is_in(text, range); },
      [&member, empty](const std::string &text) {
        member.reset();
        if (text != empty)
          member = from_entry_text(text, unit::si).value_or(0.) * degree;
      });
}

Entry &add_angle(Declarations      &declarations,
                 const std::string &name,
                 double            &member,
                 const Range       &range,
                 const std::string &meaning)
{
  return declarations.add(
      name,
      to_entry_text(member / degree, unit::si),
      range.text(),
      meaning,
      [range](const std::string &text) { return is_in(text, range); },
      [&member](const std::string &text) {
        member = from_entry_text(text, unit::si).value_or(0.) * degree;
      },
      form_of(range));
}

Entry &add_point(Declarations                         &declarations,
                 const std::string                    &name,
                 std::optional<std::array<double, 2>> &member,
                 const std::string                    &meaning)
{
  const Range range   = between(-1e5, 1e5);
  const auto  numbers = [range](const std::string &text) {
    std::vector<double> found;
    for (const std::string &word : split_at_commas(text))
      if (is_in(word, range))
        found.push_back(*from_entry_text(word, unit::milli));
      else
        return std::vector<double>();
    return found.size() == 2 ? found : std::vector<double>();
  };
  return declarations.add(
      name,
      member ? to_entry_text((*member)[0], unit::milli) + ", " +
                   to_entry_text((*member)[1], unit::milli) :
               "auto",
      "auto, or x and y separated by a comma, each " + range.text(),
      meaning,
      [numbers](const std::string &text) { return text == "auto" || !numbers(text).empty(); },
      [numbers, &member](const std::string &text) {
        const std::vector<double> at = numbers(text);
        member.reset();
        if (!at.empty())
          member = std::array<double, 2>{{at[0], at[1]}};
      });
}

Entry &add(Declarations      &declarations,
           const std::string &name,
           unsigned int      &member,
           const unsigned int lower,
           const unsigned int upper,
           const std::string &meaning)
{
  return declarations.add(
      name,
      std::to_string(member),
      whole_number(lower, upper),
      meaning,
      [lower, upper](const std::string &text) { return is_in(text, lower, upper); },
      [&member](const std::string &text) { member = *read_all<unsigned int>(text); },
      upper > most_in_forms ? "[Anything]" :
                              dealii::Patterns::Integer(int(lower), int(upper)).description());
}

Entry &add(Declarations                &declarations,
           const std::string           &name,
           std::optional<unsigned int> &member,
           const unsigned int           lower,
           const unsigned int           upper,
           const std::string           &meaning)
{
  return declarations.add(
      name,
      member ? std::to_string(*member) : "auto",
      whole_number(lower, upper) + ", or auto",
      meaning,
      [lower, upper](const std::string &text) {
        return text == "auto" || is_in(text, lower, upper);
      },
      [&member](const std::string &text) {
        member.reset();
        if (text != "auto")
          member = *read_all<unsigned int>(text);
      });
}

Entry &add(Declarations      &declarations,
           const std::string &name,
           unsigned int      &member,
           const unsigned int lower,
           const unsigned int upper,
           const std::string &meaning,
           const std::string &none)
{
  return declarations.add(
      name,
      member > 0 ? std::to_string(member) : none,
      whole_number(lower, upper) + ", or " + none,
      meaning,
      [lower, upper, none](const std::string &text) {
        return text == none || is_in(text, lower, upper);
      },
      [&member, none](const std::string &text) {
        member = text == none ? 0 : *read_all<unsigned int>(text);
      });
}

namespace
{
/// A list of numbers that are in @p range as they are written; @p to_text and @p from_text are
/// those of one member.
template <typename ToText, typename FromText>
Entry &add_list(Declarations        &declarations,
                const std::string   &name,
                std::vector<double> &member,
                const Range         &range,
                const std::string   &meaning,
                const ToText        &to_text,
                const FromText      &from_text)
{
  std::string default_value;
  for (const double value : member)
    default_value += (default_value.empty() ? "" : ", ") + to_text(value);
  return declarations.add(
      name,
      default_value,
      "nothing, or one of these or several separated by commas: " + range.text(),
      meaning,
      [range](const std::string &text) {
        const std::vector<std::string> words = split_at_commas(text);
        return text.empty() ||
               (!words.empty() &&
                std::all_of(words.begin(), words.end(), [&range](const std::string &word) {
                  return is_in(word, range);
                }));
      },
      [&member, from_text](const std::string &text) {
        member.clear();
        if (!text.empty())
          for (const std::string &word : split_at_commas(text))
            member.push_back(from_text(word));
      });
}
} // namespace

Entry &add(Declarations        &declarations,
           const std::string   &name,
           std::vector<double> &member,
           const int            exponent,
           const Range         &range,
           const std::string   &meaning)
{
  return add_list(
      declarations,
      name,
      member,
      range,
      meaning,
      [exponent](const double value) { return to_entry_text(value, exponent); },
      [exponent](const std::string &word) { return from_entry_text(word, exponent).value_or(0.); });
}

Entry &add_angles(Declarations        &declarations,
                  const std::string   &name,
                  std::vector<double> &member,
                  const Range         &range,
                  const std::string   &meaning)
{
  return add_list(
      declarations,
      name,
      member,
      range,
      meaning,
      [](const double value) { return to_entry_text(value / degree, unit::si); },
      [](const std::string &word) {
        return from_entry_text(word, unit::si).value_or(0.) * degree;
      });
}

Entry &add_choice(Declarations                                   &declarations,
                  const std::string                              &name,
                  const std::string                              &default_value,
                  const std::vector<std::string>                 &texts,
                  const std::string                              &meaning,
                  const std::function<void(const std::string &)> &store)
{
  std::string listed;
  for (const std::string &text : texts)
    listed += (listed.empty() ? "" : "|") + text;
  return declarations.add(
      name,
      default_value,
      alternatives(texts),
      meaning,
      [texts](const std::string &text) {
        return std::find(texts.begin(), texts.end(), text) != texts.end();
      },
      store,
      dealii::Patterns::Selection(listed).description());
}

Entry &add_choices(Declarations                                                &declarations,
                   const std::string                                           &name,
                   const std::vector<std::string>                              &texts,
                   const std::string                                           &meaning,
                   const std::function<void(const std::vector<std::string> &)> &store)
{
  std::string listed, alternatives;
  for (const std::string &text : texts)
    {
      listed += (listed.empty() ? "" : ", ") + text;
      alternatives += (alternatives.empty() ? "" : "|") + text;
    }
  const dealii::Patterns::MultipleSelection pattern(alternatives);
  return declarations.add(
      name,
      "all",
      "all, or some of these separated by commas: " + listed,
      meaning,
      [pattern](const std::string &text) {
        return text == "all" || (!text.empty() && pattern.match(text));
      },
      [store](const std::string &text) {
        store(text == "all" ? std::vector<std::string>() : split_at_commas(text));
      });
}

Entry &add_text(Declarations      &declarations,
                const std::string &name,
                std::string       &member,
                const std::string &allowed,
                const std::string &meaning)
{
  return declarations.add(
      name,
      member,
      allowed,
      meaning,
      [](const std::string &) { return true; },
      [&member](const std::string &text) { member = text; });
}

Entry &
add(Declarations &declarations, const std::string &name, bool &member, const std::string &meaning)
{
  return declarations.add(
      name,
      member ? "true" : "false",
      "true or false",
      meaning,
      [](const std::string &text) { return text == "true" || text == "false"; },
      [&member](const std::string &text) { member = text == "true"; },
      dealii::Patterns::Bool().description());
}

Entry &add(Declarations              &declarations,
           const std::string         &name,
           std::vector<unsigned int> &member,
           const std::string         &meaning)
{
  std::string default_value = member.empty() ? "all" : "";
  for (const unsigned int number : member)
    default_value += (default_value.empty() ? "" : ", ") + std::to_string(number);
  return declarations.add(
      name,
      default_value,
      "all or whole numbers separated by commas",
      meaning,
      [](const std::string &text) {
        const auto words = split_at_commas(text);
        return text == "all" ||
               (!words.empty() &&
                std::all_of(words.begin(), words.end(), [](const std::string &word) {
                  return read_all<unsigned int>(word).has_value();
                }));
      },
      [&member](const std::string &text) {
        member.clear();
        if (text != "all")
          for (const std::string &word : split_at_commas(text))
            member.push_back(*read_all<unsigned int>(word));
        std::sort(member.begin(), member.end());
        member.erase(std::unique(member.begin(), member.end()), member.end());
      });
}
} // namespace chaindrive::parameters
