// The state in space: a point a particle, shaded like a ball, drawn only when something changes, so
// that 100,000 of them turn fluently without a graphics card.
import {
  BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, PerspectiveCamera, Points,
  Scene, ShaderMaterial, Spherical, Vector3, Vector4, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { rgb, themeColor } from "./colors.js";

const vertexShader = `
  attribute vec4 tint; // color, and whether it is drawn at all
  uniform float diameter, height;
  uniform vec4 cut;
  varying vec3 shade;
  void main() {
    shade = tint.rgb;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * seen;
    gl_PointSize = clamp(diameter * height * projectionMatrix[1][1] / (2.0 * gl_Position.w), 1.5, 64.0);
    if (tint.a < 0.5 || dot(cut.xyz, position) > cut.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }`;
const fragmentShader = `
  varying vec3 shade;
  void main() {
    vec2 place = 2.0 * gl_PointCoord - 1.0;
    float outside = dot(place, place);
    if (outside > 1.0) discard;
    gl_FragColor = vec4(shade * (0.55 + 0.45 * sqrt(1.0 - outside)), 1.0);
  }`;

function pointCloud(uniforms) {
  const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms });
  const cloud = new Points(new BufferGeometry(), material);
  cloud.frustumCulled = false;
  return cloud;
}

function setPoints(cloud, position, tint) {
  cloud.geometry.dispose();
  cloud.geometry = new BufferGeometry();
  cloud.geometry.setAttribute("position", new BufferAttribute(position, 3));
  cloud.geometry.setAttribute("tint", new BufferAttribute(tint, 4, true));
}

// Turning and zooming by keys, which OrbitControls has for moving only.
export function addKeys(canvas, camera, controls) {
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
  const zooms = { "+": 0.9, "=": 0.9, "-": 1.1 };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in turns) && !(event.key in zooms)) return;
    event.preventDefault();
    const place = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    const [around, up] = turns[event.key] ?? [0, 0];
    place.theta += around;
    place.phi = Math.min(Math.max(place.phi + up, 0.01), Math.PI - 0.01);
    place.radius *= zooms[event.key] ?? 1;
    camera.position.setFromSpherical(place).add(controls.target);
    controls.update();
  });
}

export class Space {
  constructor(canvas, onPick) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    this.camera = new PerspectiveCamera(40, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    addKeys(canvas, this.camera, this.controls);
    this.uniforms = { diameter: { value: 1 }, height: { value: 1 }, cut: { value: new Vector4(0, 0, 0, 1) } };
    this.fluid = pointCloud(this.uniforms);
    this.walls = pointCloud(this.uniforms);
    this.normals = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    this.normals.frustumCulled = false;
    this.scene = new Scene();
    this.scene.add(this.fluid, this.walls, this.normals);
    new ResizeObserver(() => this.draw()).observe(canvas);
    this.addPicking(onPick);
  }

  addPicking(onPick) {
    let down = null;
    this.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
    this.canvas.addEventListener("pointerup", (event) => {
      const moved = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]);
      if (down && moved < 4) onPick(this.nearest(event));
      down = null;
    });
  }

  // The foremost particle drawn under the pointer; -1 where there is none.
  nearest(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = [((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2];
    const { position, tint } = this.fluid.geometry.attributes;
    const place = new Vector3();
    let found = -1;
    let nearest = Infinity;
    for (let i = 0; i < position.count; ++i) {
      place.fromBufferAttribute(position, i);
      if (tint.array[4 * i + 3] === 0 || this.isCutAway(i)) continue;
      const distance = place.distanceTo(this.camera.position);
      place.project(this.camera);
      const radius = Math.max(this.uniforms.diameter.value * this.camera.projectionMatrix.elements[5] / distance, 0.02);
      if (Math.hypot((place.x - at[0]) * this.camera.aspect, place.y - at[1]) < radius / 2 && distance < nearest) {
        nearest = distance;
        found = i;
      }
    }
    return found;
  }

  // Takes another state; the view stays unless it is told to show the whole of it.
  show(state) {
    this.state = state;
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < state.position.length; ++i) {
      this.low[i % 3] = Math.min(this.low[i % 3], state.position[i]);
      this.high[i % 3] = Math.max(this.high[i % 3], state.position[i]);
    }
    if (state.count === 0) this.low = this.high = [0, 0, 0];
    this.uniforms.diameter.value = 0.5 * state.support_radius;
    setPoints(this.fluid, state.position, new Uint8Array(state.count * 4));
    const gray = rgb(themeColor("wall"));
    const tint = new Uint8Array((state.boundary.length / 3) * 4);
    for (let i = 0; i < tint.length; i += 4) tint.set([...gray, 255], i);
    setPoints(this.walls, state.boundary, tint);
  }

  showWhole() {
    const middle = new Vector3(...this.low).add(new Vector3(...this.high)).multiplyScalar(0.5);
    const size = new Vector3(...this.high).sub(new Vector3(...this.low)).length() || 1;
    const from = this.state.dimension === 2 ? new Vector3(0, 0, 1) : new Vector3(0.45, 0.35, 0.82);
    this.camera.near = size / 500;
    this.camera.far = size * 50;
    this.camera.position.copy(middle).addScaledVector(from, 1.1 * size);
    this.controls.target.copy(middle);
    this.controls.update();
  }

  // Shows what lies on one side of a plane: axis "x", "y", "z" or "none", place from 0 to 1.
  cut(axis, share, flipped) {
    const a = "xyz".indexOf(axis);
    const side = flipped ? -1 : 1;
    const normal = [0, 0, 0];
    if (a >= 0) normal[a] = side;
    const place = a < 0 ? 1 : side * (this.low[a] + share * (this.high[a] - this.low[a]));
    this.uniforms.cut.value.set(...normal, place);
  }

  isCutAway(i) {
    const { position } = this.state;
    const { x, y, z, w } = this.uniforms.cut.value;
    return x * position[3 * i] + y * position[3 * i + 1] + z * position[3 * i + 2] > w;
  }

  setTint(tint) {
    this.fluid.geometry.attributes.tint.array.set(tint);
    this.fluid.geometry.attributes.tint.needsUpdate = true;
  }

  // Lines of half a support radius from particles: [particle, direction] each.
  setNormals(all) {
    const normals = all.filter(([i]) => !this.isCutAway(i));
    const ends = new Float32Array(normals.length * 6);
    normals.forEach(([i, direction], n) => {
      for (let axis = 0; axis < 3; ++axis) {
        const start = this.state.position[3 * i + axis];
        ends[6 * n + axis] = start;
        ends[6 * n + 3 + axis] = start + 0.5 * this.state.support_radius * direction[axis];
      }
    });
    this.normals.geometry.dispose();
    this.normals.geometry = new BufferGeometry();
    this.normals.geometry.setAttribute("position", new BufferAttribute(ends, 3));
    this.normals.visible = normals.length > 0;
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!this.state || width === 0) return;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.renderer.setClearColor(new Color(themeColor("page")));
    this.normals.material.color.set(themeColor("ink"));
    this.uniforms.height.value = height * ratio;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
  }
}
