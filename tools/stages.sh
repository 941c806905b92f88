# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced after lib.sh by the test scripts: every stage runs even if an earlier one failed, and
# the last line sums all of them.
passed=0
failed=0
skipped=0
failures=()

# check NAME COMMAND...: a stage that counts as one test.
check() {
  local name=$1
  shift
  say "$name"
  if "$@"; then
    passed=$((passed + 1))
    echo "passed: $name"
  else
    failed=$((failed + 1))
    failures+=("$name")
    echo "FAILED: $name"
  fi
}

# suite NAME REPORT COMMAND...: a stage whose tests are counted in the JUnit file REPORT.
suite() {
  local name=$1 report=$2 status=0 suite_passed suite_failed suite_skipped
  shift 2
  say "$name"
  rm -f "$report"
  "$@" || status=$?
  read -r suite_passed suite_failed suite_skipped < <(.venv/bin/python tools/tally.py "$report")
  if ((status != 0 && suite_failed == 0)); then
    suite_failed=1
  fi
  passed=$((passed + suite_passed))
  failed=$((failed + suite_failed))
  skipped=$((skipped + suite_skipped))
  if ((suite_failed > 0)); then
    failures+=("$name")
  fi
}

# run_ctest PRESET: shows the tests that failed, and the closing line.
run_ctest() {
  local log=build/$1-unit.log status=0
  ctest --test-dir "build/$1" -j "$(nproc)" --timeout 300 --no-tests=error --output-on-failure \
    --output-junit "$PWD/build/$1-unit.xml" >"$log" 2>&1 || status=$?
  if ((status != 0)); then
    grep -vE '^ *Start +[0-9]+:|[. ]Passed +[0-9.]+ sec' "$log" || true
  else
    grep 'tests passed' "$log"
  fi
  return "$status"
}

unit_tests() {
  suite "unit tests ($1)" "build/$1-unit.xml" run_ctest "$1"
}

# Prints the sums and gives the exit code.
conclude() {
  say "summary"
  local failure
  for failure in "${failures[@]}"; do
    echo "FAILED: $failure"
  done
  if ((skipped > 0)); then
    echo "$skipped skipped"
  fi
  echo "$passed passed, $failed failed"
  ((failed == 0))
}
