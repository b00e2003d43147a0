// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace chaindrive::mesh
{
/// The lines and numbers of a mesh file of Gmsh, and what is wrong with them. Numbers come in
/// records: lines of an ASCII file, any number of bytes of a binary one.
class GmshNumbers
{
public:
  /// Throws InputError if @p file cannot be opened.
  explicit GmshNumbers(const std::string &file);

  /// Reads the next line of text to `line`; false at the end of the file.
  bool next_line();

  /// Throws InputError with the place: @p expected was, `line` or the end of the file is there.
  [[noreturn]] void fail(const std::string &expected) const;

  /// The next line of text must be @p text.
  void expect(const std::string &text);

  /// The numbers of the next line of text: at least @p n, which are @p what.
  const std::vector<double> &text(std::size_t n, const std::string &what);

  /// A line of text with one number: how many lines or elements follow.
  long count();

  /// What follows is binary and begins with the integer 1 in the order of bytes of the machine that
  /// wrote the file.
  void start_binary();
  bool binary() const { return binary_; }

  /// The following numbers are @p what.
  void record(const std::string &what);

  /// The next number of the record: of four bytes, eight bytes, and a real one of eight bytes if
  /// the file is binary.
  long   integer();
  long   size();
  double real();

  /// How many numbers of the record are left, in an ASCII file.
  std::size_t left() const { return numbers_.size() - at_; }

  std::string line;

private:
  template <typename T>
  T      raw();
  double next();
  long   whole(double value) const;

  std::string         file_, what_;
  std::ifstream       in_;
  unsigned long       n_lines_ = 0, n_bytes_ = 0;
  bool                binary_ = false, foreign_ = false;
  std::vector<double> numbers_;
  std::size_t         at_ = 0;
};
} // namespace chaindrive::mesh
