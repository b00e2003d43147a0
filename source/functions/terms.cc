// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/functions/terms.h>

#include <utility>

namespace chaindrive::functions
{
namespace
{
Registry<TermRegistration::Make> &all_terms(const Of of)
{
  static Registry<TermRegistration::Make> of_speed("term of a speed"),
      of_torque("term of a torque");
  return of == Of::speed ? of_speed : of_torque;
}
} // namespace

std::string set_of(const Of of) { return of == Of::speed ? "speed" : "torque"; }

TermRegistration::TermRegistration(
    const Of                                                     of,
    const About                                                 &about,
    Make                                                         make,
    const std::function<std::unique_ptr<parameters::Section>()> &section)
{
  all_terms(of).add(about, std::move(make));
  parameters::register_section_of_set(set_of(of), about.name, section);
}

std::vector<Term> make_terms(const Of of, const parameters::Sections &sections, const Shaft &shaft)
{
  std::vector<Term> terms;
  if (sections.any_active())
    for (const auto &[entry, make] : all_terms(of).in_order())
      make(terms, sections, shaft);
  return terms;
}
} // namespace chaindrive::functions
