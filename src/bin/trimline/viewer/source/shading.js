// The shaders: one adds up the tables of a patch, one draws and colours what comes out.

import * as THREE from "three";

export const SHADES = ["plain", "zebra", "Gaussian curvature", "mean curvature", "residual", "gap", "seam gap"];

// Once for every new table of a sum of products: a pixel for each vertex, which holds its position and Gaussian curvature, and its normal and
// mean curvature. Drawing then fetches two values a vertex, however large the basis is.
const SUM = `
precision highp float;
precision highp sampler2D;
uniform sampler2D amplitudes, basis;
uniform int count;
layout(location = 0) out vec4 pointAndGauss;
layout(location = 1) out vec4 normalAndMean;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 s = vec3(0.0), s_u = s, s_v = s, s_uu = s, s_uv = s, s_vv = s;
  for (int j = 0; j < count; j++) {
    vec3 f = texelFetch(basis, ivec2(at.x, j), 0).xyz;
    vec3 g = texelFetch(amplitudes, ivec2(at.y, j), 0).xyz;
    vec3 g_u = texelFetch(amplitudes, ivec2(at.y, count + j), 0).xyz;
    vec3 g_uu = texelFetch(amplitudes, ivec2(at.y, 2 * count + j), 0).xyz;
    s += f.x * g;
    s_u += f.x * g_u;
    s_uu += f.x * g_uu;
    s_v += f.y * g;
    s_uv += f.y * g_u;
    s_vv += f.z * g;
  }
  vec3 across = cross(s_u, s_v);
  float area = dot(across, across);
  // At a pole there is no normal; the fragment takes that of the drawn triangle.
  vec3 n = area > 1e-12 * dot(s_u, s_u) * dot(s_v, s_v) && area > 0.0 ? across * inversesqrt(area) : vec3(0.0);
  float E = dot(s_u, s_u), F = dot(s_u, s_v), G = dot(s_v, s_v);
  float L = dot(s_uu, n), M = dot(s_uv, n), N = dot(s_vv, n);
  float det = max(E * G - F * F, 1e-30);
  pointAndGauss = vec4(s, (L * N - M * M) / det);
  normalAndMean = vec4(n, (E * N - 2.0 * F * M + G * L) / (2.0 * det));
}`;

const VERTEX = `
precision highp sampler2D;
uniform sampler2D points, normals;
uniform vec2 cells;
in vec2 node;
in float scalar;
out vec3 eye, normalTo;
out vec2 place;
out float gauss, mean, shade;

void main() {
  ivec2 at = ivec2(node.yx);
  vec4 point = texelFetch(points, at, 0), n = texelFetch(normals, at, 0);
  gauss = point.w;
  mean = n.w;
  shade = scalar;
  place = node / cells;
  vec4 seen = modelViewMatrix * vec4(point.xyz, 1.0);
  eye = seen.xyz;
  normalTo = normalMatrix * n.xyz;
  gl_Position = projectionMatrix * seen;
}`;

const FRAGMENT = `
precision highp float;
uniform int mode;
uniform bool lines;
uniform float size;
in vec3 eye, normalTo;
in vec2 place;
in float gauss, mean, shade;
out vec4 color;

vec3 diverging(float x) {
  vec3 low = vec3(0.15, 0.32, 0.75), middle = vec3(0.93), high = vec3(0.77, 0.15, 0.15);
  return x < 0.0 ? mix(middle, low, -x) : mix(middle, high, x);
}

vec3 rising(float x) {
  vec3 low = vec3(0.267, 0.004, 0.329), middle = vec3(0.129, 0.569, 0.549), high = vec3(0.993, 0.906, 0.144);
  return x < 0.5 ? mix(low, middle, 2.0 * x) : mix(middle, high, 2.0 * x - 1.0);
}

void main() {
  vec3 n = dot(normalTo, normalTo) > 0.25 ? normalize(normalTo) : normalize(cross(dFdx(eye), dFdy(eye)));
  vec3 view = normalize(-eye);
  bool inside = dot(n, view) < 0.0;
  if (inside) n = -n;
  float light = 0.35 + 0.65 * max(dot(n, normalize(vec3(0.3, 0.5, 0.9))), 0.0);
  vec3 base = inside ? vec3(0.80, 0.66, 0.50) : vec3(0.52, 0.66, 0.80);
  if (mode == 1) {
    vec3 r = reflect(-view, n);
    float band = sin(24.0 * asin(clamp(r.y, -1.0, 1.0)));
    base = vec3(mix(0.12, 0.95, smoothstep(-0.2, 0.2, band / max(fwidth(band), 0.2))));
    light = 1.0;
  } else if (mode == 2) {
    base = diverging(gauss * size * size / (1.0 + abs(gauss) * size * size));
  } else if (mode == 3) {
    base = diverging(mean * size / (1.0 + abs(mean) * size));
  } else if (mode >= 4 && shade >= 0.0) {
    base = rising(clamp((log(max(shade, 1e-17)) / log(10.0) + 16.0) / 16.0, 0.0, 1.0));
  }
  vec3 lit = base * (mode >= 2 ? 0.45 + 0.55 * light : light);
  if (lines) {
    vec2 at = place * vec2(16.0, 32.0);
    vec2 near = abs(fract(at - 0.5) - 0.5) / max(fwidth(at), vec2(1e-6));
    lit = mix(vec3(0.1), lit, smoothstep(0.3, 1.3, min(near.x, near.y)));
  }
  color = vec4(lit, 1.0);
}`;

// What all patches share: colouring, and the size that curvatures are measured against.
export function sharedUniforms() {
  return { mode: { value: 0 }, lines: { value: false }, size: { value: 1 } };
}

export function drawing(shared) {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: THREE.DoubleSide,
    // Behind the lines that run on it.
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: { ...shared, points: { value: null }, normals: { value: null }, cells: { value: new THREE.Vector2(1, 1) } },
  });
}

export function summing() {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: "void main() { gl_Position = vec4(position, 1.0); }",
    fragmentShader: SUM,
    depthTest: false,
    depthWrite: false,
    uniforms: { amplitudes: { value: null }, basis: { value: null }, count: { value: 0 } },
  });
}
