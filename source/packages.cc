// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/packages.h>

#include <string>

namespace chaindrive
{
namespace
{
std::string packages_of(const std::string &what, const std::string &names)
{
  return what + " needs packages of Debian: apt install --no-install-recommends " + names;
}
} // namespace

std::string packages_of_reports() { return packages_of("A report", CHAINDRIVE_REPORT_PACKAGES); }

std::string packages_of_exports() { return packages_of("An export", CHAINDRIVE_REPORT_PACKAGES); }

std::string packages_of_studies() { return packages_of("A study", CHAINDRIVE_STUDY_PACKAGES); }
} // namespace chaindrive
