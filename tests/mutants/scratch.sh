# Sourced: make_scratch TOP copies the sources of TOP to TOP/build/mutants/src, configures TOP/build/mutants/build and enters
# the copy. Only files that differ are copied, so that a second run rebuilds only what changed, and what an interrupted run
# left there is put right.
make_scratch() {
  local top=$1 f
  mkdir -p "$top/build/mutants/src"
  exec {scratch_lock}>"$top/build/mutants/lock"
  flock -n "$scratch_lock" || { echo "build/mutants is in use by another run" >&2; exit 3; }
  cd "$top"
  git ls-files -co --exclude-standard | while IFS= read -r f; do
    [ -f "$f" ] || continue
    echo "$f"
    cmp -s "$f" "build/mutants/src/$f" || install -D -m "$(stat -c %a "$f")" "$f" "build/mutants/src/$f"
  done | LC_ALL=C sort >build/mutants/files
  cd "$top/build/mutants/src"
  find . -type f -printf '%P\n' | LC_ALL=C sort | LC_ALL=C comm -13 ../files - | xargs -rd '\n' rm -- # no longer a source
  # -O1: the tests must see the change, the compiler need not be clever about it.
  cmake -S . -B ../build -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1 \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)" >/dev/null
}
