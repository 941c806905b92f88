#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# setup.sh SET...: installs what the sets of tools/packages/ name and the machine lacks, and makes
# .venv from the locked lists of Python packages. Does nothing, and needs neither root nor network,
# where all of it is there already.
source "$(dirname "$0")/lib.sh"

# The system's own Python: one found elsewhere on the PATH may miss Debian's modules or change.
system_python=/usr/bin/python3

wanted_packages() {
  local set
  for set in "$@"; do
    grep -hv -e '^#' -e '^$' "tools/packages/$set.txt"
  done | sort -u
}

missing_packages() {
  local package
  for package in "$@"; do
    if [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
      echo "$package"
    fi
  done
}

install_packages() {
  local as_root=() apt=(apt-get -o DPkg::Lock::Timeout=600)
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null || ! { sudo -n true 2>/dev/null || [[ -t 0 ]]; }; then
      as_root=(false)
    else
      as_root=(sudo)
    fi
  fi
  echo "installing: $*"
  if ! "${as_root[@]}" true; then
    tell_what_to_run "$@"
  fi
  # Lists that cannot be renewed may still be good enough; the installation decides.
  "${as_root[@]}" "${apt[@]}" -q update || echo "the package lists could not all be renewed" >&2
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    "${apt[@]}" -q -y --no-install-recommends install "$@"; then
    tell_what_to_run "$@"
  fi
}

tell_what_to_run() {
  cat >&2 <<MESSAGE
error: these packages could not be installed: $*
Run this line as root, then repeat the command:
  apt-get update && apt-get install -y --no-install-recommends $*
MESSAGE
  exit 1
}

# install_python NAME: brings .venv to the state of tools/NAME.txt.
install_python() {
  local lock=tools/$1.txt stamp=.venv/$1.stamp state
  state=$({ "$system_python" --version && cat "$lock"; } | sha256sum)
  if [[ -e $stamp && $(<"$stamp") == "$state" ]]; then
    return
  fi
  echo "installing the Python packages of $lock into .venv"
  if [[ $1 == requirements || ! -x .venv/bin/python ]]; then
    "$system_python" -m venv --clear .venv
  fi
  .venv/bin/python -m pip install -q --disable-pip-version-check --no-input --only-binary :all: \
    --require-hashes -r "$lock"
  echo "$state" >"$stamp"
}

main() {
  local packages missing set
  mapfile -t packages < <(wanted_packages "$@")
  mapfile -t missing < <(missing_packages "${packages[@]}")
  if ((${#missing[@]} > 0)); then
    install_packages "${missing[@]}"
  fi
  install_python requirements
  for set in "$@"; do
    if [[ $set == test || $set == verify ]]; then
      install_python requirements-test
    elif [[ $set == docs ]]; then
      install_python requirements-docs
    fi
  done
}

# Two commands started at once must not build the same .venv.
mkdir -p build
exec 9>build/setup.lock
flock 9
main "$@"
