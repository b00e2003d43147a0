#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# same_on_ranks.sh PROGRAM FILE.prm OPTION...: a hundred steps of elastic bodies, or more, with the
# driver at full speed after the first twenty, must give the same energies on one, two and four ranks
# to 1e-10, and every rank must leave its piece of the pictures.
set -e
program=$1 file=$2
shift 2
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
for n in 1 2 4; do
  mpirun -n $n "$program" "$file" --quiet --output ranks$n --set "Loads/Ramp time in ms=0.002" \
    --set "Time/End time in ms=0.0095" --set "Output/Window start in ms=0" --set "Output/History interval in us=1" "$@"
  # what is zero but for round-off is left out
  grep -E '"(drive_work|kinetic|strain|hourglass|contact|friction_loss|contact_damping_loss|stable_step|plate faces)"' \
    ranks$n/summary.json | tr -d , >ranks$n.txt
  ! grep '"plate faces": 0.0' ranks$n.txt # where plates may touch, they do
done
for n in 2 4; do
  numdiff -q -r 1e-10 ranks1.txt ranks$n.txt
  test "$(ls ranks$n/fields/bodies_000000.*.vtu | wc -l)" -eq $n
done
