// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/declarations.h>

#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// That section @p outer (empty: the file) has no section @p name, and which was probably meant.
std::string unknown_section(const Declarations &declarations,
                            const std::string  &name,
                            const std::string  &outer);

/// That section @p section (empty: outside all) has no entry @p name, to which @p value was to be
/// given, and what to do: the section or the present name of such an entry; the entry of the same
/// quantity in another unit, with the value converted to it; that the quantity is not modelled; the
/// entry that was probably misspelt; the entries of the section.
std::string unknown_entry(const Declarations &declarations,
                          const std::string  &section,
                          const std::string  &name,
                          const std::string  &value);

/// What to do about a @p path that no entry has, to which @p value was to be given; its section may
/// be missing or wrong. A sentence, with a blank before it.
std::string
advice_on_path(const Declarations &declarations, const std::string &path, const std::string &value);

/// Quantities that entries are often sought for and that no entry has, in the words of users, each
/// with what to know of it: doc/not-modelled.md lists the same.
struct NotModelled
{
  std::vector<std::string> words;
  std::string              sentence;
};
const std::vector<NotModelled> &not_modelled();
} // namespace chaindrive::parameters
