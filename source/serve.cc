// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/serve.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/memory.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace chaindrive
{
namespace
{
constexpr std::size_t        longest_request = 1 << 20; // bytes
constexpr int                n_streams = 3, most_files = 16;
constexpr std::array<int, 2> from_terminal = {{SIGINT, SIGHUP}};

/// What is asked for.
struct Request
{
  std::vector<std::string> words, environment;
  std::vector<int>         files; ///< the three streams, the working directory, others

  bool is_whole() const { return !words.empty() && files.size() > n_streams; }
};

/// A copy at work.
struct Copy
{
  pid_t process;
  int   connection; ///< -1: the other side has gone
};

[[noreturn]] void fail(const std::string &what, const std::string &path)
{
  throw RunError(what + " '" + path + "': " + std::strerror(errno) + ".");
}

int open_socket(const std::string &path)
{
  sockaddr_un address = {};
  address.sun_family  = AF_UNIX;
  if (path.size() >= sizeof(address.sun_path))
    throw RunError("The path of a socket is too long: '" + path + "'.");
  std::copy(path.begin(), path.end(), std::begin(address.sun_path));
  const int  file   = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  const auto before = ::umask(0077);
  const bool bound =
      file >= 0 &&
      ::bind(file, reinterpret_cast<const sockaddr *>(&address), sizeof(address)) == 0 &&
      ::listen(file, SOMAXCONN) == 0;
  ::umask(before);
  if (!bound)
    fail("Cannot listen on the socket", path);
  return file;
}

bool is_own_user(const int connection)
{
  ucred     peer   = {};
  socklen_t length = sizeof(peer);
  return ::getsockopt(connection, SOL_SOCKET, SO_PEERCRED, &peer, &length) == 0 &&
         peer.uid == ::geteuid();
}

/// What the next message of @p connection asks for; not whole if it is no request.
Request receive(const int connection)
{
  std::vector<char>     text(longest_request);
  iovec                 part                                          = {text.data(), text.size()};
  alignas(cmsghdr) char control[CMSG_SPACE(most_files * sizeof(int))] = {};
  msghdr                message                                       = {};
  message.msg_iov                                                     = &part;
  message.msg_iovlen                                                  = 1;
  message.msg_control                                                 = control;
  message.msg_controllen                                              = sizeof(control);
  const ssize_t n = ::recvmsg(connection, &message, MSG_CMSG_CLOEXEC);

  Request request;
  for (cmsghdr *header = CMSG_FIRSTHDR(&message); header != nullptr;
       header          = CMSG_NXTHDR(&message, header))
    if (header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS)
      {
                 request.files.resize((header->cmsg_len - CMSG_LEN(0)) / sizeof(int));
                 std::memcpy(request.files.data(), CMSG_DATA(header), request.files.size() * sizeof(int));
      }
  if (n <= 0 || (message.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0)
    return request;
  std::vector<std::string> all;
  for (auto begin = text.begin(), end = begin + n; begin != end;)
    {
      const auto zero = std::find(begin, end, '\0');
      all.emplace_back(begin, zero);
      begin = zero == end ? end : zero + 1;
    }
  const std::size_t n_words = std::strtoul(all[0].c_str(), nullptr, 10);
  if (n_words < all.size())
    {
      request.words.assign(all.begin() + 1, all.begin() + 1 + n_words);
      request.environment.assign(all.begin() + 1 + n_words, all.end());
    }
  return request;
}

/// This process becomes the one that was asked for. The additional files stay open as long as it
/// lives.
bool become(const Request &request)
{
  if (::fchdir(request.files[n_streams]) != 0)
    return false;
  for (int stream = 0; stream < n_streams; ++stream)
    if (::dup2(request.files[stream], stream) < 0)
      return false;
  for (int file = 0; file <= n_streams; ++file)
    ::close(request.files[file]);
  ::clearenv();
  for (const std::string &variable : request.environment)
    if (const std::size_t equals = variable.find('='); equals != std::string::npos)
      ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  return true;
}

class Server
{
public:
  explicit Server(const std::string &path) : path_(path), socket_(open_socket(path))
  {
    sigset_t children;
    sigemptyset(&children);
    sigaddset(&children, SIGCHLD);
    ::sigprocmask(SIG_BLOCK, &children, &mask_before_);
    ended_ = ::signalfd(-1, &children, SFD_CLOEXEC);
    if (ended_ < 0)
      fail("Cannot wait for processes of the socket", path);
    // a terminal sends these to the copies, too, which may have much to do before they end
    for (std::size_t i = 0; i < from_terminal.size(); ++i)
      before_[i] = std::signal(from_terminal[i], SIG_IGN);
  }

  /// To the copies: their words. See serve().
  std::optional<std::vector<std::string>> work()
  {
    bool is_open = true;
    while (is_open || !copies_.empty())
      {
        std::vector<pollfd> files = {{ended_, POLLIN, 0}};
        if (is_open)
          {
            files.push_back({STDIN_FILENO, POLLIN, 0});
            files.push_back({socket_, POLLIN, 0});
          }
        const std::size_t n_own = files.size();
        for (const Copy &copy : copies_)
          files.push_back({copy.connection, POLLIN, 0}); // -1 is left out
        if (::poll(files.data(), files.size(), -1) < 0)
          continue;

        for (std::size_t i = n_own; i < files.size(); ++i)
          if (files[i].revents != 0)
            hear(copies_[i - n_own]);
        if (files[0].revents != 0)
          bury();
        if (!is_open)
          continue;
        if (files[2].revents != 0)
          if (auto words = accept())
            return words;
        if (files[1].revents != 0 && has_ended(STDIN_FILENO))
          {
            is_open = false;
            ::close(socket_);
            ::unlink(path_.c_str());
          }
      }
    return {};
  }

private:
  static bool has_ended(const int file)
  {
    std::array<char, 4096> ignored;
    return ::read(file, ignored.data(), ignored.size()) <= 0;
  }

  /// What the other side of a copy says: a signal, or, by closing the connection, that the copy is
  /// to end.
  static void hear(Copy &copy)
  {
    char          number = 0;
    const ssize_t n      = ::recv(copy.connection, &number, 1, 0);
    if (n < 0 && errno == EINTR)
      return;
    ::kill(copy.process, n == 1 ? number : SIGTERM);
    if (n != 1)
      {
        ::close(copy.connection);
        copy.connection = -1;
      }
  }

  /// Says of the copies that have ended how they did.
  void bury()
  {
    signalfd_siginfo ignored;
    if (::read(ended_, &ignored, sizeof(ignored)) < 0)
      return;
    int    status = 0;
    rusage usage  = {};
    for (pid_t process = 0; (process = ::wait4(-1, &status, WNOHANG, &usage)) > 0;)
      {
        const auto copy = std::find_if(copies_.begin(), copies_.end(), [process](const Copy &c) {
          return c.process == process;
        });
        if (copy == copies_.end())
          continue;
        const std::string answer =
            std::to_string(WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status)) + ' ' +
            std::to_string(usage.ru_maxrss);
        if (copy->connection >= 0)
          {
            ::send(copy->connection, answer.data(), answer.size(), MSG_NOSIGNAL);
            ::close(copy->connection);
          }
        copies_.erase(copy);
      }
  }

  std::optional<std::vector<std::string>> accept()
  {
    const int connection = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection < 0)
      return {};
    const Request request = is_own_user(connection) ? receive(connection) : Request();
    const pid_t   parent  = ::getpid();
    remember_pages_of_files();
    const pid_t process = request.is_whole() ? ::fork() : -1;
    if (process == 0)
      {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        for (const Copy &copy : copies_)
          if (copy.connection >= 0)
            ::close(copy.connection);
        ::close(connection);
        ::close(socket_);
        ::close(ended_);
        ::sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
        for (std::size_t i = 0; i < from_terminal.size(); ++i)
          std::signal(from_terminal[i], before_[i]);
        if (::getppid() != parent || !become(request))
          ::_exit(3);
        return request.words;
      }
    for (const int file : request.files)
      ::close(file);
    if (process > 0)
      copies_.push_back({process, connection});
    else
      ::close(connection);
    return {};
  }

  std::string path_;
  int         socket_, ended_;
  sigset_t    mask_before_;

  std::array<void (*)(int), from_terminal.size()> before_;

  std::vector<Copy> copies_;
};
} // namespace

std::optional<std::vector<std::string>> serve(const std::string &path)
{
  return Server(path).work();
}
} // namespace chaindrive
