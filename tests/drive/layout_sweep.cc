// SPDX-License-Identifier: LGPL-2.1-or-later

// Layouts of many drives: every distance of bushes exact, the loop closed, no roller within a
// tooth, rollers on their pitch circle, regions in order, links on their joints.

#include "compare.h"
#include "forms.h"

#include <chaindrive/drive/layout.h>

#include <deal.II/base/numbers.h>

using namespace chaindrive;

namespace
{
struct Worst
{
  double   spacing = 0., overlap = 0., seat = 0., link = 0., bush = 0.;
  unsigned drives = 0, refused = 0, disordered = 0;
};

void check(const parameters::Drive &drive, const bool clearances, Worst &worst)
{
  const auto chain = drive::make_chain(drive.chain);
  const auto forms = forms_of(drive, chain);
  ++worst.drives;
  drive::Layout layout;
  try
    {
      layout = drive::make_layout(drive, chain, forms, clearances, 3e8, 100., 1000.);
    }
  catch (const InputError &error)
    {
      if (++worst.refused <= 3)
        std::cout << drive.sprockets.driver().teeth << '/' << drive.sprockets.driven().teeth << ' '
                  << drive.n_links << ' ' << text_of(drive.layout.centre_distance_from) << ' '
                  << drive.layout.start_phase << ": " << error.what() << '\n';
      return;
    }
  const auto        &joints = layout.joints;
  const unsigned int n      = drive.n_links;
  if (joints.size() != n || layout.links.size() != n ||
      layout.sprockets[0].seats + layout.sprockets[1].seats + layout.tight().links +
              layout.slack().links !=
          n + 2)
    ++worst.disordered;

  const bool   concentric = clearances && drive.layout.start == parameters::Start::concentric;
  const double stretch    = 1000. / 3e8;
  int          region     = 0;
  for (unsigned int k = 0; k < n; ++k)
    {
      const auto &a = joints[k], &b = joints[(k + 1) % n];
      // sprocket 0, span 0, sprocket 1, span 1
      const int place = a.sprocket >= 0 ? 2 * a.sprocket : k < layout.tight().first ? 1 : 3;
      if (place < region)
        ++worst.disordered;
      region = place;

      const bool seated   = a.tooth_gap >= 0 && b.tooth_gap >= 0 && a.sprocket == b.sprocket;
      const bool in_tight = k >= layout.tight().first;
      double     expected = chain.loaded_pitch();
      if (clearances)
        expected = k % 2 == 0 ? chain.loaded_inner_pitch() : chain.loaded_outer_pitch();
      if (concentric && !seated)
        expected = k % 2 == 0 ? chain.inner_hole_pitch : chain.outer_hole_pitch;
      if (drive.layout.start == parameters::Start::settled && in_tight)
        expected += !clearances ? stretch : k % 2 == 1 ? 2. * stretch : 0.;
      worst.spacing = std::max(worst.spacing, std::abs(a.bush.distance(b.bush) - expected));
      worst.link    = std::max(worst.link,
                            (layout.links[k].centre - 0.5 * (a.bush + b.bush)).norm() +
                                std::abs(std::sin(layout.links[k].angle) * (b.bush - a.bush)[0] -
                                         std::cos(layout.links[k].angle) * (b.bush - a.bush)[1]));
      worst.bush    = std::max(worst.bush, a.bush.distance(a.roller) - chain.roller_clearance());

      for (const int i : {0, 1})
        {
          const auto            &form  = forms[i];
          const double           angle = layout.sprockets[i].angle;
          const auto             arm   = a.roller - layout.sprockets[i].centre;
          const dealii::Point<2> local(std::cos(angle) * arm[0] + std::sin(angle) * arm[1],
                                       std::cos(angle) * arm[1] - std::sin(angle) * arm[0]);
          const auto             nearest = form.closest_point(local);
          worst.overlap = std::max(worst.overlap, 0.5 * chain.roller_diameter - nearest.distance);
          if (a.sprocket == i)
            {
              const double seat = a.tooth_gap * form.pitch_angle();
              const double r    = 0.5 * chain.loaded_pitch() / std::sin(0.5 * form.pitch_angle());
              worst.seat        = std::max(
                  worst.seat, local.distance(r * dealii::Point<2>(std::cos(seat), std::sin(seat))));
              if (static_cast<int>(nearest.tooth_gap) != a.tooth_gap)
                ++worst.disordered;
            }
        }
    }
}

void report(const std::string &name, const Worst &worst)
{
  std::cout << name << ": " << worst.drives << " drives, " << worst.refused << " refused\n";
  verdict("  distances of bushes exact to 1e-9 mm", worst.spacing < 1e-12);
  verdict("  no roller deeper than 1e-9 m in a tooth", worst.overlap <= 1e-9);
  verdict("  seated rollers in their gaps to 1e-9 mm", worst.seat < 1e-12);
  verdict("  links between their joints to 1e-9 mm", worst.link < 1e-12);
  verdict("  bushes within their rollers", worst.bush <= 1e-9);
  verdict("  joints in the order driver, slack, driven, tight", worst.disordered == 0);
}
} // namespace

int main()
{
  // chain length for spans of about `spans` pitches
  const auto links = [](const unsigned int z1, const unsigned int z2, const unsigned int spans) {
    const double d = (static_cast<double>(z2) - z1) / 6.2832;
    return 2 * ((static_cast<unsigned int>(2. * spans + 0.5 * (z1 + z2) + d * d / spans) + 1) / 2);
  };

  for (const auto start :
       {parameters::Start::taut, parameters::Start::settled, parameters::Start::concentric})
    for (const bool clearances : {false, true})
      {
        if (!clearances && start == parameters::Start::concentric)
          continue;
        Worst worst;
        for (const auto &[z1, z2] : {std::pair<unsigned, unsigned>{9, 9},
                                     {9, 40},
                                     {11, 23},
                                     {15, 42},
                                     {25, 25},
                                     {19, 57},
                                     {42, 15},
                                     {60, 13},
                                     {14, 120}})
          for (const unsigned int spans : {8u, 21u, 40u, 110u})
            for (const auto from :
                 {parameters::CentreDistanceFrom::slack, parameters::CentreDistanceFrom::sag})
              for (const auto tight : {parameters::TightSide::upper, parameters::TightSide::lower})
                for (const double phase : {0., 0.13, 0.5, 0.87, 0.999})
                  {
                    if (spans < 30 && z1 + z2 > 2 * spans)
                      continue;
                    parameters::Drive drive;
                    drive.sprockets.driver().teeth    = z1;
                    drive.sprockets.driven().teeth    = z2;
                    drive.n_links                     = links(z1, z2, spans);
                    drive.layout.centre_distance_from = from;
                    drive.layout.slack                = 1e-3;
                    drive.layout.sag                  = 0.015;
                    drive.layout.tight_span           = tight;
                    drive.layout.start_phase          = phase;
                    drive.layout.start                = start;
                    check(drive, clearances, worst);
                  }
        report(text_of(start) + (clearances ? ", with clearances" : ", without"), worst);
      }

  Worst worst;
  for (int i = 0; i < 200; ++i)
    {
      parameters::Drive drive;
      drive.layout.centre_distance_from = parameters::CentreDistanceFrom::given;
      drive.layout.centre_distance      = 635e-3 + i * 8.2e-3 / 199;
      drive.layout.start_phase          = std::fmod(0.37 * i, 1.);
      check(drive, i % 2 == 0, worst);
    }
  report("15/42, C given from 635 to 643.2 mm", worst);

  worst = Worst();
  for (int i = 0; i < 50; ++i)
    {
      parameters::Drive drive;
      drive.chain.pitch_set                    = parameters::PitchSet::paper_literal;
      drive.sprockets.seat_centre              = parameters::SeatCentre::bottom_diameter;
      drive.sprockets.driver().bottom_diameter = 66.28e-3;
      drive.sprockets.driven().bottom_diameter = 202.82e-3;
      drive.layout.start_phase                 = 0.02 * i;
      check(drive, i % 2 == 0, worst);
    }
  report("paper literal", worst);

  worst = Worst();
  for (const unsigned int n : {20u, 21u, 75u, 111u, 600u})
    {
      parameters::Drive drive;
      drive.sprockets.driver().teeth = n < 50 ? 9 : 17;
      drive.sprockets.driven().teeth = n < 50 ? 9 : 21;
      drive.n_links                  = n;
      check(drive, false, worst);
    }
  report("odd and extreme numbers of links", worst);
}
