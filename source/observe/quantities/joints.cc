// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/forces_in_places.h>
#include <chaindrive/observe/link_kernels.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

// What the parts of a joint do to each other: pins in bushes, bushes in rollers.

namespace chaindrive::observe
{
namespace
{
constexpr scene::Interface all_interfaces[] = {scene::Interface::roller_bush,
                                               scene::Interface::bush_pin};

/// With what the paths of the histories of a joint called @p name begin.
std::string path_of(std::string name)
{
  std::replace(name.begin(), name.end(), '-', '_');
  return "joints/" + name;
}

class Joints : public Quantity
{
public:
  explicit Joints(const Observation &now) : Quantity(now)
  {
    std::set<scene::Interface> found; // there are families of rigid and of elastic bodies
    for (const scene::BoreFamily &bores : now.scene.bores)
      if (found.insert(bores.interface).second)
        kinds_.push_back({bores.name,
                          now.system.contacts.find(bores.interface),
                          std::vector<double>(now.scene.drive.n_joints, 0.),
                          std::vector<double>(now.scene.drive.n_joints, 0.),
                          std::vector<double>(now.scene.drive.n_joints, 0.)});
    for (Kind &kind : kinds_)
      if (const auto *found = dynamic_cast<const contact::ForcesInPlaces *>(kind.families.front());
          kind.families.size() == 1 && found != nullptr)
        {
          kind.place = places_of_joints(*found, now.scene.drive.n_joints);
          if (kind.place.empty())
            continue;
          kind.in_places = found;
          for (std::vector<double> *most : {&kind.peak_in_places, &kind.depth_in_places})
            most->resize(found->forces_in_places().n, 0.);
        }
  }

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return !start.scene.bores.empty(); }

  static Contents contents()
  {
    Contents contents;
    for (const scene::Interface interface : all_interfaces)
      {
        const std::string path = path_of(parameters::text_of(interface));
        contents.histories.push_back({path + "_force", "N", "Normal force in the joint"});
        contents.histories.push_back(
            {path + "_force_peak", "N", "Its largest value since the last sample"});
        contents.histories.push_back(
            {path + "_gap", "m", "Smallest gap in the joint, negative: penetration"});
        contents.histories.push_back(
            {path + "_pressure", "Pa", "Largest contact pressure on a node of an elastic joint"});
      }
    for (const scene::Interface interface : all_interfaces)
      {
        contents.summary.push_back({"penetration_max/" + parameters::text_of(interface),
                                    "m",
                                    "penetration of the two sides, largest"});
        contents.summary.push_back({"contact_pressure_max/" + parameters::text_of(interface),
                                    "Pa",
                                    "largest contact pressure at samples in the window, of "
                                    "elastic joints"});
      }
    return contents;
  }

  void add_channels(Channels &channels) override
  {
    const unsigned int n = now_.scene.drive.n_joints;
    for (const Kind &kind : kinds_)
      {
        const std::string              path   = path_of(kind.name);
        const std::vector<std::string> labels = labels_up_to(n);
        channels.add(path + "_force", labels, copy_of(kind.force));
        channels.add(path + "_force_peak", labels, copy_of(kind.peak));
        channels.add(path + "_gap", labels, smallest_gaps_of(kind.families));
        if (know_pressure(kind.families))
          channels.add(path + "_pressure", labels, copy_of(kind.pressure));
      }
  }

  void update() override
  {
    for (Kind &kind : kinds_)
      if (kind.in_places != nullptr)
        {
          const contact::ForcesInPlaces::View now = kind.in_places->forces_in_places();
          kernels_.raise(kind.peak_in_places.data(), now.normal, now.n);
          kernels_.raise(kind.depth_in_places.data(), now.penetration, now.n);
        }
      else
        {
          std::fill(kind.force.begin(), kind.force.end(), 0.);
          for (const contact::Family *family : kind.families)
            kind.penetration = std::max(kind.penetration, family->add_normal_forces(kind.force));
          kernels_.raise(
              kind.peak.data(), kind.force.data(), static_cast<unsigned int>(kind.force.size()));
        }
  }

  void gather() override
  {
    for (Kind &kind : kinds_)
      kind.take_from_places();
    for (Kind &kind : kinds_)
      find_pressures(now_, kind.families, kind.pressure, kind.pressure_max);
  }

  void begin_interval() override
  {
    for (Kind &kind : kinds_)
      std::fill(kind.peak.begin(), kind.peak.end(), 0.);
  }

  void summarize(files::Json &summary) const override
  {
    for (const Kind &kind : kinds_)
      {
        summary["penetration_max"][kind.name] = kind.deepest();
        if (know_pressure(kind.families))
          summary["contact_pressure_max"][kind.name] = kind.pressure_max;
      }
  }

  void serialize(const Archive &archive) override
  {
    for (Kind &kind : kinds_)
      {
        const Archive part = archive / kind.name;
        kind.take_from_places();
        part.numbers("peak", kind.peak);
        kind.penetration = kind.deepest();
        part("overlap", kind.penetration);
        std::fill(kind.depth_in_places.begin(), kind.depth_in_places.end(), 0.);
        part("pressure", kind.pressure_max);
      }
  }

private:
  struct Kind
  {
    std::string                          name;
    std::vector<const contact::Family *> families;         ///< of rigid and of elastic bodies
    std::vector<double>                  force, peak;      ///< per joint, N
    std::vector<double>                  pressure;         ///< per joint, Pa
    double                               penetration = 0.; ///< largest so far, m

    /// Largest in the window so far, Pa.
    double pressure_max = std::numeric_limits<double>::quiet_NaN();

    // where forces stand in places, joints are told when somebody asks
    const contact::ForcesInPlaces *in_places       = nullptr;
    std::vector<unsigned int>      place           = {}; ///< [joint]
    std::vector<double>            peak_in_places  = {}; ///< since that was so last, N
    std::vector<double>            depth_in_places = {}; ///< largest penetrations, m

    double deepest() const ///< m
    {
      return std::accumulate(depth_in_places.begin(),
                             depth_in_places.end(),
                             penetration,
                             [](const double a, const double b) { return std::max(a, b); });
    }

    void take_from_places()
    {
      if (in_places == nullptr)
        return;
      const double *now = in_places->forces_in_places().normal;
      for (std::size_t k = 0; k < place.size(); ++k)
        {
          force[k] = now[place[k]];
          peak[k]  = std::max(peak[k], peak_in_places[place[k]]);
        }
      std::fill(peak_in_places.begin(), peak_in_places.end(), 0.);
    }
  };
  const LinkKernels &kernels_ = *link_kernels(simd_width());
  std::vector<Kind>  kinds_;
};

const Registered<Joints>
    registered_joints({"joints", "The contact forces in each joint.", {"teeth"}},
                      parameters::QuantityGroup::joint_forces);
} // namespace
} // namespace chaindrive::observe
