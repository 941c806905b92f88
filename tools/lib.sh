# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by the scripts of this folder: strict mode, the repository root, shared helpers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Busy-waiting threads cost up to ten times the time where the processors are shared.
export OMP_WAIT_POLICY=passive

say() {
  printf '\n== %s\n' "$*"
}

# As many compilers at once as there are processors, but no more than memory has room for.
jobs() {
  local processors memory_kib by_memory
  processors=$(nproc)
  memory_kib=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  by_memory=$((memory_kib / 1250000))
  if ((by_memory < 1)); then
    by_memory=1
  fi
  echo $((processors < by_memory ? processors : by_memory))
}

# configure_and_build PRESET [cmake option...] [-- target...]
configure_and_build() {
  local preset=$1 options=() targets=() log
  shift
  while (($# > 0)) && [[ $1 != -- ]]; do
    options+=("$1")
    shift
  done
  if (($# > 1)); then
    targets=(--target "${@:2}")
  fi
  mkdir -p build
  log=build/configure-$preset.log
  if ! cmake --preset "$preset" "${options[@]}" >"$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
  cmake --build --preset "$preset" -j "$(jobs)" "${targets[@]}"
}
