// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/functions/terms.h>

namespace chaindrive::functions
{
namespace
{
/// A torque against the rotation, whichever way the shaft turns.
struct OfSpeed
{
  struct Parameters
  {
    double linear    = 0.; ///< N m s
    double quadratic = 0.; ///< N m s2

    bool is_active() const { return linear != 0. || quadratic != 0.; }

    void declare(parameters::Declarations &declarations)
    {
      add(declarations,
          "Linear in N m s",
          linear,
          parameters::unit::si,
          parameters::between(0., 1e6),
          "Torque over speed that resists the rotation, as of a brake or a generator on a "
          "resistor. "
          "Default: none.");
      add(declarations,
          "Quadratic in N m s2",
          quadratic,
          parameters::unit::si,
          parameters::between(0., 1e6),
          "Torque over the square of the speed that resists the rotation, as of a fan, a pump or "
          "the air on a vehicle. Default: none.");
    }
  };

  static Term make(const Parameters &given, const Shaft &)
  {
    return {Variable::speed, std::make_shared<Resistance>(given.linear, given.quadratic)};
  }
};

const TermOf<OfSpeed> resistance(Of::torque, {"Of speed", "A torque that grows with the speed."});
} // namespace
} // namespace chaindrive::functions
