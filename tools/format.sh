#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compares the C++ sources with .clang-format; --fix rewrites them.
source "$(dirname "$0")/lib.sh"

mode=(--dry-run -Werror)
if [[ ${1-} == --fix ]]; then
  mode=(-i)
fi
git ls-files -z --cached --others --exclude-standard -- '*.cpp' '*.hpp' |
  while IFS= read -r -d '' file; do
    if [[ -e $file ]]; then
      printf '%s\0' "$file"
    fi
  done | xargs -0 -r clang-format "${mode[@]}"
