// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace chaindrive
{
/// InputError that names the command line's @p option unless @p value is from @p least to @p most.
void check_option(const char *option, double value, double least, double most);
} // namespace chaindrive
