#!/bin/sh
# Every script of packaging/ and link/ can be parsed, and shellcheck, where it is there, finds nothing in it.
set -eu
cd "$(dirname "$0")/../.."
scripts=$(grep -rlE '^#!/(bin/sh|usr/bin/env bash)' packaging link | sort)
for script in $scripts; do
    case $(head -n 1 "$script") in
    *bash) bash -n "$script" ;;
    *) sh -n "$script" ;;
    esac
done
# shellcheck disable=SC2086 # names without spaces, each a word
if command -v shellcheck >/dev/null; then shellcheck $scripts; fi
# Whoever has a copy of the tree without the right to execute finds out here and not on the appliance.
for script in $scripts; do
    case $script in *.prerm | *.postrm | *.postinst | *.preinst) continue ;; esac
    [ -x "$script" ] || { echo "$script cannot be executed"; exit 1; }
done
