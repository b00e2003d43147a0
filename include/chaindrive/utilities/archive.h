// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/utilities.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace chaindrive
{
/// State on its way into a checkpoint or back, as named items. A class lists what its state is
/// once, in a function serialize() that serves both directions:
///
///     void Clock::serialize(const Archive &archive)
///     {
///       archive("time", time_);
///       archive.numbers("bells", bells_);
///       hand_.serialize(archive / "hand");
///     }
///
/// What is repeated on every rank is written by the first one and read by all. What is distributed
/// goes through of_this_rank(), under names that do not depend on the number of ranks.
class Archive
{
public:
  using Bytes = std::vector<char>;
  /// Takes the item of a name: so many bytes from an address on.
  using WriteItem = std::function<void(const std::string &, const char *, std::size_t)>;
  /// Gives the item of a name; none when there is no such item.
  using ReadItem = std::function<std::optional<Bytes>(const std::string &)>;

  /// An archive to be written. With @p own_only, on all ranks but the first, only what goes through
  /// of_this_rank() is.
  explicit Archive(WriteItem write_item, bool own_only = false)
      : write_item_(std::move(write_item)), skips_(own_only)
  {
  }

  /// An archive to be read.
  explicit Archive(ReadItem get) : read_item_(std::move(get)) {}

  bool reads() const { return static_cast<bool>(read_item_); }

  /// The part of this archive called @p name.
  Archive operator/(const std::string &name) const
  {
    Archive part = *this;
    part.path_ += name + "/";
    return part;
  }

  /// This archive for what only this rank has.
  Archive of_this_rank() const
  {
    Archive own = *this;
    own.skips_  = false;
    return own;
  }

  /// An object: copied byte by byte where that is allowed, otherwise as Boost serialises it. While
  /// reading, InputError when there is no such item or it has another size.
  template <typename T>
  void operator()(const std::string &name, T &value) const
  {
    if constexpr (std::is_trivially_copyable_v<T>)
      numbers(name, &value, 1);
    else if (reads())
      value = dealii::Utilities::unpack<T>(get(name), false);
    else if (!skips_)
      {
        const Bytes bytes = dealii::Utilities::pack(value, false);
        write_item_(path_ + name, bytes.data(), bytes.size());
      }
  }

  /// @p n objects, every so many places from @p first on; their number must be the one written.
  template <typename T>
  void
  numbers(const std::string &name, T *first, const std::size_t n, const std::size_t every = 1) const
  {
    static_assert(std::is_trivially_copyable_v<T>);
    if (reads())
      {
        const Bytes bytes = get(name, n * sizeof(T));
        for (std::size_t i = 0; i < n; ++i)
          std::memcpy(first + i * every, bytes.data() + i * sizeof(T), sizeof(T));
      }
    else if (!skips_)
      {
        Bytes bytes(n * sizeof(T));
        for (std::size_t i = 0; i < n; ++i)
          std::memcpy(bytes.data() + i * sizeof(T), first + i * every, sizeof(T));
        write_item_(path_ + name, bytes.data(), bytes.size());
      }
  }

  /// All objects of a vector, which keeps its size.
  template <typename T>
  void numbers(const std::string &name, std::vector<T> &values) const
  {
    numbers(name, values.data(), values.size());
  }

private:
  /// The item called @p name; InputError when there is none, or when it has not the size wanted.
  Bytes get(const std::string &name) const;
  Bytes get(const std::string &name, std::size_t size) const;

  WriteItem   write_item_;
  ReadItem    read_item_;
  std::string path_;
  bool        skips_ = false;
};
} // namespace chaindrive
