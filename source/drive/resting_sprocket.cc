// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/rest.h>

#include <memory>

namespace chaindrive::drive
{
namespace
{
/// A sprocket as an obstacle.
class Teeth : public path::Obstacle
{
public:
  explicit Teeth(const ToothForm &form) : form_(form) {}

  double        reach() const override { return 0.5 * form_.outside_diameter; }
  path::Nearest nearest(const dealii::Point<2> &p) const override
  {
    const Projection nearest = form_.closest_point(p);
    return {nearest.distance, nearest.normal};
  }

private:
  const ToothForm &form_;
};
} // namespace

RestingWheel resting_sprocket(const ToothForm &form, const bool held, const double torque)
{
  return {std::make_shared<Teeth>(form), 0.5 * form.pitch_diameter, form.seats(), held, torque};
}
} // namespace chaindrive::drive
