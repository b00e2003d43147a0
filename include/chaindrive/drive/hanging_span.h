// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/layout.h>

namespace chaindrive::drive
{
/// A span that hangs between two sprockets at one height: a flat parabola of an elastic chain.
struct HangingSpan
{
  double length;      ///< between its ends, m
  double weight;      ///< per metre, N/m
  double flexibility; ///< by how much longer a newton more of its tension makes what it pulls: the
                      ///< span itself and what deflects at its ends, m/N; above 0

  /// The tension [N] in its middle: the one, H, that stretches the chain to the length of its
  /// parabola, slack + flexibility H = weight^2 length^3 / (24 H^2). @p slack [m] is the length of
  /// the chain without that tension less the distance of the ends; zero or negative: the chain is
  /// pulled to that distance.
  double tension(double slack) const;

  /// The tension [N] in its middle, and the sag [m], one from the other; zero for zero.
  double tension_of_sag(double sag) const;
  double sag(double tension) const;
};

/// The lowest vibration of a hanging span in its plane.
struct LowestMode
{
  double factor;    ///< its frequency over the first one of a string of that length and tension
  bool   symmetric; ///< about the middle of the span; then it stretches the chain
};

/// That of @p span under @p tension [N]. Two half waves, antisymmetric, have twice the frequency of
/// the string. The symmetric mode has the factor 2 x / pi, where tan(x) = x - 4 x^3 / lambda^2 with
/// lambda^2 = (weight length / tension)^2 length / (tension flexibility): a string's without sag,
/// but above the antisymmetric one for lambda > 2 pi. H. M. Irvine, T. K. Caughey, The linear
/// theory of free vibrations of a suspended cable, Proc. R. Soc. A 341 (1974) 299-315.
LowestMode lowest_mode(const HangingSpan &span, double tension);

/// Sag over the distance that the slack span of a @p layout bridges.
double relative_sag(const Layout &layout);
} // namespace chaindrive::drive
