// SPDX-License-Identifier: LGPL-2.1-or-later
// What a user is told about a mesh file that cannot be used.

#include <chaindrive/files/file.h>
#include <chaindrive/mesh/import/import.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/utilities/errors.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

using namespace chaindrive;

namespace
{
std::string read(const std::string &file)
{
  std::ifstream     in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string &old, const std::string &by)
{
  const auto at = text.find(old);
  if (at == std::string::npos)
    throw std::logic_error("the good mesh has no '" + old + "'");
  return text.replace(at, old.size(), by);
}

void expect_error(const std::string &what, const std::function<void()> &action)
{
  std::cout << what << '\n';
  try
    {
      action();
      std::cout << "  accepted\n";
    }
  catch (const InputError &error)
    {
      std::cout << "  " << error.what() << '\n';
    }
}

/// Twelve corners of two cubes side by side, and @p elements made of them.
std::string cubes(const std::string &elements)
{
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
         "$PhysicalNames\n2\n2 1 \"tooth flanks\"\n2 2 \"hub\"\n$EndPhysicalNames\n"
         "$Nodes\n12\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n"
         "9 2 0 0\n10 2 1 0\n11 2 0 1\n12 2 1 1\n$EndNodes\n"
         "$Elements\n" +
         elements + "$EndElements\n";
}
} // namespace

int main()
{
  const auto            chain = drive::make_chain(parameters::Chain());
  parameters::Sprockets sprockets;
  sprockets.driver().outside_diameter = 81.8e-3;
  const auto        form              = drive::make_tooth_form(15, chain, sprockets, 0);
  const std::string good              = read(SOURCE_DIR "/../../meshes/sprocket-15.msh");

  const auto import = [](const std::string &text, const drive::ToothForm &teeth) {
    std::ofstream("mesh.msh") << text;
    mesh::import_sprocket("mesh.msh", teeth, 7600.);
  };
  const auto reject = [&](const std::string &what, const std::string &text) {
    expect_error(what, [&] { import(text, form); });
  };

  reject("good file", good);
  expect_error("missing", [] { files::find_file("none.msh", {"here", "there"}); });
  expect_error("missing, absolute", [] { files::find_file("/nowhere/none.msh", {"here"}); });
  expect_error("not there", [&] { mesh::import_sprocket("none.msh", form, 7600.); });
  reject("empty", "");
  reject("no mesh", "solid sprocket\n");
  reject("old format", replaced(good, "2.2 0 8", "2.1 0 8"));
  reject("binary", replaced(good, "2.2 0 8", "4.1 1 8"));
  reject("cut in the vertices", good.substr(0, good.size() / 2));
  reject("cut in the cells", good.substr(0, good.size() - 20000));
  reject("no flanks", replaced(good, "tooth flanks", "teeth"));
  reject("no faces of a surface",
         replaced(replaced(good, "2 1 \"tooth flanks\"", "2 9 \"tooth flanks\""),
                  "$Nodes",
                  "$Extra\n$EndExtra\n$Nodes"));
  reject("no names",
         replaced(replaced(replaced(good, "tooth flanks", ""), "hub", ""), "sides", ""));
  reject("tetrahedra", cubes("1\n1 4 2 0 0 1 2 3 5\n"));
  reject("surface only", cubes("1\n1 3 2 1 1 1 2 3 4\n"));

  const std::string side = "3 3 2 1 1 1 2 3 4\n", first = "1 5 2 0 0 1 2 3 4 5 6 7 8\n";
  reject("another body", cubes("3\n" + first + "2 5 2 0 0 2 9 10 3 6 11 12 7\n" + side));
  reject("one cell upside down", cubes("3\n" + first + "2 5 2 0 0 6 11 12 7 2 9 10 3\n" + side));
  reject("one cell tangled", cubes("3\n" + first + "2 5 2 0 0 2 9 10 3 12 6 11 7\n" + side));
  reject("one corner inside out",
         replaced(cubes("3\n" + first + "2 5 2 0 0 2 9 10 3 6 11 12 7\n" + side),
                  "12 2 1 1",
                  "12 1.1 0.1 0.6"));
  reject("no groups at all", cubes("1\n" + first));
  const std::string second = "2 5 2 0 0 2 9 10 3 6 11 12 7\n";
  reject("fewer vertices than counted", replaced(good, "3150\n", "3151\n"));
  reject("more vertices than counted", replaced(good, "3150\n", "3149\n"));
  reject("a vertex twice", replaced(good, "\n2 34.79", "\n1 34.79"));
  reject("a vertex that is no number", replaced(good, "\n2 34.79", "\n2 x34.79"));
  reject("a vertex far away", replaced(good, "\n2 34.79489104630051", "\n2 1e9"));
  reject("a number too large", replaced(good, "\n2 34.79", "\n99999999999999999999 34.79"));
  reject("a vertex that is not there", cubes("2\n1 5 2 0 0 1 2 3 4 5 6 7 13\n" + side));
  reject("more tags than words", cubes("2\n1 5 99 0 0 1 2 3 4 5 6 7 8\n" + side));
  reject("seven vertices", cubes("2\n1 5 2 0 0 1 2 3 4 5 6 7\n" + side));
  reject("a vertex twice in a cell", cubes("2\n1 5 2 0 0 1 1 3 4 5 6 7 8\n" + side));
  reject("a cell twice, which is one cell", cubes("3\n" + first + first + side));
  reject("three cells at a face",
         replaced(cubes("4\n" + first + second + "2 5 2 0 0 2 13 14 3 6 15 16 7\n" + side),
                  "$Nodes\n12\n",
                  "$Nodes\n16\n13 3 0 0\n14 3 1 0\n15 3 0 1\n16 3 1 1\n"));
  reject("a cell folded over its neighbour",
         replaced(cubes("3\n" + first + second + side),
                  "9 2 0 0\n10 2 1 0\n11 2 0 1\n12 2 1 1",
                  "9 0.5 0 0\n10 0.5 1 0\n11 0.5 0 1\n12 0.5 1 1"));
  reject("a surface between cells", cubes("3\n" + first + second + "3 3 2 1 1 2 3 7 6\n"));
  reject("a surface with two names", cubes("3\n" + first + side + "3 3 2 2 1 4 3 2 1\n"));
  reject("no end of the cells",
         replaced(cubes("2\n" + first + side), "$EndElements\n", "$EndElement\n"));

  expect_error("other number of teeth", [&] {
    import(good, drive::make_tooth_form(16, chain, parameters::Sprockets(), 0));
  });

  // every second face of the flanks without a name, or those of one side of the middle plane
  const auto unnamed = [&good](const std::function<bool(unsigned int)> &drop) {
    std::istringstream lines(good);
    std::string        text, line;
    unsigned int       n = 0;
    while (std::getline(lines, line))
      {
        int number = 0, type = 0, tags = 0, surface = 0;
        if (std::sscanf(line.c_str(), "%d %d %d %d", &number, &type, &tags, &surface) == 4 &&
            type == 3 && surface == 1 && drop(n++))
          line = line.substr(0, line.find(" 2 1 ")) + " 2 0 " + line.substr(line.find(" 2 1 ") + 5);
        text += line + '\n';
      }
    return text;
  };
  reject("half of the flanks", unnamed([](const unsigned int i) { return i % 2 == 0; }));
  reject("one gap of fifteen without flanks", unnamed([](const unsigned int i) { return i < 36; }));

  // as an elastic rim, and cut in half
  const auto rim = [&](const std::string &what, const std::string &text, const bool half) {
    expect_error(what, [&] {
      std::ofstream("mesh.msh") << text;
      const mesh::Sector sector(mesh::import_sprocket("mesh.msh", form, 7600., half));
      std::cout << "  " << sector.part->mesh->n_active_cells() << " elastic cells\n";
    });
  };
  rim("rim", good, false);
  rim("half of it", good, true);
  rim("rigid zone outside",
      replaced(replaced(replaced(good, "\"rim\"", "\"\""), "\"hub zone\"", "\"rim\""),
               "\"\"",
               "\"hub zone\""),
      false);
  rim("vertex off the middle plane",
      replaced(good, "-3.812927470559414 0\n", "-3.812927470559414 0.1\n"),
      true);
}
