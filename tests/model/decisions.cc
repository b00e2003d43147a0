// SPDX-License-Identifier: LGPL-2.1-or-later
// What is decided of a model, and why: which bodies are elastic for which quantities, as the table
// of doc/parameters.md says; that each effect is decided once; what is off has no coefficient; and
// what the entries that are auto become.
#include <chaindrive/model/decide.h>
#include <chaindrive/model/model.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

using namespace chaindrive;
using model::Effect;
using model::Effects;
using parameters::QuantityGroup;
using parameters::Switch;

namespace
{
void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

Parameters of(const std::string &fidelity)
{
  Parameters p;
  p.model.fidelity = fidelity;
  return p;
}

/// The first cells of the rows of the table of needs, by the text of the group.
std::map<std::string, std::vector<bool>> documented_needs()
{
  std::ifstream file(std::string(SOURCE_DIR) + "/../../doc/parameters.md");
  std::map<std::string, std::vector<bool>> rows;
  bool                                     begun = false;
  for (std::string line; std::getline(file, line);)
    {
      begun = begun || line == "## What needs what";
      if (!begun || line.compare(0, 3, "| `") != 0)
        continue;
      std::istringstream cells(line.substr(1));
      std::string        name, cell;
      std::getline(cells, name, '|');
      std::vector<bool> &row = rows[name.substr(2, name.size() - 4)];
      for (unsigned int i = 0; i < 4 && std::getline(cells, cell, '|'); ++i)
        row.push_back(cell == " needed ");
    }
  return rows;
}

/// Whether a full model that is asked for each group alone has what the document says.
void check_needs()
{
  const auto   rows  = documented_needs();
  unsigned int right = 0;
  for (const auto &[group, name] : parameters::texts_of<QuantityGroup>)
    {
      Parameters p              = of("full");
      p.output.quantities       = {group};
      const Effects     effects = model::decide_effects(p);
      const auto       &row     = rows.at(name);
      const bool        links = row[0], rollers = row[1], sprockets = row[2], both_halves = row[3];
      const std::string why = std::string("for Output/Quantities = ") + name;
      const bool        holds =
          effects.is_on(Effect::elastic_links) == links &&
          effects.is_on(Effect::elastic_rollers) == rollers &&
          effects.is_on(Effect::elastic_sprocket, 0) == sprockets &&
          effects.is_on(Effect::elastic_sprocket, 1) == sprockets &&
          effects.is_on(Effect::symmetry_model) == (links && rollers && !both_halves) &&
          effects.of(Effect::elastic_links).reason ==
              (links ? why : "nothing in Output/Quantities needs it") &&
          (!both_halves || effects.of(Effect::symmetry_model).reason == "whole bodies: " + why);
      if (!holds)
        std::cout << "  not so for " << name << '\n';
      right += holds;
    }
  std::cout << "groups of quantities whose needs are met as documented: " << right << " of "
            << rows.size() << '\n';
}

void check_that_all_are_decided_once()
{
  bool once = true;
  for (const std::string fidelity : {"simple", "layered", "reduced", "full"})
    {
      std::map<Effect, unsigned int> times;
      for (const model::Decision &decision : model::decide_effects(of(fidelity)))
        {
          ++times[decision.effect];
          once = once && !decision.reason.empty();
        }
      for (const auto &[effect, text] : parameters::texts_of<Effect>)
        once = once && times[effect] == (effect == Effect::elastic_sprocket ? 2U : 1U);
    }
  verdict("each effect is decided once, that of sprockets for both, with a reason", once);
  try
    {
      Effects().is_on(Effect::friction);
      verdict("what nobody decided is refused", false);
    }
  catch (const std::logic_error &)
    {
      verdict("what nobody decided is refused", true);
    }
}

void show(const std::string &what, const Parameters &p, const std::vector<Effect> &asked)
{
  std::cout << what << '\n';
  for (const model::Decision &decision : model::decide_effects(p))
    for (const Effect effect : asked)
      if (decision.effect == effect)
        std::cout << "  " << decision.name() << (decision.on ? " on, " : " off, ")
                  << decision.reason << '\n';
}

/// Which contacts have no penalty.
void show_exact_contact()
{
  const std::vector<Effect> exact{
      Effect::exact_joints, Effect::exact_teeth, Effect::contact_damping};
  const Parameters reduced = of("reduced");
  show("reduced, its contact", reduced, exact);
  show("full, its contact", of("full"), exact);
  Parameters p            = reduced;
  p.reduction.modes_up_to = 60e3;
  show("reduced with modes up to 60 kHz", p, exact);
  p                         = reduced;
  p.effects.contact_damping = Switch::on;
  show("reduced, damped", p, exact);
  p.contact.plate_faces = Switch::on;
  show("reduced, damped plate faces", p, exact);
  p                               = reduced;
  p.drive.sprockets.driven().mesh = "driven.msh";
  show("reduced, an imported sprocket", p, exact);
  p                     = reduced;
  p.model.elastic_links = parameters::ElasticLinks::region_of_interest;
  show("reduced in a region", p, exact);
  p                         = reduced;
  p.effects.elastic_rollers = Switch::off;
  show("reduced, rigid rollers", p, exact);
  for (const auto &[enforcement, text] : parameters::texts_of<parameters::Enforcement>)
    if (enforcement != parameters::Enforcement::automatic)
      {
        p                     = reduced;
        p.contact.enforcement = enforcement;
        show(std::string("reduced, asked for: ") + text, p, exact);
      }
}

void show_reasons()
{
  const std::vector<Effect> elastic{Effect::elastic_links,
                                    Effect::elastic_rollers,
                                    Effect::elastic_sprocket,
                                    Effect::tooth_compliance,
                                    Effect::reduced_bodies,
                                    Effect::symmetry_model};
  show("simple", of("simple"), {Effect::elastic_links, Effect::chain_bars});
  show("reduced", of("reduced"), elastic);
  show("full", of("full"), elastic);
  Parameters p              = of("full");
  p.effects.elastic_rollers = Switch::off;
  show("full, rollers off", p, elastic);
  p                     = of("full");
  p.model.elastic_links = parameters::ElasticLinks::region_of_interest;
  p.model.other_links   = parameters::OtherLinks::reduced;
  show("full, arriving", p, elastic);
  p                                  = of("full");
  p.output.quantities                = {QuantityGroup::tensions};
  p.model.elastic_sprockets          = Switch::off;
  p.drive.sprockets.driven().elastic = Switch::on;
  p.drive.sprockets.driven().mesh    = "driven.msh";
  show("full, tensions, the driven sprocket on and imported", p, elastic);
}

void check_values()
{
  constexpr double PI             = dealii::numbers::PI;
  Parameters       p              = of("layered");
  p.model.stiffness_from          = parameters::StiffnessFrom::dimensions;
  p.contact.friction_coefficient  = 0.1;
  p.contact.bush_pin_friction     = 0.2;
  p.contact.roller_bush_stiffness = 3e8;
  p.output.field_interval.reset();
  const drive::Drive drive = drive::make_drive(p);
  model::Model       m     = model::make_model(p, drive);
  verdict("interfaces have their own friction or the common one",
          m.contact.bush_pin_friction == 0.2 && m.contact.roller_bush_friction == 0.1 &&
              m.contact.roller_tooth_friction == 0.1 && m.contact.plate_friction == 0.1);
  verdict("a stiffness is given or that of the drive",
          m.roller_bush_stiffness.given && m.roller_bush_stiffness.value == 3e8 &&
              !m.roller_tooth_stiffness.given &&
              m.roller_tooth_stiffness.value == drive.roller_tooth_stiffness);
  verdict("pictures come ten times in a pitch time",
          std::abs(m.field_interval / (0.1 * 2. * PI / (15 * 120.74)) - 1.) < 1e-12 &&
              m.output.field_interval == m.field_interval);
  verdict("gravity acts, drag does not", m.loads.gravity == 9.81 && m.loads.drag == 0.);
  verdict("the window is that of the entries",
          !m.window.waits && m.window.start == 10e-3 && std::isinf(m.window.end));

  p.effects.friction = p.effects.contact_damping = p.effects.gravity = Switch::off;
  p.output.quantities                                                = {QuantityGroup::tensions};
  p.output.window_start.reset();
  m = model::make_model(p, drive);
  verdict("what is off has no coefficient",
          m.contact.bush_pin_friction == 0. && m.contact.roller_bush_friction == 0. &&
              m.contact.roller_tooth_friction == 0. && m.contact.plate_friction == 0. &&
              m.contact.damping_ratio == 0. && m.loads.gravity == 0.);
  verdict("pictures that nobody asks for have no interval", m.field_interval == 0.);
  verdict("a window that waits has no times yet",
          m.window.waits && std::isinf(m.window.start) && m.window.pitches == 10);
}

void check_arriving()
{
  Parameters p             = of("full");
  p.model.stiffness_from   = parameters::StiffnessFrom::dimensions;
  p.model.elastic_links    = parameters::ElasticLinks::region_of_interest;
  p.output.window_start    = 10e-3;
  p.output.window_end      = 15e-3;
  const drive::Drive drive = drive::make_drive(p);
  const model::Model m     = model::make_model(p, drive);
  // rad; the linear ramp of 5 ms costs half its time
  const auto   turned  = [&p](const double time) { return p.loads.driver_speed * (time - 2.5e-3); };
  const double rollers = 15. * (turned(15e-3) - turned(10e-3)) / (2. * dealii::numbers::PI);
  unsigned int n       = 0;
  for (const char elastic : m.elastic_joints)
    n += elastic != 0;
  // two more on both sides, and up to three for whole ones and inner links
  verdict("the rollers that arrive in the window are elastic",
          m.elastic_joints.size() == 110 && n >= rollers + 4. && n <= rollers + 8. &&
              !m.elastic_joints[50]);
  p.output.window_end.reset();
  p.time.end = 0.5;
  try
    {
      model::make_model(p, drive);
      std::cout << "a window of the whole chain is accepted\n";
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}

void check_stiffnesses()
{
  const auto show = [](const std::string &what, const Parameters &p) {
    const auto wanted = model::part_stiffnesses(p, model::decide_effects(p));
    std::cout << "  " << what << ':';
    if (!wanted)
      std::cout << " none";
    else
      std::cout << (wanted->per_pitch ? " per pitch" : "") << (wanted->rollers ? " rollers" : "")
                << (wanted->teeth ? " teeth" : "");
    std::cout << '\n';
  };
  std::cout << "stiffnesses from parts\n";
  show("simple", of("simple"));
  show("full", of("full"));
  show("reduced", of("reduced"));
  Parameters p                     = of("layered");
  p.contact.roller_tooth_stiffness = 1e8;
  show("layered, roller-tooth given", p);
  p.model.fidelity = "simple";
  show("simple, roller-tooth given", p);
  p.model.stiffness_from = parameters::StiffnessFrom::dimensions;
  show("from dimensions", p);
  p                    = of("full");
  p.drive.layout.start = parameters::Start::settled;
  show("full, settled", p);

  p                         = of("reduced");
  p.model.stiffness_from    = parameters::StiffnessFrom::dimensions;
  p.contact.tooth_stiffness = 1e5;
  const drive::Drive drive  = drive::make_drive(p);
  try
    {
      model::make_model(p, drive);
      std::cout << "soft teeth are accepted\n";
    }
  catch (const InputError &error)
    {
      const std::string text = error.what();
      std::cout << text.substr(0, text.find(',')) << " ...\n";
    }
  p.effects.tooth_compliance = Switch::off;
  model::make_model(p, drive); // they do not act
}
} // namespace

int main()
{
  check_needs();
  check_that_all_are_decided_once();
  show_reasons();
  show_exact_contact();
  check_values();
  check_arriving();
  check_stiffnesses();
}
