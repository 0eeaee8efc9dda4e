#version 330 core
// SPDX-License-Identifier: MIT
uniform sampler2D shade;
uniform vec4 colour; // and how much of it the darkest shadow has
in vec2 at;
out vec4 pixel;

void main() { pixel = vec4(colour.rgb, colour.a * texture(shade, at).r); }
