// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/spring.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/pointer_list.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive
{
/// What pulls or turns two bodies without contact: a bar, a spring, a stop. It knows its bodies by
/// their numbers, books its energies in the ledger, and announces its springs for the step limit. A
/// scene lists those that it has (scene::Scene::forces); each System works on copies of its own.
class ForceElement
{
public:
  ForceElement()          = default;
  virtual ~ForceElement() = default;

  virtual std::unique_ptr<ForceElement> clone() const = 0;

  /// What sentences call it, such as "torsion spring".
  virtual std::string name() const = 0;

  /// Adds its forces and moments at the present state, equal and opposite on both bodies; books the
  /// energy that it stores (Ledger::spring) and what it has lost since the last call
  /// (Ledger::spring_damping). @p dt is the time since then [s], 0 at the first call.
  virtual void add_forces(World &world, double dt) = 0;

  /// The forces [N] on its bodies at the last call of add_forces(), for who looks for faults.
  virtual std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>> forces() const { return {}; }

  /// What it has lost since the start [J], as far as losses are told by #name(); empty: they are
  /// those of all other force elements. Known to the first rank.
  virtual std::optional<double> lost() const { return {}; }

  /// Its springs at the present state, as stiff as they can become, for the critical time step.
  virtual void add_springs(const World &world, std::vector<Spring> &springs) const = 0;

  /// What it remembers from step to step.
  virtual void serialize(const Archive &archive) = 0;

protected:
  ForceElement(const ForceElement &)            = default;
  ForceElement &operator=(const ForceElement &) = default;
};

using ForceElements = OwningList<ForceElement>;
} // namespace chaindrive
