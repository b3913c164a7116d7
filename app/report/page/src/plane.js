// The feature plane on a canvas: particles in cells, the denser the stronger, and the line.
import { rgb, themeColor } from "./colors.js";

const margin = { left: 52, right: 12, top: 10, bottom: 40 };

// What the axes span: all particles of these states, in the units of the model.
export function rangesOf(states, p) {
  const ranges = { x: [0, 0], y: [0, 0], whole: true };
  for (const state of states) {
    const { x, y, scales } = state.planes[p];
    ranges.whole &&= scales[1] === states[0].planes[p].scales[1];
    for (let i = 0; i < state.count; ++i) {
      ranges.x[1] = Math.max(ranges.x[1], x[i] / scales[0]);
      ranges.x[0] = Math.min(ranges.x[0], x[i] / scales[0]);
      ranges.y[1] = Math.max(ranges.y[1], y[i] / scales[1]);
      ranges.y[0] = Math.min(ranges.y[0], y[i] / scales[1]);
      ranges.whole &&= Number.isInteger(y[i]);
    }
  }
  ranges.unit = ranges.whole && states.length > 0 ? 1 / states[0].planes[p].scales[1] : 0;
  for (const axis of ["x", "y"]) ranges[axis][1] += 0.04 * (ranges[axis][1] - ranges[axis][0]) || 1;
  return ranges;
}

function niceStep(span, parts) {
  const rough = span / parts;
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= rough);
}

// Numbers of the four classes in cells of a few pixels; y in rows of whole numbers where it is whole.
function cellsOf(states, p, ranges, width, height) {
  const across = Math.max(1, Math.floor(width / 2));
  const row = (height * ranges.unit) / (ranges.y[1] - ranges.y[0]);
  const down = row > 2 ? Math.ceil((ranges.y[1] - ranges.y[0]) / ranges.unit) : Math.max(1, Math.floor(height / 2));
  const cells = new Uint32Array(across * down * 4);
  const toX = across / (ranges.x[1] - ranges.x[0]);
  const toY = row > 2 ? 1 / ranges.unit : down / (ranges.y[1] - ranges.y[0]);
  for (const state of states) {
    const { x, y, scales } = state.planes[p];
    for (let i = 0; i < state.count; ++i) {
      const cx = Math.min(across - 1, Math.floor((x[i] / scales[0] - ranges.x[0]) * toX));
      const cy = Math.min(down - 1, Math.floor((y[i] / scales[1] - ranges.y[0]) * toY + 1e-9));
      cells[4 * (cy * across + cx) + 2 * state.surface[i] + state.predicted[i]]++;
    }
  }
  return { cells, across, down, cellHeight: row > 2 ? row : height / down };
}

function paintCells(context, { cells, across, down, cellHeight }, area) {
  // Interior, passed by the line, missed, found: as state.surface and state.predicted number them.
  const colors = ["interior", "passed", "missed", "surface"].map((name) => rgb(themeColor(name)));
  let most = 1;
  for (let c = 0; c < cells.length; c += 4)
    most = Math.max(most, cells[c] + cells[c + 1] + cells[c + 2] + cells[c + 3]);
  const cellWidth = area.width / across;
  for (let c = 0; c < across * down; ++c) {
    const counts = cells.subarray(4 * c, 4 * c + 4);
    const all = counts[0] + counts[1] + counts[2] + counts[3];
    if (all === 0) continue;
    const mixed = [0, 1, 2].map((part) => counts.reduce((sum, n, k) => sum + (n * colors[k][part]) / all, 0));
    const strength = 0.45 + (0.55 * Math.log(1 + all)) / Math.log(1 + most);
    context.fillStyle = `rgba(${mixed.map(Math.round)}, ${strength})`;
    const x = area.left + (c % across) * cellWidth;
    const y = area.top + area.height - (Math.floor(c / across) + 1) * cellHeight;
    context.fillRect(x, y + 0.15 * cellHeight, cellWidth, Math.max(1, 0.7 * cellHeight));
  }
}

function paintAxes(context, ranges, area, names) {
  context.strokeStyle = themeColor("edge");
  context.fillStyle = themeColor("ink");
  context.strokeRect(area.left, area.top, area.width, area.height);
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "center";
  const ticks = ([low, high]) => {
    const step = niceStep(high - low, 6);
    const first = Math.ceil(low / step);
    return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, n) => +((first + n) * step).toPrecision(6));
  };
  for (const tick of ticks(ranges.x)) context.fillText(tick, area.x(tick), area.top + area.height + 16);
  context.fillText(names[0], area.left + area.width / 2, area.top + area.height + 33);
  context.textAlign = "right";
  for (const tick of ticks(ranges.y)) context.fillText(tick, area.left - 6, area.y(tick) + 4);
  context.save();
  context.translate(13, area.top + area.height / 2);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText(names[1], 0, 0);
  context.restore();
}

// Missed particles as crosses, which stand out however few they are.
function paintMissed(context, states, p, area) {
  context.strokeStyle = themeColor("missed");
  context.lineWidth = 1.5;
  context.beginPath();
  let left = 5000;
  for (const state of states) {
    const { x, y, scales } = state.planes[p];
    for (let i = 0; i < state.count && left > 0; ++i) {
      if (!state.surface[i] || state.predicted[i]) continue;
      const px = area.x(x[i] / scales[0]);
      const py = area.y(y[i] / scales[1]);
      context.moveTo(px - 4, py - 4);
      context.lineTo(px + 4, py + 4);
      context.moveTo(px - 4, py + 4);
      context.lineTo(px + 4, py - 4);
      --left;
    }
  }
  context.stroke();
}

function paintLine(context, line, ranges, area) {
  context.save();
  context.beginPath();
  context.rect(area.left, area.top, area.width, area.height);
  context.clip();
  context.strokeStyle = themeColor("ink");
  context.lineWidth = 2;
  context.beginPath();
  for (const x of ranges.x) context.lineTo(area.x(x), area.y(line.k * x + line.d));
  context.stroke();
  context.restore();
}

export function paintPlane(canvas, { states, p, ranges, line, names, picked }) {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = canvas.clientWidth * ratio;
  canvas.height = canvas.clientHeight * ratio;
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  const area = {
    left: margin.left,
    top: margin.top,
    width: canvas.clientWidth - margin.left - margin.right,
    height: canvas.clientHeight - margin.top - margin.bottom,
    x: (x) => area.left + ((x - ranges.x[0]) / (ranges.x[1] - ranges.x[0])) * area.width,
    y: (y) => area.top + area.height * (1 - (y - ranges.y[0]) / (ranges.y[1] - ranges.y[0])),
  };
  paintCells(context, cellsOf(states, p, ranges, area.width, area.height), area);
  paintMissed(context, states, p, area);
  if (line) paintLine(context, line, ranges, area);
  paintAxes(context, ranges, area, names);
  if (picked) {
    context.strokeStyle = themeColor("ink");
    context.lineWidth = 2;
    context.beginPath();
    context.arc(area.x(picked[0]), area.y(picked[1]), 8, 0, 2 * Math.PI);
    context.stroke();
  }
}
