// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import/gmsh_file.h>
#include <chaindrive/mesh/import/gmsh_numbers.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <utility>

namespace chaindrive::mesh
{
namespace
{
// of dimension and entity
using Groups = std::map<std::pair<long, long>, std::shared_ptr<std::vector<long>>>;

void read_names(GmshNumbers &in, GmshFile &mesh)
{
  for (long n = in.count(); n > 0; --n)
    {
      in.next_line();
      const auto        first = in.line.find('"'), last = in.line.rfind('"');
      long              dimension = 0, group = 0;
      const char *const end    = in.line.data() + in.line.size();
      const auto        result = std::from_chars(in.line.data(), end, dimension);
      if (result.ptr == end || std::from_chars(result.ptr + 1, end, group).ec != std::errc() ||
          first == std::string::npos || first == last)
        in.fail("dimension, number and \"name\" of a physical group");
      const std::string name = in.line.substr(first + 1, last - first - 1);
      if (!name.empty() && dimension > 1)
        (dimension == 2 ? mesh.surfaces : mesh.volumes)[name].push_back(group);
    }
}

/// Entities of version 4, or the parts of them that a partitioned mesh has in their place.
void read_entities(GmshNumbers &in, const bool partitioned, Groups &groups)
{
  if (partitioned)
    {
      in.record("number of partitions");
      in.size();
      in.record("number of ghost entities");
      for (long n = in.size(); n > 0; --n)
        {
          in.record("a ghost entity");
          in.integer();
          in.integer();
        }
    }
  std::array<long, 4> counts{};
  in.record("four numbers of entities");
  for (long &n : counts)
    n = in.size();
  for (long dimension = 0; dimension < 4; ++dimension)
    for (long n = counts[dimension]; n > 0; --n)
      {
        in.record("an entity with its physical groups");
        auto &found = groups[{dimension, in.integer()}];
        if (found == nullptr)
          found = std::make_shared<std::vector<long>>();
        if (partitioned)
          {
            in.integer(); // dimension and number of what it is a part of
            in.integer();
            for (long m = in.size(); m > 0; --m)
              in.integer(); // partition
          }
        for (unsigned int i = 0; i < (dimension == 0 ? 3 : 6); ++i)
          in.real(); // the point, or the two ends of a box
        for (long m = in.size(); m > 0; --m)
          found->push_back(std::abs(in.integer())); // negative: turned round
        if (dimension > 0 && in.binary())
          for (long m = in.size(); m > 0; --m)
            in.integer(); // on its boundary
      }
}

void add_node(const GmshNumbers           &in,
              GmshFile                    &mesh,
              const long                   number,
              const std::array<double, 3> &x)
{
  if (!mesh.nodes.emplace(number, dealii::Point<3>(x[0], x[1], x[2])).second)
    in.fail("another number than that of node " + std::to_string(number) +
            ", which was there before,");
}

std::array<double, 3> coordinates(GmshNumbers &in)
{
  std::array<double, 3> x{};
  for (double &value : x)
    value = in.real();
  return x;
}

/// @p parametric nodes say where they lie on a curve (dimension 1) or surface (2).
void read_nodes_2(GmshNumbers &in, const bool parametric, GmshFile &mesh)
{
  for (long n = in.count(); n > 0; --n)
    {
      in.record("number and coordinates of a node");
      const long                  number = in.integer();
      const std::array<double, 3> x      = coordinates(in);
      if (parametric && in.binary())
        {
          const long dimension = in.integer();
          in.integer(); // entity
          for (long i = 0; i < dimension && dimension < 3; ++i)
            in.real();
        }
      add_node(in, mesh, number, x);
    }
}

void read_nodes_4(GmshNumbers &in, GmshFile &mesh)
{
  in.record("number of blocks of nodes");
  long blocks = in.size();
  for (unsigned int i = 0; i < 3; ++i)
    in.size();
  for (; blocks > 0; --blocks)
    {
      in.record("a block of nodes");
      const long dimension = in.integer();
      in.integer(); // entity
      const long        n_parameters = in.integer() == 0 ? 0 : dimension;
      std::vector<long> nodes;
      for (long n = in.size(); n > 0; --n)
        {
          if (!in.binary() || nodes.empty())
            in.record("number of a node");
          nodes.push_back(in.size());
        }
      for (const long node : nodes)
        {
          in.record("coordinates of a node");
          const std::array<double, 3> x = coordinates(in);
          for (long i = 0; i < n_parameters && in.binary(); ++i)
            in.real();
          add_node(in, mesh, node, x);
        }
    }
}

/// How many nodes an element of Gmsh's @p type has, of all that the manual lists.
long n_nodes(const GmshNumbers &in, const long type)
{
  static const std::map<long, long> known = {
      {1, 2},   {2, 3},   {3, 4},   {4, 4},   {5, 8},   {6, 6},   {7, 5},   {8, 3},   {9, 6},
      {10, 9},  {11, 10}, {12, 27}, {13, 18}, {14, 14}, {15, 1},  {16, 8},  {17, 20}, {18, 15},
      {19, 13}, {20, 9},  {21, 10}, {22, 12}, {23, 15}, {24, 15}, {25, 21}, {26, 4},  {27, 5},
      {28, 6},  {29, 20}, {30, 35}, {31, 56}, {92, 64}, {93, 125}};
  const auto found = known.find(type);
  if (found == known.end())
    in.fail("elements of a type of the manual's list instead of type " + std::to_string(type));
  return found->second;
}

/// The rest of the record of an element.
std::vector<long> read_nodes_of(GmshNumbers &in, const long type, const bool sizes)
{
  std::vector<long> nodes(in.binary() ? n_nodes(in, type) : in.left());
  for (long &node : nodes)
    node = sizes ? in.size() : in.integer();
  return nodes;
}

/// In binary, a head with the type stands before elements of the same type.
void read_elements_2(GmshNumbers &in, GmshFile &mesh)
{
  const std::string                what = "number, type, tags and nodes of an element";
  const GmshFile::Groups           none = std::make_shared<const std::vector<long>>();
  std::map<long, GmshFile::Groups> known; // by their number
  for (long n = in.count(); n > 0;)
    {
      GmshFile::Element element;
      long              n_tags = 0, n_same = 1;
      in.record(what);
      if (in.binary())
        {
          element.type = in.integer();
          n_same       = in.integer();
        }
      else
        {
          in.integer();
          element.type = in.integer();
        }
      n_tags = in.integer();
      if (n_tags < 0 || n_same < 1 || n_same > n)
        in.fail(what);
      n -= n_same;
      for (; n_same > 0; --n_same)
        {
          if (in.binary())
            in.integer();
          element.groups = none;
          for (long i = 0; i < n_tags; ++i) // group, entity, partitions
            if (const long tag = std::abs(in.integer()); i == 0)
              {
                element.groups = known[tag];
                if (element.groups == nullptr)
                  element.groups = known[tag] = std::make_shared<const std::vector<long>>(1, tag);
              }
          element.nodes = read_nodes_of(in, element.type, false);
          mesh.elements.push_back(element);
        }
    }
}

void read_elements_4(GmshNumbers &in, const Groups &groups, GmshFile &mesh)
{
  const GmshFile::Groups none = std::make_shared<const std::vector<long>>();
  in.record("number of blocks of elements");
  long blocks = in.size();
  for (unsigned int i = 0; i < 3; ++i)
    in.size();
  for (; blocks > 0; --blocks)
    {
      in.record("a block of elements");
      const long        dimension = in.integer();
      const auto        found     = groups.find({dimension, in.integer()});
      GmshFile::Element element;
      element.type   = in.integer();
      element.groups = none;
      if (found != groups.end())
        element.groups = found->second;
      for (long n = in.size(); n > 0; --n)
        {
          in.record("number and nodes of an element");
          in.size();
          element.nodes = read_nodes_of(in, element.type, true);
          mesh.elements.push_back(element);
        }
    }
}

/// Reads over the rest of @p section.
void skip(GmshNumbers &in, const std::string &section)
{
  const std::string end = "$End" + section.substr(1);
  while (in.line != end && !(in.binary() && in.line.size() > end.size() &&
                             in.line.compare(in.line.size() - end.size(), end.size(), end) == 0))
    if (!in.next_line())
      in.fail("'" + end + "'");
}

/// The version of the file, whose numbers may be binary from here on.
double read_format(GmshNumbers &in, const std::string &file)
{
  in.next_line();
  if (in.line == "$NOD")
    throw InputError(
        "'" + file +
        "' is a Gmsh file of version 1; 2.2 and 4.1 can be read (gmsh -format msh41).");
  if (in.line.compare(0, 11, "$MeshFormat") != 0)
    throw InputError("'" + file +
                     "' is not a mesh file of Gmsh: it does not begin with $MeshFormat.");
  const std::vector<double> &format  = in.text(2, "version and kind of the file");
  const double               version = format[0], kind = format[1];
  if (!(version == 2.2 || version == 4.1))
    throw InputError("'" + file + "' is a Gmsh file of version " + to_text(version) +
                     "; 2.2 and 4.1 can be read (gmsh -format msh41).");
  if (kind != 0. && (format.size() < 3 || format[2] != 8.))
    throw InputError("'" + file +
                     "' is a binary Gmsh file whose numbers do not have 8 bytes; only "
                     "those of 64-bit computers, or in ASCII, can be read.");
  if (kind != 0.)
    in.start_binary();
  in.expect("$EndMeshFormat");
  return version;
}
} // namespace

std::string GmshFile::not_read() const
{
  std::string text;
  for (const std::string &section : unknown)
    text += (text.empty() ? ". It also has sections that are not known: " : ", ") + section;
  return text;
}

GmshFile read_gmsh(const std::string &file)
{
  // of Gmsh's manual, but nothing that a mesh needs
  static const std::vector<std::string> others = {"$Comments",
                                                  "$Periodic",
                                                  "$GhostElements",
                                                  "$Parametrizations",
                                                  "$NodeData",
                                                  "$ElementData",
                                                  "$ElementNodeData",
                                                  "$InterpolationScheme"};
  GmshNumbers                           in(file);
  const double                          version = read_format(in, file);
  GmshFile                              mesh;
  Groups                                groups;
  while (in.next_line())
    {
      if (in.line.empty())
        continue;
      const std::string section = in.line;
      if (section[0] != '$' || section.compare(0, 4, "$End") == 0)
        in.fail("the beginning of a section");
      if (section == "$PhysicalNames")
        read_names(in, mesh);
      else if (version > 4. && (section == "$Entities" || section == "$PartitionedEntities"))
        read_entities(in, section != "$Entities", groups);
      else if (section == "$Nodes" || (version < 4. && section == "$ParametricNodes"))
        version < 4. ? read_nodes_2(in, section != "$Nodes", mesh) : read_nodes_4(in, mesh);
      else if (section == "$Elements")
        version < 4. ? read_elements_2(in, mesh) : read_elements_4(in, groups, mesh);
      else
        {
          if (std::find(others.begin(), others.end(), section) == others.end())
            mesh.unknown.push_back(section);
          skip(in, section);
          continue;
        }
      in.expect("$End" + section.substr(1));
    }
  return mesh;
}
} // namespace chaindrive::mesh
