// The scene and its state: builds what is shown, moves it with time, and draws what has changed.

import { STATES, strip, VIRIDIS } from "./colours.js";
import { placeOf } from "./data.js";
import { depthLegend, lineLegend, shares, signLegend } from "./legend.js";
import { FatLines } from "./lines.js";
import { Bodies, Markers } from "./markers.js";
import { roundStep, words } from "./numbers.js";
import { Panel } from "./panel.js";
import { compose } from "./picture.js";
import { Scales } from "./scales.js";
import { Sea } from "./sea.js";
import { Seabed } from "./seabed.js";
import { Stage } from "./stage.js";

const find = (id) => document.getElementById(id);
const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
const CLOSE = 0.25; // how much of a line's span a close view shows around what moves
const DEEP = 4; // times the mooring's width: a deeper seabed is not shown at first
const RIM = [0.08, 0.11, 0.15, 1];

export class App {
  constructor(meta, tables) {
    this.meta = meta;
    this.tables = tables;
    this.times = this.meta.time;
    this.duration = this.times[this.times.length - 1] - this.times[0];
    this.interval = this.times.length > 1 ? this.duration / (this.times.length - 1) : 0;
    this.digits = Math.max(1, Math.ceil(-Math.log10(this.interval || 1) - 1e-6)); // of times
    this.nudge = Math.max(this.interval, roundStep(this.duration / 600));
    this.state = { time: this.times[0], playing: false, speed: 1, quantity: this.meta.quantities[0], picked: null };
    this.spent = [];
    this.stale = true; // something but the camera has changed
    this.build();
    this.setQuantity(this.meta.quantities[0].key);
    this.stage.resize();
  }

  build() {
    const [x0, y0, x1, y1] = this.meta.region;
    const span = Math.max(x1 - x0, y1 - y0);
    const step = roundStep(span / 12);
    this.fine = roundStep(span / 20000); // of places in words
    this.seabed = new Seabed(this.meta, this.tables.bed, step);
    this.stage = new Stage(find("scene"), this.meta, this.seabed);
    this.sea = new Sea(this.meta);
    const world = this.stage.world;
    world.add(this.seabed.mesh, this.sea.group);
    this.palettes = { lines: strip(VIRIDIS), states: {} };
    const owner = this.meta.lines.flatMap(({ first, last }, k) => Array(last - first + 1).fill(k));
    this.lines = new FatLines(owner);
    this.shadow = new FatLines(owner);
    this.shadow.draw(world, { width: 2.5, colour: [0.1, 0.15, 0.2, 0.25], lift: 2e-5, cap: 0 }, 1);
    this.rim = this.lines.draw(world, { width: 4, rim: 1.2, colour: RIM, lift: 2e-4 }, 2);
    this.body = this.lines.draw(world, { width: 4, colours: this.palettes.lines, lift: 4e-4 }, 3);
    this.rods = new FatLines(this.meta.rods.flatMap((_, k) => [k, k]));
    this.rods.draw(world, { width: 8, colour: [0.28, 0.32, 0.36, 1], lift: 3e-4, solid: true }, 2);
    this.rings = this.meta.platforms.map((group) => [...group, ...(group.length > 2 ? [group[0]] : [])]);
    this.platforms = new FatLines(this.rings.flatMap((ring, k) => ring.map(() => k)));
    this.platforms.draw(world, { width: 7, rim: 1.2, colour: RIM, lift: 2e-4 }, 2);
    this.platforms.draw(world, { width: 7, colour: [0.93, 0.71, 0.25, 1], lift: 4e-4, solid: true }, 3);
    this.markers = new Markers(this.meta.markers, this.stage.renderer.getPixelRatio());
    this.bodies = new Bodies(this.meta.bodies, span / 40);
    world.add(this.markers.mesh, this.bodies.group);
    this.scales = new Scales(find("ticks"), find("axes"), this.meta, this.seabed, step);
    this.panel = new Panel(find("panel"), this.meta, this.tables.history);
    this.nodes = new Float32Array(this.tables.position.columns);
    this.rodEnds = new Float32Array(this.tables.rods.columns);
    this.values = {};
    for (const { key } of this.meta.quantities) this.values[key] = new Float32Array(this.tables[key].columns);
    this.across = mainDirection(this.tables.position);
    find("depth").innerHTML = depthLegend(this.seabed);
    find("signs").innerHTML = signLegend(this.meta);
  }

  /** Put everything where it is at the time of the state. */
  move() {
    const { time, quantity } = this.state;
    const [row, share] = placeOf(time, this.times);
    const position = this.tables.position.mix(row, share, this.nodes);
    for (const { key, states } of this.meta.quantities) {
      this.tables[key].mix(row, states.length ? Math.round(share) : share, this.values[key]); // no state between states
    }
    const values = this.values[quantity.key];
    const [low, scale] = shares(quantity);
    const [out, ground] = [this.lines.data, this.shadow.data];
    for (let i = 0; i < values.length; i++) {
      const [x, y] = [position[3 * i], position[3 * i + 1]];
      out[4 * i] = ground[4 * i] = x;
      out[4 * i + 1] = ground[4 * i + 1] = y;
      out[4 * i + 2] = position[3 * i + 2];
      out[4 * i + 3] = (values[i] - low) * scale;
      ground[4 * i + 2] = this.seabed.levelAt(x, y);
    }
    this.tables.markers.mix(row, share, this.markers.data);
    this.tables.rods.mix(row, share, this.rodEnds);
    this.tables.bodies.mix(row, share, this.bodies.data);
    for (let i = 0; i < this.rods.count; i++) this.rods.data.set(this.rodEnds.subarray(3 * i, 3 * i + 3), 4 * i);
    this.rings.flat().forEach((k, i) => this.platforms.data.set(this.markers.data.subarray(3 * k, 3 * k + 3), 4 * i));
    for (const thing of [this.lines, this.shadow, this.rods, this.platforms, this.markers, this.bodies])
      thing.changed();
    this.sea.at(time);
  }

  /** One frame: what has changed is drawn. */
  frame(now) {
    const begin = performance.now();
    const { state } = this;
    if (state.playing && this.before !== undefined) {
      const time = state.time + (Math.min(now - this.before, 100) / 1000) * state.speed;
      this.setTime(time > this.times[this.times.length - 1] ? this.times[0] : time);
    }
    this.before = now;
    const moved = this.stage.advance(now);
    if (moved || this.stale) {
      if (this.stale) {
        this.move();
        this.showTime();
      }
      this.stage.render();
      if (moved) this.scales.place(this.stage);
      this.stale = false;
      this.spent.push(performance.now() - begin);
      if (this.spent.length > 5000) this.spent.shift();
    }
    requestAnimationFrame((t) => this.frame(t));
  }

  showTime() {
    const { time, quantity, playing } = this.state;
    if (this.meta.moving) {
      find("now").textContent = time.toFixed(this.digits);
      if (document.activeElement !== find("slider") || playing) find("slider").value = time;
    }
    if (!this.panel.open) return;
    if (this.panel.along) this.panel.draw(time, quantity, this.values[quantity.key]);
    this.panel.now(time, placeOf(time, this.meta.historyTime));
  }

  setTime(time) {
    this.state.time = Math.min(Math.max(time, this.times[0]), this.times[this.times.length - 1]);
    this.stale = true;
  }

  play(on) {
    this.state.playing = on && this.meta.moving;
    find("play").setAttribute("aria-label", this.state.playing ? "Pause" : "Play");
    find("play").classList.toggle("playing", this.state.playing);
  }

  setQuantity(key) {
    const quantity = (this.state.quantity = this.meta.quantities.find((q) => q.key === key));
    find("quantity").value = key;
    find("scale").innerHTML = lineLegend(quantity);
    const n = quantity.states.length;
    this.body.colours.value = n ? (this.palettes.states[n] ??= strip(STATES, n)) : this.palettes.lines;
    this.stale = true;
  }

  setStretch(factor) {
    this.stage.setStretch(factor);
    find("stretch").value = factor;
    this.seabed.uniforms.stretch.value = this.sea.uniforms.stretch.value = factor;
    this.look(this.view, 0);
  }

  look(view, swift) {
    this.view = view;
    const [a, b] = [this.meta.low, this.meta.high];
    const [x0, y0, x1, y1] = this.meta.region;
    const box = (xs, ys, zs) => xs.flatMap((x) => ys.flatMap((y) => zs.map((z) => [x, y, z])));
    const upright = [Math.min(0, a[2]), Math.max(0, b[2])];
    const bed = this.seabed.low < -DEEP * Math.max(x1 - x0, y1 - y0) ? [] : [this.seabed.low]; // too deep to be shown
    let around = box([x0, x1], [y0, y1], [...upright, ...bed]);
    if (view === "side") around = box([a[0], b[0]], [a[1], b[1]], upright);
    if (view === "close") around = this.closeUp();
    if (view === "top") around = box([x0, x1], [y0, y1], [0]);
    const across = view === "top" ? [1, 0] : this.across;
    this.stage.look(view, around, across, this.covered(), calm ? 0 : swift);
    document
      .querySelectorAll("[data-view]")
      .forEach((button) => button.setAttribute("aria-pressed", button.dataset.view === view));
  }

  /** Pixels at the left and at the top that cards cover. */
  covered() {
    const [{ offsetWidth: panel }, about] = [find("panel"), find("about")];
    return { left: panel && panel < this.stage.size.width / 2 ? panel + 24 : 0, top: about.offsetTop + about.offsetHeight };
  }

  /** Places of the clicked line, or around the platform in the middle, or around what moves, or the highest place. */
  closeUp() {
    const { picked } = this.state;
    const at = (data) => (i) => Array.from(data.subarray(3 * i, 3 * i + 3));
    const [node, marker] = [at(this.nodes), at(this.markers.data)];
    const all = Array.from({ length: this.nodes.length / 3 }, (_, i) => node(i));
    if (picked !== null) return all.slice(this.meta.lines[picked].first, this.meta.lines[picked].last + 1);
    const moved = [...this.meta.markers.keys()].filter((k) => this.meta.markers[k].kind.startsWith("coupled"));
    const [x0, y0, x1, y1] = this.meta.region;
    const away = ([x, y]) => Math.hypot(x - (x0 + x1) / 2, y - (y0 + y1) / 2);
    const central = (a, b) => away(marker(a[0])) - away(marker(b[0]));
    const groups = [...this.meta.platforms].sort(central);
    const shown = (groups[0] ?? moved).map(marker);
    const rods = this.meta.rods.flatMap((_, k) => [2 * k, 2 * k + 1]).map(at(this.rodEnds));
    const bodies = this.meta.bodies.map((_, k) => Array.from(this.bodies.data.subarray(6 * k, 6 * k + 3)));
    if (!all.length) return [...shown, ...rods, ...bodies, ...this.meta.markers.map((_, k) => marker(k))];
    if (!shown.length) shown.push(all.reduce((a, b) => (b[2] > a[2] ? b : a)));
    const spans = this.meta.lines.map(({ first, last }) => distance(all[first], all[last]));
    const reach = (CLOSE * spans.reduce((a, b) => a + b)) / spans.length;
    return [...shown, ...all.filter((p) => shown.some((q) => distance(p, q) < reach))];
  }

  select(line) {
    this.state.picked = line;
    this.body.picked.value = this.rim.picked.value = line ?? -9;
    this.panel.show(line);
    this.panel.draw(this.state.time, this.state.quantity, this.values[this.state.quantity.key]);
    this.stale = true;
  }

  picture() {
    const ratio = this.stage.renderer.getPixelRatio();
    this.sized(2);
    this.stage.render();
    const shown = this.meta.moving ? `t = ${words(this.state.time, 0.1)} s` : "static equilibrium";
    const vertical = this.stage.stretch === 1 ? "" : `vertical scale ${this.stage.stretch}:1`;
    const below = [this.meta.source, shown, vertical].filter(Boolean).join(", ");
    const facts = { title: this.meta.title, below, quantity: this.state.quantity };
    const canvas = compose(this.stage, this.scales, this.seabed, facts);
    this.sized(ratio);
    this.stale = true;
    return canvas;
  }

  sized(ratio) {
    this.stage.renderer.setPixelRatio(ratio);
    this.markers.sized(ratio);
  }

  save() {
    const link = document.createElement("a");
    link.href = this.picture().toDataURL("image/png");
    link.download = `${this.meta.source.replace(/\.[^.]*$/, "") || "mooring"}.png`;
    link.click();
  }
}

function distance(a, b) {
  return Math.hypot(...a.map((v, k) => v - b[k]));
}

/** The horizontal direction in which a mooring extends most at the start, pointing along +x; +x where it has none. */
function mainDirection(position) {
  const n = position.columns / 3;
  if (!n) return [1, 0];
  const mean = [0, 1].map(
    (k) => Array.from({ length: n }, (_, i) => position.at(0, 3 * i + k)).reduce((a, b) => a + b) / n,
  );
  let [xx, xy, yy] = [0, 0, 0];
  for (let i = 0; i < n; i++) {
    const [x, y] = [position.at(0, 3 * i) - mean[0], position.at(0, 3 * i + 1) - mean[1]];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const [half, apart] = [(xx + yy) / 2, Math.hypot((xx - yy) / 2, xy)];
  if (apart < 0.25 * half) return [1, 0];
  const angle = 0.5 * Math.atan2(2 * xy, xx - yy);
  return Math.cos(angle) < -1e-9 ? [-Math.cos(angle), -Math.sin(angle)] : [Math.cos(angle), Math.sin(angle)];
}
