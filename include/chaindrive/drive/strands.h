// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/facts.h>

#include <string>

namespace chaindrive::drive
{
// A chain of several strands: all are alike and share the load equally, so that one of them is
// computed, with its share of all that acts on the shafts. What is said of chain, joints and teeth
// is said of one strand, what is said of shafts and of the drive as a whole of all.

/// That rule in a sentence for plan and log.
std::string in_words_of_strands(unsigned int strands);

/// How much more than its share the strand takes that pulls most, by the factors of ratings:
/// strands / strand_factor(strands).
double uneven_share(unsigned int strands);

/// Makes of the @p facts of one strand those of the drive with all of its strands.
void add_strands(Facts &facts, unsigned int strands);
} // namespace chaindrive::drive
