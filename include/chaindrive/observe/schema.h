// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/json.h>

namespace chaindrive::observe
{
/// All histories and all members of the summary that runs may have, whatever their fidelity:
/// `histories` and `summary`, each with a member for each files::Described::path, of `unit`,
/// `description` and, where Output/Quantities decides on it, `quantities`, the word that asks for
/// it. And `old_names`: the present name of each entry of the .prm file, of each value of an entry
/// and of each member of the summary that earlier versions called otherwise.
files::Json schema();
} // namespace chaindrive::observe
