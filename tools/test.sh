#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds with warnings as errors and runs everything that is quick enough to run at each change.
source "$(dirname "$0")/lib.sh"
source "$(dirname "$0")/stages.sh"

# Each folder in a process of its own, because each has helpers of its own in a conftest.py. Those of
# the package take it with its extension, as the build left it.
python_tests() {
  local name report package
  for name in tools python cli reference package docs; do
    report=build/python-$name.xml
    package=$PWD/python
    if [[ $name == package ]]; then
      package=$PWD/build/developer/python
    fi
    suite "Python tests ($name)" "$report" \
      env PERCOLITH="$PWD/build/developer/bin/percolith" PYTHONPATH="$package" MPLBACKEND=Agg \
      .venv/bin/python -m pytest -q -p no:cacheprovider --durations=3 --durations-min=1 \
      --junitxml="$report" "tests/$name"
  done
}

fuzz_tests() {
  local source target targets=()
  for source in tests/fuzz/fuzz_*.cpp; do
    targets+=("$(basename "$source" .cpp)")
  done
  check "build of the fuzz targets" configure_and_build fuzz -- "${targets[@]}"
  for target in "${targets[@]}"; do
    if [[ -x build/fuzz/bin/$target ]]; then
      check "$target" tools/fuzz.sh "$target"
    fi
  done
}

tools/setup.sh build test docs
say "building with warnings as errors"
if ! configure_and_build developer; then
  failed=1
  failures=("build")
  conclude
  exit 1
fi
unit_tests developer
python_tests
check "documentation" env PERCOLITH_PACKAGE="$PWD/build/developer/python" tools/docs.sh
check "format" tools/format.sh
check "dependencies of the rooms" .venv/bin/python tools/check_rooms.py
check "licence lines" .venv/bin/python tools/check_sources.py licence
check "length of files" .venv/bin/python tools/check_sources.py length
check "nothing unfinished" .venv/bin/python tools/check_sources.py unfinished
check "no paths of one machine" .venv/bin/python tools/check_sources.py machine-paths
fuzz_tests
conclude
