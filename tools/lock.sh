#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Pins the newest Python packages that tools/*.in admit, with the hashes of every file.
source "$(dirname "$0")/lib.sh"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
/usr/bin/python3 -m venv "$scratch/venv"
"$scratch/venv/bin/python" -m pip install -q pip-tools
cd tools
for name in requirements requirements-test requirements-docs; do
  CUSTOM_COMPILE_COMMAND="make lock" "$scratch/venv/bin/pip-compile" --quiet --upgrade \
    --generate-hashes --strip-extras --no-annotate --no-emit-options --no-emit-index-url \
    --no-emit-trusted-host --no-emit-find-links --output-file "$name.txt" "$name.in"
done
