#version 330 core
// SPDX-License-Identifier: MIT
// A particle of a 3D picture: the square around the outline of a ball, as a point sprite; with a corner, as one vertex
// of two triangles, for balls larger than a sprite can be.
uniform mat4 projection;
uniform vec2 corner_at, size; // of the viewport, pixels
uniform float radius;         // metres
uniform float focal;          // pixels of a metre at depth 1
uniform vec2 scale;           // colour coordinate = value * x + y
uniform sampler2D map;
layout(location = 0) in vec3 eye; // the centre, in the camera's axes
layout(location = 1) in float value;
layout(location = 2) in float light; // what its surroundings leave of the ambient light
layout(location = 3) in vec2 corner; // (0, 0) for a sprite
flat out vec3 colour;
flat out vec2 centre;
flat out vec3 disc; // radius in pixels, depth of the centre, depth of the foremost point from there

void main() {
  float s = clamp(value * scale.x + scale.y, 0.0, 1.0);
  float n = float(textureSize(map, 0).x);
  colour = light * textureLod(map, vec2((s * (n - 1.0) + 0.5) / n, 0.5), 0.0).rgb;
  vec4 clip = projection * vec4(eye, 1.0);
  centre = corner_at + 0.5 * size * (clip.xy / clip.w + 1.0);
  float pixels = radius * focal / clip.w;
  // Depths on the surface to first order in radius / distance: a division for each ball instead of each pixel.
  float slope = (clip.z / clip.w + projection[2][2]) / clip.w;
  disc = vec3(pixels, 0.5 * clip.z / clip.w + 0.5, 0.5 * radius * slope);
  gl_PointSize = 2.0 * pixels + 1.0;
  gl_Position = clip + vec4(corner * (2.0 * pixels + 1.0) / size * clip.w, 0.0, 0.0);
}
