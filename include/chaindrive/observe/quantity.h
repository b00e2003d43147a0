// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/described.h>
#include <chaindrive/files/histories.h>
#include <chaindrive/files/json.h>
#include <chaindrive/observe/observation.h>
#include <chaindrive/parameters/sections.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/registry.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::observe
{
/// The histories of all quantities: each channel with the function that fills its row.
class Channels
{
public:
  using Row  = dealii::ArrayView<double>;
  using Fill = std::function<void(Row)>;

  /// With @p single, channels of several columns, of which there is one for each roller, link or
  /// tooth, are stored in single precision.
  explicit Channels(files::Histories &histories, const bool single = false)
      : histories_(histories), single_(single)
  {
  }

  /// The history `group/name`, which its quantity has in Contents::histories; the group must be one
  /// of files::is_history_group(). Rows begin as NaN.
  void add(const std::string &path, Fill fill);

  /// One of a sprocket or span whose name is known to the drive alone, as @p history describes it.
  void add(const files::Described &history, Fill fill);

  /// One with a column for each of @p labels.
  void add(const std::string &path, const std::vector<std::string> &labels, Fill fill);
  void add(const files::Described &history, const std::vector<std::string> &labels, Fill fill);

  /// Writes a sample at @p time [s].
  void sample(double time);

private:
  struct Source
  {
    files::Histories::Handle handle;
    Fill                     fill;
  };
  void add(files::Channel channel, Fill fill);

  files::Histories   &histories_;
  bool                single_;
  std::vector<Source> sources_;
};

/// What a quantity may write, in whatever model: its histories, its members of the summary.
struct Contents
{
  std::vector<files::Described> histories = {};
  std::vector<files::Described> summary   = {};
};

/// Something that is observed of a run: its channels in the histories, its members of the summary.
/// A new one is one file in source/observe/quantities, or in a plug-in (doc/plugins.md), which ends
/// with its registration:
///
///     class Speed : public Quantity
///     {
///     public:
///       using Quantity::Quantity;
///       static bool exists(const Observation &start);
///       static Contents contents();
///       void add_channels(Channels &channels) override;
///       ...
///     };
///     const Registered<Speed> registered_speed({"speed", "How fast rollers are.", {"rollers"}},
///                                              parameters::QuantityGroup::speeds);
///
/// One that has entries of its own in the .prm file holds them in a struct:
///
///       struct Parameters
///       {
///         double limit = 1.; ///< m/s
///         void   declare(parameters::Declarations &declarations);
///       };
///       Speed(const Observation &now, const Parameters &parameters);
///
/// They form the section `Quantities/speed`.
///
/// Every rank has all quantities of its scene. Functions do nothing unless overridden.
class Quantity
{
public:
  explicit Quantity(const Observation &now) : now_(now) {}
  virtual ~Quantity()                   = default;
  Quantity(const Quantity &)            = delete;
  Quantity &operator=(const Quantity &) = delete;

  /// What those who read results are told of it; every history must be among it.
  static Contents contents() { return {}; }

  /// Declares the histories. First rank only, before the first sample.
  virtual void add_channels(Channels &) {}

  /// Whether update() or channels look at contact records, also those behind
  /// Observation::spans(): only then are they brought to the first rank at every step.
  virtual bool reads_contacts() const { return true; }

  /// Whether update() looks at frames, displacements, velocities, forces or spins of bodies other
  /// than hubs, in every step; channels, gather() and summarize() may anyway. One that seldom does
  /// calls Observation::update_bodies() before. See dynamics::Observer::asks_for_bodies().
  virtual bool reads_bodies() const { return true; }

  /// Looks at the system before the first step and after each. First rank only.
  virtual void update() {}

  /// Brings together for a sample what is distributed over the ranks. Collective.
  virtual void gather() {}

  /// A sample has been taken: what counts since the last one begins anew. First rank only.
  virtual void begin_interval() {}

  /// Adds to the summary of the run up to now. Collective.
  virtual void summarize(files::Json &) const {}

  /// What it remembers from step to step. InputError when a run with other intervals or windows
  /// cannot go on with it. Collective.
  virtual void serialize(const Archive &) {}

protected:
  const Observation &now_; ///< the present one
};

/// A kind of quantity that the program knows.
class Registration
{
public:
  /// Makes the quantity; null when the scene has nothing of the kind, which then costs nothing.
  using Make = std::function<std::unique_ptr<Quantity>(const Observation &start)>;

  /// Quantities are asked, and their histories follow each other, in the order of @p about: each
  /// after those that it names. One of a @p group is made only when Output/Quantities ask for that;
  /// one without, always.
  Registration(const About                             &about,
               std::optional<parameters::QuantityGroup> group,
               Make                                     make,
               const Contents                          &contents = {});
};

/// Registers T, which says with T::exists(start) whether a scene has it, with T::contents() what it
/// writes, and with T::Parameters, if there are any, what entries it has.
template <typename T>
struct Registered : Registration
{
  explicit Registered(const About                                    &about,
                      const std::optional<parameters::QuantityGroup> &group = std::nullopt)
      : Registration(about, group, maker(section_of(about.name)), T::contents())
  {
    if constexpr (parameters::has_parameters<T>)
      parameters::register_section<parameters::SectionOf<typename T::Parameters>>(
          section_of(about.name));
  }

private:
  static std::string section_of(const std::string &name) { return "Quantities/" + name; }

  static Make maker(const std::string &section)
  {
    return [section](const Observation &start) -> std::unique_ptr<Quantity> {
      if (!T::exists(start))
        return nullptr;
      if constexpr (parameters::has_parameters<T>)
        return std::make_unique<T>(
            start,
            start.model.sections.get<parameters::SectionOf<typename T::Parameters>>(section)
                .values);
      else
        return std::make_unique<T>(start);
    };
  }
};

/// A quantity of a run.
struct NamedQuantity
{
  std::string               name;
  std::unique_ptr<Quantity> quantity;
};

/// All registered quantities that are asked for and that the scene of @p start has, in their order.
/// They keep a reference to @p start.
std::vector<NamedQuantity> make_quantities(const Observation &start);

/// What each of the registered quantities may write, in their order, with its group.
std::vector<std::pair<std::optional<parameters::QuantityGroup>, Contents>> all_contents();
} // namespace chaindrive::observe
