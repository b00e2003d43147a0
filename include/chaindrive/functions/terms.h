// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/functions/function.h>
#include <chaindrive/parameters/sections.h>
#include <chaindrive/utilities/registry.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// What a .prm file can add to the torque or speed of a shaft. One term is a class in one file of
/// source/functions/terms, which ends with its registration:
///
///     struct Pulse
///     {
///       struct Parameters
///       {
///         double height = 0.; ///< N m
///         bool   is_active() const { return height != 0.; }
///         void   declare(parameters::Declarations &declarations);
///       };
///       static Term make(const Parameters &parameters, const Shaft &shaft);
///     };
///     const TermOf<Pulse> registered_pulse(Of::torque, {"Pulse", "A torque of half a sine
///     wave."});
///
/// Its entries form the section `Pulse` of each shaft that has a torque, such as
/// Loads/driven/Pulse.
namespace chaindrive::functions
{
/// Of what a term is one.
enum class Of
{
  speed, ///< of a driver
  torque ///< that resists a shaft which the chain drives
};

/// The name of the set of their sections: Sections(set_of(of)) has them.
std::string set_of(Of of);

/// What a term is a function of.
enum class Variable
{
  time,  ///< s; of a speed it is added, rad/s
  angle, ///< turned since the start in the sense of operation, rad; of a speed by which part of it
         ///< the speed fluctuates
  speed  ///< in that sense, rad/s; of a torque
};

/// One term, in N m or as Variable says.
struct Term
{
  Variable    variable;
  Pointer     function;
  bool        replaces = false; ///< it takes the place of the speed of section Loads and its ramp
  std::string file     = {};    ///< that was read for it
};

/// The shaft that a term is made for.
struct Shaft
{
  std::string              section; ///< of its entries, such as "Loads/driver"
  std::vector<std::string> folders; ///< where files are looked for
  double                   start;   ///< of the run, s
  double                   run_up;  ///< until when the speed of section Loads grows, s
  double                   speed;   ///< which it has from then on, rad/s
};

/// The entries of a term.
template <typename Values>
struct TermSection : parameters::Section
{
  std::unique_ptr<parameters::Section> clone() const override
  {
    return std::make_unique<TermSection>(*this);
  }
  void declare(parameters::Declarations &declarations) override { values.declare(declarations); }
  bool is_active() const override { return values.is_active(); }

  Values values;
};

class TermRegistration
{
public:
  /// Adds to terms what @p sections, those of a shaft, ask for.
  using Make =
      std::function<void(std::vector<Term> &, const parameters::Sections &, const Shaft &)>;

  TermRegistration(Of                                                           of,
                   const About                                                 &about,
                   Make                                                         make,
                   const std::function<std::unique_ptr<parameters::Section>()> &section);
};

/// Registers T, whose T::make(parameters, shaft) makes a term of @p of.
template <typename T>
struct TermOf : TermRegistration
{
  using Section = TermSection<typename T::Parameters>;

  TermOf(const Of of, const About &about)
      : TermRegistration(
            of,
            about,
            [name = about.name](std::vector<Term>          &terms,
                                const parameters::Sections &sections,
                                const Shaft                &shaft) {
              const Section &section = sections.get<Section>(name);
              if (!section.is_active())
                return;
              Shaft at = shaft;
              at.section += "/" + name;
              terms.push_back(T::make(section.values, at));
            },
            [] { return std::make_unique<Section>(); })
  {
  }
};

/// The terms that the sections of a shaft ask for, in the order of their registrations. InputError
/// for values that do not go together, and for files that are no tables.
std::vector<Term> make_terms(Of of, const parameters::Sections &sections, const Shaft &shaft);
} // namespace chaindrive::functions
