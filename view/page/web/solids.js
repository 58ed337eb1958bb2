// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the 3-D pictures: bodies with their faces and edges, features, arrows, planes. Places are those of a frame (geometry.js).
// One body takes one draw call for its faces from either side and one for its edges, however many it has.
import { across, cross, fan, inOrder, minus, norm, normalOf, plus, times, unit } from "./geometry.js";
import { colour } from "./look.js";

/** In this order things are drawn, one over the other. */
export const layer = {
  backs: 0, solid: 10, solidEdges: 12, glass: 20, glassDepth: 30, edges: 40, plane: 50, faint: 60, strong: 61, arrow: 70,
};

/** The triangles of polygons, each with the polygon's own normal; owner[t] is the polygon of triangle t. */
export function triangles(vertices, polygons) {
  const position = [], normal = [], owner = [];
  polygons.forEach((polygon, f) => {
    const n = normalOf(polygon.map((v) => vertices[v]));
    for (const corners of fan(polygon.length)) {
      for (const c of corners) {
        position.push(...vertices[polygon[c]]);
        normal.push(...n);
      }
      owner.push(f);
    }
  });
  return { position, normal, owner };
}

export function meshGeometry({ position, normal }) {
  const T = globalThis.THREE, geometry = new T.BufferGeometry();
  geometry.setAttribute("position", new T.Float32BufferAttribute(position, 3));
  geometry.setAttribute("normal", new T.Float32BufferAttribute(normal, 3));
  return geometry;
}

/** Stripes of the screen, with nearly nothing between them. */
export function hatched(material, between = 0.25) {
  const period = (8 * ratio()).toFixed(1), stripe = (2.2 * ratio()).toFixed(1), end = "#include <opaque_fragment>";
  const share = `diffuseColor.a *= mod(gl_FragCoord.x + gl_FragCoord.y, ${period}) < ${stripe} ? 1.0 : ${between.toFixed(2)};`;
  material.onBeforeCompile = (shader) => { shader.fragmentShader = shader.fragmentShader.replace(end, `${share}\n${end}`); };
  return material;
}

const ratio = () => Math.min(2, window.devicePixelRatio || 1);

/** A mesh of one colour, by the name of the style sheet's property; recolour(root) reads them again. */
export function surface(geometry, name, order, options, hatch = null) {
  const T = globalThis.THREE;
  const { flat = false, ...rest } = options;
  const material = new (flat ? T.MeshBasicMaterial : T.MeshLambertMaterial)({ transparent: true, ...rest });
  if (hatch !== null) hatched(material, hatch);
  return dressed(new T.Mesh(geometry, material), name, order);
}

/** Segments [p, q, p, q, ...], wide ones: width in pixels. dash: length of a dash in the frame, 0 for none. */
export function segments(points, name, order, { width = 1.5, dash = 0, ...options } = {}) {
  const T = globalThis.THREE, flat = points.flat();
  const most = 2 * 6000;  // ends: more edges than this are drawn one pixel wide
  if (points.length > most) {
    const geometry = new T.BufferGeometry();
    geometry.setAttribute("position", new T.Float32BufferAttribute(flat, 3));
    return dressed(new T.LineSegments(geometry, new T.LineBasicMaterial({ transparent: true, ...options })), name, order);
  }
  const geometry = new T.LineSegmentsGeometry();
  if (flat.length) geometry.setPositions(flat);
  const dashes = { dashed: dash > 0, dashSize: dash, gapSize: dash * 0.8 };
  const material = new T.LineMaterial({ linewidth: width, transparent: true, ...dashes, ...options });
  const lines = new T.LineSegments2(geometry, material);
  if (dash > 0 && flat.length) lines.computeLineDistances();
  lines.visible = flat.length > 0;
  return dressed(lines, name, order);
}

/** Round dots, size in pixels. */
export function dots(points, name, order, { size = 11, ...options } = {}) {
  const T = globalThis.THREE, geometry = new T.BufferGeometry();
  geometry.setAttribute("position", new T.Float32BufferAttribute(points.flat(), 3));
  const round = { size: size * ratio(), sizeAttenuation: false, transparent: true, alphaTest: 0.5, map: roundTexture() };
  return dressed(new T.Points(geometry, new T.PointsMaterial({ ...round, ...options })), name, order);
}

let roundOne = null;
function roundTexture() {
  if (roundOne) return roundOne;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d");
  context.fillStyle = "#fff";
  context.arc(32, 32, 30, 0, 2 * Math.PI);
  context.fill();
  roundOne = new globalThis.THREE.CanvasTexture(canvas);
  return roundOne;
}

function dressed(object, name, order) {
  object.renderOrder = order;
  object.frustumCulled = false;
  object.userData.colour = name;
  object.material.color.set(colour(name));
  return object;
}

/** Reads the colours of everything below root again. */
export function recolour(root) {
  root.traverse((object) => {
    if (object.userData.colour) object.material.color.set(colour(object.userData.colour));
  });
}

/** Stands a group where an affine map carries it. */
export function carry(group, map) {
  const at = map([0, 0, 0]), [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => minus(map(axis), at));
  group.matrixAutoUpdate = false;
  group.matrix.set(x[0], y[0], z[0], at[0], x[1], y[1], z[1], at[1], x[2], y[2], z[2], at[2], 0, 0, 0, 1);
  group.matrixWorldNeedsUpdate = true;
}

/** Frees what a group holds of the graphics memory, and empties it. */
export function emptied(group) {
  group.traverse((object) => {
    object.geometry?.dispose();
    object.material?.dispose();
  });
  group.clear();
  return group;
}

/** An arrow of two meshes, as wide as pixels however near the camera is. place(from, to) sets it. */
export function arrow(view, name) {
  const T = globalThis.THREE, group = new T.Group(), options = { flat: view.flat, depthTest: false, depthWrite: false };
  const shaft = surface(new T.CylinderGeometry(1, 1, 1, 16), name, layer.arrow, options);
  const head = surface(new T.ConeGeometry(1, 1, 24), name, layer.arrow + 1, options);
  group.add(shaft, head);
  let from = [0, 0, 0], to = [0, 0, 0];
  view.beforeFrame(() => {
    const length = norm(minus(to, from)), pixel = view.pixel(to);
    group.visible = length > 0.5 * pixel;
    if (!group.visible) return;
    const way = times(minus(to, from), 1 / length), headLength = Math.min(20 * pixel, 0.6 * length);
    const width = Math.min(2.2 * pixel, 0.12 * length);
    const turn = new T.Quaternion().setFromUnitVectors(new T.Vector3(0, 1, 0), new T.Vector3(...way));
    shaft.scale.set(width, length - headLength, width);
    shaft.position.set(...plus(from, times(way, (length - headLength) / 2)));
    head.scale.set(headLength * 0.36, headLength, headLength * 0.36);
    head.position.set(...plus(to, times(way, -headLength / 2)));
    shaft.quaternion.copy(turn);
    head.quaternion.copy(turn);
  });
  return { group, place(p, q) { from = p; to = q; } };
}

/** The directions of x and y, from a corner: {lines, ends: [place, place]}, the ends a little beyond the lines. */
export function axes(corner, length) {
  const along = (far) => [[far, 0, 0], [0, far, 0]].map((by) => plus(corner, by));
  const lines = segments(along(length).flatMap((tip) => [corner, tip]), "--soft", layer.strong, { width: 1.5, depthTest: false });
  return { lines, ends: along(1.3 * length) };
}

/** A feature in contact: a dot, a thick line, or a thick outline with its area. Seen through what hides it, but fainter. */
export function feature(points, name, normal) {
  const T = globalThis.THREE, group = new T.Group();
  const seen = { depthWrite: false }, behind = { depthWrite: false, depthTest: false, opacity: 0.4 };
  if (points.length === 1) group.add(dots(points, name, layer.faint, behind), dots(points, name, layer.strong, seen));
  if (points.length < 2) return group;
  const around = inOrder(points, normal), sides = points.length === 2 ? around.slice(0, 1) : around;
  const ends = sides.flatMap((p, i) => [p, around[(i + 1) % around.length]]);
  group.add(segments(ends, name, layer.faint, { width: 5, ...behind }), segments(ends, name, layer.strong, { width: 5, ...seen }));
  if (points.length > 2) {
    const area = triangles(around, [around.map((_, i) => i)]);
    group.add(surface(meshGeometry(area), name, layer.faint, { flat: true, side: T.DoubleSide, ...behind, opacity: 0.22 }));
  }
  return group;
}

/** A square of a plane with its outline; upon the plane of x and y, a line of it. */
export function planeSquare(place, normal, half, name, flat = false) {
  if (flat) {
    const ends = [-half, half].map((by) => plus(place, times(cross([0, 0, 1], unit(normal)), by)));
    return segments(ends, name, layer.plane + 1, { width: 1.2, opacity: 0.7, depthWrite: false });
  }
  const T = globalThis.THREE, group = new T.Group(), x = times(across(normal), half), y = cross(unit(normal), x);
  const ring = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([i, j]) => plus(place, plus(times(x, i), times(y, j))));
  const glass = { flat: true, side: T.DoubleSide, depthWrite: false, opacity: 0.16 };
  const sides = ring.flatMap((p, i) => [p, ring[(i + 1) % 4]]);
  group.add(surface(meshGeometry(triangles(ring, [[0, 1, 2, 3]])), name, layer.plane, glass));
  group.add(segments(sides, name, layer.plane + 1, { width: 1.2, opacity: 0.7, depthWrite: false }));
  return group;
}
