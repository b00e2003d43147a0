// SPDX-License-Identifier: LGPL-2.1-or-later
// Arrays of several blocks in VTU files, read back without the code that wrote them: digits that
// cannot be compressed are stored, others shrink, and of a second picture the numbers count that it
// has, not those of the first. Points of rigid bodies in columns along z shrink to what differs,
// whatever their bytes are and wherever blocks and bodies end, and nothing is lost where periods
// are wrong or too long for the format. Beside them bodies that deform are stored.
#include <chaindrive/files/vtu.h>

#include <cstring>
#include <iostream>
#include <random>
#include <sstream>
#include <zlib.h>

using namespace chaindrive;

/// The bytes of an array of a file by its name, and how many they are in the file.
template <typename Number>
std::vector<Number>
read_array(const std::string &text, const std::string &name, std::size_t &in_file)
{
  const std::size_t xml   = text.find("Name=\"" + name + "\"");
  const std::size_t field = text.find("offset=\"", xml) + 8;
  std::size_t       at =
      text.find('_', text.find("<AppendedData")) + 1 + std::stoul(text.substr(field, 20));
  const auto next = [&]() {
    std::uint64_t number;
    std::memcpy(&number, &text[at], sizeof(number));
    at += sizeof(number);
    return number;
  };
  const std::uint64_t        n_blocks = next(), block = next(), rest = next();
  std::vector<std::uint64_t> packed(n_blocks);
  for (std::uint64_t &size : packed)
    size = next();
  std::vector<Number> values((n_blocks * block - (rest > 0 ? block - rest : 0)) / sizeof(Number));
  auto               *to = reinterpret_cast<Bytef *>(values.data());
  in_file                = 0;
  for (std::uint64_t b = 0; b < n_blocks; ++b)
    {
      uLongf length = b + 1 < n_blocks || rest == 0 ? block : rest;
      if (uncompress(to, &length, reinterpret_cast<const Bytef *>(&text[at]), packed[b]) != Z_OK)
        std::cout << "cannot be unpacked" << std::endl;
      to += length;
      at += packed[b];
      in_file += packed[b];
    }
  return values;
}

std::size_t size_of(const std::vector<float> &values) { return values.size() * sizeof(float); }

/// Bodies that are swept along z, 5 points in each column, of random bits: with a period that is
/// right, one that is wrong, and one farther than the format can point.
void write_rigid_bodies()
{
  files::VtuGrid grid;
  std::mt19937   random(2);
  const auto     any = [&random]() {
    const auto bits = static_cast<std::uint32_t>(random());
    float      number;
    std::memcpy(&number, &bits, sizeof(number));
    return number;
  };
  constexpr std::size_t height = 5;
  float                 z[height];
  for (float &plane : z)
    plane = any();
  for (const auto &[n_points, period] : {std::make_pair(std::size_t(30000), height),
                                         std::make_pair(std::size_t(1005), std::size_t(7)),
                                         std::make_pair(std::size_t(20005), std::size_t(20000)),
                                         std::make_pair(std::size_t(50), std::size_t(0))})
    {
      for (std::size_t column = 0; column < n_points / height; ++column)
        {
          const float x = any(), y = any();
          for (const float plane : z)
            grid.points.insert(grid.points.end(), {x, y, plane});
        }
      grid.bodies.push_back({n_points, n_points, period});
    }
  const std::size_t n = grid.points.size() / 3;
  grid.connectivity.resize(8 * n);
  grid.point_data = {{"still", 3, std::vector<float>(3 * n)}};
  grid.cell_data  = {{"load", 3, std::vector<float>(3 * n)}, {"noise", 1, {}}};
  for (std::size_t i = 0; i < n; ++i)
    grid.cell_data[1].values.push_back(any());
  for (std::size_t i = 2 * n; i < 3 * n; ++i)
    grid.cell_data[0].values[i] = 1.F;

  files::VtuPacked   before;
  std::ostringstream out;
  files::write_vtu(out, grid, 0.5, before);
  const auto look = [&](const std::string &name, const std::vector<float> &values) {
    std::size_t size = 0;
    const auto  read = read_array<float>(out.str(), name, size);
    std::cout << name << ": "
              << (read.size() == values.size() &&
                          std::memcmp(read.data(), values.data(), size_of(values)) == 0 ?
                      "the same" :
                      "others")
              << ", " << 100 * size / size_of(values) << " %" << std::endl;
  };
  std::cout << "rigid bodies" << std::endl;
  look("position", grid.points);
  look("still", grid.point_data[0].values);
  look("load", grid.cell_data[0].values);
  look("noise", grid.cell_data[1].values);
}

/// Bodies that deform, of random bits, between rigid ones of which all is zero: blocks begin and
/// end in any of them. What deforms is stored, what is rigid vanishes.
void write_bodies_of_both_kinds()
{
  files::VtuGrid     grid;
  std::vector<float> stress;
  std::mt19937       random(3);
  const auto add = [&random](std::vector<float> &to, const std::size_t n, const bool deforms) {
    for (std::size_t i = 0; i < n; ++i)
      {
        const std::uint32_t bits   = deforms ? static_cast<std::uint32_t>(random()) : 0;
        float               number = 0.F;
        std::memcpy(&number, &bits, sizeof(number));
        to.push_back(number);
      }
  };
  for (const auto &[n_points, deforms] : {std::make_pair(std::size_t(50000), false),
                                          std::make_pair(std::size_t(100001), true),
                                          std::make_pair(std::size_t(7), false),
                                          std::make_pair(std::size_t(3), true),
                                          std::make_pair(std::size_t(40000), true),
                                          std::make_pair(std::size_t(9), false),
                                          std::make_pair(std::size_t(4), true),
                                          std::make_pair(std::size_t(50000), false)})
    {
      grid.bodies.push_back({n_points, n_points - 1, 0, deforms});
      add(grid.points, 3 * n_points, deforms);
      add(stress, 6 * (n_points - 1), deforms);
    }
  grid.connectivity.resize(8 * stress.size() / 6);
  grid.cell_data = {{"stress", 6, stress}};

  files::VtuPacked   before;
  std::ostringstream out;
  files::write_vtu(out, grid, 0.5, before);
  std::cout << "bodies of both kinds" << std::endl;
  for (const auto &[name, values] :
       {std::make_pair("position", &grid.points), std::make_pair("stress", &stress)})
    {
      std::size_t size = 0;
      const auto  read = read_array<float>(out.str(), name, size);
      std::cout << name << ": "
                << (read.size() == values->size() &&
                            std::memcmp(read.data(), values->data(), size_of(*values)) == 0 ?
                        "the same" :
                        "others")
                << ", " << 100 * size / size_of(*values) << " %" << std::endl;
    }
}

int main()
{
  constexpr std::size_t n_points = 60000;

  files::VtuGrid                        grid;
  std::mt19937                          random(1);
  std::uniform_real_distribution<float> uniform(-1.F, 1.F);
  for (std::size_t i = 0; i < 3 * n_points; ++i)
    grid.points.push_back(uniform(random));
  grid.point_data = {{"steady", 3, std::vector<float>(3 * n_points, 0.25F)},
                     {"few", 2, std::vector<float>(2 * n_points), true}};
  for (std::size_t i = 0; i < 2 * n_points; i += 97)
    grid.point_data[1].values[i] = uniform(random);
  for (std::size_t i = 0; i + 8 <= n_points; ++i)
    for (std::size_t v = 0; v < 8; ++v)
      grid.connectivity.push_back(static_cast<std::int32_t>(i + v));
  const std::size_t n_cells = grid.connectivity.size() / 8;
  grid.cell_numbers         = {{"body", std::vector<std::int32_t>(n_cells, 3)}};

  files::VtuPacked before;
  for (const int picture : {1, 2, 3})
    {
      if (picture == 2)
        grid.cell_numbers[0].values.back() = 4;
      if (picture == 3) // another mesh: its last cells are missing
        {
          grid.connectivity.resize(4000);
          grid.cell_numbers[0].values.resize(500);
        }
      std::ostringstream out;
      files::write_vtu(out, grid, 0.5, before);
      const auto look = [&](const std::string &name, const auto &values) {
        std::size_t size;
        const bool  same =
            read_array<std::decay_t<decltype(values[0])>>(out.str(), name, size) == values;
        const double part = double(size) / double(values.size() * sizeof(values[0]));
        std::cout << name << ": " << (same ? "the same" : "others") << ", "
                  << (part > 1.001 ? "larger" :
                      part > 0.999 ? "stored" :
                                     "smaller")
                  << std::endl;
      };
      std::cout << "picture " << picture << std::endl;
      look("position", grid.points);
      look("steady", grid.point_data[0].values);
      look("few", grid.point_data[1].values);
      look("connectivity", grid.connectivity);
      look("body", grid.cell_numbers[0].values);
    }
  write_rigid_bodies();
  write_bodies_of_both_kinds();
}
