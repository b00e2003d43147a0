#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# full_disk.sh PROGRAM FILE.prm: a disk that fills up, played by a limit on the size of files. The
# program must say so, end with its own status, and leave the files that were complete.
here=$(dirname "$0")
rm -rf full
ulimit -f 200
"$here/refuses.sh" 3 'histories.*(space|large|full|limit)' "$1" "$2" --quiet --output full \
  --set "Output/Field interval in ms=0" || exit 1
test -s full/parameters.prm && test -s full/input.prm
