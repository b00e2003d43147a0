// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/console.h>
#include <chaindrive/files/file.h>
#include <chaindrive/files/log.h>
#include <chaindrive/files/sink.h>
#include <chaindrive/utilities/errors.h>

#include <string_view>
#include <utility>

namespace chaindrive::files
{
class Log::Tee : public Sink
{
public:
  Tee(std::ostream *console, std::ostream *warnings)
      : console_(console), warnings_(warnings), slow_(dynamic_cast<const Console *>(console))
  {
  }

  void open(const std::string &path, const bool append)
  {
    file_ = std::make_unique<File>(path, path, append);
    to_file(std::exchange(unwritten_, {}));
  }

  void close()
  {
    show_status("");
    if (file_)
      file_->close();
    file_.reset();
  }

  void show_status(const std::string &line)
  {
    if (console_ == nullptr || (line.empty() && !status_shown_))
      return;
    if (!line.empty() && slow_ != nullptr && slow_->is_behind())
      return;
    // back to the first column, the text, and clear what is left of a longer line
    *console_ << '\r' << line << "\x1b[K" << std::flush;
    status_shown_ = !line.empty();
  }

  void warn(const std::string &text)
  {
    xsputn(text.data(), static_cast<std::streamsize>(text.size()));
    if (console_ == nullptr && warnings_ != nullptr)
      *warnings_ << text << std::flush;
  }

  void to_file(const std::string_view text)
  {
    if (!file_)
      {
        unwritten_ += text;
        return;
      }
    *file_ << text;
    // A log is most needed when the program ends unexpectedly: every line goes out at once. A
    // failure must not silence the console; the file remembers it until close().
    if (text.find('\n') != std::string_view::npos)
      try
        {
          file_->complete();
        }
      catch (const RunError &)
        {
        }
  }

protected:
  std::streamsize xsputn(const char *text, const std::streamsize n) override
  {
    if (console_ != nullptr)
      {
        show_status("");
        console_->write(text, n);
      }
    to_file({text, static_cast<std::size_t>(n)});
    return n;
  }

  int sync() override
  {
    if (console_ != nullptr)
      console_->flush();
    return 0;
  }

private:
  std::ostream         *console_, *warnings_;
  const Console        *slow_; ///< the console, if it is one
  std::unique_ptr<File> file_;
  std::string           unwritten_; ///< said before there was a file
  bool                  status_shown_ = false;
};

Log::Log(std::ostream *console, std::ostream *warnings)
    : std::ostream(nullptr), tee_(std::make_unique<Tee>(console, warnings))
{
  rdbuf(tee_.get());
}

Log::~Log() { tee_->show_status(""); }

void Log::open(const std::string &path, const bool append) { tee_->open(path, append); }

void Log::close() { tee_->close(); }

std::string Log::end_with(std::string line)
{
  try
    {
      tee_->to_file(line + '\n');
      tee_->close();
    }
  catch (const RunError &)
    {
    }
  return line;
}

void Log::warn(const std::string &line) { tee_->warn(line + '\n'); }

void Log::show_status(const std::string &line) { tee_->show_status(line); }

void Log::write_to_file(const std::string &line) { tee_->to_file(line + '\n'); }
} // namespace chaindrive::files
