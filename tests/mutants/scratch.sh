# Sourced: make_scratch TOP copies the sources of TOP to TOP/build/mutants/src, configures TOP/build/mutants/build and enters
# the copy. Only files that differ are copied, so that a second run rebuilds only what changed.
make_scratch() {
  local top=$1 f
  mkdir -p "$top/build/mutants/src"
  cd "$top"
  git ls-files -co --exclude-standard -z | while IFS= read -r -d '' f; do
    [ -f "$f" ] || continue
    cmp -s "$f" "build/mutants/src/$f" || install -D -m "$(stat -c %a "$f")" "$f" "build/mutants/src/$f"
  done
  cd "$top/build/mutants/src"
  # -O1: the tests must see the change, the compiler need not be clever about it.
  cmake -S . -B ../build -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1 >/dev/null
}
