// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/declarations.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <memory>

namespace chaindrive::parameters
{
namespace
{
/// Accepts what a function accepts; its description is for those who click.
class Pattern : public dealii::Patterns::PatternBase
{
public:
  Pattern(const std::string &form, const std::function<bool(const std::string &)> &accepts)
      : form_(form), accepts_(accepts)
  {
  }

  bool match(const std::string &value) const override { return accepts_(value); }

  std::string description(const OutputStyle) const override { return form_; }

  std::unique_ptr<PatternBase> clone() const override { return std::make_unique<Pattern>(*this); }

private:
  std::string                              form_;
  std::function<bool(const std::string &)> accepts_;
};
} // namespace

Entry &Declarations::add(const std::string                              &name,
                         const std::string                              &default_value,
                         const std::string                              &allowed,
                         const std::string                              &meaning,
                         const std::function<bool(const std::string &)> &accepts,
                         const std::function<void(const std::string &)> &store,
                         const std::string                              &form)
{
  prm_.declare_entry(
      name, default_value, Pattern(form, accepts), meaning + " Allowed: " + allowed + ".");
  prm_.add_action(name, store); // stores the default, too: from text and back it is unchanged
  entries_.push_back({open_, name, default_value, allowed, meaning, on_resume_, {}});
  return entries_.back();
}

Subsection::Subsection(Declarations      &declarations,
                       const std::string &name,
                       const OnResume     on_resume)
    : declarations_(declarations)
    , outer_(declarations.open_)
    , outer_on_resume_(declarations.on_resume_)
{
  declarations.open_      = outer_.empty() ? name : outer_ + "/" + name;
  declarations.on_resume_ = on_resume;
  declarations.sections_.push_back(declarations.open_);
  declarations.prm_.enter_subsection(name);
}

Subsection::~Subsection()
{
  declarations_.prm_.leave_subsection();
  declarations_.open_      = outer_;
  declarations_.on_resume_ = outer_on_resume_;
}

const Entry *Declarations::find(const std::string &section, const std::string &name) const
{
  const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry &e) {
    return e.section == section && e.name == name;
  });
  return entry == entries_.end() ? nullptr : &*entry;
}

bool Declarations::has_section(const std::string &path) const
{
  return path.empty() || std::find(sections_.begin(), sections_.end(), path) != sections_.end();
}

std::vector<std::string> Declarations::entry_names(const std::string &section) const
{
  std::vector<std::string> names;
  for (const Entry &entry : entries_)
    if (entry.section == section)
      names.push_back(entry.name);
  return names;
}

std::vector<std::string> Declarations::section_names(const std::string &section) const
{
  const std::string        begin = section.empty() ? "" : section + "/";
  std::vector<std::string> names;
  for (const std::string &path : sections_)
    if (path.size() > begin.size() && path.compare(0, begin.size(), begin) == 0 &&
        path.find('/', begin.size()) == std::string::npos)
      names.push_back(path.substr(begin.size()));
  return names;
}

void Declarations::print(std::ostream &out, const dealii::ParameterHandler::OutputStyle style) const
{
  prm_.print_parameters(out,
                        dealii::ParameterHandler::OutputStyle(
                            style | dealii::ParameterHandler::KeepDeclarationOrder));
}

void Declarations::set(const Entry &entry, const std::string &value, const std::string &where)
{
  const std::vector<std::string> path = dealii::Utilities::split_string_list(entry.section, '/');
  for (const std::string &name : path)
    prm_.enter_subsection(name);
  bool allowed = true;
  try
    {
      prm_.set(entry.name, value);
    }
  catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
    {
      allowed = false;
    }
  for (std::size_t i = 0; i < path.size(); ++i)
    prm_.leave_subsection();
  if (!allowed)
    throw InputError(where + entry.path() + " = " + (value.empty() ? "(nothing)" : value) +
                     " is not allowed: it must be " + entry.allowed + ".");
}
} // namespace chaindrive::parameters
