// The panel of the line that was clicked: tension at its ends over time, or the shown quantity along it.

import { ENDS } from "./colours.js";
import { words } from "./numbers.js";
import { padded, Plot } from "./plot.js";

const NOTHING = 1e-6; // beside a highest value of 1

export class Panel {
  constructor(root, meta, history) {
    this.root = root;
    this.meta = meta;
    this.times = meta.historyTime;
    this.history = history;
    this.line = null;
    this.along = !meta.moving;
    this.plot = new Plot(root.querySelector("canvas"));
    this.find = (name) => root.querySelector(`[data-part=${name}]`);
    this.find("over").hidden = this.find("along").hidden = !meta.moving;
  }

  get open() {
    return this.line !== null;
  }

  /** Show a line; null closes the panel. */
  show(line) {
    this.line = line;
    this.root.hidden = line === null;
    if (line === null) return;
    const { name, ends } = this.meta.lines[line];
    this.find("title").textContent = name;
    this.series = [0, 1].map((end) => this.times.map((_, row) => this.history.at(row, 2 * line + end)));
    this.most = this.series.flat().reduce((a, b) => Math.max(a, Math.abs(b)), 0);
    this.find("rows").innerHTML = this.series
      .map((values, end) => {
        const range = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
        const cells = this.meta.moving ? range.map((v) => `<td>${this.told(v)}</td>`).join("") : "";
        const sign = `<i style="background:${ENDS[end]}"></i>`;
        const what = `${sign}end ${"AB"[end]} <small>${ends[end]}</small>`;
        return `<tr><th>${what}</th><td data-end="${end}"></td>${cells}</tr>`;
      })
      .join("");
    this.root.querySelectorAll("[data-moving]").forEach((cell) => (cell.hidden = !this.meta.moving));
  }

  /** Words for a tension; what is nothing beside the highest one is 0. */
  told(value) {
    return words(Math.abs(value) < NOTHING * this.most ? 0 : value);
  }

  /** Draw the curves. `values` holds the shown quantity of every node. */
  draw(time, quantity, values) {
    if (!this.open) return;
    this.find("over").setAttribute("aria-pressed", !this.along);
    this.find("along").setAttribute("aria-pressed", this.along);
    if (this.along) {
      const { first, last, arc } = this.meta.lines[this.line];
      this.plot.show({
        curves: [{ x: arc, y: Array.from(values.subarray(first, last + 1)), colour: "#35608d" }],
        xLabel: "arc length from end A (m)",
        yLabel: quantity.unit ? `${quantity.label.toLowerCase()} (${quantity.unit})` : quantity.label.toLowerCase(),
        range: padded([quantity.low, quantity.high], 0.04),
      });
    } else {
      const curves = this.series.map((y, end) => ({ x: this.times, y, colour: ENDS[end] }));
      this.plot.show({ curves, xLabel: "time (s)", yLabel: "tension (kN)" });
    }
    this.now(time);
  }

  /** Show the values at a time: `row` and `share` say where it is in the history. */
  now(time, [row, share] = [0, 0]) {
    if (!this.open) return;
    if (!this.along) this.plot.cursor(time);
    this.root.querySelectorAll("[data-end]").forEach((cell, end) => {
      const next = Math.min(row + 1, this.times.length - 1);
      const [a, b] = [this.series[end][row], this.series[end][next]];
      cell.textContent = this.told(a + share * (b - a));
    });
  }
}
