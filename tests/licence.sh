#!/usr/bin/env bash
# Every file of the tree has a licence that is there (reuse lint), and packaging/debian/copyright names the same ones.
set -euo pipefail
cd "$(dirname "$0")/.."
reuse lint
stated() { sed -n 's/^License: //p' "$1" | sort -u; }
diff <(stated .reuse/dep5) <(stated packaging/debian/copyright)
cmp LICENSE LICENSES/Apache-2.0.txt
