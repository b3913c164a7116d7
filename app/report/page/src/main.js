// The page: what is chosen, and who is told when that changes. A link's fragment sets choices, as in
// page.html#d=30&state=2&pick=17: tests and people who share a view use it.
import { readReport } from "./data.js";
import { constantThatMissesNone, judge, sum } from "./judge.js";
import { capsOf, directions, uncoveredDirection } from "./coverage.js";
import { classNames, colorings } from "./colorings.js";
import { showLegend, themeColor } from "./colors.js";
import { headerLines, modelText } from "./model.js";
import { paintPlane, rangesOf } from "./plane.js";
import { CoveredSphere, maxCaps } from "./sphere.js";
import { Space } from "./space.js";
import { countTexts, showSources, showTable } from "./table.js";

const $ = (id) => document.getElementById(id);
const report = readReport();
const states = report.states.map((_, s) => report.state(s));
const isJudged = report.audit !== null; // else there are labels and no line
const lines = isJudged ? report.planes.map(({ k, d, above }) => ({ k, d, above })) : [];
const chosen = { state: 0, line: 0, picked: -1 };
let counts = [];
let ranges;
let space = null;
let sphere = null;

const current = () => states[chosen.state];
const framesOf = (scene) => states.map((_, s) => s).filter((s) => states[s].scene === scene);
const inScope = () => {
  const scope = $("scope").value;
  return states.map((_, s) => s).filter((s) =>
    scope === "all" || (scope === "scene" ? states[s].scene === current().scene : s === chosen.state));
};
const scopeStates = () => inScope().map((s) => states[s]);
const nameOf = (state, i) => (state.index ? state.index[i] : i);

// ---- what is shown ----

function option(value, text) {
  const element = document.createElement("option");
  element.value = value;
  element.textContent = text;
  return element;
}

function lineText({ k, d, above }, { features }) {
  return `${features[1]} ${above ? ">=" : "<="} ${+k.toPrecision(6)} ${features[0]} + ${+d.toPrecision(6)}`;
}

function showHeading() {
  $("program").textContent = `Written by ${report.program}.`;
  if (!isJudged) {
    $("title").textContent = "What the labels say of these states";
    $("heading").textContent = `Surface: more than ${+(100 * report.label_threshold).toPrecision(3)} % of the sphere is uncovered.`;
    return;
  }
  const { objective, label_threshold: trainedAt } = report.model;
  const model = report.planes.map((plane) => lineText(plane, plane)).join(" and ");
  $("heading").textContent =
    `${report.model_file}: surface where ${model} (${objective}); by label where more than ` +
    `${+(100 * report.label_threshold).toPrecision(3)} % of the sphere is uncovered` +
    (trainedAt === report.label_threshold ? "." : `; trained at ${+(100 * trainedAt).toPrecision(3)} %.`);
}

function showNotes() {
  const notes = [...report.notes, ...(report.audit?.warnings ?? [])];
  const byPage = sum(counts);
  const audited = report.audit?.total ?? { false_negatives: 0, false_positives: 0 };
  const differ = Math.abs(byPage.missed - audited.false_negatives) + Math.abs(byPage.passed - audited.false_positives);
  if (report.notes.length === 0 && differ > 0)
    notes.push(`${differ} particles lie so close to the line that this page rounds them to its other side.`);
  $("notes").replaceChildren(...notes.map((note) => {
    const item = document.createElement("li");
    item.textContent = note;
    return item;
  }));
}

function setSlider(id, value, [low, high]) {
  const slider = $(id);
  [slider.min, slider.max] = [Math.min(low, value), Math.max(high, value)];
  slider.value = value;
  $(`${id}-number`).value = value;
}

function showSliders() {
  if (!isJudged) return;
  const line = lines[chosen.line];
  const [x, y] = [ranges.x[1] - ranges.x[0], ranges.y[1] - ranges.y[0]];
  setSlider("k", line.k, [-(2 * y) / x, (4 * y) / x]);
  setSlider("d", line.d, [ranges.y[0] - 0.5 * y, ranges.y[1]]);
}

function showPlane() {
  const { features, meanings } = report.planes[chosen.line];
  const plane = current().planes[chosen.line];
  const i = chosen.picked;
  paintPlane($("plane"), {
    states: scopeStates(),
    p: chosen.line,
    ranges,
    line: lines[chosen.line],
    names: features,
    picked: i >= 0 ? [plane.x[i] / plane.scales[0], plane.y[i] / plane.scales[1]] : null,
  });
  $("plane").title = `${features[0]}: ${meanings[0]}\n${features[1]}: ${meanings[1]}`;
  const errors = [[themeColor("missed"), "false negatives (crosses)"], [themeColor("passed"), "false positives"]];
  showLegend($("plane-legend"), [
    [themeColor("surface"), isJudged ? "surface, found" : "surface"], [themeColor("interior"), "interior"],
    ...(isJudged ? errors : []),
  ]);
}

function showCounts() {
  const all = sum(inScope().map((s) => counts[s]));
  const texts = countTexts(all);
  for (const id in texts) $(id).textContent = texts[id];
  if (!isJudged) {
    $("plane").setAttribute("aria-label", `Particles in the plane of ${report.planes[0].features.join(" and ")}`);
    return;
  }
  $("plane").setAttribute("aria-label",
    `Particles in the plane of ${report.planes[chosen.line].features.join(" and ")}, with the line ` +
    `${lineText(lines[chosen.line], report.planes[chosen.line])}: ${all.missed} false negatives, ${all.passed} false positives`);
  const live = new Map(report.scenes.map((scene) => [scene, sum(framesOf(scene).map((s) => counts[s]))]));
  showTable(report.audit, live, sum(counts));
  $("header-lines").textContent = headerLines(lines[chosen.line]);
  $("model-text").textContent = modelText(report, lines);
}

// ---- the state in space ----

function showColors() {
  const state = current();
  const [colorOf, legend] = colorings[$("color").value](state);
  const onlySurface = $("only-surface").checked;
  showLegend($("space-legend"), legend);
  $("space").setAttribute("aria-label", `${state.count} particles of ${state.file} in space`);
  if (!space) return;
  const tint = new Uint8Array(4 * state.count);
  for (let i = 0; i < state.count; ++i) {
    tint.set(i === chosen.picked ? [255, 255, 0] : colorOf(i), 4 * i);
    tint[4 * i + 3] = !onlySurface || state.surface[i] || state.predicted[i] ? 255 : 0;
  }
  space.setTint(tint);
}

function normalsOf(state) {
  if (state.normals) return state.normals;
  const tested = directions(state.dimension === 2 ? 64 : 256, state.dimension);
  state.normals = [];
  for (let i = 0; i < state.count; ++i) {
    if (!state.surface[i]) continue;
    const stored = state.normal && [...state.normal.subarray(3 * i, 3 * i + 3)];
    const direction = stored && Math.hypot(...stored) > 0 ? stored : uncoveredDirection(capsOf(state, i), tested);
    if (direction) state.normals.push([i, direction]);
  }
  return state.normals;
}

function showSpace() {
  showColors();
  if (!space) return;
  space.walls.visible = $("walls").checked;
  space.cut($("clip-axis").value, Number($("clip").value), $("clip-flip").checked);
  space.setNormals($("normals").checked ? normalsOf(current()) : []);
  space.draw();
}

function row(name, value) {
  const line = document.createElement("tr");
  const head = document.createElement("th");
  head.scope = "row";
  const cell = document.createElement("td");
  head.textContent = name;
  cell.textContent = value;
  line.append(head, cell);
  return line;
}

function showPicked() {
  const state = current();
  const i = chosen.picked;
  $("picked").hidden = i < 0;
  $("pick").value = i < 0 ? "" : nameOf(state, i);
  if (i < 0) return;
  const caps = capsOf(state, i);
  const openDirection = uncoveredDirection(caps, directions(2000, state.dimension));
  const metres = (axis) => +(state.low[axis] + state.position[3 * i + axis]).toPrecision(6);
  const verdict = classNames[2 * state.surface[i] + state.predicted[i]];
  const rows = [
    row("particle", nameOf(state, i)),
    row("position in m", [0, 1, 2].slice(0, state.dimension).map(metres).join(", ")),
    row("uncovered fraction lambda", +state.lambda[i].toPrecision(6)),
    row(isJudged ? "it is" : "by label", !isJudged ? ["interior", "surface"][state.surface[i]] : { interior: "interior", passed: "a false positive", missed: "a false negative", surface: "surface, found" }[verdict]),
  ];
  report.planes.forEach(({ features }, p) => {
    const plane = state.planes[p];
    [plane.x, plane.y].forEach((values, f) => {
      if (p === 0 || !report.planes[0].features.includes(features[f]))
        rows.push(row(features[f], +values[i].toPrecision(6)));
    });
  });
  if (state.curvature) rows.push(row("mean curvature in 1/m", +state.curvature[i].toPrecision(5)));
  rows.push(row("caps of neighbors", caps.filter(({ wall }) => !wall).length));
  rows.push(row("caps of walls", caps.filter(({ wall }) => wall).length));
  if (caps.length > maxCaps) rows.push(row("drawn", `the nearest ${maxCaps} caps`));
  $("picked-numbers").replaceChildren(...rows);
  $("sphere").setAttribute("aria-label",
    `Sphere of particle ${nameOf(state, i)} with ${caps.length} caps; ${(100 * state.lambda[i]).toPrecision(4)} % is uncovered`);
  if (space && !sphere) sphere = new CoveredSphere($("sphere"));
  sphere?.show(caps, {
    ratio: state.radius_ratio, dimension: state.dimension, openDirection,
    withSpheres: $("neighbor-spheres").checked,
  });
}

// ---- what happens ----

function judgeAll() {
  counts = states.map((state) => judge(state, lines));
}

function lineMoved() {
  judgeAll();
  showSliders();
  showPlane();
  showCounts();
  showSpace();
}

function scopeChanged() {
  ranges = rangesOf(scopeStates(), chosen.line);
  lineMoved();
}

function stateChanged(isNewScene) {
  const state = current();
  const frames = framesOf(state.scene);
  $("scene").value = state.scene;
  $("frame").max = frames.length - 1;
  $("frame").value = frames.indexOf(chosen.state);
  $("frame").disabled = $("play").disabled = frames.length < 2;
  $("frame-name").textContent = state.file + (state.time === null ? "" : `, ${+state.time.toPrecision(6)} s`);
  $("color").querySelector("[value=curvature]").disabled = !state.curvature;
  if (!state.curvature && $("color").value === "curvature") $("color").value = "class";
  $("walls").disabled = state.boundary.length === 0;
  $("pick").max = nameOf(state, state.count - 1);
  space?.show(state);
  if (isNewScene) space?.showWhole();
  scopeChanged();
  showPicked();
}

function chooseState(s) {
  const isNewScene = states[s].scene !== current().scene;
  chosen.state = s;
  chosen.picked = -1;
  stateChanged(isNewScene);
}

function pick(i) {
  chosen.picked = i;
  showPicked();
  showPlane();
  showSpace();
}

function moveLine(change) {
  Object.assign(lines[chosen.line], change);
  lineMoved();
}

// One drawing a frame, however many events come.
function coalesced(work) {
  let waits = false;
  return (...words) => {
    if (waits) return;
    waits = true;
    requestAnimationFrame(() => {
      waits = false;
      work(...words);
    });
  };
}

function addLineControls() {
  for (const name of ["k", "d"])
    for (const id of [name, `${name}-number`])
      $(id).addEventListener("input", coalesced(() => {
        const value = $(id).valueAsNumber;
        if (Number.isFinite(value)) moveLine({ [name]: value });
      }));
  $("line").addEventListener("change", () => {
    chosen.line = Number($("line").value);
    scopeChanged();
  });
  $("zero").addEventListener("click", () =>
    moveLine({ d: constantThatMissesNone(scopeStates(), chosen.line, lines[chosen.line]) }));
  $("reset").addEventListener("click", () => {
    const { k, d } = report.planes[chosen.line];
    moveLine({ k, d });
  });
  for (const button of document.querySelectorAll("[data-copies]"))
    button.addEventListener("click", async () => {
      const text = $(button.dataset.copies);
      getSelection().selectAllChildren(text); // for browsers that let no page from disk copy
      await navigator.clipboard?.writeText(text.textContent);
    });
}

function addStateControls() {
  let timer = 0;
  const next = () => {
    const frames = framesOf(current().scene);
    chooseState(frames[(frames.indexOf(chosen.state) + 1) % frames.length]);
  };
  $("scene").addEventListener("change", () => chooseState(framesOf($("scene").value)[0]));
  $("frame").addEventListener("input", () => chooseState(framesOf(current().scene)[Number($("frame").value)]));
  $("scope").addEventListener("change", scopeChanged);
  $("play").addEventListener("click", () => {
    $("play").textContent = timer ? "Play" : "Pause";
    clearInterval(timer);
    timer = timer ? 0 : setInterval(next, 400);
  });
}

function addSpaceControls() {
  for (const id of ["color", "clip-axis", "clip", "clip-flip", "only-surface", "walls", "normals"])
    $(id).addEventListener("input", coalesced(showSpace));
  $("view-reset").addEventListener("click", () => space?.showWhole());
  $("neighbor-spheres").addEventListener("input", showPicked);
  $("pick").addEventListener("change", () => {
    const name = $("pick").valueAsNumber;
    const state = current();
    pick(state.index ? state.index.indexOf(name) : name >= 0 && name < state.count ? name : -1);
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => stateChanged(false));
  new ResizeObserver(coalesced(showPlane)).observe($("plane"));
}

// Choices out of the link's fragment.
function readFragment() {
  const words = new URLSearchParams(location.hash.slice(1));
  const number = (name) => (words.has(name) ? Number(words.get(name)) : NaN);
  if (words.has("scope")) $("scope").value = words.get("scope");
  if (number("state") in states) chooseState(number("state"));
  if (number("line") in lines) $("line").value = chosen.line = number("line");
  for (const [name, id] of [["color", "color"], ["cut", "clip-axis"], ["at", "clip"]])
    if (words.has(name)) $(id).value = words.get(name);
  for (const [name, id] of [["flip", "clip-flip"], ["walls", "walls"], ["normals", "normals"],
    ["surface", "only-surface"], ["spheres", "neighbor-spheres"]])
    if (words.has(name)) $(id).checked = words.get(name) !== "0";
  if (isJudged) for (const name of ["k", "d"]) if (Number.isFinite(number(name))) lines[chosen.line][name] = number(name);
  scopeChanged();
  // One part of the page alone, for pictures of it.
  if (words.has("show"))
    for (const part of document.querySelectorAll("header, main > section, footer"))
      part.hidden = !part.contains($(words.get("show")));
  if (words.has("zero")) $("zero").click();
  if (number("pick") >= 0 && number("pick") < current().count) pick(number("pick"));
  document.documentElement.dataset.ready = "yes";
}

function start() {
  $("scene").append(...report.scenes.map((scene) => option(scene, scene)));
  $("line").append(...report.planes.map(({ features }, p) =>
    option(p, `${["first", "second"][p]}: ${features[1]} over ${features[0]}`)));
  $("color").append(option("class", "class by label"), ...(isJudged ? [option("error", "error of the line")] : []),
    option("uncovered", "uncovered fraction"), option("curvature", "mean curvature"));
  $("color").value = isJudged ? "error" : "class";
  document.body.classList.toggle("labels-only", !isJudged);
  $("scope").value = "all";
  showHeading();
  showSources(report);
  judgeAll();
  showNotes();
  if (states.length === 0) {
    if (isJudged) showTable(report.audit, new Map(), undefined);
    return;
  }
  try {
    space = new Space($("space"), pick);
  } catch (error) {
    $("space-title").textContent = `The state in space needs WebGL: ${error.message}`;
  }
  addLineControls();
  addStateControls();
  addSpaceControls();
  stateChanged(true);
  readFragment();
  window.addEventListener("hashchange", readFragment);
}

start();
