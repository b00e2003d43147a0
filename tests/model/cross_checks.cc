// SPDX-License-Identifier: LGPL-2.1-or-later
// Entries that are allowed one by one but contradict each other.
#include <chaindrive/model/cross_checks.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/utilities/errors.h>

#include <functional>
#include <iostream>
#include <vector>

using chaindrive::Parameters;
namespace model = chaindrive::model;
using namespace chaindrive::parameters;

void check(const std::function<void(Parameters &)> &change)
{
  Parameters p;
  change(p);
  try
    {
      for (const std::string &note : model::cross_check(p, model::decide_effects(p)))
        std::cout << "note: " << note << std::endl;
    }
  catch (const chaindrive::InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
  std::cout << std::endl;
}

int main()
{
  std::cout << "defaults" << std::endl;
  check([](Parameters &) {});

  std::cout << "times" << std::endl;
  check([](Parameters &p) { p.time.start = p.time.end; });
  check([](Parameters &p) { p.time.step = 31e-3; });
  check([](Parameters &p) { p.output.history_interval = 31e-3; });
  check([](Parameters &p) { p.time.end = 10e-3; });
  check([](Parameters &p) { p.output.window_end = 40e-3; });
  check([](Parameters &p) { p.output.window_end = 5e-3; });
  check([](Parameters &p) { p.output.field_interval = 50e-3; });
  check([](Parameters &p) {
    p.time.start          = 5e-3;
    p.output.window_start = 0.;
  });

  std::cout << "chain and sprockets" << std::endl;
  check([](Parameters &p) {
    p.model.fidelity = "layered";
    p.drive.n_links  = 111;
  });
  check([](Parameters &p) { p.drive.n_links = 111; });
  check([](Parameters &p) {
    p.drive.sprockets.seat_centre              = SeatCentre::bottom_diameter;
    p.drive.sprockets.driver().bottom_diameter = 66.28e-3;
  });
  check([](Parameters &p) { p.drive.sprockets.driven().bottom_diameter = 202.82e-3; });
  check([](Parameters &p) { p.drive.chain.pitch_set = PitchSet::paper_literal; });
  check([](Parameters &p) {
    p.drive.chain.pitch_set                    = PitchSet::paper_literal;
    p.drive.sprockets.seat_centre              = SeatCentre::bottom_diameter;
    p.drive.sprockets.driver().bottom_diameter = 66.28e-3;
    p.drive.sprockets.driven().bottom_diameter = 202.82e-3;
  });
  check([](Parameters &p) { p.drive.chain.pitch_set = PitchSet::nominal; });
  check([](Parameters &p) {
    p.drive.chain.pitch_set      = PitchSet::nominal;
    p.model.fidelity             = "layered";
    p.effects.bush_pin_clearance = Switch::off;
  });
  check([](Parameters &p) { p.drive.sprockets.driver().mesh = "driver.msh"; });
  check([](Parameters &p) { p.output.rollers = {0, 109, 110}; });
  check([](Parameters &p) { p.drive.sprockets.facets = 24; });
  check([](Parameters &p) { p.drive.sprockets.facets = 10; });
  check([](Parameters &p) {
    p.drive.sprockets.facets           = 25;
    p.drive.sprockets.driven().mesh    = "driven.msh";
    p.model.fidelity                   = "full";
    p.drive.sprockets.driven().elastic = Switch::off;
  });

  std::cout << "fidelity and start" << std::endl;
  check([](Parameters &p) { p.drive.layout.start = Start::concentric; });
  check([](Parameters &p) {
    p.drive.layout.start = Start::concentric;
    p.model.fidelity     = "layered";
  });
  check([](Parameters &p) { p.drive.layout.start = Start::settled; });
  check([](Parameters &p) {
    p.drive.layout.start    = Start::settled;
    p.model.fidelity        = "full";
    p.mesh.inner_link.along = 2;
    p.mesh.roller_along     = 5;
    p.mesh.roller_around    = 30;
    p.model.mass_per_pitch  = 10e-3;
  });
  check([](Parameters &p) {
    p.drive.layout.centre_distance_from = CentreDistanceFrom::pretension;
    p.model.fidelity                    = "full";
    p.contact.roller_tooth_stiffness    = 2e8;
    p.model.stiffness_per_pitch         = 8e7;
  });
  check([](Parameters &p) { p.model.elastic_sprockets = Switch::on; });
  check([](Parameters &p) { p.contact.plate_faces = Switch::on; });
  check([](Parameters &p) {
    p.model.elastic_links = ElasticLinks::region_of_interest;
    p.model.half          = SymmetryModel::yes;
  });
  check([](Parameters &p) {
    p.model.fidelity          = "full";
    p.model.elastic_links     = ElasticLinks::region_of_interest;
    p.model.elastic_sprockets = Switch::on;
  });
  check([](Parameters &p) { p.loads.ramp_time = 40e-3; });
  check([](Parameters &p) { p.contact.bush_pin_friction = 0.2; });

  std::cout << "effects" << std::endl;
  check([](Parameters &p) {
    p.effects.friction             = Switch::on;
    p.contact.friction_coefficient = 0.;
  });
  check([](Parameters &p) { // on by the coefficient of one interface
    p.effects.friction             = Switch::on;
    p.contact.friction_coefficient = 0.;
    p.contact.bush_pin_friction    = 0.1;
    p.model.fidelity               = "layered";
  });
  check([](Parameters &p) { // which the simple model does not have
    p.effects.friction             = Switch::on;
    p.contact.friction_coefficient = 0.;
    p.contact.bush_pin_friction    = 0.1;
  });
  check([](Parameters &p) {
    p.effects.contact_damping = p.effects.chain_damping = p.effects.gravity = p.effects.drag =
        Switch::on;
    p.contact.damping_ratio = p.model.chain_damping_ratio = p.loads.gravity = 0.;
  });
  check([](Parameters &p) {
    p.effects.chain_damping = Switch::on;
    p.model.fidelity        = "layered";
  });
  check([](Parameters &p) { p.effects.drag = Switch::off; });
  check([](Parameters &p) {
    p.effects.roller_bush_clearance = p.effects.bush_pin_clearance = p.effects.elastic_links =
        p.drive.sprockets.driven().elastic = p.effects.plate_bending = Switch::on;
  });

  std::cout << "elasticity" << std::endl;
  const auto full = [](const std::function<void(Parameters &)> &change) {
    check([&change](Parameters &p) {
      p.model.fidelity = "full";
      change(p);
    });
  };
  for (const double common : {0.1, 0.}) // of plate faces alone
    full([common](Parameters &p) {
      p.contact.plate_faces           = Switch::on;
      p.effects.friction              = Switch::on;
      p.contact.friction_coefficient  = common;
      p.contact.roller_tooth_friction = p.contact.roller_bush_friction =
          p.contact.bush_pin_friction = 0.;
    });
  full([](Parameters &p) {
    p.effects.elastic_rollers          = Switch::off;
    p.drive.sprockets.driver().elastic = Switch::on;
  });
  full([](Parameters &p) {
    p.effects.elastic_links = Switch::off;
    p.effects.plate_bending = Switch::on;
  });
  full([](Parameters &p) {
    p.model.half        = SymmetryModel::yes;
    p.output.quantities = {QuantityGroup::tensions};
  });
  check([](Parameters &p) { p.effects.tooth_compliance = Switch::on; });
  full([](Parameters &p) { p.effects.tooth_compliance = Switch::on; });
  full([](Parameters &p) {
    p.effects.tooth_compliance = Switch::on;
    p.effects.elastic_rollers  = Switch::off;
  });
  full([](Parameters &p) { // which is possible
    p.effects.tooth_compliance         = Switch::on;
    p.drive.sprockets.driven().elastic = Switch::off;
  });
  check([](Parameters &p) { p.effects.tooth_places = Switch::on; });
  for (const auto &against : std::vector<std::function<void(Parameters &)>>{
           [](Parameters &p) { p.effects.tooth_compliance = Switch::off; },
           [](Parameters &p) { p.contact.enforcement = Enforcement::penalty; },
           [](Parameters &p) { p.contact.tooth_stiffness = 3e8; },
           [](Parameters &p) { p.model.stiffness_from = StiffnessFrom::dimensions; },
           [](Parameters &) {}})
    check([&](Parameters &p) {
      p.model.fidelity       = "reduced";
      p.effects.tooth_places = Switch::on;
      against(p);
    });

  std::cout << "reduction" << std::endl;
  check([](Parameters &p) {
    p.model.fidelity          = "reduced";
    p.model.elastic_sprockets = Switch::on;
    p.contact.plate_faces     = Switch::on;
    p.effects.plate_bending   = Switch::off;
    p.model.mass_per_pitch    = 10e-3;
  });
  full([](Parameters &p) { // beside elastic ones
    p.model.elastic_links   = ElasticLinks::region_of_interest;
    p.model.other_links     = OtherLinks::reduced;
    p.effects.plate_bending = Switch::off;
  });

  check([](Parameters &p) { // no link is left that is not reduced
    p.model.fidelity      = "reduced";
    p.model.elastic_links = ElasticLinks::region_of_interest;
    p.model.other_links   = OtherLinks::reduced;
  });

  std::cout << "quantities" << std::endl;
  check([](Parameters &p) {
    p.output.quantities = {QuantityGroup::plate_stress,
                           QuantityGroup::surface_velocity,
                           QuantityGroup::joint_forces,
                           QuantityGroup::tensions};
  });
  full([](Parameters &p) {
    p.output.quantities     = {QuantityGroup::plate_stress, QuantityGroup::fields};
    p.effects.elastic_links = Switch::off;
    p.output.field_interval = 0.;
  });
  full([](Parameters &p) {
    p.output.quantities       = {QuantityGroup::surface_velocity};
    p.effects.elastic_rollers = Switch::off;
  });
  full([](Parameters &p) {
    p.output.quantities                = {QuantityGroup::tensions, QuantityGroup::engagements};
    p.drive.sprockets.driven().elastic = Switch::off;
  });
  full([](Parameters &p) {
    p.output.quantities     = {QuantityGroup::plate_stress};
    p.effects.plate_bending = Switch::off;
  });

  std::cout << "settled window" << std::endl;
  full([](Parameters &p) {
    p.output.window_start.reset();
    p.output.window_end   = 20e-3;
    p.loads.driver_speed  = 0.;
    p.model.elastic_links = ElasticLinks::region_of_interest;
  });
  check([](Parameters &p) { p.output.window_start.reset(); });

  std::cout << "noise" << std::endl;
  check([](Parameters &p) { p.acoustics.noise = true; });
  check([](Parameters &p) {
    p.acoustics.noise    = true;
    p.output.quantities  = {QuantityGroup::speeds};
    p.output.rollers     = {1, 2};
    p.loads.driver_speed = 0.;
  });
}
