// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/guide_line.h>
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/observe/known_names.h>
#include <chaindrive/observe/quantity.h>

#include <set>
#include <string>
#include <utility>
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
    std::set<unsigned int> bodies; // there are families of rigid and of elastic links
    for (const scene::GuideFamily &guide : now.scene.guides)
      if (bodies.insert(guide.body).second)
        {
          guides_.push_back({now.scene.drive.spans[now.scene.bodies[guide.body].number].name,
                             {},
                             static_cast<double>(now.scene.drive.strands)});
          for (const auto &family : now.system.contacts.families())
            if (const auto *found = dynamic_cast<const contact::SurfaceContact *>(family);
                found != nullptr && found->master() == guide.body)
              guides_.back().contacts.push_back(found);
        }
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.guides.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const auto &[history, across] : histories_of(any_span))
      contents.histories.push_back(history);
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    for (const Guide &guide : guides_)
      for (const auto &[history, across] : histories_of(guide.span))
        channels.add(history, [&guide, across = across](const Channels::Row row) {
          row[0] = guide.sum(across);
        });
  }

private:
  struct Guide
  {
    std::string                                  span;
    std::vector<const contact::SurfaceContact *> contacts;
    double                                       strands;

    /// Of the forces of all slaves of all strands, across their normals or along them, N.
    double sum(const bool across) const
    {
      double total = 0.;
      for (const contact::SurfaceContact *contact : contacts)
        for (const unsigned int i : contact->near())
          {
            const contact::Record &record = contact->records()[i];
            const double           along  = record.force * record.normal;
            total += across ? (record.force - along * record.normal).norm() : along;
          }
      return strands * total;
    }
  };

  /// Of the guide beside a span, each with whether it is of forces across the normals.
  static std::vector<std::pair<files::Described, bool>> histories_of(const std::string &span)
  {
    return {
        {{"guides/" + span + "_force", "N", "Sum of the normal forces of the chain on the guide"},
         false},
        {{"guides/" + span + "_friction", "N", "Sum of the magnitudes of its friction forces"},
         true}};
  }

  std::vector<Guide> guides_;
};

const Registered<Guides>
    registered_guides({"guides", "With what forces the chain runs on its guides.", {"shafts"}},
                      parameters::QuantityGroup::tooth_forces);
} // namespace
} // namespace chaindrive::observe
