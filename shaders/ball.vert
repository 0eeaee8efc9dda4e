#version 330 core
// SPDX-License-Identifier: MIT
// A particle of a 3D picture as a point sprite that covers the outline of a ball.
uniform mat4 view, projection;
uniform vec2 corner, size; // of the pane's viewport, pixels
uniform float radius;      // metres
uniform vec2 scale;        // colour coordinate = value * x + y
uniform sampler2D map;
layout(location = 0) in vec3 position;
layout(location = 1) in float value;
flat out vec3 colour;
flat out vec3 eye;
flat out vec2 centre;
flat out float pixels; // radius

void main() {
  float s = clamp(value * scale.x + scale.y, 0.0, 1.0);
  float n = float(textureSize(map, 0).x);
  colour = textureLod(map, vec2((s * (n - 1.0) + 0.5) / n, 0.5), 0.0).rgb;
  eye = (view * vec4(position, 1.0)).xyz;
  gl_Position = projection * vec4(eye, 1.0);
  centre = corner + 0.5 * size * (gl_Position.xy / gl_Position.w + 1.0);
  pixels = radius * projection[0][0] * 0.5 * size.x / gl_Position.w;
  gl_PointSize = 2.0 * pixels + 1.0;
}
