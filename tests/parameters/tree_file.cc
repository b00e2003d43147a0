// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files as XML and JSON: what this program writes, deal.II reads, and the other way
// round; what deal.II's parameter_gui offers for entries; damaged files.
#include <chaindrive/model/reading.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

using namespace chaindrive;
using namespace chaindrive::parameters;

/// deal.II's own reader finds @p text to be a file of its form, with this value.
std::string read_by_dealii(const std::string &text, const bool xml)
{
  dealii::ParameterHandler prm;
  prm.enter_subsection("Drive");
  prm.declare_entry("Driver teeth", "0", dealii::Patterns::Integer());
  prm.enter_subsection("Chain");
  prm.declare_entry("Designation", "", dealii::Patterns::Anything());
  prm.leave_subsection();
  prm.leave_subsection();
  prm.enter_subsection("Loads");
  prm.declare_entry("Driver speed in rad/s", "0", dealii::Patterns::Double());
  prm.leave_subsection();
  std::istringstream in(text);
  if (xml)
    prm.parse_input_from_xml(in, /*skip_undefined=*/true);
  else
    prm.parse_input_from_json(in, true);
  prm.enter_subsection("Drive");
  std::string found = std::to_string(prm.get_integer("Driver teeth"));
  prm.enter_subsection("Chain");
  found += " teeth, " + prm.get("Designation");
  prm.leave_subsection();
  prm.leave_subsection();
  prm.enter_subsection("Loads");
  return found + ", " + prm.get("Driver speed in rad/s") + " rad/s";
}

void read(const std::string &file, const std::string &text)
{
  std::ofstream(file) << text;
  try
    {
      const Input input = model::read_parameters(file);
      std::cout << "  accepted: " << input.parameters.drive.sprockets.driver().teeth << " teeth";
      for (const std::string &note : input.notes)
        std::cout << "\n  note: " << note;
      std::cout << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << "  " << error.what() << std::endl;
    }
}

int main()
{
  // from .prm to a tree and back; wheels, forms of one quantity of which only one may be given
  std::ofstream("a.prm") << "subsection Drive\nset Driver teeth = 17\nset Driven teeth = 21\n"
                            "subsection Chain\nset Designation = 08B\nend\n"
                            "subsection Wheels\nset Order of travel = driver, driven, idler\n"
                            "subsection idler\nset Teeth = 13\nset Centre in mm = 200, -90\nend\n"
                            "end\nend\n"
                            "subsection Loads\nset Driver speed in rpm = 300\nend\n"
                            "subsection Output\nset Directory = a b/<&>\"c\nend\n";
  const Input given = parameters::read_parameters("a.prm");
  for (const Form form : {Form::xml, Form::json, Form::prm})
    {
      const std::string name = "b." + text_of(form), text = in_form("a.prm", form);
      std::ofstream(name) << text;
      const Input again = parameters::read_parameters(name);
      std::cout << text_of(form) << ": the same drive " << (again.resolved == given.resolved)
                << ", written again the same "
                << (in_form(name, form) == text &&
                    in_form(name, Form::prm) == in_form("a.prm", Form::prm));
      if (form != Form::prm)
        std::cout << ", deal.II: " << read_by_dealii(text, form == Form::xml);
      std::cout << std::endl;
    }
  const std::string left = parameters::read_parameters("b.xml").text;
  std::ofstream("left.prm") << left;
  std::cout << left << "as .prm the same drive "
            << (parameters::read_parameters("left.prm").resolved == given.resolved) << std::endl;

  // what deal.II writes itself: names with any character, entries in another order
  dealii::ParameterHandler prm;
  prm.enter_subsection("Loads");
  prm.declare_entry("Driver speed in rad/s", "50", dealii::Patterns::Double());
  prm.leave_subsection();
  prm.enter_subsection("Drive");
  prm.declare_entry("Driver teeth", "15", dealii::Patterns::Integer());
  prm.set("Driver teeth", "19");
  prm.leave_subsection();
  for (const auto &[name, style] : {std::make_pair("d.xml", dealii::ParameterHandler::XML),
                                    std::make_pair("s.xml", dealii::ParameterHandler::ShortXML),
                                    std::make_pair("d.json", dealii::ParameterHandler::JSON),
                                    std::make_pair("s.json", dealii::ParameterHandler::ShortJSON)})
    {
      std::ofstream out(name);
      prm.print_parameters(out, style);
      out.close();
      const Input input = parameters::read_parameters(name);
      std::cout << name << ": " << input.parameters.drive.sprockets.driver().teeth << " teeth, "
                << input.parameters.loads.driver_speed << " rad/s" << std::endl;
    }

  // fields of parameter_gui
  const std::string all = in_form(std::map<std::string, std::string>(), Form::xml);
  for (const char *name : {"Tight_20span",
                           "Number_20of_20links",
                           "Driver_20teeth",
                           "CSV",
                           "Friction_20coefficient",
                           "Start_20phase",
                           "Designation"})
    {
      const std::size_t at   = all.find(std::string("<") + name + ">");
      const std::size_t from = all.find("<pattern_description>", at) + 21;
      std::cout << name << ": " << all.substr(from, all.find('<', from) - from) << std::endl;
    }
  read("defaults.xml", all);

  std::cout << "damaged" << std::endl;
  read("cut.xml", all.substr(0, all.find("<value>") + 7));
  read("empty.xml", "");
  read("no_xml.xml", "subsection Drive\n  set Driver teeth = 17\nend\n");
  read("other.xml", "<?xml version=\"1.0\"?><svg><g/></svg>");
  read("no_json.json", "{\n \"Drive\": {\n  \"Driver teeth\": 17,\n }\n}\n");
  read("list.json", "{\"Drive\": {\"Driver teeth\": [17, 19]}}");
  read("top_list.json", "[1, 2]");
  read("number.json", "{\"Drive\": {\"Driver teeth\": 17}}");
  read("empty_section.json", "{\"Drive\": {}}");
  std::string deep;
  for (int i = 0; i < 200000; ++i)
    deep += "<a>";
  read("deep.xml", "<ParameterHandler>" + deep);
  std::replace(deep.begin(), deep.end(), '<', '[');
  read("deep.json", deep);
  const std::string begin = "<ParameterHandler><Drive>", end = "</Drive></ParameterHandler>";
  const auto        teeth = [&](const std::string &value) {
    return begin + "<Driver_20teeth><value>" + value + "</value></Driver_20teeth>" + end;
  };
  read("good.xml", teeth(" 17 "));
  read("not_allowed.xml", teeth("3"));
  read("twice.xml",
       begin + "<Driver_20teeth><value>17</value></Driver_20teeth>" +
           "<Driver_20teeth><value>18</value></Driver_20teeth>" + end);
  read("statement.xml", teeth("17\n  set Driven teeth = 99"));
  read("comment.xml", teeth("17 # 18"));
  read("name.xml",
       begin + "<Driver_20teeth_0aset_20Driven><value>17</value>" +
           "</Driver_20teeth_0aset_20Driven>" + end);
  read("unknown.xml", begin + "<Driver_20tooth><value>17</value></Driver_20tooth>" + end);
  read("unknown_section.xml",
       "<ParameterHandler><Drve><Driver_20teeth><value>17</value></Driver_20teeth></Drve>"
       "</ParameterHandler>");
  read("bad_order.xml",
       "<ParameterHandler><Drive><Wheels><Order_20of_20travel><value>driver, driver</value>"
       "</Order_20of_20travel></Wheels></Drive></ParameterHandler>");
  read("entity.xml",
       "<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>" +
           teeth("&a;"));
}
