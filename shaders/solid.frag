#version 330 core
// SPDX-License-Identifier: MIT
// Lit as the balls are, with more contrast: its colour stands for nothing.
uniform vec3 colour;
in vec3 towards;
in vec3 eye;
out vec4 pixel;

const vec3 key = vec3(-0.393, 0.738, 0.549);

void main() {
  vec3 normal = normalize(towards);
  if (dot(normal, eye) > 0.0) normal = -normal;
  pixel = vec4(min(colour * (0.66 + 0.40 * dot(normal, key)), 1.0), 1.0);
}
