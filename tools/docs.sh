#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the site of the documentation, build/docs/index.html; any warning is an error. The reference
# of the Python package is made from the package with its extension, in the folder that the variable
# PERCOLITH_PACKAGE names; without the variable the extension is built first.
source "$(dirname "$0")/lib.sh"

tools/setup.sh build docs
package=${PERCOLITH_PACKAGE:-}
if [[ -z $package ]]; then
  tools/setup.sh test
  say "building the Python extension"
  configure_and_build developer -- percolith_extension percolith_stub
  package=build/developer/python
fi
if ! compgen -G "$package/percolith/_core*.so" >/dev/null; then
  echo "error: $package holds no package percolith with its extension" >&2
  exit 1
fi
say "building the site"
rm -rf build/docs build/docs-source build/docs-cache
.venv/bin/python docs/site/staging.py build/docs-source
.venv/bin/python docs/figures/draw.py build/docs-source/figures
PYTHONPATH=$package MPLBACKEND=Agg .venv/bin/python -m sphinx -q -W --keep-going -b html \
  -c docs/site -d build/docs-cache build/docs-source build/docs
.venv/bin/python docs/site/offline.py build/docs
echo "the site: build/docs/index.html"
