// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/link_kernels.h>
#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/rows.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <limits>

// What the links pull.

namespace chaindrive::observe
{
namespace
{
class Links : public Quantity
{
public:
  explicit Links(const Observation &now) : Quantity(now), peak_(now.scene.drive.n_joints, 0.) {}

  bool reads_bodies() const override { return false; }

  static bool exists(const Observation &start) { return start.scene.drive.n_joints > 0; }

  static Contents contents()
  {
    return {{{"links/tension", "N", "Tension of the bar or link from joint k to joint k+1"},
             {"links/tension_peak", "N", "Largest tension since the last sample"}},
            {}};
  }

  void add_channels(Channels &channels) override
  {
    const unsigned int n = now_.scene.drive.n_joints;
    channels.add("links/tension", labels_up_to(n), [this](const Channels::Row row) {
      const std::vector<double> &tension = now_.spans().link_tension();
      std::copy(tension.begin(), tension.end(), row.begin());
    });
    channels.add("links/tension_peak", labels_up_to(n), copy_of(peak_));
  }

  void update() override
  {
    const std::vector<double> &tension = now_.spans().link_tension();
    kernels_.raise(peak_.data(), tension.data(), static_cast<unsigned int>(tension.size()));
  }

  void begin_interval() override
  {
    std::fill(peak_.begin(), peak_.end(), -std::numeric_limits<double>::max());
  }

  void serialize(const Archive &archive) override { archive.numbers("peak", peak_); }

private:
  const LinkKernels  &kernels_ = *link_kernels(simd_width());
  std::vector<double> peak_; ///< since the last sample, N
};

const Registered<Links> registered_links({"links", "The tension of each link.", {"rollers"}},
                                         parameters::QuantityGroup::tensions);
} // namespace
} // namespace chaindrive::observe
