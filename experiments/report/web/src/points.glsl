// Points as round dots of a size in metres.
uniform int coloring;  // 0 by scan, 1 by height, 2 by reflectance
uniform vec2 heights;
uniform float cut;
uniform float dotSize;  // [m]
uniform float screenHeight;  // [px]
uniform float lightening;
uniform sampler2D scanColors, heightColors, reflectanceColors;
attribute vec2 info;  // stop, reflectance
varying vec3 shade;

vec3 onRamp(sampler2D ramp, float share) {
  float count = float(textureSize(ramp, 0).x);
  return texture2D(ramp, vec2((clamp(share, 0.0, 1.0) * (count - 1.0) + 0.5) / count, 0.5)).rgb;
}

void main() {
  float count = float(textureSize(scanColors, 0).x);
  if (coloring == 0) shade = texture2D(scanColors, vec2((mod(info.x, count) + 0.5) / count, 0.5)).rgb;
  if (coloring == 1) shade = onRamp(heightColors, (position.z - heights.x) / max(heights.y - heights.x, 1e-3));
  if (coloring == 2) shade = onRamp(reflectanceColors, info.y);
  shade = mix(shade, vec3(1.0), lightening);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  float size = dotSize * projectionMatrix[1][1] * screenHeight / (2.0 * gl_Position.w);
  gl_PointSize = clamp(size, 1.5, 40.0);
  if (position.z > cut) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside of the picture
}
