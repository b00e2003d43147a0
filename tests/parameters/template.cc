// SPDX-License-Identifier: LGPL-2.1-or-later
// The template can be read again and gives the defaults; so does the file of all values that a run
// leaves among its results.
#include <chaindrive/model/reading.h>
#include <chaindrive/parameters/declarations.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/parameters/writer.h>
#include <chaindrive/utilities/errors.h>

#include <fstream>
#include <iostream>
#include <sstream>

using namespace chaindrive;
using namespace chaindrive::parameters;

int main()
{
  Parameters   defaults;
  Declarations declarations;
  defaults.declare(declarations);
  std::ostringstream expected;
  write_prm(expected, declarations, {}, false);

  std::ofstream template_file("template.prm");
  write_template(template_file);
  template_file.close();
  const Input from_template = model::read_parameters("template.prm");
  std::cout << "template gives the defaults: " << (from_template.resolved == expected.str())
            << ", notes: " << from_template.notes.size() << std::endl;

  std::ofstream("short.prm") << "subsection Drive\nset Driver teeth = 17\nend\n"
                                "subsection Contact\nset Damping ratio = 0.25\nend\n"
                                "subsection Output\nset Rollers = 3, 1, 3\nend\n";
  const Input given = model::read_parameters("short.prm");
  std::ofstream("resolved.prm") << given.resolved;
  const Input again = model::read_parameters("resolved.prm");
  std::cout << "file of all values gives the same values: " << (again.resolved == given.resolved)
            << std::endl;
  std::cout << "teeth " << again.parameters.drive.sprockets.driver().teeth << ", damping ratio "
            << again.parameters.contact.damping_ratio << ", rollers";
  for (const unsigned int roller : again.parameters.output.rollers)
    std::cout << ' ' << roller;
  std::cout << std::endl;

  // what differs from the default can be seen
  std::istringstream lines(given.resolved);
  for (std::string line; std::getline(lines, line);)
    if (line.find("default:") != std::string::npos)
      std::cout << line << std::endl;

  // speed in rpm and power in kW stand for rad/s and N m: 3000 W / (50 rad/s * 21/63) = 180 N m
  std::ofstream("other_forms.prm")
      << "subsection Drive\nset Driver teeth = 21\nset Driven teeth = 63\nend\n"
         "subsection Loads\nset Driver speed in rpm = 477.46482927568605\n"
         "set Power in kW = 3\nend\n";
  const Input other_forms = model::read_parameters("other_forms.prm");
  std::ofstream("other_forms_resolved.prm") << other_forms.resolved;
  for (const parameters::Loads &loads :
       {other_forms.parameters.loads,
        model::read_parameters("other_forms_resolved.prm").parameters.loads})
    std::cout << "rpm and kW: " << loads.driver_speed << " rad/s, " << loads.resisting_torque
              << " N m" << std::endl;
  for (const char *both : {"Loads/Driver speed in rad/s=50", "Loads/Resisting torque in N m=180"})
    try
      {
        model::read_parameters("other_forms.prm", {both});
        std::cout << "NOT REFUSED" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }

  std::ostringstream text;
  write_template(text);
  unsigned int n_to_be_set = 0;
  for (std::size_t at = text.str().find("TO BE SET"); at != std::string::npos;
       at             = text.str().find("TO BE SET", at + 1))
    ++n_to_be_set;
  std::cout << "entries to be set in the template: " << n_to_be_set << std::endl;

  unsigned int n_undocumented = 0, n_without_full_stop = 0;
  for (const Entry &entry : declarations.entries())
    {
      n_undocumented += entry.meaning.size() < 20 || entry.allowed.empty();
      n_without_full_stop += entry.meaning.back() != '.';
    }
  std::cout << "entries without documentation: " << n_undocumented
            << ", without a full stop: " << n_without_full_stop << std::endl;

  const std::string documentation = parameter_documentation();
  unsigned int      n_missing     = 0;
  for (const Entry &entry : declarations.entries())
    n_missing += documentation.find("| `" + entry.name + "` |") == std::string::npos;
  std::cout << "entries missing in the documentation: " << n_missing << std::endl;
}
