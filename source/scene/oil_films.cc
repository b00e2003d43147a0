// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>

namespace chaindrive::scene
{
void add_oil_films(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  const drive::ChainDimensions &chain = drive.chain;
  OilFilms                      films;
  films.viscosity       = model.contact.oil_viscosity;
  films.roller_radius   = 0.5 * chain.roller_diameter;
  films.bore_radius     = 0.5 * chain.roller_bore;
  films.bush_radius     = 0.5 * chain.bush_diameter;
  films.length          = chain.roller_length;
  films.bush_stiffness  = model.roller_bush_stiffness.value;
  films.tooth_stiffness = model.roller_tooth_stiffness.value;
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    {
      const Joint joint = joint_of(k, drive, scene.drive);
      films.rollers.push_back({joint.roller, joint.inner, joint.bush_x});
    }
  for (std::size_t i = 0; i < drive.sprockets.size(); ++i)
    films.wheels.push_back({scene.drive.sprockets[i].body,
                            std::min(chain.roller_length, drive.sprocket_width),
                            drive.sprockets[i].form});
  scene.oil.push_back(films);
  scene.notes.push_back("Oil of " + to_text(1e3 * films.viscosity, 3) +
                        " mPa s fills the gaps between rollers, bushes and teeth.");
}
} // namespace chaindrive::scene
