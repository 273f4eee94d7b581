// The camera and its presets, the renderer, and where places are on the screen.

import { screen } from "./lines.js";

const ANGLE = 13; // of view, degrees
const BESIDE = 84; // pixels on both sides of what a preset shows
const SWIFT = 350; // ms of a move from one preset to another
export const VIEWS = ["overview", "side", "top", "close"];

export class Stage {
  constructor(canvas, meta, seabed) {
    this.canvas = canvas;
    this.meta = meta;
    this.seabed = seabed;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.world = new THREE.Group(); // what the vertical scale stretches
    this.scene.add(this.world);
    this.camera = new THREE.PerspectiveCamera(ANGLE, 1, 1, 1e5);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => (this.moved = true));
    this.controls.addEventListener("start", () => (this.flight = null));
    this.stretch = 1;
    this.moved = true;
    this.flight = null;
    this.pixels = screen.value = new THREE.Vector2();
    this.size = { width: 1, height: 1 };
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.size = { width, height };
    this.renderer.setSize(width, height, false);
    this.renderer.getDrawingBufferSize(this.pixels);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.moved = true;
  }

  setStretch(factor) {
    this.stretch = factor;
    this.world.scale.z = factor;
    this.moved = true;
  }

  /** Fly to a preset; `around` are places [x, y, z] that must be seen, `covered` pixels at the left and at the top not. */
  look(view, around, across, covered, swift = SWIFT) {
    const side = new THREE.Vector3(across[1], -across[0], 0); // horizontal, towards the reader
    const right = new THREE.Vector3(across[0], across[1], 0);
    const up = new THREE.Vector3(0, 0, 1);
    const away = {
      overview: side.clone().multiplyScalar(0.84).addScaledVector(right, 0.42).addScaledVector(up, 0.5),
      side: side.clone().addScaledVector(up, 0.02),
      top: up.clone().addScaledVector(new THREE.Vector3(0, -1, 0), 0.001),
      close: side.clone().multiplyScalar(0.8).addScaledVector(right, 0.55).addScaledVector(up, 0.28),
    }[view].normalize();
    const places = around.map(([x, y, z]) => new THREE.Vector3(x, y, z * this.stretch));
    const goal = this.fit(places, away, view, covered);
    if (swift <= 0) {
      this.camera.position.copy(goal.position);
      this.controls.target.copy(goal.target);
      this.flight = null;
      this.controls.update();
    } else {
      this.flight = {
        ...goal,
        from: this.camera.position.clone(),
        to: this.controls.target.clone(),
        start: null,
        swift,
      };
    }
    this.moved = true;
  }

  /** Where a camera that looks along -away sees all places, in the part of the screen that panels leave free. */
  fit(places, away, view, covered) {
    const right = new THREE.Vector3().crossVectors(this.camera.up, away).normalize();
    const top = new THREE.Vector3().crossVectors(away, right);
    const { width, height } = this.size;
    const above = view === "overview" ? Math.max(70, covered.top) : 176; // pixels that panels and labels take
    const below = view === "top" ? 132 : 148;
    const left = Math.max(BESIDE, covered.left);
    const span = [width - left - BESIDE, height - above - below];
    const perPixel = (2 * Math.tan((ANGLE * Math.PI) / 360)) / height; // at distance 1
    const middle = places.reduce((sum, p) => sum.add(p), new THREE.Vector3()).divideScalar(places.length);
    const target = middle.clone();
    let distance = 0;
    for (let pass = 0; pass < 4; pass++) {
      const seen = places.map((p) => p.clone().sub(target)).map((d) => [d.dot(right), d.dot(top), d.dot(away)]);
      const needed = ([u, v, w]) => w + (2 * Math.max(Math.abs(u) / span[0], Math.abs(v) / span[1])) / perPixel;
      distance = Math.max(...seen.map(needed), 1e-3);
      [right, top].forEach((direction, k) => {
        const shown = seen.map((s) => s[k] / (distance - s[2]));
        target.addScaledVector(direction, 0.5 * (Math.max(...shown) + Math.min(...shown)) * distance);
      });
    }
    target.addScaledVector(top, 0.5 * perPixel * distance * (above - below)); // to the middle of what is free
    target.addScaledVector(right, 0.5 * perPixel * distance * (BESIDE - left));
    return { target, position: target.clone().addScaledVector(away, distance) };
  }

  /** Go on with a flight; whether the camera has moved since the last call. */
  advance(now) {
    if (this.flight) {
      const f = this.flight;
      f.start ??= now;
      const share = Math.min((now - f.start) / f.swift, 1);
      const s = share * share * (3 - 2 * share);
      this.camera.position.lerpVectors(f.from, f.position, s);
      this.controls.target.lerpVectors(f.to, f.target, s);
      this.controls.update();
      if (share === 1) this.flight = null;
      this.moved = true;
    }
    const moved = this.moved;
    this.moved = false;
    return moved;
  }

  render() {
    const far = this.camera.position.distanceTo(this.controls.target);
    const [x0, y0, x1, y1] = this.meta.region;
    const size = Math.hypot(x1 - x0, y1 - y0, this.stretch * (this.seabed.high - this.seabed.low + this.meta.depth));
    this.camera.near = Math.max((far - size) * 0.5, far * 0.005);
    this.camera.far = far + 4 * size;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
  }

  /** Pixels that a metre across the line of sight takes at a place. */
  perMetre(x, y, z) {
    const away = this.camera.position.distanceTo(new THREE.Vector3(x, y, z * this.stretch));
    return this.size.height / (2 * Math.tan((ANGLE * Math.PI) / 360) * away);
  }

  /** The matrix from places in the model to the screen's -1..1. */
  matrix() {
    this.camera.updateMatrixWorld();
    const m = new THREE.Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    return m.scale(new THREE.Vector3(1, 1, this.stretch)).elements;
  }

  /** Pixels [x, y] and distance of a place, null behind the camera. */
  pixel(x, y, z, m = this.matrix()) {
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return null;
    const u = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
    const v = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
    return [(0.5 + 0.5 * u) * this.size.width, (0.5 - 0.5 * v) * this.size.height, w];
  }
}
