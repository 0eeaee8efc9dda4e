#!/bin/bash
# Applies each small wrong change in tests/mutants/*.patch to a scratch copy of the sources and demands that the tests named
# in its first lines catch it. A mutant that does not build, or that no test notices, is an error.
#   tests/mutants/run.sh [NAME...]        without names: all of them
# A patch begins with:  Caught-by: <test program, without test_> <googletest filter>
set -euo pipefail
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/tests/mutants/scratch.sh"
make_scratch "$top" # leaves us in the copy

names=("$@")
if [ ${#names[@]} -eq 0 ]; then
  for p in "$top"/tests/mutants/*.patch; do names+=("$(basename "$p" .patch)"); done
fi

survived=0
for name in "${names[@]}"; do
  patch_file=$top/tests/mutants/$name.patch
  read -r _ program filter < <(grep -m1 '^Caught-by:' "$patch_file")
  patch -s -p1 <"$patch_file"
  verdict=caught
  if ! cmake --build ../build --target "test_$program" >../build.log 2>&1; then
    verdict="DOES NOT BUILD (see build/mutants/build.log)"
  elif "../build/tests/$program/test_$program" --gtest_filter="$filter" --gtest_brief=1 >../test.log 2>&1; then
    verdict=SURVIVED
  fi
  patch -s -R -p1 <"$patch_file"
  printf '%-36s %-14s %s\n' "$name" "$program" "$verdict"
  [ "$verdict" = caught ] || survived=$((survived + 1))
done
echo "$((${#names[@]} - survived)) of ${#names[@]} mutants caught"
[ "$survived" -eq 0 ]
