// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/observe/massless_deflections.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/vector.hpp>

namespace chaindrive::observe
{
MasslessDeflections::MasslessDeflections(const scene::Scene &scene, const dynamics::System &system)
{
  for (const ModalGroup *group : system.world.groups.modal())
    {
      const BodyBatches      &copies = system.world.copies[group->copies()];
      const reduction::Basis &basis  = *scene.bases.at(scene.bodies[copies.bodies.front()].part());
      if (basis.joints.empty())
        continue;
      auto free = std::make_unique<reduction::FreePart>(
          *copies.part,
          copies.nodes,
          element::ElasticPart(*copies.part, copies.nodes, scene.material, scene.elements));
      free->expect_many_forces();
      parts_.emplace(group->copies(), Part{std::move(free), &basis});
    }
}

std::map<unsigned int, std::vector<dealii::Tensor<1, 3>>>
MasslessDeflections::now(const dynamics::System &system) const
{
  std::map<unsigned int, std::vector<dealii::Tensor<1, 3>>> deflections;
  if (parts_.empty())
    return deflections;
  const World                    &world = system.world;
  std::vector<contact::NodeForce> own;
  for (const auto &family : system.contacts.families())
    if (family->is_distributed() || world.is_first_rank())
      family->add_massless_forces(world, own);

  std::map<unsigned int, reduction::Vector> forces; // by body, in its axes
  for (const auto &of_rank : dealii::Utilities::MPI::all_gather(world.communicator(), own))
    for (const contact::NodeForce &at : of_rank)
      {
        const auto part = parts_.find(world.elastic_address[at.body].group);
        if (part == parts_.end() || !world.owns(at.body))
          continue;
        reduction::Vector &force = forces[at.body];
        if (force.size() == 0)
          force.reinit(part->second.free->n_unknowns());
        const dealii::Tensor<1, 3> in_body = transpose(world.frames[at.body].rotation) * at.force;
        for (unsigned int d = 0; d < 3; ++d)
          force[3 * at.node + d] += in_body[d];
      }
  for (const auto &[body, force] : forces)
    {
      const Part             &part = parts_.at(world.elastic_address[body].group);
      const reduction::Vector u = reduction::massless_displacement(*part.free, *part.basis, force);
      std::vector<dealii::Tensor<1, 3>> &deflection = deflections[body];
      deflection.reserve(u.size() / 3);
      for (unsigned int i = 0; i < u.size(); i += 3)
        deflection.push_back(world.frames[body].rotation *
                             dealii::Tensor<1, 3>({u[i], u[i + 1], u[i + 2]}));
    }
  return deflections;
}
} // namespace chaindrive::observe
