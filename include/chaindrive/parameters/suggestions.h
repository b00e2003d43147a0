// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/declarations.h>

#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// What to say of an entry @p name that section @p section does not have, to which @p value was to
/// be given: the entry of the same quantity in another unit, with the value converted to it; that
/// the quantity is not modelled; the entry that was probably misspelt; the entries of the section.
/// A sentence, with a blank before it; empty if there is nothing to say. @p with_paths names
/// entries by their paths.
std::string advice(const std::vector<Entry> &entries,
                   const std::string        &section,
                   const std::string        &name,
                   const std::string        &value,
                   bool                      with_paths = false);

/// Quantities that entries are often sought for and that no entry has, in the words of users, each
/// with what to know of it: doc/not-modelled.md lists the same.
struct NotModelled
{
  std::vector<std::string> words;
  std::string              sentence;
};
const std::vector<NotModelled> &not_modelled();
} // namespace chaindrive::parameters
