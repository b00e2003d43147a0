// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>

// The ledger, of all strands. Histories have the lines that the scene's effects can fill, the
// summary has all.

namespace chaindrive::observe
{
namespace
{
struct Line
{
  const char *name;
  double Ledger::*term;
  bool (*is_there)(const Observation &now); ///< whether anything can fill the line
  const char *description;
};

bool always(const Observation &) { return true; }
bool elastic(const Observation &now) { return now.scene.has_elastic_bodies(); }
bool with_forces(const Observation &now) { return !now.system.forces.empty(); }
bool nodal(const Observation &now) { return now.system.world.n_nodal_groups() > 0; }

template <model::Effect effect>
bool with(const Observation &now)
{
  return now.scene.effects.is_on(effect);
}

constexpr Line lines[] = {
    {"kinetic", &Ledger::kinetic, always, "Of all bodies but the prescribed hub"},
    {"potential",
     &Ledger::potential,
     with<model::Effect::gravity>,
     "Of gravity, zero at the start"},
    {"bar", &Ledger::bar, with<model::Effect::chain_bars>, "Strain energy of the bars"},
    {"strain", &Ledger::strain, elastic, "Strain energy of elastic bodies"},
    {"hourglass",
     &Ledger::hourglass,
     nodal,
     "In the hourglass stiffness of elastic bodies; physical bending for the enhanced elements"},
    {"contact", &Ledger::contact, always, "Stored in the contact springs"},
    {"spring", &Ledger::spring, with_forces, "Stored in force elements other than bars"},
    {"friction_loss",
     &Ledger::friction,
     with<model::Effect::friction>,
     "Lost by friction since the start"},
    {"contact_damping_loss",
     &Ledger::contact_damping,
     with<model::Effect::contact_damping>,
     "Lost by contact damping since the start"},
    {"chain_damping_loss",
     &Ledger::chain_damping,
     with<model::Effect::chain_damping>,
     "Lost in the bars' dashpots since the start"},
    {"drag_loss", &Ledger::drag, with<model::Effect::drag>, "Lost by drag since the start"},
    {"spring_damping_loss",
     &Ledger::spring_damping,
     with_forces,
     "Lost in force elements other than bars since the start"}};

class Energy : public Quantity
{
public:
  using Quantity::Quantity;

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &) { return true; }

  static Contents contents()
  {
    Contents contents;
    for (const Line &line : lines)
      {
        const std::string path = std::string("energy/") + line.name;
        contents.histories.push_back({path, "J", line.description});
        contents.summary.push_back({path, "J", line.description});
      }
    contents.histories.insert(
        contents.histories.end(),
        {{"energy/drive_work", "J", "Of the driver on the chain since the start"},
         {"energy/resisting_work", "J", "Against the load torque since the start"},
         {"energy/imbalance", "J", "Stored and lost less supplied: the error of the balance"}});
    contents.summary.push_back({"drive_work", "J", "work of the driver"});
    contents.summary.push_back({"resisting_work", "J", "work against the load"});
    return contents;
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    const Ledger &ledger  = now_.system.world.ledger;
    const double  strands = now_.scene.drive.strands;
    const auto    term    = [&](const std::string &name, double Ledger::*value) {
      channels.add("energy/" + name, [&ledger, value, strands](const Channels::Row row) {
        row[0] = strands * ledger.*value;
      });
    };
    for (const Line &line : lines)
      if (line.is_there(now_))
        term(line.name, line.term);
    term("drive_work", &Ledger::drive_work);
    term("resisting_work", &Ledger::resisting_work);
    channels.add("energy/imbalance", [&ledger, strands](const Channels::Row row) {
      row[0] = strands * ledger.imbalance();
    });
  }

  void summarize(files::Json &summary) const override
  {
    const Ledger &ledger      = now_.system.world.ledger;
    const double  strands     = now_.scene.drive.strands;
    summary["drive_work"]     = strands * ledger.drive_work;
    summary["resisting_work"] = strands * ledger.resisting_work;
    for (const Line &line : lines)
      summary["energy"][line.name] = strands * ledger.*line.term;
  }
};

const Registered<Energy>
    registered_energy({"energy", "The energy balance, line by line.", {"plate faces"}},
                      parameters::QuantityGroup::energy);
} // namespace
} // namespace chaindrive::observe
