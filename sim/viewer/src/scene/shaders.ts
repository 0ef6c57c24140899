// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a width in pixels: each segment is one instance of a quad that is spanned on the screen.

export const lineVertex = /* glsl */ `
attribute vec3 aStart, aEnd, aColour;
attribute vec3 aStyle;             // dash pattern, 1 hatched, width
attribute vec2 aAlong, aTime;      // metres and seconds at both ends
uniform vec2 uScreen;
uniform float uWidth, uBias;
varying vec3 vColour;
varying vec3 vStyle;
varying float vAlong, vTime, vSide, vHalf;

void main() {
  vec4 a = modelViewMatrix * vec4(aStart, 1.0), b = modelViewMatrix * vec4(aEnd, 1.0);
  float near = -0.01;
  if (a.z > near && b.z < near) a = mix(b, a, (near - b.z) / (a.z - b.z));
  if (b.z > near && a.z < near) b = mix(a, b, (near - a.z) / (b.z - a.z));
  vec4 ca = projectionMatrix * a, cb = projectionMatrix * b;
  vec2 sa = ca.xy / ca.w * uScreen * 0.5, sb = cb.xy / cb.w * uScreen * 0.5;
  vec2 along = sb - sa;
  float size = length(along);
  along = size > 1e-4 ? along / size : vec2(1.0, 0.0);
  vHalf = 0.5 * uWidth * aStyle.z;
  bool atEnd = position.x > 0.5;
  vec4 clip = atEnd ? cb : ca;
  vec2 offset = vec2(-along.y, along.x) * position.y * vHalf + along * (atEnd ? 0.5 : -0.5) * vHalf;
  clip.xy += offset / (uScreen * 0.5) * clip.w;
  clip.z -= uBias * clip.w;
  gl_Position = clip;
  vColour = aColour;
  vStyle = aStyle;
  vAlong = atEnd ? aAlong.y : aAlong.x;
  vTime = atEnd ? aTime.y : aTime.x;
  vSide = position.y;
}
`;

export const lineFragment = /* glsl */ `
uniform vec3 uCasing, uHatch;
uniform float uDash, uNow, uPixel;
varying vec3 vColour;
varying vec3 vStyle;
varying float vAlong, vTime, vSide, vHalf;

// What the gaps of a dash pattern are: 0 solid, 1 long, 2 short, 3 long and short in turn.
bool inGap(float pattern, float along) {
  float at = fract(along / uDash);
  if (pattern < 0.5) return false;
  if (pattern < 1.5) return at > 0.68;
  if (pattern < 2.5) return fract(at * 3.0) > 0.5;
  return (at > 0.48 && at < 0.64) || at > 0.84;
}

void main() {
  if (vTime > uNow) discard;
  vec3 colour = vColour;
  bool edge = abs(vSide) * vHalf > vHalf - uPixel;
  if (inGap(vStyle.x, vAlong)) { if (!edge) colour = mix(uCasing, vColour, 0.25); }
  if (vStyle.y > 0.5) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * uPixel);
    if (stripe < 4.5 * uPixel) colour = uHatch;
  }
  // Thin lines that lie close together would be all casing.
  if (edge && vHalf > 2.0 * uPixel) colour = uCasing;
  gl_FragColor = vec4(colour, 1.0);
}
`;

// Points that have a side: from behind they are not seen.

export const sampleVertex = /* glsl */ `
attribute vec3 aNormal;
attribute vec2 aPlaces;            // in the legend of coverage and in that of redundancy
uniform vec3 uColours[8];
uniform float uByBin, uShift, uSize, uPerMetre, uPixel;
varying vec3 vColour;

void main() {
  vec4 eye = modelViewMatrix * vec4(position + uShift * aNormal, 1.0);
  vec3 towards = normalize(normalMatrix * aNormal);
  float facing = -dot(towards, normalize(eye.xyz));
  gl_Position = facing < 0.0 ? vec4(0.0, 0.0, 2.0, 1.0) : projectionMatrix * eye;
  gl_PointSize = max(uSize * uPerMetre / max(-eye.z, 1e-6), 1.5 * uPixel);
  // A little shade tells form; the legend's colour stays what it is.
  vColour = uColours[int(mix(aPlaces.x, aPlaces.y, uByBin) + 0.5)] * (0.86 + 0.14 * facing);
}
`;

export const sampleFragment = /* glsl */ `
varying vec3 vColour;
void main() { gl_FragColor = vec4(vColour, 1.0); }
`;
