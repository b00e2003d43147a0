// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain.h>
#include <chaindrive/model/bush_chain.h>

namespace chaindrive::model
{
std::vector<std::string> against_bush_chain(const Parameters &p)
{
  using parameters::Enforcement;
  using parameters::QuantityGroup;
  std::vector<std::string> sentences;
  if (drive::has_rollers(p.drive.chain))
    return sentences;
  const std::string chain = "Drive/Chain/Designation = " + p.drive.chain.designation +
                            " with Rollers = " + text_of(p.drive.chain.rollers) + " has not";
  const Enforcement enforcement = p.contact.enforcement;
  if (enforcement != Enforcement::automatic && enforcement != Enforcement::penalty)
    sentences.push_back("Contact/Enforcement = " + text_of(enforcement) +
                        " is for chains with rollers, which " + chain +
                        "; choose penalty or auto.");
  if (p.output.names(QuantityGroup::surface_velocity))
    sentences.push_back("Output/Quantities = " + text_of(QuantityGroup::surface_velocity) +
                        " is for rollers, which " + chain + "; leave it out.");
  return sentences;
}
} // namespace chaindrive::model
