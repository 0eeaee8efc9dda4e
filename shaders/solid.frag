#version 330 core
// SPDX-License-Identifier: MIT
// Lit as the balls are, with more contrast: its colour stands for nothing. Where the domain cuts a body open, what is seen
// of its inside is lit as the cut itself would be: as the wall through which the ray of sight comes in.
uniform vec3 colour;
uniform vec3 domain, camera; // its upper corner and the eye, from its lower corner
uniform mat4 view;
uniform sampler3D around; // how full it is around (render/views/surroundings.h): each level is half as fine
uniform float cell;       // of the first level, metres
in vec3 towards; // the normal in the domain's axes
in vec3 at;
out vec4 pixel;

const vec3 key = vec3(-0.393, 0.738, 0.549);

const float takes[5] = float[5](0.36, 0.34, 0.28, 0.18, 0.10);

/// What is left of the ambient light.
float open(vec3 normal) {
  float light = 1.0, away = 1.5 * cell;
  for (int k = 0; k < 5; ++k, away *= 2.0)
    light *= 1.0 - takes[k] * textureLod(around, (at + away * normal) / domain, float(k)).r;
  return light;
}

void main() {
  // Not by clip distances: with more varyings beside them llvmpipe of Mesa 22 writes outside its buffers.
  float slack = 1e-4 * (domain.x + domain.y + domain.z); // faces that lie in a wall stay
  if (any(lessThan(at, vec3(-slack))) || any(greaterThan(at, domain + slack))) discard;
  vec3 ray = at - camera, normal = normalize(towards);
  if (dot(normal, ray) > 0.0) normal = -normal;
  if (gl_FrontFacing) { // y of the picture points down, which turns outsides into backs
    vec3 first = min(-camera / ray, (domain - camera) / ray);
    float t = max(first.x, max(first.y, first.z));
    if (t > 0.0) normal = vec3(equal(first, vec3(t))) * -sign(ray);
  }
  float light = open(normal);
  pixel = vec4(min(colour * light * (0.66 + 0.40 * dot(mat3(view) * normal, key)), 1.0), 1.0);
}
