#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# verify.sh [CASE]: compares with the references, all or one; writes build/verify.
source "$(dirname "$0")/lib.sh"

tools/setup.sh build verify
say "building the program"
configure_and_build release -DPERCOLITH_TESTS=OFF
say "comparing with the references"
PERCOLITH="$PWD/build/release/bin/percolith" PYTHONPATH="$PWD/python" MPLBACKEND=Agg \
  .venv/bin/python verification/run.py "$@"
