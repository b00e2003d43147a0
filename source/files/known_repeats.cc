// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/known_repeats.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <libdeflate.h>

namespace chaindrive::files
{
namespace
{
constexpr std::size_t number_size = 4, farthest = (1 << 15) / number_size,
                      longest = 256 / number_size, // in numbers
    fewest_stored             = 32;

/// Bits that are written together, the first one lowest.
struct Bits
{
  std::uint32_t bits;
  unsigned int  n;
};

/// A Huffman code, whose highest bit comes first.
constexpr Bits huffman(const std::uint32_t code, const unsigned int n)
{
  std::uint32_t bits = 0;
  for (unsigned int i = 0; i < n; ++i)
    bits |= ((code >> i) & 1U) << (n - 1 - i);
  return {bits, n};
}

constexpr Bits with(const Bits &first, const std::uint32_t bits, const unsigned int n)
{
  return {first.bits | (bits << first.n), first.n + n};
}

/// The fixed code of a literal byte or, from 256 on, of the end and of lengths.
constexpr Bits fixed_code(const std::uint32_t symbol)
{
  return symbol < 144 ? huffman(0x30 + symbol, 8) :
         symbol < 256 ? huffman(0x190 + symbol - 144, 9) :
         symbol < 280 ? huffman(symbol - 256, 7) :
                        huffman(0xc0 + symbol - 280, 8);
}

/// Of a repeat of 3 to 257 bytes: symbols stand for one length each, then, four by four, for 2, 4
/// to 32 of them, told apart by further bits.
constexpr Bits code_of_length(const std::uint32_t bytes)
{
  const std::uint32_t less  = bytes - 3;
  unsigned int        extra = 0;
  while ((less >> extra) >= 8)
    ++extra;
  return with(fixed_code(257 + 4 * extra + (less >> extra)), less & ((1U << extra) - 1U), extra);
}

/// Of 1 to 32768 bytes, likewise two by two.
constexpr Bits code_of_distance(const std::uint32_t bytes)
{
  const std::uint32_t less  = bytes - 1;
  unsigned int        extra = 0;
  while ((less >> extra) >= 4)
    ++extra;
  return with(huffman(2 * extra + (less >> extra), 5), less & ((1U << extra) - 1U), extra);
}

struct Codes
{
  std::array<Bits, 256>         literal{};
  std::array<Bits, longest + 1> length{}; ///< of so many numbers
};

constexpr Codes make_codes()
{
  Codes codes;
  for (std::uint32_t byte = 0; byte < 256; ++byte)
    codes.literal[byte] = fixed_code(byte);
  for (std::uint32_t n = 1; n <= longest; ++n)
    codes.length[n] = code_of_length(number_size * n);
  return codes;
}

constexpr Codes codes = make_codes();

class BitStream
{
public:
  explicit BitStream(char *to) : to_(to) {}

  /// At most 56 bits.
  void add_bits(const std::uint64_t bits, const unsigned int n)
  {
    bits_ |= bits << n_;
    n_ += n;
    std::memcpy(to_, &bits_, sizeof(bits_)); // least significant byte first
    to_ += n_ / 8;
    bits_ >>= n_ / 8 * 8;
    n_ %= 8;
  }

  /// @p n bytes as stored blocks, none of them the last.
  void store(const char *bytes, const std::size_t n)
  {
    constexpr std::size_t most = 65535;
    for (std::size_t at = 0, length; at < n; at += length)
      {
        length = std::min(most, n - at);
        add_bits(0, 3);
        end();
        add_bits(length | ((~length & most) << 16), 32);
        std::memcpy(to_, bytes + at, length);
        to_ += length;
      }
  }

  /// Where the stream ends, at a whole byte.
  char *end()
  {
    if (n_ > 0)
      add_bits(0, 8 - n_);
    return to_;
  }

private:
  char         *to_;
  std::uint64_t bits_ = 0; ///< not written yet
  unsigned int  n_    = 0;
};

/// Whether @p is holds for any of @p stretches with so many of the @p n numbers from @p first on.
template <typename Is>
bool any_of_range(const std::vector<Stretch> &stretches,
                  const std::size_t           first,
                  const std::size_t           n,
                  const Is                   &is)
{
  std::size_t begin = 0;
  for (const Stretch &stretch : stretches)
    {
      const std::size_t end = begin + stretch.n, from = std::max(begin, first),
                        to = std::min(end, first + n);
      if (from < to && is(stretch, to - from))
        return true;
      begin = end;
    }
  return false;
}

/// Whether any of the @p n numbers from @p first on may be stored.
bool any_stored(const std::vector<Stretch> &stretches, const std::size_t first, const std::size_t n)
{
  return any_of_range(stretches, first, n, [](const Stretch &stretch, const std::size_t many) {
    return !stretch.repeats() && many >= fewest_stored;
  });
}

/// How many numbers from @p a on, up to @p most, are those from @p b on.
std::size_t n_equal(const std::uint32_t *a, const std::uint32_t *b, const std::size_t most)
{
  std::size_t n = 0;
  while (n < most && a[n] == b[n])
    ++n;
  return n;
}
} // namespace

bool any_repeat(const std::vector<Stretch> &stretches, const std::size_t first, const std::size_t n)
{
  return any_of_range(
      stretches, first, n, [](const Stretch &stretch, std::size_t) { return stretch.repeats(); });
}

void append_known_repeats(const void                 *values,
                          const std::size_t           first,
                          const std::size_t           n,
                          const std::vector<Stretch> &stretches,
                          std::vector<char>          &room,
                          std::string                &to)
{
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  const auto *numbers = static_cast<const std::uint32_t *>(values) + first;
  // two bytes of zlib, nine bits at most for each byte, the checksum, and room to write ahead
  room.resize(std::max(room.size(), 2 + number_size * n * 9 / 8 + 4 + 2 * sizeof(std::uint64_t)));
  char *begin                          = room.data();
  begin[0]                             = 0x78;
  begin[1]                             = 0x01;
  constexpr Bits         over          = fixed_code(256);
  constexpr unsigned int by_fixed_code = 2, last = 1;
  const bool             stores = any_stored(stretches, first, n);
  BitStream              stream(begin + 2);
  stream.add_bits(stores ? by_fixed_code : by_fixed_code | last, 3);

  std::size_t stretch = 0, end = 0; // of the stretch, from `first` on, as far as it lies there
  std::size_t passed = 0;           // numbers of all stretches so far
  bool        plain  = false;       // whether it has no repeats
  std::array<std::size_t, 2> distance{};
  std::array<Bits, 2>        far{};
  const auto                 next_stretch = [&](const std::size_t at) {
    while (at >= end)
      {
        if (stretch == stretches.size())
          {
            end      = n;
            distance = {};
            plain    = false;
            return;
          }
        passed += stretches[stretch].n;
        end      = std::min(n, passed > first ? passed - first : 0);
        distance = stretches[stretch].distance;
        plain    = !stretches[stretch].repeats();
        ++stretch;
        for (unsigned int d = 0; d < 2; ++d)
          if (distance[d] > farthest)
            distance[d] = 0;
          else if (distance[d] > 0)
            far[d] = code_of_distance(static_cast<std::uint32_t>(number_size * distance[d]));
      }
  };
  for (std::size_t i = 0; i < n;)
    {
      if (i >= end)
        {
          next_stretch(i);
          if (plain && end - i >= fewest_stored)
            {
              stream.add_bits(over.bits, over.n);
              stream.store(reinterpret_cast<const char *>(numbers + i), number_size * (end - i));
              stream.add_bits(by_fixed_code, 3);
              i = end;
              continue;
            }
        }
      std::size_t       repeated = 0;
      unsigned int      of       = 0;
      const std::size_t most     = std::min(longest, n - i);
      for (unsigned int d = 0; d < 2; ++d)
        if (distance[d] > 0 && i >= distance[d])
          if (const std::size_t equal = n_equal(numbers + i, numbers + i - distance[d], most);
              equal > repeated)
            {
              repeated = equal;
              of       = d;
            }
      if (repeated > 0)
        {
          const Bits &length = codes.length[repeated];
          stream.add_bits(length.bits | (std::uint64_t(far[of].bits) << length.n),
                          length.n + far[of].n);
          i += repeated;
          continue;
        }
      const std::uint32_t number = numbers[i++];
      std::uint64_t       bits   = 0;
      unsigned int        size   = 0;
      for (unsigned int byte = 0; byte < number_size; ++byte)
        {
          const Bits &literal = codes.literal[(number >> (8 * byte)) & 0xffU];
          bits |= std::uint64_t(literal.bits) << size;
          size += literal.n;
        }
      stream.add_bits(bits, size);
    }
  stream.add_bits(over.bits, over.n);
  if (stores) // an empty block is the last one
    {
      stream.add_bits(by_fixed_code | last, 3);
      stream.add_bits(over.bits, over.n);
    }
  char               *checksum = stream.end();
  const std::uint32_t adler    = libdeflate_adler32(1, numbers, number_size * n);
  for (unsigned int byte = 0; byte < 4; ++byte)
    checksum[byte] = static_cast<char>(adler >> (8 * (3 - byte)));
  to.append(begin, static_cast<std::size_t>(checksum + 4 - begin));
}
} // namespace chaindrive::files
