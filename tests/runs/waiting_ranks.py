# SPDX-License-Identifier: LGPL-2.1-or-later
"""waiting_ranks.py: what scripts/rank_times.py makes of the calls of two ranks, in cases that are told by hand."""
import math

import rank_times as times
from program import check

SUM = (times.EXCHANGE, 1)
RECORDS = 2  # a tag


def close(found, expected, what):
    check(math.isclose(found, expected, rel_tol=1e-12), f"{what}: {found} instead of {expected}")


def sums():
    """Of each step the longer part counts, and the other rank waits for the rest."""
    first, second = times.replay([(1.0, *SUM), (4.0, *SUM)], [(3.0, *SUM), (2.0, *SUM)])
    close(first.time, 7.0 + 2 * times.LATENCY, "two steps")
    close(first.waited[times.EXCHANGE], 2.0, "the first rank waits")
    close(second.waited[times.EXCHANGE], 2.0, "the second rank waits")


def messages():
    """The first rank waits for a message, the second one does not; what has been sent is there."""
    first = [(1.0, times.RECEIVE, RECORDS), (1.0, *SUM), (1.0, times.RECEIVE, RECORDS), (0.5, *SUM)]
    second = [(2.0, times.SEND, RECORDS), (0.5, times.SEND, RECORDS), (2.0, *SUM), (0.0, *SUM)]
    first, second = times.replay(first, second)
    close(first.waited[times.RECEIVE], 1.0, "for messages")
    close(first.waited[times.EXCHANGE], 1.5, "for the sum")
    close(second.waited[times.EXCHANGE], 1.5, "of the second rank for the sum")
    close(second.time, 6.0 + 2 * times.LATENCY, "with messages")


def part():
    """The start has two sums, what follows the last one is the end."""
    calls = [(float(i), *SUM) for i in range(5)] + [(9.0, times.END, 0)]
    check([times.busy(of) for of in times.parts(calls)] == [3.0, 7.0, 9.0], "the parts of a run")


sums()
messages()
part()
