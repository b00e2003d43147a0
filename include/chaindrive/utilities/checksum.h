// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace chaindrive
{
/// CRC-64/XZ (ECMA-182, reflected) of bytes as they come: the same on every machine and with every
/// compiler. Of "123456789" it is 995dc9bbdf1939fa.
class Checksum
{
public:
  Checksum();
  ~Checksum();

  void          add(const char *bytes, std::size_t n);
  std::uint64_t value() const;

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// The checksum of @p text as 16 hexadecimal digits.
std::string checksum(const std::string &text);
} // namespace chaindrive
