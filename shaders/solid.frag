#version 330 core
// SPDX-License-Identifier: MIT
// Lit as the balls are, with more contrast: its colour stands for nothing. Where the domain cuts a body open, what is seen
// of its inside is lit as the cut itself would be: as the wall through which the ray of sight comes in.
uniform vec3 colour;
uniform vec3 domain;
uniform mat4 view;
in vec3 towards;
in vec3 eye;
in vec3 at; // in the domain
flat in vec3 origin; // the eye, in the domain
out vec4 pixel;

const vec3 key = vec3(-0.393, 0.738, 0.549);

void main() {
  vec3 normal = normalize(towards);
  if (dot(normal, eye) > 0.0) normal = -normal;
  if (gl_FrontFacing) { // y of the picture points down, which turns outsides into backs
    vec3 ray = at - origin, first = min(-origin / ray, (domain - origin) / ray);
    float t = max(first.x, max(first.y, first.z));
    if (t > 0.0) normal = normalize(mat3(view) * (vec3(equal(first, vec3(t))) * -sign(ray)));
  }
  pixel = vec4(min(colour * (0.66 + 0.40 * dot(normal, key)), 1.0), 1.0);
}
