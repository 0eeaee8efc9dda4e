#version 330 core
// SPDX-License-Identifier: MIT
// Light comes in at the lamp's side of a drop and leaves on the other: dark towards the lamp but for its image, bright
// away from it.
flat in vec3 colour;
flat in vec2 centre;
flat in vec3 disc;
out vec4 pixel;

const vec3 key = vec3(-0.393, 0.738, 0.549);

void main() {
  vec2 d = (gl_FragCoord.xy - centre) / max(disc.x, 0.5);
  float r2 = dot(d, d);
  if (r2 > 1.0) discard;
  vec3 normal = vec3(d.x, -d.y, sqrt(1.0 - r2)); // y of the picture points down
  gl_FragDepth = disc.y + disc.z * normal.z;
  float glint = pow(max(dot(normal, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
  pixel = vec4(mix(colour * (0.92 - 0.22 * dot(normal, key) + 0.12 * r2), vec3(1.0), 0.8 * glint), 1.0);
}
