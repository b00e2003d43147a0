// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace chaindrive::output
{
/// Makes the output directory @p path with its parents and removes the results of an earlier run
/// from it: the files this program writes, recognised by their exact names, and nothing else.
/// InputError when a component of the path is not a directory or nothing can be written there.
///
/// To be called when everything else about the input has been checked, so that a run that is
/// refused leaves earlier results alone. A run that @p resumes an earlier one keeps its results and
/// removes only files that were left unfinished.
void prepare_directory(const std::string &path, bool resumes = false);
} // namespace chaindrive::output
