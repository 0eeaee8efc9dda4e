#version 330 core
// SPDX-License-Identifier: MIT
// The surface of a solid body.
uniform mat4 model; // from the body's own frame to the domain, whose lower corner is the origin
uniform mat4 view, projection;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 towards, at;

void main() {
  vec4 place = model * vec4(position, 1.0);
  at = place.xyz;
  towards = mat3(model) * normal;
  gl_Position = projection * (view * place);
}
