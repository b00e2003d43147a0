// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/life.h>
#include <chaindrive/observe/link_kernels.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/utilities/batch_means.h>
#include <chaindrive/utilities/simd.h>

#include <deal.II/base/numbers.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// What the tensions in the window do to link plates. No link goes round the chain in a window that
// is shorter than a turn, but all of them together do: behind the history of a link over n pitches
// comes that of the link n ahead, which begins where that one ends.

namespace chaindrive::observe
{
namespace
{
/// The tension of a link: its turning points and the last value, with the way of the chain
/// [pitches] since the window began. Reversals that are too small to matter are left out; what
/// remains has its exact values.
struct LinkHistory
{
  std::vector<double> way, tension;

  template <typename BoostArchive>
  void serialize(BoostArchive &archive, unsigned int)
  {
    archive &way &tension;
  }
};

/// The histories of all links. The last value of each, which moves on as long as the tension rises
/// or falls, stands in an array over the links: hardly ever is there more to be done at a step.
class LinkHistories
{
public:
  explicit LinkHistories(const std::size_t n_links) : links_(n_links) {}

  void add(const double at, const std::vector<double> &tension, const double smallest)
  {
    const std::size_t n = links_.size();
    if (last_.empty())
      {
        last_ = tension;
        way_.assign(n, at);
        sense_.assign(n, 0.);
        return;
      }
    if (!kernels_.follow({tension.data(),
                          last_.data(),
                          way_.data(),
                          sense_.data(),
                          static_cast<unsigned int>(n),
                          at,
                          smallest}))
      return;
    for (std::size_t k = 0; k < n; ++k)
      if (const double change = tension[k] - last_[k]; std::abs(change) > smallest)
        {
          links_[k].way.push_back(way_[k]);
          links_[k].tension.push_back(last_[k]);
          last_[k]  = tension[k];
          way_[k]   = at;
          sense_[k] = change > 0. ? 1. : -1.;
        }
  }

  std::size_t size() const { return links_.size(); }

  /// Of all links, the last values included.
  std::vector<LinkHistory> whole() const
  {
    std::vector<LinkHistory> links = links_;
    for (std::size_t k = 0; k < last_.size(); ++k)
      {
        links[k].way.push_back(way_[k]);
        links[k].tension.push_back(last_[k]);
      }
    return links;
  }

  void serialize(const Archive &archive)
  {
    archive("turned", links_);
    archive("last", last_);
    archive("last way", way_);
    archive("sense", sense_);
  }

private:
  const LinkKernels       &kernels_ = *link_kernels(simd_width());
  std::vector<LinkHistory> links_; ///< turning points
  std::vector<double>      last_;  ///< tensions, N; none before the first
  std::vector<double>      way_;   ///< when they were so, pitches
  std::vector<double> sense_; ///< 1: it has risen to that, -1: fallen; 0: there is no other yet
};

class Fatigue : public Quantity
{
public:
  explicit Fatigue(const Observation &now)
      : Quantity(now)
      , smallest_(0.005 * now.model.plates.dynamic_strength)
      , links_(now.scene.drive.n_joints)
  {
    const scene::DriveView &drive = now.scene.drive;
    for (const World::Hub &hub : now.system.world.hubs)
      if (hub.body == drive.driver().body)
        {
          driver_ = &hub;
          teeth_ = drive.driver().sense * double(drive.driver().teeth) / (2. * dealii::numbers::PI);
        }
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start)
  {
    return start.scene.drive.n_joints > 0 && !start.scene.drive.sprockets.empty() &&
           start.model.plates.dynamic_strength > 0.;
  }

  static Contents contents()
  {
    return {{},
            {{"life/fatigue/pitches",
              "1",
              "way of the chain that the turns below are made of, from the window"},
             {"life/fatigue/turns", "1", "turns that differ"},
             {"life/fatigue/force/mean",
              "N",
              "from zero, does what the largest cycle of a turn does, mean"},
             {"life/fatigue/force/uncertainty", "N", "of the mean: half of its 95 % interval"},
             {"life/fatigue/force/largest", "N", "the same of the turn where it is largest"},
             {"life/fatigue/least", "N", "least tension in that cycle"},
             {"life/fatigue/most", "N", "largest tension in that cycle"},
             {"life/fatigue/link", "", "link that had this tension"},
             {"life/fatigue/step",
              "1",
              "largest step between histories that follow each other, over that cycle's range"},
             {"life/fatigue/damage", "1", "part of the life of plates that a turn takes, mean"},
             {"life/fatigue/damage_uncertainty",
              "1",
              "of that mean: half of its 95 % interval, of four turns or more"},
             {"life/simulated_plate_safety",
              "1",
              "endurance of the plates over the largest force from zero"},
             {"life/simulated_plate_hours", "h", "mean hours until plates fail, by damage"},
             {"life/early_plate_hours",
              "h",
              "the same of plates that are two standard deviations weaker"},
             {"life/late_plate_hours", "h", "and stronger"}}};
  }

  void update() override
  {
    const double time = now_.time();
    if (driver_ == nullptr || time < now_.window().start() || time > now_.window().end())
      return;
    if (first_ < 0.)
      {
        first_ = time;
        angle_ = driver_->angle;
      }
    last_            = time;
    const double way = teeth_ * (driver_->angle - angle_);
    const auto  &now = now_.spans().link_tension();
    links_.add(way, now, smallest_);
    if (way >= static_cast<double>(at_pitches_.size()))
      at_pitches_.push_back(now);
    way_ = way;
  }

  void summarize(files::Json &summary) const override
  {
    const std::size_t pitches = pitches_of_turns();
    if (pitches == 0)
      return;
    const drive::PlateFatigue     &plates = now_.model.plates;
    const std::vector<LinkHistory> links  = links_.whole();
    std::vector<double>            forces, damages;
    double                         damage = 0., early = 0., late = 0.;
    Turn                           worst;
    double                         largest = -1., step = 0.;
    const std::size_t              n_turns = std::min(pitches, links_.size());
    for (std::size_t k = 0; k < n_turns; ++k)
      {
        const Turn   turn  = turn_from(links, k, pitches);
        const auto   cycle = drive::rainflow_of_turn(turn.tension);
        const double turns = std::max(1., std::floor(double(pitches) / double(links_.size())));
        double       force = 0.;
        for (const drive::Cycle &one : cycle)
          force = std::max(
              force, plates.from_zero(one.mean - 0.5 * one.range, one.mean + 0.5 * one.range));
        forces.push_back(force);
        const auto part = [&](const drive::PlateFatigue &some) {
          return 1. / drive::turns_of(some, cycle) / turns;
        };
        damages.push_back(part(plates));
        damage += damages.back() / double(n_turns);
        early += part(plates.weaker(2.)) / double(n_turns);
        late += part(plates.weaker(-2.)) / double(n_turns);
        step = std::max(step, turn.step);
        if (force > largest)
          {
            largest = force;
            worst   = turn;
          }
      }
    const auto   most  = std::max_element(worst.tension.begin(), worst.tension.end());
    const double least = *std::min_element(worst.tension.begin(), worst.tension.end());
    double       mean  = 0.;
    for (const double force : forces)
      mean += force / double(forces.size());
    files::Json &life = summary["life"];
    life["fatigue"]   = {
          {"pitches", pitches},
          {"turns", n_turns},
          {"force",
           {{"mean", mean}, {"uncertainty", uncertainty_of_mean(forces)}, {"largest", largest}}},
          {"least", least},
          {"most", *most},
          {"link", worst.link[static_cast<std::size_t>(most - worst.tension.begin())]},
          {"step", *most > least ? step / (*most - least) : 0.},
          {"damage", damage},
          {"damage_uncertainty", uncertainty_of_mean(damages)}};
    if (largest > 0.)
      life["simulated_plate_safety"] = plates.endurance() / largest;
    const double per_hour = 3600. * way_ / double(links_.size()) / (last_ - first_);
    if (damage > 0.)
      life["simulated_plate_hours"] = 1. / damage / per_hour;
    if (early > 0.)
      life["early_plate_hours"] = 1. / early / per_hour;
    if (late > 0.)
      life["late_plate_hours"] = 1. / late / per_hour;
  }

  void serialize(const Archive &archive) override
  {
    links_.serialize(archive / "links");
    archive("at pitches", at_pitches_);
    archive("first", first_);
    archive("last", last_);
    archive("angle", angle_);
    archive("way", way_);
  }

private:
  /// A turn as links have seen it one behind the other.
  struct Turn
  {
    std::vector<double>      tension;
    std::vector<std::size_t> link;      ///< of each of them
    double                   step = 0.; ///< largest between one and the next, N
  };

  /// Whole pitches of the window: of the two kinds of links each is followed by its own. 0: too
  /// few.
  std::size_t pitches_of_turns() const
  {
    if (driver_ == nullptr || at_pitches_.size() < 3 || !(way_ > 0.))
      return 0;
    const std::size_t all = 2 * ((at_pitches_.size() - 1) / 2), n = links_.size();
    return all < n ? all : all / n * n;
  }

  /// The turn that begins with the link @p first and its way over so many @p pitches.
  Turn turn_from(const std::vector<LinkHistory> &links,
                 const std::size_t               first,
                 const std::size_t               pitches) const
  {
    const std::size_t n = links.size();
    Turn              turn;
    for (std::size_t done = 0; done < std::max(n, pitches); done += pitches)
      {
        const std::size_t  k = (first + done) % n, next = (k + pitches) % n;
        const std::size_t  way  = std::min(pitches, std::max(n, pitches) - done);
        const LinkHistory &link = links[k];
        const auto         add  = [&](const double tension) {
          turn.tension.push_back(tension);
          turn.link.push_back(k);
        };
        add(at_pitches_[0][k]);
        for (std::size_t i = 0; i < link.way.size() && link.way[i] < double(way); ++i)
          add(link.tension[i]);
        add(at_pitches_[way][k]);
        if (way == pitches)
          turn.step = std::max(turn.step, std::abs(at_pitches_[way][k] - at_pitches_[0][next]));
      }
    return turn;
  }

  const World::Hub                *driver_ = nullptr;
  double                           teeth_  = 0.; ///< of the driver over 2 pi, positive as it runs
  double                           smallest_;    ///< reversal that is kept, N
  LinkHistories                    links_;
  std::vector<std::vector<double>> at_pitches_;              ///< tensions after each whole pitch, N
  double                           first_ = -1., last_ = 0.; ///< instants that were looked at, s
  double                           angle_ = 0.;              ///< of the driver at the first, rad
  double                           way_   = 0.;              ///< of the chain since then, pitches
};

const Registered<Fatigue>
    registered_fatigue({"fatigue", "What the tensions of links do to their plates.", {"links"}},
                       parameters::QuantityGroup::tensions);
} // namespace
} // namespace chaindrive::observe
