#!/bin/bash
# Disassembles what a Release build made: the base level may hold no instruction that only a higher level has (the first
# one that an older CPU meets ends the program), and the library of a level must hold its own.
#   tests/levels/run.sh OBJDUMP BUILD-FOLDER LEVEL...
set -euo pipefail
objdump=$1 build=$2
shift 2

# AVX and later: every mnemonic with a v before an operand in a vector register, and BMI2's.
avx='^[^;<]*\s(v[a-z0-9]+\s[^<]*%[xyz]mm|(mulx|pdep|pext|rorx|sarx|shlx|shrx|andn)[lq]?\s)'
# The loops by which `flipbook bench` finds the peak of the processor ask it first what it has.
lines() {
  "$objdump" -d --no-show-raw-insn "$1" | awk '/^[0-9a-f]+ <.*>:$/ {asks = /avx(2|512)_chains/} !asks' | grep -cE "$avx" || true
}

rc=0
for f in "$build/flipbook" "$build"/lib/*.so; do
  n=$(lines "$f")
  [ "$n" -eq 0 ] || { echo "$f has $n instructions above the base level" >&2; rc=1; }
done
for level in "$@"; do
  f=$build/lib/glibc-hwcaps/$level/libflipbook_sim.so
  n=$(lines "$f")
  [ "$n" -ge 1000 ] || { echo "$f has only $n instructions of $level" >&2; rc=1; }
done
exit "$rc"
