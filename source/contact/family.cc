// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/family.h>

#include <algorithm>

namespace chaindrive::contact
{
unsigned int Family::n_touching() const
{
  records();
  return static_cast<unsigned int>(std::count_if(
      states_.begin(), states_.end(), [](const TouchState &s) { return s.normal > 0.; }));
}

void Family::add_joint_forces(std::vector<dealii::Tensor<1, 3>> &forces) const
{
  for (const Record &record : records())
    forces[record.joint] += record.force;
}

double Family::deepest() const
{
  double deepest = -std::numeric_limits<double>::max();
  for (const Record &record : records())
    deepest = std::max(deepest, -record.gap);
  return deepest;
}

double Family::add_normal_forces(std::vector<double> &forces) const
{
  double deepest = 0.;
  for (const Record &record : records())
    {
      forces[record.joint] += record.force * record.normal;
      deepest = std::max(deepest, -record.gap);
    }
  return deepest;
}

namespace
{
/// Hands every number of @p record that other ranks need to @p item.
template <typename Item>
void visit(Record &record, const Item &item)
{
  item(record.gap);
  item(record.normal_speed);
  for (unsigned int d = 0; d < 3; ++d)
    {
      item(record.force[d]);
      item(record.normal[d]);
    }
  double feature = record.feature;
  item(feature);
  record.feature = static_cast<unsigned int>(feature);
}
} // namespace

void Family::pack_records(const unsigned int rank, std::vector<double> &numbers) const
{
  for (unsigned int i = 0; i < owner_.size(); ++i)
    if (owner_[i] == rank && within_reach(i))
      {
        Record record = records_[i];
        visit(record, [&numbers](const double value) { numbers.push_back(value); });
      }
}

std::size_t Family::most_numbers(const unsigned int rank) const
{
  std::size_t n = 0;
  Record      record;
  visit(record, [&n](const double) { ++n; });
  return n * std::count(owner_.begin(), owner_.end(), rank);
}

void Family::unpack_records(const unsigned int         rank,
                            const std::vector<double> &numbers,
                            std::size_t               &position)
{
  for (unsigned int i = 0; i < owner_.size(); ++i)
    if (owner_[i] == rank && within_reach(i))
      visit(records_[i], [&](double &value) { value = numbers[position++]; });
}

void Family::serialize(const Archive &archive, const unsigned int rank)
{
  records(); // as they are now
  archive.numbers("records", records_);
  if (!is_distributed())
    archive.numbers("states", states_);
  for (unsigned int i = 0; i < owner_.size(); ++i)
    if (owner_[i] == rank)
      serialize_pair(i, archive.of_this_rank() / ("pair " + std::to_string(i)));
}
} // namespace chaindrive::contact
