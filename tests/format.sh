#!/usr/bin/env bash
# Every source file stands as .clang-format wants it; prints the first lines that do not.
set -euo pipefail
cd "$(dirname "$0")/.."
find base analyzer player tests bench \( -name '*.cpp' -o -name '*.hpp' \) -print0 |
    xargs -0 clang-format --dry-run -Werror --ferror-limit=5
