// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/tooth_forces.h>

#include <set>

namespace chaindrive::observe
{
std::vector<ToothForces> make_tooth_forces(const scene::Scene     &scene,
                                           const dynamics::System &system)
{
  std::vector<ToothForces> result;
  std::set<std::string>    named; // families of rigid and of elastic bodies share a name
  for (const scene::ToothFamily &teeth : scene.teeth)
    if (named.insert(teeth.name).second)
      {
        const scene::Sprocket &sprocket =
            scene.drive.sprockets.at(scene.bodies[teeth.sprocket].number);
        result.emplace_back(sprocket.name, scene.drive.n_joints, sprocket.teeth);
        for (const contact::Family *family : system.contacts.find(teeth.name))
          result.back().families.push_back(dynamic_cast<const contact::SurfaceContact *>(family));
      }
  return result;
}
} // namespace chaindrive::observe
