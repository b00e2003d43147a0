// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/utilities/message_tags.h>
#include <chaindrive/utilities/to_first_rank.h>

#include <cmath>
#include <limits>

// Stresses at the waists of the side plates of elastic links.

namespace chaindrive::observe
{
namespace
{
class PlateStressQuantity : public Quantity
{
public:
  explicit PlateStressQuantity(const Observation &now)
      : Quantity(now), waists_(now.scene, now.system), stress_(now.scene.drive.n_joints)
  {
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start)
  {
    return has_elastic(
        start.scene, start.system, {scene::Kind::inner_link, scene::Kind::outer_link});
  }

  static Contents contents()
  {
    return {{{"plates/axial_stress",
              "Pa",
              "Stress along the link at the waist of a side plate, mean over the section"},
             {"plates/bending_in_plane",
              "Pa",
              "Half of that at the outer edge less that at the edge towards the chain's inside"},
             {"plates/bending_out_of_plane",
              "Pa",
              "Half of that in the outer face less that in the face towards the middle plane"},
             {"plates/principal_1",
              "Pa",
              "Larger in-plane principal stress in the middle of the plate"},
             {"plates/principal_2", "Pa", "The smaller one"}},
            {}};
  }

  bool reads_contacts() const override { return false; }

  void add_channels(Channels &channels) override
  {
    const unsigned int n   = now_.scene.drive.n_joints;
    const auto         add = [&](const std::string &name,
                         double WaistStress::*value,
                         const double         sign = 1.) {
      channels.add("plates/" + name, labels_up_to(n), [this, value, sign](const Channels::Row row) {
        for (unsigned int k = 0; k < stress_.size(); ++k)
          row[k] = sign * (stress_[k].*value);
      });
    };
    add("axial_stress", &WaistStress::axial);
    add("bending_in_plane", &WaistStress::in_plane, now_.scene.drive.sense);
    add("bending_out_of_plane", &WaistStress::out_of_plane);
    add("principal_1", &WaistStress::principal_1);
    add("principal_2", &WaistStress::principal_2);
  }

  /// Every rank looks at what it knows and leaves zeros where others do.
  void gather() override
  {
    constexpr double    nan   = std::numeric_limits<double>::quiet_NaN();
    const World        &world = now_.system.world;
    constexpr auto      n     = n_waist_components;
    std::vector<double> numbers(n * stress_.size(), 0.);
    for (unsigned int b = 0; b < now_.scene.bodies.size(); ++b)
      {
        const scene::Body &body = now_.scene.bodies[b];
        if (body.kind != scene::Kind::inner_link && body.kind != scene::Kind::outer_link)
          continue;
        const bool      is_elastic = world.elastic_address[b].group != World::Address::none;
        WaistComponents components =
            is_elastic ? waists_.components(now_.system, b) : WaistComponents{};
        for (unsigned int c = 0; c < n; ++c)
          numbers[n * body.number + c] = is_elastic ? entry(components, c) : nan;
      }
    on_first_rank_.sum(numbers, world.communicator(), tag_plate_stresses);
    for (unsigned int k = 0; k < stress_.size(); ++k)
      {
        WaistComponents components{};
        for (unsigned int c = 0; c < n; ++c)
          entry(components, c) = numbers[n * k + c];
        stress_[k] = std::isnan(components.axial) ? WaistStress{nan, nan, nan, nan, nan} :
                                                    stress_of(components);
      }
  }

private:
  Waists                   waists_;
  SumOnFirstRank           on_first_rank_;
  std::vector<WaistStress> stress_; ///< per link, at the present sample
};

const Registered<PlateStressQuantity> registered_plate_stress(
    {"plate stress", "The stress in the plates of elastic links.", {"surface velocity"}},
    parameters::QuantityGroup::plate_stress);
} // namespace
} // namespace chaindrive::observe
