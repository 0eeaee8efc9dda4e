#!/bin/bash
# Installs what is missing, builds, and renders the main comparison video.
#   ./demo.sh [--no-install] [arguments of `flipbook render`, for example: --duration 1 -o demo.mp4]
set -euo pipefail
cd "$(dirname "$0")"
. .ci/packages.sh
no_install=
if [ "${1:-}" = --no-install ]; then no_install=--no-install; shift; fi
need_packages $no_install build run

[ -f build/release/build.ninja ] || cmake --preset release -DFLIPBOOK_TESTS=OFF >build-configure.log 2>&1 || {
  cat build-configure.log >&2; exit 1; }
rm -f build-configure.log
cmake --build --preset release --target flipbook
build/release/flipbook render assets/studies/dam_break.toml "$@"
