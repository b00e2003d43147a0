// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/sections.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/registry.h>

#include <functional>
#include <string>
#include <vector>

namespace chaindrive::scene
{
/// What a .prm file can add to the scene of any drive: a force element (Scene::forces), a surface
/// that bodies may touch (Scene::surfaces), a load of a shaft over time (Scene::shafts). One is a
/// class in one file, which ends with its registration:
///
///     struct Brake
///     {
///       struct Parameters
///       {
///         double damping = 0.01; ///< N m s
///         void   declare(parameters::Declarations &declarations);
///       };
///       static void add_to(Scene &scene, const Parameters &parameters);
///     };
///     const Addition<Brake> registered_brake({"brake", "A torque against the rotation."});
///
/// Its entries form the section `Additions/brake`, which has one more, `Active`: nothing is added
/// unless that is true.
class AdditionRegistration
{
public:
  /// Changes the scene of a drive once all of its bodies are there: DriveView knows which are
  /// which. InputError for parameters that do not suit the drive.
  using Add = std::function<void(Scene &, const parameters::Sections &)>;

  /// One after the other in the order of @p about; the section of its name holds its entries.
  AdditionRegistration(const About &about, Add add);

  /// The section of an addition.
  static std::string section_of(const std::string &name) { return "Additions/" + name; }
};

/// The entries of an addition.
template <typename Values>
struct AdditionSection : parameters::Section
{
  std::unique_ptr<parameters::Section> clone() const override
  {
    return std::make_unique<AdditionSection>(*this);
  }
  void declare(parameters::Declarations &declarations) override
  {
    parameters::add(declarations,
                    "Active",
                    active,
                    "Whether this is added to the drive. Without it, no other "
                    "entry of its section has an effect.");
    values.declare(declarations);
  }
  bool is_active() const override { return active; }

  bool   active = false;
  Values values;
};

/// Registers T, which adds itself to a scene with T::add_to(scene, parameters).
template <typename T>
struct Addition : AdditionRegistration
{
  using Section = AdditionSection<typename T::Parameters>;

  explicit Addition(const About &about)
      : AdditionRegistration(
            about,
            [path = section_of(about.name)](Scene &scene, const parameters::Sections &sections) {
              const Section &section = sections.get<Section>(path);
              if (section.active)
                T::add_to(scene, section.values);
            })
  {
    parameters::register_section<Section>(section_of(about.name));
  }
};

/// Adds to @p scene what is registered and active.
void add_additions(const parameters::Sections &sections, Scene &scene);

/// The sprocket of @p drive that the value @p name of the entry @p entry means, "driver" or another
/// of its names. InputError when it has none of that name.
const Sprocket &
find_sprocket(const DriveView &drive, const std::string &name, const std::string &entry);
} // namespace chaindrive::scene
