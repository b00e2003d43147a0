// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace chaindrive
{
/// What the user asked for cannot be done: the message is one or two clear sentences that name the
/// entry, the value and what is allowed. main() prints it alone and exits with status 2.
class InputError : public std::runtime_error
{
public:
  explicit InputError(const std::string &message) : std::runtime_error(message) {}
};

/// Something failed while running: a disk that is full, a balance that does not close. main()
/// prints the message and exits with status 3; files that were complete stay as they are.
class RunError : public std::runtime_error
{
public:
  explicit RunError(const std::string &message) : std::runtime_error(message) {}
};
} // namespace chaindrive
