#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The slow checks: clang-tidy, shellcheck, the unit tests under the sanitizers.
source "$(dirname "$0")/lib.sh"
source "$(dirname "$0")/stages.sh"

tools/setup.sh build test check
suite "clang-tidy sees mistakes" build/lint.xml \
  .venv/bin/python -m pytest -q -p no:cacheprovider --junitxml=build/lint.xml tests/lint
check "clang-tidy" tools/lint.sh
check "shellcheck" shellcheck tools/*.sh .ci/run
say "building with the address and undefined-behaviour sanitizers"
if configure_and_build sanitize; then
  unit_tests sanitize
else
  failed=$((failed + 1))
  failures+=("build with sanitizers")
fi
conclude
