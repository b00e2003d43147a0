// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

// What messages say where something is missing that a command starts: the Debian packages with it,
// from packaging/packages.txt, and how they are installed.

namespace chaindrive
{
/// "A report needs Debian's packages: apt install ...".
std::string packages_of_reports();

/// The same of an export.
std::string packages_of_exports();

/// The same of a study.
std::string packages_of_studies();
} // namespace chaindrive
