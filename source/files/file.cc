// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <streambuf>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace chaindrive::files
{
std::string write_failure(const std::string &path, const int error_number)
{
  return "Cannot write '" + path + "': " +
         (error_number == ELOOP ? "it is a symbolic link" :
                                  std::generic_category().message(error_number)) +
         ".";
}

int create_anew(const std::string &path)
{
  struct ::stat there = {};
  if (::lstat(path.c_str(), &there) == 0)
    {
      if (!S_ISREG(there.st_mode) && !S_ISLNK(there.st_mode))
        return ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
      if (::unlink(path.c_str()) != 0)
        return -1;
    }
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

namespace
{
/// Waits for a file or directory. Returns an error number, or 0; not every file system can do this,
/// and a directory may be closed to readers.
int sync_path(const std::string &path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return errno == EACCES ? 0 : errno;
  const int error = ::fsync(descriptor) != 0 && errno != EINVAL ? errno : 0;
  ::close(descriptor);
  return error;
}

/// Waits for the name of a file: a rename is in its directory.
void sync_name(const std::string &path)
{
  const std::string directory = std::filesystem::path(path).parent_path().string();
  if (const int error = sync_path(directory.empty() ? "." : directory); error != 0)
    throw RunError(write_failure(path, error));
}
} // namespace

/// Writes to a file descriptor and keeps the first error number, which std::filebuf would lose.
class File::Buffer : public std::streambuf
{
public:
  Buffer(const std::string &path, const bool append)
      : descriptor_(append ?
                        ::open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666) :
                        create_anew(path))
      , error_(descriptor_ < 0 ? errno : 0)
  {
    if (append && error_ == 0)
      size_ = final_size_ = std::max<off_t>(0, ::lseek(descriptor_, 0, SEEK_END));
    setp(text_.data(), text_.data() + text_.size());
  }

  int error() const { return error_; }

  /// Everything handed over is final; after an error the file is cut back to its last final state.
  void complete()
  {
    flush();
    if (error_ == 0)
      final_size_ = size_;
    else if (descriptor_ >= 0)
        // nothing to be done if this fails too: the original error is the one that is reported
        [[maybe_unused]]
      const int ignored = ::ftruncate(descriptor_, final_size_);
  }

  void sync_with_disk()
  {
    if (::fsync(descriptor_) != 0 && errno != EINVAL) // not every file can be waited for
      error_ = errno;
  }

  void close()
  {
    if (descriptor_ >= 0 && ::close(descriptor_) != 0 && error_ == 0)
      error_ = errno;
    descriptor_ = -1;
  }

protected:
  int_type overflow(const int_type c) override
  {
    if (!flush())
      return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof()))
      sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

  int sync() override { return flush() ? 0 : -1; }

  /// What does not fit goes to the file straight away.
  std::streamsize xsputn(const char *text, const std::streamsize n) override
  {
    if (n < static_cast<std::streamsize>(text_.size()))
      return std::streambuf::xsputn(text, n);
    return flush() && write(text, text + n) ? n : 0;
  }

private:
  bool flush()
  {
    write(pbase(), pptr());
    setp(text_.data(), text_.data() + text_.size());
    return error_ == 0;
  }

  bool write(const char *next, const char *end)
  {
    while (next != end && error_ == 0)
      {
        const ssize_t n = ::write(descriptor_, next, end - next);
        if (n >= 0)
          {
            next += n;
            size_ += n;
          }
        else if (errno != EINTR)
          error_ = errno;
      }
    return error_ == 0;
  }

  int                     descriptor_, error_;
  off_t                   size_ = 0, final_size_ = 0;
  std::array<char, 65536> text_;
};

File::File(const std::string &path, const std::string &name, const bool append)
    : std::ostream(nullptr)
    , name_(name.empty() ? path : name)
    , buffer_(std::make_unique<Buffer>(path, append))
{
  if (buffer_->error() != 0)
    throw RunError(write_failure(name_, buffer_->error()));
  rdbuf(buffer_.get());
}

File::~File()
{
  buffer_->complete();
  buffer_->close();
}

void File::complete()
{
  buffer_->complete();
  if (buffer_->error() != 0)
    throw RunError(write_failure(name_, buffer_->error()));
}

void File::sync()
{
  complete();
  buffer_->sync_with_disk();
  if (buffer_->error() != 0)
    throw RunError(write_failure(name_, buffer_->error()));
}

void File::close()
{
  complete();
  buffer_->close();
  if (buffer_->error() != 0)
    throw RunError(write_failure(name_, buffer_->error()));
}

namespace
{
/// Whether a device or a pipe is called so, of which a file must not take the place.
bool is_special(const std::string &path)
{
  struct ::stat there = {};
  return ::stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
}

/// Whether @p path is a symbolic link.
bool is_link(const std::string &path)
{
  struct ::stat there = {};
  return ::lstat(path.c_str(), &there) == 0 && S_ISLNK(there.st_mode);
}
} // namespace

void write_file(const std::string                         &path,
                const std::function<void(std::ostream &)> &write,
                const bool                                 durable)
{
  if (is_special(path))
    {
      if (is_link(path))
        throw RunError(write_failure(path, ELOOP));
      File file(path);
      write(file);
      file.close();
      return;
    }
  const std::string part = path + ".part";
  try
    {
      File file(part, path);
      write(file);
      if (durable)
        file.sync();
      file.close();
      if (std::rename(part.c_str(), path.c_str()) != 0)
        throw RunError(write_failure(path, errno));
    }
  catch (...)
    {
      ::unlink(part.c_str());
      throw;
    }
  if (durable)
    sync_name(path);
}

void sync_file(const std::string &path)
{
  if (const int error = sync_path(path); error != 0)
    throw RunError(write_failure(path, error));
  sync_name(path);
}

void write_text(const std::string &path, const std::string &text)
{
  write_file(path, [&text](std::ostream &out) { out << text; });
}

std::string find_file(const std::string &name, const std::vector<std::string> &folders)
{
  namespace fs = std::filesystem;
  std::vector<std::string> looked;
  for (const std::string &folder : folders) // an absolute name takes the folder's place
    {
      std::string path = (fs::path(folder) / name).lexically_normal().string();
      if (fs::is_regular_file(path))
        return path;
      if (std::find(looked.begin(), looked.end(), path) == looked.end())
        looked.push_back(path);
    }
  for (const std::string &path : looked)
    if (fs::is_directory(path))
      throw InputError("'" + path + "' is a folder; a file is needed.");
  std::string places;
  for (const std::string &path : looked)
    places += (places.empty() ? "; looked for " : " and ") + path;
  throw InputError("There is no file '" + name + "'" +
                   (looked == std::vector<std::string>{name} ? "" : places) + ".");
}

std::string read_text(const std::string &path)
{
  std::ifstream     in(path, std::ios::binary);
  std::stringstream text;
  if (!in || (in.peek() != std::ifstream::traits_type::eof() && !(text << in.rdbuf())))
    throw InputError("Cannot read '" + path + "'.");
  return text.str();
}
} // namespace chaindrive::files
