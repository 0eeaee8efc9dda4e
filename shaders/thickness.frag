#version 330 core
// SPDX-License-Identifier: MIT
// Where the line of sight leaves the liquid minus where it enters, summed up: its way through, in the direction of the
// camera's axis. Nothing beyond a solid counts, which then ends the way itself.
uniform sampler2D solids; // depths of what is opaque
uniform vec3 lens;        // the projection's [2][2] and [3][2]; a depth inside the domain, for the digits
in float depth;
out float way;

void main() {
  float z = 2.0 * texelFetch(solids, ivec2(gl_FragCoord.xy), 0).r - 1.0;
  float end = min(depth, lens.y / (z + lens.x)) - lens.z;
  way = gl_FrontFacing ? end : -end; // y of the picture points down, which turns outsides into backs
}
