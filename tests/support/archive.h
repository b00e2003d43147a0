// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/archive.h>

#include <iostream>
#include <map>
#include <optional>
#include <string>

namespace test
{
/// What a checkpoint holds, in memory.
using Items = std::map<std::string, chaindrive::Archive::Bytes>;

inline chaindrive::Archive writer(Items &items)
{
  return chaindrive::Archive(
      [&items](const std::string &name, const char *bytes, const std::size_t n) {
        if (!items.emplace(name, chaindrive::Archive::Bytes(bytes, bytes + n)).second)
          std::cout << "two items are called " << name << '\n';
      });
}

inline chaindrive::Archive reader(const Items &items)
{
  return chaindrive::Archive([&items](const std::string &name) {
    const auto found = items.find(name);
    return found == items.end() ? std::nullopt : std::make_optional(found->second);
  });
}
} // namespace test
