# SPDX-License-Identifier: LGPL-2.1-or-later
"""run_variant.py FOLDER RANKS PROGRAM [PLUGIN]...: one run of a study. It resumes from a checkpoint if there is
one of the same variant.prm, and writes result.json at its end, also after a failure: status, error (the sentence),
wall (s, of this call). Without result.json it ends with a nonzero status: it was stopped and has to be started again."""
import ctypes
import fcntl
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import served

RANKS = pathlib.Path(__file__).resolve().parents[1] / "ranks"
ENVIRONMENT = {**served.ENVIRONMENT, "GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"}
PR_SET_PDEATHSIG = 1


def end_with_parent():
    """The run writes a checkpoint and ends when this script is killed."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


def is_orphan(parent):
    return os.getppid() != parent


def run(folder, ranks, program, plugins):
    """Status and last words of chaindrive; the status is below zero when a signal ended it."""
    parent = os.getppid()
    # whoever worked here before may still be writing its checkpoint: the run has the lock, too
    lock = os.open(folder / "variant.lock", os.O_RDWR | os.O_CREAT)
    fcntl.flock(lock, fcntl.LOCK_EX)

    if (folder / "result.json").exists():  # Snakemake has removed that of earlier times: it was finished meanwhile
        sys.exit(0)

    given, before = folder / "variant.prm", folder / "input.prm"
    same = before.exists() and before.read_bytes() == given.read_bytes()
    words = [program, str(given), "--output", str(folder), "--quiet", *(["--resume", "auto"] if same else [])]
    for plugin in plugins:
        words += ["--plugin", plugin]
    if ranks > 1:
        words = [str(RANKS), str(ranks), *words]
    with open(folder / "errors.txt", "w+", encoding="utf-8", errors="replace") as errors:
        process = served.popen(words, subprocess.DEVNULL, errors, {**ENVIRONMENT, **os.environ}, keep=[lock],
                               preexec_fn=end_with_parent)
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(number, lambda *_: process.send_signal(signal.SIGTERM))
        asked = False
        while process.poll() is None:
            if is_orphan(parent) and not asked:
                process.send_signal(signal.SIGTERM)
                asked = True
            time.sleep(0.05)
        errors.seek(0)
        said = [line.strip() for line in errors.read().splitlines() if line.strip()]
    return process.returncode, said


def main():
    folder, ranks, program, plugins = pathlib.Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3], sys.argv[4:]
    start = time.time()
    status, said = run(folder, ranks, program, plugins)
    sentences = [line.removeprefix("chaindrive: ") for line in said if line.startswith("chaindrive: ")]
    if status not in (0, 2, 3):
        sys.exit(f"{folder}: not finished (status {status})\n" + "\n".join(said))
    result = {"status": status, "error": "" if status == 0 else " ".join(sentences or said[-1:]), "wall": time.time() - start}
    part = folder / "result.json.part"
    part.write_text(json.dumps(result, indent=1) + "\n")
    part.replace(folder / "result.json")


if __name__ == "__main__":
    main()
