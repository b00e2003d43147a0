// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>
#include <chaindrive/utilities/rotation.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace chaindrive::scene
{
/// A sprocket, as those see it who look at a drive that runs.
struct Sprocket
{
  std::string          name;  ///< of histories
  std::string          title; ///< what sentences call it
  parameters::Role     role;
  unsigned int         body;
  unsigned int         shaft; ///< the body that its shaft turns: itself, or what its coupling does
  unsigned int         teeth;
  int                  sense;        ///< of its rotation in operation, +1: about +z
  double               pitch_radius; ///< of the loaded pitch, m
  dealii::Tensor<1, 3> entry_normal; ///< unit, outward, of the side on which the chain arrives
  bool                 flat = false; ///< a drum: its teeth are the sectors in which it is described
};

/// The chain between two sprockets. Its straight line touches their pitch circles.
struct Span
{
  std::string          name;       ///< of histories: those of the two sprockets
  unsigned int         from, to;   ///< sprockets, in the direction of travel
  dealii::Tensor<1, 3> along;      ///< unit, from the centre of the first sprocket to the second
  double               length;     ///< distance of the centres, m
  double               begin, end; ///< where the line touches them, along #along from the first, m
  dealii::Tensor<1, 3> direction;  ///< of travel at the start, unit
  dealii::Tensor<1, 3> normal;     ///< outward, unit
};

/// What those who look at a run know of its drive: which bodies are the chain, round which
/// sprockets it runs, in which order. Joints are counted in the direction of travel, link k joins
/// joints k and k + 1. SI units.
struct DriveView
{
  unsigned int strands = 1; ///< alike, of which the scene has one for all; 1 also
                            ///< where it has all of them (Scene::strands)
  unsigned int              n_joints = 0;
  std::vector<unsigned int> rollers;    ///< body of each joint's roller; where bushes are in its
                                        ///< place, the inner link that each belongs to
  std::vector<dealii::Point<3>> bushes; ///< there: its middle in that link's frame, m; else empty
  std::vector<unsigned int>     links;  ///< body of each link; empty where bars are the links
  std::vector<char>             seated; ///< per joint: it starts on a sprocket, not in a span
  std::vector<Sprocket>         sprockets; ///< in the order of travel: the driver first
  std::vector<Span>             spans;     ///< span i leads from sprocket i to the next one
  int                           sense               = 1;  ///< +1: counter-clockwise drive
  double                        pitch               = 0.; ///< loaded, mean, m
  double                        mass_per_pitch      = 0.; ///< kg, of one strand
  double                        stiffness_per_pitch = 0.; ///< N/m, of one strand
  unsigned int strand = 0; ///< of these rollers and links, which InterfaceOf knows it by; 0 is the
                           ///< one that stands for the chain in histories
  double z = 0.;           ///< of the middle plane of that in the chain's own frames, m

  /// What is in the seat of @p joint moves as this: its roller, or its bush. @p frames are those of
  /// all bodies, @p room holds the result where it is none of them.
  const Frame &roller(unsigned int joint, const std::vector<Frame> &frames, Frame &room) const;

  /// Where in the frame of its body the middle of the roller or bush of @p joint is, m.
  dealii::Point<3> roller_at(const unsigned int joint) const
  {
    return bushes.empty() ? dealii::Point<3>() : bushes[joint];
  }

  /// Of the pitch circle of a sprocket with so many teeth, m.
  double pitch_radius_of(unsigned int n_teeth) const;

  const Sprocket &driver() const { return sprockets.front(); }
  const Sprocket &driven() const; ///< the first one with a load; there must be one

  /// The span that the driver pulls in, and the one that it lets out.
  const Span &tight() const { return spans.back(); }
  const Span &slack() const { return spans.front(); }

  /// Joint @p steps further in the direction of travel.
  unsigned int next(const unsigned int joint, const unsigned int steps = 1) const
  {
    return (joint + steps) % n_joints;
  }
};
} // namespace chaindrive::scene
