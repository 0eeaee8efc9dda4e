#version 330 core
// SPDX-License-Identifier: MIT
// The surface of a solid body, cut off at the domain.
uniform mat4 model; // from the body's own frame to the domain, whose lower corner is the origin
uniform vec3 domain;
uniform mat4 view, projection;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 towards; // the normal in the camera's axes
out vec3 eye;
out vec3 at; // in the domain
flat out vec3 origin; // the eye, in the domain
out float gl_ClipDistance[6];

void main() {
  vec4 where = model * vec4(position, 1.0);
  at = where.xyz;
  origin = -transpose(mat3(view)) * view[3].xyz;
  float slack = 1e-4 * (domain.x + domain.y + domain.z); // faces that lie in a wall stay
  for (int a = 0; a < 3; ++a) {
    gl_ClipDistance[2 * a] = at[a] + slack;
    gl_ClipDistance[2 * a + 1] = domain[a] + slack - at[a];
  }
  towards = mat3(view) * (mat3(model) * normal);
  vec4 seen = view * where;
  eye = seen.xyz;
  gl_Position = projection * seen;
}
