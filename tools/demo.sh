#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the six-fracture example and draws it; earlier results of the demo are renewed.
source "$(dirname "$0")/lib.sh"

results=build/demo/six_fractures
tools/build.sh
say "running examples/six_fractures"
mkdir -p build/demo
build/release/bin/percolith run examples/six_fractures/case.toml --output "$results" --force \
  --threads "$(nproc)"
say "drawing"
build/release/bin/percolith plot "$results"
say "done"
echo "results: $results (open its .pvd files in ParaView)"
echo "pictures:"
find "$results" -name '*.png' | sort | sed 's/^/  /'
