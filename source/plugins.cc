// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/plugin.h>
#include <chaindrive/plugins.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/registry.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <ostream>

// Shared libraries that add to the program. What one is stands in a section of its file, so that it
// is read without loading the library: loading runs its static objects, which may expect other
// classes than those of this program.

namespace chaindrive
{
namespace
{
std::vector<Plugin> &all_plugins()
{
  static std::vector<Plugin> all;
  return all;
}

/// The bytes of the file @p path. InputError when there is none, or it cannot be read.
std::string read_library(const std::string &path)
{
  std::error_code error;
  const auto      status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw InputError("There is no plug-in '" + path +
                     "': --plugin takes the path of a shared library, which is looked for nowhere "
                     "else.");
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(status) || !in)
    throw InputError("The plug-in '" + path + "' cannot be read: it is " +
                     (std::filesystem::is_regular_file(status) ? "not permitted." : "no file."));
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The T at @p place of @p bytes; empty beyond their end.
template <typename T>
std::optional<T> number_at(const std::string &bytes, const std::size_t place)
{
  T value;
  if (place > bytes.size() || bytes.size() - place < sizeof(T))
    return {};
  std::memcpy(&value, bytes.data() + place, sizeof(T));
  return value;
}

bool is_shared_library(const std::string &bytes)
{
  const auto header = number_at<Elf64_Ehdr>(bytes, 0);
  return header && std::memcmp(header->e_ident, ELFMAG, SELFMAG) == 0 &&
         header->e_ident[EI_CLASS] == ELFCLASS64 && header->e_type == ET_DYN;
}

/// The contents of the section @p name of the shared library @p bytes; empty when it has none.
std::string contents_of_section(const std::string &bytes, const std::string &name)
{
  const auto header  = number_at<Elf64_Ehdr>(bytes, 0);
  const auto section = [&](const std::size_t i) {
    return number_at<Elf64_Shdr>(bytes, header->e_shoff + i * sizeof(Elf64_Shdr));
  };
  const auto names = section(header->e_shstrndx);
  for (std::size_t i = 0; names && i < header->e_shnum; ++i)
    if (const auto one = section(i))
      {
        const std::size_t at = names->sh_offset + one->sh_name;
        if (at < bytes.size() &&
            bytes.compare(at, name.size() + 1, name.c_str(), name.size() + 1) == 0 &&
            one->sh_offset < bytes.size())
          return bytes.substr(one->sh_offset, one->sh_size);
      }
  return "";
}

/// The texts in @p bytes, each of which ends with a zero.
std::vector<std::string> zero_ended_texts(const std::string &bytes)
{
  std::vector<std::string> texts;
  for (std::size_t at = 0, end; (end = bytes.find('\0', at)) != std::string::npos; at = end + 1)
    texts.push_back(bytes.substr(at, end - at));
  return texts;
}

/// What the shared library @p path says of itself. InputError when it is none of this program.
Plugin examine_plugin(const std::string &path)
{
  const std::string bytes = read_library(path);
  if (!is_shared_library(bytes))
    throw InputError("The plug-in '" + path + "' is no shared library for this machine.");
  const std::vector<std::string> texts =
      zero_ended_texts(contents_of_section(bytes, CHAINDRIVE_PLUGIN_SECTION));
  if (texts.size() < 4 || texts[0] != CHAINDRIVE_PLUGIN_MARK)
    throw InputError("'" + path + "' is a shared library, but no plug-in of chaindrive: " +
                     "CHAINDRIVE_PLUGIN() makes it one.");
  if (texts[1] != CHAINDRIVE_ABI)
    throw InputError("The plug-in '" + path + "' was made for another program: for " + texts[1] +
                     ", and this is " CHAINDRIVE_ABI
                     ". Build it again with the headers of this one.");
  for (const Plugin &other : all_plugins())
    if (other.name == texts[2])
      throw InputError("The plug-ins '" + other.path + "' and '" + path + "' have the same name, " +
                       texts[2] + ": load one of them.");
  return {std::filesystem::absolute(path).lexically_normal().string(),
          texts[2],
          texts[3],
          checksum(bytes)};
}

std::vector<std::string> registered_by(const std::string &plugin)
{
  std::vector<std::string> all;
  for (const AnyRegistry *registry : AnyRegistry::all())
    for (const AnyRegistry::Entry &entry : registry->entries())
      if (entry.plugin == plugin)
        all.push_back(registry->kind() + " '" + entry.about.name + "'");
  std::sort(all.begin(), all.end()); // registries come in the order of the linker
  return all;
}

void load_plugin(const std::string &path)
{
  const Plugin plugin = examine_plugin(path);
  AnyRegistry::begin_plugin(plugin.name);
  // absolute: a bare name would be looked for in folders that the environment names
  if (::dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr)
    throw InputError("The plug-in '" + path + "' cannot be loaded: " + ::dlerror() + ".");
  all_plugins().push_back(plugin);
  if (!AnyRegistry::problems().empty())
    throw InputError("The plug-in '" + path + "' cannot be used. " +
                     AnyRegistry::problems().front());
  if (registered_by(plugin.name).empty())
    throw InputError("The plug-in '" + path +
                     "' adds nothing: it registers no quantity, addition, term or fidelity.");
}

/// What goes wrong on this rank; empty: nothing.
std::string try_to_load(const std::vector<std::string> &files)
{
  try
    {
      for (const std::string &file : files)
        load_plugin(file);
      for (const AnyRegistry *registry : AnyRegistry::all())
        registry->order(); // throws if there is none
    }
  catch (const InputError &error)
    {
      return error.what();
    }
  return "";
}
} // namespace

void load_plugins(const std::vector<std::string> &files, const MPI_Comm comm)
{
  if (files.empty())
    return;
  std::string       loaded;
  const std::string problem = try_to_load(files);
  for (const Plugin &plugin : all_plugins())
    loaded += plugin.checksum;
  const auto problems = dealii::Utilities::MPI::all_gather(comm, problem);
  for (const std::string &one : problems)
    if (!one.empty())
      throw InputError(one);
  const auto checksums = dealii::Utilities::MPI::all_gather(comm, loaded);
  for (const std::string &one : checksums)
    if (one != checksums.front())
      throw InputError("The ranks do not find the same plug-ins: " + join(files) +
                       " differ from machine to machine.");
}

const std::vector<Plugin> &loaded_plugins() { return all_plugins(); }

std::string plugins_text()
{
  std::vector<std::string> all;
  for (const Plugin &plugin : all_plugins())
    all.push_back(plugin.name + " " + plugin.version);
  return "--plugin = " + (all.empty() ? "none" : join(all));
}

void print_plugins(std::ostream &out, const std::string &begin)
{
  for (const Plugin &plugin : all_plugins())
    out << begin << "Plug-in " << plugin.name << ' ' << plugin.version << ": " << plugin.path
        << ", checksum " << plugin.checksum << ", adds " << join(registered_by(plugin.name))
        << '\n';
}
} // namespace chaindrive
