// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/functions/csv.h>
#include <chaindrive/functions/terms.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::functions
{
namespace
{
/// What the first column of a table is.
enum class Column
{
  seconds,
  milliseconds,
  radians,
  degrees
};

/// What the second column of a table of speeds is.
enum class SpeedUnit
{
  rad_per_s,
  rpm
};
} // namespace
} // namespace chaindrive::functions

namespace chaindrive::parameters
{
template <>
inline constexpr Texts<functions::Column, 4> texts_of<functions::Column>{
    {{functions::Column::seconds, "time in s"},
     {functions::Column::milliseconds, "time in ms"},
     {functions::Column::radians, "angle in rad"},
     {functions::Column::degrees, "angle in degrees"}}};

template <>
inline constexpr Texts<functions::SpeedUnit, 2> texts_of<functions::SpeedUnit>{
    {{functions::SpeedUnit::rad_per_s, "rad/s"}, {functions::SpeedUnit::rpm, "rpm"}}};
} // namespace chaindrive::parameters

namespace chaindrive::functions
{
namespace
{
using dealii::numbers::PI;
using parameters::add;

const char *const lines =
    " On each line two numbers, apart by a comma, a semicolon or blanks; a first line of titles "
    "and "
    "lines that begin with # are left out. Between points a monotone cubic, before the first and "
    "after the last one constant. It is looked for in the parameter file's directory, then in the "
    "one the program is started in. Empty: none.";

/// Of the points of a table in s or rad: beyond, and closer together, sums over them lose their
/// digits.
constexpr double farthest = 1e9, closest = 1e-9;

/// What is wrong with @p table, whose values are up to @p most @p unit; empty if nothing is.
std::string wrong_in(const Table &table, const double most, const std::string &unit)
{
  const std::vector<double> &x = table.x();
  if (x.size() < 2)
    return "has one point only; a table has at least two";
  if (std::max(-x.front(), x.back()) > farthest)
    return "goes beyond " + to_text(farthest) + " s or rad; leave out what is farther";
  for (std::size_t i = 1; i < x.size(); ++i)
    if (x[i] - x[i - 1] < closest)
      return "has points " + std::to_string(i) + " and " + std::to_string(i + 1) + " less than " +
             to_text(closest) + " s or rad apart; leave one of them out";
  for (const double value : table.y())
    if (std::abs(value) > most)
      return "has the value " + to_text(value) + ' ' + unit + "; numbers from " + to_text(-most) +
             " to " + to_text(most) + " are allowed";
  return "";
}

/// The file @p name of @p shaft as a table with values up to @p most @p unit.
std::shared_ptr<const Table> read_table(const std::string &name,
                                        const Shaft       &shaft,
                                        const double       x_unit,
                                        const double       y_unit,
                                        const double       x_zero,
                                        const double       most,
                                        const std::string &unit,
                                        std::string       &path)
{
  try
    {
      path       = files::find_file(name, shaft.folders);
      auto table = read_csv(path, x_unit, y_unit, x_zero);
      if (const std::string wrong = wrong_in(*table, most, unit); !wrong.empty())
        throw InputError("'" + path + "' " + wrong + ".");
      return table;
    }
  catch (const InputError &error)
    {
      throw InputError(shaft.section + "/File = " + name + ": " + error.what());
    }
}

/// @p table over and over; its ends must be alike.
Pointer repeated(const std::shared_ptr<const Table> &table, const Shaft &shaft)
{
  const std::vector<double> &y     = table->y();
  const double               scale = table->largest(table->x().front(), table->x().back());
  if (std::abs(y.front() - y.back()) > 1e-9 * scale)
    throw InputError(shaft.section +
                     "/Repeats = true needs a table that ends with the value with which it begins: "
                     "give one, or choose false.");
  return std::make_shared<Periodic>(table, table->x().front(), table->x().back());
}

struct TorqueTable
{
  struct Parameters
  {
    std::string file;
    Column      column  = Column::milliseconds;
    bool        repeats = false;

    bool is_active() const { return !file.empty(); }

    void declare(parameters::Declarations &declarations)
    {
      add_text(declarations,
               "File",
               file,
               "a file name or nothing",
               std::string("Table of a torque in N m that is added to the others.") + lines);
      add(declarations,
          "Variable",
          column,
          "What the first column is: time since the start, or the angle that this shaft has turned "
          "since then in the sense of operation. Over an angle the torque grows over Loads/Torque "
          "ramp angle in rad, as the others do.");
      add(declarations,
          "Repeats",
          repeats,
          "Whether the table begins anew where it ends, as the load of a machine that does the "
          "same "
          "in each revolution.");
    }
  };

  static Term make(const Parameters &given, const Shaft &shaft)
  {
    const bool   of_time = given.column == Column::seconds || given.column == Column::milliseconds;
    const double unit    = given.column == Column::milliseconds ? 1e-3 :
                           given.column == Column::degrees      ? PI / 180. :
                                                                  1.;
    Term         term{of_time ? Variable::time : Variable::angle, nullptr};
    const auto   table =
        read_table(given.file, shaft, unit, 1., of_time ? shaft.start : 0., 1e7, "N m", term.file);
    term.function = given.repeats ? repeated(table, shaft) : table;
    return term;
  }
};

struct SpeedTable
{
  struct Parameters
  {
    std::string file;
    Column      column  = Column::milliseconds;
    SpeedUnit   unit    = SpeedUnit::rad_per_s;
    bool        repeats = false;

    bool is_active() const { return !file.empty(); }

    void declare(parameters::Declarations &declarations)
    {
      add_text(
          declarations,
          "File",
          file,
          "a file name or nothing",
          std::string("Table of the driver's speed over time, in place of Loads/Driver speed in "
                      "rad/s and its ramp; that entry remains the speed for which key figures, "
                      "design checks and pitch times are told.") +
              lines);
      parameters::add_choice(
          declarations,
          "Variable",
          parameters::text_of(column),
          {parameters::text_of(Column::seconds), parameters::text_of(Column::milliseconds)},
          "What the first column is: time since the start.",
          [this](const std::string &text) { column = *parameters::value_of<Column>(text); });
      add(declarations,
          "Value",
          unit,
          "What the second column is. Below zero the driver turns back.");
      add(declarations, "Repeats", repeats, "Whether the table begins anew where it ends.");
    }
  };

  static Term make(const Parameters &given, const Shaft &shaft)
  {
    Term       term{Variable::time, nullptr, true};
    const auto table = read_table(given.file,
                                  shaft,
                                  given.column == Column::milliseconds ? 1e-3 : 1.,
                                  given.unit == SpeedUnit::rpm ? PI / 30. : 1.,
                                  shaft.start,
                                  1e5,
                                  "rad/s",
                                  term.file);
    term.function    = given.repeats ? repeated(table, shaft) : table;
    return term;
  }
};

const TermOf<SpeedTable>  table_of_speed(Of::speed, {"Table", "The speed from a file."});
const TermOf<TorqueTable> table_of_torque(Of::torque, {"Table", "A torque from a file."});
} // namespace
} // namespace chaindrive::functions
