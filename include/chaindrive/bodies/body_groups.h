// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/elastic_group.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace chaindrive
{
/// The groups of a world in the order in which they are called, and again under each interface that
/// they implement: who needs a capability finds here those that have it and asks none of the
/// others. Lists keep the order of all().
class BodyGroups
{
public:
  /// Takes over @p group, and lists it under what its class @p Group implements.
  template <typename Group>
  Group &add(std::unique_ptr<Group> group)
  {
    Group &added = *group;
    list<Group>(added, force_);
    list<Group>(added, surface_);
    list<Group>(added, elastic_);
    list<Group>(added, nodal_);
    list<Group>(added, modal_);
    all_.push_back(std::move(group));
    return added;
  }

  const std::vector<std::unique_ptr<BodyGroup>> &all() const { return all_; }
  const std::vector<ForceGroup *>               &force() const { return force_; }
  const std::vector<SurfaceGroup *>             &surface() const { return surface_; }
  const std::vector<ElasticGroup *>             &elastic() const { return elastic_; }
  const std::vector<NodalGroup *>               &nodal() const { return nodal_; }
  const std::vector<ModalGroup *>               &modal() const { return modal_; }

private:
  template <typename Group, typename Interface>
  static void list(Group &group, std::vector<Interface *> &of)
  {
    if constexpr (std::is_base_of_v<Interface, Group>)
      of.push_back(&group);
  }

  std::vector<std::unique_ptr<BodyGroup>> all_;
  std::vector<ForceGroup *>               force_;
  std::vector<SurfaceGroup *>             surface_;
  std::vector<ElasticGroup *>             elastic_;
  std::vector<NodalGroup *>               nodal_;
  std::vector<ModalGroup *>               modal_;
};
} // namespace chaindrive
