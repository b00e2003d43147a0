// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>
#include <chaindrive/utilities/batch_means.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/statistics.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

// Where the energy goes in the window of the averages: what each interface dissipates, what comes
// in, goes out and is stored meanwhile. Of all strands.

namespace chaindrive::observe
{
namespace
{
class Losses : public Quantity
{
public:
  explicit Losses(const Observation &now)
      : Quantity(now), time_(now.window().start(), now.window().end())
  {
    for (const auto &family : now.system.contacts.families())
      interfaces_.push_back(family->name());
    for (const ForceElement *element : now.system.forces)
      if (element->lost())
        elements_.push_back(element->name());
    const scene::DriveView &drive = now.scene.drive;
    for (const World::Hub &hub : now.system.world.hubs)
      if (!drive.sprockets.empty() && hub.body == drive.driver().body)
        {
          driver_ = &hub;
          teeth_ = drive.driver().sense * double(drive.driver().teeth) / (2. * dealii::numbers::PI);
        }
    present(before_);
    within_.resize(before_.size(), 0.);
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &) { return true; }

  static Contents contents()
  {
    return {
        {},
        {{"losses/*/friction", "J", "lost by friction of an interface in the window"},
         {"losses/*/damping", "J", "lost by damping of an interface in the window"},
         {"losses/*/energy",
          "J",
          "lost by an interface, chain damping, drag, a coupling, a bearing or other force "
          "elements in "
          "the window"},
         {"losses/*/power", "W", "the same over the time of the window"},
         {"losses/*/uncertainty",
          "W",
          "of the power: half of its 95 % interval, by batches of pitches"},
         {"window_energy/drive_work", "J", "work of the driver in the window"},
         {"window_energy/resisting_work", "J", "work against the load in the window"},
         {"window_energy/lost", "J", "lost in the window"},
         {"window_energy/lost_uncertainty",
          "J",
          "of what is lost in windows as long as this: half of its 95 % interval, by batches of "
          "pitches"},
         {"window_energy/stored", "J", "stored at the end of the window less at its begin"},
         {"window_energy/duration", "s", "time of the window"},
         {"efficiency", "1", "efficiency in the window"},
         {"efficiency_uncertainty",
          "1",
          "of the efficiency: half of its 95 % interval, by batches of pitches"}}};
  }

  bool reads_contacts() const override { return false; }

  void update() override
  {
    present(values_);
    const std::vector<double> &values = values_;
    const double               begin  = now_.time() - now_.dt();
    if (now_.window().settled()) // since when is not known from the start
      time_.move_to(now_.window().start(), now_.window().end());
    if (const double inside = time_.inside(begin, now_.dt()); inside > 0.)
      for (std::size_t i = 0; i < values.size(); ++i)
        within_[i] += inside / now_.dt() * (values[i] - before_[i]);
    if (time_.inside(begin, now_.dt()) > 0.)
      add_pitch();
    time_.add(begin, now_.dt(), 0.);
    std::swap(before_, values_);
  }

  void summarize(files::Json &summary) const override
  {
    const double duration = time_.duration();
    const bool   empty    = !(duration > 0.);
    const double strands  = now_.scene.drive.strands;
    const auto energy = [&](const double value) { return empty ? std::nan("") : strands * value; };
    files::Json &losses = summary["losses"];
    losses              = files::Json::object();
    const auto add = [&](const std::string &name, const Terms &terms, const Terms &without = {}) {
      const double lost           = sum(within_.data(), terms) - sum(within_.data(), without);
      losses[name]["energy"]      = energy(lost);
      losses[name]["power"]       = energy(lost) / duration;
      losses[name]["uncertainty"] = strands * uncertainty_of(terms, without);
    };
    for (std::size_t i = 0; i < interfaces_.size(); ++i)
      { // families of rigid and of elastic bodies share a name
        double friction = 0., damping = 0.;
        Terms  both;
        for (std::size_t j = 0; j < interfaces_.size(); ++j)
          if (interfaces_[j] == interfaces_[i])
            {
              friction += within_[n_terms + 2 * j];
              damping += within_[n_terms + 2 * j + 1];
              both.insert(both.end(), {n_terms + 2 * j, n_terms + 2 * j + 1});
            }
        losses[interfaces_[i]] = {{"friction", energy(friction)}, {"damping", energy(damping)}};
        add(interfaces_[i], both);
      }
    if (now_.system.bars.size() > 0)
      add("chain damping", {chain_damping});
    if (now_.system.loads.drag() != 0.)
      add("drag", {drag});
    const std::size_t first = n_terms + 2 * interfaces_.size();
    for (std::size_t i = 0; i < elements_.size(); ++i)
      add(elements_[i], {first + i});
    if (elements_.size() < now_.system.forces.size())
      { // the others
        std::vector<std::size_t> all(elements_.size());
        std::iota(all.begin(), all.end(), first);
        add("force elements", {spring_damping}, all);
      }

    const double in = within_[drive_work], out = within_[resisting_work],
                 stored      = within_[stored_energy];
    summary["window_energy"] = {{"drive_work", energy(in)},
                                {"resisting_work", energy(out)},
                                {"lost", energy(within_[lost])},
                                {"lost_uncertainty", strands * uncertainty_of({lost}) * duration},
                                {"stored", energy(stored)},
                                {"duration", duration}};
    const bool drives        = in - stored > 0. && out > 0.;
    summary["efficiency"]    = drives ? out / (in - stored) : std::nan("");
    summary["efficiency_uncertainty"] =
        drives ? uncertainty_of_efficiency(out / (in - stored)) : std::nan("");
  }

  void serialize(const Archive &archive) override
  {
    time_.move_to(now_.window().start(), now_.window().end());
    WindowMean earlier = time_;
    archive("time", earlier);
    if (archive.reads() && !time_.go_on_from(earlier, now_.time()))
      throw InputError("its losses up to " + to_text(now_.time() * 1e3) +
                       " ms belong to another window; leave Output/Window start in ms and "
                       "Window end in ms as they were");
    archive.numbers("before", before_);
    archive.numbers("within", within_);
    archive("angle", angle_);
    archive("pitch ends", pitch_ends_);
    archive("at pitches", at_pitches_);
  }

private:
  using Terms = std::vector<std::size_t>; ///< places in present()

  enum Term : unsigned int
  {
    drive_work,
    resisting_work,
    stored_energy,
    lost,
    chain_damping,
    drag,
    spring_damping,
    n_terms
  };

  /// The terms at this instant, then the losses of the interfaces, friction and damping in turn,
  /// then those of force elements with names; all but what is stored since the start, J.
  void present(std::vector<double> &values) const
  {
    const Ledger &ledger = now_.system.world.ledger;
    values               = {ledger.drive_work,
                            ledger.resisting_work,
                            ledger.stored(),
                            ledger.lost(),
                            ledger.chain_damping,
                            ledger.drag,
                            ledger.spring_damping};
    for (const contact::Loss &loss : now_.system.contacts.losses())
      values.insert(values.end(), {loss.friction, loss.damping});
    for (const ForceElement *element : now_.system.forces)
      if (const auto lost = element->lost())
        values.push_back(*lost);
  }

  /// Remembers what has come to each term when another pitch of the driver has passed.
  void add_pitch()
  {
    if (driver_ == nullptr)
      return;
    if (pitch_ends_.empty())
      angle_ = driver_->angle;
    if (teeth_ * (driver_->angle - angle_) < static_cast<double>(pitch_ends_.size()))
      return;
    pitch_ends_.push_back(now_.time());
    at_pitches_.insert(at_pitches_.end(), within_.begin(), within_.end());
  }

  /// Of the values that begin at @p values those of @p terms.
  static double sum(const double *values, const Terms &terms)
  {
    double all = 0.;
    for (const std::size_t term : terms)
      all += values[term];
    return all;
  }

  std::size_t n_pitches() const { return pitch_ends_.empty() ? 0 : pitch_ends_.size() - 1; }

  /// What has come to @p terms in a pitch, J, of one strand.
  double in_pitch(const std::size_t i, const Terms &terms) const
  {
    const double *end = &at_pitches_[(i + 1) * within_.size()];
    return sum(end, terms) - sum(end - within_.size(), terms);
  }

  /// Of the mean power that is lost in @p terms and not in those @p without, of one strand, W; not
  /// a number when there are too few pitches.
  double uncertainty_of(const Terms &terms, const Terms &without = {}) const
  {
    std::vector<double> powers;
    for (std::size_t i = 0; i < n_pitches(); ++i)
      powers.push_back((in_pitch(i, terms) - in_pitch(i, without)) /
                       (pitch_ends_[i + 1] - pitch_ends_[i]));
    return uncertainty_of_mean(powers, now_.window().pitches_per_period());
  }

  /// Of the @p efficiency e, work w against the load over this and what is lost l: a ratio of
  /// means, whose error is that of the mean of (w - e (w + l)) over that of w + l [W. G. Cochran,
  /// Sampling Techniques, 3rd ed., 1977, sec. 6.4]. 1
  double uncertainty_of_efficiency(const double efficiency) const
  {
    std::vector<double> off;
    double              all = 0.;
    for (std::size_t i = 0; i < n_pitches(); ++i)
      {
        const double out = in_pitch(i, {resisting_work}), both = out + in_pitch(i, {lost});
        off.push_back(out - efficiency * both);
        all += both;
      }
    return uncertainty_of_mean(off, now_.window().pitches_per_period()) /
           (all / static_cast<double>(off.size()));
  }

  const World::Hub        *driver_ = nullptr;
  double                   teeth_  = 0.; ///< of the driver over 2 pi, positive as it runs
  double                   angle_  = 0.; ///< of the driver when the window began
  std::vector<double>      pitch_ends_;  ///< when whole pitches had passed since, s
  std::vector<double>      at_pitches_;  ///< what had come to each term until then, J
  WindowMean               time_;        ///< how much of the window has passed
  std::vector<std::string> interfaces_;
  std::vector<std::string> elements_; ///< whose losses have names of their own
  std::vector<double>      before_;   ///< present() after the last step, J
  std::vector<double>      values_;   ///< present() at this one, J
  std::vector<double>      within_;   ///< what has come to it within the window, J
};

const Registered<Losses>
    registered_losses({"losses", "The power lost in each kind of contact.", {"energy"}},
                      parameters::QuantityGroup::energy);
} // namespace
} // namespace chaindrive::observe
