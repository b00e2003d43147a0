// SPDX-License-Identifier: LGPL-2.1-or-later
// Names that entries and their values had in earlier versions are read, in files, overrides, loops
// of studies and misspelt; a note says what each is called now, once; both names in one file are
// refused. What is read is what the present name gives.
#include <chaindrive/parameters/old_names.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/utilities/errors.h>

#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using namespace chaindrive;
using parameters::Input;
using parameters::OldEntry;
using parameters::OldValue;

namespace
{
/// A value of each entry that is not its default.
const std::map<std::string, std::string> values = {{"Model/Symmetry model", "false"},
                                                   {"Elements/Selective mass scaling", "0.5"},
                                                   {"Time/Time step in us", "0.02"}};

/// "subsection A ... set NAME = value ... end" of the entry @p path.
std::string set(const std::string &path, const std::string &value)
{
  const std::size_t slash = path.rfind('/');
  return "subsection " + path.substr(0, slash) + "\n  set " + path.substr(slash + 1) + " = " +
         value + "\nend\n";
}

const std::string full = set("Model/Fidelity", "full");

std::string file(const std::string &text)
{
  std::ofstream("drive.prm") << text;
  return "drive.prm";
}

/// How often the notes say that something is called @p now.
unsigned int n_notes(const std::vector<std::string> &notes, const std::string &now)
{
  unsigned int n = 0;
  for (const std::string &note : notes)
    n += note.find(" is now called " + now + ".") != std::string::npos ? 1 : 0;
  return n;
}

std::string refusal(const std::string &text)
{
  try
    {
      parameters::read_parameters(file(text));
    }
  catch (const InputError &error)
    {
      return error.what();
    }
  return "accepted";
}

void check(const std::string &what, const bool good)
{
  std::cout << "  " << what << ": " << (good ? "yes" : "NO") << '\n';
}

/// What is the same of an entry and of a value: @p old_text and @p text set it in a file, @p
/// old_override and @p entry on the command line; @p now is how it is called.
void compare(const std::string &old_text,
             const std::string &text,
             const std::string &old_override,
             const std::string &now)
{
  const Input by_old = parameters::read_parameters(file(full + old_text)),
              by_new = parameters::read_parameters(file(full + text)),
              both   = parameters::read_parameters(file(full + old_text), {old_override}),
              on_top = parameters::read_parameters(file(full), {old_override});
  check("one note, none of the present name",
        n_notes(by_old.notes, now) == 1 && n_notes(by_new.notes, now) == 0);
  check("one note in an override, and one of file and override together",
        n_notes(on_top.notes, now) == 1 && n_notes(both.notes, now) == 1);
  check("all entries are the same, written and for a run that resumes",
        by_old.resolved == by_new.resolved && on_top.resolved == by_new.resolved &&
            by_old.fixed == by_new.fixed);
  check("and others than by default",
        by_new.resolved != parameters::read_parameters(file(full)).resolved);
}
} // namespace

int main()
{
  for (const OldEntry &entry : parameters::old_entries())
    {
      std::cout << entry.old_path << '\n';
      const std::string &value = values.at(entry.path);
      compare(set(entry.old_path, value),
              set(entry.path, value),
              entry.old_path + "=" + value,
              entry.path);
      std::cout << "  both: " << refusal(full + set(entry.old_path, value) + set(entry.path, value))
                << '\n'
                << "  both, the present one first: "
                << refusal(full + set(entry.path, value) + set(entry.old_path, value)) << '\n';
    }
  for (const OldValue &one : parameters::old_values())
    {
      std::cout << one.path << " = " << one.old_value << '\n';
      // the default of a choice differs from what is set before it
      const std::string before = full + (one.value == "solid" ? set(one.path, "membrane") : "");
      const Input       by_old =
                      parameters::read_parameters(file(before), {one.path + "=" + one.old_value}),
                  by_new = parameters::read_parameters(file(before), {one.path + "=" + one.value});
      check("one note, none of the present value",
            n_notes(by_old.notes, one.value) == 1 && n_notes(by_new.notes, one.value) == 0);
      check("all entries are the same", by_old.resolved == by_new.resolved);
      check("and others than before",
            by_new.resolved != parameters::read_parameters(file(before)).resolved);
    }

  std::cout << "A study\n";
  const auto study = parameters::read_study(file(set("Study/Against", "Time/Step in us") +
                                                 set("Time/Step in us", "{0.1 | 0.2}") +
                                                 set("Model/Elastic links", "{{all | arriving}}")),
                                            {},
                                            false);
  for (const std::string &note : study.notes)
    std::cout << "  " << note << '\n';
  std::cout << "  against " << study.study.against << '\n';
  for (const parameters::Variant &variant : study.variants)
    {
      std::cout << "  " << variant.name << ":";
      for (const auto &[path, value] : variant.values)
        std::cout << " " << path << " = " << value << ";";
      std::cout << '\n';
    }

  std::cout << "Misspelt\n";
  for (const char *text : {"Model/Half modell=true", "Half model=true", "Time/Step in ms=1"})
    try
      {
        parameters::read_parameters(file(full), {text});
        std::cout << "  accepted\n";
      }
    catch (const InputError &error)
      {
        std::cout << "  " << error.what() << '\n';
      }
}
