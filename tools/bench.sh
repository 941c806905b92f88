#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the benchmarks, with hypre where it is installed, and runs them; writes build/bench.
source "$(dirname "$0")/lib.sh"

hypre=OFF
if [[ -e /usr/include/hypre/HYPRE.h ]]; then
  hypre=ON
fi
tools/setup.sh build bench
say "building the benchmarks (hypre $hypre)"
configure_and_build bench -DPERCOLITH_HYPRE=$hypre
say "measuring"
.venv/bin/python bench/run.py
