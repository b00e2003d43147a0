# SPDX-License-Identifier: LGPL-2.1-or-later
# Shared by ./run, ./check and ./study: install what is missing, configure, build. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

export LC_ALL=C.UTF-8
# OpenMPI refuses root and more ranks than cores unless told otherwise.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe # what the last of them is to OpenMPI 5

# The packages of packaging/packages.txt, an array for each use: build_packages, check_packages, ...
# A deal.II of one's own is found through DEAL_II_DIR.
while read -r use name _; do
  [[ -z $name || $use == "#"* || $name == libdeal.ii-dev && -n ${DEAL_II_DIR:-} ]] ||
    declare -ga "${use}_packages+=($name)"
done <"$root/packaging/packages.txt"
[[ ${CXX:-} != *clang++* ]] || build_packages+=(clang)

say() { printf '== %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# install_packages NAME...: those that are not there yet, with apt-get, as root or through sudo.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: taking it that these are installed: $*"
    return
  fi
  local installed missing=() name
  installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
  for name in "$@"; do
    grep -qxF "installed $name" <<<"$installed" || missing+=("$name")
  done
  ((${#missing[@]})) || return 0

  local as_root=() by_hand="apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      fail "these packages are missing and only root may install them. Run as root:
  $by_hand"
    as_root=(sudo)
    [[ -t 0 ]] || as_root+=(-n) # nobody is there to type a password
  fi
  say "installing ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300
    -o Acquire::Retries=3)
  # A machine of CI is thrown away: it need not wait until each file has reached the disk.
  [[ -z ${CI:-} ]] || apt+=(-o DPkg::Options::=--force-unsafe-io)
  "${apt[@]}" update </dev/null || say "the package lists are not all up to date; trying to go on"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null ||
    fail "the packages could not be installed (no network, or no right to?). Run as root:
  $by_hand"
}

# configure_build [CMAKE OPTION...]: in CI a compiler warning is an error.
configure_build() {
  cmake -G Ninja -S "$root" -B "$build" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    ${CI:+-DCHAINDRIVE_WARNINGS_AS_ERRORS=ON} "$@" >"$build/configure.log" 2>&1 ||
    { cat "$build/configure.log" >&2 && fail "CMake found something wrong (above)"; }
}

# build_targets TARGET...: silent when there is nothing to do.
build_targets() {
  # A compiler busy with deal.II's headers takes up to 1.5 GB.
  local jobs cores line said=
  cores=$(nproc)
  jobs=$(awk '/^MemAvailable/ { print int($2 / 1.5e6) }' /proc/meminfo)
  # ninja looks for new files first, so that a dry run (-n) does not tell whether there is work
  ninja -C "$build" -j "$((jobs < 1 ? 1 : jobs < cores ? jobs : cores))" "$@" | while IFS= read -r line; do
    case $line in
      "ninja: Entering directory"* | "ninja: no work to do." | *"Re-checking globbed directories..."*) continue ;;
    esac
    [[ $said ]] || say "building"
    said=yes
    printf '%s\n' "$line"
  done
}

# One build at a time in this folder, whoever else starts ./run or ./check meanwhile.
lock_build() {
  mkdir -p "$build"
  exec 9>"$build/lock"
  flock -n 9 || { say "waiting for another build in ${build#"$root"/}/" && flock 9; }
}

unlock_build() { exec 9>&-; }
