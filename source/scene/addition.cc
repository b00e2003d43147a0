// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/addition.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <utility>

namespace chaindrive::scene
{
namespace
{
Registry<AdditionRegistration::Add> &all_additions()
{
  static Registry<AdditionRegistration::Add> additions("addition");
  return additions;
}
} // namespace

AdditionRegistration::AdditionRegistration(const About &about, Add add)
{
  all_additions().add(about, std::move(add));
}

void add_additions(const parameters::Sections &sections, Scene &scene)
{
  for (const auto &[entry, add] : all_additions().in_order())
    add(scene, sections);
}

const Sprocket &
find_sprocket(const DriveView &drive, const std::string &name, const std::string &entry)
{
  std::vector<std::string> names;
  for (const Sprocket &sprocket : drive.sprockets)
    if (sprocket.name == name)
      return sprocket;
    else
      names.push_back(sprocket.name);
  throw InputError(entry + " = " + name + " is not a sprocket of the drive: it has " + join(names) +
                   ".");
}
} // namespace chaindrive::scene
