// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/elastic_group.h>
#include <chaindrive/contact/closed_window.h>
#include <chaindrive/stability/closed_modes.h>

#include <vector>

namespace chaindrive::stability
{
/// A window of one of the families of contacts.
struct ClosedWindow : contact::ClosedWindow
{
  unsigned int family = 0;
  /// By how much more its body alone feels the springs of friction of nodes, see Shares.
  double springs = 2.;
  /// Is of a joint that is not taken apart, see HeldLink.
  bool together = false;
};

/// A window that is closed: about a direction, or in one of its sets of strips.
struct Closed
{
  const ClosedWindow *window;
  unsigned int        number; ///< of that

  const contact::ClosedStrips *strips() const
  {
    return window->strips.empty() ? nullptr : &window->strips[number];
  }

  /// A column counts that is nearer than half a column beyond the window's end.
  std::vector<unsigned int> columns() const;
};

/// What bodies are held by, 1/s2, and how stiff that is in any direction of the plane at most, N/m.
struct Hold
{
  Matrix              matrix;
  Matrix              across; ///< by the springs of friction of the nodes of one window
  const ClosedWindow *nodes     = nullptr; ///< that window
  double              stiffness = 0.;
  /// The same times the mobility of a rim with inertia on which strips are, 1/s2: the largest
  /// eigenvalue of K^1/2 (B B^T) K^1/2, B being what its modes move strips by. All gaps together,
  /// closed alike, that is the largest of all numbers of waves round the rim.
  double of_rim = 0.;

  Matrix all() const
  {
    Matrix sum = matrix;
    if (nodes != nullptr)
      sum.add(nodes->springs, across);
    return sum;
  }
};

/// What @p bodies are held by where these windows, of nodes at most one, are @p closed.
Hold held_by(const ModalGroup &bodies, const std::vector<Closed> &closed);

/// A round body with one joint, such as a roller, and the cylinder of another one that it is
/// around; both with its side of the joint, the cylinder's with ClosedWindow::joint.
struct Ringed
{
  const ModalGroup   *ring, *link;
  const ClosedWindow *bore, *cylinder;
};

/// A way in which a ring closes: perhaps in a window of its outside, and in its bore about one of
/// n_directions of its own.
struct RingWay
{
  Closed       outside{nullptr, 0};
  unsigned int direction = 0;
};

/// What the motions of ring and link, in this order, are held by together, 1/s2, where the nodes of
/// the cylinder about one of n_directions of the link are closed, and the ring as @p way says. The
/// ring is turned so that both directions are one. Springs of friction act between the two.
Matrix held_together(const Ringed &bodies, unsigned int direction, const RingWay &way);
} // namespace chaindrive::stability
