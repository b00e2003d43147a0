#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# pipe.sh PROGRAM FILE: a run whose parameter file is a named pipe ends, and keeps what it has read.
set -eu
program=$1 file=$2
rm -rf pipe results
mkfifo pipe
timeout -k 5 30 cat "$file" >pipe &
timeout -k 5 60 "$program" pipe --quiet --output results --set "Time/End time in ms=0.1" \
  --set "Output/Window start in ms=0"
wait
cmp "$file" results/input.prm
