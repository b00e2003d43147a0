// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/stress.h>
#include <chaindrive/files/vtu_series.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/rotation.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <string>
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
  std::size_t period = 0; ///< vertices, besides one, after which z is most often the same; 0: none
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

  /// Per cell of a body with solid-shells, zero in its solid elements.
  dealii::ArrayView<const element::FaceStresses> faces{};

  /// Of contacts, per vertex of an elastic body whose surface may touch [Pa].
  dealii::ArrayView<const double> pressure{};

  double tension    = 0.; ///< of a link; of a roller, mean of its two links [N]
  double tooth_load = 0.; ///< normal force of the teeth on a roller [N]
  /// Of a sprocket: normal force in each gap between two teeth [N], and its frame at the start. Its
  /// cells show that of the gap that is nearest.
  dealii::ArrayView<const double> gap_load{};
  const Frame                    *sprocket = nullptr;
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

/// A piece of a surface that presses another one evenly, at one instant.
struct PatchSnapshot
{
  std::array<dealii::Point<3>, 4> corners;                ///< round and round [m]
  double                          pressure, normal_force; ///< Pa, N

  int          body, other; ///< numbers of the bodies that touch
  unsigned int joint;
  int          interface; ///< number of scene::Interface
};

/// Field output of the moving chain for ParaView: the series `bodies` and, when there are bars,
/// `bars` (files::VtuSeries); where contacts know pressure, `contacts`.
///
/// Points lie where they are now and carry displacement and velocity, and contact pressure where
/// surfaces of elastic bodies know it; cells carry the body's
/// number, the kind of its part, whether it deforms, its contact force, tension and tooth load.
/// Where bodies have stresses, cells carry them too: von Mises' of Cauchy's stress, Green's strain
/// and the second Piola-Kirchhoff stress in body axes (xx, yy, zz, xy, yz, xz), zero in other
/// bodies; where there are solid-shells, the stress at their faces. Numbers are stored in single
/// precision: 0.06 micrometres at 1 m.
class Fields
{
public:
  /// Each rank of @p comm writes its own bodies to @p directory.
  explicit Fields(const std::string &directory, MPI_Comm comm = MPI_COMM_SELF)
      : comm_(comm)
      , bodies_(directory, "bodies", comm)
      , bars_(directory, "bars", comm)
      , contacts_(directory, "contacts", comm)
  {
  }

  /// Collective; bars are the first rank's. @p contacts are what touches at this instant, of each
  /// rank its own; null, on all ranks: nothing tells.
  void write(double                            time,
             const std::vector<BodySnapshot>  &bodies,
             const std::vector<BarSnapshot>   &bars     = {},
             const std::vector<PatchSnapshot> *contacts = nullptr);

  /// The lists of instants.
  void serialize(const Archive &archive)
  {
    bodies_.serialize(archive);
    bars_.serialize(archive);
    contacts_.serialize(archive);
  }

private:
  /// Makes grid_ for @p bodies, with what does not change as long as they are the same, unless it
  /// has been made for these.
  void set_up(const std::vector<BodySnapshot> &bodies);

  /// What grid_ was set up for, of each body.
  struct Drawn
  {
    const PartPatches *part;
    unsigned int       id;
    int                kind;
    bool               elastic;
    std::size_t        n_gaps;

    bool operator==(const Drawn &other) const
    {
      return part == other.part && id == other.id && kind == other.kind &&
             elastic == other.elastic && n_gaps == other.n_gaps;
    }
  };

  MPI_Comm                  comm_;
  files::VtuSeries          bodies_, bars_, contacts_;
  files::VtuGrid            grid_; ///< of bodies
  std::vector<Drawn>        drawn_;
  std::vector<unsigned int> gap_; ///< of a sprocket that is nearest to each of its cells, in turn
};
} // namespace chaindrive::observe
