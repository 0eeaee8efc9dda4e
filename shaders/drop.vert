#version 330 core
// SPDX-License-Identifier: MIT
// A drop apart from its liquid, as a point sprite.
uniform mat4 model, projection; // to the camera's axes, and on
uniform vec2 corner_at, size;   // of the viewport, pixels
uniform float radius;           // metres
uniform float focal;            // pixels of a metre at depth 1
uniform float largest;          // radius of a sprite
uniform vec2 scale;             // colour coordinate = value * x + y
uniform float tint;             // 1: coloured by the map, 0: water
uniform vec3 water;
uniform sampler2D map;
layout(location = 0) in vec3 position;
layout(location = 1) in float share; // of a whole drop
layout(location = 2) in float value;
flat out vec3 colour;
flat out vec2 centre;
flat out vec3 disc; // radius in pixels, depth of the centre, depth of the foremost point from there

void main() {
  float s = clamp(value * scale.x + scale.y, 0.0, 1.0), n = float(textureSize(map, 0).x);
  colour = mix(water, textureLod(map, vec2((s * (n - 1.0) + 0.5) / n, 0.5), 0.0).rgb, tint);
  vec4 clip = projection * (model * vec4(position, 1.0));
  float own = radius * pow(share, 1.0 / 3.0), pixels = min(own * focal / clip.w, largest);
  centre = corner_at + 0.5 * size * (clip.xy / clip.w + 1.0);
  disc = vec3(pixels, 0.5 * clip.z / clip.w + 0.5, 0.5 * own * (clip.z / clip.w + projection[2][2]) / clip.w);
  gl_PointSize = 2.0 * pixels + 1.0;
  gl_Position = clip;
}
