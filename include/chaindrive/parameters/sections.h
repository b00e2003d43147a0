// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/entries.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace chaindrive::parameters
{
/// A section of the .prm file that belongs to something that registers itself, with its values.
class Section
{
public:
  virtual ~Section() = default;

  virtual std::unique_ptr<Section> clone() const = 0;

  /// Declares an entry for each of its members, which takes every value that is set. It must
  /// outlive
  /// @p declarations.
  virtual void declare(Declarations &declarations) = 0;

  /// Whether what it belongs to is asked for. If not, what else it says has no effect.
  virtual bool is_active() const { return true; }

protected:
  Section()                           = default;
  Section(const Section &)            = default;
  Section &operator=(const Section &) = default;
};

/// That of a struct with a member function `void declare(Declarations &)`.
template <typename Values>
struct SectionOf : Section
{
  std::unique_ptr<Section> clone() const override { return std::make_unique<SectionOf>(*this); }
  void declare(Declarations &declarations) override { values.declare(declarations); }

  Values values;
};

/// Whether a class has a struct `Parameters` of its own.
template <typename T, typename = void>
inline constexpr bool has_parameters = false;
template <typename T>
inline constexpr bool has_parameters<T, std::void_t<typename T::Parameters>> = true;

/// Registers the section @p path, "Heading/name": each object of Sections then has one that @p make
/// has made.
void register_section(const std::string                               &path,
                      const std::function<std::unique_ptr<Section>()> &make);

/// The same for one that its default constructor makes.
template <typename Kind>
void register_section(const std::string &path)
{
  register_section(path, [] { return std::make_unique<Kind>(); });
}

/// Registers the section @p name of the @p set: of what several things have, each with values of
/// its own, such as the terms of a shaft's torque.
void register_section_of_set(const std::string                               &set,
                             const std::string                               &name,
                             const std::function<std::unique_ptr<Section>()> &make);

/// All sections that were registered when it was made, with their values; copies have their own.
class Sections
{
public:
  Sections();

  /// Those of a set, which have their names for paths and stand in the section that is open.
  explicit Sections(const std::string &set);

  ~Sections() = default;
  Sections(const Sections &other);
  Sections &operator=(const Sections &other);
  Sections(Sections &&)            = default;
  Sections &operator=(Sections &&) = default;

  void declare(Declarations &declarations);

  /// The section @p path, which was registered as a @p Kind.
  template <typename Kind>
  const Kind &get(const std::string &path) const
  {
    return dynamic_cast<const Kind &>(*sections_.at(path));
  }
  template <typename Kind>
  Kind &get(const std::string &path)
  {
    return dynamic_cast<Kind &>(*sections_.at(path));
  }

  /// Whether some of them are Section::is_active().
  bool any_active() const;

  /// Paths of those below @p heading that are Section::is_active().
  std::vector<std::string> active(const std::string &heading) const;

  /// Paths of those that are not Section::is_active().
  std::vector<std::string> inactive() const;

private:
  std::map<std::string, std::unique_ptr<Section>> sections_; ///< by path
};

/// Whether plug-ins have their sections below the heading @p name of a .prm file.
bool is_heading_of_plugins(const std::string &name);
} // namespace chaindrive::parameters
