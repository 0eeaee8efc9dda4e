#!/bin/bash
# Measures everything that README.md in this folder lists, and writes one CSV file for each workload, named after the machine:
#   tests/bench/run.sh MACHINE [FLIPBOOK]      MACHINE: a short name for the files; FLIPBOOK: the program
# Nothing else should run meanwhile. Takes up to an hour.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
machine=${1:?a short name of this machine, for the names of the files}
program=${2:-$here/../../build/release/flipbook}
bench() { # NAME ARGUMENTS...
  local name=$1
  shift
  "$program" bench "$@" --csv "$here/$machine-$name.csv"
}
bench W2 W2
bench T T
bench W3-64 W3-64 --scaling
bench W3-64-1e-4 W3-64 --set pressure.tolerance=1e-4
bench W3-128 W3-128
bench W3-128-1e-4 W3-128 --set pressure.tolerance=1e-4
bench double W2,W3-64 --precisions double
bench M3 M3 --scaling
bench pressure P-64,P-128,P-256
bench transfers transfers
bench pictures C4,D3
