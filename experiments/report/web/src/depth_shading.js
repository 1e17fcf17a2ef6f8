import * as THREE from 'three';

// Eye-dome lighting: a pixel is the darker, the farther it lies behind those around it. Shows the shape of clouds
// of points, which have no normals. The depth is passed on, for what is drawn afterwards.
const vertexShader = `
varying vec2 at;
void main() {
  at = position.xy * 0.5 + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const fragmentShader = `
uniform sampler2D colors, depths;
uniform vec2 pixel;  // size of one, as a share of the picture
uniform vec2 range;  // near, far [m]
uniform float tangent;  // a pixel's size at a distance of 1 m [m]
varying vec2 at;

float metres(vec2 place) {
  float depth = texture2D(depths, place).r;
  return range.x * range.y / (range.y - depth * (range.y - range.x));
}

void main() {
  float depth = texture2D(depths, at).r;
  if (depth >= 1.0) discard;
  float own = metres(at);
  float slack = 3.0 * tangent * own;  // of a surface seen at an angle
  float behind = 0.0;
  for (int i = 0; i < 8; ++i) {
    float angle = float(i) * 0.785398;
    float step = own - metres(at + 1.6 * pixel * vec2(cos(angle), sin(angle)));
    behind += clamp((step - slack) / 0.5, 0.0, 1.0) / 8.0;
  }
  gl_FragColor = vec4(texture2D(colors, at).rgb * exp(-2.0 * behind), 1.0);
  gl_FragDepth = depth;
}`;

export function makeDepthShading() {
  const target = new THREE.WebGLRenderTarget(1, 1, { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
  target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
  const uniforms = {
    colors: { value: target.texture },
    depths: { value: target.depthTexture },
    pixel: { value: new THREE.Vector2() },
    range: { value: new THREE.Vector2() },
    tangent: { value: 1 },
  };
  const material = new THREE.ShaderMaterial({ vertexShader, fragmentShader, uniforms, depthFunc: THREE.AlwaysDepth });
  const screen = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
  screen.frustumCulled = false;

  const setSize = (width, height) => {
    target.setSize(width, height);
    uniforms.pixel.value.set(1 / width, 1 / height);
  };
  // Draws a scene, and then another over it.
  const render = (renderer, solid, overlay, camera) => {
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(solid, camera);
    renderer.setRenderTarget(null);
    renderer.clear();
    uniforms.range.value.set(camera.near, camera.far);
    uniforms.tangent.value = (2 * Math.tan((camera.fov * Math.PI) / 360)) / target.height;
    renderer.render(screen, camera);
    renderer.render(overlay, camera);
  };
  return { setSize, render };
}
