#version 330 core
// SPDX-License-Identifier: MIT
// Pixels that were computed beforehand, each in its place.
uniform sampler2D image;
uniform ivec2 corner; // of the area in the picture
out vec4 pixel;

void main() { pixel = texelFetch(image, ivec2(gl_FragCoord.xy) - corner, 0); }
