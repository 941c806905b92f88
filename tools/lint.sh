#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Reads all sources with clang-tidy, those of a room several at a time: most of its time goes into
# the headers they share. Two checks look at nothing that is included, so the sources that have
# what these checks are about are read once more, one by one, by them alone.
source "$(dirname "$0")/lib.sh"

# tidy PRESET [argument of run-clang-tidy...]
tidy() {
  local preset=$1 log=build/$1/clang-tidy.log errors=build/$1/clang-tidy-errors.log
  shift
  configure_and_build "$preset" -- percolith_version >/dev/null
  if ! run-clang-tidy -quiet -p "build/$preset" -j "$(jobs)" "$@" >"$log" 2>"$errors"; then
    grep -E '(warning|error):' -A 4 "$log" || cat "$errors"
    return 1
  fi
}

status=0
tidy lint || status=1
declarations='^ *(using +[A-Za-z0-9_:]+::[A-Za-z0-9_]+ *;|namespace +[A-Za-z0-9_]+ *=)'
mapfile -t sources < <(grep -rlE --include='*.cpp' "$declarations" src/percolith)
if ((${#sources[@]} > 0)); then
  tidy lint-single '-checks=-*,misc-unused-alias-decls,misc-unused-using-decls' \
    "${sources[@]/%/\$}" || status=1
fi
exit "$status"
