// The sea surface: eta = sum A cos(w t - k . x + phase), summed for every corner of its mesh on the graphics card.

const SUM = (count) => `
  uniform vec4 waves[${Math.max(count, 1)}];   // amplitude, k_x, k_y, w t + phase
  vec3 surface(vec2 p) {                       // elevation and its slopes
    vec3 sum = vec3(0.0);
    for (int i = 0; i < ${count}; i++) {
      float angle = waves[i].w - dot(waves[i].yz, p);
      sum += waves[i].x * vec3(cos(angle), waves[i].yz * sin(angle));
    }
    return sum;
  }`;

const VERTEX = `
  varying vec3 vSlope;
  varying vec4 vView;
  void main() {
    vec3 s = surface(position.xy);
    vSlope = s;
    vView = modelViewMatrix * vec4(position.xy, s.x, 1.0);
    gl_Position = projectionMatrix * vView;
  }`;

const FRAGMENT = `
  uniform float stretch, steep;
  varying vec3 vSlope;
  varying vec4 vView;
  void main() {
    vec3 normal = normalize(vec3(-steep * stretch * vSlope.yz, 1.0));
    float light = dot(normal, normalize(vec3(-0.5, 0.4, 0.75)));
    float shine = pow(max(light, 0.0), 24.0);
    vec3 own = mix(vec3(0.16, 0.42, 0.62), vec3(0.72, 0.87, 0.95), clamp(1.6 * light - 0.62, 0.0, 1.0));
    gl_FragColor = vec4(own, 0.30 + 0.12 * shine);
  }`;

const EDGE = `
  void main() {
    gl_FragColor = vec4(0.16, 0.42, 0.62, 0.75);
  }`;

export class Sea {
  constructor(meta) {
    const { components, ramp, cells } = meta.sea;
    this.components = components;
    this.ramp = ramp;
    this.waves = components.map(() => new THREE.Vector4());
    const slope = Math.sqrt(components.reduce((s, [a, kx, ky]) => s + 0.5 * a * a * (kx * kx + ky * ky), 0));
    this.uniforms = {
      waves: { value: this.waves.length ? this.waves : [new THREE.Vector4()] },
      stretch: { value: 1 },
      steep: { value: slope > 0 ? Math.max(1, 0.14 / slope) : 1 }, // light sees long waves as if they were steeper
    };
    const common = { uniforms: this.uniforms, vertexShader: SUM(components.length) + VERTEX, transparent: true };
    const water = new THREE.ShaderMaterial({
      ...common,
      fragmentShader: FRAGMENT,
      side: THREE.DoubleSide,
      depthWrite: false,
    });
    const edge = new THREE.ShaderMaterial({ ...common, fragmentShader: EDGE, depthWrite: false });
    const [surface, border] = this.geometries(meta.region, components.length ? cells : 1);
    this.group = new THREE.Group();
    this.group.add(new THREE.Mesh(surface, water), new THREE.LineLoop(border, edge));
    this.group.children.forEach((child, i) => Object.assign(child, { frustumCulled: false, renderOrder: 10 + i }));
    this.at(0);
  }

  grown(time) {
    return this.ramp > 0 && time < this.ramp ? 0.5 * (1 - Math.cos((Math.PI * Math.max(time, 0)) / this.ramp)) : 1;
  }

  /** Move the surface to a time. */
  at(time) {
    const grown = this.grown(time);
    this.components.forEach(([a, kx, ky, w, phase], i) => {
      this.waves[i].set(grown * a, kx, ky, (w * time + phase) % (2 * Math.PI));
    });
  }

  elevation(x, y, time) {
    const wave = ([a, kx, ky, w, phase]) => a * Math.cos(w * time + phase - kx * x - ky * y);
    return this.grown(time) * this.components.reduce((sum, component) => sum + wave(component), 0);
  }

  geometries([x0, y0, x1, y1], cells) {
    const step = Math.max(x1 - x0, y1 - y0) / cells;
    const nx = Math.max(1, Math.round((x1 - x0) / step));
    const ny = Math.max(1, Math.round((y1 - y0) / step));
    const place = (i, j) => [x0 + ((x1 - x0) * i) / nx, y0 + ((y1 - y0) * j) / ny, 0];
    const [corners, index, border] = [[], [], []];
    for (let i = 0; i <= nx; i++) {
      for (let j = 0; j <= ny; j++) {
        corners.push(...place(i, j));
        const k = i * (ny + 1) + j;
        if (i && j) index.push(k - ny - 2, k - 1, k, k - ny - 2, k, k - ny - 1);
      }
    }
    for (let i = 0; i < nx; i++) border.push(...place(i, 0));
    for (let j = 0; j < ny; j++) border.push(...place(nx, j));
    for (let i = nx; i > 0; i--) border.push(...place(i, ny));
    for (let j = ny; j > 0; j--) border.push(...place(0, j));
    return [corners, border].map((values, k) => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(values), 3));
      if (k === 0) geometry.setIndex(index);
      return geometry;
    });
  }
}
