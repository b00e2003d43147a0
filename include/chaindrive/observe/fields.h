// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/stress.h>
#include <chaindrive/files/vtu.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/rotation.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::observe
{
/// The hexahedra of a part, made once and drawn for each of its bodies.
struct PartPatches
{
  /// With @p rigid_zone_only, the cells of a sprocket's rigid zone.
  explicit PartPatches(const dealii::Triangulation<3> &mesh, bool rigid_zone_only = false);

  std::vector<dealii::Point<3>>            vertices; ///< in the part's frame [m], mesh's numbering
  std::vector<std::array<unsigned int, 8>> cells;    ///< vertices of each cell, in VTK's order
};

/// A body at one instant. A rigid or lumped body follows its frames; an elastic one gives the
/// displacement and velocity of each vertex (world axes, numbered as PartPatches::vertices).
struct BodySnapshot
{
  const PartPatches   *part;
  unsigned int         id;
  int                  kind; ///< number of the kind of part, written as it is
  Frame                initial;
  Frame                now;           ///< ignored for an elastic body
  dealii::Tensor<1, 3> contact_force; ///< resultant on the body [N]

  dealii::ArrayView<const dealii::Tensor<1, 3>> displacement{}; ///< elastic bodies only [m]
  dealii::ArrayView<const dealii::Tensor<1, 3>> velocity{};     ///< elastic bodies only [m/s]
  dealii::ArrayView<const element::Stress>      stress{};       ///< per cell, elastic bodies only
};

/// A bar between two joints at one instant.
struct BarSnapshot
{
  unsigned int                        id;
  std::array<dealii::Point<3>, 2>     position;     ///< of its ends, now [m]
  std::array<dealii::Tensor<1, 3>, 2> displacement; ///< since the start [m]
  std::array<dealii::Tensor<1, 3>, 2> velocity;     ///< m/s
  double                              tension;      ///< N
};

/// Pictures of the moving chain for ParaView: `bodies.pvd` and, when there are bars, `bars.pvd`,
/// with one VTU file for each instant in the folder `fields` beside them; with several ranks, one
/// of each rank and a PVTU file that names them.
///
/// Points lie where they are now and carry displacement and velocity, cells carry the body's
/// number, the kind of its part and its contact force. Where bodies have stresses, cells carry them
/// too: von Mises' of Cauchy's stress, Green's strain and the second Piola-Kirchhoff stress in body
/// axes (xx, yy, zz, xy, yz, xz), zero in other bodies. Numbers are stored in single precision:
/// 0.06 micrometres at 1 m. Every failure to write is a RunError; earlier instants stay readable.
class Fields
{
public:
  /// Pictures go to the folder `fields` in @p directory. Each rank of @p comm writes its own
  /// bodies.
  explicit Fields(const std::string &directory, MPI_Comm comm = MPI_COMM_SELF);

  /// Collective; bars are the first rank's.
  void write(double                           time,
             const std::vector<BodySnapshot> &bodies,
             const std::vector<BarSnapshot>  &bars = {});

  /// The lists of instants.
  void serialize(const Archive &archive)
  {
    archive("bodies", bodies_);
    archive("bars", bars_);
  }

private:
  using Record = std::vector<std::pair<double, std::string>>; // time, file

  /// Writes the next instant of a series.
  void write_next(const std::string &name, const files::VtuGrid &grid, double time, Record &record);

  const std::string directory_;
  MPI_Comm          comm_;
  Record            bodies_, bars_;
};
} // namespace chaindrive::observe
