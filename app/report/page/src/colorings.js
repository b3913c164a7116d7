// What particles in space are colored by.
import { rgb, scaleColor, scaleGradient, themeColor } from "./colors.js";

// As state.surface and state.predicted number them; colors of the style have the same names.
export const classNames = ["interior", "passed", "missed", "surface"];

const curvatureScale = (state) => {
  const sizes = Array.from(state.curvature, Math.abs).filter((value) => value > 0).sort((a, b) => a - b);
  return sizes.length > 0 ? sizes[Math.floor(0.95 * (sizes.length - 1))] : 1;
};

// How particles are colored: a function of the particle, and the legend.
export const colorings = {
  class(state) {
    const colors = [rgb(themeColor("interior")), rgb(themeColor("surface"))];
    return [(i) => colors[state.surface[i]],
      [[themeColor("surface"), "surface by label"], [themeColor("interior"), "interior"]]];
  },
  error(state) {
    const colors = classNames.map((name) => rgb(themeColor(name)));
    return [(i) => colors[2 * state.surface[i] + state.predicted[i]],
      [[themeColor("surface"), "surface, found"], [themeColor("interior"), "interior"],
        [themeColor("missed"), "false negative"], [themeColor("passed"), "false positive"]]];
  },
  uncovered(state) {
    return [(i) => scaleColor("viridis", 2 * state.lambda[i]),
      [[scaleGradient("viridis"), "uncovered fraction, 0 to 0.5", true]]];
  },
  curvature(state) {
    const scale = curvatureScale(state);
    return [(i) => scaleColor("diverging", 0.5 + state.curvature[i] / (2 * scale)),
      [[scaleGradient("diverging"), `mean curvature, -${scale.toPrecision(3)} to ${scale.toPrecision(3)} 1/m`, true]]];
  },
};
