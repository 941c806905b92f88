#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the Python package as users get it: the archive of the sources, from that the wheel, and that
# installed where nothing of the sources can be found; then a case is run there in both ways, and a page
# of it is made. Takes as long as building the library. The archive and the wheel are left in
# build/package.
source "$(dirname "$0")/lib.sh"

tools/setup.sh build test
rm -rf build/package
mkdir -p build/package
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
/usr/bin/python3 -m venv "$scratch/build"
"$scratch/build/bin/python" -m pip install -q --disable-pip-version-check build==1.6.1
say "the archive and the wheel"
CMAKE_BUILD_PARALLEL_LEVEL=$(jobs) "$scratch/build/bin/python" -m build --outdir build/package .
say "the wheel by itself"
/usr/bin/python3 -m venv "$scratch/venv"
"$scratch/venv/bin/python" -m pip install -q --disable-pip-version-check build/package/*.whl
cd "$scratch"
cat >check.py <<'CHECK'
import percolith

case = percolith.Case.load("strip/case.toml")
case["time.end"] = "1 ms"
case["output.times"] = []
print(percolith.__version__, case.run("python").summary["state_hash"])
CHECK
"$scratch/venv/bin/percolith" new strip
"$scratch/venv/bin/python" check.py
"$scratch/venv/bin/percolith" run strip/case.toml --output program --quiet \
  --set "time.end=1 ms" --set "output.times=[]"
"$scratch/venv/bin/percolith" plot program
"$scratch/venv/bin/percolith" report program
grep -q '<canvas id="view-canvas"' program/report.html
cmp python/history.csv program/history.csv
