#version 330 core
// SPDX-License-Identifier: MIT
uniform mat4 projection;
uniform float radius;
flat in vec3 colour;
flat in vec3 eye;
flat in vec2 centre;
flat in float pixels;
out vec4 pixel;

void main() {
  vec2 d = (gl_FragCoord.xy - centre) / max(pixels, 0.5);
  float r2 = dot(d, d);
  if (r2 > 1.0) discard;
  vec3 normal = vec3(d.x, -d.y, sqrt(1.0 - r2)); // y of the picture points down
  vec4 clip = projection * vec4(eye + radius * normal, 1.0);
  gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
  float light = 0.45 + 0.55 * max(dot(normal, normalize(vec3(-0.35, 0.75, 0.55))), 0.0);
  pixel = vec4(colour * light, 1.0);
}
