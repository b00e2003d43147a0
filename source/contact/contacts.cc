// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/contacts.h>
#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/guide_line.h>
#include <chaindrive/contact/node_bores.h>
#include <chaindrive/contact/node_contact.h>
#include <chaindrive/contact/node_faces.h>
#include <chaindrive/contact/planar_contact.h>
#include <chaindrive/contact/point_contact.h>
#include <chaindrive/contact/roller_strips.h>
#include <chaindrive/contact/tooth_side.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/message_tags.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace chaindrive::contact
{
namespace
{
/// Rollers that become ovals, and stiffness curves, are for PlanarContact alone.
void refuse_in_space(const scene::Scene    &scene,
                     const scene::Interface interface,
                     const std::string     &name,
                     const bool             curved)
{
  if (curved)
    throw InputError("Effects/Stiffness curves = on is not possible: the contacts " + name +
                     " are not all alike in the plane; choose auto or off.");
  if (scene.oval &&
      (interface == scene::Interface::roller_teeth || interface == scene::Interface::roller_bush))
    throw InputError("Effects/Oval rollers = on is not possible: the contacts " + name +
                     " are not all alike in the plane; choose auto or off.");
}
} // namespace

Contacts::Contacts(const scene::Scene &scene, World &world, const bool search_every_step)
    : every_step_(search_every_step)
{
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.elastic)
      NodeBores::want_ghosts(bores, world);
  for (const scene::FaceFamily &faces : scene.faces)
    NodeFaces::want_ghosts(faces, world);
  for (BodyBatches &copies : world.copies)
    copies.make_ghosts();
  world.node_exchange.connect(world.copies);

  const auto add_planar = [&](auto family) {
    const bool made = family != nullptr;
    if (made)
      families_.push_back(std::move(family));
    return made;
  };
  const auto add_family = [&](const scene::SurfaceFamily &family) {
    std::unique_ptr<SurfaceContact> made;
    if (family.elastic)
      made = std::make_unique<NodeContact>(family, world, search_every_step);
    else
      made = std::make_unique<PointContact>(family);
    if (const auto *flanks = dynamic_cast<const ElasticFlanks *>(family.surface.get()))
      near_flanks_.add(*flanks, *made);
    families_.push_back(std::move(made));
  };
  std::vector<RollerStrips *> strips;
  const auto                  add_strips =
      [&](const scene::Scene &scene, const scene::ToothFamily &teeth, World &world) {
        auto made = std::make_unique<RollerStrips>(
            scene, teeth, world, NodeBores::owners_of_bores(scene, teeth, world));
        strips.push_back(made.get());
        families_.push_back(std::move(made));
      };
  for (const scene::ToothFamily &teeth : scene.teeth)
    {
      if (!has_penalty(scene, teeth))
        {
          add_strips(scene, teeth, world);
          continue;
        }
      const scene::SurfaceFamily family = on_flanks(teeth, world);
      if (world.planar == nullptr || !add_planar(PlanarFlanks::make(teeth, family, world)))
        {
          refuse_in_space(scene, family.interface.interface, teeth.name, teeth.curve.has_value());
          add_family(family);
        }
    }
  for (const scene::SurfaceFamily &family : scene.surfaces)
    add_family(family);
  for (const scene::GuideFamily &guide : scene.guides)
    add_family({guide.name,
                std::make_shared<const GuideLine>(guide),
                guide.law,
                guide.slaves,
                guide.elastic,
                mesh::plate_edges,
                guide.stiffness});
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.elastic)
      {
        auto made = std::make_unique<NodeBores>(scene, bores, world, search_every_step);
        for (RollerStrips *of_rollers : strips)
          made->couple(*of_rollers);
        families_.push_back(std::move(made));
      }
    else if (world.planar == nullptr || !add_planar(PlanarBores::make(bores, world)))
      {
        refuse_in_space(scene, bores.interface, bores.name, bores.curve.has_value());
        families_.push_back(std::make_unique<PointContact>(bores));
      }
  for (const scene::SideFamily &sides : scene.sides)
    families_.push_back(std::make_unique<PointContact>(sides));
  for (const scene::ToothSideFamily &sides : scene.tooth_sides)
    if (sides.elastic)
      add_family({sides.name,
                  std::make_shared<const ToothSide>(sides, 0),
                  sides.law,
                  sides.slaves,
                  true,
                  sides.slave_surface,
                  0.,
                  scene::right_angle,
                  {scene::Interface::plate_teeth, sides.sprocket, sides.strand},
                  sides.slave_nodes});
    else
      families_.push_back(std::make_unique<PointContact>(sides));
  for (const scene::FaceFamily &faces : scene.faces)
    families_.push_back(std::make_unique<NodeFaces>(faces, world, search_every_step));

  // the reach is as large as the smallest slave: larger, and searches were fewer but lists longer
  reach_ = std::numeric_limits<double>::max();
  for (const auto &family : families_)
    if (family->needs_search())
      {
        needs_search_ = true;
        reach_        = std::min(reach_, family->smallest_radius());
      }
  reads_frames_ = std::any_of(families_.begin(), families_.end(), [](const Family *family) {
    return family->reads_frames();
  });
  lost_now_.resize(2 * families_.size());
  losses_.resize(families_.size());
}

bool Contacts::search_if_due(World &world, const double dt)
{
  double largest = 0.;
  if (!every_step_ && world.planar == nullptr)
    for (const Frame &frame : world.frames)
      largest = std::max(largest, frame.velocity.norm_square());
  else if (!every_step_)
    {
      largest = world.planar->fastest_square();
      for (const World::Hub &hub : world.hubs)
        largest = std::max(largest, world.frames[hub.body].velocity.norm_square());
    }
  const double approach = 2. * std::sqrt(largest) * dt;

  const bool due = every_step_ || cadence_.is_due(approach);
  if (due)
    {
      if (world.planar != nullptr)
        world.planar->publish(world);
      for (const auto &family : families_)
        family->search(world, reach_);
      cadence_.restart(reach_);
      ++statistics_.searches;
    }
  else
    cadence_.use(approach);
  ++statistics_.evaluations;
  return due;
}

void Contacts::add_forces(World &world, const double dt)
{
  const bool searched = needs_search_ && search_if_due(world, dt);
  near_flanks_.update(world, searched, dt);
  for (const auto &family : families_)
    family->announce(world, dt);
  world.place_surfaces(0.5 * dt);
  world.node_exchange.fetch(world.copies);
  std::fill(lost_now_.begin(), lost_now_.end(), 0.);
  const auto with_losses = [&](const std::size_t i, const auto &act) {
    const double friction = world.ledger.friction, damping = world.ledger.contact_damping;
    act();
    lost_now_[2 * i] += world.ledger.friction - friction;
    lost_now_[2 * i + 1] += world.ledger.contact_damping - damping;
  };
  for (std::size_t i = 0; i < families_.size(); ++i)
    if (families_[i]->is_distributed() || world.is_first_rank())
      with_losses(i, [&] { families_[i]->add_forces(world, dt); });
  for (std::size_t i = 0; i < families_.size(); ++i)
    if (families_[i]->is_distributed())
      with_losses(i, [&] { families_[i]->finish_forces(world, dt); });
  world.node_exchange.send_forces(world.copies);
  world.gather_forces();
}

void Contacts::book_losses()
{
  for (std::size_t i = 0; i < losses_.size(); ++i)
    {
      losses_[i].friction += lost_now_[2 * i];
      losses_[i].damping += lost_now_[2 * i + 1];
    }
}

void Contacts::gather_records(const World &world)
{
  const MPI_Comm     comm = world.communicator();
  const unsigned int rank = rank_in(comm), n_ranks = n_ranks_in(comm);

  if (rank > 0)
    {
      std::vector<double> &own = own_records_.numbers();
      for (const auto &family : families_)
        family->pack_records(rank, own);
      own_records_.send(comm, tag_contact_records);
      return;
    }

  // room for the records of all pairs, of which those that are near will come
  messages_.resize(n_ranks);
  std::vector<MPI_Request> requests(n_ranks - 1);
  for (unsigned int i = 0; i < requests.size(); ++i)
    {
      std::vector<double> &message = messages_[1 + i];
      if (message.empty())
        for (const auto &family : families_)
          message.resize(message.size() + family->most_numbers(1 + i));
      const int status = MPI_Irecv(message.data(),
                                   int(message.size()),
                                   MPI_DOUBLE,
                                   int(1 + i),
                                   tag_contact_records,
                                   comm,
                                   &requests[i]);
      AssertThrowMPI(status);
    }
  for (unsigned int n = 0; n < requests.size(); ++n) // in the order in which they come
    {
      int i = 0;
      {
        const Waiting waiting;
        const int     status =
            MPI_Waitany(int(requests.size()), requests.data(), &i, MPI_STATUS_IGNORE);
        AssertThrowMPI(status);
      }
      std::size_t position = 0;
      for (const auto &family : families_)
        family->unpack_records(1 + i, messages_[1 + i], position);
    }
}

void Contacts::serialize(const Archive &archive, World &world)
{
  cadence_.serialize(archive);
  archive("statistics", statistics_);
  archive.numbers("losses", losses_);
  unsigned long missed = dealii::Utilities::MPI::sum(n_missed(), world.communicator());
  archive("missed", missed);
  if (archive.reads() && world.is_first_rank())
    missed_before_ = missed;
  for (unsigned int f = 0; f < families_.size(); ++f)
    {
      const Archive of_family = archive / ("family " + std::to_string(f));
      families_[f]->serialize(of_family, rank_in(world.communicator()));
      double most = dealii::Utilities::MPI::max(families_[f]->most_pressed(), world.communicator());
      of_family("most pressed", most);
      if (archive.reads())
        families_[f]->set_most_pressed(most);
    }
  if (!archive.reads())
    return;
  near_flanks_.forget();
  for (const auto &family : families_)
    family->announce(world, {});
}

void Contacts::add_springs(const World &world, std::vector<Spring> &springs) const
{
  for (const auto &family : families_)
    family->add_springs(world, springs);
}

void Contacts::refuse_penetration(World &world, const double prestress, const double overlap)
{
  constexpr double tolerance = 1e-9;
  const Ledger     ledger    = world.ledger; // no work is done: bodies have been placed
  world.clear_forces();
  add_forces(world, 0.);
  gather_records(world);
  const Record *worst = nullptr;
  std::string   where;
  for (const auto &family : families_)
    for (const Record &record : family->records())
      {
        // a dashpot presses as well where surfaces meet at speed: of points the spring alone
        const double force = family->is_distributed() ?
                                 record.force.norm() :
                                 (-record.gap - overlap) * family->law().stiffness;
        if (record.gap < -tolerance - overlap && force > 1.01 * prestress &&
            (worst == nullptr || record.gap < worst->gap))
          {
            worst = &record;
            where = family->name();
          }
      }
  world.ledger = ledger;
  world.clear_forces();
  std::string message;
  if (worst != nullptr)
    message = "The bodies overlap at the start: interface " + where + ", joint " +
              std::to_string(worst->joint) + ", by " + to_text(-worst->gap * 1e3) +
              " mm, where at most 1e-06 mm is accepted. Choose clearances, pitch set and "
              "tooth form so that the chain fits the sprockets.";
  if (n_ranks_in(world.communicator()) > 1) // the first rank knows
    message = dealii::Utilities::MPI::broadcast(world.communicator(), message);
  if (!message.empty())
    throw InputError(message);
}

std::vector<const Family *> Contacts::find(const scene::InterfaceOf &interface) const
{
  std::vector<const Family *> found;
  for (const auto &family : families_)
    if (family->interface() == interface)
      found.push_back(family);
  return found;
}

std::vector<const Family *> Contacts::find_all(const scene::InterfaceOf &interface) const
{
  std::vector<const Family *> found;
  for (const auto &family : families_)
    if (family->interface().is_like(interface))
      found.push_back(family);
  return found;
}

std::string Contacts::overload_sentence(const World &world, const double step) const
{
  // for 500 MPa in all joints and seats limits are 0.56 (525) to 0.92 (08B) of those for working
  // loads, with the friction of default
  constexpr double for_any_force = 0.55;
  if (step <= for_any_force)
    return "";

  const Family *worst = nullptr;
  double        most  = 1.;
  for (const auto &family : families_)
    if (const double pressed =
            dealii::Utilities::MPI::max(family->most_pressed(), world.communicator());
        pressed > most)
      {
        most  = pressed;
        worst = family;
      }
  return worst == nullptr ?
             "" :
             "Interface " + worst->name() + " has carried up to " +
                 to_text(1e-3 * most * worst->largest_force(), 3) +
                 " kN. The critical time step is a bound for forces of up to " +
                 to_text(1e-3 * worst->largest_force(), 3) +
                 " kN. Choose Time/Safety factor = " + to_text(for_any_force, 2) +
                 ", which suffices for any force that such a chain bears, if energy does not "
                 "balance.";
}

unsigned long Contacts::n_missed() const
{
  unsigned long missed = missed_before_;
  for (const auto &family : families_)
    missed += family->n_missed();
  return missed;
}

std::size_t Contacts::memory_consumption() const
{
  std::size_t bytes = 0;
  for (const auto &family : families_)
    bytes += family->memory_consumption();
  return bytes;
}
} // namespace chaindrive::contact
