// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/checksum.h>

#include <boost/crc.hpp>

#include <cinttypes>
#include <cstdio>

namespace chaindrive
{
struct Checksum::Data
{
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true>
      crc;
};

Checksum::Checksum() : data_(std::make_unique<Data>()) {}

Checksum::~Checksum() = default;

void Checksum::add(const char *bytes, const std::size_t n) { data_->crc.process_bytes(bytes, n); }

std::uint64_t Checksum::value() const { return data_->crc.checksum(); }

std::string checksum(const std::string &text)
{
  Checksum sum;
  sum.add(text.data(), text.size());
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016" PRIx64, sum.value());
  return digits;
}
} // namespace chaindrive
