// SPDX-License-Identifier: LGPL-2.1-or-later
// Things that register themselves: each comes after those that it names, then the program's own,
// then those of plug-ins in the order of their loading, then by name. A circle, a name that there
// is not and one that there is already are told; nothing is thrown while they register.
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/registry.h>

#include <iostream>

using namespace chaindrive;

namespace
{
void print(const Registry<int> &registry)
{
  try
    {
      for (const auto &[entry, item] : registry.in_order())
        std::cout << ' ' << entry.about.name << '=' << item
                  << (entry.plugin.empty() ? "" : " (" + entry.plugin + ")");
    }
  catch (const InputError &error)
    {
      std::cout << ' ' << error.what();
    }
  std::cout << '\n';
}
} // namespace

int main()
{
  Registry<int> colours("colour"), shapes("shape"), waiting("wish");
  colours.add({"red", "", {"violet"}}, 1);
  colours.add({"blue", ""}, 2);
  colours.add({"violet", ""}, 3);
  colours.add({"green", "", {"red", "blue"}}, 4);
  print(colours);

  AnyRegistry::begin_plugin("pastel");
  colours.add({"ash", ""}, 5);
  colours.add({"azure", "", {"ochre"}}, 6);
  print(colours);
  AnyRegistry::begin_plugin("earth");
  colours.add({"ochre", "", {"blue"}}, 7);
  print(colours);

  std::cout << AnyRegistry::problems().size() << " problems\n";
  colours.add({"blue", ""}, 8);
  colours.add({"ash", ""}, 9);
  for (const std::string &problem : AnyRegistry::problems())
    std::cout << problem << '\n';
  print(colours);

  waiting.add({"egg", "", {"hen"}}, 1);
  waiting.add({"hen", "", {"egg"}}, 2);
  waiting.add({"nest", ""}, 3);
  print(waiting);
  shapes.add({"own", "", {"own"}}, 1);
  print(shapes);

  for (const AnyRegistry *registry : AnyRegistry::all())
    std::cout << registry->kind() << ' ' << registry->entries().size() << '\n';
}
