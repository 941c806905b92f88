#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The slow checks: clang-tidy, shellcheck, the unit tests under the sanitizers.
source "$(dirname "$0")/lib.sh"
source "$(dirname "$0")/stages.sh"

lint() {
  local log=build/lint/clang-tidy.log
  configure_and_build lint -- percolith_version >/dev/null
  if ! run-clang-tidy -quiet -p build/lint -j "$(jobs)" "$PWD/src/percolith/.*" \
    >"$log" 2>build/lint/clang-tidy-errors.log; then
    grep -E '(warning|error):' -A 4 "$log" || cat build/lint/clang-tidy-errors.log
    return 1
  fi
}

tools/setup.sh build test check
check "clang-tidy" lint
check "shellcheck" shellcheck tools/*.sh .ci/run
say "building with the address and undefined-behaviour sanitizers"
if configure_and_build sanitize; then
  unit_tests sanitize
else
  failed=$((failed + 1))
  failures+=("build with sanitizers")
fi
conclude
