// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/files/json.h>

namespace chaindrive::files
{
void write_json(const std::string &path, const Json &content)
{
  write_file(path, [&content](std::ostream &out) {
    // texts may come from file names, which need not be UTF-8
    out << content.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  });
}
} // namespace chaindrive::files
