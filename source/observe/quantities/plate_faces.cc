// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/quantity.h>

#include <algorithm>

// How deep faces of plates have been in each other.

namespace chaindrive::observe
{
namespace
{
class PlateFaces : public Quantity
{
public:
  explicit PlateFaces(const Observation &now) : Quantity(now)
  {
    for (const scene::FaceFamily &faces : now.scene.faces)
      kinds_.push_back({faces.name, now.system.contacts.find(faces.interface)});
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.faces.empty(); }

  static Contents contents()
  {
    return {{}, {{"penetration_max/plate faces", "m", "penetration of the two sides, largest"}}};
  }

  void update() override
  {
    for (Kind &kind : kinds_)
      for (const contact::Family *family : kind.families)
        for (const contact::Record &record : family->records())
          kind.penetration = std::max(kind.penetration, -record.gap);
  }

  void summarize(files::Json &summary) const override
  {
    for (const Kind &kind : kinds_)
      summary["penetration_max"][kind.name] = kind.penetration;
  }

  void serialize(const Archive &archive) override
  {
    for (Kind &kind : kinds_)
      (archive / kind.name)("overlap", kind.penetration);
  }

private:
  struct Kind
  {
    std::string                          name;
    std::vector<const contact::Family *> families;
    double                               penetration = 0.; ///< largest so far, m
  };
  std::vector<Kind> kinds_;
};

const Registered<PlateFaces> registered_plate_faces(
    {"plate faces", "How deep the faces of plates have been in each other.", {"joints"}},
    parameters::QuantityGroup::joint_forces);
} // namespace
} // namespace chaindrive::observe
