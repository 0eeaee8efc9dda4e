#version 330 core
// SPDX-License-Identifier: MIT
// The mean of 2 x 2 pixels (or of one) of a 3D layer over what is under it, in linear light (to within the difference of a square
// from the sRGB curve).
uniform sampler2D layer, under;
uniform ivec2 corner; // of the pane in the picture
uniform int detail;   // 2 or 1
uniform float share;  // 1 / detail^2
out vec4 pixel;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - corner;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < detail * detail; ++k) {
    vec4 s = texelFetch(layer, detail * at + ivec2(k & 1, k >> 1), 0);
    sum += vec4(s.rgb * s.rgb, s.a);
  }
  if (sum.a == 0.0) discard;
  vec3 below = texelFetch(under, at, 0).rgb;
  pixel = vec4(sqrt(share * sum.rgb + (1.0 - share * sum.a) * below * below), 1.0);
}
