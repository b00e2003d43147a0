#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# refuses.sh STATUS TEXT COMMAND...: the command must end with STATUS and say TEXT, an extended
# regular expression, in a message that begins with "chaindrive: "; signals count as other statuses.
status=$1 text=$2
shift 2
said=$("$@" 2>&1)
got=$?
echo "$said"
[ "$got" -eq "$status" ] || { echo "exit status $got instead of $status"; exit 1; }
echo "$said" | grep -q '^chaindrive: ' || { echo "no message of the program"; exit 1; }
echo "$said" | tr '\n' ' ' | grep -Eq "$text" || { echo "the message does not say: $text"; exit 1; }
! echo "$said" | grep -Eqi 'exception|deal\.ii|assert|HDF5-DIAG' || { echo "the message is not for users"; exit 1; }
