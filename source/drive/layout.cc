// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/drive/hanging_span.h>
#include <chaindrive/drive/layout.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;
using parameters::CentreDistanceFrom;

namespace
{
constexpr double overlap_tolerance = 1e-9; // m

/// @p lengths under a tension that stretches the chain by @p stretch [m] per pitch.
path::LinkLengths
stretched(const path::LinkLengths &lengths, const bool clearances, const double stretch)
{
  // per pitch; rigid links with clearances stretch in the two joints of every outer link
  return clearances ? path::LinkLengths{lengths.inner, lengths.outer + 2. * stretch} :
                      path::LinkLengths{lengths.inner + stretch, lengths.outer + stretch};
}

/// What the chain is to be fitted with: the distances of bushes on the sprockets and in either
/// span, all from the loaded pitches of the chain, longer by the tension of the start over the
/// stiffness of a pitch; @p in_both [N] is added in both. On the sprockets they are never
/// stretched: seats decide there.
Fitter make_fitter(const parameters::Drive &drive,
                   const ChainDimensions   &chain,
                   const bool               clearances,
                   const double             stiffness_per_pitch,
                   const double             tight_tension,
                   const bool               weightless,
                   const double             in_both)
{
  const parameters::Layout &layout = drive.layout;
  Fitter                    fitter;
  fitter.sprockets  = wheels_of(drive.sprockets, chain);
  path::Chain &laid = fitter.chain;
  laid.n_links      = drive.n_links;
  laid.phase        = layout.start_phase;
  if (const parameters::Guide &guide = drive.sprockets.driver().guide; guide.is_sprung())
    for (const auto &p : guide.points)
      fitter.pressing.emplace_back(p[0], p[1]);
  if (weightless)
    fitter.gravity = 0;
  else if (layout.tight_span == parameters::TightSide::lower) // the drive is mirrored
    fitter.gravity = 1;

  const double mean = chain.loaded_pitch();
  laid.seats        = clearances ?
                          path::LinkLengths{chain.loaded_inner_pitch(), chain.loaded_outer_pitch()} :
                          path::LinkLengths{mean, mean};
  laid.taut = laid.slack = laid.seats;
  if (clearances && layout.start == parameters::Start::concentric)
    laid.taut = laid.slack = {chain.inner_hole_pitch, chain.outer_hole_pitch};

  const double everywhere = layout.centre_distance_from == CentreDistanceFrom::pretension ?
                                layout.pretension / stiffness_per_pitch :
                                0.;
  const double in_tight =
      layout.start == parameters::Start::settled ? tight_tension / stiffness_per_pitch : everywhere;
  const double stretch = in_both / stiffness_per_pitch;
  laid.taut            = stretched(laid.taut, clearances, in_tight + stretch);
  laid.slack           = stretched(laid.slack, clearances, everywhere + stretch);
  return fitter;
}

void check_entries(const parameters::Drive &drive, const bool clearances)
{
  const parameters::Layout &layout = drive.layout;
  if (!(layout.start_phase >= 0. && layout.start_phase < 1.))
    throw InputError("Drive/Layout/Start phase = " + to_text(layout.start_phase) +
                     " must be at least 0 and less than 1.");
  if (clearances && drive.n_links % 2 == 1)
    throw InputError("Drive/Number of links = " + std::to_string(drive.n_links) +
                     " is odd: inner and outer links would not alternate without an offset link, "
                     "which there is not; take an even number.");
  if (layout.start == parameters::Start::concentric &&
      layout.centre_distance_from == CentreDistanceFrom::pretension)
    throw InputError("Drive/Layout/Start = concentric has no contact in its joints, so Centre "
                     "distance from = pretension cannot be; choose Start = taut.");
}

int modulo(const int a, const unsigned int n)
{
  const int m = static_cast<int>(n);
  return ((a % m) + m) % m;
}

/// Unit vector to the right of @p direction: outward for a chain that runs counter-clockwise.
Tensor<1, 2> right_of(const Tensor<1, 2> &direction)
{
  Tensor<1, 2> normal;
  normal[0] = direction[1];
  normal[1] = -direction[0];
  return normal;
}

/// y -> -y: the lower span is tight, all sprockets turn clockwise.
void mirror(Layout &layout, const std::vector<ToothForm> &forms)
{
  layout.sense = -1;
  for (std::optional<Tensioner> *tensioner : {&layout.tensioner, &layout.clamped})
    if (*tensioner)
      (*tensioner)->mirror();
  for (Layout::Sprocket &sprocket : layout.sprockets)
    {
      sprocket.centre[1]       = 0. - sprocket.centre[1]; // and no negative zero
      sprocket.eccentricity[1] = 0. - sprocket.eccentricity[1];
      sprocket.angle           = -sprocket.angle;
      sprocket.speed           = -sprocket.speed;
    }
  for (Layout::Span &span : layout.spans)
    {
      span.direction[1] = -span.direction[1];
      span.normal[1]    = -span.normal[1];
    }
  for (Layout::Joint &joint : layout.joints)
    {
      joint.roller[1]   = -joint.roller[1];
      joint.bush[1]     = -joint.bush[1];
      joint.velocity[1] = -joint.velocity[1];
      if (joint.sprocket >= 0)
        joint.tooth_gap = modulo(-joint.tooth_gap, forms[joint.sprocket].teeth);
    }
}

/// What is wrong with the layout, in a sentence; empty if nothing is. Every roller is compared with
/// the profile of every sprocket that it may reach, in the frame of the sprocket: one that sits in
/// its gap has the gap zero, those before the first and after the last seat are the ones that may
/// be too near. With clearances a bush may be off its roller's centre by the clearance between
/// them.
std::string find_overlap(const Layout                 &layout,
                         const parameters::Sprockets  &sprockets,
                         const ChainDimensions        &chain,
                         const std::vector<ToothForm> &forms,
                         const bool                    clearances)
{
  const double radius = 0.5 * chain.roller_diameter;
  for (unsigned int k = 0; k < layout.joints.size(); ++k)
    {
      const Layout::Joint &joint = layout.joints[k];
      for (unsigned int i = 0; i < layout.sprockets.size(); ++i)
        {
          const ToothForm   &form  = forms[i];
          const double       angle = layout.sprockets[i].angle;
          const Tensor<1, 2> arm   = joint.roller - layout.sprockets[i].centre;
          if (arm.norm() > 0.5 * form.outside_diameter + radius)
            continue;
          const double c = std::cos(angle), s = std::sin(angle);
          const auto   nearest =
              form.closest_point(Point<2>(c * arm[0] + s * arm[1], c * arm[1] - s * arm[0]));
          if (const double gap = nearest.distance - radius; gap < -overlap_tolerance)
            return "roller " + std::to_string(k) + " overlaps gap " +
                   std::to_string(nearest.tooth_gap) + " of the " + sprockets.list[i].in_words() +
                   " by " + in_mm(-gap) + " at the start: " +
                   (joint.sprocket < 0 ?
                        "it is beside its wheel in a span; choose another Layout/Start phase, less "
                        "slack or more links." :
                        "chain and sprocket do not fit (loaded pitch " +
                            in_mm(chain.loaded_pitch()) + ", bottom diameter " +
                            in_mm(form.root_diameter) + ").");
        }
      const double offset = joint.bush.distance(joint.roller);
      if (clearances && offset > chain.roller_clearance() + overlap_tolerance)
        return "the bush of joint " + std::to_string(k) + " overlaps its roller by " +
               in_mm(offset - chain.roller_clearance()) + " at the start: the loaded pitches " +
               in_mm(chain.loaded_inner_pitch()) + " and " + in_mm(chain.loaded_outer_pitch()) +
               " differ by more than the clearance " + in_mm(chain.roller_clearance()) +
               " between bush and roller makes up for.";
    }
  return "";
}

/// Where a chain with these joints comes closer to itself than @p height: a joint and the first one
/// of a link that is some links away.
std::optional<std::pair<std::size_t, std::size_t>> meeting(const std::vector<Point<2>> &joints,
                                                           const double                 height)
{
  const std::size_t n = joints.size(), some = 4;
  double            longest = 0.;
  for (std::size_t k = 0; k < n; ++k)
    longest = std::max(longest, joints[k].distance(joints[(k + 1) % n]));
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t away = some; away + some < n;)
      {
        const std::size_t  first    = (k + away) % n;
        const Tensor<1, 2> along    = joints[(first + 1) % n] - joints[first];
        const Tensor<1, 2> arm      = joints[k] - joints[first];
        const double       part     = std::clamp(arm * along / along.norm_square(), 0., 1.);
        const double       distance = (arm - part * along).norm();
        if (distance < height)
          return std::make_pair(k, first);
        // those are farther that the chain cannot bring nearer by its length
        away += 1 + static_cast<std::size_t>((distance - height) / longest);
      }
  return {};
}

/// More than two wheels may stand so that the chain would lie on itself, if its slack span were
/// straight or only as it hangs, or run into a wheel on its way to others.
void check_apart(const Fit                    &fit,
                 const Fitter                 &fitter,
                 const parameters::Sprockets  &sprockets,
                 const std::vector<ToothForm> &forms,
                 const double                  height)
{
  const std::size_t              n     = fit.wheels.size();
  const path::SlackSpan         &slack = fit.laid.slack;
  const std::vector<path::Joint> all   = path::joints(fit.wheels, fitter.chain, fit.laid);
  std::vector<Point<2>>          hanging, straight;
  std::vector<std::size_t>       behind; // the wheel on which a joint is, or from which it comes
  const std::size_t              first = fit.laid.route.wraps[0]; // of the slack span
  for (const path::Joint &joint : all)
    {
      const std::size_t k = hanging.size();
      hanging.push_back(joint.bush);
      straight.push_back(joint.bush);
      if (k > first && k < first + slack.links)
        straight.back() =
            slack.from + static_cast<double>(k - first) / slack.links * (slack.to - slack.from);
      behind.push_back(joint.wheel >= 0 ? joint.wheel : behind.back());
    }
  const auto name  = [&](const std::size_t wheel) { return sprockets.list[wheel % n].name; };
  const auto place = [&](const std::size_t k) {
    return all[k].wheel >= 0 ? "on " + name(behind[k]) :
                               "between " + name(behind[k]) + " and " + name(behind[k] + 1);
  };
  if (const auto met = meeting(straight, height))
    throw InputError("Drive/Wheels: the chain " + place(met->first) + " would lie on the chain " +
                     place(met->second) + ": they must be " + in_mm(height, 4) +
                     " apart, the height of a plate; choose other places, or another order or "
                     "side, of wheels.");
  if (const auto met = meeting(hanging, height))
    throw InputError("Drive/Layout: with " + in_mm(slack.slack) + " of slack the chain " +
                     place(met->first) + " would hang down onto the chain " + place(met->second) +
                     "; choose less slack or fewer links, or other places of wheels.");
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < all.size(); ++k)
      {
        const bool is_beside = behind[k] == i || (behind[k] + 1) % n == i ||
                               (all[k].wheel >= 0 && behind[k] == (i + 1) % n);
        const double least = 0.5 * (forms[i].outside_diameter + height);
        if (!is_beside && straight[k].distance(fit.wheels[i].centre) < least)
          throw InputError("Drive/Wheels: the chain " + place(k) + " would run into " + name(i) +
                           ": it must pass at least " + in_mm(least, 4) +
                           " from its centre; choose another place, or another order or side, of "
                           "a wheel.");
      }
}

/// The slack span is an arc of equal angles between its links. It must neither turn back, which
/// takes half a turn, nor, where it hangs inwards, lie on the tight one of two sprockets.
void check_slack(const Fit &fit, const Fitter &fitter, const double height, const bool even)
{
  const path::SlackSpan &slack = fit.laid.slack;
  if ((slack.links - 1) * std::abs(slack.turn) > PI)
    {
      const path::SlackSpan taut  = fitter.fits(fit.centre_distance, true, 1).front().laid.slack;
      const double          chord = taut.from.distance(taut.to);
      throw InputError(
          "Drive/Layout: the chain has " + in_mm(taut.slack) + " of slack at the centre distance " +
          in_mm(fit.centre_distance) + ", so that the slack span would turn back; at most " +
          advised_links(fitter, (0.5 * PI - 1.) * chord - taut.slack, even) + " links fit.");
    }
  if (fit.wheels.size() > 2)
    return; // check_apart()
  for (const path::TautSpan &span : fit.laid.taut)
    for (const Point<2> &p : path::slack_joints(slack, fitter.chain.slack))
      {
        const double       length = span.from.distance(span.to);
        const Tensor<1, 2> along = (span.to - span.from) / length, arm = p - span.from;
        const double       beside = along[0] * arm[1] - along[1] * arm[0];
        // the tight span has all of the loop on one side
        if (arm * along > 0. && arm * along < length && beside < height)
          throw InputError("Drive/Layout: with " + in_mm(slack.slack) +
                           " of slack the slack span would hang down onto another one; use fewer "
                           "links, a greater centre distance, or Tight span = upper.");
      }
}

/// Why the chain closes on no route: the entry that decides the centre distance, its value, and up
/// to where there is one.
std::string no_route(const parameters::Layout &layout,
                     const Fitter             &fitter,
                     const double              least_distance,
                     const bool                even)
{
  const std::string what = ": the chain closes on no route around these sprockets";
  if (fitter.tensioner)
    return "Drive/Wheels" + what + "; choose another number of links, or other places of wheels.";
  if (layout.centre_distance_from == CentreDistanceFrom::given)
    return "Drive/Layout/Centre distance in mm = " + to_text(layout.centre_distance * 1e3, 7) +
           what + "; choose a larger one, or Centre distance from = slack.";
  if (layout.centre_distance_from == CentreDistanceFrom::pretension)
    return "Drive/Layout/Pretension in N = " + to_text(layout.pretension) + what +
           "; choose another number of links.";

  parameters::Layout trial = layout;
  const bool         sag   = layout.centre_distance_from == CentreDistanceFrom::sag;
  double            &value = sag ? trial.sag : trial.slack;
  double             low = 0., high = value;
  // bisection: the largest value for which some route closes, to a millionth of the one asked for
  for (unsigned int i = 0; i < 20; ++i)
    {
      value         = 0.5 * (low + high);
      bool possible = false;
      try
        {
          const Proposal proposal = propose(fitter, trial, least_distance, even);
          for (const Fit &near : proposal.fits)
            {
              const auto fit =
                  fitter.solve(*proposal.target, near.laid.route, near.centre_distance);
              possible = possible || (fit && fit->laid.slack.links >= 1);
            }
        }
      catch (const InputError &)
        {
        }
      (possible ? low : high) = value;
    }
  const double unit = sag ? 1e2 : 1e3;
  const double most = std::floor(low * unit * 10.) / 10.;
  return std::string("Drive/Layout/") + (sag ? "Sag in percent" : "Slack in mm") + " = " +
         to_text((sag ? layout.sag : layout.slack) * unit) + what +
         (most > 0. ? "; choose at most " + to_text(most, 4) + "." :
                      ", nor would it with less; choose another number of links.");
}
} // namespace

const Layout::Span &Layout::into(const unsigned int sprocket) const
{
  return spans[(sprocket + spans.size() - 1) % spans.size()];
}

Layout
to_layout(const std::vector<path::Wheel> &wheels, const path::Chain &chain, const path::Laid &laid)
{
  Layout layout{};
  layout.sense = 1;
  for (const path::Joint &joint : path::joints(wheels, chain, laid))
    {
      int gap = joint.seat;
      if (joint.wheel >= 0 && wheels[joint.wheel].teeth > 0)
        gap = modulo(wheels[joint.wheel].turn * gap, wheels[joint.wheel].teeth);
      layout.joints.push_back({joint.roller, joint.bush, {}, joint.wheel, gap});
    }
  unsigned int first = 0; // joint of the span: the last seat of the wheel before it
  for (unsigned int i = 0; i < wheels.size(); ++i)
    {
      const path::Wheel &wheel = wheels[i];
      const unsigned int wrap  = laid.route.wraps[i];
      layout.sprockets.push_back({wheel.centre, laid.entry[i], 0., wrap + 1, wheel.turn});
      first += wrap;
      const bool         slack = i == 0;
      const Point<2>    &from  = slack ? laid.slack.from : laid.taut[i - 1].from;
      const Point<2>    &to    = slack ? laid.slack.to : laid.taut[i - 1].to;
      const unsigned int links = slack ? laid.slack.links : laid.taut[i - 1].links;
      const Tensor<1, 2> along = (to - from) / from.distance(to);
      layout.spans.push_back({!slack,
                              first,
                              links,
                              slack ? laid.slack.slack : 0.,
                              slack ? laid.slack.sag() : 0.,
                              along,
                              right_of(along)});
      first += links;
    }
  return layout;
}

bool keeps_sag(const parameters::Layout &layout)
{
  return layout.start == parameters::Start::settled &&
         layout.centre_distance_from == CentreDistanceFrom::sag;
}

// The velocities v = w x r of a straight span's ends along it are the same. With r from either
// centre and d along the span, w2 (r2 x d) = w1 (r1 x d), where r1 x d and r2 x d are the distances
// of the centres from the span's line; their ratio is the instantaneous speed ratio. From the
// driver on it goes against the travel, over all spans but the slack one. Joints on a sprocket turn
// with it; in spans the velocity changes linearly from one end to the other.
void set_in_motion(Layout &layout, const double driver_speed)
{
  const unsigned int n      = layout.joints.size();
  layout.sprockets[0].speed = layout.sense * driver_speed;
  for (unsigned int i = static_cast<unsigned int>(layout.sprockets.size()) - 1; i > 0; --i)
    {
      const Layout::Span     &span   = layout.spans[i];
      Layout::Sprocket       &before = layout.sprockets[i];
      const Layout::Sprocket &after  = layout.sprockets[(i + 1) % layout.sprockets.size()];
      const Point<2>         &to     = layout.joints[(span.first + span.links) % n].bush;
      const Point<2>         &from   = layout.joints[span.first].bush;
      before.speed                   = after.speed * cross(to - after.axis(), to - from) /
                     cross(from - before.axis(), to - from);
    }

  for (Layout::Joint &joint : layout.joints)
    if (joint.sprocket >= 0)
      {
        const Layout::Sprocket &sprocket = layout.sprockets[joint.sprocket];
        const Tensor<1, 2>      arm      = joint.roller - sprocket.axis();
        joint.velocity[0]                = -sprocket.speed * arm[1];
        joint.velocity[1]                = sprocket.speed * arm[0];
      }
  for (const Layout::Span &span : layout.spans)
    {
      const Tensor<1, 2> a = layout.joints[span.first].velocity;
      const Tensor<1, 2> b = layout.joints[(span.first + span.links) % n].velocity;
      for (unsigned int i = 1; i < span.links; ++i)
        layout.joints[span.first + i].velocity = a + static_cast<double>(i) / span.links * (b - a);
    }
}

void set_links(Layout &layout)
{
  const unsigned int n = layout.joints.size();
  layout.links.clear();
  for (unsigned int k = 0; k < n; ++k)
    {
      const Point<2> &a = layout.joints[k].bush, &b = layout.joints[(k + 1) % n].bush;
      layout.links.push_back(
          {Point<2>(0.5 * (a + b)), std::atan2(b[1] - a[1], b[0] - a[0]), k % 2 == 0});
    }
}

Layout make_layout(const parameters::Drive      &drive,
                   const ChainDimensions        &chain,
                   const std::vector<ToothForm> &forms,
                   const bool                    clearances,
                   const double                  stiffness_per_pitch,
                   const double                  driver_speed,
                   const double                  tight_tension,
                   const bool                    weightless,
                   const double                  weight,
                   const double                  centrifugal)
{
  check_entries(drive, clearances);
  const auto fitter_with = [&](const double in_both) {
    return make_fitter(
        drive, chain, clearances, stiffness_per_pitch, tight_tension, weightless, in_both);
  };
  Fitter fitter = fitter_with(0.);
  check_wheels(drive.sprockets, drive.layout, forms, fitter);
  unsigned int moved = 1;
  for (unsigned int i = 1; i < fitter.sprockets.size(); ++i)
    if (fitter.sprockets[i].moves)
      moved = i;
  const double       least     = 0.5 * (forms[0].outside_diameter + forms[moved].outside_diameter);
  const unsigned int tensioned = tensioned_wheel(drive.sprockets);
  const auto         proposed  = [&]() {
    if (tensioned == 0)
      {
        fitter.rises = slack_rises(fitter, drive.layout.centre_distance);
        return propose(fitter, drive.layout, least, clearances);
      }
    set_tensioner(drive, fitter);
    const bool clamped = fitter.tensioner->is_clamped();
    return take_up(fitter,
                   clamped ? wanted(drive.layout) : Fitter::Target{Fitter::Target::Kind::slack, 0.},
                   drive.sprockets.list[tensioned].name,
                   clearances);
  };
  Proposal proposal = proposed();
  if (keeps_sag(drive.layout) && drive.layout.sag > 0. && !proposal.fits.empty())
    {
      // the span is longer by the stretch, which changes its tension by as small a part
      const path::SlackSpan &slack = proposal.fits.front().laid.slack;
      const HangingSpan      hung{slack.from.distance(slack.to), weight, 0.};
      fitter   = fitter_with(hung.tension_of_sag(drive.layout.sag * hung.length) + centrifugal);
      proposal = proposed();
    }

  // The best route may leave a roller just short of its seat, touching a flank: then it belongs on
  // the sprocket, which is one of the next routes.
  std::string problem;
  for (const Fit &near : proposal.fits)
    {
      const std::optional<Fit> found =
          proposal.target ? fitter.solve(*proposal.target, near.laid.route, near.centre_distance) :
                            near;
      if (!found || found->laid.slack.links < 1)
        continue;
      const Fit &fit = *found;
      check_loop(fit.wheels);
      const double height = std::max(chain.inner_plate_height, chain.outer_plate_height);
      check_slack(fit, fitter, height, clearances);
      if (fit.wheels.size() > 2)
        check_apart(fit, fitter, drive.sprockets, forms, height);
      Layout layout = to_layout(fit.wheels, fitter.chain, fit.laid);
      for (std::size_t i = 0; i < layout.sprockets.size(); ++i)
        layout.sprockets[i].eccentricity = fitter.sprockets[i].eccentricity;
      layout.moved = moved;
      layout.rises = fitter.rises;
      if (tensioned > 0)
        {
          auto &held   = fitter.tensioner->is_clamped() ? layout.clamped : layout.tensioner;
          held         = fitter.tensioner;
          held->travel = fit.centre_distance;
        }
      if (drive.layout.start == parameters::Start::settled)
        set_in_motion(layout, std::abs(driver_speed));
      if (drive.layout.tight_span == parameters::TightSide::lower)
        mirror(layout, forms);
      const std::string overlap = find_overlap(layout, drive.sprockets, chain, forms, clearances);
      if (overlap.empty())
        {
          for (Layout::Sprocket &sprocket : layout.sprockets)
            sprocket.angle = std::remainder(sprocket.angle, 2. * PI);
          set_links(layout);
          return layout;
        }
      if (problem.empty())
        problem = overlap;
    }
  throw InputError(problem.empty() ? no_route(drive.layout, fitter, least, clearances) :
                                     "Drive: " + problem);
}
} // namespace chaindrive::drive
