// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/effects.h>

#include <stdexcept>

namespace chaindrive::model
{
std::string Decision::name() const
{
  const std::string text = parameters::text_of(effect);
  return sprocket.empty() ? text : text + " " + sprocket;
}

const Decision &Effects::of(const Effect effect, const unsigned int sprocket) const
{
  unsigned int n = 0;
  for (const Decision &decision : decisions_)
    if (decision.effect == effect && n++ == sprocket)
      return decision;
  throw std::logic_error("an effect that nobody decided");
}
} // namespace chaindrive::model
