// A plot on a canvas: curves over time or along a line, with a cursor.

import { INK } from "./colours.js";
import { ticks, words } from "./numbers.js";

const MARGIN = { left: 54, right: 12, top: 10, bottom: 34 };
const QUIET = "#5c6b7a";

export class Plot {
  constructor(canvas) {
    this.canvas = canvas;
    this.still = document.createElement("canvas"); // all but the cursor, drawn once
  }

  /** Draw curves {x, y, colour}; x and y are arrays of numbers. */
  show({ curves, xLabel, yLabel, range = null }) {
    const ratio = window.devicePixelRatio || 1;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    for (const canvas of [this.canvas, this.still])
      Object.assign(canvas, { width: width * ratio, height: height * ratio });
    Object.assign(this, { ratio, width, height });
    this.x = extent(curves.map((curve) => curve.x));
    this.y = range ?? padded(extent(curves.map((curve) => curve.y)));
    const c = this.still.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    this.axes(c, xLabel, yLabel);
    for (const curve of curves) this.curve(c, curve);
    this.cursor(null);
  }

  axes(c, xLabel, yLabel) {
    c.font = "11px system-ui, sans-serif";
    c.lineWidth = 1;
    const [bottom, right] = [this.height - MARGIN.bottom, this.width - MARGIN.right];
    const ys = ticks(...this.y, 4);
    const xs = ticks(...this.x, 6);
    c.strokeStyle = "#e3e8ed";
    c.fillStyle = QUIET;
    c.textBaseline = "middle";
    c.textAlign = "right";
    for (const v of ys) {
      line(c, MARGIN.left, this.py(v), right, this.py(v));
      c.fillText(words(v, ys[1] - ys[0] || 1), MARGIN.left - 6, this.py(v));
    }
    c.textAlign = "center";
    c.textBaseline = "top";
    for (const v of xs) c.fillText(words(v, xs[1] - xs[0] || 1), this.px(v), bottom + 5);
    c.fillText(xLabel, (MARGIN.left + right) / 2, bottom + 19);
    c.save();
    c.translate(9, (MARGIN.top + bottom) / 2);
    c.rotate(-Math.PI / 2);
    c.textBaseline = "middle";
    c.fillText(yLabel, 0, 0);
    c.restore();
    c.strokeStyle = "#9aa7b3";
    line(c, MARGIN.left, bottom, right, bottom);
  }

  curve(c, { x, y, colour }) {
    c.strokeStyle = colour;
    c.lineWidth = 1.4;
    c.lineJoin = "round";
    c.beginPath();
    for (let i = 0; i < x.length; i++) c.lineTo(this.px(x[i]), this.py(y[i]));
    c.stroke();
  }

  /** Move the cursor to a value of x. */
  cursor(x) {
    const c = this.canvas.getContext("2d");
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, this.canvas.width, this.canvas.height);
    c.drawImage(this.still, 0, 0);
    if (x === null) return;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.strokeStyle = INK;
    c.lineWidth = 1;
    line(c, this.px(x), MARGIN.top, this.px(x), this.height - MARGIN.bottom);
  }

  px(v) {
    return MARGIN.left + ((v - this.x[0]) / (this.x[1] - this.x[0])) * (this.width - MARGIN.left - MARGIN.right);
  }

  py(v) {
    const size = this.height - MARGIN.top - MARGIN.bottom;
    return this.height - MARGIN.bottom - ((v - this.y[0]) / (this.y[1] - this.y[0])) * size;
  }

  /** The value of x under a pixel. */
  under(pixel) {
    const share = (pixel - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right);
    return this.x[0] + Math.min(Math.max(share, 0), 1) * (this.x[1] - this.x[0]);
  }
}

function line(c, x0, y0, x1, y1) {
  c.beginPath();
  c.moveTo(x0, y0);
  c.lineTo(x1, y1);
  c.stroke();
}

function extent(arrays) {
  const all = arrays.flatMap((values) => Array.from(values));
  return [all.reduce((a, b) => Math.min(a, b), Infinity), all.reduce((a, b) => Math.max(a, b), -Infinity)];
}

/** A range with room at both ends, a share of it. */
export function padded([low, high], share = 0.06) {
  const room = high > low ? share * (high - low) : Math.max(0.05 * Math.abs(high), 1e-6);
  return [low - room, high + room];
}
