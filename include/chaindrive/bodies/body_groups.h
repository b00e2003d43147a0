// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/elastic_group.h>
#include <chaindrive/utilities/pointer_list.h>

#include <deal.II/base/exceptions.h>

#include <memory>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace chaindrive
{
/// What is true of a class of body groups that can be added to BodyGroups: what is not would
/// compile, and its bodies would stand still or never touch.
template <typename Group>
struct GroupRules
{
  template <typename Interface>
  static constexpr bool implements = std::is_base_of_v<Interface, Group>;

  /// The group is known by its own class: of a base class its capabilities could not be told.
  static constexpr bool is_complete =
      implements<BodyGroup> && !std::is_same_v<Group, BodyGroup> && !std::is_abstract_v<Group>;

  /// Elastic bodies move by their nodes or by modes.
  static constexpr bool moves_one_way =
      implements<ElasticGroup> == (implements<NodalGroup> != implements<ModalGroup>);

  /// Nodes of bodies that move by modes do not move by themselves: somebody must place them.
  static constexpr bool places_its_nodes = !implements<ModalGroup> || implements<SurfaceGroup>;

  /// It moves something, or has a capability.
  static constexpr bool does_something =
      !std::is_same_v<decltype(&Group::kick), decltype(&BodyGroup::kick)> ||
      !std::is_same_v<decltype(&Group::drift), decltype(&BodyGroup::drift)> ||
      !std::is_same_v<decltype(&Group::finish), decltype(&BodyGroup::finish)> ||
      implements<ForceGroup> || implements<SurfaceGroup> || implements<ElasticGroup>;
};

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
    using Rules = GroupRules<Group>;
    static_assert(Rules::is_complete, "a group is added by its own class, derived from BodyGroup");
    static_assert(Rules::moves_one_way, "an ElasticGroup is a NodalGroup or a ModalGroup");
    static_assert(Rules::places_its_nodes, "a ModalGroup is a SurfaceGroup as well");
    static_assert(Rules::does_something,
                  "a group has a capability, or overrides kick(), drift() or finish()");
    Group &added = *group;
    AssertThrow(typeid(added) == typeid(Group),
                dealii::ExcMessage("A group is added by its own class."));
    list<Group>(added, force_);
    list<Group>(added, surface_);
    list<Group>(added, elastic_);
    list<Group>(added, nodal_);
    list<Group>(added, modal_);
    list<Group>(added, shared_);
    all_.push_back(std::move(group));
    return added;
  }

  PointerList<BodyGroup>          &all() { return all_; }
  const PointerList<BodyGroup>    &all() const { return all_; }
  PointerList<ForceGroup>         &force() { return force_; }
  const PointerList<ForceGroup>   &force() const { return force_; }
  PointerList<SurfaceGroup>       &surface() { return surface_; }
  const PointerList<SurfaceGroup> &surface() const { return surface_; }
  PointerList<ElasticGroup>       &elastic() { return elastic_; }
  const PointerList<ElasticGroup> &elastic() const { return elastic_; }
  PointerList<NodalGroup>         &nodal() { return nodal_; }
  const PointerList<NodalGroup>   &nodal() const { return nodal_; }
  PointerList<ModalGroup>         &modal() { return modal_; }
  const PointerList<ModalGroup>   &modal() const { return modal_; }
  PointerList<SharedGroup>        &shared() { return shared_; }
  const PointerList<SharedGroup>  &shared() const { return shared_; }

private:
  template <typename Group, typename Interface>
  static void list(Group &group, PointerList<Interface> &of)
  {
    if constexpr (std::is_base_of_v<Interface, Group>)
      of.push_back(&group);
  }

  OwningList<BodyGroup>     all_;
  PointerList<ForceGroup>   force_;
  PointerList<SurfaceGroup> surface_;
  PointerList<ElasticGroup> elastic_;
  PointerList<NodalGroup>   nodal_;
  PointerList<ModalGroup>   modal_;
  PointerList<SharedGroup>  shared_;
};
} // namespace chaindrive
