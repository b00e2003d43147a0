// SPDX-License-Identifier: LGPL-2.1-or-later
// An addition to the scene of any drive is one file. These are two: a spring between the shafts of
// a drive, after it a load that grows with the time on one of them. Their entries are read, checked
// and written; without `Active` nothing is added, and what they say besides is told to have no
// effect.
#include "../support/decided.h"
#include "../support/scenes.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/forces/torsion_spring.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/scene/addition.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/errors.h>

using namespace test;

namespace
{
struct ShaftSpring
{
  struct Parameters
  {
    double      stiffness = 3.; ///< N m/rad
    std::string sprocket  = "driven";

    void declare(parameters::Declarations &declarations)
    {
      using namespace parameters;
      add(declarations, "Stiffness in kN m", stiffness, unit::kilo, above(0.), "Of the spring.");
      add_text(declarations, "Sprocket", sprocket, "a sprocket", "That the driver is tied to.");
    }
  };

  static void add_to(scene::Scene &scene, const Parameters &parameters)
  {
    const scene::Sprocket &sprocket =
        scene::find_sprocket(scene.drive, parameters.sprocket, "Additions/shaft spring/Sprocket");
    scene.forces.push_back(std::make_shared<const TorsionSpring>(
        sprocket.body, scene.drive.driver().body, parameters.stiffness));
  }
};
const scene::Addition<ShaftSpring>
    shaft_spring({"shaft spring", "Between two shafts.", {"growing load"}});

struct GrowingLoad
{
  struct Parameters
  {
    double slope = 0.; ///< N m/s

    void declare(parameters::Declarations &declarations)
    {
      using namespace parameters;
      add(declarations, "Slope in N m/s", slope, unit::si, at_least(0.), "How fast it grows.");
    }
  };

  static void add_to(scene::Scene &scene, const Parameters &parameters)
  {
    std::cout << "  forces when the load is added: " << scene.forces.size() << '\n';
    for (scene::Shaft &shaft : scene.shafts)
      if (shaft.body == scene.drive.driven().body)
        shaft.program.torque_added =
            std::make_shared<functions::Ramp>(parameters.slope, scene.start_time, 1.);
  }
};
const scene::Addition<GrowingLoad> growing_load({"growing load",
                                                 "A load that grows with the time."});

scene::Scene build(const Parameters &parameters) { return test::scene_of(parameters); }

void refuse(const std::string &what, const std::string &path, const std::string &value)
{
  try
    {
      build(model::read_entries({{"Additions/shaft spring/Active", "true"}, {path, value}})
                .parameters);
      std::cout << what << ": accepted\n";
    }
  catch (const InputError &error)
    {
      std::cout << what << ": " << error.what() << '\n';
    }
}
} // namespace

int main()
{
  const std::string spring = "Additions/shaft spring/", load = "Additions/growing load/";

  std::cout << "nothing is asked for\n";
  std::cout << "  forces " << build(Parameters()).forces.size() << '\n';

  std::cout << "entries without Active\n";
  const auto input = model::read_entries({{spring + "Stiffness in kN m", "2"}});
  for (const std::string &note : input.notes)
    if (note.find("Additions") != std::string::npos)
      std::cout << "  " << note << '\n';
  std::cout << "  forces " << build(input.parameters).forces.size() << '\n';

  std::cout << "both\n";
  const parameters::Input both  = model::read_entries({{spring + "Active", "true"},
                                                       {spring + "Stiffness in kN m", "2"},
                                                       {load + "Active", "true"},
                                                       {load + "Slope in N m/s", "7"}});
  Parameters              copy  = both.parameters; // has values of its own
  const scene::Scene      scene = build(copy);
  copy.sections.get<scene::AdditionSection<ShaftSpring::Parameters>>("Additions/shaft spring")
      .values.stiffness = 1.;
  verdict("copies of parameters have their own values",
          both.parameters.sections
                  .get<scene::AdditionSection<ShaftSpring::Parameters>>("Additions/shaft spring")
                  .values.stiffness == 2000.);
  dynamics::System    system(scene, false);
  std::vector<Spring> springs;
  system.forces[0]->add_springs(system.world, springs);
  std::cout << "  forces " << scene.forces.size() << ", stiffness " << springs.front().stiffness
            << " N m, second body that of the driver: "
            << (springs.front().second == scene.drive.driver().body ? "yes" : "no") << '\n';
  for (const scene::Shaft &shaft : scene.shafts)
    if (shaft.body == scene.drive.driven().body)
      std::cout << "  torque added after half a second "
                << shaft.program.torque_added->value(scene.start_time + 0.5) << " N m\n";

  std::cout << "what is written and must stay\n";
  for (const std::string &text : {both.resolved, both.fixed})
    for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
      if (const std::string line = text.substr(at, end - at);
          line.find("shaft spring") != std::string::npos ||
          line.find("Stiffness in kN m") != std::string::npos)
        std::cout << "  " << line << '\n';

  refuse("negative", spring + "Stiffness in kN m", "-1");
  refuse("no sprocket", spring + "Sprocket", "third");
}
