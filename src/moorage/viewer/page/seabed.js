// The seabed: a block of ground, coloured by depth, with a grid of round distances.

import { DEPTH, strip } from "./colours.js";

const VERTEX = `
  attribute vec3 slope;
  varying vec3 vPlace, vSlope;
  void main() {
    vPlace = position;
    vSlope = slope;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const FRAGMENT = `
  uniform sampler2D colours;
  uniform float low, high, flat_, grid, stretch;
  varying vec3 vPlace, vSlope;
  void main() {
    float depth = flat_ > 0.5 ? 0.12 : clamp((vPlace.z - high) / (low - high), 0.0, 1.0);
    vec3 own = texture2D(colours, vec2(depth, 0.5)).rgb;
    if (vSlope.z > 0.5) {                                     // a side of the block
      own *= 0.80;
    } else {
      vec3 normal = normalize(vec3(-stretch * vSlope.xy, 1.0));
      own *= 0.62 + 0.38 * dot(normal, normalize(vec3(-0.45, 0.35, 0.82))) / 0.82;
      vec2 cell = vPlace.xy / grid;
      vec2 away = abs(fract(cell - 0.5) - 0.5) / fwidth(cell);
      own = mix(own * 0.86, own, clamp(min(away.x, away.y) - 0.1, 0.0, 1.0));
    }
    gl_FragColor = vec4(own, 1.0);
  }`;

export class Seabed {
  constructor(meta, table, gridStep) {
    [this.x0, this.y0, this.x1, this.y1] = meta.region;
    ({ nx: this.nx, ny: this.ny, flat: this.flat } = meta.bed);
    this.z = Float32Array.from({ length: this.nx * this.ny }, (_, i) => table.at(i, 0));
    this.low = this.z.reduce((a, b) => Math.min(a, b));
    this.high = this.z.reduce((a, b) => Math.max(a, b));
    this.dx = (this.x1 - this.x0) / (this.nx - 1);
    this.dy = (this.y1 - this.y0) / (this.ny - 1);
    const span = Math.max(this.x1 - this.x0, this.y1 - this.y0);
    this.floor = this.low - 0.012 * span;
    this.uniforms = {
      colours: { value: strip(DEPTH) },
      low: { value: this.low },
      high: { value: this.high },
      flat_: { value: this.flat ? 1 : 0 },
      grid: { value: gridStep },
      stretch: { value: 1 },
    };
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: this.uniforms,
      side: THREE.DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.mesh = new THREE.Mesh(this.geometry(), material);
    this.mesh.frustumCulled = false;
  }

  /** z of the seabed at a place, as it is drawn; beyond its edges the edge goes on. */
  levelAt(x, y) {
    const u = Math.min(Math.max((x - this.x0) / this.dx, 0), this.nx - 1);
    const v = Math.min(Math.max((y - this.y0) / this.dy, 0), this.ny - 1);
    const i = Math.min(Math.floor(u), this.nx - 2);
    const j = Math.min(Math.floor(v), this.ny - 2);
    const [s, t] = [u - i, v - j];
    const k = i * this.ny + j;
    const low = this.z[k] + s * (this.z[k + this.ny] - this.z[k]);
    const high = this.z[k + 1] + s * (this.z[k + this.ny + 1] - this.z[k + 1]);
    return low + t * (high - low);
  }

  geometry() {
    const [position, slope, index] = [[], [], []];
    const { nx, ny } = this;
    const add = (i, j, z, sx, sy, side) => {
      position.push(this.x0 + i * this.dx, this.y0 + j * this.dy, z);
      slope.push(sx, sy, side);
      return position.length / 3 - 1;
    };
    const at = (i, j) => this.z[Math.min(Math.max(i, 0), nx - 1) * ny + Math.min(Math.max(j, 0), ny - 1)];
    for (let i = 0; i < nx; i++) {
      for (let j = 0; j < ny; j++) {
        const [di, dj] = [i > 0 && i < nx - 1 ? 2 : 1, j > 0 && j < ny - 1 ? 2 : 1];
        const sx = (at(i + 1, j) - at(i - 1, j)) / (di * this.dx);
        add(i, j, at(i, j), sx, (at(i, j + 1) - at(i, j - 1)) / (dj * this.dy), 0);
        if (i && j) {
          const k = i * ny + j;
          index.push(k - ny - 1, k - 1, k, k - ny - 1, k, k - ny);
        }
      }
    }
    const edge = [];
    for (let i = 0; i < nx; i++) edge.push([i, 0]);
    for (let j = 1; j < ny; j++) edge.push([nx - 1, j]);
    for (let i = nx - 2; i >= 0; i--) edge.push([i, ny - 1]);
    for (let j = ny - 2; j >= 0; j--) edge.push([0, j]);
    let before = null;
    for (const [i, j] of edge) {
      const pair = [add(i, j, at(i, j), 0, 0, 1), add(i, j, this.floor, 0, 0, 1)];
      if (before) index.push(before[0], before[1], pair[1], before[0], pair[1], pair[0]);
      before = pair;
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(position), 3));
    geometry.setAttribute("slope", new THREE.BufferAttribute(new Float32Array(slope), 3));
    geometry.setIndex(index);
    return geometry;
  }
}
