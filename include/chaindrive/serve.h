// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace chaindrive
{
/// Listens on the Unix socket @p path, which must not exist yet, and makes a copy of this process
/// for each request: a copy has the libraries that a new program would spend most of a second on.
/// The other side is scripts/study/served.py.
///
/// A request is a message of the socket (SOCK_SEQPACKET): the number of words of the command line,
/// the words, the environment as "name=value", each ended by a zero byte; with it come open files:
/// standard input, output and error, the working directory, and others, which the copy keeps open.
/// Each byte that follows is the number of a signal for the copy. The answer is a message, the
/// status of the copy in decimal digits, or -N if signal N ended it, and the largest memory of the
/// copy in kilobytes. A copy gets SIGTERM when the
/// other side closes the connection, and when this process dies. Who is not the user of this
/// process is not served.
///
/// Returns the command line to the copies, with streams, working directory and environment as asked
/// for; nothing to the process that listens, after its standard input has ended and then the last
/// copy. RunError if it cannot listen there. To be called before MPI_Init() and before threads are
/// started.
std::optional<std::vector<std::string>> serve(const std::string &path);
} // namespace chaindrive
