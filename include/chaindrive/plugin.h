// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// What a plug-in includes in one of its sources: see doc/plugins.md.

#include <chaindrive/abi.h>

#include <deal.II/base/config.h>

#ifdef DEBUG
#define CHAINDRIVE_ABI_BUILD "Debug"
#else
#define CHAINDRIVE_ABI_BUILD "Release"
#endif

/// With what a plug-in and the program that loads it must both be made, in words: the program, all
/// of its headers (their checksum), deal.II and the type of the build.
#define CHAINDRIVE_ABI                                                                             \
  "chaindrive " CHAINDRIVE_ABI_VERSION " (headers " CHAINDRIVE_ABI_HEADERS                         \
  "), deal.II " DEAL_II_PACKAGE_VERSION ", " CHAINDRIVE_ABI_BUILD

/// The section of a shared library that says what it is, read before any of the library is run.
#define CHAINDRIVE_PLUGIN_SECTION "chaindrive_plugin"
#define CHAINDRIVE_PLUGIN_MARK "chaindrive plug-in"

/// Makes the shared library a plug-in of this @p name and @p version, both literals. Once in a
/// library, outside of all namespaces: CHAINDRIVE_PLUGIN("brake", "1.0")
#define CHAINDRIVE_PLUGIN(name, version)                                                           \
  extern "C" __attribute__((used, section(CHAINDRIVE_PLUGIN_SECTION)))                             \
  const char chaindrive_plugin_text[];                                                             \
  const char chaindrive_plugin_text[] =                                                            \
      CHAINDRIVE_PLUGIN_MARK "\0" CHAINDRIVE_ABI "\0" name "\0" version;
