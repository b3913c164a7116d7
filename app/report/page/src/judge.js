// The lines on particles, in double and by the runtime's own comparison, and the audit's counts
// (classifier/training_set/error_counts.hpp).

export const noCounts = () => ({ particles: 0, surface: 0, missed: 0, passed: 0, area: 0, missedArea: 0 });

// Lines follow the state's support radius over spacing: k and d in units of its own features.
const lineOf = ({ k, d }, [ofX, ofY]) => ({ k: (k * ofY) / ofX, d: d * ofY });

// Sets state.predicted by all lines together and returns the counts.
export function judge(state, lines) {
  const { count, neighborCount, predicted, surface, lambda } = state;
  if (lines.length === 0) predicted.set(surface);
  else predicted.fill(1);
  lines.forEach((line, p) => {
    const { x, y, scales } = state.planes[p];
    const { k, d } = lineOf(line, scales);
    for (let i = 0; i < count; ++i)
      if (!(line.above ? y[i] >= k * x[i] + d : y[i] <= k * x[i] + d)) predicted[i] = 0;
  });
  const counts = noCounts();
  counts.particles = count;
  for (let i = 0; i < count; ++i) {
    if (lines.length > 0 && neighborCount[i] === 0) predicted[i] = 1; // alone: surface whatever the line
    if (surface[i]) {
      counts.surface++;
      counts.area += lambda[i];
      if (!predicted[i]) {
        counts.missed++;
        counts.missedArea += lambda[i];
      }
    } else if (predicted[i]) counts.passed++;
  }
  return counts;
}

export function sum(all) {
  const total = noCounts();
  for (const counts of all) for (const name in total) total[name] += counts[name];
  return total;
}

export const share = (part, whole) => (whole === 0 ? 0 : part / whole);

// The d nearest to interior with which a line of this k misses no surface particle of these states.
export function constantThatMissesNone(states, p, line) {
  let d = line.above ? Infinity : -Infinity;
  for (const state of states) {
    const { x, y, scales } = state.planes[p];
    for (let i = 0; i < state.count; ++i) {
      if (!state.surface[i] || state.neighborCount[i] === 0) continue;
      const needed = y[i] / scales[1] - (line.k * x[i]) / scales[0];
      d = line.above ? Math.min(d, needed) : Math.max(d, needed);
    }
  }
  if (!Number.isFinite(d)) return line.d;
  const margin = 1e-9 * Math.max(1, Math.abs(d)); // above rounding
  return line.above ? d - margin : d + margin;
}
