// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables from text files: how these may look, and which are refused with file, line and what is
// allowed.
#include <chaindrive/functions/csv.h>
#include <chaindrive/utilities/errors.h>

#include <fstream>
#include <iostream>
#include <string>

using namespace chaindrive;

namespace
{
void read(const std::string &what, const std::string &text)
{
  std::ofstream("table.csv", std::ios::binary) << text;
  std::cout << what << ": ";
  try
    {
      const functions::Pointer table = functions::read_csv("table.csv", 1e-3, 2.);
      std::cout << table->value(0.) << ' ' << table->value(1.5e-3) << ' ' << table->value(1.)
                << '\n';
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
} // namespace

int main()
{
  read("plain", "0,10\n1,20\n2,30\n");
  read("titles", "time [ms],torque [N m]\n0,10\n1,20\n2,30\n");
  read("semicolons, blanks, tabs", "0 ; 10\n1\t20\n  +2   30 \n");
  read("notes and empty lines", "# of a test bench\n\n0,10\n\n# more\n1,20\n2,3e1");
  read("other systems",
       "\xEF\xBB\xBF"
       "a,b\r\n0,10\r\n1,20\r\n2,30\r\n");
  read("an old one", "0,10\r1,20\r2,30\r");
  read("one point", "5,7\n");
  read("empty", "");
  read("titles only", "a,b\n");
  read("titles twice", "a,b\nc,d\n0,10\n");
  read("a first point that is no number", "0,nan\n1,20\n");
  read("a first point with a letter", "0,1O\n1,20\n");
  read("titles with numbers", "speed 1,speed 2\n0,10\n");
  read("one number", "0,10\n1\n");
  read("three numbers", "0,10\n1,2,3\n");
  read("words", "0,10\n1,many\n");
  read("a decimal comma", "0,5;10,5\n");
  read("not finite", "0,10\n1,inf\n");
  read("too large", "0,10\n1,1e999\n");
  read("back in time", "0,10\n1,20\n1,30\n");
  read("no text", std::string("0,1\n\0\1\2,\xff\xfe\n", 12));
  try
    {
      functions::read_csv("nowhere.csv");
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
