// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/registry.h>

#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// What parameters, drive and effects ask of a fidelity, a model of the chain: never its name.
struct Capabilities
{
  bool has_clearances; ///< rollers, inner and outer links are bodies; else lumps joined by bars
  bool is_elastic;     ///< bodies deform; else their compliance sits in bars and contacts
  bool is_reduced;     ///< they do so by few modes
};

/// Makes the fidelity @p about one that Model/Fidelity can choose, besides simple, layered, reduced
/// and full. It needs a builder, too: see scene/fidelity.h.
void register_fidelity(const About &about, const Capabilities &capabilities);

/// Names of all fidelities, in the order in which messages list them. InputError as Registry.
std::vector<std::string> fidelities();

/// What each of them is, for the documentation of the entry.
std::string fidelities_in_words();

/// Those of the fidelity @p name; std::logic_error when there is none of that name.
const Capabilities &capabilities_of(const std::string &name);
} // namespace chaindrive::parameters
