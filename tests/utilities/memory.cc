// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest memory of a copy of a process: that of the process, whose pages of files the system
// does not give to the copy at once, and what the copy takes itself; a copy of the copy likewise.
#include <chaindrive/utilities/memory.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
constexpr std::size_t of_file = 48u << 20, own = 24u << 20; // bytes
constexpr double      near = 4e6;                           // bytes

/// Touches every page of a file that is as large as @p bytes; false if there is no room for it.
bool touch_file(const std::size_t bytes)
{
  char       name[] = "memory-XXXXXX";
  const int  file   = ::mkstemp(name);
  const bool made   = file >= 0 && ::unlink(name) == 0 && ::ftruncate(file, off_t(bytes)) == 0;
  void      *begin  = made ? ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, file, 0) : MAP_FAILED;
  if (begin == MAP_FAILED)
    return false;
  for (std::size_t i = 0; i < bytes; i += 4096)
    static_cast<void>(static_cast<const volatile char *>(begin)[i]);
  return true;
}

/// What @p work finds in a copy of this process.
bool in_copy(const std::function<bool()> &work)
{
  chaindrive::remember_pages_of_files();
  const pid_t copy = ::fork();
  if (copy == 0)
    ::_exit(work() ? 0 : 1);
  int status = 1;
  return ::waitpid(copy, &status, 0) == copy && status == 0;
}

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << std::endl;
}
} // namespace

int main()
{
  using chaindrive::largest_memory;
  const double at_first = largest_memory();
  verdict("a file that is read counts",
          touch_file(of_file) && largest_memory() > at_first + of_file - near);
  const double before  = largest_memory();
  const auto   is_near = [](const double wanted) {
    return largest_memory() > wanted - near && largest_memory() < wanted + near;
  };
  verdict("a copy has as much as its process", in_copy([&] { return is_near(before); }));
  const auto grows = [&] {
    const std::vector<char> data(own, 1);
    return data.back() == 1 && is_near(before + own);
  };
  verdict("and what it takes itself", in_copy(grows));
  verdict("a copy of a copy, too", in_copy([&] { return in_copy(grows); }));
  verdict("what is given back was there", grows() && is_near(before + own));
}
