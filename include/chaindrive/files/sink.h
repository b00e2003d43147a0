// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <streambuf>

namespace chaindrive::files
{
/// A stream buffer that keeps nothing: a derived class takes all text in xsputn().
class Sink : public std::streambuf
{
protected:
  int_type overflow(const int_type c) override
  {
    const char character = traits_type::to_char_type(c);
    if (!traits_type::eq_int_type(c, traits_type::eof()))
      xsputn(&character, 1);
    return traits_type::not_eof(c);
  }
};
} // namespace chaindrive::files
