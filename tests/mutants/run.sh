#!/bin/bash
# Applies each small wrong change in tests/mutants/*.patch to a scratch copy of the sources and demands that the test named
# in its first line catches it. A mutant that does not apply or build, or that the test does not notice, is an error; so is a
# test that fails, or does not exist, without any mutant.
#   tests/mutants/run.sh [--share K/N] [NAME...]        without names: all of them; --share: every N-th, from the K-th on
#   tests/mutants/run.sh --apply                        only: does every patch still apply to the sources as they are?
# A patch begins with:  Caught-by: <test program, without test_> <googletest filter>
set -euo pipefail
top=$(cd "$(dirname "$0")/../.." && pwd)
if [ "${1:-}" = --apply ]; then
  cd "$top"
  rc=0
  for p in tests/mutants/*.patch; do
    patch -s -f -p1 --dry-run <"$p" >/dev/null || { echo "$p does not apply" >&2; rc=1; }
  done
  exit "$rc"
fi

. "$top/tests/mutants/scratch.sh"
make_scratch "$top" # leaves us in the copy

share=0 shares=1
if [ "${1:-}" = --share ]; then
  share=${2%/*} shares=${2#*/}
  shift 2
fi
patches=()
for name in "${@:-*}"; do
  for p in "$top"/tests/mutants/$name.patch; do # the default is a pattern
    [ -f "$p" ] || { echo "there is no $p" >&2; exit 2; }
    patches+=("$p")
  done
done
chosen=()
for i in "${!patches[@]}"; do [ $((i % shares)) -ne $((share % shares)) ] || chosen+=("${patches[i]}"); done
patches=("${chosen[@]}")
caught_by() { grep -m1 '^Caught-by:' "$1" | cut -d' ' -f2-; }
build() { cmake --build ../build --target "$@" >../build.log 2>&1; }
passes() { # PROGRAM FILTER; a filter that no test answers to is no pass
  timeout 120 "../build/tests/$1/test_$1" --gtest_filter="$2" --gtest_brief=1 >../test.log 2>&1 &&
    grep -q '\[  PASSED  \] [1-9]' ../test.log
}

mapfile -t programs < <(for p in "${patches[@]}"; do caught_by "$p" | sed 's/^/test_/; s/ .*//'; done | sort -u)
build "${programs[@]}" || { tail -20 ../build.log >&2; echo "the sources without a mutant do not build" >&2; exit 1; }
for p in "${patches[@]}"; do
  read -r program filter < <(caught_by "$p")
  passes "$program" "$filter" && continue
  tail -20 ../test.log >&2
  echo "without a mutant, $program \"$filter\" fails or names no test" >&2
  exit 1
done

caught=0
for p in "${patches[@]}"; do
  read -r program filter < <(caught_by "$p")
  begin=$SECONDS verdict=caught
  if ! patch -s -f -p1 --dry-run <"$p" >/dev/null; then
    verdict="DOES NOT APPLY"
  else
    mapfile -t files < <(sed -n 's|^+++ b/||p' "$p")
    rm -rf ../kept && mkdir ../kept && cp -p --parents "${files[@]}" ../kept
    touch ../begin
    patch -s -f -p1 --no-backup-if-mismatch <"$p"
    if ! build "test_$program"; then
      verdict="DOES NOT BUILD (see build/mutants/build.log)"
    elif passes "$program" "$filter"; then
      verdict=SURVIVED
    fi
    # What was built from the mutant goes, and the source comes back as old as it was: nothing else is built again for it.
    for file in "${files[@]}"; do
      ninja -C ../build -t deps 2>/dev/null | awk -v file="$PWD/$file" '/^[^ ]/ {sub(/:.*/, ""); o = $0} $1 == file {print o}'
    done | (cd ../build && xargs -r -I{} find {} -newer ../begin -delete 2>/dev/null) || true # some were never built
    cp -pr ../kept/. .
  fi
  [ "$verdict" != caught ] || caught=$((caught + 1))
  printf '%-32s %-12s %3d s  %s\n' "$(basename "$p" .patch)" "$program" $((SECONDS - begin)) "$verdict"
done
echo "$caught of ${#patches[@]} mutants caught"
[ "$caught" -eq "${#patches[@]}" ]
