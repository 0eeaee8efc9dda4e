#version 330 core
// SPDX-License-Identifier: MIT
uniform float radius;
flat in vec3 colour;
flat in vec2 centre;
out vec4 pixel;

void main() {
  // The part of the pixel inside the disc, to first order; a disc smaller than a pixel fades instead of vanishing.
  float cover = clamp(radius + 0.5 - distance(gl_FragCoord.xy, centre), 0.0, min(1.0, 2.0 * radius));
  if (cover <= 0.0) discard;
  pixel = vec4(colour, cover);
}
