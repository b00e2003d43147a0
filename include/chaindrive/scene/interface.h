// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/stiffness.h>
#include <chaindrive/parameters/choice.h>
#include <chaindrive/scene/contact_law.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
struct ToothForm;
}

namespace chaindrive::mesh
{
class FacetSurface;
}

namespace chaindrive::path
{
class Curve;
}

namespace chaindrive::reduction
{
struct RimModes;
}

namespace chaindrive::contact
{
class Surface;
}

namespace chaindrive::scene
{
/// Which two surfaces touch.
enum class Interface
{
  roller_teeth, ///< of a sprocket, whose name the family has behind the text
  roller_bush,
  bush_pin,
  plate_faces,
  plate_teeth, ///< of a sprocket, as above: inner plates and the sides of its teeth
  roller_ends, ///< rollers and inner plates
  other        ///< of what is no chain drive
};
} // namespace chaindrive::scene

namespace chaindrive::parameters
{
template <>
inline constexpr Texts<scene::Interface, 7> texts_of<scene::Interface>{
    {{scene::Interface::roller_teeth, "roller"},
     {scene::Interface::roller_bush, "roller-bush"},
     {scene::Interface::bush_pin, "bush-pin"},
     {scene::Interface::plate_faces, "plate faces"},
     {scene::Interface::plate_teeth, "plate"},
     {scene::Interface::roller_ends, "roller-plate"},
     {scene::Interface::other, "surface"}}};
} // namespace chaindrive::parameters

namespace chaindrive::scene
{
/// Which interface a family is, by which those who look at contacts find it. Where strands
/// are separate, each has families of its own, which share their names.
struct InterfaceOf
{
  InterfaceOf(const Interface of, const unsigned int body = 0, const unsigned int strand = 0)
      : interface(of), sprocket(body), strand(strand)
  {
  }

  Interface    interface;
  unsigned int sprocket; ///< the body whose teeth they are, 0 for others
  unsigned int strand;   ///< DriveView::strand of the chain

  bool operator==(const InterfaceOf &other) const
  {
    return is_like(other) && strand == other.strand;
  }

  /// The same of any strand.
  bool is_like(const InterfaceOf &other) const
  {
    return interface == other.interface && sprocket == other.sprocket;
  }
};

/// What the interface of the rollers with the teeth of @p sprocket is called.
inline std::string name_of_teeth(const std::string &sprocket)
{
  return parameters::text_of(Interface::roller_teeth) + "-" + sprocket;
}

/// The same of the inner plates with the sides of its teeth.
inline std::string name_of_sides(const std::string &sprocket)
{
  return parameters::text_of(Interface::plate_teeth) + "-" + sprocket;
}

constexpr double right_angle = 0.5 * dealii::numbers::PI;
constexpr double any_force   = std::numeric_limits<double>::infinity();

/// A point of a body's axis that carries a radius: the slave side of a rigid cylinder.
struct SlavePoint
{
  unsigned int     body;
  dealii::Point<3> point;  ///< in the body's frame, m
  double           radius; ///< m; 0 for a mesh node
  unsigned int     joint;  ///< joint of the chain it belongs to
};

/// A slave point inside a cylindrical bore of a master body; the bore's axis is the body's z axis.
struct BorePair
{
  unsigned int     master;
  dealii::Point<3> axis;   ///< a point of the bore's axis in the master's frame, m
  double           radius; ///< of the bore, m
  SlavePoint       slave;

  unsigned int master_surface = 0, slave_surface = 0; ///< of elastic bodies: sides of their meshes
};

/// All bores of one kind in the scene: roller-bush or bush-pin.
struct BoreFamily
{
  std::string           name; ///< in words
  Interface             interface = Interface::other;
  ContactLaw            law; ///< of elastic bodies, whose nodes touch: per m2
  std::vector<BorePair> pairs;
  bool         elastic    = false; ///< nodes touch: one of each two bodies is elastic at least
  double       half_angle = right_angle;  ///< up to which nodes touch under the largest forces, rad
  double       largest_force = any_force; ///< N: those
  unsigned int strand        = 0;         ///< see InterfaceOf
  /// Of rigid bodies in the plane: of all points of a pair together, instead of the law's
  /// stiffness.
  std::optional<drive::StiffnessCurve> curve = {};
};

/// Two elastic bodies whose faces across z may touch round a common axis along z.
struct FacePair
{
  unsigned int     master, slave;                 ///< bodies
  unsigned int     master_surface, slave_surface; ///< sides of their meshes, at z < 0 and z > 0
  dealii::Point<3> master_axis, slave_axis;       ///< a point of the axis in the body's frame, m
  unsigned int     joint;
};

/// All faces of one kind in the scene.
struct FaceFamily
{
  std::string           name; ///< in words
  Interface             interface = Interface::other;
  ContactLaw            law;    ///< per m2
  double                radius; ///< about the axis, in which the master's face is a full ring, m
  std::vector<FacePair> pairs;
};

/// A point of a rigid body that may touch a flat face of another one, across that body's z axis.
struct SidePair
{
  unsigned int master;
  double       z;    ///< of the face in the master's frame, m
  int          sign; ///< of the z towards which the face looks
  SlavePoint   slave;
};

/// All flat faces of one kind of rigid bodies.
struct SideFamily
{
  std::string           name; ///< in words
  Interface             interface = Interface::other;
  ContactLaw            law; ///< of one point
  std::vector<SidePair> pairs;
  unsigned int          strand = 0; ///< see InterfaceOf
};

/// The sides of a sprocket's teeth, rounded towards their tips, and all points of inner plates that
/// could ever meet them. Between teeth the sides go on: what meets them there has a tooth beside.
struct ToothSideFamily
{
  std::string             name;                   ///< in words
  unsigned int            sprocket;               ///< body
  double                  half_width, tip_radius; ///< m
  double                  relief, radius;         ///< of the rounding: its height and radius, m
  ContactLaw              law;                    ///< of one point
  std::vector<SlavePoint> slaves;                 ///< on the inner faces of plates: at z > 0 they
                                                  ///< meet the side at z > 0

  /// The slaves are elastic links, about whose centres spheres hold all that may touch; the law is
  /// per m2.
  bool                      elastic       = false;
  unsigned int              slave_surface = 0;  ///< the side of their mesh that touches
  std::vector<unsigned int> slave_nodes   = {}; ///< the nodes of it that may, of the part

  unsigned int strand = 0;  ///< see InterfaceOf
  double       z      = 0.; ///< of the middle plane of these teeth in the sprocket's frame, m
};

/// The toothed rim of a sprocket that has inertia: from a rigid hub to the teeth.
struct InertRim
{
  double bore, hub_diameter, width; ///< of the sprocket or of the half that is computed, m
  double modes_up_to;               ///< rad/s
};

/// The flanks of one sprocket and every roller that could ever meet them.
struct ToothFamily
{
  std::string                               name;     ///< in words
  unsigned int                              sprocket; ///< master body
  std::shared_ptr<const drive::ToothForm>   form;     ///< exact arcs
  std::shared_ptr<const mesh::FacetSurface> facets;   ///< of an imported mesh; null: the arcs rule
  unsigned int                              teeth;    ///< of the sprocket
  double                                    outer_radius; ///< of the sprocket, m
  double                                    half_width;   ///< of the sprocket, m
  ContactLaw                                law; ///< of elastic rollers, whose nodes touch: per m2
  bool                                      elastic = false; ///< the slaves are elastic bodies
  bool         at_centres    = false; ///< forces act at the centres of slaves: plates on a drum
  unsigned int slave_surface = 0;     ///< of elastic slaves: the side of their mesh that touches
  std::vector<SlavePoint> slaves;
  double tooth_stiffness = 0.;   ///< of a rigid sprocket's tooth and rim behind the contact with an
                                 ///< elastic slave, N/m; 0: they do not deflect
  double loaded_half_angle = 0.; ///< of the contact in the seat where it is that, rad
  /// The same at places of the seat, of contact without penalty; empty: it is that everywhere.
  std::vector<drive::PlacedStiffness> tooth_places = {};
  /// Of contact without penalty, with places: a rim with inertia, and its modes, which are part of
  /// what these places deflect. Who builds a system finds the modes of the rims of a scene.
  std::optional<InertRim>                    inert_rim = {};
  std::shared_ptr<const reduction::RimModes> rim_modes = {};
  double half_angle = right_angle; ///< up to which round slaves touch under the largest forces, rad
  double half_line  = right_angle; ///< and on a straight flank, rad
  double sticking_stiffness = 0.;  ///< of friction on a roller without penalty, N/m
  double largest_force      = any_force; ///< N: those
  unsigned int strand       = 0;         ///< see InterfaceOf
  double       z            = 0.; ///< of the middle plane of these teeth in the sprocket's frame, m
  /// Of rigid rollers in the plane: of all points of a roller together, instead of the law's
  /// stiffness.
  std::optional<drive::StiffnessCurve> curve = {};
};

/// Slaves that may meet a surface of some body: what needs no chain, such as a block on an incline
/// or a belt on a drum.
struct SurfaceFamily
{
  std::string                             name;
  std::shared_ptr<const contact::Surface> surface;
  ContactLaw                              law; ///< of elastic slaves, whose nodes touch: per m2
  std::vector<SlavePoint>                 slaves;
  bool                                    elastic = false; ///< the slaves are elastic bodies
  unsigned int slave_surface     = 0;  ///< of elastic slaves: the side of their mesh that touches
  double       surface_stiffness = 0.; ///< of a rigid surface that deflects as a whole under each
                                       ///< elastic slave, N/m; 0: it does not
  double half_angle = right_angle; ///< up to which round slaves touch under the largest forces, rad
  InterfaceOf               interface   = Interface::other;
  std::vector<unsigned int> slave_nodes = {}; ///< of that side those that may touch; empty: all
};

/// A guide and all plates that could ever slide on it.
struct GuideFamily
{
  std::string                        name;  ///< in words
  unsigned int                       body;  ///< whose frame the line is in
  std::shared_ptr<const path::Curve> curve; ///< on which the edges of plates slide
  ContactLaw                         law;
  std::vector<SlavePoint>            slaves;
  bool at_centres = false; ///< forces act at the centres of slaves, which plates do not turn
  bool elastic    = false; ///< nodes of the edges of plates touch: the law is per m2, and the guide
                           ///< deflects as a whole under each link
  double stiffness = 0.;   ///< of that, N/m
  double depth     = 0.;   ///< the guide is a strip twice as thick behind its line, for nodes, m
};

/// A massless elastic bar between the centres of two bodies.
struct Bar
{
  unsigned int first, second;
  double       length;    ///< unloaded, m
  double       stiffness; ///< N/m
  double       damping;   ///< N s/m
};
} // namespace chaindrive::scene
