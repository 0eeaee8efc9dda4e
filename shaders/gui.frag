#version 330 core
// SPDX-License-Identifier: MIT
uniform sampler2D atlas; // coverage of the glyphs
in vec2 at;
in vec4 colour;
out vec4 pixel;

void main() { pixel = vec4(colour.rgb, colour.a * texture(atlas, at).r); }
