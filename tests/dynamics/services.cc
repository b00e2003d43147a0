// SPDX-License-Identifier: LGPL-2.1-or-later
// What observers may do: nothing that changes a system. What one rank asks all ranks know after the
// next step, and it is over after that; the run ends with the step in which an observer says so; a
// state can be written but not read.
#include "../support/archive.h"
#include "../support/scenes.h"

#include <chaindrive/dynamics/services.h>
#include <chaindrive/dynamics/time_loop.h>
#include <chaindrive/utilities/ranks.h>

#include <deal.II/base/mpi.h>

#include <type_traits>
#include <utility>

using namespace test;
using dynamics::Request;
using dynamics::System;

namespace
{
// Through a constant system everything is constant, what is behind pointers included.
template <typename T>
constexpr bool is_constant = std::is_const_v<std::remove_pointer_t<std::remove_reference_t<T>>>;
using Seen                 = const System &;
static_assert(is_constant<decltype(std::declval<Seen>().contacts.families()[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().forces[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().world.groups.all()[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().world.groups.force()[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().world.groups.surface()[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().world.groups.elastic()[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().world.groups.nodal()[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().world.groups.modal()[0])>);
static_assert(is_constant<decltype(*std::declval<Seen>().contacts.families().begin())>);
static_assert(is_constant<decltype(*std::declval<Seen>().world.groups.elastic().begin())>);
static_assert(is_constant<decltype(std::declval<Seen>().world.frames[0])>);
static_assert(is_constant<decltype(std::declval<Seen>().world.velocity.begin())>);
static_assert(is_constant<decltype(std::declval<Seen>().world.copies[0])>);

/// The last rank asks for a checkpoint at step 3 and for a stop at step 5, and all stop when they
/// are told so.
class Asker : public dynamics::Observer
{
public:
  void observe(const System       &system,
               const unsigned long step,
               double,
               dynamics::Services &services) override
  {
    const MPI_Comm comm = system.world.communicator();
    for (const Request request : {Request::checkpoint, Request::stop, Request::alarm})
      if (services.asked(request))
        heard += (request == Request::checkpoint ? " checkpoint" :
                  request == Request::stop       ? " stop" :
                                                   " alarm") +
                 std::string(" at ") + std::to_string(step);
    if (rank_in(comm) + 1 == n_ranks_in(comm) && step == 3)
      services.ask(Request::checkpoint);
    if (rank_in(comm) + 1 == n_ranks_in(comm) && step == 5)
      services.ask(Request::stop);
    if (services.asked(Request::stop))
      services.stop_run();
    ++calls;
    if (step == 4)
      {
        Items items;
        services.write_state(writer(items));
        n_items = items.size();
        try
          {
            services.write_state(reader(items));
          }
        catch (const dealii::ExceptionBase &)
          {
            refused = true;
          }
      }
  }
  std::string name() const override { return "asker"; }

  std::string   heard;
  unsigned long calls   = 0;
  std::size_t   n_items = 0;
  bool          refused = false;
};
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm                                 comm  = MPI_COMM_WORLD;
  scene::Scene                                   scene = empty_scene();
  scene.bodies                                         = {lump(1e-3, vector(0., 0., 0.))};
  System system(scene, false, comm);

  Asker                             first, second;
  std::vector<dynamics::Observer *> observers = {&first, &second};
  const unsigned long               steps     = dynamics::run(system, observers, 0., 1e-3, 1e-5);
  const bool                        alike     = n_ranks_in(comm) == 1 || [&] {
    const auto all = dealii::Utilities::MPI::all_gather(comm, first.heard);
    return all.front() == all.back();
  }();
  if (rank_in(comm) != 0)
    return 0;
  std::cout << "heard:" << first.heard << ", after " << steps << " steps\n";
  verdict("all ranks have heard the same", alike);
  verdict("both observers have seen all steps",
          first.calls == steps + 1 && second.calls == steps + 1 && first.heard == second.heard);
  verdict("a state is written and not read", first.n_items > 5 && first.refused);
}
