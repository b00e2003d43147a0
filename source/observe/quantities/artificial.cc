// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>

#include <string>

// How much of the energy of elastic bodies is artificial: that of the stiffness against
// hourglassing of elements of one point, which stands for nothing in the body. That of the other
// formulations is the energy of bending.

namespace chaindrive::observe
{
namespace
{
class Artificial : public Quantity
{
public:
  using Quantity::Quantity;

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start)
  {
    return start.system.world.n_nodal_groups() > 0 &&
           start.scene.elements.formulation == parameters::Formulation::one_point;
  }

  static Contents contents()
  {
    return {{}, {{"artificial_energy", "1", "energy of hourglass modes over that of all strain"}}};
  }

  bool reads_contacts() const override { return false; }

  void update() override
  {
    const Ledger &ledger = now_.system.world.ledger;
    hourglass_ += ledger.hourglass * now_.dt();
    all_ += (ledger.hourglass + ledger.strain) * now_.dt();
  }

  void summarize(files::Json &summary) const override
  {
    summary["artificial_energy"] = all_ > 0. ? files::Json(hourglass_ / all_) : files::Json();
  }

  void serialize(const Archive &archive) override
  {
    archive("hourglass", hourglass_);
    archive("all", all_);
  }

private:
  double hourglass_ = 0., all_ = 0.; ///< integrals over time, J s
};

const Registered<Artificial> registered_artificial(
    {"artificial", "The share of hourglass modes in the energy of elastic bodies.", {"losses"}});
} // namespace
} // namespace chaindrive::observe
