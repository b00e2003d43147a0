// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/ratings.h>
#include <chaindrive/drive/strands.h>

namespace chaindrive::drive
{
std::string in_words_of_strands(const unsigned int strands)
{
  return std::to_string(strands) +
         " strands share the load equally, and one is computed with its share: masses, stiffnesses "
         "and tensions of the chain and forces in joints and on teeth are those of one strand; "
         "torques, inertias, loads of shafts and guides, forces of tensioners, power, losses, "
         "energies and sound those of all.";
}

double uneven_share(const unsigned int strands) { return strands / strand_factor(strands); }

void add_strands(Facts &facts, const unsigned int strands)
{
  facts.strands = strands;
  for (Facts::Sprocket &sprocket : facts.sprockets)
    for (double *value : {&sprocket.torque, &sprocket.inertia, &sprocket.load})
      *value *= strands;
  for (double *value : {&facts.power, &facts.shaft_load, &facts.driven_inertia})
    *value *= strands;
  facts.rated_power *= strand_factor(strands);
}
} // namespace chaindrive::drive
