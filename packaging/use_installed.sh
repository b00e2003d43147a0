#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# What try_in does on the bare system, as root, with the packages in /packages.
set -euo pipefail
cd /packages

fail() {
  printf 'try_in: %s\n' "$*" >&2
  exit 1
}

# install DEB...: with what they depend on, and nothing else.
install() {
  local before after
  before=$(dpkg-query -f '${Package}\n' -W | wc -l)
  apt-get -qq -o DPkg::Options::=--force-unsafe-io install --no-install-recommends "${@/#/./}" </dev/null >install.log 2>&1 ||
    { tail -n 30 install.log >&2 && fail "$* cannot be installed"; }
  after=$(dpkg-query -f '${Package}\n' -W | wc -l)
  echo "$* brought $((after - before)) packages; $(du -xsh --exclude=/proc --exclude=/dev / | cut -f1) on disk"
}

# as_user COMMAND: in a shell, in the folder of a user.
as_user() { su - user -c "$1" </dev/null; }

# refuses STATUS REGEX COMMAND: the user's command ends with that status and such a text.
refuses() {
  local said status=0
  said=$(as_user "$3" 2>&1) || status=$?
  ((status == $1)) || fail "'$3' ended with $status instead of $1: $said"
  grep -qE -- "$2" <<<"$said" || fail "'$3' says: $said"
  ! grep -E '\./run|\./study|Traceback' <<<"$said" >&2 || fail "'$3' says what no user of a package knows"
  echo "$said" | tail -n 1
}

apt-get -qq update
useradd --create-home --shell /bin/bash user
drives=/usr/share/chaindrive/prm
short='--set "Time/End time in ms=2" --set "Output/Window start in ms=0"'
apt_install='apt install --no-install-recommends'

echo "== the program alone"
install chaindrive_*.deb
chaindrive --version | grep '^chaindrive '
as_user "chaindrive plan $drives/paper/simple.prm" | grep -A 3 '^Drive'
as_user "chaindrive $drives/paper/simple.prm $short --output simple --quiet 2>warnings.txt"
as_user "chaindrive plan $drives/paper/imported-sprocket.prm >imported.txt"
as_user "chaindrive template --chain 10B --teeth 21/63 --centre 500 --rpm 1450 --kW 3 >my.prm && chaindrive plan my.prm >my.txt"
as_user "mpirun --oversubscribe -n 2 chaindrive $drives/paper/simple.prm $short --output two --quiet 2>warnings.txt"
as_user "grep -q '\"steps\"' simple/summary.json two/summary.json"
# root is refused by OpenMPI alone
! mpirun -n 1 chaindrive --version >refused.txt 2>&1 || fail "mpirun takes root: README.md says otherwise"
grep -q allow-run-as-root refused.txt
mpirun --allow-run-as-root -n 1 chaindrive --version >/dev/null
refuses 2 "^chaindrive: A report needs .*: $apt_install python3-h5py python3-numpy python3-pandas\$" "chaindrive report simple"
refuses 3 "^chaindrive: Snakemake, .* is not installed.*: $apt_install .*snakemake" "chaindrive study $drives/studies/step.prm --quick"
refuses 0 "$apt_install python3-h5py" "chaindrive $drives/paper/simple.prm $short --output reported --report"
mv /usr/share/chaindrive/python /usr/share/chaindrive/aside
refuses 2 "no folder /usr/share/chaindrive/python, " "chaindrive report simple"
mv /usr/share/chaindrive/aside /usr/share/chaindrive/python

echo "== plug-ins"
install chaindrive-dev_*.deb
as_user "cp -r /usr/share/doc/chaindrive/doc/plugin-example . && cmake -S plugin-example -B plugin && cmake --build plugin" >plugin.log
as_user "chaindrive plan plugin-example/example.prm --plugin plugin/example.so" | grep '^Plug-in example'

echo "== reports"
install chaindrive-report_*.deb
as_user "chaindrive report simple two --output page.html && grep -c plotly.js page.html"
as_user "chaindrive $drives/paper/simple.prm $short --output reported --report --quiet 2>warnings.txt && test ! -e reported/report.html"
as_user "chaindrive $drives/paper/simple.prm $short --output reported --report >said.txt 2>&1 && test -s reported/report.html"

echo "== studies"
install chaindrive-study_*.deb
as_user "cat >two.prm <<'TEXT'
include $drives/paper/simple.prm
subsection Time
  set End time in ms = 2
end
subsection Output
  set Window start in ms = 0
end
subsection Contact
  set Friction coefficient = {0|0.1}
end
subsection Study
  set Phases = 1
  set Ranks  = {{1|2}}
end
TEXT
chaindrive study two.prm --output study --quiet 2>warnings.txt && test -s study/study.html"
as_user "cut -d , -f 1-4 study/table.csv"

echo "== removed"
apt-get -qq purge 'chaindrive*' </dev/null >install.log 2>&1 || { cat install.log >&2 && fail "cannot be removed"; }
left=$(find /usr /etc /opt -name '*chaindrive*')
[[ ! $left ]] || fail "left behind: $left"
echo "all is well"
