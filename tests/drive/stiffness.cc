// SPDX-License-Identifier: LGPL-2.1-or-later

// Stiffness estimates of a 525 chain of steel (210 GPa, 0.3) against closed forms, an independent
// solution of the conforming contact, and converged plane-stress solutions of its plates.

#include "compare.h"

#include <chaindrive/drive/stiffness.h>

#include <deal.II/base/numbers.h>

using namespace chaindrive;

int main()
{
  const Material               steel{210e9, 0.3, 7600.};
  const drive::ChainDimensions chain  = drive::make_chain(parameters::Chain());
  const double                 degree = dealii::numbers::PI / 180.;

  std::cout << "== roller on tooth, kN/mm\n";
  compare("line contact", drive::line_contact_stiffness(7e-3, steel) * 1e-6, 634.4, 1);
  const drive::PartStiffness all = drive::estimated_stiffness(chain, 1412., steel);
  compare("roller between tooth and bush",
          all.pressed_roller() * 1e-6,
          1e-6 / (1. / all.roller_tooth + 1. / all.roller_bush),
          2);

  std::cout << "== roller on bush, R 3.715 mm, clearance 0.045 mm, 7 mm long\n";
  const auto at = [&](const double load) {
    return drive::conforming_contact(3.715e-3, 0.045e-3, load / 7e-3, steel);
  };
  compare("half angle at 1 kN, deg", at(1e3).half_angle / degree, 10.62, 2);
  compare("peak pressure at 1 kN, MPa", at(1e3).peak_pressure * 1e-6, 132.6, 1);
  compare("approach at 1 kN, um", at(1e3).approach * 1e6, 1.877, 3);
  compare("half angle at 5 kN, deg", at(5e3).half_angle / degree, 22.93, 2);
  compare("peak pressure at 5 kN, MPa", at(5e3).peak_pressure * 1e-6, 312.2, 1);
  compare("secant stiffness at 1 kN, kN/mm",
          drive::roller_bush_stiffness(chain, 1e3, steel) * 1e-6,
          1e3 / 1.877,
          0);

  // light load: Hertz, half angle^2 = 8 q / (pi E' clearance)
  const double light = 1.;
  compare("half angle at 1 mN/mm over Hertz'",
          drive::conforming_contact(3.715e-3, 0.045e-3, light, steel).half_angle /
              std::sqrt(8. * light / (dealii::numbers::PI * steel.plane_modulus() * 0.045e-3)),
          1.,
          4);
  compare("half angle without clearance, deg",
          drive::conforming_contact(3.715e-3, 0., 1e5, steel).half_angle / degree,
          84.8,
          1);

  std::cout << "== the largest forces\n";
  // 500 MPa on 7.43 mm by 7 mm are 26005 N
  compare("half angle, deg",
          drive::largest_half_angle(3.715e-3, 0.045e-3, drive::breaking_pressure, steel) / degree,
          at(26005.).half_angle / degree,
          4);
  compare("without clearance, deg",
          drive::largest_half_angle(3e-3, 0., drive::breaking_pressure, steel) / degree,
          90.,
          4);

  // 1412 N are far from it: a quarter is enough, or four times a load that is above
  compare("pressure for the step, MPa",
          1e-6 * drive::working_pressure(chain, 1412.),
          1e-6 * 0.25 * drive::breaking_pressure,
          4);
  compare("under four times the tension of 5 kN, MPa",
          1e-6 * drive::working_pressure(chain, 5e3),
          1e-6 * 4. * 5e3 / (chain.pin_diameter * chain.bush_length),
          4);
  // over all that touches it is as stiff as the joint
  compare("modulus of the contact over stiffness per area",
          drive::contact_modulus(3.715e-3, 0.045e-3, 1412. / 7e-3, steel) * 7e-3 * 2. *
              at(1412.).half_angle * 3.715e-3 / drive::roller_bush_stiffness(chain, 1412., steel),
          1.,
          6);

  // under a light load Hertz' ellipse of half width a: a foundation K deflects by p / K, on the
  // average weighted by p by (8 / 3 pi) (2 q / pi a) / K
  const double width =
      std::sqrt(8. * light / (dealii::numbers::PI * steel.plane_modulus() * 0.045e-3)) * 3.715e-3;
  compare("foundation of a seat over Hertz'",
          drive::foundation_of_seat(3.715e-3, 0.045e-3, 7e-3, 7e-3 * light, 3e8, steel) /
              (3e8 * 16. / (3. * dealii::numbers::PI * dealii::numbers::PI * width * 7e-3)),
          1.,
          4);

  std::cout << "== plates, kN/mm, beside a finite element solution and the deviation in percent\n";
  double worst = 0.;
  for (const auto &[hole, height, ratio, expected] :
       {std::array<double, 4>{{7.43, 15.09, 0.7, 65.4}},
        {{5.24, 13.02, 0.7, 81.7}},
        {{7.43, 15.09, 1.0, 81.8}},
        {{5.24, 13.02, 1.0, 95.5}}})
    {
      const drive::Plate plate{15.875e-3, hole * 1e-3, height * 1e-3, ratio * height * 1e-3, 2e-3};
      const double       k = drive::plate_stiffness(plate, steel) * 1e-6;
      worst                = std::max(worst, std::abs(k / expected - 1.));
      std::cout << std::setprecision(1) << k << ' ' << expected << ' ' << 100. * (k / expected - 1.)
                << '\n';
    }
  verdict("all within 3.5 percent", worst < 0.035);

  std::cout << "== chain per pitch at 1412 N\n";
  const double joint = drive::bush_pin_stiffness(chain, 1412., steel);
  std::cout << std::setprecision(4) << "bush-pin joint, kN/mm: " << joint * 1e-6
            << "\nchain, kN/mm: " << drive::chain_stiffness(chain, 1412., steel) * 1e-6 << '\n';
  const double inner = 2. * drive::plate_stiffness(drive::inner_plate(chain), steel);
  const double outer = 2. * drive::plate_stiffness(drive::outer_plate(chain), steel);
  compare("two pitches: compliance over the sum of its parts",
          2. / drive::chain_stiffness(chain, 1412., steel) / (1. / inner + 1. / outer + 2. / joint),
          1.,
          9);
}
