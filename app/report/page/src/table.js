// The audit's table, sortable by every column, and where each figure comes from.
import { share } from "./judge.js";

const percent = (value, digits = 2) => `${(100 * value).toFixed(digits)} %`;

// Of each column: its name, its value for a row, how that is shown, and where it comes from.
const columns = [
  ["scene", (row) => row.scene, String, "The option --scene, else what the file stores, else its name without a frame number."],
  ["files", (row) => row.files.length, String, "Labelled snapshots of the scene, and how many of them the model was trained on: told by the hash of their bytes."],
  ["trained on", (row) => row.files_trained_on, String, null],
  ["particles", (row) => row.particles, String, "Valid ones."],
  ["surface", (row) => row.surface, String, "By label: particles whose uncovered fraction lambda, as the file stores it, is above the label threshold."],
  ["missed", (row) => row.false_negatives, String, "False negatives: surface by label, interior by the model, whose features are worked out anew from the positions, in double."],
  ["in float", (row) => row.false_negatives_float, String, "The same with positions, features and line in float."],
  ["missed area", (row) => row.missed_area, (v) => percent(v, 4), "Sum of lambda over the false negatives, over that of all surface particles."],
  ["false positives", (row) => row.false_positives, String, "Not surface by label, surface by the model, in double."],
  ["of all", (row) => row.false_positive_rate, percent, "False positives over all particles."],
  ["of interior", (row) => row.false_positive_rate_interior, percent, "False positives over the particles that are not surface by label."],
  ["uncovered", (row) => row.false_positives_after_coverage_check, String, "False positives that a coverage check leaves: lambda above 0 and at most the label threshold."],
  ["missed by the line as moved", (row) => row.live?.missed ?? NaN, (v) => (Number.isNaN(v) ? "not drawn" : String(v)), "As missed, counted by this page with the line as it stands now, over the states that it holds."],
  ["false positives then", (row) => row.live?.passed ?? NaN, (v) => (Number.isNaN(v) ? "not drawn" : String(v)), "As false positives, counted likewise."],
];

let sorted = { column: 0, down: false, asked: false };

function cell(row, [, value, text], kind = "td") {
  const element = document.createElement(kind);
  element.textContent = text(value(row));
  return element;
}

function lineOf(row) {
  const line = document.createElement("tr");
  line.append(...columns.map((column) => cell(row, column)));
  return line;
}

function inOrder(rows) {
  if (!sorted.asked) return rows;
  const value = columns[sorted.column][1];
  const sign = sorted.down ? -1 : 1;
  return [...rows].sort((a, b) => sign * (value(a) < value(b) ? -1 : value(a) > value(b) ? 1 : 0));
}

function heads(repeat) {
  const line = document.createElement("tr");
  columns.forEach(([name], c) => {
    const head = document.createElement("th");
    head.scope = "col";
    const isSorted = sorted.asked && sorted.column === c;
    head.setAttribute("aria-sort", isSorted ? (sorted.down ? "descending" : "ascending") : "none");
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = name + (isSorted ? (sorted.down ? " \u25be" : " \u25b4") : "");
    button.addEventListener("click", () => {
      sorted = { column: c, down: isSorted ? !sorted.down : c > 0, asked: true };
      repeat();
      document.querySelectorAll("#audit th button")[c].focus();
    });
    head.append(button);
    line.append(head);
  });
  return line;
}

// Rows of the audit with the counts that the page makes, by scene; `live` may lack scenes.
export function showTable(audit, live, liveTotal) {
  const table = document.getElementById("audit");
  const rows = audit.scenes.map((row) => ({ ...row, live: live.get(row.scene) }));
  const repeat = () => showTable(audit, live, liveTotal);
  table.tHead.replaceChildren(heads(repeat));
  table.tBodies[0].replaceChildren(...inOrder(rows).map(lineOf));
  table.tFoot.replaceChildren(lineOf({ ...audit.total, live: liveTotal }));
}

const term = (name, text) => {
  const dt = document.createElement("dt");
  const dd = document.createElement("dd");
  dt.textContent = name;
  dd.textContent = text;
  return [dt, dd];
};

const provenanceText = ({ provenance }) =>
  Object.entries(provenance)
    .map(([name, value]) => `${name} ${value}`)
    .join(", ");

export function showSources(report) {
  const list = document.getElementById("sources");
  for (const [name, , , source] of columns) if (source) list.append(...term(name, source));
  for (const state of report.states)
    list.append(...term(`${state.file} (${state.scene})`, `${state.count} particles; ${provenanceText(state)}`));
}

export const countTexts = (counts) => ({
  particles: counts.particles,
  surface: counts.surface,
  "false-negatives": counts.missed,
  "missed-area": percent(share(counts.missedArea, counts.area), 4),
  "false-positives": counts.passed,
  "false-positive-rate": percent(share(counts.passed, counts.particles)),
  "false-positive-rate-interior": percent(share(counts.passed, counts.particles - counts.surface)),
});
