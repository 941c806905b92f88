#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Leaves the program at build/release/bin/percolith.
source "$(dirname "$0")/lib.sh"

tools/setup.sh build
say "building the program"
configure_and_build release -DPERCOLITH_TESTS=OFF
echo "the program: build/release/bin/percolith"
