// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/guide.h>

#include <deal.II/base/utilities.h>

namespace chaindrive::parameters
{
namespace
{
/// The points in @p text, m; none if there is something else in it, or fewer than two.
std::vector<std::array<double, 2>> points_in(const std::string &text)
{
  std::vector<std::array<double, 2>> points;
  for (const std::string &word : dealii::Utilities::split_string_list(text, ';'))
    {
      const auto numbers = dealii::Utilities::split_string_list(word, ',');
      if (numbers.size() != 2)
        return {};
      std::array<double, 2> point{};
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto value = from_entry_text(numbers[d], unit::si);
          if (!value || !between(-1e5, 1e5).contains(*value))
            return {};
          point[d] = *from_entry_text(numbers[d], unit::milli);
        }
      points.push_back(point);
    }
  return points.size() < 2 ? std::vector<std::array<double, 2>>() : points;
}

std::string text_of_points(const std::vector<std::array<double, 2>> &points)
{
  std::string text;
  for (const auto &point : points)
    text += (text.empty() ? "" : "; ") + to_entry_text(point[0], unit::milli) + ", " +
            to_entry_text(point[1], unit::milli);
  return text;
}
} // namespace

Guide::Guide() = default;

void Guide::declare(Declarations &declarations, const bool may_move)
{
  const Subsection section(declarations, "Guide");
  declarations.add(
      "Points in mm",
      text_of_points(points),
      "nothing, or two points or more separated by semicolons, each x and y separated "
      "by a comma, numbers from -100000 to 100000",
      "Of a guide beside the span that leads from this wheel to the next one, as in "
      "Centre in mm: the line on which the edges of the plates slide, from end to end. "
      "The chain must run beside it at the start; all fidelities but full. Nothing: "
      "there is no guide.",
      [](const std::string &text) { return text.empty() || !points_in(text).empty(); },
      [this](const std::string &text) { points = points_in(text); });
  add(declarations,
      "Line",
      line,
      "arc: the circle through three points. spline: the natural cubic spline through them all, of "
      "two a straight line.");
  add(declarations,
      "Plate friction coefficient",
      friction,
      unit::si,
      between(0., 2.),
      "Of plates on the guide. Default: steel on a plastic guide with oil.");
  add(declarations,
      "Stiffness in N/m",
      stiffness,
      unit::si,
      above(0., 1e12),
      "Of the contact of the plates at one joint with the guide. Default: of the order of a "
      "plastic guide on a steel carrier.");
  if (may_move)
    held.declare_of_guide(declarations);
}
} // namespace chaindrive::parameters
