// Distances along the edges of the seabed, levels along an upright, and the axes in the corner.

import { ticks, words } from "./numbers.js";

const SHORTEST = 46; // pixels between two labels
const ALONG = 0.3; // an edge that is seen shorter than this part of its length points at the eye: no labels

export class Scales {
  constructor(holder, axes, meta, seabed, step) {
    this.holder = holder;
    this.axes = axes;
    this.meta = meta;
    this.seabed = seabed;
    this.step = step;
    this.labels = [];
  }

  /** Put the labels where the camera has them. */
  place(stage) {
    this.used = 0;
    const m = stage.matrix();
    const [x0, y0, x1, y1] = this.meta.region;
    const away = stage.camera.position.clone().sub(stage.controls.target);
    const [farX, farY] = [away.x > 1e-6 * away.length() ? x0 : x1, away.y > 0 ? y0 : y1];
    const [nearX, nearY] = [x0 + x1 - farX, y0 + y1 - farY];
    const floor = (x, y) => [x, y, this.seabed.floor];
    const centre = floor((x0 + x1) / 2, (y0 + y1) / 2);
    const middle = stage.pixel(...centre, m);
    this.perMetre = stage.perMetre(...centre);
    this.edge(stage, m, ticks(x0, x1, (x1 - x0) / this.step), (v) => floor(v, nearY), 0, middle);
    this.edge(stage, m, ticks(y0, y1, (y1 - y0) / this.step), (v) => floor(nearX, v), 1, middle);
    const corners = [
      { x: farX, y: nearY },
      { x: nearX, y: farY },
    ]; // beside what is seen
    this.upright(stage, m, corners);
    this.labels.slice(this.used).forEach((label) => (label.style.display = "none"));
    this.turnAxes(stage);
  }

  edge(stage, m, values, at, axis, middle) {
    const places = values.map((v) => [v, stage.pixel(...at(v), m)]).filter(([, p]) => p);
    if (places.length < 2 || !middle) return;
    const [a, b] = [places[0][1], places[places.length - 1][1]];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const every = Math.max(1, Math.ceil((SHORTEST * places.length) / Math.max(length, 1)));
    if (length < Math.max(2 * SHORTEST, ALONG * this.perMetre * (values[values.length - 1] - values[0]))) return;
    const out = this.outward(a, b, middle, 15);
    places.forEach(([v, p], i) => {
      const text = words(v + this.meta.origin[axis], this.step);
      if (Math.round(v / this.step) % every === 0) this.label(text, p[0] + out[0], p[1] + out[1]);
    });
    const [u, v] = this.outward(a, b, middle, 1);
    const far = 34 + 24 * Math.abs(u); // labels are wider than high
    this.label(`${"xy"[axis]} (m)`, (a[0] + b[0]) / 2 + far * u, (a[1] + b[1]) / 2 + far * v, "name");
  }

  upright(stage, m, corners) {
    const ends = corners.map(({ x, y }) => {
      const low = this.seabed.levelAt(x, y);
      return { x, y, low, top: stage.pixel(x, y, 0, m), foot: stage.pixel(x, y, low, m) };
    });
    const [left] = ends.filter(({ top, foot }) => top && foot).sort((a, b) => a.top[0] - b.top[0]);
    if (!left) return;
    const { x, y, low, top, foot } = left;
    const seen = Math.hypot(top[0] - foot[0], top[1] - foot[1]);
    if (seen < Math.max(40, ALONG * this.perMetre * stage.stretch * Math.abs(low))) return;
    const step = this.zStep(low);
    const every = Math.max(1, Math.ceil((22 * Math.abs(low)) / (Math.abs(top[1] - foot[1]) * step)));
    for (const z of ticks(low, 0, Math.abs(low) / step)) {
      const p = stage.pixel(x, y, z, m);
      if (p && Math.round(z / step) % every === 0) this.label(words(z, step), p[0] - 20, p[1]);
    }
    this.label("z (m)", top[0] - 16, top[1] - 18, "name");
  }

  zStep(low) {
    const steps = ticks(low, 0, 4);
    return steps.length > 1 ? steps[1] - steps[0] : Math.abs(low);
  }

  /** A vector of some pixels across an edge, away from the middle of the seabed. */
  outward(a, b, middle, pixels) {
    const size = Math.hypot(b[0] - a[0], b[1] - a[1]);
    let n = [-(b[1] - a[1]) / size, (b[0] - a[0]) / size];
    if (n[0] * (middle[0] - a[0]) + n[1] * (middle[1] - a[1]) > 0) n = n.map((v) => -v);
    return n.map((v) => v * pixels);
  }

  label(text, x, y, kind = "") {
    const label = (this.labels[this.used] ??= this.holder.appendChild(document.createElement("span")));
    this.used += 1;
    if (label.textContent !== text) label.textContent = text;
    label.className = kind;
    label.style.display = "";
    label.style.transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  turnAxes(stage) {
    const e = stage.camera.matrixWorldInverse.elements;
    [0, 1, 2].forEach((k) => {
      const [u, v] = [26 * e[4 * k], -26 * e[4 * k + 1]];
      const [line, text] = this.axes.children[k].children;
      line.setAttribute("x2", u);
      line.setAttribute("y2", v);
      text.setAttribute("x", 1.36 * u);
      text.setAttribute("y", 1.36 * v);
      this.axes.children[k].style.opacity = Math.hypot(u, v) < 5 ? 0 : 1;
    });
  }
}
