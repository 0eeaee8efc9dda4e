#!/bin/bash
# One declaration is enough: adds a parameter to one scheme header in a scratch copy of the sources and, with no other edit,
# demands to find it in `list parameters`, --set, TOML, the timeline, and the pixels of the panel, moving. And one command is enough
# for a scheme in plain scalar code: it is built, graded and compared without another edit.
set -euo pipefail
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/tests/mutants/scratch.sh"
make_scratch "$top" # leaves us in the copy; the next one puts the header right

header=sim/transfer/apic.h
sed -i -e 's|double affine = 1;|double affine = 1, whirl = 0.5;|' \
  -e '/void describe(ParameterVisitor& v)/a v.real({.name = "whirl", .help = "Added by a test", .min = 0, .max = 1, .level = Level::teach}, whirl);' \
  "$header"
[ "$(grep -c whirl "$header")" -eq 2 ] || { echo "$header no longer has the lines that this test edits" >&2; exit 1; }
# Two schemes, built together with the parameter. The second scheme is wrong: the sign of its affine offset is reversed.
# FLIPBOOK, where it is given, is a program of these sources, to save a build.
flipbook=${FLIPBOOK:-$PWD/../build/flipbook}
[ -n "${FLIPBOOK:-}" ] || cmake --build ../build --target flipbook >../build.log 2>&1 || { tail -20 ../build.log >&2; exit 1; }
for scheme in homework mistaken; do "$flipbook" new scheme $scheme >/dev/null; done
sed -i 's|v += p.C(a, b) \* r\[b\]|v -= p.C(a, b) * r[b]|' sim/transfer/mistaken.h
[ "$(grep -c 'v -= ' sim/transfer/mistaken.h)" -eq 1 ] || { echo "the template no longer has the line that this test edits" >&2; exit 1; }
cmake --build ../build --target flipbook >../build.log 2>&1 || { tail -20 ../build.log >&2; exit 1; }

program=$PWD/../build/flipbook
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "FAILED: $1" >&2; exit 1; }
says() { grep -- "$1" >/dev/null; } # reads to the end, so that the program before the pipe can finish

"$program" list parameters | says '^ *transfer\.whirl ' || fail "list parameters does not know it"

"$program" still dam_break --at 0 --cells 16,16 --set transfer.whirl=0.25 -o set/ --quiet >/dev/null || fail "--set refuses it"
"$program" info set/*.png --study | says 'whirl = 0\.25$' || fail "the picture's study does not have what --set said"
code=0
"$program" still dam_break --at 0 --set transfer.whirl=2 -o refused/ --quiet >/dev/null 2>message || code=$?
[ "$code" -eq 2 ] || fail "its range is not checked"
says 'transfer\.whirl must be a number from 0 to 1' <message || fail "the message does not say what is wrong: $(cat message)"

cat >moving.toml <<'TOML'
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
size = [1280, 720]
fps = 30
duration = 0.2
TOML
sed '/\[\[key\]\]/,/whirl = 0.9/d' moving.toml >still.toml
"$program" render still.toml -o still/ --quiet >/dev/null || fail "TOML refuses it"
"$program" info still/frame_000000.png --study | says 'whirl = 0\.1$' || fail "the picture's study does not have what TOML said"
"$program" render moving.toml -o moving/ --quiet >/dev/null || fail "the timeline refuses it"

# The panel, at the right: a line with the name and the value, and the slider with the pointer below it. Only the key can make
# them differ between frames.
pixels() { ffmpeg -v error -i "$1" -vf "crop=$2" -f rawvideo -pix_fmt rgb24 - | sha256sum; }
for part in value=256:26:1004:62 slider=256:34:1004:88; do
  name=${part%%=*} crop=${part#*=}
  for frame in 3 5; do
    [ "$(pixels still/frame_000001.png "$crop")" = "$(pixels "still/frame_00000$frame.png" "$crop")" ] ||
      fail "the panel's $name moves without a key"
  done
  [ "$(for frame in 1 3 5; do pixels "moving/frame_00000$frame.png" "$crop"; done | sort -u | wc -l)" -eq 3 ] ||
    fail "the panel's $name does not move with the key"
done
echo "one declaration was enough"

"$program" list schemes | says '^ *homework\[:keep\] ' || fail "list schemes does not know the new scheme"
"$program" verify --only homework >card || fail "the new scheme does not pass as it is written: $(grep HOLD card)"
says 'REPORT CARD' <card || fail "verify does not grade it"
code=0
"$program" verify --only mistaken >card || code=$?
[ "$code" -eq 1 ] || fail "a wrong scheme passes"
says '^5\.4 .*DOES NOT HOLD' <card || fail "the card does not say that angular momentum gets lost on the way to the grid"
says '^5\.2 .*holds' <card || fail "the card denies what does hold"
"$program" compare transfer_rotation --schemes apic,homework:0.5,mistaken --frames 3 -o panes/ --quiet >/dev/null || fail "compare refuses it"
"$program" compare dam_break --schemes apic,homework --cells 16 --frames 2 -o flow/ --quiet >/dev/null || fail "it does not flow"
echo "one command was enough"
