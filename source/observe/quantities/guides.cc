// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/guide_line.h>
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/quantity.h>

#include <string>
#include <vector>

// With what forces the chain presses and rubs on its guides.

namespace chaindrive::observe
{
namespace
{
class Guides : public Quantity
{
public:
  explicit Guides(const Observation &now) : Quantity(now)
  {
    for (const scene::GuideFamily &guide : now.scene.guides)
      for (const auto &family : now.system.contacts.families())
        if (const auto *found = dynamic_cast<const contact::SurfaceContact *>(family);
            found != nullptr && found->master() == guide.body)
          guides_.push_back(
              {now.scene.drive.spans[now.scene.bodies[guide.body].number].name, found});
  }

  static bool exists(const Observation &start) { return !start.scene.guides.empty(); }

  void add_channels(Channels &channels) override
  {
    for (const Guide &guide : guides_)
      {
        channels.add(files::Described{"guides/" + guide.span + "_force",
                                      "N",
                                      "Sum of the normal forces of the chain on the guide"},
                     [&guide](const Channels::Row row) { row[0] = guide.sum(false); });
        channels.add(files::Described{"guides/" + guide.span + "_friction",
                                      "N",
                                      "Sum of the magnitudes of its friction forces"},
                     [&guide](const Channels::Row row) { row[0] = guide.sum(true); });
      }
  }

private:
  struct Guide
  {
    std::string                    span;
    const contact::SurfaceContact *contact;

    /// Of the forces of all slaves, across their normals or along them, N.
    double sum(const bool across) const
    {
      double total = 0.;
      for (const unsigned int i : contact->near())
        {
          const contact::Record &record = contact->records()[i];
          const double           along  = record.force * record.normal;
          total += across ? (record.force - along * record.normal).norm() : along;
        }
      return total;
    }
  };

  std::vector<Guide> guides_;
};

const Registered<Guides>
    registered_guides({"guides", "With what forces the chain runs on its guides.", {"shafts"}},
                      parameters::QuantityGroup::tooth_forces);
} // namespace
} // namespace chaindrive::observe
