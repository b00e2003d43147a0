// SPDX-License-Identifier: LGPL-2.1-or-later
// A third sprocket is one more element of the list of sprockets: it is laid, balanced, turned and
// observed as the others are. An idler outside of the loop turns against the drive and takes
// nothing from the tension; a second load adds its own to the span that it pulls.
#include "../support/scenes.h"

#include <chaindrive/drive/facts.h>
#include <chaindrive/observe/observation.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/summary.h>
#include <chaindrive/observe/wrap.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/statistics.h>

#include <sstream>
#include <utility>

using namespace test;
using parameters::Role;

namespace
{
void run(const std::string &what, Parameters p)
{
  p.model.fidelity               = "simple";
  p.drive.layout.slack           = 3e-3;
  p.drive.layout.start           = parameters::Start::settled;
  p.drive.sprockets.tooth_form   = parameters::StandardForm::iso_mid;
  p.loads.driver_speed           = 30.;
  p.loads.resisting_torque       = 60.;
  p.model.driven_inertia         = 9.88e-3;
  p.contact.friction_coefficient = 0.;
  p.time.end                     = 60e-3;
  p.output.window_start          = 0.;
  const drive::Drive drive       = drive::make_drive(p);
  const drive::Facts facts       = drive::make_facts(p, drive);
  const model::Model model       = model::make_model(p, drive);
  const scene::Scene scene       = scene::build_scene(model, drive, {"."});
  dynamics::System   system(scene, false);
  const std::size_t  n = scene.drive.sprockets.size();
  std::cout << what << ": " << scene.drive.n_joints << " links";
  for (const auto &sprocket : drive.layout.sprockets)
    std::cout << ", " << sprocket.seats;
  std::cout << " seats" << std::endl;

  observe::Observation       now(scene, model, system);
  std::vector<WindowMean>    tension(n, WindowMean(0., 1.)), speed(n, WindowMean(0., 1.));
  std::vector<observe::Wrap> wraps;
  for (unsigned int i = 0; i < n; ++i)
    wraps.emplace_back(scene, i);
  std::vector<observe::NamedQuantity> quantities;
  for (observe::NamedQuantity &item : observe::make_quantities(now))
    if (item.name == "hubs" || item.name == "shafts")
      quantities.push_back(std::move(item));
  std::vector<double> start;
  for (const World::Hub &hub : system.world.hubs)
    start.push_back(hub.angle);
  const double dt      = 0.5 * system.critical_time_step();
  double       overlap = 0.;
  bool         is_off  = false;
  unsigned int step    = 0;
  advance(system, static_cast<unsigned long>(p.time.end / dt), dt, [&]() {
    now.next(dt);
    for (unsigned int i = 0; i < n; ++i)
      {
        tension[i].add(now.time() - dt, dt, now.spans().of(i).tension);
        speed[i].add(now.time() - dt, dt, now.spans().of(i).speed);
      }
    for (const observe::NamedQuantity &item : quantities)
      item.quantity->update();
    for (const auto &family : system.contacts.families())
      for (const contact::Record &record : family->records())
        overlap = std::max(overlap, -record.gap);
    if (step++ % 50 == 0)
      for (observe::Wrap &wrap : wraps)
        {
          wrap.update(system.world);
          is_off = is_off || wrap.is_off() || wrap.jumped() != 0;
        }
  });

  files::Json summary;
  for (const observe::NamedQuantity &item : quantities)
    item.quantity->summarize(summary);
  std::ostringstream text;
  summary["window"] = {{"start", 0.}, {"end", p.time.end}, {"settled", nullptr}};
  observe::print_summary(text, summary);
  const files::Json statistics = summary["statistics"];
  for (unsigned int i = 0; i < n; ++i)
    {
      const scene::Sprocket    &sprocket = scene.drive.sprockets[i];
      const std::string        &name     = sprocket.name;
      const drive::Facts::Span &span     = facts.spans[i];
      const World::Hub         &hub      = system.world.hubs[i];
      const double              by_teeth = sprocket.sense * scene.drive.driver().sense *
                              system.world.hubs[0].angle * scene.drive.driver().teeth /
                              sprocket.teeth;
      // a tooth of the driver is the measure: how far its angle is from that of the teeth
      verdict("  " + sprocket.name + " turns by its teeth, to a quarter of a tooth",
              std::abs(hub.angle - by_teeth) * sprocket.teeth < 0.5 * dealii::numbers::PI);
      const double by_ratio =
          p.loads.driver_speed * scene.drive.driver().teeth / double(sprocket.teeth);
      verdict("  its statistics and its shaft's are in the summary and in its text",
              (sprocket.role == Role::driven) == statistics.contains(name + "_speed") &&
                  (sprocket.role != Role::driven ||
                   std::abs(statistics[name + "_speed"]["mean"].get<double>() / by_ratio - 1.) <
                       0.02) &&
                  statistics[name + "_load"]["mean"].get<double>() > 0. &&
                  text.str().find("  " + name + " shaft load ") != std::string::npos);
      const double chain = scene.drive.driver().pitch_radius * p.loads.driver_speed;
      // links of a slack span lie across its direction
      verdict("  " + scene.drive.spans[i].name +
                  " runs at the chain's speed, to 1 %, slack to 10 %",
              std::abs(speed[i].mean() / chain - 1.) < (tension[i].mean() > 100. ? 0.01 : 0.1));
      verdict("  its tension is that of the loads, to 4 % of the tight one",
              std::abs(tension[i].mean() - tension[0].mean() -
                       (span.tension - facts.spans[0].tension)) < 0.04 * facts.tight().tension);
    }
  verdict("  the span that the driver pulls in is the tightest",
          tension.back().mean() > 0.9 * facts.effective_tension);
  verdict("  rollers stay in their gaps", !is_off);
  verdict("  overlap below 0.05 mm", overlap < 0.05e-3);
  verdict("  energy closes to 1e-4 of what the driver has given",
          std::abs(system.world.ledger.imbalance()) <
              1e-4 * (system.world.ledger.drive_work + system.world.ledger.initial));
}

parameters::Sprocket third(const std::string &name,
                           const Role         role,
                           const unsigned int teeth,
                           const int          turn,
                           const double       x,
                           const double       y)
{
  parameters::Sprocket sprocket{name, role, teeth};
  sprocket.turn   = turn;
  sprocket.centre = std::array<double, 2>{{x, y}};
  return sprocket;
}
} // namespace

int main()
{
  Parameters outside;
  auto      &list = outside.drive.sprockets.list;
  list.insert(list.begin() + 1, third("idler", Role::idler, 11, -1, 0.3, -0.092));
  run("an idler outside of the loop, on the slack side", outside);

  Parameters inside;
  inside.drive.n_links = 112;
  auto &wider          = inside.drive.sprockets.list;
  wider.insert(wider.begin() + 1, third("idler", Role::idler, 11, 1, 0.3, -0.09));
  run("an idler inside of it", inside);

  Parameters loaded;
  loaded.drive.n_links = 116;
  loaded.drive.sprockets.list.push_back(third("pump", Role::driven, 25, 1, 0.3, 0.16));
  loaded.drive.sprockets.list.back().inertia = 9.88e-3;
  loaded.drive.layout.tight_span             = parameters::TightSide::lower;
  run("a second load on the tight side, the whole drive mirrored", loaded);
}
