// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import/gmsh_numbers.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace chaindrive::mesh
{
namespace
{
constexpr double largest_whole = 1e15; // a double counts that far
}

GmshNumbers::GmshNumbers(const std::string &file) : file_(file), in_(file, std::ios::binary)
{
  if (!in_)
    throw InputError("The mesh file '" + file + "' cannot be opened.");
}

bool GmshNumbers::next_line()
{
  line.clear();
  ++n_lines_;
  if (!std::getline(in_, line))
    return false;
  n_bytes_ += line.size() + 1;
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return true;
}

void GmshNumbers::fail(const std::string &expected) const
{
  std::string found = line.substr(0, 40);
  if (binary_)
    std::replace_if(
        found.begin(), found.end(), [](const char c) { return c < ' ' || c > '~'; }, '?');
  throw InputError(
      "The mesh '" + file_ + "', " +
      (binary_ ? "byte " + std::to_string(n_bytes_) : "line " + std::to_string(n_lines_)) + ": " +
      expected + " expected, found " +
      (in_ ? "'" + found + (line.size() > 40 ? "...'" : "'") : "the end of the file") + ".");
}

void GmshNumbers::expect(const std::string &text)
{
  bool has_line = next_line();
  if (binary_ && has_line && line.empty()) // the end of the binary data
    has_line = next_line();
  if (!has_line || line != text)
    fail("'" + text + "'");
}

const std::vector<double> &GmshNumbers::text(const std::size_t n, const std::string &what)
{
  numbers_.clear();
  at_ = 0;
  next_line();
  const char *at = line.data(), *const end = at + line.size();
  while (at != end)
    {
      double     value  = 0.;
      const auto result = std::from_chars(at, end, value);
      if (result.ec == std::errc::invalid_argument)
        fail(what);
      numbers_.push_back(result.ec == std::errc() ? value : NAN); // too large for a double
      at = std::find_if(result.ptr, end, [](const char c) { return c != ' ' && c != '\t'; });
      if (at == result.ptr && at != end)
        fail(what);
    }
  if (numbers_.size() < n)
    fail(what);
  return numbers_;
}

long GmshNumbers::count() { return whole(text(1, "a number of lines")[0]); }

void GmshNumbers::record(const std::string &what)
{
  what_ = what;
  if (!binary_)
    text(0, what);
}

/// Gmsh and the computers that chaindrive runs on have the same types; only the order of bytes is
/// not the same on all of them.
template <typename T>
T GmshNumbers::raw()
{
  std::array<char, sizeof(T)> bytes{};
  line.clear();
  if (!in_.read(bytes.data(), bytes.size()))
    fail(what_);
  n_bytes_ += bytes.size();
  if (foreign_)
    std::reverse(bytes.begin(), bytes.end());
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

void GmshNumbers::start_binary()
{
  binary_        = true;
  what_          = "the integer 1 in binary";
  const auto one = raw<std::int32_t>();
  foreign_       = one == 0x01000000;
  if (one != 1 && !foreign_)
    {
      line = std::to_string(one);
      fail(what_);
    }
}

double GmshNumbers::next()
{
  if (at_ >= numbers_.size())
    fail(what_);
  return numbers_[at_++];
}

long GmshNumbers::whole(const double value) const
{
  if (!(std::abs(value) < largest_whole) || value != std::floor(value))
    fail("a whole number instead of " + to_text(value));
  return static_cast<long>(value);
}

long GmshNumbers::integer() { return binary_ ? raw<std::int32_t>() : whole(next()); }

long GmshNumbers::size()
{
  if (!binary_)
    return whole(next());
  const auto value = raw<std::uint64_t>();
  if (static_cast<double>(value) < largest_whole)
    return static_cast<long>(value);
  line = std::to_string(value);
  fail(what_ + ", a number below " + to_text(largest_whole) + ",");
}

double GmshNumbers::real() { return binary_ ? raw<double>() : next(); }
} // namespace chaindrive::mesh
