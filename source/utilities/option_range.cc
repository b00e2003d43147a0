// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/option_range.h>
#include <chaindrive/utilities/text.h>

#include <string>

namespace chaindrive
{
void check_option(const char *option, const double value, const double least, const double most)
{
  if (!(value >= least && value <= most))
    throw InputError(std::string("The option ") + option + " = " + to_text(value) +
                     " must be a number from " + to_text(least) + " to " + to_text(most) + ".");
}
} // namespace chaindrive
