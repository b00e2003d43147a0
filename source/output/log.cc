// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/output/file.h>
#include <chaindrive/output/log.h>
#include <chaindrive/utilities/errors.h>

#include <streambuf>
#include <string_view>
#include <utility>

namespace chaindrive::output
{
class Log::Tee : public std::streambuf
{
public:
  explicit Tee(std::ostream *console) : console_(console) {}

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
    // back to the first column, the text, and clear what is left of a longer line
    *console_ << '\r' << line << "\x1b[K" << std::flush;
    status_shown_ = !line.empty();
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

  int_type overflow(const int_type c) override
  {
    const char character = traits_type::to_char_type(c);
    if (!traits_type::eq_int_type(c, traits_type::eof()))
      xsputn(&character, 1);
    return traits_type::not_eof(c);
  }

  int sync() override
  {
    if (console_ != nullptr)
      console_->flush();
    return 0;
  }

private:
  std::ostream         *console_;
  std::unique_ptr<File> file_;
  std::string           unwritten_; ///< said before there was a file
  bool                  status_shown_ = false;
};

Log::Log(std::ostream *console) : std::ostream(nullptr), tee_(std::make_unique<Tee>(console))
{
  rdbuf(tee_.get());
}

Log::~Log() { tee_->show_status(""); }

void Log::open(const std::string &path, const bool append) { tee_->open(path, append); }

void Log::close() { tee_->close(); }

void Log::show_status(const std::string &line) { tee_->show_status(line); }

void Log::write_to_file(const std::string &line) { tee_->to_file(line + '\n'); }
} // namespace chaindrive::output
