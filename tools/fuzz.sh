#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# fuzz.sh TARGET: feeds a fuzz target the mutations of its seeds, the same ones every time. What
# makes it fail is kept in build/fuzz/findings; give that file to the program to see it again.
source "$(dirname "$0")/lib.sh"

target=$1
seeds=tests/fuzz/corpus_${target#fuzz_}
grown=build/fuzz/grown/$target
findings=build/fuzz/findings
rm -rf "$grown"
mkdir -p "$grown" "$findings"
log=build/fuzz/$target.log
if ! OMP_NUM_THREADS=1 "build/fuzz/bin/$target" -seed=1 -runs="${FUZZ_RUNS:-20000}" \
  -max_total_time="${FUZZ_SECONDS:-40}" -timeout=10 -rss_limit_mb=3000 -print_final_stats=1 \
  -artifact_prefix="$findings/$target-" "$grown" "$seeds" >"$log" 2>&1; then
  tail -n 60 "$log"
  exit 1
fi
grep -E 'number_of_executed_units|peak_rss_mb' "$log"
