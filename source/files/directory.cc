// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/directory.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <regex>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace chaindrive::files
{
namespace
{
constexpr std::array<const char *, 9> groups{
    {"hubs", "guides", "rollers", "teeth", "links", "spans", "joints", "plates", "energy"}};

std::string csv_files()
{
  std::string names;
  for (const char *group : groups)
    names += (names.empty() ? "histories_(" : "|") + std::string(group);
  return names + ")\\.csv";
}

// Names of results, as regular expressions.
constexpr const char *others = "(parameters\\.prm|input\\.prm|log\\.txt)";
constexpr const char *series =
    "(histories(-[0-9]+)?\\.h5|histories\\.saved|checkpoint-[0-9]+\\.ckpt)";
constexpr const char *lists       = "(bodies|bars|contacts)\\.pvd";
constexpr const char *field_files = "(bodies|bars|contacts)_[0-9]+(\\.[0-9]+)?\\.p?vtu";
constexpr const char *summary =
    "(summary\\.json|acoustics\\.(json|h5)|noise_[A-Za-z0-9_]+\\.wav|report\\.html)";
constexpr const char *unfinished = "\\.part";

std::string either(const std::vector<std::string> &names)
{
  std::string all;
  for (const std::string &name : names)
    all += (all.empty() ? "(" : "|") + name;
  return all + ")";
}

/// Finished or not.
std::string both(const std::string &names) { return names + "(" + unfinished + ")?"; }

/// The files of @p directory whose whole name matches @p names, symbolic links among them wherever
/// they lead; only directories if so asked.
std::vector<fs::path>
entries(const fs::path &directory, const std::string &names, const bool directories = false)
{
  const std::regex      expression(names);
  std::error_code       error;
  std::vector<fs::path> found;
  for (auto entry = fs::directory_iterator(directory, error); !error && entry != fs::end(entry);
       entry.increment(error))
    {
      std::error_code ignored;
      if (std::regex_match(entry->path().filename().string(), expression) &&
          (directories ? entry->is_directory(ignored) :
                         entry->is_regular_file(ignored) || entry->is_symlink(ignored)))
        found.push_back(entry->path());
    }
  return found;
}

void remove(const std::vector<fs::path> &files)
{
  std::error_code error;
  for (const fs::path &file : files)
    if (!fs::remove(file, error) && error)
      throw InputError("Cannot replace the earlier result '" + file.string() +
                       "': " + error.message() + ".");
}
} // namespace

bool is_history_group(const std::string &group)
{
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

/// A lock on an open file, which says for other processes who has it. The file goes with it.
class Directory::Lock
{
public:
  /// Waits for nobody.
  explicit Lock(std::string file) : file_(std::move(file))
  {
    do
      {
        close();
        descriptor_ =
            ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0666);
        error_ = descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 ? errno : 0;
      }
    while (error_ == 0 && !is_still_there()); // who had it may have removed the file meanwhile
    if (error_ == 0)
      say_who();
  }

  Lock(const Lock &)            = delete;
  Lock &operator=(const Lock &) = delete;

  ~Lock()
  {
    if (descriptor_ >= 0 && !is_taken())
      ::unlink(file_.c_str());
    close();
  }

  bool is_open() const { return descriptor_ >= 0; }
  bool is_taken() const { return error_ == EWOULDBLOCK; }
  int  error() const { return error_; }

  /// What the other process says about itself.
  std::string owner() const
  {
    std::array<char, 256> text{};
    const ssize_t         n = ::pread(descriptor_, text.data(), text.size(), 0);
    return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0))};
  }

private:
  void close()
  {
    if (descriptor_ >= 0)
      ::close(descriptor_);
    descriptor_ = -1;
  }

  bool is_still_there() const
  {
    struct ::stat mine = {}, there = {};
    return ::fstat(descriptor_, &mine) == 0 && ::lstat(file_.c_str(), &there) == 0 &&
           mine.st_ino == there.st_ino && mine.st_dev == there.st_dev;
  }

  void say_who() const
  {
    std::array<char, 128> host{}, date{};
    ::gethostname(host.data(), host.size() - 1);
    const std::time_t now   = std::time(nullptr);
    std::tm           parts = {};
    std::strftime(date.data(), date.size(), "%F %T", ::localtime_r(&now, &parts));
    const std::string text =
        "process " + std::to_string(::getpid()) + " on " + host.data() + ", since " + date.data();
    // a full disk takes the name, not the lock
    [[maybe_unused]] const bool written =
        ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, text.data(), text.size(), 0) > 0;
  }

  std::string file_;
  int         descriptor_ = -1;
  int         error_      = 0;
};

Directory::Directory(std::string path) : path_(std::move(path)) {}

Directory::~Directory() = default;

std::string Directory::refusal() const
{
  return "The output directory '" + path_ + "' cannot be used: ";
}

std::string Directory::lock()
{
  // to be able to make this file is to be able to write there; access() knows nothing of read-only
  // or full disks
  lock_ = std::make_unique<Lock>((fs::path(path_) / "chaindrive.lock").string());
  if (lock_->is_taken())
    {
      const std::string owner = lock_->owner();
      throw InputError("Another run is at work in the output directory '" + path_ + "'" +
                       (owner.empty() ? "" : ": " + owner) +
                       ". Choose another one with --output, or wait for its end.");
    }
  if (!lock_->is_open())
    throw InputError(refusal() +
                     (lock_->error() == ELOOP ? "chaindrive.lock there is a symbolic link" :
                                                std::generic_category().message(lock_->error())) +
                     ".");
  if (lock_->error() != 0)
    return "The output directory '" + path_ + "' cannot be locked (" +
           std::generic_category().message(lock_->error()) +
           "): see to it that no other run uses it.";
  return "";
}

void Directory::check_components() const
{
  // The first component that is no directory explains more than the system's "Not a directory".
  fs::path        part;
  std::error_code error;
  for (const fs::path &component : fs::path(path_))
    {
      part /= component;
      const fs::file_status status = fs::status(part, error);
      if (fs::exists(status) && !fs::is_directory(status))
        throw InputError(refusal() + (part == path_ ? "it" : "'" + part.string() + "'") +
                         " is a file, not a directory.");
    }
}

void Directory::check_contents() const
{
  const std::string names = both(either({series, lists, others, summary, csv_files()}));
  auto              found = entries(path_, names, true);
  const auto        below = entries(fs::path(path_) / "fields", field_files, true);
  found.insert(found.end(), below.begin(), below.end());
  if (!found.empty())
    throw InputError(refusal() + "'" + found.front().string() +
                     "' is a directory, where a result is to stand.");
  std::error_code       error;
  const fs::path        fields = fs::path(path_) / "fields";
  const fs::file_status status = fs::status(fields, error);
  if (fs::exists(status) && !fs::is_directory(status))
    throw InputError(refusal() + "'" + fields.string() +
                     "' is a file, where a directory is to stand.");
  if (fs::is_symlink(fs::symlink_status(fields, error)))
    throw InputError(refusal() + "'" + fields.string() +
                     "' is a symbolic link, where a directory is to stand.");
}

std::string Directory::strangers() const
{
  const std::regex ours(
      either({both(either({series, lists, others, summary, csv_files()})),
              "fields|chaindrive\\.lock|variant\\.(prm|lock)|errors\\.txt|result\\.json"}));
  std::error_code error;
  std::string     first;
  std::size_t     n = 0;
  for (auto entry = fs::directory_iterator(path_, error); !error && entry != fs::end(entry);
       entry.increment(error))
    if (const std::string name = entry->path().filename().string(); !std::regex_match(name, ours))
      {
        ++n;
        first = first.empty() ? name : std::min(first, name);
      }
  if (n == 0 || fs::exists(fs::path(path_) / "log.txt"))
    return "";
  return "The output directory '" + path_ + "' holds " + std::to_string(n) +
         (n == 1 ? " file" : " files") + " that no run has written, such as '" + first +
         "': the results go beside them.";
}

void Directory::spare(const std::string &parameter_file) const
{
  // a run opens its log first, then writes these two
  std::error_code error;
  const fs::path  folder(path_);
  if (fs::exists(folder / "log.txt", error))
    return;
  for (const char *name : {"parameters.prm", "input.prm"})
    {
      const fs::path file = folder / name;
      if (!fs::exists(fs::symlink_status(file, error)))
        continue;
      const bool own = fs::equivalent(file, parameter_file, error);
      if (own && file.filename() == "input.prm")
        continue; // gets the text that it has
      throw InputError(refusal() + "'" + file.string() + "' is " +
                       (own ? "the parameter file of this run" : "there and not of a run") +
                       ", and would be replaced. Choose another one with --output, or rename the "
                       "file.");
    }
}

std::string Directory::claim()
{
  check_components();
  std::error_code error;
  if (!fs::is_directory(path_, error))
    return "";
  check_contents();
  return lock();
}

std::string Directory::take_over(const bool resumes, const bool csv)
{
  std::string warning;
  if (lock_ == nullptr)
    {
      check_components();
      std::error_code error;
      fs::create_directories(path_, error);
      if (error)
        throw InputError(refusal() + error.message() + ".");
      check_contents(); // another run may have made it meanwhile
      warning = lock();
    }
  const auto ended = [resumes](const std::string &names) {
    return resumes ? names + unfinished : both(names);
  };
  remove(entries(path_, both(summary)));
  remove(entries(path_, ended(either({series, lists}))));
  if (!resumes || !csv)
    remove(entries(path_, csv_files()));
  remove(entries(fs::path(path_) / "fields", ended(field_files)));
  return warning;
}
} // namespace chaindrive::files
