// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/observer.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/model/model.h>
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/observe/fields.h>
#include <chaindrive/observe/massless_deflections.h>
#include <chaindrive/observe/schedule.h>
#include <chaindrive/observe/spans.h>
#include <chaindrive/observe/tooth_forces.h>
#include <chaindrive/scene/scene.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace chaindrive::observe
{
/// What is looked at of a strand for field output.
struct StrandForces
{
  Spans                    spans;
  std::vector<ToothForces> teeth;
};

/// Writes the field output of a run, every Output/Field interval.
class FieldOutput : public dynamics::Observer
{
public:
  /// It goes to @p directory. @p scene must outlive this.
  FieldOutput(const scene::Scene     &scene,
              const model::Model     &model,
              const dynamics::System &system,
              const std::string      &directory,
              PhaseTimer             &timer);

  void        observe(const dynamics::System &system,
                      unsigned long           step,
                      double                  dt,
                      dynamics::Services     &services) override;
  bool        asks_for_bodies() const override { return true; }
  std::string name() const override { return "field output"; }

  /// A resumed run may have another interval.
  void serialize(const Archive &archive, const dynamics::System &system) override;

private:
  /// What is drawn of each part and kept between outputs.
  struct Drawing
  {
    Drawing(const scene::Scene     &scene,
            const dynamics::System &system,
            const std::string      &directory);

    Fields                               fields;
    std::map<scene::PartOf, PartPatches> parts;   ///< of a sprocket with a rim: its rigid zone
    std::map<unsigned int, PartPatches>  sectors; ///< of rims, by group of copies
    ElasticSnapshots                     elastic;
    MasslessDeflections                  massless;
    std::vector<StrandForces>            strands; ///< of the first rank
  };

  void write(const dynamics::System &system);

  const scene::Scene      &scene_;
  PhaseTimer::Phase        phase_;
  Schedule                 schedule_;
  std::unique_ptr<Drawing> drawing_; ///< none without an interval
};
} // namespace chaindrive::observe
