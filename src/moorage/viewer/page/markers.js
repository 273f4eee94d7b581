// Points as signs of one size on the screen: squares are fixed, discs are moved, diamonds are free. Bodies as boxes.

export const KINDS = ["fixed", "coupled", "free"];
const [SMALLEST, LARGEST] = [7, 12]; // pixels
const SIGN_COLOURS = ["#1d2733", "#ffffff", "#cc79a7"];

const VERTEX = `
  attribute float kind;
  uniform float size;
  varying float vKind;
  void main() {
    vKind = kind;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_Position.z -= 0.0012 * gl_Position.w;
    gl_PointSize = size;
  }`;

const FRAGMENT = `
  uniform vec3 colours[3];
  varying float vKind;
  void main() {
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    int kind = int(vKind + 0.5);
    float r = kind == 0 ? max(abs(p.x), abs(p.y)) * 1.25 : kind == 1 ? length(p) * 1.08 : abs(p.x) + abs(p.y);
    if (r > 1.0) discard;
    vec3 own = kind == 0 ? colours[0] : kind == 1 ? colours[1] : colours[2];
    vec3 rim = kind == 0 ? vec3(1.0) : vec3(0.114, 0.153, 0.2);
    gl_FragColor = vec4(r > 0.72 ? rim : own, 1.0);
  }`;

function kindOf(label) {
  return Math.max(
    0,
    KINDS.findIndex((kind) => label.kind.startsWith(kind)),
  );
}

export class Markers {
  constructor(labels, ratio) {
    this.labels = labels;
    this.data = new Float32Array(3 * labels.length);
    const geometry = new THREE.BufferGeometry();
    this.position = new THREE.BufferAttribute(this.data, 3).setUsage(THREE.DynamicDrawUsage);
    geometry.setAttribute("position", this.position);
    geometry.setAttribute("kind", new THREE.BufferAttribute(Float32Array.from(labels, kindOf), 1));
    const colours = SIGN_COLOURS.map(
      (hex) => new THREE.Vector3(...[1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)),
    );
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { size: { value: 0 }, colours: { value: colours } },
    });
    this.uniforms = material.uniforms;
    this.sized(ratio);
    this.mesh = new THREE.Points(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 5;
  }

  /** Set the size for a screen with so many pixels to one of the page; many signs are smaller. */
  sized(ratio) {
    this.uniforms.size.value =
      ratio * Math.min(LARGEST, Math.max(SMALLEST, LARGEST * Math.sqrt(40 / this.labels.length)));
  }

  changed() {
    this.position.needsUpdate = true;
  }
}

/** Boxes at the places of bodies, turned as they are; their size says nothing. */
export class Bodies {
  constructor(labels, size) {
    this.group = new THREE.Group();
    this.data = new Float32Array(6 * labels.length);
    const box = new THREE.BoxGeometry(size, size, size);
    const edges = new THREE.EdgesGeometry(box);
    for (const _ of labels) {
      const body = new THREE.Group();
      body.add(new THREE.Mesh(box, new THREE.MeshBasicMaterial({ color: 0xe8b54a, transparent: true, opacity: 0.75 })));
      body.add(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({ color: 0x1d2733 })));
      this.group.add(body);
    }
  }

  changed() {
    this.group.children.forEach((body, i) => {
      const [x, y, z, roll, pitch, yaw] = this.data.subarray(6 * i, 6 * i + 6);
      body.position.set(x, y, z);
      body.rotation.set(roll, pitch, yaw, "XYZ");
    });
  }
}
