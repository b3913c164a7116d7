// Colors of the page, from its style, and scales for numbers: two that people of every color vision
// can read (viridis, and blue to orange by way of gray).

export const themeColor = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

export function rgb(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

const stops = {
  viridis: ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"].map(rgb),
  diverging: ["#2166ac", "#92c5de", "#dddddd", "#f4a582", "#b2182b"].map(rgb),
};

// Color of a share from 0 to 1.
export function scaleColor(name, share) {
  const colors = stops[name];
  const place = Math.min(Math.max(share, 0), 1) * (colors.length - 1);
  const low = Math.min(Math.floor(place), colors.length - 2);
  return colors[low].map((value, c) => value + (place - low) * (colors[low + 1][c] - value));
}

export const scaleGradient = (name) =>
  `linear-gradient(to right, ${stops[name].map((color) => `rgb(${color})`).join(", ")})`;

// Items of a legend: [color or gradient, words] each.
export function showLegend(list, items) {
  list.replaceChildren(
    ...items.map(([color, words, isBar]) => {
      const item = document.createElement("li");
      const mark = document.createElement("i");
      mark.style.background = color;
      if (isBar) mark.className = "bar";
      item.append(mark, words);
      return item;
    }),
  );
}
