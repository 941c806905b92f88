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
if [[ $# -eq 0 ]]; then
  say "opening the page in a browser"
  chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1200,28000 \
    --screenshot="$PWD/build/verify/page.png" "file://$PWD/build/verify/index.html" \
    2>build/verify/browser.log
  [[ $(stat -c %s build/verify/page.png) -gt 100000 ]] ||
    { echo "build/verify/page.png: the browser drew nothing; see build/verify/browser.log" >&2; exit 1; }
  echo "build/verify/page.png shows it as a picture"
  say "pages of runs in a browser"
  MPLBACKEND=Agg .venv/bin/python -m pytest -q -p no:cacheprovider tests/browser
fi
