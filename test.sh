#!/bin/bash
# Installs what is missing, builds, and runs every test.
#   ./test.sh [--no-install] [arguments of ctest, for example: -L property]
set -euo pipefail
cd "$(dirname "$0")"
. .ci/packages.sh
no_install=
if [ "${1:-}" = --no-install ]; then no_install=--no-install; shift; fi
need_packages $no_install build run test

cmake --preset release -DFLIPBOOK_TESTS=ON ${CI:+-DFLIPBOOK_WERROR=ON}
cmake --build --preset release
ctest --preset release -j "$(nproc)" "$@"
