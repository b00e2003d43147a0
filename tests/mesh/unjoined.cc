// SPDX-License-Identifier: LGPL-2.1-or-later
// A sprocket must be one body: sectors with vertices of their own where they meet, sectors with
// other vertices there, and slits would deflect too much. Left-handed and mirrored meshes are what
// they were, and so is one whose elements come in another order.

#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/mesh/import/gmsh_file.h>
#include <chaindrive/mesh/import/import.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>

using namespace chaindrive;
using mesh::GmshFile;

namespace
{
constexpr unsigned int teeth = 15;

const char *const names = "$PhysicalNames\n5\n2 1 \"tooth flanks\"\n2 2 \"hub\"\n2 3 \"sides\"\n"
                          "3 4 \"rim\"\n3 5 \"hub zone\"\n$EndPhysicalNames\n";

void write(const GmshFile &gmsh)
{
  std::ofstream out("mesh.msh");
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      << names << "$Nodes\n"
      << gmsh.nodes.size() << '\n';
  for (const auto &[number, x] : gmsh.nodes)
    out << number << ' ' << x << '\n';
  out << "$EndNodes\n$Elements\n" << gmsh.elements.size() << '\n';
  for (const GmshFile::Element &element : gmsh.elements)
    {
      out << "1 " << element.type << " 2 " << element.groups->at(0) << " 1";
      for (const long node : element.nodes)
        out << ' ' << node;
      out << '\n';
    }
  out << "$EndElements\n";
}

dealii::Point<3> centre(const GmshFile &gmsh, const GmshFile::Element &element)
{
  dealii::Point<3> sum;
  for (const long node : element.nodes)
    sum += gmsh.nodes.at(node) / static_cast<double>(element.nodes.size());
  return sum;
}

unsigned int sector(const dealii::Point<3> &x)
{
  const double turned = std::atan2(x[1], x[0]) / (2. * dealii::numbers::PI / teeth);
  return static_cast<unsigned int>(std::lround(turned + teeth)) % teeth;
}

/// Whether a cell with the centre @p cell gets a node of its own at @p node.
using Chosen = std::function<bool(const dealii::Point<3> &cell, const dealii::Point<3> &node)>;

/// Every sector with nodes of its own where @p chosen says so; in places of their own if @p away is
/// not zero: along the axis, where the flanks allow it.
GmshFile split(GmshFile gmsh, const Chosen &chosen, const double away = 0.)
{
  const std::map<long, dealii::Point<3>> nodes = gmsh.nodes;
  for (GmshFile::Element &element : gmsh.elements)
    {
      const dealii::Point<3> x = centre(gmsh, element);
      for (long &node : element.nodes)
        if (dealii::Point<3> y = nodes.at(node); chosen(x, y))
          {
            const double k = away * (sector(x) % 3); // not that of the next sectors
            y[2]           = (1. - k) * y[2] + 2. * k;
            node += 10000 * (1 + static_cast<long>(sector(x)));
            gmsh.nodes[node] = y;
          }
    }
  std::set<long> used;
  for (const GmshFile::Element &element : gmsh.elements)
    used.insert(element.nodes.begin(), element.nodes.end());
  for (auto node = gmsh.nodes.begin(); node != gmsh.nodes.end();)
    node = used.count(node->first) > 0 ? std::next(node) : gmsh.nodes.erase(node);
  return gmsh;
}
} // namespace

int main()
{
  const auto            chain = drive::make_chain(parameters::Chain());
  parameters::Sprockets sprockets;
  sprockets.driver().outside_diameter = 81.8e-3;
  const auto       form               = drive::make_tooth_form(teeth, chain, sprockets, 0);
  const GmshFile   good               = mesh::read_gmsh(SOURCE_DIR "/../../meshes/sprocket-15.msh");
  const mesh::Part part =
      mesh::import_sprocket(SOURCE_DIR "/../../meshes/sprocket-15.msh", form, 7600.);

  const auto say = [&](const std::string &what, const GmshFile &gmsh) {
    std::cout << what << "\n  ";
    try
      {
        write(gmsh);
        const mesh::Part other = mesh::import_sprocket("mesh.msh", form, 7600.);
        std::cout << other.mesh->n_active_cells() << " cells, " << other.mesh->n_used_vertices()
                  << " vertices; mass and inertia over those of the good mesh: "
                  << other.meshed.mass / part.meshed.mass << ", "
                  << other.meshed.inertia[2][2] / part.meshed.inertia[2][2] << '\n';
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << '\n';
      }
  };
  const Chosen everywhere = [](const auto &, const auto &) { return true; };

  say("good", good);
  say("sectors with vertices of their own", split(good, everywhere));
  // as Gmsh writes them without coherence: faces of one sector, flanks too, have nodes of others
  GmshFile mixed = split(good, everywhere);
  for (GmshFile::Element &element : mixed.elements)
    if (element.type == 3)
      for (long &node : element.nodes)
        if (const long other = node % 10000 + 10000 * (node / 10000 % teeth + 1);
            mixed.nodes.count(other) > 0)
          node = other;
  say("and surfaces that have those of the next sector", mixed);
  say("and these a fraction of a micrometre apart", split(good, everywhere, 1e-4));
  say("sectors with other vertices", split(good, everywhere, 0.05));
  const Chosen slit = [](const dealii::Point<3> &cell, const dealii::Point<3> &node) {
    const double turned = std::atan2(node[1], node[0]) / (2. * dealii::numbers::PI / teeth);
    return sector(cell) == 4 && turned > 4.49 && std::hypot(node[0], node[1]) < 25.;
  };
  say("a slit in one place", split(good, slit));
  say("a slit with other vertices on its two sides", split(good, slit, 0.05));

  const auto without_name = [&good](const long group, const unsigned int n) {
    GmshFile     gmsh = good;
    unsigned int left = n;
    for (GmshFile::Element &element : gmsh.elements)
      if (left > 0 && element.type == 3 && element.groups->at(0) == group)
        {
          element.groups = std::make_shared<const std::vector<long>>(1, 0L);
          --left;
        }
    return gmsh;
  };
  say("five faces of the hub without a name", without_name(2, 5));
  say("no sides", without_name(3, 100000));

  // the teeth and the hub zone are left
  GmshFile   ring = good;
  const auto away = [&good](const GmshFile::Element &element) {
    const dealii::Point<3> x = centre(good, element);
    return std::hypot(x[0], x[1]) > 17. && std::hypot(x[0], x[1]) < 26.;
  };
  ring.elements.erase(std::remove_if(ring.elements.begin(), ring.elements.end(), away),
                      ring.elements.end());
  say("a ring is away", ring);

  GmshFile handed = good;
  for (GmshFile::Element &element : handed.elements)
    if (element.type == 5)
      std::rotate(element.nodes.begin(), element.nodes.begin() + 4, element.nodes.end());
  say("left-handed", handed);
  GmshFile mirrored = good;
  for (auto &node : mirrored.nodes)
    node.second[1] *= -1.;
  say("mirrored", mirrored);
  GmshFile reversed = good;
  std::reverse(reversed.elements.begin(), reversed.elements.end());
  say("in another order", reversed);
}
