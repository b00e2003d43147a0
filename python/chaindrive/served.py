# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts chaindrive many times without loading its libraries many times.

`chaindrive serve SOCKET` makes a copy of itself for each start (include/chaindrive/serve.h says what goes over the
socket). Where no server can be reached, a process is started as usual.
"""
from __future__ import annotations

import array
import contextlib
import os
import pathlib
import select
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from typing import IO, Any, Optional, Union

VARIABLE = "CHAINDRIVE_SERVER"  # "SOCKET:PROGRAM" of the server that runs

# in a container all are root, and there may be more ranks than cores
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe"}  # the last is of OpenMPI 5


class Server:
    """A server of `program`, until stop() or the end of this process.

    Whatever is started meanwhile finds it in the environment.
    """

    def __init__(self, program: str | os.PathLike[str]) -> None:
        self.before = os.environ.get(VARIABLE)
        self.folder = tempfile.mkdtemp(prefix="chaindrive-")
        path = f"{self.folder}/socket"
        self.process = subprocess.Popen([str(program), "serve", path], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
        os.environ[VARIABLE] = f"{path}:{pathlib.Path(program).resolve()}"

    def stop(self) -> None:
        """Ends the server when the last copy has ended."""
        os.environ.pop(VARIABLE, None)
        if self.before is not None:
            os.environ[VARIABLE] = self.before
        if self.process.stdin:
            self.process.stdin.close()
        self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


@contextlib.contextmanager
def serving(program: str | os.PathLike[str]) -> Iterator[None]:
    """A server within a with statement."""
    server = Server(program)
    try:
        yield
    finally:
        server.stop()


class Copy:
    """A copy at work, with what subprocess.Popen has: poll(), wait(), send_signal(), returncode; and its largest memory in bytes."""

    def __init__(self, connection: socket.socket) -> None:
        self.connection = connection
        self.returncode: Optional[int] = None
        self.memory = 0

    def poll(self, timeout: float | None = 0.0) -> int | None:
        """The status, or None while the copy is at work; waits for `timeout` s at most, None: without end."""
        if self.returncode is None and select.select([self.connection], [], [], timeout)[0]:
            answer = self.connection.recv(64)
            status, kilobytes = map(int, answer.split() or (-signal.SIGTERM, 0))  # the server has died, and its copies with it
            self.returncode, self.memory = status, 1024 * kilobytes
            self.connection.close()
        return self.returncode

    def wait(self) -> int | None:
        """The status, after the end."""
        return self.poll(None)

    def send_signal(self, number: int) -> None:
        """Sends the copy a signal, if it is still at work."""
        if self.returncode is None:
            with contextlib.suppress(OSError):
                self.connection.send(bytes([number]))


#: A file that is open for what a process says, or subprocess.DEVNULL.
Stream = Union[IO[Any], int]


def ask(words: Sequence[str], streams: Sequence[int], environment: Mapping[str, str], folder: str, keep: Sequence[int]) -> Copy | None:
    """A copy for these words, or None if no server takes them."""
    path, _, program = os.environ.get(VARIABLE, "").rpartition(":")
    if not path or not os.path.exists(path) or os.path.realpath(shutil.which(words[0]) or words[0]) != program:
        return None
    parts = [str(len(words)), *words, *(f"{name}={value}" for name, value in environment.items())]
    message = b"".join(os.fsencode(part) + b"\0" for part in parts)
    connection = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        connection.connect(path)
        files = array.array("i", [*streams, directory, *keep])
        connection.sendmsg([message], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, files)])
    except OSError:  # it has ended, is on another machine, or the words are too many for a message
        connection.close()
        return None
    finally:
        os.close(directory)
    return Copy(connection)


def popen(words: Sequence[str], stdout: Stream, stderr: Stream, environment: Mapping[str, str] | None = None, folder: str = ".",
          keep: Sequence[int] = (), **how: Any) -> Copy | subprocess.Popen[bytes]:
    """Starts the words, as a copy of a server where there is one, else as subprocess.Popen does.

    Streams are open files or subprocess.DEVNULL; the files `keep` stay open in what is started. `how` goes to Popen.
    """
    words = [str(word) for word in words]
    environment = dict(os.environ if environment is None else environment)
    with open(os.devnull, "r+b") as nothing:
        streams = [nothing.fileno(), *(nothing.fileno() if isinstance(one, int) else one.fileno() for one in (stdout, stderr))]
        sys.stdout.flush()
        copy = ask(words, streams, environment, folder, keep)
    return copy or subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=stdout, stderr=stderr, env=environment, cwd=folder,
                                    pass_fds=keep, **how)


def run(words: Sequence[str], environment: Mapping[str, str] | None = None, folder: str = ".",
        merged: bool = False) -> subprocess.CompletedProcess[str]:
    """Starts the words, waits for their end and returns status, stdout and stderr.

    `merged`: what goes to stderr is in stdout, where it belongs. Who is interrupted meanwhile asks for the end, and
    waits for it.
    """
    with tempfile.TemporaryFile() as stdout, tempfile.TemporaryFile() as own:
        stderr = stdout if merged else own
        process = popen(words, stdout, stderr, environment, folder)
        try:
            process.wait()
        except BaseException:
            process.send_signal(signal.SIGTERM)
            process.wait()
            raise
        for file in (stdout, own):
            file.seek(0)
        texts = [file.read().decode(errors="replace") for file in (stdout, own)]
    return subprocess.CompletedProcess(words, int(process.returncode or 0), *texts)
