// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/observe/massless_deflections.h>
#include <chaindrive/utilities/gather_all.h>

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
      parts_.emplace(group->copies(),
                     Part{std::make_unique<reduction::FreePart>(
                              *copies.part,
                              copies.nodes,
                              element::ElasticPart(
                                  *copies.part, copies.nodes, scene.material, scene.elements)),
                          &basis});
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

  struct Loaded
  {
    std::vector<unsigned int>      bodies;
    std::vector<reduction::Vector> forces; // on each of them, in its axes
  };
  std::map<unsigned int, Loaded>      loaded; // by part
  std::map<unsigned int, std::size_t> place;  // of bodies there
  for (const contact::NodeForce &at : gather_all(std::move(own), world.communicator()))
    {
      const unsigned int group = world.elastic_address[at.body].group;
      const auto         part  = parts_.find(group);
      if (part == parts_.end() || !world.owns(at.body))
        continue;
      Loaded &of_part            = loaded[group];
      const auto [known, is_new] = place.try_emplace(at.body, of_part.bodies.size());
      if (is_new)
        {
          of_part.bodies.push_back(at.body);
          of_part.forces.emplace_back(part->second.free->n_unknowns());
        }
      const dealii::Tensor<1, 3> in_body = transpose(world.frames[at.body].rotation) * at.force;
      for (unsigned int d = 0; d < 3; ++d)
        of_part.forces[known->second][3 * at.node + d] += in_body[d];
    }
  for (const auto &[group, of_part] : loaded)
    {
      const Part                          &part = parts_.at(group);
      const std::vector<reduction::Vector> u =
          reduction::massless_displacements(*part.free, *part.basis, of_part.forces);
      for (std::size_t b = 0; b < u.size(); ++b)
        {
          const unsigned int                 body       = of_part.bodies[b];
          std::vector<dealii::Tensor<1, 3>> &deflection = deflections[body];
          deflection.reserve(u[b].size() / 3);
          for (unsigned int i = 0; i < u[b].size(); i += 3)
            deflection.push_back(world.frames[body].rotation *
                                 dealii::Tensor<1, 3>({u[b][i], u[b][i + 1], u[b][i + 2]}));
        }
    }
  return deflections;
}
} // namespace chaindrive::observe
