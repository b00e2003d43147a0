// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/time_loop.h>
#include <chaindrive/files/histories.h>
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/observe/engagements.h>
#include <chaindrive/observe/fields.h>
#include <chaindrive/observe/progress.h>
#include <chaindrive/observe/schedule.h>
#include <chaindrive/observe/spans.h>
#include <chaindrive/observe/summary.h>
#include <chaindrive/observe/tooth_forces.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/utilities/statistics.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace chaindrive::observe
{
/// Watches a run: samples histories, writes fields, keeps the means and maxima of the summary.
/// Means and maxima see every step, samples only theirs. Every rank has one; the first writes.
class Recorder : public dynamics::Observer
{
public:
  /// Results of a run of @p n_steps steps go to @p directory, which must exist; the hash of the
  /// parameters is stored with them.
  Recorder(const scene::Scene     &scene,
           const Parameters       &parameters,
           const dynamics::System &system,
           unsigned long           n_steps,
           const std::string      &directory,
           const std::string      &parameter_text,
           PhaseTimer             &timer,
           files::Log             &log);

  bool observe(dynamics::System &system, unsigned long step, double dt) override;

  /// What was seen up to the present time of @p system. A resumed run may have other intervals, but
  /// its window must be the same as far as it has gone (InputError).
  void serialize(const Archive &archive, const dynamics::System &system);

  /// InputError when the histories in @p directory are not those of @p archive, or are damaged.
  static void check(const Archive &archive, const std::string &directory);

  /// Writes what is left and closes the histories; of a run that is @p finished, what was kept to
  /// resume it is removed.
  void close(bool finished);

  /// The numbers of summary.json; their definitions are in doc/output.md. Collective.
  files::Json summary(const dynamics::System             &system,
                      const dynamics::Guard              &guard,
                      const dynamics::StepChoice         &step,
                      unsigned long                       n_steps,
                      const std::vector<PhaseTimer::Row> &table) const;

private:
  /// A channel and how to fill its row.
  struct Source
  {
    files::Histories::Handle                                                 handle;
    std::function<void(const dynamics::System &, dealii::ArrayView<double>)> fill;
  };
  using Fill = decltype(Source::fill);

  /// The same of one kind of joint contact.
  struct BoreForces
  {
    std::string                          name;
    std::vector<const contact::Family *> families; ///< of rigid and of elastic bodies
    std::vector<double>                  joint, peak;
    double                               overlap = 0.; ///< largest so far, m
  };

  /// How deep faces of one kind have been in each other.
  struct FaceOverlap
  {
    std::string                          name;
    std::vector<const contact::Family *> families;
    double                               overlap = 0.; ///< largest so far, m
  };

  void add_channels();
  void add_hub_channels();
  void add_roller_channels();
  void add_link_channels();
  void add_tooth_channels();
  void add_energy_channels();
  void add_elastic_channels();
  void add(const files::Channel &channel, Fill fill);

  void keep_peaks(const dynamics::System &system);
  void look_at_elastic_bodies(const dynamics::System &system); ///< collective
  template <typename Item>
  void visit_elastic_values(const Item &item);
  void keep_means(const dynamics::System &system, double dt);
  void sample(dynamics::System &system);
  void write_fields(const dynamics::System &system);

  const scene::Scene &scene_;
  const Parameters   &parameters_;
  PhaseTimer::Phase   phase_;

  std::unique_ptr<files::Histories>    histories_; ///< on the first rank
  std::vector<Source>                  sources_;
  std::unique_ptr<Fields>              fields_;
  std::map<scene::PartOf, PartPatches> patches_; ///< of a sprocket with a rim: its rigid zone

  std::map<unsigned int, PartPatches> sector_patches_; ///< of rims, by group of copies
  std::unique_ptr<Progress>           progress_;       ///< on the first rank, until close()

  std::unique_ptr<ElasticBodies> elastic_; ///< none without elastic bodies

  Spans       spans_;
  Engagements engagements_;

  std::vector<unsigned int> rollers_; ///< chosen for the histories
  std::vector<ToothForces>  teeth_;
  std::vector<BoreForces>   bores_;
  std::vector<FaceOverlap>  faces_;
  std::vector<double>       acceleration_; ///< of all bodies at the present sample
  std::vector<double>       link_peak_;    ///< N

  std::vector<dealii::Tensor<1, 3>> surface_velocity_; ///< of rollers_ at the present sample, m/s
  std::vector<WaistStress>          waists_;           ///< per link, at the present sample

  WindowMean driven_speed_, driver_torque_, tight_tension_, slack_tension_, span_speed_;
  double     tight_tension_start_ = 0.;

  Schedule samples_, pictures_;
};
} // namespace chaindrive::observe
