// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/model/model.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/scene/scene.h>

#include <functional>

namespace chaindrive::scene
{
/// The modes of a part whose bodies are reduced ones.
using BasisOf = std::function<std::shared_ptr<const reduction::Basis>(const mesh::Part &)>;

/// The scene of the fidelity that @p model asks for. A fidelity is nothing but a choice of
/// bodies, motions and interfaces; what comes after knows only those. Imported meshes are looked
/// for in @p folders. Without @p basis_of reduced bodies have no bases: such a scene is to look at.
/// Throws InputError for masses or meshes that cannot be.
Scene build_scene(const model::Model             &model,
                  const drive::Drive             &drive,
                  const std::vector<std::string> &folders,
                  const BasisOf                  &basis_of = {});

/// The simple model: one lumped roller of the mass of a pitch per joint, elastic bars between them.
/// With friction on the teeth the ring of each roller has a spin, or it could not roll; a bush
/// turns with its inner link.
void add_simple_chain(const model::Model &model, const drive::Drive &drive, Scene &scene);

/// The layered model: rigid rollers, inner and outer links with clearances between them. Plates and
/// joint contact act in series in the bush-pin interface. Without rollers bushes, which are one
/// with the inner links, are in their place.
void add_layered_chain(const model::Model &model, const drive::Drive &drive, Scene &scene);

/// The full model: the same bodies made of elastic finite elements, whose nodes touch; or only
/// those of Model::elastic_joints, the others as in the layered model or reduced. The reduced
/// model: the same with few modes in the place of the nodes' own motion. Without rollers nodes of
/// bushes are on the teeth.
void add_full_chain(const model::Model &model, const drive::Drive &drive, Scene &scene);

/// Finds the bases of reduced bodies and says what they keep.
void add_bases(const BasisOf &basis_of, Scene &scene);

/// Gives reduced bodies, whose parts must be there, the mass and inertia of their nodes.
void weigh_reduced_bodies(Scene &scene);

/// Angular velocity [rad/s] of the roller of joint @p k at the start: that of its sprocket or, in a
/// span and of a bush everywhere, of the inner link that carries it; zero unless the start is
/// settled.
double roller_spin(const drive::Drive &drive, unsigned int k);

/// Where the mass of the chain of @p drive is from that is not given, in words.
std::string source_of_mass(const drive::Drive &drive);

/// Rollers, where the chain has them, inner and outer links of a chain with clearances: elastic
/// where the effect is on and
/// @p elastic_joint says so of the roller's joint or of both joints of the link, else rigid.
void add_chain_bodies(const model::Model      &model,
                      const drive::Drive      &drive,
                      const std::vector<char> &elastic_joint,
                      Scene                   &scene);

/// Roller-bush and bush-pin interfaces of bodies that both are rigid, as in the layered model: none
/// where there are none.
void add_rigid_joints(const model::Model &model, const drive::Drive &drive, Scene &scene);

/// The oil between rigid rollers, the bushes in them and the teeth of all sprockets, which must be
/// there.
void add_oil_films(const model::Model &model, const drive::Drive &drive, Scene &scene);

/// A family of @p interface without law and pairs.
BoreFamily bores_of(Interface interface);

/// At joint k meet its roller, the inner link whose bush it is and the outer link whose pin it is.
struct Joint
{
  unsigned int roller;        ///< body; of a chain without rollers the inner link
  unsigned int inner, outer;  ///< bodies
  double       bush_x, pin_x; ///< of the bush's and the pin's axis in their links' frames, m
};

/// Joint @p k of the chain of @p view, whose bodies are those of add_chain_bodies().
Joint joint_of(unsigned int k, const drive::Drive &drive, const DriveView &view);

/// The sprockets and the interfaces of the rollers, which must be there, with their teeth.
void add_sprockets(const model::Model             &model,
                   const drive::Drive             &drive,
                   const std::vector<std::string> &folders,
                   Scene                          &scene);

/// The arm or slide of the tensioner of @p drive, if there is one, and its spring. The wheels must
/// be there.
void add_tensioner(const drive::Drive &drive, Scene &scene);

/// Adds the arms that move wheels as is prescribed.
void add_swings(const drive::Drive &drive, Scene &scene);

/// What is behind the couplings of the wheels of @p drive, and what carries those on bearings that
/// yield. The wheels must be there, and a tensioner.
void add_shafts(const drive::Drive &drive, Scene &scene);
/// What the plates of every joint touch a guide or a drum with: the round ends of inner plates, the
/// higher ones, about its axis. In the simple model they are lumped with the roller and do not turn
/// with its ring. In space there is one on each side. Links that move by nodes have none.
std::vector<SlavePoint> plates_of_joints(const drive::Drive &drive, const Scene &scene);

/// What inner links that move by nodes touch a guide or a drum with: the edges of their plates.
struct PlateNodes
{
  std::vector<SlavePoint> slaves; ///< the links, with how far they reach
  ContactLaw              law;    ///< per area
};
PlateNodes plate_nodes(const model::Model &model,
                       const drive::Drive &drive,
                       const Scene        &scene,
                       double              friction);

/// The guides of @p drive, which plates slide on. The wheels must be there.
void add_guides(const model::Model &model, const drive::Drive &drive, Scene &scene);

/// What wheels that are out of line need: the faces of plates, rollers and teeth, which keep bodies
/// in place across the plane of the drive; of elastic bodies their nodes. All else must be there,
/// of elastic links also the faces of plates on plates.
void add_sides(const model::Model &model, const drive::Drive &drive, Scene &scene);

/// Makes of @p scene, which has one strand with its share of all loads and is in line, one in which
/// each strand has rollers and inner links of its own, the transverse pitch apart, with contacts of
/// their own, on outer links that are one body of all strands: pins, rigid, pass through them all.
/// Shafts, springs and wheels have the whole of what they had the share of. All else must be there.
void separate_strands(const drive::Drive &drive, Scene &scene);

/// The unit normal of the plane of wheel number @p i.
Tensor3 normal_of_wheel(const drive::Drive &drive, unsigned int i);

/// Takes the wheels of @p drive out of the plane, and the chain with them. On a wheel the chain is
/// in the wheel's plane; a span, laid in line, is displaced by a cubic polynomial that leaves each
/// wheel in its plane (Hermite's). Links point from joint to joint, and twist from one plane to the
/// other. So spans are longer by 3 d^2 / (5 L) for an offset d, and pins somewhat askew in their
/// bushes: Scene::start_overlap. Throws InputError where a span would be askew by more than a tooth
/// guides.
void move_out_of_line(const drive::Drive &drive, Scene &scene);

/// The law per area of a contact of elastic bodies of @p steel whose elements below the surface are
/// @p thickness [m] thick: stiffness from the penalty factor, the rest as make_law() does.
ContactLaw make_area_law(const model::Contact &contact,
                         const Material       &steel,
                         double                thickness,
                         double                friction);

/// Of a ring, m2.
double ring_area(double outer_radius, double inner_radius);

/// The law per area of flat faces of elastic links that touch on an @p area [m2] each, with
/// elements
/// @p thickness [m] thick below: of bodies that move by nodes that of make_area_law(). Reduced ones
/// bend as softly, but have no mass so small that it could follow so stiff a face: theirs are
/// stiffer than a plate bends, model::Model::side_stiffness, by a factor.
ContactLaw
make_face_law(const model::Model &model, const drive::Drive &drive, double area, double thickness);

/// @p law in series with a foundation of @p modulus [N/m3], with the same damping ratio.
ContactLaw in_series(const ContactLaw &law, double modulus);

/// Lets the rigid teeth of @p teeth deflect by @p stiffness [N/m] under a roller of this @p radius
/// [m] that bears @p load [N] on the @p length [m]: one half of the compliance is that of the
/// surface, in series with the law of the contact, the other that of the tooth as a whole.
void make_compliant(ToothFamily    &teeth,
                    double          stiffness,
                    double          radius,
                    double          length,
                    double          load,
                    const Material &steel);

/// What a mesh is made for: to be elastic, or only for field output, where one cell reaches across
/// the chain from face to face unless the entries of the mesh say otherwise.
enum class MeshUse
{
  elastic,
  picture
};

/// Meshes of parts; of a chain without rollers that of a roller is its bush between the plates.
std::shared_ptr<const mesh::Part>
make_roller_part(const model::Meshes &, const drive::Drive &, MeshUse use = MeshUse::elastic);
std::shared_ptr<const mesh::Part> make_link_part(const model::Meshes &,
                                                 const drive::Drive &,
                                                 bool    inner,
                                                 MeshUse use = MeshUse::elastic);
std::shared_ptr<const mesh::Part> make_sprocket_part(const model::Meshes &,
                                                     const drive::Drive &,
                                                     const drive::Sprocket &,
                                                     MeshUse use);

/// A penalty law for an interface of stiffness @p k [N/m] and this coefficient of @p friction
/// between bodies whose reduced mass is @p mass [kg]: damping and tangential terms from @p contact.
ContactLaw make_law(const model::Contact &contact, double k, double mass, double friction);
} // namespace chaindrive::scene
