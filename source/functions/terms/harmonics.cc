// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/functions/terms.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>

namespace chaindrive::functions
{
namespace
{
using parameters::add;

/// A sum of cosines of the angle that a shaft has turned.
template <Of of>
struct HarmonicsOfAngle
{
  struct Parameters
  {
    std::vector<double> orders, amplitudes, phases; ///< phases in degrees

    bool is_active() const { return !orders.empty() || !amplitudes.empty() || !phases.empty(); }

    static std::string amplitude_entry()
    {
      return of == Of::speed ? "Amplitudes in percent" : "Amplitudes in N m";
    }

    void declare(parameters::Declarations &declarations)
    {
      const std::string what = of == Of::speed ? "speed" : "torque";
      add(declarations,
          "Orders",
          orders,
          parameters::unit::si,
          parameters::between(1e-3, 1000.),
          "How often each of the waves that are added to the " + what +
              " comes in one revolution of this shaft: of a four-stroke engine with four cylinders "
              "2, 4, 6. Empty: none.");
      add(declarations,
          amplitude_entry(),
          amplitudes,
          of == Of::speed ? parameters::unit::percent : parameters::unit::si,
          of == Of::speed ? parameters::between(0., 100.) : parameters::between(0., 1e7),
          of == Of::speed ? "Of each of them, of the mean speed at that time." :
                            "Of each of them. They grow with the torque over Loads/Torque ramp "
                            "angle in rad.");
      add(declarations,
          "Phases in degrees",
          phases,
          parameters::unit::si,
          parameters::between(-360., 360.),
          "Of each of them: the wave is amplitude times cos(order times angle + phase), with the "
          "angle turned since the start. Empty: all are 0.");
    }
  };

  static Term make(const Parameters &given, const Shaft &shaft)
  {
    const auto refuse_other_number = [&](const std::string &entry, const std::size_t n) {
      if (n != given.orders.size())
        throw InputError(shaft.section + "/" + entry + " has " + std::to_string(n) +
                         " values, but Orders has " + std::to_string(given.orders.size()) +
                         "; give one for each order.");
    };
    refuse_other_number(Parameters::amplitude_entry(), given.amplitudes.size());
    if (!given.phases.empty())
      refuse_other_number("Phases in degrees", given.phases.size());
    std::vector<Harmonic> waves;
    double                sum = 0.;
    for (std::size_t i = 0; i < given.orders.size(); ++i)
      {
        const double phase = given.phases.empty() ? 0. : given.phases[i];
        waves.push_back({given.orders[i], given.amplitudes[i], phase * dealii::numbers::PI / 180.});
        sum += given.amplitudes[i];
      }
    if (of == Of::speed && sum >= 1.)
      throw InputError(shaft.section + "/" + Parameters::amplitude_entry() +
                       " add up to 100 or more, so that the shaft would stop and turn back in each "
                       "revolution; choose less than 100 together.");
    return {Variable::angle, std::make_shared<Harmonics>(waves)};
  }
};

const TermOf<HarmonicsOfAngle<Of::speed>>
    harmonics_of_speed(Of::speed, {"Harmonics", "Waves of the speed over the angle of the shaft."});
const TermOf<HarmonicsOfAngle<Of::torque>>
    harmonics_of_torque(Of::torque,
                        {"Harmonics", "Waves of the torque over the angle of the shaft."});
} // namespace
} // namespace chaindrive::functions
