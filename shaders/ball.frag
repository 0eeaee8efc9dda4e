#version 330 core
// SPDX-License-Identifier: MIT
// Shading multiplies the colour by 0.52 (at the outline, away from the light) to 1.05 (towards it), 1.00 in the middle of
// the disc and 0.90 on average: hue and saturation stay those of the key to the colours. The surroundings change that by
// the factor `light` (render/views/occlusion.cpp), which is 0.84 to 1.06 in the open.
flat in vec3 colour;
flat in vec2 centre;
flat in vec3 disc;
out vec4 pixel;

const vec3 key = vec3(-0.393, 0.738, 0.549);

void main() {
  vec2 d = (gl_FragCoord.xy - centre) / disc.x;
  float r2 = dot(d, d);
  if (r2 > 1.0) discard;
  vec3 normal = vec3(d.x, -d.y, sqrt(1.0 - r2)); // y of the picture points down
  gl_FragDepth = disc.y + disc.z * normal.z;
  pixel = vec4(colour * (0.70 + 0.22 * dot(normal, key) + 0.18 * normal.z), 1.0);
}
