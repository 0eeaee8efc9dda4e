#version 330 core
// SPDX-License-Identifier: MIT
// The surface of a liquid.
uniform mat4 model, projection; // to the camera's axes, and on
uniform vec2 scale;             // colour coordinate = value * x + y
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
out vec3 eye, towards;
out float shade;

void main() {
  vec4 at = model * vec4(position, 1.0);
  eye = at.xyz;
  towards = mat3(model) * normal;
  shade = clamp(value * scale.x + scale.y, 0.0, 1.0);
  gl_Position = projection * at;
}
