// The line as it stands, as people take it along: a model file, and lines of a coefficient header.

// C++ and JSON alike: what reads back to the same bits, always a floating-point number.
function numberText(value) {
  const text = String(value);
  return /[.e]/.test(text) ? text : `${text}.0`;
}

const isMoved = (line, plane) => line.k !== plane.k || line.d !== plane.d;

// A moved line was trained on nothing: it is written as one from elsewhere.
export function modelText(report, lines) {
  const model = structuredClone(report.model);
  if (lines.some((line, p) => isMoved(line, report.planes[p])))
    Object.assign(model, { objective: "moved by hand", d_margin: 0, training_files: [], false_negatives: 0, false_positives: 0 });
  [model, model.second_line].slice(0, lines.length).forEach((part, p) => {
    if (!isMoved(lines[p], report.planes[p])) return;
    Object.assign(part, { k: lines[p].k, d: lines[p].d, d_margin: 0 });
  });
  return JSON.stringify(model, null, 2) + "\n";
}

export const headerLines = ({ k, d }) =>
  `static constexpr double k = ${numberText(k)};\nstatic constexpr double d = ${numberText(d)};\n`;
