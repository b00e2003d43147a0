// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/without_effect.h>

#include <algorithm>
#include <utility>

namespace chaindrive::model
{
using parameters::CentreDistanceFrom;
using parameters::Switch;

namespace
{
/// What holds of all entries of a section, or of one.
struct Rule
{
  bool                     applies;
  std::vector<std::string> paths; ///< of entries, or of sections with a slash at their end
  std::string              reason;
};

std::vector<Rule> rules(const Parameters &p, const Effects &effects)
{
  const auto [has_clearances, is_elastic, is_reduced] = p.model.capabilities();
  const std::string        chosen                     = "Model/Fidelity = " + p.model.fidelity;
  const CentreDistanceFrom from                       = p.drive.layout.centre_distance_from;
  const std::string        layout                     = "Drive/Layout/";
  const Decision          &reduced                    = effects.of(Effect::reduced_bodies),
                 &teeth                               = effects.of(Effect::tooth_compliance),
                 &exact = effects.of(Effect::exact_teeth), &pictures = effects.of(Effect::fields);

  std::vector<Rule> rules = {
      {p.drive.chain.elongation == 0.,
       {"Drive/Layout/Worn chain"},
       "Drive/Chain/Elongation in percent = 0 is a new chain"},
      {p.drive.chain.pitch_tolerance == 0.,
       {"Drive/Chain/Pitch seed"},
       "Drive/Chain/Pitch tolerance in percent = 0 makes all links the same"},
      {!has_clearances,
       {"Contact/Roller-bush stiffness in N/m",
        "Contact/Roller-bush friction",
        "Contact/Bush-pin friction",
        "Effects/Roller-bush clearance",
        "Effects/Bush-pin clearance"},
       chosen + " has no bushes and pins"},
      {p.effects.roller_bush_clearance == Switch::off,
       {"Drive/Chain/Roller bore in mm"},
       "Effects/Roller-bush clearance = off makes it fit"},
      {p.effects.bush_pin_clearance == Switch::off,
       {"Drive/Chain/Bush bore in mm"},
       "Effects/Bush-pin clearance = off makes it fit"},
      {!drive::has_rollers(p.drive.chain),
       {"Contact/Roller-bush stiffness in N/m",
        "Contact/Roller-bush friction",
        "Effects/Roller-bush clearance",
        "Effects/Elastic rollers",
        "Elements/Selective mass scaling"},
       "the chain has no rollers"},
      {has_clearances, {"Model/Chain damping ratio"}, chosen + " has no bars"},
      {!is_elastic,
       {"Contact/Penalty factor",
        "Elements/",
        "Reduction/",
        "Model/Other links",
        "Effects/Elastic links",
        "Effects/Elastic rollers",
        "Effects/Elastic driver",
        "Effects/Elastic driven",
        "Effects/Plate bending",
        "Effects/Tooth compliance",
        "Effects/Tooth compliance over place"},
       chosen + " has no elastic bodies"},
      {is_elastic && !reduced.on, {"Reduction/"}, "no body is reduced: " + reduced.reason},
      {!anything_overlaps(p, exact.on, effects.is_on(Effect::plate_faces)),
       {"Contact/Damping ratio"},
       "nothing overlaps: " + exact.reason},
      {exact.on && !effects.is_on(Effect::plate_faces),
       {"Contact/Penalty factor"},
       "no elastic bodies overlap: " + exact.reason},
      {exact.on,
       {"Reduction/Harmonics of rollers and bushes", "Reduction/Harmonics of pins"},
       "pressures have no attachment modes: " + exact.reason},
      {!exact.on,
       {"Reduction/Highest frequency of rollers in kHz"},
       "rollers keep their modes, which deflect with inertia: " + exact.reason},
      {!effects.is_on(Effect::misalignment),
       {"Contact/Side stiffness in N/m",
        "Drive/Sprockets/Side relief in mm",
        "Drive/Sprockets/Side radius in mm"},
       effects.of(Effect::misalignment).reason},
      {!effects.is_on(Effect::separate_strands),
       {"Drive/Chain/Transverse pitch in mm"},
       "strands are not separate: " + effects.of(Effect::separate_strands).reason},
      {!teeth.on,
       {"Contact/Tooth stiffness in N/m"},
       "Effects/Tooth compliance is off: " + teeth.reason},
      {is_reduced, {"Elements/Selective mass scaling"}, "rollers move by modes"},
      {is_elastic && p.model.elastic_links == parameters::ElasticLinks::all,
       {"Model/Other links"},
       "Model/Elastic links = all leaves no others"},
      {!is_elastic && !pictures.on,
       {"Mesh/"},
       chosen + " needs meshes for field output only, and none is written: " + pictures.reason},
      {!p.output.asks_for(parameters::QuantityGroup::fields),
       {"Output/Field interval in ms"},
       "Output/Quantities do not name fields"},
      {p.output.window_start.has_value(),
       {"Output/Window length in pitches"},
       "Output/Window start in ms is a time"},
      {p.drive.layout.start == parameters::Start::settled,
       {"Loads/Speed ramp", "Loads/Ramp time in ms", "Loads/Torque ramp angle in rad"},
       layout + "Start = settled begins at full speed under full load"},
      {is_elastic && p.elements.formulation != parameters::Formulation::one_point,
       {"Elements/Hourglass coefficient"},
       "Elements/Formulation = " + text_of(p.elements.formulation) + " does not use it"}};
  for (const auto &[choice, entry] : {std::pair<CentreDistanceFrom, const char *>{
                                          CentreDistanceFrom::given, "Centre distance in mm"},
                                      {CentreDistanceFrom::slack, "Slack in mm"},
                                      {CentreDistanceFrom::sag, "Sag in percent"},
                                      {CentreDistanceFrom::pretension, "Pretension in N"}})
    rules.push_back(
        {from != choice, {layout + entry}, layout + "Centre distance from = " + text_of(from)});
  for (const parameters::Sprocket &wheel : p.drive.sprockets.list)
    {
      const parameters::Holder holder = wheel.held.holder;
      const std::string        of     = "Drive/Wheels/" + wheel.name + "/";
      const std::string        held   = of + "Held by = " + text_of(holder);
      const bool               fixed  = holder == parameters::Holder::bearing;
      rules.push_back({wheel.runout == 0.,
                       {of + "Runout phase in degrees"},
                       of + "Runout in um = 0 is no runout"});
      rules.push_back({wheel.tilt == 0.,
                       {of + "Tilt direction in degrees"},
                       of + "Tilt in degrees = 0 is no tilt"});
      rules.push_back(
          {!wheel.bearing.stiffness, {of + "Bearing/"}, of + "Bearing/Stiffness in N/m = rigid"});
      rules.push_back({!wheel.coupling.stiffness,
                       {of + "Coupling/"},
                       of + "Coupling/Stiffness in N m/rad = rigid"});
      rules.push_back({wheel.bearing.damping.has_value(),
                       {of + "Bearing/Damping ratio"},
                       of + "Bearing/Damping in N s/m is given"});
      rules.push_back({wheel.coupling.damping.has_value(),
                       {of + "Coupling/Damping ratio"},
                       of + "Coupling/Damping in N m s/rad is given"});
      rules.push_back({wheel.index_tolerance == 0.,
                       {of + "Index seed"},
                       of + "Index tolerance in um = 0 is no random wheel"});
      rules.push_back({fixed || !turns(holder), {of + "Arm/"}, held});
      rules.push_back({fixed || turns(holder), {of + "Slide/"}, held});
      rules.push_back({is_clamped(holder),
                       {of + "Arm/Moment in N m",
                        of + "Arm/Stiffness in N m/rad",
                        of + "Arm/Damping in N m s/rad",
                        of + "Arm/Retracting damping in N m s/rad",
                        of + "Arm/Inertia in kg m2",
                        of + "Slide/Force in N",
                        of + "Slide/Stiffness in N/m",
                        of + "Slide/Damping in N s/m",
                        of + "Slide/Retracting damping in N s/m",
                        of + "Slide/Mass in g"},
                       held + " is clamped"});
      rules.push_back(
          {!wheel.swing.is_active(), {of + "Swing/"}, of + "Swing/Pivot in mm = auto is no arm"});
      rules.push_back(
          {wheel.guide.points.empty(), {of + "Guide/"}, of + "Guide/Points in mm is empty"});
      const std::string loads = "Loads/" + wheel.name + "/";
      const auto        terms =
          (wheel.role == parameters::Role::driver ? wheel.speed_terms : wheel.torque_terms)
              .inactive();
      for (const auto &[term, entry] :
           {std::pair<std::string, std::string>{"Table", "File"}, {"Changes", "Times in ms"}})
        rules.push_back({std::find(terms.begin(), terms.end(), term) != terms.end(),
                         {loads + term + "/"},
                         loads + term + "/" + entry + " is empty"});
    }
  for (const std::string &section : p.sections.inactive())
    rules.push_back({true, {section + "/"}, section + "/Active = false"});
  return rules;
}
} // namespace

std::vector<std::string> without_effect(const Parameters               &parameters,
                                        const Effects                  &effects,
                                        const std::vector<std::string> &given)
{
  std::vector<std::string> sentences;
  for (const Rule &rule : rules(parameters, effects))
    {
      if (!rule.applies)
        continue;
      std::vector<std::string> found;
      for (const std::string &entry : given)
        for (const std::string &path : rule.paths)
          if (entry == path || (path.back() == '/' && entry.compare(0, path.size(), path) == 0))
            found.push_back(entry);
      std::string names;
      for (std::size_t i = 0; i < found.size(); ++i)
        names += (i == 0 ? "" : i + 1 == found.size() ? " and " : ", ") + found[i];
      if (!found.empty())
        sentences.push_back(names + (found.size() == 1 ? " has" : " have") + " no effect, since " +
                            rule.reason + ".");
    }
  return sentences;
}
} // namespace chaindrive::model
