// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/model/model.h>
#include <chaindrive/parameters/fidelity.h>
#include <chaindrive/scene/scene.h>

#include <functional>

namespace chaindrive::scene
{
/// A fidelity is a model of the chain: a builder of its bodies, motions and interfaces. One that is
/// added to the program's own is one file, which ends with its registration:
///
///     void add_stiff_chain(const model::Model &, const drive::Drive &, Scene &);
///     const Fidelity stiff({"stiff", "rigid rollers at a constant distance."},
///                          {false, false, false},
///                          &add_stiff_chain);
///
/// Then `set Fidelity = stiff` chooses it. A builder adds the bodies of the chain and says in
/// Scene::drive which are its rollers; sprockets, loads and additions come after it.
class Fidelity
{
public:
  using Builder = std::function<void(const model::Model &, const drive::Drive &, Scene &)>;

  Fidelity(const About &about, const parameters::Capabilities &capabilities, Builder builder);

  /// The builder of the fidelity @p name; std::logic_error when there is none of that name.
  static const Builder &builder_of(const std::string &name);
};
} // namespace chaindrive::scene
