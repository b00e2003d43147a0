// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/errors.h>

namespace chaindrive
{
Archive::Bytes Archive::get(const std::string &name) const
{
  std::optional<Bytes> item = read_item_(path_ + name);
  if (!item)
    throw InputError("it has no item '" + path_ + name + "'");
  return std::move(*item);
}

Archive::Bytes Archive::get(const std::string &name, const std::size_t size) const
{
  Bytes item = get(name);
  if (item.size() != size)
    throw InputError("its item '" + path_ + name + "' has " + std::to_string(item.size()) +
                     " bytes instead of " + std::to_string(size));
  return item;
}
} // namespace chaindrive
