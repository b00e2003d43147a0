// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/services.h>
#include <chaindrive/dynamics/system.h>

#include <deal.II/base/exceptions.h>

namespace chaindrive::dynamics
{
void Services::ask(const Request request) { system_.requests.ask(request); }

bool Services::asked(const Request request) const { return system_.requests.asked(request); }

void Services::update_bodies() { system_.world.update_bodies(); }

void Services::gather_records() { system_.contacts.gather_records(system_.world); }

void Services::write_state(const Archive &archive)
{
  AssertThrow(!archive.reads(), dealii::ExcMessage("Observers do not change the state."));
  system_.serialize(archive);
}

PhaseTimer &Services::timer() { return system_.timer; }
} // namespace chaindrive::dynamics
