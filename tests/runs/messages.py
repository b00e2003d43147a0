# SPDX-License-Identifier: LGPL-2.1-or-later
"""messages.py PROGRAM: what four ranks send each other in a step of a small elastic drive. To any other rank go
at most one message with nodes, one with the forces on them, and to the first rank one with contact records if
these are looked at, and at samples one for each of four sums; all ranks meet in one sum. With the flanks of all teeth 768 kB would travel.
"""
import sys
import tempfile

import count_messages
from program import check
from small_drives import ELASTIC

PROGRAM = sys.argv[1]
RANKS = 4
MOST = 650e3  # bytes


def main():
    with tempfile.TemporaryDirectory() as folder:
        library = count_messages.counter(folder)
        for quantities, of_records in (("all", 1), ("energy", 0)):
            at_samples = 4 / 20 * of_records  # a sample every 20 steps
            entries = {**ELASTIC, "Output/Quantities": quantities}
            file = "prm/verification/hard.prm"
            counted = count_messages.per_step(library, file, entries, RANKS, (20, 60), PROGRAM)
            sent, received, together = counted
            total = sum(size for _, size in sent.values())
            print(f"{quantities}: sent {sent}, received {received}, together {together}")
            check(total > 0, "nothing is sent")
            for rank, (messages, _) in sent.items():
                most = 2 * (RANKS - 1) + (of_records + at_samples if rank > 0 else 0)
                check(messages < most + 1e-9, f"{quantities}: rank {rank} sends {messages} messages a step, more than {most}")
            messages, _ = received[0]
            most = (2 + of_records + at_samples) * (RANKS - 1)
            check(messages < most + 1e-9, f"{quantities}: the first rank gets {messages} messages, more than {most}")
            check(total < MOST, f"{quantities}: {total} bytes are sent a step, not less than {MOST}")
            sums, _ = together["Allreduce"]
            check(sums < 1.01, f"{quantities}: {sums} sums a step")


main()
