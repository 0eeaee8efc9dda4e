#version 330 core
// SPDX-License-Identifier: MIT
// The floor of a 3D pane.
uniform mat4 projection;
layout(location = 0) in vec3 eye; // in the camera's axes
layout(location = 1) in vec2 place;
out vec2 at;

void main() {
  at = place;
  gl_Position = projection * vec4(eye, 1.0);
}
