#version 330 core
// SPDX-License-Identifier: MIT
// The nearest surface of a liquid, in linear light (to within the difference of a square from the sRGB curve): what lies
// behind, moved by refraction and darkened by the way through (red first); the light that the liquid itself sends back,
// the more of it the deeper it is; the sky in its reflection, by Schlick's form of Fresnel's law; and the lamp.
uniform sampler2D scene;     // the picture without the liquid
uniform sampler2D thickness; // pixels of the layer
uniform sampler2D map;
uniform float tint; // 1: coloured by the map, 0: water
uniform vec2 size;  // of the pane, pixels of the picture
uniform int detail;
uniform float focal; // pixels of the picture of a metre at depth 1
uniform float reach; // metres: what counts as deep
uniform vec3 up;     // against gravity, in the camera's axes
uniform vec3 deep, horizon, zenith; // light of the liquid and of the sky
in vec3 eye, towards;
in float shade;
out vec4 pixel;

const vec3 key = vec3(-0.393, 0.738, 0.549);
const vec3 absorbed = vec3(2.6, 0.75, 0.45); // for each `reach`

vec3 sky(vec3 ray) {
  float height = dot(ray, up);
  vec3 light = mix(horizon, zenith, smoothstep(-0.2, 0.9, height));
  light *= 0.35 + 0.65 * smoothstep(-0.6, 0.1, height); // the ground
  // A broad window above, beside the lamp: its edge in the water shows the shape of the water.
  return light + 0.9 * zenith * smoothstep(0.80, 0.93, dot(ray, key));
}

void main() {
  vec3 sight = normalize(eye), normal = normalize(towards);
  float facing = -dot(sight, normal);
  if (facing < 0.0) { // at an outline
    normal = normalize(normal + (0.02 - facing) * -sight);
    facing = 0.02;
  }
  float way = max(texelFetch(thickness, ivec2(gl_FragCoord.xy), 0).r, 0.0) * length(eye) / (-eye.z * reach);

  vec2 bent = normal.xy * min(way, 0.35) * (0.18 * focal * reach / eye.z);
  vec2 at = (gl_FragCoord.xy / float(detail) + bent * vec2(1.0, -1.0)) / size;
  vec3 behind = texture(scene, clamp(at, 0.5 / size, 1.0 - 0.5 / size)).rgb;
  vec3 through = behind * behind * exp(-absorbed * way);

  vec3 own = deep;
  if (tint > 0.0) {
    float n = float(textureSize(map, 0).x);
    own = textureLod(map, vec2((shade * (n - 1.0) + 0.5) / n, 0.5), 0.0).rgb;
    own *= own;
  }
  float lit = 0.78 + 0.34 * dot(normal, key);
  vec3 light = mix(through, own * lit, 1.0 - exp(-mix(2.6, 14.0, tint) * way - mix(0.30, 0.9, tint)));

  vec3 mirrored = reflect(sight, normal);
  float fresnel = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
  light = mix(light, sky(mirrored), fresnel * mix(1.0, 0.5, tint));
  float glint = max(dot(mirrored, key), 0.0);
  light += (0.8 * pow(glint, 220.0) + 0.16 * pow(glint, 28.0)) * vec3(1.0, 0.98, 0.94);
  pixel = vec4(sqrt(clamp(light, 0.0, 1.0)), 1.0);
}
