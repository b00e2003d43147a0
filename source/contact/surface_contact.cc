// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/surface_contact.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace chaindrive::contact
{
SurfaceContact::SurfaceContact(std::string               name,
                               const scene::InterfaceOf &interface,
                               const scene::ContactLaw  &law,
                               std::vector<Pair>         pairs)
    : Family(std::move(name), interface, law), pairs_(std::move(pairs)), near_(pairs_.size())
{
  for (const Pair &pair : pairs_)
    {
      add_radius(pair.slave.radius);
      add_record(pair.surface->body(), pair.slave.body, pair.slave.joint);
    }
  states_.resize(records_.size());
  if (needs_search())
    near_.clear();
  else
    std::iota(near_.begin(), near_.end(), 0u);
}

bool SurfaceContact::needs_search() const
{
  return std::any_of(
      pairs_.begin(), pairs_.end(), [](const Pair &pair) { return pair.surface->needs_search(); });
}

void SurfaceContact::search(const World &world, const double reach)
{
  near_.clear();
  for (unsigned int i = 0; i < pairs_.size(); ++i)
    {
      const scene::SlavePoint   &slave  = pairs_[i].slave;
      const dealii::Tensor<1, 3> centre = to_world(world.frames[slave.body], slave.point);
      if (pairs_[i].surface->is_near(world, centre, slave.radius, reach))
        near_.push_back(i);
      else
        records_[i].gap = std::numeric_limits<double>::max();
    }
}

const std::vector<SurfaceContact::Press> &SurfaceContact::presses() const
{
  presses_.clear();
  for (const unsigned int i : near_)
    {
      const Record &record = records()[i];
      presses_.push_back({record.slave,
                          record.joint,
                          record.feature,
                          1,
                          record.force * record.normal,
                          record.gap,
                          record.force,
                          record.normal});
    }
  return presses_;
}

void SurfaceContact::serialize(const Archive &archive, const unsigned int rank)
{
  Family::serialize(archive, rank);
  archive("near", near_);
}

std::vector<SurfaceContact::Pair>
SurfaceContact::pairs_on(const std::shared_ptr<const Surface> &surface,
                         const std::vector<scene::SlavePoint> &slaves)
{
  std::vector<Pair> pairs;
  pairs.reserve(slaves.size());
  for (const scene::SlavePoint &slave : slaves)
    pairs.push_back({surface, slave});
  return pairs;
}
} // namespace chaindrive::contact
