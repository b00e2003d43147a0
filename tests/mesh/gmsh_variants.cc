// SPDX-License-Identifier: LGPL-2.1-or-later
// All ways in which Gmsh writes the same two cubes: version 2.2 and 4.1; ASCII, binary and binary
// of a computer with the other order of bytes; every element once for each of its groups, or in an
// entity with several; groups turned round; partitions with ghosts; nodes with parameters; sections
// that say nothing of the mesh. The same triangulation comes of each.

#include <chaindrive/mesh/import/gmsh_cells.h>
#include <chaindrive/mesh/import/gmsh_file.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <sstream>

using namespace chaindrive;

namespace
{
enum class Kind
{
  ascii,
  binary,
  foreign
};

struct Variant
{
  int  version = 2;
  Kind kind    = Kind::ascii;
  bool groups = false, partitions = false, parameters = false, other_sections = false;
};

/// Numbers as text or bytes.
class Writer
{
public:
  explicit Writer(const Kind kind) : kind_(kind) {}

  void text(const std::string &line) { out << line << '\n'; }
  void i(const std::int32_t value) { put(value); }
  void s(const std::uint64_t value) { put(value); }
  void d(const double value) { put(value); }
  void integers(const std::vector<int> &values)
  {
    for (const int value : values)
      i(value);
  }
  void sizes(const std::vector<int> &values)
  {
    for (const int value : values)
      s(value);
  }
  void reals(const std::vector<double> &values)
  {
    for (const double value : values)
      d(value);
  }
  void end_line()
  {
    if (kind_ == Kind::ascii)
      out << '\n';
  }
  void end(const std::string &section)
  {
    if (kind_ != Kind::ascii)
      out << '\n';
    text("$End" + section);
  }

  std::ostringstream out;

private:
  template <typename T>
  void put(T value)
  {
    if (kind_ == Kind::ascii)
      {
        out << value << ' ';
        return;
      }
    char *const bytes = reinterpret_cast<char *>(&value);
    if (kind_ == Kind::foreign)
      std::reverse(bytes, bytes + sizeof(T));
    out.write(bytes, sizeof(T));
  }

  Kind kind_;
};

struct Element
{
  int              type, entity; // the entity has the dimension of the element
  std::vector<int> groups, nodes;
};

// Sheets 1 (flanks, in the second case also group 3) and 2 (hub), blocks 8 (rim, also group 6) and
// 9 (hub zone).
std::vector<Element> elements(const bool groups)
{
  std::vector<Element> all = {{3, 1, {1}, {1, 4, 8, 5}},
                              {3, 2, {7}, {90, 91, 93, 92}},
                              {5, 8, {4}, {1, 2, 3, 4, 5, 6, 7, 8}},
                              {5, 9, {5}, {2, 90, 91, 3, 6, 92, 93, 7}}};
  if (groups)
    {
      all[0].groups = {3, 1};
      all[2].groups = {4, 6};
      all[3].groups = {6, 5};
    }
  return all;
}

const std::vector<std::pair<int, std::vector<double>>> nodes = {{1, {0, 0, 0}},
                                                                {2, {1, 0, 0}},
                                                                {3, {1, 1, 0}},
                                                                {4, {0, 1, 0}},
                                                                {5, {0, 0, 1}},
                                                                {6, {1, 0, 1}},
                                                                {7, {1, 1, 1}},
                                                                {8, {0, 1, 1}},
                                                                {90, {2, 0, 0}},
                                                                {91, {2, 1, 0}},
                                                                {92, {2, 0, 1}},
                                                                {93, {2, 1, 1}}};

void write_2(Writer &out, const Variant &variant)
{
  const std::string section = variant.parameters ? "ParametricNodes" : "Nodes";
  out.text("$" + section);
  out.text(std::to_string(nodes.size()));
  for (const auto &[number, x] : nodes)
    {
      const int dimension = number % 4; // of where it lies
      out.i(number);
      out.reals(x);
      if (variant.parameters)
        {
          out.integers({dimension, 1});
          out.reals(std::vector<double>(dimension < 3 ? dimension : 0, 0.25));
        }
      out.end_line();
    }
  out.end(section);

  out.text("$Elements");
  std::vector<Element> listed; // once for each group
  for (const Element &element : elements(variant.groups))
    for (const int group : element.groups)
      listed.push_back({element.type, element.entity, {group}, element.nodes});
  if (variant.groups) // a group that is turned round has the other order of nodes
    std::rotate(
        listed.back().nodes.begin(), listed.back().nodes.begin() + 4, listed.back().nodes.end());
  out.text(std::to_string(listed.size()));
  int number = 0;
  for (const Element &element : listed)
    {
      std::vector<int> tags = {element.groups[0], element.entity};
      if (variant.partitions)
        tags.insert(tags.end(), {2, 1, -2}); // in partition 1, ghost of 2
      if (variant.kind == Kind::ascii)
        out.integers({++number, element.type, static_cast<int>(tags.size())});
      else
        out.integers({element.type, 1, static_cast<int>(tags.size()), ++number});
      out.integers(tags);
      out.integers(element.nodes);
      out.end_line();
    }
  out.end("Elements");
}

/// Entities; those of partitions have a parent and partitions.
void write_entities(Writer &out, const Variant &variant, const bool partitioned)
{
  const std::string section = partitioned ? "PartitionedEntities" : "Entities";
  out.text("$" + section);
  if (partitioned)
    {
      for (const auto &values : {std::vector<int>{2}, {1}}) // partitions, ghost entities
        {
          out.sizes(values);
          out.end_line();
        }
      out.integers({500, 1});
      out.end_line();
    }
  out.sizes({1, 1, 2, 2});
  out.end_line();
  const auto entity = [&](const int dimension, const int tag, const std::vector<int> &groups) {
    out.i(partitioned ? 100 + tag : tag);
    if (partitioned)
      {
        out.integers({dimension, tag});
        out.s(2);
        out.integers({1, 2});
      }
    out.reals(std::vector<double>(dimension == 0 ? 3 : 6, 0.5));
    out.s(groups.size());
    out.integers(groups);
    if (dimension > 0)
      {
        out.s(2);
        out.integers({1, -2});
      }
    out.end_line();
  };
  entity(0, 1, {});
  entity(1, 1, {});
  for (const Element &element : elements(variant.groups))
    {
      // the entity that has parts says nothing of groups
      std::vector<int> groups =
          partitioned || !variant.partitions ? element.groups : std::vector<int>();
      if (variant.groups)
        for (int &group : groups)
          group = -group;
      entity(element.type == 3 ? 2 : 3, element.entity, groups);
    }
  out.end(section);
}

void write_4(Writer &out, const Variant &variant)
{
  write_entities(out, variant, false);
  if (variant.partitions)
    write_entities(out, variant, true);
  const int first = variant.partitions ? 100 : 0;

  out.text("$Nodes");
  out.sizes({2, static_cast<int>(nodes.size()), 1, 93});
  out.end_line();
  for (const int dimension : {2, 3})
    {
      const unsigned int begin = dimension == 2 ? 0 : 8, end = dimension == 2 ? 8 : nodes.size();
      const bool         parameters = variant.parameters && dimension == 2;
      out.integers({dimension, first + dimension, parameters});
      out.s(end - begin);
      out.end_line();
      for (unsigned int k = begin; k < end; ++k)
        {
          out.s(nodes[k].first);
          out.end_line();
        }
      for (unsigned int k = begin; k < end; ++k)
        {
          out.reals(nodes[k].second);
          if (parameters)
            out.reals({0.25, 0.5});
          out.end_line();
        }
    }
  out.end("Nodes");

  out.text("$Elements");
  out.sizes({4, 4, 1, 4});
  out.end_line();
  int number = 0;
  for (const Element &element : elements(variant.groups))
    {
      out.integers({element.type == 3 ? 2 : 3, first + element.entity, element.type});
      out.s(1);
      out.end_line();
      out.s(++number);
      out.sizes(element.nodes);
      out.end_line();
    }
  out.end("Elements");
  if (variant.partitions)
    {
      out.text("$GhostElements");
      out.s(1);
      out.end_line();
      out.s(3);
      out.i(1);
      out.s(1);
      out.i(2);
      out.end_line();
      out.end("GhostElements");
    }
}

std::string written(const Variant &variant)
{
  Writer out(variant.kind);
  out.text("$MeshFormat");
  out.text(std::string(variant.version == 2 ? "2.2 " : "4.1 ") +
           (variant.kind == Kind::ascii ? "0 8" : "1 8"));
  if (variant.kind != Kind::ascii)
    out.i(1);
  out.end("MeshFormat");
  out.text("$PhysicalNames\n6\n2 1 \"tooth flanks\"\n2 7 \"hub\"\n2 3 \"another\"\n3 4 \"rim\"\n"
           "3 5 \"hub zone\"\n3 6 \"steel\"\n$EndPhysicalNames");
  if (variant.other_sections)
    {
      out.text("$Comments\nof $Nodes\n$EndComments");
      out.text("$Periodic");
      out.s(1);
      out.end_line();
      out.integers({2, 1, 2});
      out.end_line();
      out.sizes({0, 10});
      out.end_line();
      out.end("Periodic");
    }
  variant.version == 2 ? write_2(out, variant) : write_4(out, variant);
  return out.out.str();
}

/// What comes of the file: all that a triangulation has, as text.
std::string triangulation(const std::string &text)
{
  std::ofstream("variant.msh", std::ios::binary) << text;
  const mesh::GmshFile gmsh = mesh::read_gmsh("variant.msh");
  const auto           mesh =
      mesh::make_triangulation("variant.msh",
                               gmsh,
                               {{gmsh.surfaces.at("tooth flanks").at(0), mesh::tooth_flanks},
                                {gmsh.surfaces.at("hub").at(0), mesh::hub}},
                               {gmsh.volumes.at("hub zone").at(0)});
  std::ostringstream all;
  for (const auto &cell : mesh->active_cell_iterators())
    {
      all << cell->center() << ' ' << mesh::component_name(cell->material_id()) << '\n';
      for (const auto &face : cell->face_iterators())
        all << "  " << face->center() << ' '
            << (face->at_boundary() ? mesh::surface_name(face->boundary_id()) : "inside") << '\n';
    }
  return all.str();
}
} // namespace

int main()
{
  const std::string expected = triangulation(written({}));
  std::cout << expected;
  const std::vector<std::pair<std::string, Variant>> variants = [] {
    std::vector<std::pair<std::string, Variant>> all;
    for (const int version : {2, 4})
      for (const Kind kind : {Kind::ascii, Kind::binary, Kind::foreign})
        for (const char *what : {"as it is", "two groups", "partitions", "parameters", "sections"})
          {
            const std::string name = what;
            Variant           v;
            v.version        = version;
            v.kind           = kind;
            v.groups         = name == "two groups";
            v.partitions     = name == "partitions";
            v.parameters     = name == "parameters";
            v.other_sections = name == "sections";
            all.emplace_back((version == 2 ? "2.2 " : "4.1 ") +
                                 std::string(kind == Kind::ascii  ? "ASCII, " :
                                             kind == Kind::binary ? "binary, " :
                                                                    "foreign, ") +
                                 name,
                             v);
          }
    return all;
  }();
  const auto say = [&](const std::string &what, const std::string &text) {
    std::cout << what << ": ";
    try
      {
        std::cout << (triangulation(text) == expected ? "the same" : "different") << '\n';
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << '\n';
      }
  };
  for (const auto &[name, variant] : variants)
    say(name, written(variant));

  // binary files that end early: at every byte a sentence
  for (const int version : {2, 4})
    {
      const std::string whole = written({version, Kind::binary, false, true, false, false});
      unsigned int      n     = 0;
      for (std::size_t size = 1; size + 2 < whole.find("$EndElements"); ++size)
        try
          {
            std::ofstream("variant.msh", std::ios::binary) << whole.substr(0, size);
            const mesh::GmshFile gmsh = mesh::read_gmsh("variant.msh");
            n += gmsh.elements.size() == 4; // none may be whole
          }
        catch (const InputError &)
          {
          }
      std::cout << "read whole although cut: " << n << '\n';
    }
  const auto replaced = [](std::string text, const std::string &old, const std::string &by) {
    return text.replace(text.find(old), old.size(), by);
  };
  const Variant binary = {2, Kind::binary, false, false, false, false};
  say("4 bytes", replaced(written(binary), "2.2 1 8", "2.2 1 4"));
  say("1 that is none", replaced(written(binary), std::string("\1\0\0\0", 4), "abcd"));
  say("unknown type",
      replaced(written(binary),
               std::string("\5\0\0\0\1\0\0\0", 8),
               std::string("\x50\0\0\0\1\0\0\0", 8)));
  say("unknown section",
      replaced(replaced(written({}), "$Nodes", "$Knots"), "$EndNodes", "$EndKnots"));
  say("version 1", "$NOD\n1\n1 0 0 0\n$ENDNOD\n");
}
