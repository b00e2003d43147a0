// SPDX-License-Identifier: LGPL-2.1-or-later
// Two cubes in both versions of Gmsh's format: the same nodes, elements, groups and names, though
// one counts in blocks, has sections in between and lines that end in the manner of Windows.

#include <chaindrive/mesh/import/gmsh_cells.h>
#include <chaindrive/mesh/import/gmsh_file.h>

#include <deal.II/grid/grid_tools.h>

#include <fstream>
#include <iostream>

using namespace chaindrive;

namespace
{
const std::string version_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n4\n2 1 \"tooth flanks\"\n2 7 \"hub\"\n3 4 \"rim\"\n3 5 \"hub zone\"\n"
    "$EndPhysicalNames\n"
    "$Nodes\n12\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n"
    "90 2 0 0\n91 2 1 0\n92 2 0 1\n93 2 1 1\n$EndNodes\n"
    "$Elements\n4\n1 3 2 1 1 1 4 8 5\n2 3 2 7 1 90 91 93 92\n3 5 2 4 8 1 2 3 4 5 6 7 8\n"
    "4 5 2 5 9 2 90 91 3 6 92 93 7\n$EndElements\n";

const std::string version_4 =
    "$MeshFormat\r\n4.1 0 8\r\n$EndMeshFormat\r\n"
    "$PhysicalNames\n4\n2 1 \"tooth flanks\"\n2 7 \"hub\"\n3 4 \"rim\"\n3 5 \"hub zone\"\n"
    "$EndPhysicalNames\n\n"
    "$Entities\n1 1 2 2\n5 0 0 0 0\n6 0 0 0 1 0 0 0 2 5 -5\n"
    "1 0 0 0 0 1 1 1 1 1 6\n2 2 0 0 2 1 1 1 7 0\n"
    "8 0 0 0 1 1 1 1 4 1 1\n9 1 0 0 2 1 1 1 5 1 2\n$EndEntities\n"
    "$Periodic\n1\n0 1 1\n$EndPeriodic\n"
    "$Nodes\n2 12 1 93\n3 8 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "3 9 0 4\n90\n91\n92\n93\n2 0 0\n2 1 0\n2 0 1\n2 1 1\n$EndNodes\n"
    "$Elements\n4 4 1 4\n2 1 3 1\n1 1 4 8 5\n2 2 3 1\n2 90 91 93 92\n"
    "3 8 5 1\n3 1 2 3 4 5 6 7 8\n3 9 5 1\n4 2 90 91 3 6 92 93 7\n$EndElements\n";

mesh::GmshFile read(const std::string &text)
{
  std::ofstream("cubes.msh") << text;
  return mesh::read_gmsh("cubes.msh");
}
} // namespace

int main()
{
  const mesh::GmshFile two = read(version_2), four = read(version_4);
  const auto           say = [](const char *what, const bool same) {
    std::cout << what << ": " << (same ? "the same" : "different") << '\n';
  };
  say("nodes", two.nodes == four.nodes && two.nodes.size() == 12);
  say("names", two.surfaces == four.surfaces && two.volumes == four.volumes);
  bool same = two.elements.size() == 4 && four.elements.size() == 4;
  for (unsigned int i = 0; same && i < 4; ++i)
    same = two.elements[i].type == four.elements[i].type &&
           *two.elements[i].groups == *four.elements[i].groups &&
           two.elements[i].nodes == four.elements[i].nodes;
  say("elements", same);

  const auto cubes = mesh::make_triangulation("cubes.msh",
                                              four,
                                              {{1, mesh::tooth_flanks}, {7, mesh::hub}},
                                              {four.volumes.at("hub zone").at(0)});
  std::cout << "volume over that of two cubes of 1 mm: " << dealii::GridTools::volume(*cubes) / 2e-9
            << '\n';
  for (const auto &cell : cubes->active_cell_iterators())
    {
      std::cout << mesh::component_name(cell->material_id())
                << " at x = " << 1e3 * cell->center()[0] << " mm\n";
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() != mesh::other_surface)
          std::cout << "  " << mesh::surface_name(face->boundary_id())
                    << " at x = " << 1e3 * face->center()[0] << " mm\n";
    }
}
