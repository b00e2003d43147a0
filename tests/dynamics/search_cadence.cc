// SPDX-License-Identifier: LGPL-2.1-or-later
// The search driven by displacement misses nothing: the layered drive moves bit by bit as it does
// with a search at every step, and searches far less.
#include "../support/decided.h"
#include "../support/scenes.h"

using namespace test;

int main()
{
  Parameters parameters;
  parameters.model.fidelity        = "layered";
  parameters.output.field_interval = 0.;
  parameters.drive.layout.start =
      parameters::Start::settled; // at speed: rollers arrive from the first moment on
  const scene::Scene scene = scene_of(parameters);

  dynamics::System    seldom(scene, false), always(scene, true);
  const double        dt               = 0.25 * seldom.critical_time_step();
  const unsigned long n                = static_cast<unsigned long>(4e-3 / dt);
  unsigned long       first_difference = 0;
  unsigned int        most = 0, least = 1000;
  for (unsigned long i = 1; i <= n; ++i)
    {
      seldom.advance(dt, i * dt);
      always.advance(dt, i * dt);
      if (first_difference == 0)
        for (unsigned int j = 0; j < 3 * seldom.world.n_bodies(); ++j)
          if (seldom.world.displacement.local_element(j) !=
              always.world.displacement.local_element(j))
            first_difference = i;
      unsigned int touching = 0;
      for (const auto &family : seldom.contacts.families())
        touching += family->needs_search() ? family->n_touching() : 0;
      most  = std::max(most, touching);
      least = std::min(least, touching);
    }
  verdict("the same motion, bit by bit", first_difference == 0);
  verdict("contacts with teeth came and went", most > least);
  verdict("a search at every step when asked for",
          always.contacts.search_statistics().searches ==
              always.contacts.search_statistics().evaluations);
  verdict("a hundred times fewer otherwise",
          seldom.contacts.search_statistics().searches * 100 < n);
}
