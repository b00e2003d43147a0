// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that cannot be run: what the user reads about each.
#include <chaindrive/model/reading.h>
#include <chaindrive/utilities/errors.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace chaindrive;

void read(const std::string &file)
{
  try
    {
      const auto input = model::read_parameters(file);
      std::cout << "  accepted" << std::endl;
      for (const std::string &note : input.notes)
        std::cout << "  note: " << note << std::endl;
      for (const std::string &warning : input.warnings)
        std::cout << "  warning: " << warning << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << "  " << error.what() << std::endl;
    }
}

void read_text(const std::string &title, const std::string &text)
{
  std::cout << title << std::endl;
  std::ofstream("bad.prm", std::ios::binary) << text;
  read("bad.prm");
}

int main()
{
  std::cout << "files" << std::endl;
  read("no_such_file.prm");
  read("help");
  std::ofstream("without_ending.prm") << "";
  read("without_ending");
  std::filesystem::create_directory("a_directory");
  read("a_directory");
  read_text("empty", "");
  read_text("comments only", "# nothing\n\n   \n");
  read_text("binary", std::string("set x\0 = 1\n", 11));
  read_text("control bytes", "\x1f\x8b\x08 compressed");
  read_text("too large", std::string(2 << 20, ' '));

  read_text("misspelt section", "subsection Drve\n  set Driver teeth = 15\nend\n");
  read_text("misspelt inner section", "subsection Drive\n  subsection Chian\n  end\nend\n");
  read_text("section elsewhere", "subsection Layout\nend\n");
  read_text("section far from all names", "subsection Xyzzy\nend\n");
  read_text("misspelt entry", "subsection Drive\n\n  set Driver tooth = 15\nend\n");
  read_text("entry elsewhere", "subsection Drive\n  set Friction coefficient = 0.1\nend\n");
  read_text("entry without its unit", "subsection Time\n  set End = 30\nend\n");
  read_text("entry in another unit", "subsection Time\n  set End time in s = 0.03\nend\n");
  read_text("entry in a unit of another kind", "subsection Time\n  set End time in mm = 3\nend\n");
  read_text("entry that has no unit", "subsection Contact\n  set Penalty factor in N = 3\nend\n");
  read_text("entry outside all sections", "set Foo = 15\n");

  read_text("below its range", "subsection Drive\n  set Driver teeth = 8\nend\n");
  read_text("not a whole number", "subsection Drive\n  set Driver teeth = 15.5\nend\n");
  read_text("not a number", "subsection Time\n  set End time in ms = 30 ms\nend\n");
  read_text("half a point", "subsection Acoustics\n  set Observers = 1 2 3; 4 5\nend\n");
  read_text("a point of words", "subsection Acoustics\n  set Observers = left 2 3\nend\n");
  read_text("four coordinates", "subsection Acoustics\n  set Observers = 1 2 3 4\nend\n");
  read_text("decimal comma", "subsection Time\n  set End time in ms = 0,5\nend\n");
  read_text("end of an open range",
            "subsection Drive\n  subsection Layout\n    set Start phase = 1\n  end\nend\n");
  read_text("no number at all", "subsection Model\n  set Mass per pitch in g = heavy\nend\n");
  read_text("nothing", "subsection Model\n  set Fidelity =\nend\n");
  read_text("no such choice", "subsection Model\n  set Fidelity = finest\nend\n");
  read_text("no list", "subsection Output\n  set Rollers = 1, two\nend\n");

  read_text("end too many", "subsection Model\nend\nend\n");
  read_text("end missing", "subsection Drive\n  subsection Chain\n  end\n");
  read_text("end missing before the next section",
            "subsection Drive\n  subsection Chain\n  end\n\nsubsection Model\nend\n");
  read_text("text after end", "subsection Model\nend Model\n");
  read_text("no set", "subsection Drive\n  Driver teeth = 15\nend\n");
  read_text("no equals", "subsection Drive\n  set Driver teeth 15\nend\n");
  read_text("not a statement", "Drive:\n  teeth: 15\n");
  read_text("include", "include other.prm\n");

  read_text("several mistakes at once",
            "subsection Drive\n  set Driver teeth = 5\n  set Driven tooth = 42\nend\n"
            "subsection Modle\n  set Fidelity = simple\nend\n");
  read_text("set twice",
            "subsection Drive\n  set Driver teeth = 15\n  set Driver teeth = 16\nend\n");
  read_text("set three times",
            "subsection Time\n  set End time in ms = 20\nend\nsubsection Time\n"
            "  set End time in ms = 25\n\n  set End time in ms = 30\nend\n");
  read_text(
      "without effect in the simple model",
      "subsection Contact\n  set Penalty factor = 1\n  set Bush-pin friction = 0.2\nend\n"
      "subsection Elements\n  set Formulation = full\n  set Hourglass coefficient = 0.05\nend\n"
      "subsection Drive\n  subsection Layout\n    set Sag in percent = 2\n"
      "    set Slack in mm = 0.6\n  end\nend\n");
  read_text("without effect in the full model",
            "subsection Model\n  set Fidelity = full\n  set Chain damping ratio = 0.02\nend\n"
            "subsection Elements\n  set Hourglass coefficient = 0.05\nend\n");
  read_text("without effect at a settled start",
            "subsection Drive\n  subsection Layout\n    set Start = settled\n  end\nend\n"
            "subsection Loads\n  set Ramp time in ms = 2\nend\n");
  read_text("without effect where there is no table, change or guide",
            "subsection Loads\n"
            "  subsection driver\n    subsection Table\n      set File = speed.csv\n"
            "      set Repeats = true\n    end\n"
            "    subsection Changes\n      set Course = linear\n    end\n  end\n"
            "  subsection driven\n    subsection Table\n      set Repeats = true\n    end\n  end\n"
            "end\n"
            "subsection Drive\n  subsection Wheels\n    subsection driven\n"
            "      subsection Guide\n        set Line = spline\n      end\n    end\n  end\nend\n");
  const std::string wheels = "subsection Drive\n  set Number of links = auto\n"
                             "  subsection Chain\n    set Designation = 08B\n  end\n"
                             "  subsection Wheels\n"
                             "    set Order of travel = driver, idler, driven\n"
                             "    subsection idler\n      set Teeth = 13\n"
                             "      set Side = outside\n      set Centre in mm = 190, -58\n",
                    driven = "    subsection driven\n      set Centre in mm = 411, 0\n    end\n",
                    end = "    end\n", both = "  end\nend\n";
  read_text("links for a distance", wheels + end + both);
  read_text("links for given centres", wheels + end + driven + both);
  read_text("links for a tensioner", wheels + "      set Held by = arm\n" + end + driven + both);
  read_text("no hourglass stiffness",
            "subsection Elements\n  set Hourglass coefficient = 0\nend\n");
  read_text("defaults are not worth a note",
            "subsection Contact\n  set Penalty factor = 0.50\nend\n"
            "subsection Elements\n  set Hourglass coefficient = 1e-1\nend\n");
  read_text("Windows line ends and byte order mark",
            "\xef\xbb\xbfsubsection Drive\r\n  set Driver teeth = 15\r\nend\r\n");
}
