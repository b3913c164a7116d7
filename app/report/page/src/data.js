// The report's data, as the command wrote them into the page: JSON with arrays that are compressed
// by deflate and written in base64 (app/report/packed_arrays.hpp).
import { unzlibSync } from "fflate";

function bytesOf(packed) {
  const text = atob(packed);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return unzlibSync(bytes);
}

// Numbers of a type; a copy, since they begin at a multiple of their size.
const numbers = (Type, packed) => new Type(bytesOf(packed).slice().buffer);

// Whole steps, all x, then all y, then all z, as metres from the corner, a row a particle.
function positions(packed, step) {
  const steps = numbers(Uint16Array, packed);
  const count = steps.length / 3;
  const metres = new Float32Array(steps.length);
  for (let i = 0; i < count; ++i)
    for (let axis = 0; axis < 3; ++axis) metres[3 * i + axis] = steps[axis * count + i] * step;
  return metres;
}

// Unpacks one state; the arrays of features by the planes of the model's lines.
function unpack(json, planes) {
  const { arrays } = json;
  const optional = (Type, name) => (arrays[name] ? numbers(Type, arrays[name]) : null);
  const feature = (name) => numbers(Float64Array, arrays[name]);
  return {
    ...json,
    position: positions(arrays.position, json.step),
    boundary: arrays.boundary ? positions(arrays.boundary, json.step) : new Float32Array(0),
    planes: planes.map(({ features }, p) => ({
      x: feature(features[0]),
      y: feature(features[1]),
      scales: json.scales[p],
    })),
    neighborCount: feature("neighbor_count"),
    surface: numbers(Uint8Array, arrays.surface),
    lambda: numbers(Float32Array, arrays.uncovered_fraction),
    normal: optional(Float32Array, "normal"),
    curvature: optional(Float32Array, "curvature"),
    phase: optional(Float32Array, "phase"),
    radii: optional(Float32Array, "support_radius"),
    index: optional(Uint32Array, "index"),
    predicted: new Uint8Array(json.count),
  };
}

export function readReport() {
  const report = JSON.parse(document.getElementById("report").textContent);
  const unpacked = new Map();
  return {
    ...report,
    scenes: [...new Set(report.states.map(({ scene }) => scene))],
    // States are unpacked when they are first looked at.
    state(s) {
      if (!unpacked.has(s)) unpacked.set(s, unpack(report.states[s], report.planes));
      return unpacked.get(s);
    },
  };
}
