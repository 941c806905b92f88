#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds with warnings as errors and runs everything that is quick enough to run at each change.
source "$(dirname "$0")/lib.sh"
source "$(dirname "$0")/stages.sh"

python_tests() {
  local folders=() folder
  for folder in tests/tools tests/python tests/cli tests/reference; do
    if compgen -G "$folder/test_*.py" >/dev/null; then
      folders+=("$folder")
    fi
  done
  suite "Python tests" build/python.xml \
    env PERCOLITH="$PWD/build/developer/bin/percolith" PYTHONPATH="$PWD/python" MPLBACKEND=Agg \
    .venv/bin/python -m pytest -q -p no:cacheprovider --durations=5 \
    --junitxml=build/python.xml "${folders[@]}"
}

fuzz_tests() {
  local source target
  check "build of the fuzz targets" configure_and_build fuzz
  for source in tests/fuzz/fuzz_*.cpp; do
    target=$(basename "$source" .cpp)
    if [[ -x build/fuzz/bin/$target ]]; then
      check "$target" tools/fuzz.sh "$target"
    fi
  done
}

tools/setup.sh build test
say "building with warnings as errors"
if ! configure_and_build developer; then
  failed=1
  failures=("build")
  conclude
  exit 1
fi
unit_tests developer
python_tests
check "format" tools/format.sh
check "dependencies of the rooms" .venv/bin/python tools/check_rooms.py
check "licence lines" .venv/bin/python tools/check_sources.py licence
check "length of files" .venv/bin/python tools/check_sources.py length
check "nothing unfinished" .venv/bin/python tools/check_sources.py unfinished
check "no paths of one machine" .venv/bin/python tools/check_sources.py machine-paths
fuzz_tests
conclude
