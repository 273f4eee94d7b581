// Lines of a width in pixels, shaded as round, with a dark rim that sets them off from light and dark ground.

const VERTEX = `
  attribute vec2 corner;       // x: 0 start, 1 end of the segment; y: -1, 1 its sides
  attribute vec4 start, end;   // x, y, z and value
  attribute float part;        // which line; below zero: from one line to the next
  uniform vec2 screen;
  uniform float width, rim, picked, lift, cap;
  varying vec2 vPlace;
  varying float vLength, vRadius, vDepth, vFrom, vTo, vPicked;
  void main() {
    vec4 a = modelViewMatrix * vec4(start.xyz, 1.0), b = modelViewMatrix * vec4(end.xyz, 1.0);
    float near = -0.01 - projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0);
    if (a.z > near && b.z < near) a = mix(b, a, (near - b.z) / (a.z - b.z));
    if (b.z > near && a.z < near) b = mix(a, b, (near - a.z) / (b.z - a.z));
    vec4 ca = projectionMatrix * a, cb = projectionMatrix * b;
    vec2 pa = ca.xy / ca.w * screen * 0.5, pb = cb.xy / cb.w * screen * 0.5;
    float size = length(pb - pa);
    vec2 along = size > 1e-4 ? (pb - pa) / size : vec2(1.0, 0.0), across = vec2(-along.y, along.x);
    vPicked = abs(part - picked) < 0.5 ? 1.0 : 0.0;
    vRadius = 0.5 * width * (1.0 + 0.6 * vPicked) + rim;
    vec4 c = corner.x < 0.5 ? ca : cb;
    float reach = (2.0 * corner.x - 1.0) * vRadius * cap;
    c.xy += (along * reach + across * corner.y * vRadius) / (0.5 * screen) * c.w;
    c.z -= lift * c.w;
    if (part < -0.5 || (a.z > near && b.z > near)) c = vec4(2.0, 2.0, 2.0, 1.0);
    gl_Position = c;
    vDepth = c.w;              // so that places are linear on the screen
    vPlace = vec2(corner.x * size + reach, corner.y * vRadius) * c.w;
    vLength = size;
    vFrom = start.w;
    vTo = end.w;
  }`;

const FRAGMENT = `
  uniform vec4 colour;
  uniform float coloured;
  uniform sampler2D colours;
  varying vec2 vPlace;
  varying float vLength, vRadius, vDepth, vFrom, vTo, vPicked;
  void main() {
    vec2 p = vPlace / vDepth;
    float beyond = p.x - clamp(p.x, 0.0, vLength);
    if (length(vec2(beyond, p.y)) > vRadius) discard;
    float share = vLength > 0.0 ? clamp(p.x / vLength, 0.0, 1.0) : 0.0;
    vec3 own = mix(colour.rgb, texture2D(colours, vec2(mix(vFrom, vTo, share), 0.5)).rgb, coloured);
    float round_ = sqrt(max(0.0, 1.0 - p.y * p.y / (vRadius * vRadius)));
    own *= mix(1.0, 0.72 + 0.34 * round_, coloured);
    gl_FragColor = vec4(own, colour.a);
  }`;

export const screen = { value: null }; // size in pixels, shared by all materials; set by the stage

function material(options) {
  return new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      screen,
      width: { value: options.width },
      rim: { value: options.rim ?? 0 },
      picked: { value: -9 },
      lift: { value: options.lift ?? 0 },
      cap: { value: options.cap ?? 1 },
      colour: { value: new THREE.Vector4(...(options.colour ?? [0, 0, 0, 1])) },
      coloured: { value: options.colours ? 1 : 0 },
      colours: { value: options.colours ?? null },
    },
    transparent: (options.colour?.[3] ?? 1) < 1,
    depthWrite: Boolean(options.colours ?? options.solid), // a rim must not hide the next segment
    side: THREE.DoubleSide,
  });
}

/** Lines through nodes: `data` holds x, y, z and a value from 0 to 1 of every node; `parts` says whose node it is. */
export class FatLines {
  constructor(parts) {
    this.count = parts.length;
    this.data = new Float32Array(4 * this.count);
    this.buffer = new THREE.InstancedInterleavedBuffer(this.data, 4).setUsage(THREE.DynamicDrawUsage);
    const part = new Float32Array(Math.max(this.count - 1, 0));
    for (let i = 0; i + 1 < this.count; i++) part[i] = parts[i] === parts[i + 1] ? parts[i] : -1;
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute("corner", new THREE.BufferAttribute(new Float32Array([0, -1, 1, -1, 1, 1, 0, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute("start", new THREE.InterleavedBufferAttribute(this.buffer, 4, 0));
    geometry.setAttribute("end", new THREE.InterleavedBufferAttribute(this.buffer, 4, 4));
    geometry.setAttribute("part", new THREE.InstancedBufferAttribute(part, 1));
    geometry.instanceCount = part.length;
    this.geometry = geometry;
    this.meshes = [];
  }

  /**
   * Add a drawing of these lines to a group: its width and rim in pixels, a colour [r, g, b, a] or a strip of colours,
   * how far it is lifted towards the eye, whether its segments have round ends, whether a colour hides what is behind.
   */
  draw(group, options, order = 0) {
    const mesh = new THREE.Mesh(this.geometry, material(options));
    mesh.frustumCulled = false;
    mesh.renderOrder = order;
    this.meshes.push(mesh);
    group.add(mesh);
    return mesh.material.uniforms;
  }

  changed() {
    this.buffer.needsUpdate = true;
  }
}
