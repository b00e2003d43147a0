// SPDX-License-Identifier: LGPL-2.1-or-later
// The checksum is CRC-64/XZ: its published check value, in one piece and in two, and a changed bit
// shows.
#include <chaindrive/utilities/checksum.h>

#include <iostream>

using namespace chaindrive;

int main()
{
  Checksum pieces;
  pieces.add("1234", 4);
  pieces.add("56789", 5);
  std::cout << "of 123456789: " << checksum("123456789") << '\n'
            << "in two pieces: " << (pieces.value() == 0x995DC9BBDF1939FA ? "the same" : "ANOTHER")
            << '\n'
            << "of nothing: " << checksum("") << '\n'
            << "with a bit changed: "
            << (checksum("123456788") == checksum("123456789") ? "THE SAME" : "another")
            << std::endl;
}
