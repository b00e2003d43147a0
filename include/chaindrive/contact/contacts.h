// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/family.h>
#include <chaindrive/contact/near_flanks.h>
#include <chaindrive/contact/search_cadence.h>
#include <chaindrive/utilities/pointer_list.h>
#include <chaindrive/utilities/to_first_rank.h>

#include <deal.II/base/array_view.h>

#include <string>
#include <vector>

namespace chaindrive::contact
{
/// How often the search ran.
struct SearchStatistics
{
  unsigned long searches = 0, evaluations = 0;
};

/// Lost in an interface, J: parts of the ledger's lines `friction` and `contact_damping`.
struct Loss
{
  double friction = 0., damping = 0.;
};

/// All interfaces of the scene behind one call, add_forces().
///
/// The search is driven by displacement: it lists the pairs closer than a reach, and runs again
/// before any two bodies can have come nearer to each other by that reach. To that end the largest
/// speed of any body, doubled because two bodies may approach each other, is summed over time; a
/// pair that could touch is therefore never missed. On request it runs at every evaluation.
class Contacts
{
public:
  Contacts(const scene::Scene &scene, World &world, bool search_every_step);

  /// Adds this rank's share of the contact forces; @p dt is the time since the last call [s], zero
  /// at the first one. Collective.
  void add_forces(World &world, double dt);

  /// What this rank has lost in each interface at the last add_forces(), friction and damping in
  /// turn [J]: World::sum_over_ranks() makes totals of it, which book_losses() then books.
  dealii::ArrayView<double> lost_now() { return {lost_now_.data(), lost_now_.size()}; }
  void                      book_losses();

  /// Lost in each of families() since the start.
  const std::vector<Loss> &losses() const { return losses_; }

  /// Brings the records of all pairs that are near to the first rank: one message from each other,
  /// which goes on. Collective.
  void gather_records(const World &world);

  /// What searches and pairs remember between two steps. Collective.
  void serialize(const Archive &archive, World &world);

  /// The springs of all pairs within reach, held closed.
  void add_springs(const World &world, std::vector<Spring> &springs) const;

  /// Refuses (InputError) a start with surfaces that overlap by more than a nanometre, unless the
  /// contact force there is no more than the @p prestress [N] of the chain: names the interface,
  /// the joint and the penetration. @p overlap [m] more is accepted everywhere.
  void refuse_penetration(World &world, double prestress, double overlap = 0.);

  const PointerList<Family> &families() const { return families_; }

  /// Family::reads_frames() of any of them.
  bool reads_frames() const { return reads_frames_; }

  /// The families of @p interface: one for rigid bodies, one for elastic ones, or none.
  std::vector<const Family *> find(const scene::InterfaceOf &interface) const;

  /// Those of all strands.
  std::vector<const Family *> find_all(const scene::InterfaceOf &interface) const;

  /// Contacts of elastic nodes that the searches of this rank have missed: see Family.
  unsigned long n_missed() const;

  /// What is to be said where forces have been larger than those for which the limit of the step
  /// holds; empty where none were, and where @p step, over that limit, is so short that it is
  /// bounded under any force that a chain bears. Collective.
  std::string overload_sentence(const World &world, double step) const;

  const SearchStatistics &search_statistics() const { return statistics_; }
  std::size_t             memory_consumption() const;

private:
  /// Returns whether it was.
  bool search_if_due(World &world, double dt);

  OwningList<Family>               families_;
  bool                             every_step_;
  bool                             needs_search_ = false;
  bool                             reads_frames_;
  double                           reach_;   ///< m
  SearchCadence                    cadence_; ///< of approach, m
  NearFlanks                       near_flanks_;
  SearchStatistics                 statistics_;
  std::vector<double>              lost_now_;
  std::vector<Loss>                losses_;
  unsigned long                    missed_before_ = 0; ///< the run was resumed, by any rank
  std::vector<std::vector<double>> messages_;    ///< of gather_records(), by rank, on the first
  ToFirstRank                      own_records_; ///< on others
};
} // namespace chaindrive::contact
