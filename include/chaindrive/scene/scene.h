// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/programs.h>
#include <chaindrive/drive/roller_ring.h>
#include <chaindrive/drive/tensioner.h>
#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/drive_view.h>
#include <chaindrive/scene/interface.h>
#include <chaindrive/scene/oil_films.h>
#include <chaindrive/utilities/mirror_symmetry.h>
#include <chaindrive/utilities/rotation.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::mesh
{
struct Part;
struct Sector;
} // namespace chaindrive::mesh

namespace chaindrive::reduction
{
struct Basis;
struct RoundFlexibility;
} // namespace chaindrive::reduction

namespace chaindrive
{
class ForceElement;
}

namespace chaindrive::scene
{
/// What a body is; field output and histories tell bodies apart by it.
enum class Kind
{
  roller,
  inner_link,
  outer_link,
  sprocket,
  tensioner, ///< the arm or slide of one
  guide,
  bearing, ///< a way along x or y of a wheel's axis
  machine  ///< what is behind the coupling of a wheel
};

/// Which part a body is an instance of: all rollers, inner and outer links share one each, every
/// sprocket has its own.
struct PartOf
{
  PartOf(const Kind of, const unsigned int number = 0) : kind(of), sprocket(number) {}

  Kind         kind;
  unsigned int sprocket; ///< its number in Scene::sprockets, 0 for others

  bool operator<(const PartOf &other) const
  {
    return std::make_pair(kind, sprocket) < std::make_pair(other.kind, other.sprocket);
  }
};

/// How a body may move.
enum class Motion
{
  lumped,  ///< three translations of a rigid shape, and a spin about z if it has an inertia for it
  rigid,   ///< six degrees of freedom
  reduced, ///< the same and the modes of a basis, which move the nodes of the part's mesh
  elastic  ///< three degrees of freedom per node of the part's mesh; of a sprocket, of its rim
};

/// Whether bodies that move so deform: nodes of theirs touch.
constexpr bool deforms(const Motion motion)
{
  return motion == Motion::reduced || motion == Motion::elastic;
}

/// What holds a body.
struct Mount
{
  enum class Kind
  {
    free,     ///< in space
    fixed,    ///< it stands still
    motor,    ///< turns about an axis as its shaft says; without one it stands still
    revolute, ///< turns about an axis by the moments on it, those of its shaft among them
    prismatic ///< moves along an axis by the forces on it
  };
  Kind                            kind  = Kind::free;
  dealii::Tensor<1, 3>            axis  = {}; ///< unit
  std::optional<dealii::Point<3>> pivot = {}; ///< a point of the axis, m; empty: the body's origin
  std::optional<unsigned int>     carrier = {}; ///< a body on a mount whose origin is that of this
                                                ///< one and takes it along, without turning it

  static Mount free() { return {}; }
  static Mount fixed() { return {Kind::fixed, along_z()}; }
  static Mount motor() { return {Kind::motor, along_z()}; }       ///< about z
  static Mount revolute() { return {Kind::revolute, along_z()}; } ///< about z
  static Mount revolute(const dealii::Tensor<1, 3> &axis, const dealii::Point<3> &pivot)
  {
    return {Kind::revolute, axis, pivot};
  }
  static Mount prismatic(const dealii::Tensor<1, 3> &axis) { return {Kind::prismatic, axis}; }

  bool is_free() const { return kind == Kind::free; }

private:
  static dealii::Tensor<1, 3> along_z();
};

/// One instance of a part, placed in the world.
struct Body
{
  Kind                 kind;
  unsigned int         number; ///< of the roller's joint, the link, or in Scene::sprockets
  Motion               motion;
  Mount                mount;
  double               mass;    ///< kg
  dealii::Tensor<1, 3> inertia; ///< principal moments about the body's axes, kg m2
  Frame                initial; ///< at the start time
  /// A lumped body without inertia about z that turns with the line from the first of these bodies
  /// to the second, and hands them the moments on it.
  std::optional<std::array<unsigned int, 2>> turns_with = {};
  /// Where its part stands in its frame, along z, m: once for each strand that it belongs to.
  std::vector<double> parts_at = {0.};
  /// From 1 on, of a chain whose strands are separate; 0: it has one, or the body belongs to all.
  unsigned int strand = 0;

  PartOf part() const { return {kind, kind == Kind::sprocket ? number : 0}; }

  /// What field output tells bodies apart by: the number of the kind, on which sprockets count.
  int number_in_fields() const
  {
    return static_cast<int>(kind) + static_cast<int>(part().sprocket);
  }
};

/// What a shaft gives to a body on a hub.
struct Shaft
{
  unsigned int        body;
  int                 sense; ///< of its rotation in operation, +1: about +z
  drive::ShaftProgram program;
};

/// What presses an arm or a slide that carries a wheel, or a guide.
struct Tensioner
{
  unsigned int body;          ///< on a mount
  unsigned int number;        ///< its wheel in DriveView::sprockets, or of a guide its span
  int          sense;         ///< +1: travel is positive as the body's motion about or along its
                              ///< axis
  double              travel; ///< at the start
  drive::TensionerLaw law;
};

/// What moves an arm that carries a wheel.
struct Swing
{
  unsigned int       body;     ///< on a mount that is a motor
  unsigned int       sprocket; ///< its wheel, in DriveView::sprockets
  functions::Pointer angle;    ///< over time [s], about +z, rad
};

/// A torsion spring with a damper between a wheel and what is behind it.
struct Coupling
{
  unsigned int sprocket;  ///< in DriveView::sprockets
  unsigned int wheel;     ///< body on a mount
  unsigned int machine;   ///< body on a mount, behind it
  int          sense;     ///< of the torque on the machine while the drive drives, +1: about +z
  double       stiffness; ///< N m/rad
  double       damping;   ///< N m s/rad
  double       torque;    ///< on the wheel at the start, about +z, N m
};

/// Springs with dampers that hold the axis of a wheel: two bodies on mounts move along x and y,
/// the second one on the first one, and carry the wheel.
struct Bearing
{
  unsigned int                sprocket;           ///< in DriveView::sprockets
  std::array<unsigned int, 2> bodies;             ///< that move along x and along y
  std::array<double, 2>       stiffness, damping; ///< N/m and N s/m
  std::array<double, 2>       start;              ///< displacement at the start, m
  double weight; ///< that they bear where the displacement is zero, along -y, N
};

/// Who is there, what touches what, what pulls: a pure description, from which a World is made.
struct Scene
{
  std::vector<Body> bodies; ///< rollers first (in joint order), then links, sprockets, others
  std::vector<Bar>  bars;   ///< simple fidelity: bar k joins rollers k and k+1
  std::vector<std::shared_ptr<const ForceElement>> forces; ///< others than bars and contacts
  std::vector<Tensioner>                           tensioners;
  std::vector<Swing>                               swings;
  std::vector<Coupling>                            couplings;
  std::vector<Bearing>                             bearings;
  std::vector<OilFilms>                            oil; ///< one if there is oil, else none
  std::vector<BoreFamily>                          bores;
  std::vector<FaceFamily>                          faces;
  std::vector<ToothFamily>                         teeth;
  std::vector<SurfaceFamily>                       surfaces;
  std::vector<GuideFamily>                         guides;
  std::vector<SideFamily>                          sides;
  std::vector<ToothSideFamily>                     tooth_sides;
  parameters::Loads  loads;           ///< with the coefficients of effects that are off set to zero
  std::vector<Shaft> shafts;          ///< a hub without one stands still or turns freely
  double             start_time = 0.; ///< s
  double             prestress  = 0.; ///< N, in the spans at the start
  double start_overlap          = 0.; ///< m, of bodies that were laid in line and are not any more
  bool   half                   = false; ///< elastic bodies are halves, see mesh::Part::half
  bool   planar                 = false; ///< free bodies do not leave the plane z = const
  std::optional<drive::RollerRing> oval; ///< what rigid rollers become, if they do
  bool                             plates_bend = true;  ///< of elastic links, out of their planes
  bool                             at_speed    = false; ///< the drive starts at full speed
  std::map<PartOf, std::shared_ptr<const mesh::Part>>       parts;   ///< those that somebody needs
  std::map<PartOf, std::shared_ptr<const mesh::Sector>>     sectors; ///< of elastic sprockets
  std::map<PartOf, std::shared_ptr<const reduction::Basis>> bases;   ///< of reduced bodies
  /// Of reduced bodies of a part, what observers ask for of forces f on their nodes: g f, the sum
  /// over all nodes, with each of these g, three components for each node in body axes, see
  /// reduction::kept_static_responses().
  std::map<PartOf, std::vector<std::vector<double>>> measures;
  Material                                           material;
  parameters::Elements                               elements;
  model::Effects                                     effects;
  std::vector<std::string> notes; ///< what the log must say about choices made

  DriveView drive; ///< empty in a scene without a chain
  /// Where each strand has bodies of its own, that view of each, in the order of their places along
  /// z; one of them is #drive. Else empty.
  std::vector<DriveView> strands;

  /// How many strands the scene has bodies for.
  unsigned int n_strands() const
  {
    return strands.empty() ? 1 : static_cast<unsigned int>(strands.size());
  }

  bool has_elastic_bodies() const;

  /// From one of the driver's teeth to the next at its full speed, s; infinite where it stands.
  double pitch_time() const;

  MirrorSymmetry symmetry() const { return MirrorSymmetry(half); }

  /// What sentences call body @p b, such as "roller 5".
  std::string name_of(unsigned int b) const;

  /// Kinetic energy of the chain at the full speed of the drive, J: the scale of all energies.
  double nominal_energy() const;
};

/// What the body @p number of @p scene deflects on a round @p surface of its mesh without inertia;
/// null if nothing: then it touches others there by penalty.
const reduction::RoundFlexibility *
round_flexibility(const Scene &scene, unsigned int number, unsigned int surface);

/// The sides on which reduced bodies of one part touch others with their nodes.
std::set<unsigned int> sides_that_touch(const Scene &scene, const PartOf &of);

/// Whether @p bores are kept from overlapping by a penalty, since not all of their sides deflect
/// without inertia. Throws std::logic_error if some of the pairs have a penalty and others have
/// not.
bool has_penalty(const Scene &scene, const BoreFamily &bores);

/// Whether rollers and @p teeth are kept from overlapping by a penalty.
bool has_penalty(const Scene &scene, const ToothFamily &teeth);
} // namespace chaindrive::scene
