// Legends: what the colours of lines and seabed mean, and what the signs are.

import { colourAt, DEPTH, STATES, VIRIDIS } from "./colours.js";
import { KINDS } from "./markers.js";
import { roundStep, short, ticks, words } from "./numbers.js";

const SIGNS = ["fixed point", "moved point", "free point"];
export const MIDDLE = VIRIDIS[(VIRIDIS.length - 1) / 2]; // of a quantity that has but one value
const EDGE = 8; // % of a scale near its ends, where labels stay inside

/** Where a quantity begins, and the factor to its share of the palette. */
export function shares({ low, high, states }) {
  if (states.length) return [-0.5, 1 / states.length];
  return high > low ? [low, 1 / (high - low)] : [low - 0.5, 1]; // one value: the middle of the palette
}

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
    const shift = share < EDGE ? share / (2 * EDGE) : share > 100 - EDGE ? 1 - (100 - share) / (2 * EDGE) : 0.5;
    return `<span style="left:${share.toFixed(2)}%;transform:translateX(${(-100 * shift).toFixed(0)}%)">${text(v, step)}</span>`;
  });
  return `<div class="bar" style="background:${gradient(palette)}"></div><div class="marks">${marks.join("")}</div>`;
}

export function lineLegend(quantity) {
  if (constant(quantity)) return state(MIDDLE, constant(quantity));
  if (!quantity.states.length) return bar(VIRIDIS, quantity.low, quantity.high, (v, step) => words(v, step));
  return quantity.states.map((name, i) => state(STATES[i], name)).join("");
}

function state(colour, name) {
  return `<div class="state"><i style="background:${colour}"></i>${name}</div>`;
}

/** Words for a quantity that is the same everywhere and always, empty for others. */
export function constant({ low, high, unit, states }) {
  return states.length || high > low ? "" : `${[short(low), unit].filter(Boolean).join(" ")} everywhere`;
}

export function depthLegend(seabed) {
  if (seabed.flat) return `<div class="label">Water depth <b>${short(-seabed.low)} m</b></div>`;
  const scale = bar(DEPTH, -seabed.high, -seabed.low, (v, step) => words(v, step));
  return `<div class="label">Water depth (m)</div>${scale}`;
}

export function signLegend({ markers, platforms, rods, bodies }) {
  const points = KINDS.map((kind, i) => [kind, SIGNS[i], markers.some((label) => label.kind.startsWith(kind))]);
  const others = [["rod", "rod", rods.length], ["body", "body", bodies.length], ["frame", "moved together", platforms.length]];
  return [...points, ...others]
    .filter(([, , shown]) => shown)
    .map(([kind, name]) => `<div class="sign"><i class="${kind}"></i>${name}</div>`)
    .join("");
}
