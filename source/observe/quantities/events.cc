// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/link_kernels.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/schedule.h>
#include <chaindrive/observe/wrap.h>
#include <chaindrive/utilities/simd.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// What makes key figures of a run meaningless: a chain that jumps, is off its sprocket, stands on
// tips, hangs where it must pull, or would have broken. Runs go on; their summary says so.

namespace chaindrive::observe
{
namespace
{
constexpr double look_interval = 20e-6; // s, at most: a chain slips less than half a pitch in it
constexpr double looks_a_pitch = 50.;   // and so many times in a pitch time
constexpr double longest_pitch = 10e-3; // s, for a drive that stands still or creeps
constexpr double slack_part    = 0.05;  // of the tension that the load asks for
constexpr double slack_pitches = 3.;    // that are slack one after the other

/// Something of one kind at one place.
struct Event
{
  double       first     = -1.;   ///< s; below zero: never
  double       amount    = 0.;    ///< teeth, s or N
  unsigned int body      = 0;     ///< the joint or link at which it was first or most
  bool         in_window = false; ///< at least once

  bool happened() const { return first >= 0.; }
};

/// A state that counts when it lasts.
struct Lasting
{
  double since = -1.; ///< s; below zero: it is not so

  /// For how long it has been so, s.
  double update(const bool is_so, const double time)
  {
    if (!is_so)
      since = -1.;
    else if (since < 0.)
      since = time;
    return is_so ? time - since : 0.;
  }
};

/// Sums over the looks of a pitch time; a chain vibrates too much to be judged at an instant.
struct OfPitch
{
  double       begin   = 0.;            ///< s
  double       tension = 0., pull = 0.; ///< of the tight span, and what the load asks for, N
  unsigned int n = 0;
};

std::string at(const double time) { return to_text(time * 1e3, 4) + " ms"; }

/// From when on no speed that is prescribed changes its course, s.
double last_change_of_speeds(const Observation &now)
{
  double last = now.scene.start_time;
  for (const scene::Shaft &shaft : now.scene.shafts)
    if (shaft.program.speed)
      last = std::max(last, functions::last_breakpoint(*shaft.program.speed, now.scene.start_time));
  return last;
}

class Events : public Quantity
{
public:
  explicit Events(const Observation &now)
      : Quantity(now)
      , pitch_time_(std::min(now.scene.pitch_time(), longest_pitch))
      , started_(last_change_of_speeds(now) + pitch_time_)
      , looks_(now.scene.start_time, std::min(look_interval, pitch_time_ / looks_a_pitch))
      , knows_tensions_(now.model.output.asks_for(parameters::QuantityGroup::tensions))
      , strength_(now.model.tensile_strength)
  {
    for (unsigned int i = 0; i < now.scene.drive.sprockets.size(); ++i)
      if (!now.scene.drive.sprockets[i].flat) // no chain jumps there, and it is always off teeth
        {
          numbers_.push_back(i);
          sprockets_.emplace_back(now.scene, i);
        }
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start)
  {
    const scene::Scene &scene = start.scene;
    return scene.drive.n_joints > 0 && !scene.drive.sprockets.empty() &&
           std::all_of(scene.drive.sprockets.begin(),
                       scene.drive.sprockets.end(),
                       [&](const auto &sprocket) {
                         return std::any_of(
                             scene.teeth.begin(), scene.teeth.end(), [&](const auto &teeth) {
                               return teeth.sprocket == sprocket.body;
                             });
                       });
  }

  /// Tensions are known where they are asked for anyway.
  bool reads_contacts() const override { return knows_tensions_; }

  static Contents contents()
  {
    return {{},
            {{"events/*/kind",
              "",
              "jumped, chain off, roller on a tip, tight span slack or above breaking"},
             {"events/*/time", "s", "of the first one"},
             {"events/*/sprocket", "", "name, of what happens at one"},
             {"events/*/roller", "", "number of the joint, of a roller on a tip"},
             {"events/*/span", "", "of a span that is slack"},
             {"events/*/link", "", "number of the link, of one above breaking"},
             {"events/*/ahead", "1", "teeth by which the chain is ahead at the end, of a jump"},
             {"events/*/amount", "", "how much or how long, in its unit"},
             {"events/*/unit", "", "teeth, s or N"},
             {"events/*/in_window", "", "whether it was so in the window of the means"},
             {"events/*/sentence", "", "what has happened"}}};
  }

  void update() override
  {
    if (knows_tensions_)
      look_for_breaking();
    if (!looks_.due(now_.time()))
      return;
    now_.update_bodies();
    for (OnSprocket &sprocket : sprockets_)
      look_at(sprocket);
    if (knows_tensions_)
      look_for_slack();
  }

  void summarize(files::Json &summary) const override
  {
    files::Json list = files::Json::array();
    for (unsigned int i = 0; i < sprockets_.size(); ++i)
      add_sprocket(list, sprockets_[i], now_.scene.drive.sprockets[numbers_[i]]);
    if (slack_.happened())
      list.push_back(json("tight span slack",
                          slack_,
                          "s",
                          {"span", "tight"},
                          "The tight span was slack for " + at(slack_.amount) + " from " +
                              at(slack_.first) + " on, while a load acted."));
    if (broken_.happened())
      list.push_back(json("above breaking",
                          broken_,
                          "N",
                          {"link", broken_.body},
                          "The tension of link " + std::to_string(broken_.body) + " rose to " +
                              to_text(broken_.amount, 4) + " N, above the " +
                              to_text(strength_, 4) + " N at which the chain breaks, first at " +
                              at(broken_.first) + "."));
    summary["events"] = list;
  }

  void serialize(const Archive &archive) override
  {
    looks_.serialize(archive / "looks", now_.time());
    for (unsigned int i = 0; i < sprockets_.size(); ++i)
      {
        const Archive part     = archive / std::to_string(i);
        OnSprocket   &sprocket = sprockets_[i];
        sprocket.wrap.serialize(part);
        part("jumps", sprocket.jumped);
        part("off", sprocket.off);
        part("off since", sprocket.off_since);
        part("tip", sprocket.tip);
        part.numbers("tip since", sprocket.tip_since);
      }
    archive("slack", slack_);
    archive("slack since", slack_since_);
    archive("pitch", pitch_);
    archive("broken", broken_);
  }

private:
  struct OnSprocket
  {
    OnSprocket(const scene::Scene &scene, const unsigned int i)
        : wrap(scene, i), tip_since(scene.drive.n_joints)
    {
    }

    Wrap                 wrap;
    Event                jumped, off, tip;
    Lasting              off_since;
    std::vector<Lasting> tip_since; ///< per joint
  };

  /// Books @p amount of something that was first so at @p first.
  void book(Event &event, const double first, const double amount, const unsigned int body = 0)
  {
    const Window &window = now_.window();
    if (!event.happened())
      event.first = first;
    if (amount > event.amount)
      {
        event.amount = amount;
        event.body   = body;
      }
    event.in_window |= now_.time() >= window.start() && first <= window.end();
  }

  void look_at(OnSprocket &sprocket)
  {
    const double time   = now_.time();
    const int    before = sprocket.wrap.jumped();
    sprocket.wrap.update(now_.system.world);
    if (const int teeth = std::abs(sprocket.wrap.jumped() - before); teeth > 0)
      book(sprocket.jumped, time, sprocket.jumped.amount + teeth);
    if (const double lasts = sprocket.off_since.update(sprocket.wrap.is_off(), time);
        lasts >= pitch_time_)
      book(sprocket.off, time - lasts, lasts);
    const std::vector<unsigned int> &tips = sprocket.wrap.on_tips();
    for (unsigned int k = 0; k < sprocket.tip_since.size(); ++k)
      {
        const bool   is_on = std::find(tips.begin(), tips.end(), k) != tips.end();
        const double lasts = sprocket.tip_since[k].update(is_on, time);
        if (lasts >= pitch_time_)
          book(sprocket.tip, time - lasts, lasts, k);
      }
  }

  void look_for_breaking()
  {
    const std::vector<double> &tension = now_.spans().link_tension();
    if (strength_ <= 0. || tension.empty())
      return;
    // at every step: in lanes, unlike a search of the largest
    if (!kernels_.any_above(tension.data(), static_cast<unsigned int>(tension.size()), strength_))
      return;
    const auto most = std::max_element(tension.begin(), tension.end());
    book(broken_, now_.time(), *most, static_cast<unsigned int>(most - tension.begin()));
  }

  /// Only in the window: before it drives start up, and driven inertia overruns them.
  void look_for_slack()
  {
    const double time = now_.time();
    double       pull = 0.;
    for (const scene::Sprocket &sprocket : now_.scene.drive.sprockets)
      if (sprocket.role == parameters::Role::driven)
        pull -= sprocket.sense * now_.system.loads.torque(sprocket.body) / sprocket.pitch_radius;
    if (time < std::max(started_, now_.window().start()) || time > now_.window().end() ||
        pull <= 0.)
      {
        pitch_       = {};
        slack_since_ = {};
        return;
      }
    if (pitch_.n++ == 0)
      pitch_.begin = time;
    // what the chain's own motion needs pulls at no sprocket
    const Spans &spans = now_.spans();
    pitch_.tension += spans.tight().tension - now_.scene.drive.mass_per_pitch /
                                                  now_.scene.drive.pitch * spans.tight().speed *
                                                  spans.tight().speed;
    pitch_.pull += pull;
    if (time < pitch_.begin + pitch_time_)
      return;
    slack_since_.update(pitch_.tension < slack_part * pitch_.pull, pitch_.begin);
    if (slack_since_.since >= 0. && time - slack_since_.since >= slack_pitches * pitch_time_)
      book(slack_, slack_since_.since, time - slack_since_.since);
    pitch_ = {};
  }

  static files::Json json(const std::string                          &kind,
                          const Event                                &event,
                          const std::string                          &unit,
                          const std::pair<const char *, files::Json> &place,
                          const std::string                          &sentence)
  {
    return {{"kind", kind},
            {"time", event.first},
            {place.first, place.second},
            {"amount", event.amount},
            {"unit", unit},
            {"in_window", event.in_window},
            {"sentence", sentence}};
  }

  static void
  add_sprocket(files::Json &list, const OnSprocket &found, const scene::Sprocket &sprocket)
  {
    const std::pair<const char *, files::Json> place = {"sprocket", sprocket.name};
    const std::string                          name  = sprocket.title;
    if (found.jumped.happened())
      {
        const int   teeth = static_cast<int>(std::lround(found.jumped.amount));
        files::Json one =
            json("jumped",
                 found.jumped,
                 "teeth",
                 place,
                 "The chain jumped " +
                     (teeth == 1 ? std::string("a tooth") : std::to_string(teeth) + " teeth") +
                     " of the " + name + (teeth == 1 ? ", at " : ", first at ") +
                     at(found.jumped.first) + ".");
        one["ahead"] = found.wrap.jumped();
        list.push_back(one);
      }
    if (found.off.happened())
      list.push_back(json("chain off",
                          found.off,
                          "s",
                          place,
                          "The chain was off the teeth of the " + name + " for " +
                              at(found.off.amount) + ", first from " + at(found.off.first) +
                              " on."));
    if (found.tip.happened())
      {
        files::Json one =
            json("roller on a tip",
                 found.tip,
                 "s",
                 place,
                 "Roller " + std::to_string(found.tip.body) +
                     " stood on the tip of a tooth of the " + name + " for " +
                     at(found.tip.amount) + "; the first one did at " + at(found.tip.first) + ".");
        one["roller"] = found.tip.body;
        list.push_back(one);
      }
  }

  double                  pitch_time_; ///< of the driver at its full speed; states must last it, s
  double                  started_;    ///< time from which the start-up is over, s
  Schedule                looks_;
  bool                    knows_tensions_;
  const LinkKernels      &kernels_ = *link_kernels(simd_width());
  double                  strength_;  ///< of the chain, N; 0: not known
  std::vector<OnSprocket> sprockets_; ///< those with teeth
  std::vector<unsigned int> numbers_; ///< of these in the drive
  Event                     slack_, broken_;
  Lasting                   slack_since_;
  OfPitch                   pitch_;
};

const Registered<Events> registered_events(
    {"events",
     "What makes the key figures of a run meaningless: a chain that jumps or breaks.",
     {"search"}});
} // namespace
} // namespace chaindrive::observe
