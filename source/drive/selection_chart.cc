// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/selection.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace chaindrive::drive
{
namespace
{
constexpr double left = 130., width = 150., gap = 22., top = 92., row_height = 26.; // pixels

/// A column of the chart: a bar from `from` to its value for each candidate, or on a logarithmic
/// axis; a line where a demand is met.
struct Panel
{
  std::string                              title, unit;
  std::function<double(const Candidate &)> value;
  std::function<std::string(double)>       text;
  bool                                     logarithmic;
  double                                   from;   ///< where bars begin
  double                                   wanted; ///< 0: nothing is
  bool                                     more_is_better;
};

std::string px(const double value) { return to_text(std::round(value * 10.) / 10., 7); }

std::string text_at(const double       x,
                    const double       y,
                    const std::string &words,
                    const char        *anchor = "start",
                    const char        *what   = "")
{
  return "  <text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + anchor + "\"" +
         (*what != 0 ? std::string(" class=\"") + what + "\"" : std::string()) + ">" + words +
         "</text>\n";
}

std::string digits(const double value) { return to_text(value, 3); }

std::string in_thousands(const double hours)
{
  return !std::isfinite(hours) || hours >= 1e6 ? "endless" :
         hours < 1000.                         ? to_text(hours, 3) + " h" :
                                                 to_text(1e-3 * hours, 3) + " kh";
}

std::vector<Panel> panels(const Demand &demand)
{
  return {{"Life",
           "shortest of wear, rollers, plates",
           [](const Candidate &c) { return c.hours(); },
           in_thousands,
           true,
           1000.,
           demand.hours,
           true},
          {"Safety",
           "rated power over power",
           [](const Candidate &c) { return c.capacity; },
           digits,
           false,
           0.,
           1.,
           true},
          {"Size",
           "kg of chain and sprockets",
           [](const Candidate &c) { return c.mass; },
           digits,
           false,
           0.,
           0.,
           false},
          {"Impact",
           "m/s of rollers on teeth",
           [](const Candidate &c) { return c.impact; },
           digits,
           false,
           0.,
           0.,
           false},
          {"Sound",
           "dB(A) at 0.3 m, estimate",
           [](const Candidate &c) { return c.sound; },
           digits,
           false,
           50.,
           0.,
           false}};
}

/// Part of the width of @p panel that the bar of @p value has; @p most is at its end.
double part_of(const Panel &panel, const double value, const double most)
{
  const double bounded = std::clamp(value, panel.from, most);
  return panel.logarithmic ? std::log(bounded / panel.from) / std::log(most / panel.from) :
                             (bounded - panel.from) / (most - panel.from);
}
} // namespace

void draw(std::ostream                 &out,
          const Demand                 &demand,
          const std::vector<Candidate> &candidates,
          const unsigned int            rows)
{
  const std::size_t        n      = std::min<std::size_t>(rows, candidates.size());
  const std::vector<Panel> all    = panels(demand);
  const double             bottom = top + row_height * double(n),
               right              = left + double(all.size()) * (width + gap);
  const auto middle = [](const std::size_t i) { return top + row_height * (double(i) + 0.5); };
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << px(right) << ' '
      << px(bottom + 34.) << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
      << "  <title>Chains for " << to_text(1e-3 * demand.power) << " kW</title>\n"
      << "  <style>.bar { fill: #1c6aa8 } .bad { fill: #b3261e } .stripe { fill: #f3f5f7 } .want { "
         "stroke: #2d7d46; stroke-dasharray: 4 3 } .head { font-weight: bold } .small { font-size: "
         "10px; fill: #555 }</style>\n"
      << "  <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      << text_at(12.,
                 24.,
                 to_text(1e-3 * demand.power) + " kW at " +
                     to_text(demand.speed * 30. / dealii::numbers::PI) + " rpm, ratio " +
                     to_text(demand.ratio) + ", centre distance about " +
                     to_text(1e3 * demand.centre_distance) + " mm, " + to_text(demand.hours) + " h",
                 "start",
                 "head");
  for (std::size_t i = 0; i < n; i += 2)
    out << "  <rect class=\"stripe\" x=\"0\" y=\"" << px(top + row_height * double(i))
        << "\" width=\"" << px(right) << "\" height=\"" << px(row_height) << "\"/>\n";
  for (std::size_t i = 0; i < n; ++i)
    {
      const Candidate &c = candidates[i];
      out << text_at(12.,
                     middle(i) + 4.,
                     c.chain + "-" + std::to_string(c.strands) + ", " +
                         std::to_string(c.driver_teeth) + "/" + std::to_string(c.driven_teeth),
                     "start",
                     c.faults.empty() ? "" : "bad");
    }
  for (std::size_t k = 0; k < all.size(); ++k)
    {
      const Panel &panel = all[k];
      const double x     = left + double(k) * (width + gap);
      double       most  = panel.wanted;
      for (std::size_t i = 0; i < n; ++i)
        if (const double value = panel.value(candidates[i]); std::isfinite(value))
          most = std::max(most, value);
      most              = panel.logarithmic ? std::min(std::max(most, 10. * panel.from), 1e6) :
                                              std::max(most, panel.from + 1e-9);
      const double room = width - 52.; // beside it stands the value
      out << text_at(x, top - 26., panel.title, "start", "head")
          << text_at(x, top - 10., panel.unit, "start", "small");
      for (std::size_t i = 0; i < n; ++i)
        {
          const double value = panel.value(candidates[i]);
          const double bar   = room * part_of(panel, value, most);
          const bool   bad   = panel.wanted > 0. &&
                           (panel.more_is_better ? value < panel.wanted : value > panel.wanted);
          out << "  <rect class=\"" << (bad ? "bad" : "bar") << "\" x=\"" << px(x) << "\" y=\""
              << px(middle(i) - 7.) << "\" width=\"" << px(bar) << "\" height=\"14\"/>\n"
              << text_at(x + bar + 4., middle(i) + 4., panel.text(value));
        }
      if (panel.wanted > 0.)
        {
          const double at = x + room * part_of(panel, panel.wanted, most);
          out << "  <path class=\"want\" d=\"M" << px(at) << ' ' << px(top - 4.) << "V"
              << px(bottom) << "\"/>\n";
        }
    }
  out << text_at(12.,
                 bottom + 20.,
                 "Closed forms; life within a factor of " + to_text(wear_scatter) +
                     ", on a logarithmic axis from 1000 h; sound from 50 dB(A). Dashed: what is "
                     "asked for; red: what "
                     "misses it, and chains that something speaks against.",
                 "start",
                 "small")
      << "</svg>\n";
}
} // namespace chaindrive::drive
