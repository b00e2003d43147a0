// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>

#include <deal.II/base/mpi.h>

// How often contacts were searched for, and whether one was missed.

namespace chaindrive::observe
{
namespace
{
class Search : public Quantity
{
public:
  using Quantity::Quantity;

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &) { return true; }

  static Contents contents()
  {
    return {{},
            {{"contacts_missed",
              "1",
              "nodes that a search found to overlap without having been visited before"},
             {"searches", "1", "searches for contacts"}}};
  }

  bool reads_contacts() const override { return false; }

  void summarize(files::Json &summary) const override
  {
    const contact::Contacts &contacts = now_.system.contacts;
    if (now_.system.world.has_elastic_bodies())
      summary["contacts_missed"] =
          dealii::Utilities::MPI::sum(contacts.n_missed(), now_.system.world.communicator());
    summary["searches"] = contacts.search_statistics().searches;
  }
};

const Registered<Search>
    registered_search({"search", "How often contacts were searched for.", {"engagements"}});
} // namespace
} // namespace chaindrive::observe
