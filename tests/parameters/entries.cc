// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of a .prm file and the SI members behind them: the decimal point is shifted in the text,
// so that nothing is rounded on the way. Choices: every value has one text, every text is read,
// listed and documented, and nothing else is read.
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/utilities/errors.h>

#include <cmath>
#include <iostream>
#include <random>
#include <set>
#include <string_view>
#include <utility>

using namespace chaindrive::parameters;

/// Whether the enum has a name for this number: the compiler writes a number with a cast if not.
template <typename Enum, Enum value>
constexpr bool is_enumerator()
{
  const std::string_view text  = __PRETTY_FUNCTION__;
  const char             first = text[text.rfind("value = ") + 8];
  return first != '(' && first != '-' && !(first >= '0' && first <= '9');
}

template <typename Enum, std::size_t... numbers>
constexpr std::size_t n_enumerators(std::index_sequence<numbers...>)
{
  return (is_enumerator<Enum, static_cast<Enum>(numbers)>() + ...);
}

/// The words of entries that are a choice of this enum.
template <typename Enum>
std::string check_choice(const std::string &name)
{
  std::set<std::string> texts;
  std::string           allowed;
  bool                  read_back = true;
  const auto           &table     = texts_of<Enum>;
  for (std::size_t i = 0; i < table.size(); ++i)
    {
      texts.insert(table[i].text);
      read_back = read_back && value_of<Enum>(text_of(table[i].value)) == table[i].value;
      allowed += (i == 0 ? "" : i + 1 < table.size() ? ", " : " or ") + text_of(table[i].value);
    }
  std::cout << "  " << name << ": " << allowed << "; every value has a text: "
            << (texts.size() == n_enumerators<Enum>(std::make_index_sequence<20>()))
            << ", which is read back: " << read_back
            << ", no other is: " << (!value_of<Enum>("") && !value_of<Enum>("other")) << std::endl;
  return allowed;
}

void check_choices()
{
  std::set<std::string> choices = {check_choice<PitchSet>("pitch set"),
                                   check_choice<StandardForm>("standard form"),
                                   check_choice<SeatCentre>("seat centre"),
                                   check_choice<CentreDistanceFrom>("centre distance from"),
                                   check_choice<WornChain>("worn chain"),
                                   check_choice<TightSide>("tight side"),
                                   check_choice<Start>("start"),
                                   check_choice<ElasticLinks>("elastic links"),
                                   check_choice<StiffnessFrom>("stiffness from"),
                                   check_choice<MassFrom>("mass from"),
                                   check_choice<Switch>("switch"),
                                   check_choice<Formulation>("formulation"),
                                   check_choice<SymmetryModel>("symmetry model"),
                                   check_choice<OtherLinks>("other links"),
                                   check_choice<ElementType>("element type"),
                                   check_choice<Search>("search"),
                                   check_choice<Enforcement>("enforcement"),
                                   check_choice<SpeedRamp>("speed ramp"),
                                   check_choice<Side>("side"),
                                   check_choice<Holder>("what holds a wheel"),
                                   check_choice<GuideLine>("line of a guide"),
                                   check_choice<RunsOn>("what lies on a drum"),
                                   check_choice<Precision>("history precision")};

  std::string list = check_choice<QuantityGroup>("quantity group");
  list.replace(list.find(" or "), 4, ", ");
  choices.insert("on or off"); // two states without an enum
  // those of registrations, terms and lists that have no enum here
  choices.insert("simple, layered, reduced or full");
  choices.insert("time in s, time in ms, angle in rad or angle in degrees");
  choices.insert("time in s or time in ms");
  choices.insert("rad/s or rpm");
  choices.insert("nothing, arm or slide"); // holds a guide
  {
    chaindrive::Parameters defaults;
    Declarations           all;
    defaults.declare(all);
    choices.insert(all.find("Drive/Wheels", "Order of travel")->allowed);
  }
  choices.insert("all, or some of these separated by commas: " + list);

  // entries that are no choice take a number, any text, true or false
  const std::string      documentation = parameter_documentation();
  chaindrive::Parameters p;
  Declarations           declarations;
  p.declare(declarations);
  const auto accepts = [&declarations](const Entry &entry, const std::string &text) {
    try
      {
        declarations.set(entry, text, "");
        return true;
      }
    catch (const chaindrive::InputError &)
      {
        return false;
      }
  };
  unsigned int n_choices = 0, n_unknown = 0, n_accepting = 0, n_undocumented = 0;
  for (const Entry &entry : declarations.entries())
    {
      if (entry.allowed.find("number") != std::string::npos || accepts(entry, "any text") ||
          entry.allowed == "true or false")
        continue;
      ++n_choices;
      n_unknown += choices.count(entry.allowed) == 0;
      n_accepting += accepts(entry, "") || accepts(entry, "other");
      n_undocumented += documentation.find("| " + entry.allowed + " |") == std::string::npos;
    }
  std::cout << "entries that are a choice: " << n_choices << ", of an enum not above: " << n_unknown
            << ", that take other words: " << n_accepting << ", not documented: " << n_undocumented
            << std::endl;
}

/// Lists of words: what is stored of each.
void check_lists()
{
  std::vector<QuantityGroup> chosen;
  Declarations               declarations;
  Entry                      entry;
  {
    const Subsection section(declarations, "Lists");
    entry = add(declarations, "Quantities", chosen, "A list.");
  }
  for (const char *text :
       {"tensions", "plate stress,speeds", " speeds ,  fields", "all", "", "other", "all, speeds"})
    {
      std::cout << "  '" << text << "':";
      try
        {
          declarations.set(entry, text, "");
          for (const QuantityGroup group : chosen)
            std::cout << ' ' << text_of(group) << ',';
          std::cout << (chosen.empty() ? " all" : "") << std::endl;
        }
      catch (const chaindrive::InputError &)
        {
          std::cout << " refused" << std::endl;
        }
    }
}

int main()
{
  std::cout << "choices" << std::endl;
  check_choices();

  std::cout << "lists" << std::endl;
  check_lists();

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
