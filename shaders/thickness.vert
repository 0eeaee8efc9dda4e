#version 330 core
// SPDX-License-Identifier: MIT
// The surface of a liquid, for how much of it the line of sight passes.
uniform mat4 model, projection; // to the camera's axes, and on
layout(location = 0) in vec3 position;
out float depth;

void main() {
  vec4 eye = model * vec4(position, 1.0);
  depth = -eye.z;
  gl_Position = projection * eye;
}
