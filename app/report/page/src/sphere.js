// The picture of the method: the sphere around one particle, the caps that its neighbors cover, and
// what stays uncovered. In two dimensions the circle, drawn as a band.
import {
  Color, CylinderGeometry, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, PerspectiveCamera, Scene,
  ShaderMaterial, SphereGeometry, Vector4, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { themeColor } from "./colors.js";
import { addKeys } from "./space.js";

export const maxCaps = 200; // a shader may have 224 vectors

const vertexShader = `
  varying vec3 direction;
  void main() {
    direction = position;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;
const fragmentShader = `
  uniform vec4 caps[${maxCaps}];
  uniform int count;
  uniform vec3 covered, open, rim;
  uniform bool flat_state;
  varying vec3 direction;
  void main() {
    vec3 u = normalize(flat_state ? vec3(direction.xy, 0.0) : direction);
    float nearest = 1.0, holds = 0.0, in_nearest = 0.0;
    for (int c = 0; c < ${maxCaps}; ++c) {
      if (c >= count) break;
      float beyond = dot(u, caps[c].xyz) - caps[c].w;
      float inside = step(0.0, beyond);
      holds += inside;
      float distance = abs(beyond) / max(sqrt(1.0 - caps[c].w * caps[c].w), 0.1);
      if (distance < nearest) {
        nearest = distance;
        in_nearest = inside;
      }
    }
    // Rims that others cover are faint.
    float strength = holds - in_nearest > 0.5 ? 0.25 : 1.0;
    vec3 color = holds > 0.0 ? covered * (1.0 - 0.03 * min(holds, 6.0)) : open;
    color = mix(color, rim, strength * (1.0 - smoothstep(0.004, 0.012, nearest)));
    float light = flat_state ? 1.0 : 0.75 + 0.25 * dot(u, normalize(vec3(0.3, 0.6, 0.8)));
    gl_FragColor = vec4(color * light, 1.0);
  }`;

export class CoveredSphere {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.camera = new PerspectiveCamera(35, 1, 0.1, 50);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    addKeys(canvas, this.camera, this.controls);
    this.scene = new Scene();
    this.uniforms = {
      caps: { value: Array.from({ length: maxCaps }, () => new Vector4()) },
      count: { value: 0 },
      covered: { value: new Color() }, open: { value: new Color() }, rim: { value: new Color() },
      flat_state: { value: false },
    };
    const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms: this.uniforms });
    this.sphere = new Mesh(new SphereGeometry(1, 96, 64), material);
    this.band = new Mesh(new CylinderGeometry(1, 1, 0.2, 256, 1, true).rotateX(Math.PI / 2), material);
    material.side = 2;
    const balls = new MeshBasicMaterial({ transparent: true, opacity: 0.09, depthWrite: false });
    this.balls = new InstancedMesh(new SphereGeometry(1, 24, 16), balls, maxCaps);
    this.balls.frustumCulled = false;
    const dots = new MeshBasicMaterial();
    this.dots = new InstancedMesh(new SphereGeometry(0.03, 12, 8), dots, maxCaps);
    this.dots.frustumCulled = false;
    this.scene.add(this.sphere, this.band, this.balls, this.dots);
    this.lookFrom([1.6, 1.2, 4.2]);
  }

  lookFrom(place) {
    this.camera.position.set(...place);
    this.controls.update();
  }

  // Caps of one particle (coverage.js); the view looks at the uncovered side where there is one.
  show(caps, { ratio, dimension, openDirection, withSpheres }) {
    const shown = caps.slice(0, maxCaps);
    shown.forEach(({ direction, cosine }, c) => this.uniforms.caps.value[c].set(...direction, cosine));
    this.uniforms.count.value = shown.length;
    this.uniforms.flat_state.value = dimension === 2;
    this.sphere.visible = dimension === 3;
    this.band.visible = dimension === 2;
    this.balls.visible = this.dots.visible = withSpheres;
    this.balls.count = this.dots.count = shown.length;
    shown.forEach(({ direction, distance }, c) => {
      const place = direction.map((part) => part * distance);
      this.balls.setMatrixAt(c, new Matrix4().makeScale(ratio, ratio, ratio).setPosition(...place));
      this.dots.setMatrixAt(c, new Matrix4().setPosition(...place));
    });
    this.balls.instanceMatrix.needsUpdate = this.dots.instanceMatrix.needsUpdate = true;
    const [x, y, z] = openDirection ?? [0.3, 0.3, 0.9];
    const from = dimension === 2 ? [0, -1.6, 4.2] : [4 * x + 1.2 * y + 0.6, 4 * y + 0.9, 4 * z - 1.2 * y + 0.6];
    this.lookFrom(from.map((part) => part * (withSpheres ? 1.4 : 1)));
    this.draw();
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.renderer.setClearColor(new Color(themeColor("page")));
    const set = (color, name) => color.set(themeColor(name)).convertLinearToSRGB();
    set(this.uniforms.covered.value, "interior");
    set(this.uniforms.open.value, "surface");
    set(this.uniforms.rim.value, "ink");
    this.balls.material.color.set(themeColor("wall"));
    this.dots.material.color.set(themeColor("ink"));
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
  }
}
