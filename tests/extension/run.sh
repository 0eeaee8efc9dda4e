#!/bin/bash
# One declaration is enough: adds a parameter to one scheme header in a scratch copy of the sources and, with no other edit,
# demands to find it in TOML, --set, `list parameters`, the timeline, and the pixels of the panel, moving.
set -euo pipefail
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/tests/mutants/scratch.sh"
make_scratch "$top" # leaves us in the copy

header=sim/transfer/apic.h
cp "$header" "$header.before"
trap 'mv "$header.before" "$header"' EXIT
sed -i -e 's|double affine = 1;|double affine = 1, whirl = 0.5;|' \
  -e '/void describe(ParameterVisitor& v)/a v.real({.name = "whirl", .help = "Added by a test", .min = 0, .max = 1, .level = Level::teach}, whirl);' \
  "$header"
cmp -s "$header" "$header.before" && { echo "the header no longer has the lines this test edits" >&2; exit 1; }
cmake --build ../build --target flipbook >../build.log 2>&1 || { tail -20 ../build.log; exit 1; }

program=$PWD/../build/flipbook
work=$(mktemp -d)
cd "$work"
fail() { echo "FAILED: $1" >&2; exit 1; }

"$program" list parameters | grep -q 'transfer.whirl' || fail "list parameters does not know it"
"$program" still dam_break --at 0 --cells 16,16 --set transfer.whirl=0.25 -o set/ --quiet >/dev/null || fail "--set refuses it"
"$program" info set/*.png | grep -q 'whirl = 0.25' || fail "the picture's study does not have it"
if "$program" still dam_break --at 0 --set transfer.whirl=2 -o refused/ --quiet 2>message; then fail "its range is not checked"; fi
grep -q 'whirl' message || fail "the message does not name it"

cat >study.toml <<'TOML'
scene = "dam_break"
grid.cells = [16, 16]
[[variant]]
transfer.scheme = "apic"
transfer.whirl = 0.1
[[key]]
t = 0
over = 0.2
transfer.whirl = 0.9
[view]
panel = ["whirl"]
[output]
fps = 30
duration = 0.2
TOML
"$program" render study.toml -o moving/ --quiet >/dev/null || fail "TOML or the timeline refuses it"
sed '/\[\[key\]\]/,/whirl = 0.9/d' study.toml >still.toml
"$program" render still.toml -o still/ --quiet >/dev/null

# The panel is at the right. Nothing but the slider can differ there between the two runs: the particles do not use whirl.
panel() { ffmpeg -v error -i "$1" -vf crop=iw*0.2:ih*0.7:iw*0.8:0 -f rawvideo -pix_fmt rgb24 - | sha256sum; }
[ "$(panel still/frame_000001.png)" = "$(panel still/frame_000003.png)" ] || fail "the panel moves without a key"
[ "$(panel moving/frame_000001.png)" != "$(panel moving/frame_000003.png)" ] || fail "the panel does not move"
[ "$(panel moving/frame_000003.png)" != "$(panel moving/frame_000005.png)" ] || fail "the panel stops moving"
rm -rf "$work"
echo "one declaration was enough"
