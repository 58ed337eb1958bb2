// SPDX-License-Identifier: GPL-3.0-or-later
// What the page uses of three.js; nothing else gets into the bundle that the bundler can tell apart.
export {
  AmbientLight, Box3, BufferGeometry, CanvasTexture, Color, ConeGeometry, CylinderGeometry, DirectionalLight, DoubleSide, BackSide,
  FrontSide, GreaterDepth, LessEqualDepth, Float32BufferAttribute, Group, HemisphereLight, InstancedMesh, Line, LineBasicMaterial, LineDashedMaterial, LineLoop,
  LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, OrthographicCamera, PerspectiveCamera, PlaneGeometry, Points,
  PointsMaterial, Quaternion, Raycaster, RepeatWrapping, Scene, Sphere, SphereGeometry, Vector2, Vector3, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
export { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
export { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
export { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
export { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
