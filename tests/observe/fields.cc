// SPDX-License-Identifier: LGPL-2.1-or-later
// VTU files, read back without the code that wrote them: points, displacement and velocity of a
// rigid, an elastic and a lumped body against closed forms; strain and stress of an elastic one;
// cells, bars and the list of instants. On two ranks, of which the second alone has an elastic
// body: every piece has the fields that the whole picture names.
#include <chaindrive/files/file.h>
#include <chaindrive/observe/fields.h>
#include <chaindrive/utilities/ranks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <cstring>
#include <iostream>
#include <zlib.h>

using namespace chaindrive;
using dealii::Point;
using dealii::Tensor;

/// A data array of a VTU file, by its name.
template <typename Number>
std::vector<Number> read_array(const std::string &text, const std::string &name)
{
  const std::size_t xml   = text.find("Name=\"" + name + "\"");
  const std::size_t field = text.find("offset=\"", xml) + 8;
  const std::size_t binary =
      text.find('_', text.find("<AppendedData")) + 1 + std::stoul(text.substr(field, 20));
  std::uint64_t n_blocks, block, rest;
  std::memcpy(&n_blocks, &text[binary], 8);
  std::memcpy(&block, &text[binary + 8], 8);
  std::memcpy(&rest, &text[binary + 16], 8);
  const uLong         size = n_blocks * block - (rest > 0 ? block - rest : 0);
  std::vector<Number> values(size / sizeof(Number));

  std::size_t from = binary + 8 * (3 + n_blocks);
  uLong       done = 0;
  for (std::uint64_t b = 0; b < n_blocks; ++b)
    {
      std::uint64_t packed;
      std::memcpy(&packed, &text[binary + 8 * (3 + b)], 8);
      uLongf length = size - done;
      if (uncompress(reinterpret_cast<Bytef *>(values.data()) + done,
                     &length,
                     reinterpret_cast<const Bytef *>(&text[from]),
                     packed) != Z_OK)
        std::cout << "cannot be unpacked" << std::endl;
      from += packed;
      done += length;
    }
  return values;
}

/// Volume of a hexahedron from its corners in VTK's order: positive only if they are in order.
double volume(const std::vector<float> &points, const std::int32_t *cell)
{
  const auto corner = [&](const int v) {
    return Point<3>(points[3 * cell[v]], points[3 * cell[v] + 1], points[3 * cell[v] + 2]);
  };
  return cross_product_3d(corner(1) - corner(0), corner(3) - corner(0)) * (corner(4) - corner(0));
}

observe::BodySnapshot
turned(const observe::PartPatches &part, const double angle, const double speed)
{
  observe::BodySnapshot body{&part, 7, 2, {}, {}, Tensor<1, 3>({3., 4., 0.})};
  body.initial.rotation        = to_matrix(rotation_about_z(0.3));
  body.initial.position        = Point<3>(0.1, 0., 0.);
  body.now.rotation            = to_matrix(rotation_about_z(0.3 + angle));
  body.now.position            = Point<3>(0.4, 0.2, 0.);
  body.now.velocity            = Point<3>(1., 2., 0.);
  body.now.angular_velocity[2] = speed;
  return body;
}

/// The names of all data arrays of a file.
std::vector<std::string> names_in(const std::string &path)
{
  const std::string        text = files::read_text(path);
  std::vector<std::string> names;
  for (std::size_t at = text.find("DataArray type");
       at < text.find("</UnstructuredGrid>") && at < text.find("</PUnstructuredGrid>");
       at = text.find("DataArray type", at + 1))
    {
      const std::size_t begin = text.find("Name=\"", at) + 6;
      const std::string name  = text.substr(begin, text.find('"', begin) - begin);
      if (name != "TimeValue" && name != "connectivity" && name != "offsets" && name != "types")
        names.push_back(name);
    }
  return names;
}

/// Rank 0 has a rigid body, rank 1 an elastic one.
void write_on_two_ranks(const observe::BodySnapshot &rigid, const observe::BodySnapshot &elastic)
{
  const unsigned int rank = rank_in(MPI_COMM_WORLD);
  observe::Fields    fields(".", MPI_COMM_WORLD);
  // what touches is known to the second rank alone
  const observe::PatchSnapshot              patch{{}, 1e6, 2., 7, 8, 3, 1};
  const std::vector<observe::PatchSnapshot> contacts(rank, patch);
  fields.write(0., {rank == 0 ? rigid : elastic}, {}, &contacts);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank > 0)
    return;
  const auto names = names_in("fields/bodies_000000.pvtu");
  for (const std::string &name : names)
    std::cout << name << ' ';
  std::cout << std::endl;
  std::cout << "contacts:";
  for (const std::string &name : names_in("fields/contacts_000000.pvtu"))
    std::cout << ' ' << name;
  for (const int piece : {0, 1})
    std::cout << "; piece " << piece << ": "
              << read_array<float>(
                     files::read_text("fields/contacts_000000." + std::to_string(piece) + ".vtu"),
                     "normal_force")
                     .size();
  std::cout << std::endl;
  for (const int piece : {0, 1})
    std::cout << "as in piece " << piece << ": "
              << (names_in("fields/bodies_000000." + std::to_string(piece) + ".vtu") == names ?
                      "yes" :
                      "no")
              << std::endl;
  const auto von_mises =
      read_array<float>(files::read_text("fields/bodies_000000.0.vtu"), "von_mises");
  std::cout << "rigid body free of stress: "
            << (von_mises == std::vector<float>(rigid.part->cells.size(), 0.F) ? "yes" : "no")
            << std::endl;
}

int main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {3, 2, 1}, Point<3>(), Point<3>(0.03, 0.02, 0.01));
  const observe::PartPatches part(mesh);
  const std::size_t          n = part.vertices.size();

  std::vector<Tensor<1, 3>> stretch(n), rate(n);
  for (std::size_t v = 0; v < n; ++v)
    {
      stretch[v][0] = 0.5 * part.vertices[v][0];
      rate[v][2]    = 100. * part.vertices[v][1];
    }
  observe::BodySnapshot rigid = turned(part, 0.5, 40.);
  observe::BodySnapshot elastic{&part, 8, 3, {}, {}, Tensor<1, 3>()};
  elastic.initial.rotation = to_matrix(Quaternion());
  elastic.displacement     = {stretch.data(), n};
  elastic.velocity         = {rate.data(), n};
  const observe::BarSnapshot bar{4, {{Point<3>(0., 1., 0.), Point<3>(1., 1., 0.)}}, {}, {}, 1412.};

  // stretched by 1.5 along x, its sides held
  dealii::Tensor<2, 3> F = dealii::unit_symmetric_tensor<3>();
  F[0][0]                = 1.5;
  F[1][2]                = 0.2;
  const Material                     material;
  const element::Stress              held = element::stress(F, material);
  const std::vector<element::Stress> stresses(6, held);
  elastic.stress = {stresses.data(), stresses.size()};
  element::FaceStresses  of_faces; // numbers 1 to 6 and 11 to 16 in VTK's order
  constexpr unsigned int vtk[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
  for (unsigned int i = 0; i < 6; ++i)
    {
      of_faces.inner[vtk[i][0]][vtk[i][1]] = 1. + i;
      of_faces.outer[vtk[i][0]][vtk[i][1]] = 11. + i;
    }
  const std::vector<element::FaceStresses> faces(6, of_faces);
  elastic.faces = {faces.data(), faces.size()};
  if (n_ranks_in(MPI_COMM_WORLD) == 2)
    {
      write_on_two_ranks(rigid, elastic);
      return 0;
    }

  // a link, and a sprocket of five gaps, the first along x, of which cells show the nearest
  const std::vector<double> gaps = {10., 20., 30., 40., 50.};
  elastic.tension                = 1234.;
  rigid.gap_load                 = {gaps.data(), gaps.size()};
  rigid.sprocket                 = &rigid.initial;
  observe::BodySnapshot roller   = turned(part, 0., 40.);
  roller.tooth_load              = 77.;

  observe::Fields fields(".");
  fields.write(0., {roller});
  const std::vector<observe::PatchSnapshot> contacts = {
      {{{Point<3>(), Point<3>(1., 0., 0.), Point<3>(1., 2., 0.), Point<3>(0., 2., 0.)}},
       3e8,
       6e8,
       7,
       8,
       5,
       0},
      {{{Point<3>(), Point<3>(), Point<3>(), Point<3>(0., 0., 3.)}}, 4e8, 0.5, 9, 10, 6, 2}};
  fields.write(1e-3, {rigid, elastic}, {bar, bar}, &contacts);

  const std::string text         = files::read_text("fields/bodies_000001.vtu");
  const auto        points       = read_array<float>(text, "position");
  const auto        displacement = read_array<float>(text, "displacement");
  const auto        velocity     = read_array<float>(text, "velocity");
  const auto        cells        = read_array<std::int32_t>(text, "connectivity");
  std::cout << "points " << points.size() / 3 << ", cells " << cells.size() / 8 << ", bodies "
            << read_array<std::int32_t>(text, "body").front() << ' '
            << read_array<std::int32_t>(text, "body").back() << ", kinds "
            << read_array<std::int32_t>(text, "kind").front() << ' '
            << read_array<std::int32_t>(text, "kind").back() << ", types "
            << int(read_array<unsigned char>(text, "types").back()) << ", last offset "
            << read_array<std::int32_t>(text, "offsets").back() << ", contact force "
            << read_array<float>(text, "contact_force")[0] << ' '
            << read_array<float>(text, "contact_force")[1] << ' '
            << read_array<float>(text, "contact_force").back() << std::endl;

  const auto load = read_array<float>(text, "tooth_load");
  std::cout << "tooth load of a roller "
            << read_array<float>(files::read_text("fields/bodies_000000.vtu"), "tooth_load").back()
            << ", of a sprocket";
  for (unsigned int c = 0; c < 6; ++c)
    std::cout << ' ' << load[c];
  std::cout << ", of a link " << load.back() << "; its tension "
            << read_array<float>(text, "tension").back() << "; elastic "
            << read_array<std::int32_t>(text, "elastic").front() << ' '
            << read_array<std::int32_t>(text, "elastic").back() << std::endl;

  // The rigid body: points by their polar angle in the body, velocity by small rotations.
  double worst_point = 0., worst_displacement = 0., worst_velocity = 0., worst_elastic = 0.;
  for (std::size_t v = 0; v < n; ++v)
    {
      const double r   = std::hypot(part.vertices[v][0], part.vertices[v][1]),
                   a   = std::atan2(part.vertices[v][1], part.vertices[v][0]);
      const auto place = [&](const double t) { // turns and moves on from the instant t = 0
        return Point<3>(0.4 + 1. * t + r * std::cos(a + 0.8 + 40. * t),
                        0.2 + 2. * t + r * std::sin(a + 0.8 + 40. * t),
                        part.vertices[v][2]);
      };
      const Point<3> start(0.1 + r * std::cos(a + 0.3), r * std::sin(a + 0.3), part.vertices[v][2]);
      const Tensor<1, 3> slope = (place(1e-5) - place(-1e-5)) / 2e-5;
      for (int d = 0; d < 3; ++d)
        {
          const std::size_t  i = 3 * v + d, j = 3 * (n + v) + d;
          const Tensor<1, 3> moved = place(0.) - start;
          worst_point              = std::max(worst_point, std::abs(points[i] - place(0.)[d]));
          worst_displacement = std::max(worst_displacement, std::abs(displacement[i] - moved[d]));
          worst_velocity     = std::max(worst_velocity, std::abs(velocity[i] - slope[d]));
          worst_elastic      = std::max({worst_elastic,
                                         std::abs(points[j] - part.vertices[v][d] * (d == 0 ? 1.5 : 1.)),
                                         std::abs(displacement[j] - stretch[v][d]),
                                         std::abs(velocity[j] - rate[v][d])});
        }
    }
  std::cout << "rigid body: points, displacement within 0.1 micrometres: "
            << (worst_point < 1e-7 && worst_displacement < 1e-7 ? "yes" : "no")
            << ", velocity within 1e-6 m/s: " << (worst_velocity < 1e-6 ? "yes" : "no") << std::endl
            << "elastic body right: " << (worst_elastic < 2e-7 ? "yes" : "no") << std::endl;

  double rigid_volume = 0., elastic_volume = 0.;
  for (unsigned int c = 0; c < 12; ++c)
    (c < 6 ? rigid_volume : elastic_volume) += volume(points, &cells[8 * c]);
  std::cout << "volume / exact: rigid " << std::round(rigid_volume / 6e-6 * 1e5) / 1e5
            << ", stretched " << std::round(elastic_volume / 9e-6 * 1e5) / 1e5 << std::endl;

  // E = (F^T F - 1) / 2, S = lambda tr E + 2 mu E, sigma = F S F^T / 1.5, each in VTK's order
  const double mu = 210e9 / 2.6, lambda = mu * 0.6 / 0.4;
  const double exx = 0.625, eyz = 0.1, ezz = 0.02, pull = lambda * (exx + ezz);
  const double sxx = pull + 2. * mu * exx, syy = pull, szz = pull + 2. * mu * ezz,
               syz = 2. * mu * eyz;
  const double txx = 1.5 * sxx, tyy = (syy + 0.4 * syz + 0.04 * szz) / 1.5, tzz = szz / 1.5,
               tyz   = (syz + 0.2 * szz) / 1.5;
  const double mises = std::sqrt(
      0.5 * ((txx - tyy) * (txx - tyy) + (tyy - tzz) * (tyy - tzz) + (tzz - txx) * (tzz - txx)) +
      3. * tyz * tyz);
  const auto strain = read_array<float>(text, "strain"), stress = read_array<float>(text, "stress"),
             von_mises           = read_array<float>(text, "von_mises");
  const double expected_strain[] = {exx, 0., ezz, 0., eyz, 0.},
               expected_stress[] = {sxx, syy, szz, 0., syz, 0.};
  double worst_rigid = 0., worst_stress = 0.;
  for (int c = 0; c < 6; ++c)
    {
      worst_rigid  = std::max(worst_rigid, double(std::abs(von_mises[c])));
      worst_stress = std::max(worst_stress, std::abs(von_mises[6 + c] / mises - 1.));
      for (int i = 0; i < 6; ++i)
        {
          worst_rigid  = std::max({worst_rigid,
                                   double(std::abs(strain[6 * c + i])),
                                   double(std::abs(stress[6 * c + i]))});
          worst_stress = std::max({worst_stress,
                                   std::abs(strain[36 + 6 * c + i] - expected_strain[i]),
                                   std::abs(stress[36 + 6 * c + i] - expected_stress[i]) / sxx});
        }
    }
  std::cout << "cells with strain, stress and von Mises: " << von_mises.size()
            << ", elastic within 1e-6: " << (worst_stress < 1e-6 ? "yes" : "no")
            << ", rigid zero: " << (worst_rigid == 0. ? "yes" : "no")
            << "; absent without elastic bodies: "
            << (files::read_text("fields/bodies_000000.vtu").find("von_mises") ==
                        std::string::npos ?
                    "yes" :
                    "no")
            << std::endl;

  const auto inner = read_array<float>(text, "stress_inner"),
             outer = read_array<float>(text, "stress_outer");
  std::cout << "stress at faces: " << inner.size() << ' ' << outer.size() << ", rigid " << inner[0]
            << ' ' << outer[35] << ", elastic " << inner[36] << ' ' << inner[41] << ' ' << outer[36]
            << ' ' << outer[71] << '\n';

  const std::string bars = files::read_text("fields/bars_000000.vtu");
  std::cout << "bars: points " << read_array<float>(bars, "position").size() / 3 << ", types "
            << int(read_array<unsigned char>(bars, "types")[0]) << ", connectivity "
            << read_array<std::int32_t>(bars, "connectivity")[2] << ' '
            << read_array<std::int32_t>(bars, "connectivity")[3] << ", tension "
            << read_array<float>(bars, "tension")[1] << ", number "
            << read_array<std::int32_t>(bars, "bar")[1] << std::endl;
  const std::string touching = files::read_text("fields/contacts_000000.vtu");
  const auto        corners  = read_array<float>(touching, "position");
  std::cout << "contacts: points " << corners.size() / 3 << ", third " << corners[6] << ' '
            << corners[7] << ", last " << corners.back() << ", type "
            << int(read_array<unsigned char>(touching, "types")[1]) << ", last offset "
            << read_array<std::int32_t>(touching, "offsets").back() << ", pressure "
            << read_array<float>(touching, "contact_pressure")[0] << ", force "
            << read_array<float>(touching, "normal_force")[1];
  for (const char *number : {"body", "other_body", "joint", "interface"})
    std::cout << ", " << number << ' ' << read_array<std::int32_t>(touching, number)[0] << ' '
              << read_array<std::int32_t>(touching, number)[1];
  std::cout << std::endl;
  for (const char *list : {"bodies.pvd", "bars.pvd", "contacts.pvd"})
    {
      const std::string record = files::read_text(list);
      for (std::size_t at = record.find("<DataSet"); at != std::string::npos;
           at             = record.find("<DataSet", at + 1))
        std::cout << record.substr(at, record.find('\n', at) - at) << std::endl;
    }
}
