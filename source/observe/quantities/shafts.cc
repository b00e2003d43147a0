// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/window_statistics.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

// What the chain does to the shafts: the resultant of all contact forces on a sprocket.

namespace chaindrive::observe
{
namespace
{
class Shafts : public Quantity
{
public:
  explicit Shafts(const Observation &now) : Quantity(now), statistics_(now, signals(titles_of(now)))
  {
    for (unsigned int i = 0; i < now.scene.drive.sprockets.size(); ++i)
      shafts_.emplace_back(now, i);
    values_.resize(2 * shafts_.size());
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.teeth.empty(); }

  static Contents contents()
  {
    Contents                                         contents;
    std::vector<std::pair<std::string, std::string>> titles;
    for (const parameters::Sprocket &sprocket : parameters::Sprockets().list)
      titles.emplace_back(sprocket.name, title_of(sprocket.name, sprocket.role));
    for (const std::string &name : known_sprockets())
      for (const unsigned int d : {0U, 1U})
        contents.histories.push_back(load_of(name, d));
    contents.summary = WindowStatistics::members(signals(titles));
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    for (const Shaft &shaft : shafts_)
      for (const unsigned int d : {0U, 1U})
        channels.add(load_of(shaft.name, d),
                     [&shaft, d](const Channels::Row row) { row[0] = shaft.load[d]; });
  }

  void update() override
  {
    for (std::size_t i = 0; i < shafts_.size(); ++i)
      {
        shafts_[i].update();
        values_[2 * i]     = shafts_[i].load.norm();
        values_[2 * i + 1] = shafts_[i].direction();
      }
    statistics_.add(values_);
  }

  void summarize(files::Json &summary) const override { statistics_.summarize(summary); }

  void serialize(const Archive &archive) override
  {
    for (Shaft &shaft : shafts_)
      archive(shaft.name + " load", shaft.load);
    statistics_.serialize(archive / "statistics");
  }

private:
  /// Name and title of each shaft.
  using Titles = std::vector<std::pair<std::string, std::string>>;

  static std::string title_of(const std::string &name, const parameters::Role role)
  {
    return role == parameters::Role::driver ? name + "'s shaft" : name + " shaft";
  }

  static Titles titles_of(const Observation &now)
  {
    Titles titles;
    for (const scene::Sprocket &sprocket : now.scene.drive.sprockets)
      titles.emplace_back(sprocket.name, title_of(sprocket.name, sprocket.role));
    return titles;
  }

  static std::vector<WindowStatistics::Signal> signals(const Titles &titles)
  {
    std::vector<WindowStatistics::Signal> signals;
    for (const auto &[name, title] : titles)
      {
        signals.push_back({name + "_load", "N", "load of the " + title});
        signals.push_back(
            {name + "_load_direction", "rad", "direction of the load of the " + title});
      }
    return signals;
  }

  static files::Described load_of(const std::string &name, const unsigned int d)
  {
    return {"hubs/" + name + (d == 0 ? "_load_x" : "_load_y"),
            "N",
            "Force of the chain on the " + name + " shaft"};
  }

  struct Shaft
  {
    Shaft(const Observation &now, const unsigned int i)
        : name(now.scene.drive.sprockets[i].name), strands(now.scene.drive.strands)
    {
      const scene::DriveView &drive = now.scene.drive;
      for (const auto &family : now.system.contacts.families())
        if (const auto *found = dynamic_cast<const contact::SurfaceContact *>(family);
            found != nullptr && found->master() == drive.sprockets[i].body)
          teeth.push_back(found);
      // the driver pulls in the span before it, the others are pulled by the one behind them
      const scene::Span &span = i == 0 ? drive.tight() : drive.spans[i];
      along                   = i == 0 ? -span.along : span.along;
      up                      = span.normal - (span.normal * along) * along;
      up /= up.norm();
    }

    /// Of the load, from the line to the other end of the span that pulls most, towards it, rad.
    double direction() const { return std::atan2(load * up, load * along); }

    void update()
    {
      dealii::Tensor<1, 3> sum;
      for (const contact::SurfaceContact *family : teeth)
        for (const contact::SurfaceContact::Press &press : family->presses())
          for (unsigned int point = 0; point < press.n_points; ++point)
            sum -= press.force;
      load = strands * sum;
    }

    std::string                                  name;
    double                                       strands;
    std::vector<const contact::SurfaceContact *> teeth;
    dealii::Tensor<1, 3>                         along, up; ///< unit
    dealii::Tensor<1, 3>                         load;      ///< of all strands, N
  };

  WindowStatistics    statistics_;
  std::vector<Shaft>  shafts_; ///< driver first
  std::vector<double> values_; ///< of the signals
};

const Registered<Shafts> registered_shafts({"shafts", "The forces on the shafts.", {"hubs"}},
                                           parameters::QuantityGroup::tooth_forces);
} // namespace
} // namespace chaindrive::observe
