#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# ranks.sh PROGRAM FILE.prm: the same run on one and on two ranks must give the same summary but for
# its times, and bad input must end on two ranks with the same status as on one.
set -e
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
set -- "$1" "$2" --quiet --set "Time/End time in ms=1" --set "Output/Window start in ms=0" --set "Output/Window end in ms=auto"
program=$1
shift
"$program" "$@" --output one
mpirun -n 2 "$program" "$@" --output two
grep -v '"\(wall_seconds\|internal_force\|time_integration\|contact_algorithm\|output\|initiation_and_rest\|total\)"' one/summary.json > one.txt
grep -v '"\(wall_seconds\|internal_force\|time_integration\|contact_algorithm\|output\|initiation_and_rest\|total\)"' two/summary.json > two.txt
cmp one.txt two.txt
status=0
mpirun -n 2 "$program" nowhere.prm || status=$?
test "$status" -eq 2
