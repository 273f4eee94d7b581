// Legends: what the colours of lines and seabed mean, and what the signs are.

import { colourAt, DEPTH, STATES, VIRIDIS } from "./colours.js";
import { KINDS } from "./markers.js";
import { roundStep, short, ticks, words } from "./numbers.js";

const SIGNS = ["fixed point", "moved point", "free point"];

/** The values of a scale that get a label, and their step. */
export function scaleTicks(low, high, count = 4) {
  const values = ticks(low, high, count);
  return { values, step: values.length > 1 ? values[1] - values[0] : roundStep((high - low) / count) };
}

function gradient(palette) {
  const stops = Array.from({ length: 17 }, (_, i) => `rgb(${colourAt(palette, i / 16).join()})`);
  return `linear-gradient(to right, ${stops.join()})`;
}

function bar(palette, low, high, text) {
  const { values, step } = scaleTicks(Math.min(low, high), Math.max(low, high));
  const marks = values.map((v) => {
    const share = (100 * (v - low)) / (high - low);
    return `<span style="left:${share.toFixed(2)}%">${text(v, step)}</span>`;
  });
  return `<div class="bar" style="background:${gradient(palette)}"></div><div class="marks">${marks.join("")}</div>`;
}

export function lineLegend(quantity) {
  if (!quantity.states.length) return bar(VIRIDIS, quantity.low, quantity.high, (v, step) => words(v, step));
  return quantity.states
    .map((name, i) => `<div class="state"><i style="background:${STATES[i]}"></i>${name}</div>`)
    .join("");
}

export function depthLegend(seabed) {
  if (seabed.flat) return `<div class="label">Water depth <b>${short(-seabed.low)} m</b></div>`;
  const scale = bar(DEPTH, -seabed.high, -seabed.low, (v, step) => words(v, step));
  return `<div class="label">Water depth (m)</div>${scale}`;
}

export function signLegend(labels) {
  return KINDS.map((kind, i) => [kind, SIGNS[i]])
    .filter(([kind]) => labels.some((label) => label.kind.startsWith(kind)))
    .map(([kind, name]) => `<div class="sign"><i class="${kind}"></i>${name}</div>`)
    .join("");
}
