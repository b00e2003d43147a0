// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import/gmsh_file.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <utility>

namespace chaindrive::mesh
{
namespace
{
/// The lines of a file, and what is wrong with them.
class Lines
{
public:
  explicit Lines(const std::string &file) : file_(file), in_(file)
  {
    if (!in_)
      throw InputError("The mesh file '" + file + "' cannot be opened.");
  }

  bool next()
  {
    line.clear();
    ++number_;
    if (!std::getline(in_, line))
      return false;
    line.erase(line.find_last_not_of(" \t\r") + 1);
    return true;
  }

  [[noreturn]] void fail(const std::string &expected) const
  {
    throw InputError("The mesh '" + file_ + "', line " + std::to_string(number_) + ": " + expected +
                     " expected, found " +
                     (in_ ? "'" + line.substr(0, 40) + (line.size() > 40 ? "...'" : "'") :
                            "the end of the file") +
                     ".");
  }

  void expect(const std::string &text)
  {
    if (!next() || line != text)
      fail("'" + text + "'");
  }

  /// The next line, which must consist of numbers: at least @p n of them.
  const std::vector<double> &numbers(const std::size_t n, const std::string &what)
  {
    numbers_.clear();
    next();
    const char *at = line.data(), *const end = at + line.size();
    while (at != end)
      {
        double     value  = 0.;
        const auto result = std::from_chars(at, end, value);
        if (result.ec == std::errc::invalid_argument)
          fail(what);
        numbers_.push_back(result.ec == std::errc() ? value : NAN); // too large for a double
        at = std::find_if(result.ptr, end, [](const char c) { return c != ' ' && c != '\t'; });
        if (at == result.ptr && at != end)
          fail(what);
      }
    if (numbers_.size() < n)
      fail(what);
    return numbers_;
  }

  /// @p value, of the last line, which must be a whole number.
  long whole(const double value) const
  {
    if (!(std::abs(value) < 1e15) || value != std::floor(value))
      fail("a whole number instead of " + to_text(value));
    return static_cast<long>(value);
  }

  std::vector<long> whole(const std::vector<double> &values, const std::size_t from) const
  {
    std::vector<long> result;
    for (std::size_t i = from; i < values.size(); ++i)
      result.push_back(whole(values[i]));
    return result;
  }

  /// A line with one number: how many lines follow.
  long count() { return whole(numbers(1, "a number of lines")[0]); }

  std::string line;

private:
  std::string         file_;
  std::ifstream       in_;
  unsigned long       number_ = 0;
  std::vector<double> numbers_;
};

using Groups = std::map<std::pair<long, long>, std::vector<long>>; // of dimension and entity

void read_names(Lines &lines, GmshFile &mesh)
{
  for (long n = lines.count(); n > 0; --n)
    {
      lines.next();
      const auto        first = lines.line.find('"'), last = lines.line.rfind('"');
      long              dimension = 0, group = 0;
      const char *const end    = lines.line.data() + lines.line.size();
      const auto        result = std::from_chars(lines.line.data(), end, dimension);
      if (result.ptr == end || std::from_chars(result.ptr + 1, end, group).ec != std::errc() ||
          first == std::string::npos || first == last)
        lines.fail("dimension, number and \"name\" of a physical group");
      const std::string name = lines.line.substr(first + 1, last - first - 1);
      if (!name.empty() && dimension > 1)
        (dimension == 2 ? mesh.surfaces : mesh.volumes)[name] = group;
    }
}

void read_entities(Lines &lines, Groups &groups)
{
  const std::string         what   = "an entity with its physical groups";
  const std::vector<double> counts = lines.numbers(4, "four numbers of entities");
  for (long dimension = 0; dimension < 4; ++dimension)
    for (long n = lines.whole(counts[dimension]); n > 0; --n)
      {
        // number, a point or the two ends of a box, number of groups, groups
        const std::size_t          place  = dimension == 0 ? 4 : 7;
        const std::vector<double> &values = lines.numbers(place + 1, what);
        const long                 m      = lines.whole(values[place]);
        if (m < 0 || static_cast<std::size_t>(m) > values.size() - place - 1)
          lines.fail(what);
        auto &found = groups[{dimension, lines.whole(values[0])}];
        for (long i = 0; i < m; ++i)
          found.push_back(lines.whole(values[place + 1 + i]));
      }
}

void add_node(const Lines &lines, GmshFile &mesh, const long number, const double *const x)
{
  if (!mesh.nodes.emplace(number, dealii::Point<3>(x[0], x[1], x[2])).second)
    lines.fail("another number than that of node " + std::to_string(number) +
               ", which was there before,");
}

void read_nodes_2(Lines &lines, GmshFile &mesh)
{
  for (long n = lines.count(); n > 0; --n)
    {
      const std::vector<double> &values = lines.numbers(4, "number and coordinates of a node");
      add_node(lines, mesh, lines.whole(values[0]), &values[1]);
    }
}

void read_nodes_4(Lines &lines, GmshFile &mesh)
{
  for (long blocks = lines.whole(lines.numbers(4, "number of blocks of nodes")[0]); blocks > 0;
       --blocks)
    {
      std::vector<long> nodes;
      for (long n = lines.whole(lines.numbers(4, "a block of nodes")[3]); n > 0; --n)
        nodes.push_back(lines.whole(lines.numbers(1, "number of a node")[0]));
      for (const long node : nodes)
        add_node(lines, mesh, node, lines.numbers(3, "coordinates of a node").data());
    }
}

void read_elements_2(Lines &lines, GmshFile &mesh)
{
  const std::string what = "number, type, tags and nodes of an element";
  for (long n = lines.count(); n > 0; --n)
    {
      std::vector<long> values = lines.whole(lines.numbers(3, what), 0);
      const long        n_tags = values[2];
      if (n_tags < 0 || static_cast<std::size_t>(n_tags) > values.size() - 3)
        lines.fail(what);
      GmshFile::Element element{values[1], {}, {values.begin() + 3 + n_tags, values.end()}};
      if (n_tags > 0)
        element.groups = {values[3]};
      mesh.elements.push_back(std::move(element));
    }
}

void read_elements_4(Lines &lines, const Groups &groups, GmshFile &mesh)
{
  for (long blocks = lines.whole(lines.numbers(4, "number of blocks of elements")[0]); blocks > 0;
       --blocks)
    {
      const std::vector<long> block = lines.whole(lines.numbers(4, "a block of elements"), 0);
      const auto              found = groups.find({block[0], block[1]});
      for (long n = block[3]; n > 0; --n)
        mesh.elements.push_back(
            {block[2],
             found == groups.end() ? std::vector<long>() : found->second,
             lines.whole(lines.numbers(2, "number and nodes of an element"), 1)});
    }
}
} // namespace

GmshFile read_gmsh(const std::string &file)
{
  Lines lines(file);
  lines.next();
  if (lines.line.compare(0, 11, "$MeshFormat") != 0)
    throw InputError("'" + file +
                     "' is not a mesh file of Gmsh: it does not begin with $MeshFormat.");
  const std::vector<double> &format  = lines.numbers(2, "version and kind of the file");
  const double               version = format[0];
  if (format[1] != 0. || !(version == 2.2 || version == 4.1))
    throw InputError("'" + file + "' is a Gmsh file of version " + to_text(version) +
                     (format[1] != 0. ? ", binary" : "") +
                     "; 2.2 and 4.1 in ASCII can be read (gmsh -format msh41).");
  lines.expect("$EndMeshFormat");

  GmshFile mesh;
  Groups   groups;
  while (lines.next())
    {
      if (lines.line.empty())
        continue;
      const std::string section = lines.line;
      if (section[0] != '$' || section.compare(0, 4, "$End") == 0)
        lines.fail("the beginning of a section");
      if (section == "$PhysicalNames")
        read_names(lines, mesh);
      else if (section == "$Entities" && version > 4.)
        read_entities(lines, groups);
      else if (section == "$Nodes")
        version < 4. ? read_nodes_2(lines, mesh) : read_nodes_4(lines, mesh);
      else if (section == "$Elements")
        version < 4. ? read_elements_2(lines, mesh) : read_elements_4(lines, groups, mesh);
      else
        {
          while (lines.line != "$End" + section.substr(1))
            if (!lines.next())
              lines.fail("'$End" + section.substr(1) + "'");
          continue;
        }
      lines.expect("$End" + section.substr(1));
    }
  return mesh;
}
} // namespace chaindrive::mesh
