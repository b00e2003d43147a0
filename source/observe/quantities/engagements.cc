// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/utilities/batch_means.h>
#include <chaindrive/utilities/signal_statistics.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

// How rollers meet the sprockets.

namespace chaindrive::observe
{
namespace
{
/// The first touch of a roller that arrives at a sprocket from the span.
struct Engagement
{
  std::string  sprocket;        ///< its name
  unsigned int roller;          ///< joint number
  double       time;            ///< of the first touch, s
  double       relative_speed;  ///< of the roller's centre and the sprocket's material there, m/s
  double       normal_speed;    ///< its part along the contact normal, m/s
  double       peak_force = 0.; ///< largest normal force within 1 ms, N
  double       impulse    = 0.; ///< of the normal force in the first 0.3 ms, N s
  bool         complete   = false; ///< the run went on for 1 ms after the touch

  template <typename BoostArchive>
  void serialize(BoostArchive &archive, unsigned int)
  {
    archive &sprocket &roller &time &relative_speed &normal_speed &peak_force &impulse &complete;
  }
};

constexpr double free_time    = 1e-3;   // without contact before a touch counts as an arrival
constexpr double peak_time    = 1e-3;   // after the touch, in which the peak is looked for
constexpr double impulse_time = 0.3e-3; // after the touch, over which the impulse is summed

/// Finds engagements while the run goes on. A roller arrives when it has been farther than 0.15
/// pitches outside the pitch circle and without contact for at least 1 ms, and touches on the side
/// of the sprocket where the chain comes in: a roller that bounces in its seat, or meets a tooth
/// once more as it leaves, does not engage again.
class Engagements : public Quantity
{
public:
  explicit Engagements(const Observation &now) : Quantity(now)
  {
    const scene::Scene     &scene  = now.scene;
    const dynamics::System &system = now.system;
    std::vector<char>       not_seated; // at the start: these will arrive from a span
    for (const char seated : scene.drive.seated)
      not_seated.push_back(!seated);

    for (const scene::Sprocket &sprocket : scene.drive.sprockets)
      for (const auto &family : system.contacts.families())
        if (const auto *found = dynamic_cast<const contact::SurfaceContact *>(family);
            found != nullptr && found->master() == sprocket.body)
          sprockets_.push_back(
              {sprocket.name,
               found,
               sprocket.pitch_radius + 0.15 * scene.drive.pitch,
               sprocket.entry_normal,
               std::vector<double>(scene.drive.n_joints, -std::numeric_limits<double>::infinity()),
               not_seated,
               std::vector<int>(scene.drive.n_joints, -1),
               std::vector<double>(scene.drive.n_joints, 0.)});
  }

  static bool exists(const Observation &start) { return !start.scene.teeth.empty(); }

  static Contents contents()
  {
    Contents contents;
    contents.summary = {{"pitch_time_mean", "s", "time from engagement to engagement, mean"},
                        {"engagements/*/sprocket", "", "name of the sprocket"},
                        {"engagements/*/roller", "", "number of the joint"},
                        {"engagements/*/time", "s", "first touch"},
                        {"engagements/*/relative_speed", "m/s", "speed of roller against tooth"},
                        {"engagements/*/normal_speed", "m/s", "normal speed of an impact"},
                        {"engagements/*/peak_force", "N", "peak force of an impact"},
                        {"engagements/*/impulse", "N s", "impulse of an impact"},
                        {"engagements/*/complete", "", "whether the run went on for 1 ms"},
                        {"impacts/*/number", "1", "impacts on a sprocket in the window"}};
    for (const auto &[name, unit] : {std::make_pair("peak_force", "N"),
                                     std::make_pair("impulse", "N s"),
                                     std::make_pair("normal_speed", "m/s")})
      for (const auto &[which, meaning] : {std::make_pair("mean", "mean"),
                                           std::make_pair("uncertainty",
                                                          "mean, half of its 95 % confidence "
                                                          "interval"),
                                           std::make_pair("deviation", "standard deviation"),
                                           std::make_pair("largest", "largest")})
        contents.summary.push_back({std::string("impacts/*/") + name + "/" + which,
                                    unit,
                                    std::string("of impacts in the window, ") + meaning});
    return contents;
  }

  void update() override
  {
    for (Sprocket &sprocket : sprockets_)
      follow(sprocket, now_.system.world, now_.dt());
  }

  void summarize(files::Json &summary) const override
  {
    summary["pitch_time_mean"] = mean_pitch_time();
    files::Json list           = files::Json::array();
    for (const Engagement &e : found_)
      list.push_back({{"sprocket", e.sprocket},
                      {"roller", e.roller},
                      {"time", e.time},
                      {"relative_speed", e.relative_speed},
                      {"normal_speed", e.normal_speed},
                      {"peak_force", e.peak_force},
                      {"impulse", e.impulse},
                      {"complete", e.complete}});
    summary["engagements"] = list;
    std::set<std::string> named; // families of rigid and of elastic rollers are two
    for (const Sprocket &sprocket : sprockets_)
      if (named.insert(sprocket.name).second)
        summary["impacts"][sprocket.name] = impacts_on(sprocket.name);
  }

  void serialize(const Archive &archive) override
  {
    archive("found", found_);
    for (unsigned int s = 0; s < sprockets_.size(); ++s)
      {
        const Archive part = archive / std::to_string(s);
        part.numbers("last touch", sprockets_[s].last_touch);
        part.numbers("was far", sprockets_[s].was_far);
        part.numbers("open", sprockets_[s].open);
        part.numbers("force", sprockets_[s].force);
      }
  }

private:
  struct Sprocket
  {
    std::string                    name;
    const contact::SurfaceContact *teeth;
    double                         far_radius; ///< m
    dealii::Tensor<1, 3>           entry_side; ///< from the axis, where rollers arrive
    std::vector<double>            last_touch; ///< per joint, s
    std::vector<char>              was_far;    ///< per joint, since it last engaged
    std::vector<int>               open;       ///< per joint, engagement still watched or -1
    std::vector<double>            force;      ///< per joint, this step, N
  };

  void follow(Sprocket &sprocket, const World &world, const double dt)
  {
    const std::vector<contact::Record> &records = sprocket.teeth->records();
    const Frame                        &hub     = world.frames[sprocket.teeth->master()];
    Frame                               room;

    // a roller may have several contact points: its force is their sum, booked at the first point
    // that touches
    for (const unsigned int i : sprocket.teeth->near())
      sprocket.force[records[i].joint] = 0.;
    for (const unsigned int i : sprocket.teeth->near())
      sprocket.force[records[i].joint] += records[i].force * records[i].normal;

    for (const unsigned int i : sprocket.teeth->near())
      {
        const contact::Record &record = records[i];
        const unsigned int     joint  = record.joint;
        const Frame           &roller = now_.scene.drive.roller(joint, world.frames, room);
        int                   &open   = sprocket.open[joint];
        const double           force  = sprocket.force[joint];
        if (force > 0. && record.force * record.normal <= 0.)
          continue; // another of its points touches

        if ((roller.position - hub.position).norm_square() >
            sprocket.far_radius * sprocket.far_radius)
          sprocket.was_far[joint] = 1;

        if (force > 0.)
          {
            if (open < 0 && sprocket.was_far[joint] &&
                world.time - sprocket.last_touch[joint] >= free_time &&
                (roller.position - hub.position) * sprocket.entry_side > 0.)
              {
                const dealii::Tensor<1, 3> relative =
                    roller.velocity - world.velocity_at(record.master, roller.position, 0.);
                open = static_cast<int>(found_.size());
                found_.push_back({sprocket.name,
                                  joint,
                                  world.time,
                                  relative.norm(),
                                  -(relative * record.normal)});
                sprocket.was_far[joint] = 0;
              }
            sprocket.last_touch[joint] = world.time;
          }

        if (open >= 0)
          {
            Engagement  &engagement = found_[open];
            const double age        = world.time - engagement.time;
            engagement.peak_force   = std::max(engagement.peak_force, force);
            if (age <= impulse_time)
              engagement.impulse += force * dt;
            if (age >= peak_time)
              {
                engagement.complete = true;
                open                = -1;
              }
          }
        // what is left of this joint's points in the list must not count its force again
        sprocket.force[joint] = 0.;
      }
  }

  /// Whether @p engagement began in the window.
  bool in_window(const Engagement &engagement) const
  {
    const double end = std::min(now_.window().end(), now_.model.time.end);
    return engagement.time >= now_.window().start() && engagement.time <= end;
  }

  /// Number of the complete engagements with a sprocket in the window; mean, standard deviation and
  /// largest of what is known of each.
  files::Json impacts_on(const std::string &sprocket) const
  {
    std::vector<const Engagement *> chosen;
    for (const Engagement &engagement : found_)
      if (engagement.sprocket == sprocket && engagement.complete && in_window(engagement))
        chosen.push_back(&engagement);
    files::Json result = {{"number", chosen.size()}};
    for (const auto &[name, member] : {std::make_pair("peak_force", &Engagement::peak_force),
                                       std::make_pair("impulse", &Engagement::impulse),
                                       std::make_pair("normal_speed", &Engagement::normal_speed)})
      {
        // each counts as much as any other
        const double        n = static_cast<double>(chosen.size());
        SignalStatistics    statistics(0., n);
        std::vector<double> values;
        for (unsigned int i = 0; i < chosen.size(); ++i)
          {
            values.push_back(chosen[i]->*member);
            statistics.add(i, 1., values.back(), {});
          }
        // of a sample, from which that of all impacts is estimated
        const double deviation = statistics.deviation() * std::sqrt(n / (n - 1.));
        result[name]           = {
                      {"mean", statistics.mean()},
                      {"uncertainty", uncertainty_of_mean(values, now_.window().pitches_per_period())},
                      {"deviation", n > 1. ? deviation : std::nan("")},
                      {"largest", statistics.largest()}};
      }
    return result;
  }

  /// Mean time between consecutive engagements of the driver that began in the window, s; not a
  /// number with fewer than two.
  double mean_pitch_time() const
  {
    const std::string driver = now_.scene.drive.driver().name;
    double            first = 0., last = 0.;
    unsigned int      n = 0;
    for (const Engagement &engagement : found_)
      if (engagement.sprocket == driver && in_window(engagement))
        {
          if (n++ == 0)
            first = engagement.time;
          last = engagement.time;
        }
    return n > 1 ? (last - first) / (n - 1) : std::numeric_limits<double>::quiet_NaN();
  }

  std::vector<Sprocket>   sprockets_;
  std::vector<Engagement> found_;
};

const Registered<Engagements>
    registered_engagements({"engagements", "How rollers meet the teeth.", {"plate stress"}},
                           parameters::QuantityGroup::engagements);
} // namespace
} // namespace chaindrive::observe
