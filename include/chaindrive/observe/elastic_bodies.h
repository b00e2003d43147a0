// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/system.h>
#include <chaindrive/observe/plate_stress.h>
#include <chaindrive/scene/scene.h>

#include <map>
#include <memory>
#include <vector>

namespace chaindrive::observe
{
/// An elastic body at one instant, in the numbering of its part's mesh.
struct ElasticSnapshot
{
  std::vector<dealii::Tensor<1, 3>> displacement; ///< per vertex, world axes, m
  std::vector<dealii::Tensor<1, 3>> velocity;     ///< per vertex, m/s, half a step before
  std::vector<element::Stress>      stress;       ///< per cell
  std::vector<element::FaceStresses>
                      faces; ///< per cell of a part with solid-shells, zero in its solid elements
  std::vector<double> pressure = {}; ///< of contacts per vertex, Pa; not filled in here
};

/// Whether elastic bodies of one of these @p kinds are in the scene.
bool has_elastic(const scene::Scene             &scene,
                 const dynamics::System         &system,
                 const std::vector<scene::Kind> &kinds);

/// Angular velocity [rad/s] about the z axis through its centre of mass of a @p body that moves by
/// nodes and that this rank owns: of its angular momentum over its moment of inertia as it is now.
double spin_of_nodes(const dynamics::System &system, unsigned int body);

/// Displacement, velocity and stress everywhere in elastic bodies.
class ElasticSnapshots
{
public:
  explicit ElasticSnapshots(const dynamics::System &system);

  /// Of an elastic body, or of a sector of a rim, that this rank owns; with a @p deflection [m,
  /// world] of its nodes beside its modes (MasslessDeflections), unless that is null.
  ElasticSnapshot of(const dynamics::System                  &system,
                     const World::Address                    &place,
                     const std::vector<dealii::Tensor<1, 3>> *deflection = nullptr) const;

private:
  /// By group of copies.
  std::map<unsigned int, std::vector<std::unique_ptr<const element::StressRecovery>>> cells_;
};

/// Makes reduced links whose joints have no penalty measure the stresses of their waists in
/// statics (scene::Scene::measures): their modes lack up to a quarter of them. Collective.
void measure_waists(scene::Scene &scene, MPI_Comm comm);

/// The waists of the side plates of elastic links. Modal bodies strain in proportion
/// to them: each mode has its stresses, which are added, and the squares of strains are left out.
/// After measure_waists() they have those of their forces in statics, less what their modes take
/// for their acceleration (reduction::kept_static_responses()).
class Waists
{
public:
  Waists(const scene::Scene &scene, const dynamics::System &system);

  /// What this rank knows of the stresses in an elastic link @p body: the sum over all ranks is
  /// all.
  WaistComponents components(const dynamics::System &system, unsigned int body) const;

  /// Stresses in an elastic link @p body all of whose nodes this rank has.
  WaistStress stress(const dynamics::System &system, const unsigned int body) const
  {
    return stress_of(components(system, body));
  }

private:
  struct Plates
  {
    PlateStress                  from_nodes;
    const ModalGroup            *modal = nullptr;  ///< null: nodal bodies
    std::vector<WaistComponents> of_modes;         ///< per amplitude of a mode
    std::vector<WaistComponents> of_accelerations; ///< of a mode; none without measures
  };

  std::map<unsigned int, Plates> plates_; ///< by group of copies
};

/// The outsides of elastic rollers.
class RollerSurfaces
{
public:
  RollerSurfaces(const scene::Scene &scene, const dynamics::System &system);

  /// Velocity [m/s] of the surface node of an elastic roller @p body, half a step before: of the
  /// node in the chain's middle plane that lies farthest along the tight span's normal at the
  /// start.
  dealii::Tensor<1, 3> velocity(const dynamics::System &system, unsigned int body) const;

private:
  std::map<unsigned int, unsigned int> nodes_; ///< by body
};
} // namespace chaindrive::observe
