#version 330 core
// SPDX-License-Identifier: MIT
// Triangles in pixels, y down: text, lines and the panel.
uniform vec2 frame; // width and height in pixels
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_at;
layout(location = 2) in vec4 tint;
out vec2 at;
out vec4 colour;

void main() {
  at = texture_at;
  colour = tint;
  gl_Position = vec4(2.0 * position / frame - 1.0, 0.0, 1.0);
}
