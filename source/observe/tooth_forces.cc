// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/tooth_forces.h>

#include <set>

namespace chaindrive::observe
{
std::vector<ToothForces> make_tooth_forces(const scene::Scene     &scene,
                                           const dynamics::System &system,
                                           const unsigned int      strand)
{
  std::vector<ToothForces> result;
  std::set<unsigned int>   found; // there are families of rigid and of elastic rollers
  for (const scene::ToothFamily &teeth : scene.teeth)
    if (found.insert(teeth.sprocket).second)
      {
        const scene::Sprocket &sprocket =
            scene.drive.sprockets.at(scene.bodies[teeth.sprocket].number);
        result.emplace_back(sprocket.name, scene.drive.n_joints, sprocket.teeth);
        result.back().flat = sprocket.flat;
        for (const contact::Family *family :
             system.contacts.find({scene::Interface::roller_teeth, teeth.sprocket, strand}))
          result.back().families.push_back(dynamic_cast<const contact::SurfaceContact *>(family));
      }
  return result;
}
} // namespace chaindrive::observe
