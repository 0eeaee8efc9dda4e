#version 330 core
// SPDX-License-Identifier: MIT
// A particle of a 2D picture as a point sprite: a disc whose edge covers pixels partly.
uniform vec2 frame;     // width and height in pixels
uniform vec4 to_pixels; // pixel = position * xy + zw
uniform float radius;   // pixels
uniform vec2 scale;     // colour coordinate = value * x + y
uniform sampler2D map;  // the colour map, one row
layout(location = 0) in vec2 position;
layout(location = 1) in float value;
flat out vec3 colour;
flat out vec2 centre;

void main() {
  centre = position * to_pixels.xy + to_pixels.zw;
  float size = float(textureSize(map, 0).x);
  float s = clamp(value * scale.x + scale.y, 0.0, 1.0);
  colour = textureLod(map, vec2((s * (size - 1.0) + 0.5) / size, 0.5), 0.0).rgb;
  gl_Position = vec4(2.0 * centre / frame - 1.0, 0.0, 1.0);
  gl_PointSize = 2.0 * radius + 2.0; // a pixel of room for the edge
}
