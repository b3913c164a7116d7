// What covers the sphere of one particle: caps of its neighbors, as docs/labels.md has them. Positions
// are rounded to the page's step here, which may put a neighbor at the limit h on its other side. Where
// the neighbor count is of just these neighbors, it says how many of them, the nearest, cover; elsewhere
// those within a step of the limit are out.

// Particles in cells of one support radius.
export class Cells {
  constructor(position, radius) {
    this.position = position;
    this.radius = radius;
    this.cells = new Map();
    for (let i = 0; i < position.length / 3; ++i) {
      const key = this.key(...[0, 1, 2].map((axis) => Math.floor(position[3 * i + axis] / radius)));
      const cell = this.cells.get(key);
      if (cell) cell.push(i);
      else this.cells.set(key, [i]);
    }
  }

  key(x, y, z) {
    return ((x + 1) * 131072 + y + 1) * 131072 + z + 1;
  }

  // Calls visit(j, dx, dy, dz) for all particles of the cells around a place.
  around(center, visit) {
    const [cx, cy, cz] = center.map((value) => Math.floor(value / this.radius));
    for (let x = cx - 1; x <= cx + 1; ++x)
      for (let y = cy - 1; y <= cy + 1; ++y)
        for (let z = cz - 1; z <= cz + 1; ++z)
          for (const j of this.cells.get(this.key(x, y, z)) ?? [])
            visit(j, ...[0, 1, 2].map((axis) => this.position[3 * j + axis] - center[axis]));
  }
}

// The caps on the sphere of particle i: unit direction, cosine of the angular radius, distance in h.
export function capsOf(state, i) {
  state.cells ??= {
    fluid: new Cells(state.position, state.support_radius),
    boundary: new Cells(state.boundary, state.support_radius),
  };
  const center = [...state.position.subarray(3 * i, 3 * i + 3)];
  const own = state.radii ? state.radii[i] : state.support_radius;
  const ratio = state.radius_ratio;
  const isCounted = !state.radii && state.boundary.length === 0;
  const caps = [];
  const add = (h, dx, dy, dz, wall) => {
    const distance = Math.hypot(dx, dy, dz) / h;
    const step = (1.5 * state.step) / h;
    if (distance >= 1 + (isCounted ? step : -step) || distance <= 1 - ratio) return;
    const cosine = (distance * distance + 1 - ratio * ratio) / (2 * distance);
    caps.push({ direction: [dx, dy, dz].map((value) => value / (distance * h)), cosine, distance, wall });
  };
  state.cells.fluid.around(center, (j, ...displacement) => {
    if (j === i || (state.phase && state.phase[j] !== state.phase[i])) return;
    add(state.radii ? (own + state.radii[j]) / 2 : own, ...displacement, false);
  });
  state.cells.boundary.around(center, (j, ...displacement) => add(own, ...displacement, true));
  caps.sort((a, b) => a.distance - b.distance);
  return isCounted ? caps.slice(0, state.neighborCount[i]) : caps;
}

// Directions spread evenly over the sphere, or in two dimensions over the circle.
export function directions(count, dimension) {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, n) => {
    if (dimension === 2) {
      const angle = (2 * Math.PI * (n + 0.5)) / count;
      return [Math.cos(angle), Math.sin(angle), 0];
    }
    const z = 1 - (2 * n + 1) / count;
    const r = Math.sqrt(1 - z * z);
    return [r * Math.cos(golden * n), r * Math.sin(golden * n), z];
  });
}

// The mean uncovered direction, which is the normal; null where all are covered.
export function uncoveredDirection(caps, tested) {
  const mean = [0, 0, 0];
  for (const [x, y, z] of tested)
    if (!caps.some(({ direction: [a, b, c], cosine }) => a * x + b * y + c * z >= cosine)) {
      mean[0] += x;
      mean[1] += y;
      mean[2] += z;
    }
  const length = Math.hypot(...mean);
  return length < 1e-9 ? null : mean.map((value) => value / length);
}
