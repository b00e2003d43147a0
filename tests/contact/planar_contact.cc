// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts of bodies that move in the plane: rollers anywhere on teeth and cylinders in bores feel
// what they feel in space, at each width of the kernels; rollers that go past teeth are told the
// piece of the profile that is nearest to them at any instant; impacts in bores obey closed forms,
// whatever their direction.
#include "../support/scenes.h"

#include <chaindrive/contact/planar_contact.h>
#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/drive.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

using namespace test;

namespace
{
const scene::ContactLaw law{1e8, 200., 0.15, 6e7, 50.};

drive::ToothForm form_of(const parameters::StandardForm standard)
{
  parameters::Sprockets sprockets;
  sprockets.tooth_form                = standard;
  sprockets.driver().outside_diameter = 81e-3;
  return drive::make_tooth_form(15, drive::make_chain(parameters::Chain()), sprockets, 0);
}

/// A body that moves and turns.
scene::Body
moving(std::mt19937 &random, const Vector3 &position, const double mass, const unsigned int number)
{
  std::uniform_real_distribution<double> any(-1., 1.);
  scene::Body                            one = body(scene::Motion::rigid,
                         scene::Mount::free(),
                         mass,
                         vector(1e-7, 1e-7, 2e-7),
                         position,
                         vector(any(random), any(random)));
  one.initial.angular_velocity               = vector(0., 0., 300. * any(random));
  one.initial.rotation                       = to_matrix(rotation_about_z(3. * any(random)));
  one.number                                 = number;
  return one;
}

/// Rollers about a sprocket that turns: in its gaps, on its tips, above and below its surface.
scene::Scene rollers_on_teeth(const drive::ToothForm &form)
{
  std::mt19937 random(7);
  scene::Scene scene        = empty_scene();
  scene.prestress           = 1e9; // overlaps are meant
  scene.loads.gravity       = 9.81;
  scene.loads.drag          = 20.;
  const double       radius = 5.08e-3;
  scene::ToothFamily teeth;
  for (unsigned int i = 0; i < 203; ++i)
    {
      const double angle = 2. * dealii::numbers::PI * i / 203.;
      double       r     = 60e-3;
      Vector3      at;
      const double wanted = i % 3 == 0 ? 20e-6 : -30e-6 * (i % 7);
      do // towards the axis, until the gap is about the wanted one
        {
          r -= 5e-6;
          at = r * vector(std::cos(angle), std::sin(angle));
        }
      while (form.closest_point(dealii::Point<2>(at[0], at[1])).distance - radius > wanted);
      scene.bodies.push_back(moving(random, at, 3e-3, i));
      for (const double z : {-2e-3, 2e-3})
        teeth.slaves.push_back({i, dealii::Point<3>(0., 0., z), radius, i});
    }
  const auto sprocket = static_cast<unsigned int>(scene.bodies.size());
  scene.bodies.push_back(ground());
  scene.bodies.back().kind = scene::Kind::sprocket;
  turn(scene, sprocket, std::make_shared<functions::Constant>(130.));
  teeth.name         = "roller-driver";
  teeth.sprocket     = sprocket;
  teeth.form         = std::make_shared<const drive::ToothForm>(form);
  teeth.teeth        = form.teeth;
  teeth.outer_radius = 0.5 * form.outside_diameter;
  teeth.half_width   = 4e-3;
  teeth.law          = law;
  scene.teeth        = {teeth};
  return scene;
}

/// Cylinders in bores, both away from the centres of their bodies, that are thrown at each other.
scene::Scene cylinders_in_bores()
{
  std::mt19937      random(11);
  scene::Scene      scene = empty_scene();
  scene::BoreFamily bores;
  bores.name      = "bore";
  bores.law       = law;
  scene.prestress = 1e9;
  for (unsigned int i = 0; i < 21; ++i)
    {
      const Vector3 place = vector(0.1 * i, 0.02);
      scene.bodies.push_back(moving(random, place, 4e-3, 2 * i));
      const Vector3 axis = place + scene.bodies.back().initial.rotation * vector(3e-3, 1e-3);
      scene.bodies.push_back(moving(random, place, 9e-3, 2 * i + 1));
      scene::Body &slave     = scene.bodies.back();
      slave.initial.position = axis - slave.initial.rotation * vector(-2e-3, 5e-4);
      for (const double z : {-3e-3, 3e-3})
        bores.pairs.push_back({2 * i,
                               dealii::Point<3>(3e-3, 1e-3, 0.),
                               2.66e-3,
                               {2 * i + 1, dealii::Point<3>(-2e-3, 5e-4, z), 2.62e-3, i}});
    }
  scene.bores = {bores};
  return scene;
}

/// What a run of @p n steps comes to: positions, velocities and rotations of all bodies, energies,
/// and the records of all points. @p is_valid becomes false if contacts are not those asked for, or
/// less than a tenth of the points touch.
std::vector<double>
outcome(scene::Scene scene, const bool planar, const unsigned int n, bool &is_valid)
{
  scene.planar = planar;
  dynamics::System system(scene, false);
  const auto      &family  = *system.contacts.families()[0];
  unsigned int     touched = 0;
  advance(system, n, 1e-7, [&]() { touched += family.n_touching(); });
  is_valid = is_valid && 10 * touched > n * family.records().size() &&
             (dynamic_cast<const contact::PlanarContact *>(&family) != nullptr) == planar;
  std::vector<double> numbers;
  for (const Frame &frame : system.world.frames)
    numbers.insert(numbers.end(),
                   {frame.position[0],
                    frame.position[1],
                    1e-3 * frame.velocity[0],
                    1e-3 * frame.velocity[1],
                    1e-5 * frame.angular_velocity[2],
                    1e-2 * frame.rotation[0][0],
                    1e-2 * frame.rotation[1][0]});
  for (const contact::Record &record : family.records())
    if (record.gap < 1e-3)
      numbers.insert(numbers.end(),
                     {record.gap,
                      1e-7 * record.force[0],
                      1e-7 * record.force[1],
                      record.force.norm() > 0. ? 1e-3 * record.feature : 0.});
  for (double Ledger::*term : Ledger::added)
    numbers.push_back(1e-3 * (system.world.ledger.*term));
  numbers.push_back(1e-3 * system.world.ledger.drive_work);
  return numbers;
}

double difference(const std::vector<double> &a, const std::vector<double> &b)
{
  double largest = a.size() == b.size() ? 0. : 1e9;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

void compare(const std::string &name, const scene::Scene &scene, const unsigned int n)
{
  bool                      is_valid = true;
  const std::vector<double> in_space = outcome(scene, false, n, is_valid);
  double                    largest  = 0.;
  for (const int width : {1, 2, 4, 8})
    if (has_simd_width(width))
      {
        setenv("CHAINDRIVE_SIMD_WIDTH", std::to_string(width).c_str(), 1);
        largest = std::max(largest, difference(in_space, outcome(scene, true, n, is_valid)));
        unsetenv("CHAINDRIVE_SIMD_WIDTH");
      }
  std::cout << name << '\n';
  verdict("  contacts are of the kind asked for, and touch", is_valid);
  verdict("  the same as in space to 1e-14 m, and as much of the rest", largest < 1e-14);
}

/// Rollers fly about teeth that do not resist them, past all pieces of the profile and through the
/// metal: whatever was nearest before, gaps are those to the nearest point.
void pass(const std::string &name, const drive::ToothForm &form)
{
  double largest = 0.;
  long   n       = 0;
  for (const int width : {1, 2, 4, 8})
    if (has_simd_width(width))
      {
        setenv("CHAINDRIVE_SIMD_WIDTH", std::to_string(width).c_str(), 1);
        scene::Scene scene  = rollers_on_teeth(form);
        scene.teeth[0].law  = {0., 0., 0., 0., 0.};
        scene.loads.gravity = scene.loads.drag = 0.;
        scene.planar                           = true;
        std::mt19937                           random(3);
        std::uniform_real_distribution<double> any(-1., 1.);
        for (scene::Body &body : scene.bodies)
          if (body.mount.is_free())
            body.initial.velocity = vector(4. * any(random), 4. * any(random));
        dynamics::System system(scene, false);
        unsigned int     step = 0;
        advance(system, 1500, 1e-6, [&]() {
          if (++step % 5 != 0)
            return;
          const Frame &sprocket = system.world.frames.back();
          const auto  &family =
              dynamic_cast<const contact::PlanarContact &>(*system.contacts.families()[0]);
          for (const unsigned int i : family.near())
            {
              const contact::Record &record = family.records()[i];
              const Vector3          at     = transpose(sprocket.rotation) *
                                 (system.world.frames[record.slave].position - sprocket.position);
              const double gap =
                  form.closest_point(dealii::Point<2>(at[0], at[1])).distance - 5.08e-3;
              largest = std::max(largest, std::abs(gap - record.gap));
              ++n;
            }
        });
        unsetenv("CHAINDRIVE_SIMD_WIDTH");
      }
  verdict(name + " that go past: gaps to 1e-14 m, of 10,000 or more",
          n >= 10000 && largest < 1e-14);
}

/// Two bodies, one in the bore of the other, meet at the speed 1 m/s in the direction @p angle.
void impact(const double angle, const double damping, double &restitution, double &worst)
{
  const double  m1 = 4e-3, m2 = 9e-3, k = 1e8, m = m1 * m2 / (m1 + m2);
  const Vector3 along = vector(std::cos(angle), std::sin(angle));
  scene::Scene  scene = empty_scene();
  scene.bodies        = {
             body(scene::Motion::rigid, scene::Mount::free(), m1, vector(1e-7, 1e-7, 2e-7), Vector3()),
             body(scene::Motion::rigid,
           scene::Mount::free(),
           m2,
           vector(1e-7, 1e-7, 2e-7),
           35e-6 * along,
           along)};
  scene.bodies[1].number = 1;
  const scene::ContactLaw spring{k / 2, damping * std::sqrt(k * m), 0., 0., 0.};
  scene.bores = {
      {"bore",
       scene::Interface::other,
       spring,
       {{0, dealii::Point<3>(), 2.66e-3, {1, dealii::Point<3>(0., 0., 1e-3), 2.62e-3, 0}},
        {0, dealii::Point<3>(), 2.66e-3, {1, dealii::Point<3>(0., 0., -1e-3), 2.62e-3, 0}}}}};
  scene.planar = true;
  dynamics::System system(scene, false);
  advance(system, 4000, 1e-8, []() {});
  const Vector3 u1 = system.world.frames[0].velocity, u2 = system.world.frames[1].velocity;
  restitution = (u1 - u2) * along;
  worst       = std::max({worst,
                          std::abs((m1 * u1 + m2 * u2 - m2 * along).norm() / m2),
                          std::abs(system.world.ledger.imbalance()) / (0.5 * m2)});
}
} // namespace

int main()
{
  compare("rollers on teeth of ISO 606",
          rollers_on_teeth(form_of(parameters::StandardForm::iso_min)),
          20);
  compare("rollers on teeth of ANSI/ASME B29.1",
          rollers_on_teeth(form_of(parameters::StandardForm::ansi)),
          20);
  compare("rollers on teeth of chords",
          rollers_on_teeth(form_of(parameters::StandardForm::iso_max).faceted(22)),
          20);
  drive::ToothForm    off_place = form_of(parameters::StandardForm::iso_min);
  std::vector<double> index;
  for (unsigned int k = 0; k < off_place.teeth; ++k)
    index.push_back(20e-6 * std::cos(3. * k));
  off_place.shift_gaps(index);
  compare("rollers on teeth off their places", rollers_on_teeth(off_place), 20);
  compare("cylinders in bores", cylinders_in_bores(), 400);
  pass("rollers on teeth of ISO 606", form_of(parameters::StandardForm::iso_min));
  pass("rollers on teeth of ANSI/ASME B29.1", form_of(parameters::StandardForm::ansi));
  pass("rollers on teeth of chords", form_of(parameters::StandardForm::iso_max).faceted(22));
  pass("rollers on teeth off their places", off_place);

  const double xi = 0.1, root = std::sqrt(1. - xi * xi);
  // contact ends when k d + c d' = 0 (Schwager and Poeschel 2007)
  const double damped = std::exp(
      -xi / root * (dealii::numbers::PI - std::atan(2. * xi * root / (1. - 2. * xi * xi))));
  double worst = 0.;
  for (const double angle : {0., 0.4, 2.5, -1.1})
    {
      double restitution = 0.;
      impact(angle, 0., restitution, worst);
      ratio("restitution of an undamped impact", restitution, 1., 3);
      impact(angle, xi, restitution, worst);
      ratio("restitution with damping ratio 0.1", restitution, damped, 3);
    }
  verdict("momentum and energy balance to 1e-4", worst < 1e-4);
}
