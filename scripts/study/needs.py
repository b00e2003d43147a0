# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run of a study is given on a cluster, from what its check has estimated (`estimate` of a variant in study.json: CPU
time [s] and memory [bytes] of one process). Too much waits a little longer in the queue, too little kills a run."""
import math

MARGIN = 1.5  # on memory: runs take up to 1.07 times what is predicted (doc/performance.md), others keep more of it
RANK = 250.  # MB of each further rank: of the full and reduced models each takes 190 to 235 MB
LEAST_MB = 500  # a run of any model takes 190 MB at least

SLOWER = 2.  # nodes may be slower than the machine of the estimate, and their cores shared
LEAST_MINUTES = 10  # a node may have to load programs from a busy file system first


def memory_mb(estimate, ranks, attempt=1):
    """Megabytes; twice as much for each attempt after the first."""
    needed = MARGIN * (1e-6 * _of(estimate, "memory") + RANK * (ranks - 1))
    return 2 ** (attempt - 1) * max(LEAST_MB, math.ceil(needed))


def minutes(estimate, attempt=1):
    """Of any number of ranks: on a coarse mesh two gain a fifth, and lumped and rigid models are computed by one of them."""
    return attempt * max(LEAST_MINUTES, math.ceil(SLOWER * _of(estimate, "cpu") / 60.))


def _of(estimate, name):
    value = estimate.get(name) if isinstance(estimate, dict) else None
    return float(value) if isinstance(value, (int, float)) and math.isfinite(value) and value > 0 else 0.
