// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/roller_motion.h>
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
constexpr double round_off    = 1e-9;   // of places, m

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
    for (Sprocket &sprocket : sprockets_)
      sprocket.near_until.resize(scene.drive.n_joints, 0.);
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.teeth.empty(); }

  static Contents contents()
  {
    Contents contents;
    contents.summary = {
        {"pitch_time_mean", "s", "time from engagement to engagement, mean"},
        {"pitch_time_uncertainty", "s", "of this mean: half of its 95 % confidence interval"},
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
    summary["pitch_time_uncertainty"] =
        uncertainty_of_mean(pitch_times(), now_.window().pitches_per_period());
    files::Json list = files::Json::array();
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
        sprockets_[s].n_open = static_cast<unsigned int>(
            std::count_if(sprockets_[s].open.begin(), sprockets_[s].open.end(), [](const int open) {
              return open >= 0;
            }));
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
    std::vector<double>            force;      ///< per joint, this step, N; 0 between steps

    // what follows from these, or is found anew
    unsigned int        n_open     = 0;  ///< engagements still watched
    std::vector<double> near_until = {}; ///< per joint, PlanarBodies::travelled() up to
                                         ///< which it is not far, m
    double near_until_first = 0.;        ///< the least of these of the joints that are near, m
    std::vector<unsigned int> near_pairs = {}, near = {}; ///< joints that are near
    dealii::Tensor<1, 3>      centre = {};                ///< m
  };

  void follow(Sprocket &sprocket, const World &world, const double dt)
  {
    look_for_far(sprocket, world);
    // a roller may have several contact points: its force is their sum, booked at the first point
    // that touches
    const std::vector<contact::SurfaceContact::Press> &presses = sprocket.teeth->presses();
    for (const auto &press : presses)
      if (press.normal > 0.)
        touch(sprocket, press, world);
    if (sprocket.n_open == 0)
      return;
    for (const auto &press : presses)
      for (unsigned int point = 0; point < press.n_points; ++point)
        sprocket.force[press.joint] += press.normal;
    for (const unsigned int joint : sprocket.near)
      if (int &open = sprocket.open[joint]; open >= 0)
        {
          Engagement  &engagement = found_[open];
          const double age        = world.time - engagement.time;
          engagement.peak_force   = std::max(engagement.peak_force, sprocket.force[joint]);
          if (age <= impulse_time)
            engagement.impulse += sprocket.force[joint] * dt;
          if (age >= peak_time)
            {
              engagement.complete = true;
              open                = -1;
              --sprocket.n_open;
            }
        }
    for (const auto &press : presses)
      sprocket.force[press.joint] = 0.;
  }

  /// A roller touches by @p press, for the first time or again.
  void touch(Sprocket &sprocket, const contact::SurfaceContact::Press &press, const World &world)
  {
    const unsigned int joint  = press.joint;
    const unsigned int master = sprocket.teeth->master();
    if (sprocket.open[joint] < 0 && sprocket.was_far[joint] &&
        world.time - sprocket.last_touch[joint] >= free_time)
      {
        const dealii::Tensor<1, 3> place = roller_position(now_.scene.drive, world, joint);
        if ((place - world.frames[master].position) * sprocket.entry_side > 0.)
          {
            const dealii::Tensor<1, 3> relative = roller_velocity(now_.scene.drive, world, joint) -
                                                  world.velocity_at(master, place, 0.);
            sprocket.open[joint] = static_cast<int>(found_.size());
            ++sprocket.n_open;
            found_.push_back(
                {sprocket.name, joint, world.time, relative.norm(), -(relative * press.direction)});
            sprocket.was_far[joint]    = 0;
            sprocket.near_until[joint] = 0.;
            sprocket.near_until_first  = 0.;
          }
      }
    sprocket.last_touch[joint] = world.time;
  }

  /// Finds rollers that are far outside the pitch circle. In the plane they are looked at when they
  /// may have come there.
  void look_for_far(Sprocket &sprocket, const World &world) const
  {
    if (sprocket.near_pairs != sprocket.teeth->near())
      {
        sprocket.near_pairs       = sprocket.teeth->near();
        sprocket.near_until_first = 0.;
        sprocket.near.clear();
        for (const unsigned int i : sprocket.near_pairs)
          if (const scene::SlavePoint &slave = sprocket.teeth->slave(i);
              sprocket.near.empty() || sprocket.near.back() != slave.joint)
            sprocket.near.push_back(slave.joint);
      }
    const dealii::Tensor<1, 3> centre   = world.frames[sprocket.teeth->master()].position;
    const bool                 in_plane = world.planar != nullptr && centre == sprocket.centre &&
                          now_.scene.drive.bushes.empty(); // which go farther than their links
    const double way = world.planar != nullptr ? world.planar->travelled() : 0.;
    sprocket.centre  = centre;
    if (in_plane && way < sprocket.near_until_first)
      return;
    sprocket.near_until_first = std::numeric_limits<double>::infinity();
    for (const unsigned int joint : sprocket.near)
      {
        if (sprocket.was_far[joint])
          continue;
        if (in_plane && way < sprocket.near_until[joint])
          {
            sprocket.near_until_first =
                std::min(sprocket.near_until_first, sprocket.near_until[joint]);
            continue;
          }
        const double square =
            (roller_position(now_.scene.drive, world, joint) - centre).norm_square();
        if (square > sprocket.far_radius * sprocket.far_radius)
          sprocket.was_far[joint] = 1;
        else
          {
            double &until = sprocket.near_until[joint];
            until         = way + std::max(0., sprocket.far_radius - std::sqrt(square) - round_off);
            sprocket.near_until_first = std::min(sprocket.near_until_first, until);
          }
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

  /// These times, one after the other, s.
  std::vector<double> pitch_times() const
  {
    const std::string   driver = now_.scene.drive.driver().name;
    std::vector<double> times;
    double              last = std::numeric_limits<double>::quiet_NaN();
    for (const Engagement &engagement : found_)
      if (engagement.sprocket == driver && in_window(engagement))
        {
          if (!std::isnan(last))
            times.push_back(engagement.time - last);
          last = engagement.time;
        }
    return times;
  }

  std::vector<Sprocket>   sprockets_;
  std::vector<Engagement> found_;
};

const Registered<Engagements>
    registered_engagements({"engagements", "How rollers meet the teeth.", {"plate stress"}},
                           parameters::QuantityGroup::engagements);
} // namespace
} // namespace chaindrive::observe
