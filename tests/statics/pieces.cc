// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes whose parts p4est refines: opposite edges run the same way in all cells, since deal.II 9.4
// tells p4est of others wrongly which are the same. Sides keep their names in the new order.
#include <chaindrive/drive/drive.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/statics/pieces.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <iostream>
#include <map>

using namespace chaindrive;
using namespace chaindrive::statics;

namespace
{
void report(const Piece &piece)
{
  unsigned int               n_odd = 0;
  std::map<unsigned, double> areas;
  for (const auto &cell : piece.mesh->active_cell_iterators())
    {
      for (const unsigned int l : cell->line_indices())
        n_odd += cell->line_orientation(l) ? 0 : 1;
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          areas[cell->face(f)->boundary_id()] += 1e6 * cell->face(f)->measure();
    }
  std::cout << piece.name << ": edges against the others " << n_odd << ", volume in mm3 "
            << 1e9 * dealii::GridTools::volume(*piece.mesh) << "; sides in mm2:";
  for (const auto &[side, area] : areas)
    std::cout << ' ' << side << ' ' << area;
  std::cout << std::endl;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const drive::Drive                             d = drive::make_drive(Parameters());
  report(link_eighth(d.chain, true));
  report(link_eighth(d.chain, false));
  report(plate_eighth(d.chain, true));
  report(link_quarter(d.chain));
  report(roller_quarter(d.chain));
  for (const auto &s : d.sprockets)
    report(rim_sector(s.form, {s.bore, s.hub_diameter, d.sprocket_width}, 3));
}
