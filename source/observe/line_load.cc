// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/line_load.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chaindrive::observe
{
double largest_edge_load(const contact::Family &family)
{
  const auto *points = dynamic_cast<const contact::SurfaceContact *>(&family);
  if (points == nullptr || points->is_distributed())
    return 0.;
  const contact::SurfaceContact   &contact = *points;
  double                           largest = 0.;
  const std::vector<unsigned int> &near    = contact.near();
  const auto                      &records = contact.records();
  for (std::size_t n = 0; n + 1 < near.size(); ++n)
    {
      const unsigned int i = near[n], j = near[n + 1];
      if (records[i].joint != records[j].joint || records[i].slave != records[j].slave)
        continue;
      const dealii::Tensor<1, 3> sum    = records[i].force + records[j].force,
                                 differ = std::sqrt(3.) * (records[j].force - records[i].force);
      const double length =
          std::sqrt(3.) * std::abs(contact.slave(j).point[2] - contact.slave(i).point[2]);
      largest = std::max({largest, (sum - differ).norm() / length, (sum + differ).norm() / length});
    }
  return largest;
}
} // namespace chaindrive::observe
