// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses at the waist of side plates. A strip under tension and moments about both axes, placed
// anywhere, against the beam's closed form. Then links, solved statically: pulled by their pins or
// bushes the mean stress of the waist is the pull over its area; turned by couples in the plates'
// plane the edges show M / W but for the notch that a waist is, and no mean. Plates of solid-shells
// show what those of solid elements do, and membranes the same but for bending across, of which
// they have a hundredth.
#include "../support/modes.h"

#include <chaindrive/drive/plate.h>
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/observe/plate_stress.h>

using namespace test;

namespace
{
const Material material;
const double   E = material.youngs_modulus, nu = material.poissons_ratio;

using parameters::ElementType;

constexpr std::array<std::pair<ElementType, const char *>, 3> walls{
    {{ElementType::solid, "solid elements"},
     {ElementType::solid_shell, "solid-shells"},
     {ElementType::membrane, "membranes"}}};

observe::WaistStress at(const mesh::Part                                                  &part,
                        const ElementType                                                  plates,
                        const std::function<Tensor<1, 3>(const Point<3> &, unsigned int)> &place)
{
  const mesh::Nodes          nodes(part);
  const observe::PlateStress stress(part, nodes, material, plates);
  std::vector<Tensor<1, 3>>  position;
  for (const unsigned int node : stress.nodes())
    position.push_back(place(nodes.position[node], node));
  return stress(position);
}

/// x from -8 to 8 mm, y from -5 to 5 mm, z from 6 to 8 mm, with the surfaces of a plate.
mesh::Part strip()
{
  const Point<3> low(-8e-3, -5e-3, 6e-3), high(8e-3, 5e-3, 8e-3);
  return part([&](dealii::Triangulation<3> &mesh) {
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {16, 10, 1}, low, high);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        cell->set_material_id(mesh::outer_plate);
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && f >= 2)
            cell->face(f)->set_boundary_id(f < 4  ? mesh::plate_edges :
                                           f == 4 ? mesh::plate_inner_faces :
                                                    mesh::plate_outer_faces);
      }
  });
}

void beam()
{
  const double pull = 3e-7 * E, in_plane = 2e-7 * E, out_of_plane = 1e-7 * E;
  const double k = in_plane / (5e-3 * E), l = out_of_plane / (1e-3 * E), e = pull / E;
  // the linear solutions of pull and bending, about y and about z: sums of small displacements
  const auto place = [&](const Point<3> &p, unsigned int) {
    const double x = p[0], y = p[1], z = p[2] - 7e-3;
    return Tensor<1, 3>(Point<3>(1., 2., 3.)) +
           turn(2.5) *
               Tensor<1, 3>(Point<3>(
                   x * (1. + e - k * y + l * z),
                   y * (1. - nu * e - nu * l * z) + 0.5 * k * (x * x + nu * (y * y - z * z)),
                   p[2] - nu * e * z + nu * k * y * z - 0.5 * l * (x * x + nu * (z * z - y * y))));
  };
  for (const auto &[wall, name] : walls)
    {
      const observe::WaistStress s = at(strip(), wall, place);
      std::cout << "strip of " << name << ": axial " << s.axial / pull << ", in the plane "
                << s.in_plane / in_plane << ", out of the plane " << s.out_of_plane / out_of_plane
                << ", principal stress in the middle " << s.principal_1 / pull
                << " of the closed forms; the other principal one below 1e-3 of it: "
                << (std::abs(s.principal_2) < 1e-3 * pull ? "yes" : "NO") << '\n';
    }
}

/// A link whose joints are pulled apart by @p pull [N] and turned against each other by @p couple
/// [N m]: forces on all nodes of its pins or bushes, in proportion to their masses.
observe::WaistStress loaded(const mesh::Part &part,
                            const ElementType plates,
                            const double      pitch,
                            const double      radius,
                            const double      pull,
                            const double      couple)
{
  const Hexahedra      reference(part, material, Formulation::enhanced);
  parameters::Elements elements;
  elements.plates = elements.bushes = plates;
  const mesh::Nodes                          nodes(part);
  const element::ElasticPart                 elastic(part, nodes, material, elements);
  std::vector<const element::ElementBlock *> blocks;
  for (const auto &block : elastic.blocks())
    blocks.push_back(block.get());
  LinearModel model;
  element::assemble(blocks, reference.n_nodes(), model.pattern, model.stiffness);
  model.mass.reinit(model.pattern);
  for (unsigned int i = 0; i < model.mass.m(); ++i)
    model.mass.diag_element(i) = reference.mass[i / 3];
  double     mass = 0., inertia = 0.;
  const auto for_each = [&](const auto &act) {
    for (unsigned int node = 0; node < reference.n_nodes(); ++node)
      {
        const Point<3> &x   = reference.position[node];
        const double    end = x[0] > 0. ? 1. : -1., arm = x[0] - 0.5 * end * pitch;
        if (std::hypot(arm, x[1]) < radius * (1. + 1e-6))
          act(node, end, arm, x[1], reference.mass[node]);
      }
  };
  for_each([&](unsigned int, double, const double x, const double y, const double m) {
    mass += 0.5 * m;
    inertia += 0.5 * m * (x * x + y * y);
  });
  Vector<double> force(model.stiffness.m());
  for_each([&](const unsigned int node, const double end, double x, double y, const double m) {
    force[3 * node] += end * (pull * m / mass - couple * m * y / inertia);
    force[3 * node + 1] += end * couple * m * x / inertia;
  });
  const Vector<double> u     = model.displacements(force, 1e4); // holds rigid motions
  const double         small = 1e-3; // of the displacements: the linear solution
  observe::WaistStress s     = at(part, plates, [&](const Point<3> &x, const unsigned int node) {
    Tensor<1, 3> moved = x;
    for (unsigned int i = 0; i < 3; ++i)
      moved[i] += small * u[3 * node + i];
    return turn(1.) * moved;
  });
  for (double *value : {&s.axial, &s.in_plane, &s.out_of_plane, &s.principal_1, &s.principal_2})
    *value /= small;
  return s;
}

void links(const unsigned int refinement)
{
  const auto   chain = drive::make_chain(parameters::Chain());
  const double pull = 1413., couple = 1.;
  for (const bool inner : {true, false})
    {
      const drive::Plate plate = inner ? drive::inner_plate(chain) : drive::outer_plate(chain);
      const mesh::Part   part =
          inner ? mesh::make_inner_link(chain, 7600., mesh::inner_link_grid(refinement)) :
                    mesh::make_outer_link(chain, 7600., mesh::outer_link_grid(refinement));
      const double radius  = 0.5 * plate.hole_diameter;
      const double nominal = 0.5 * pull / (plate.waist * plate.thickness);
      const double bent    = 0.5 * couple / (plate.thickness * plate.waist * plate.waist / 6.);

      for (const auto &[wall, name] : walls)
        {
          if (wall != ElementType::solid && refinement > 1)
            continue;
          const auto pulled = loaded(part, wall, plate.hole_pitch, radius, pull, 0.);
          const auto turned = loaded(part, wall, plate.hole_pitch, radius, 0., couple);
          std::cout << part.name << " of " << name << ", refinement " << refinement
                    << ": pulled, axial stress over " << nominal * 1e-6
                    << " MPa: " << pulled.axial / nominal
                    << ", principal in the middle: " << pulled.principal_1 / nominal
                    << ", bending in the plane below 1e-6: "
                    << (std::abs(pulled.in_plane) < 1e-6 * nominal ? "yes" : "NO")
                    << "; turned, edges over M / W: " << turned.in_plane / bent
                    << ", axial below 1e-6: "
                    << (std::abs(turned.axial) < 1e-6 * bent ? "yes" : "NO") << '\n';
        }
    }
}
} // namespace

int main()
{
  std::cout << std::fixed << std::setprecision(3);
  beam();
  for (const unsigned int refinement : {1, 2, 3})
    links(refinement);
}
