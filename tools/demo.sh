#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the pressurised well, in which fluid splits rock, and draws it, animations included; earlier
# results of the demo are renewed.
source "$(dirname "$0")/lib.sh"

results=build/demo/pressurised_well
percolith=build/release/bin/percolith
tools/build.sh
say "running examples/pressurised_well"
mkdir -p build/demo
"$percolith" run examples/pressurised_well/case.toml --output "$results" --force \
  --threads "$(nproc)"
say "drawing"
"$percolith" plot "$results"
say "animating the pressure and the stress"
"$percolith" plot "$results" --animate
"$percolith" plot "$results" --animate --field principal_stress_1
say "one page of all of it"
"$percolith" report "$results"
say "done"
echo "the page: $results/report.html, for a browser"
echo "results: $results (open its .pvd files in ParaView)"
echo "pictures; look at pressure.png first:"
find "$results" -name '*.png' | sort | sed 's/^/  /'
echo "animations:"
find "$results" -name '*.gif' | sort | sed 's/^/  /'
