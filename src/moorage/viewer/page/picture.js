// A picture of the page for reports: the scene at twice its size, with title, legends, scales and time.

import { colourAt, DEPTH, INK, STATES, VIRIDIS } from "./colours.js";
import { constant, MIDDLE, scaleTicks } from "./legend.js";
import { words } from "./numbers.js";

const SIZE = 2;
const QUIET = "#5c6b7a";

/** Draw the page on a new canvas. `facts` has title, time and the shown quantity. */
export function compose(stage, scales, seabed, facts) {
  const { width, height } = stage.size;
  const canvas = Object.assign(document.createElement("canvas"), { width: SIZE * width, height: SIZE * height });
  const c = canvas.getContext("2d");
  c.scale(SIZE, SIZE);
  const sky = c.createLinearGradient(0, 0, 0, height);
  sky.addColorStop(0, "#dce8f1");
  sky.addColorStop(1, "#f6f8f9");
  c.fillStyle = sky;
  c.fillRect(0, 0, width, height);
  c.drawImage(stage.renderer.domElement, 0, 0, width, height);
  for (const label of scales.labels.filter((l) => l.style.display !== "none")) {
    const [x, y] = label.style.transform
      .match(/translate\(([-\d.]+)px, ([-\d.]+)px\)/)
      .slice(1)
      .map(Number);
    text(c, label.textContent, x, y, { align: "center", colour: label.className ? INK : QUIET });
  }
  text(c, facts.title, 24, 30, { size: 16, weight: 600 });
  text(c, facts.below, 24, 52, { colour: QUIET });
  legend(c, width - 254, 30, facts.quantity);
  if (!seabed.flat) bar(c, width - 254, 92, "Water depth (m)", DEPTH, -seabed.high, -seabed.low);
  return canvas;
}

function legend(c, x, y, quantity) {
  const one = constant(quantity);
  if (!quantity.states.length && !one) {
    const title = quantity.unit ? `${quantity.label} (${quantity.unit})` : quantity.label;
    return bar(c, x, y, title, VIRIDIS, quantity.low, quantity.high);
  }
  return (one ? [`${quantity.label}: ${one}`] : quantity.states).forEach((name, i) => {
    c.fillStyle = one ? MIDDLE : STATES[i];
    c.fillRect(x, y - 4 + 18 * i, 18, 7);
    c.strokeStyle = INK;
    c.lineWidth = 1;
    c.strokeRect(x, y - 4 + 18 * i, 18, 7);
    text(c, name, x + 26, y + 18 * i);
  });
}

function bar(c, x, y, title, palette, low, high) {
  text(c, title, x, y, { weight: 600 });
  for (let i = 0; i < 230; i++) {
    c.fillStyle = `rgb(${colourAt(palette, i / 229).join()})`;
    c.fillRect(x + i, y + 12, 1.5, 10);
  }
  const { values, step } = scaleTicks(low, high);
  for (const v of values)
    text(c, words(v, step), x + (230 * (v - low)) / (high - low), y + 34, { align: "center", colour: QUIET });
}

function text(c, words_, x, y, { size = 12, weight = 400, align = "left", colour = INK } = {}) {
  c.font = `${weight} ${size}px system-ui, sans-serif`;
  c.textAlign = align;
  c.textBaseline = "middle";
  c.strokeStyle = "rgba(255, 255, 255, 0.8)";
  c.lineWidth = 3;
  c.strokeText(words_, x, y);
  c.fillStyle = colour;
  c.fillText(words_, x, y);
}
