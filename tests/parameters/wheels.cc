// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels that a parameter file names: their entries come with the entry that lists them, in files,
// overrides and entries at hand; what is read is written and read again as the same; what is wrong
// is refused with the entry, the value and what is allowed.
#include <chaindrive/parameters/reader.h>
#include <chaindrive/utilities/errors.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive;

namespace
{
const std::string wheels = "subsection Drive\n"
                           "  subsection Wheels\n"
                           "    set Order of travel = driver, idler, driven, pump\n"
                           "    subsection idler\n"
                           "      set Teeth = 11\n"
                           "      set Side = outside\n"
                           "      set Centre in mm = 300, -92\n"
                           "      set Held by = arm\n"
                           "      subsection Arm\n"
                           "        set Pivot in mm = 200, -100\n"
                           "        set Moment in N m = 5\n"
                           "        set Least angle in degrees = -9\n"
                           "      end\n"
                           "    end\n"
                           "    subsection pump\n"
                           "      set Role = driven\n"
                           "      set Centre in mm = 200, 150\n"
                           "      set Inertia in kg m2 = 0.002\n"
                           "      subsection Guide\n"
                           "        set Points in mm = 40, 60; 100, 62.5; 150, 60\n"
                           "      end\n"
                           "    end\n"
                           "  end\n"
                           "  subsection Sprockets\n"
                           "    set Idler outside diameter in mm = 60\n"
                           "  end\n"
                           "end\n"
                           "subsection Loads\n"
                           "  subsection pump\n"
                           "    set Resisting torque in N m = 12\n"
                           "  end\n"
                           "end\n";

parameters::Input read(const std::string &text, const std::vector<std::string> &overrides = {})
{
  std::ofstream("wheels.prm") << text;
  return parameters::read_parameters("wheels.prm", overrides);
}

void print(const Parameters &p)
{
  for (const parameters::Sprocket &sprocket : p.drive.sprockets.list)
    {
      std::cout << "  " << sprocket.name << ": " << text_of(sprocket.role) << ", " << sprocket.teeth
                << " teeth, turn " << sprocket.turn;
      if (sprocket.centre)
        std::cout << ", at " << (*sprocket.centre)[0] << ' ' << (*sprocket.centre)[1];
      if (sprocket.inertia)
        std::cout << ", " << *sprocket.inertia << " kg m2";
      if (sprocket.resisting_torque)
        std::cout << ", " << *sprocket.resisting_torque << " N m";
      if (sprocket.outside_diameter)
        std::cout << ", outside " << *sprocket.outside_diameter;
      if (sprocket.held.holder != parameters::Holder::bearing)
        {
          const parameters::Tensioner &held = sprocket.held.tensioner();
          std::cout << ", on an " << text_of(sprocket.held.holder) << " about "
                    << (*sprocket.held.pivot)[0] << ' ' << (*sprocket.held.pivot)[1] << " with "
                    << held.preload << " N m from " << *held.least << " rad on, end "
                    << held.most.has_value();
        }
      if (!sprocket.guide.points.empty())
        {
          std::cout << ", guide";
          for (const auto &point : sprocket.guide.points)
            std::cout << " (" << point[0] << ' ' << point[1] << ')';
        }
      std::cout << '\n';
    }
}

void refuse(const std::string &text, const std::vector<std::string> &overrides = {})
{
  try
    {
      read(text, overrides);
      std::cout << "ACCEPTED\n";
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}

std::string order(const std::string &names)
{
  return "subsection Drive\n subsection Wheels\n  set Order of travel = " + names + "\n end\nend\n";
}

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}
} // namespace

int main()
{
  std::cout << "two\n";
  print(read(order("driver, driven")).parameters);
  const parameters::Input all = read(wheels);
  std::cout << "four\n";
  print(all.parameters);
  const parameters::Input again = read(all.resolved);
  verdict("what is written is read as the same",
          again.resolved == all.resolved && again.fixed == all.fixed);
  verdict("a value before the list of wheels is kept",
          read("subsection Drive\n set Driver teeth = 23\nend\n" + wheels)
                  .parameters.drive.sprockets.driver()
                  .teeth == 23);
  std::cout << "an override\n";
  print(read(wheels, {"Drive/Wheels/idler/Teeth=13"}).parameters);
  std::cout << "the list as an override\n";
  print(read(order("driver, driven"),
             {"Drive/Wheels/Order of travel=driver, driven, other", "Drive/Wheels/other/Teeth=9"})
            .parameters);
  std::cout << "entries at hand\n";
  print(parameters::read_entries({{"Drive/Sprockets/Idler outside diameter in mm", "60"},
                                  {"Drive/Wheels/idler/Centre in mm", "-1.5,2"},
                                  {"Drive/Wheels/Order of travel", "driver, driven, idler"}})
            .parameters);

  std::cout << "refused\n";
  for (const char *names : {"driven, driver",
                            "driver",
                            "",
                            "driver, idler",
                            "driver, driven, driven",
                            "driver, driven, links",
                            "driver, a_to_b, driven",
                            "driver, driven, Idler",
                            "driver, driven, 2nd",
                            "driver, driven, a b",
                            "driver, driven, a/b",
                            "driver; driven",
                            "driver,,driven"})
    refuse(order(names));
  refuse(wheels, {"Drive/Wheels/Order of travel=driver, driven, pump"});
  refuse("subsection Drive\n subsection Wheels\n  subsection idler\n   set Teeth = 11\n  end\n "
         "end\nend\n");
  for (const char *entry : {"Centre in mm=300",
                            "Centre in mm=300, -92, 1",
                            "Centre in mm=300; -92",
                            "Centre in mm=300, nan",
                            "Centre in mm=1e9, 0",
                            "Held by=nothing",
                            "Arm/Pivot in mm=1",
                            "Guide/Points in mm=1, 2",
                            "Guide/Points in mm=1, 2; 3",
                            "Guide/Points in mm=1, 2; 3, x",
                            "Guide/Line=polygon",
                            "Role=driver",
                            "Side=left",
                            "Teeth=8",
                            "Inertia in kg m2=0",
                            "Direction in degrees=200"})
    refuse(wheels, {std::string("Drive/Wheels/idler/") + entry});
  refuse(wheels, {"Drive/Wheels/driver/Side=outside", "Drive/Wheels/other/Teeth=9"});
  refuse(wheels, {"Drive/Wheels/driven/Teeth=30", "Drive/Wheels/driven/Inertia in kg m2=1"});
}
