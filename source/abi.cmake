# SPDX-License-Identifier: LGPL-2.1-or-later
# cmake -D VERSION=... -D INCLUDE=FOLDER -D OUTPUT=FILE -P abi.cmake: writes the header FILE with the
# version of the program and the checksum of all headers below FOLDER.
file(GLOB_RECURSE headers RELATIVE ${INCLUDE} ${INCLUDE}/chaindrive/*.h)
list(SORT headers)
set(all)
foreach(header ${headers})
  file(SHA256 ${INCLUDE}/${header} one)
  string(APPEND all "${header} ${one}\n")
endforeach()
string(SHA256 all "${all}")
string(SUBSTRING ${all} 0 16 all)
file(WRITE ${OUTPUT} "// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#define CHAINDRIVE_ABI_VERSION \"${VERSION}\"
#define CHAINDRIVE_ABI_HEADERS \"${all}\" ///< checksum of all headers
")
