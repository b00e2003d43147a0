// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/utilities/message_tags.h>
#include <chaindrive/utilities/to_first_rank.h>

#include <limits>

// How the outside of elastic rollers moves.

namespace chaindrive::observe
{
namespace
{
class SurfaceVelocity : public Quantity
{
public:
  explicit SurfaceVelocity(const Observation &now)
      : Quantity(now), surfaces_(now.scene, now.system), velocity_(now.rollers.size())
  {
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start)
  {
    return has_elastic(start.scene, start.system, {scene::Kind::roller});
  }

  static Contents contents()
  {
    return {{{"rollers/surface_velocity_tangential",
              "m/s",
              "Of a node of the surface, along the tight span's direction of travel"},
             {"rollers/surface_velocity_normal",
              "m/s",
              "Of a node of the surface, along the tight span's outward normal"}},
            {}};
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    const auto add = [&](const std::string &name, const dealii::Tensor<1, 3> &axis) {
      channels.add("rollers/surface_velocity_" + name,
                   labels_of(now_.rollers),
                   [this, axis](const Channels::Row row) {
                     for (unsigned int i = 0; i < velocity_.size(); ++i)
                       row[i] = velocity_[i] * axis;
                   });
    };
    add("tangential", now_.scene.drive.tight().direction);
    add("normal", now_.scene.drive.tight().normal);
  }

  /// Every rank looks at its own rollers and leaves zeros where others do.
  void gather() override
  {
    constexpr double    nan   = std::numeric_limits<double>::quiet_NaN();
    const World        &world = now_.system.world;
    std::vector<double> numbers(3 * velocity_.size(), 0.);
    for (unsigned int i = 0; i < now_.rollers.size(); ++i)
      if (const unsigned int body = now_.roller_bodies[i]; world.owns(body))
        {
          const bool is_elastic        = world.elastic_address[body].group != World::Address::none;
          const dealii::Tensor<1, 3> v = is_elastic ? surfaces_.velocity(now_.system, body) :
                                                      nan * now_.scene.drive.tight().normal;
          for (unsigned int d = 0; d < 3; ++d)
            numbers[3 * i + d] = v[d];
        }
    on_first_rank_.sum(numbers, world.communicator(), tag_surface_velocities);
    for (unsigned int i = 0; i < velocity_.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        velocity_[i][d] = numbers[3 * i + d];
  }

private:
  RollerSurfaces                    surfaces_;
  SumOnFirstRank                    on_first_rank_;
  std::vector<dealii::Tensor<1, 3>> velocity_; ///< of now_.rollers at the present sample, m/s
};

const Registered<SurfaceVelocity> registered_surface_velocity(
    {"surface velocity", "How fast the surfaces of elastic parts vibrate.", {"artificial"}},
    parameters::QuantityGroup::surface_velocity);
} // namespace
} // namespace chaindrive::observe
