// What the viewer takes of three.js. README.md says how three.min.js is made from this.
export {
  BoxGeometry, BufferAttribute, BufferGeometry, DataTexture, DoubleSide, DynamicDrawUsage, EdgesGeometry, Group,
  InstancedBufferAttribute, InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute,
  LineBasicMaterial, LineLoop, LineSegments, LinearFilter, Matrix4, Mesh, MeshBasicMaterial, PerspectiveCamera, Points,
  Scene, ShaderMaterial, Vector2, Vector3, Vector4, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/addons/controls/OrbitControls.js";
