// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3, the sphere of directions with both Gaussian diagrams, lifted off a ball that hides its far side. Each colour of a hemisphere
// is one batch of lines. The camera and the chart go together: to choose a hemisphere turns the ball to it, and while both are shown the
// chart is that of the one in front.
import { dot, norm, times } from "./geometry.js";
import { hemisphereOfChoice, litArcs, litInDiagrams } from "./lit.js";
import { calm, colour, element } from "./look.js";
import { onViewLook, withView } from "./scene.js";
import { equatorOf, facingOf, halvesOfArcs, segmentsOf, stationOf, stripOnSphere } from "./spheregeometry.js";

const sphereDistance = 5.1,
  mostFaint = 200,
  greaterDepth = 6; // three.js: GreaterDepth
const ballRadius = 0.985,
  litRadius = 1.006;

export function mountSphere(root, data, selection) {
  if (data.charts.length === 0) return {};
  return withView(root, sphereLabel(data), (picture) => startSphere(root, data, selection, picture));
}

function startSphere(root, data, selection, picture) {
  const view = {
    data,
    selection,
    picture,
    camera: picture.camera,
    section: root.closest("section") ?? root,
    frames: data.charts.map((chart) => chart.frame),
  };
  root.replaceChildren(element("figure", {}, sphereTools(view), picture.stage, sphereCaption(data)));
  makeSphereScene(view);
  view.facing = facingOf(view.camera.position.toArray(), view.frames[0].z);
  picture.controls.addEventListener("change", () => sphereTurned(view));
  picture.label("n", "of-true", () => placeOfLabel(view));
  picture.resize();
  onViewLook(picture, () => colourSphere(view));
  selection.subscribe((state, changed) => showSphere(view, state, changed));
  return { lit: () => ({ sphere: litArcs(litInDiagrams(data, selection.get())) }), drawCalls: picture.drawCalls };
}

function sphereLabel({ bodies }) {
  return `Sphere of directions with the Gaussian diagrams of minus A, ${bodies.a.arcs.length} arcs, and of B, ${bodies.b.arcs.length} arcs`;
}

function sphereTools(view) {
  const button = (text, label, onclick) => element("button", { type: "button", "aria-label": label, title: label, onclick }, text);
  const turn = (x, y) => () => swingSphere(view, stationTurned(view, x, y));
  const zoom = (factor) => () => {
    const distance = Math.min(2 * sphereDistance, Math.max(1.15, factor * view.camera.position.length()));
    view.picture.look([0, 0, 0], distance, { from: view.camera.position.toArray(), up: view.frames[0].v });
  };
  const toOptimum = () => {
    const n = view.data.optima[view.selection.get().optimum]?.direction;
    if (n) swingSphere(view, times(n, sphereDistance));
  };
  return element(
    "div",
    { class: "bar", role: "group", "aria-label": "View of the sphere" },
    button("\u2190", "turn left", turn(-0.4, 0)),
    button("\u2192", "turn right", turn(0.4, 0)),
    button("\u2191", "turn up", turn(0, 0.4)),
    button("\u2193", "turn down", turn(0, -0.4)),
    button("+", "larger", zoom(0.8)),
    button("\u2212", "smaller", zoom(1.25)),
    view.data.optima.length > 0 ? button("to n", "to n, the optimum", toOptimum) : null,
  );
}

function sphereCaption({ bodies }) {
  const key = (name, text) => element("span", { class: `key-${name}` }, text);
  const faint = bodies.a.arcs.length + bodies.b.arcs.length <= mostFaint;
  return element(
    "figcaption",
    {},
    "A direction is a point of the sphere. ",
    key("a", "Diagram of \u2212A, solid"),
    "; ",
    key("b", "of B, dashed"),
    `: nodes are facets, arcs are edges, faces are vertices. The far side is ${faint ? "faint" : "hidden"}. Drag to turn.`,
  );
}

// ---- the scene ----

function makeSphereScene(view) {
  const { data, frames } = view;
  const { scene, controls } = view.picture,
    shown = view.selection.get();
  const lower = shown.hemisphere === "lower" || (shown.hemisphere === "both" && startsBelow(data, shown));
  const station = stationOf(frames[lower && frames[1] ? 1 : 0], sphereDistance);
  view.picture.look([0, 0, 0], sphereDistance, { from: station, up: frames[0].v });
  Object.assign(controls, { enablePan: false, minDistance: 1.1, maxDistance: 2 * sphereDistance });
  view.ball = new THREE.Mesh(new THREE.SphereGeometry(ballRadius, 96, 48), new THREE.MeshBasicMaterial());
  scene.add(view.ball);
  // Half a dozen dashes in an arc of middling length: of k arcs round the sphere that is about 3 / sqrt(k).
  const dash = Math.min(0.035, 0.35 / Math.sqrt(data.bodies.b.arcs.length));
  view.materials = {
    a: sphereLine("a", false),
    b: sphereLine("b", false, dash),
    faintA: sphereLine("a", true),
    faintB: sphereLine("b", true, dash),
    equator: new THREE.LineBasicMaterial(),
    wall: new THREE.LineBasicMaterial(),
    mark: new THREE.MeshBasicMaterial(),
    litA: new THREE.LineMaterial({ linewidth: 3.5 }),
    litB: new THREE.LineMaterial({ linewidth: 3.5, dashed: true, dashSize: 0.07, gapSize: 0.025 }),
    nodeA: new THREE.PointsMaterial({ size: 10, sizeAttenuation: false }),
    nodeB: new THREE.PointsMaterial({ size: 12, sizeAttenuation: false }),
  };
  view.halves = [new THREE.Group(), new THREE.Group()];
  const few = data.bodies.a.arcs.length + data.bodies.b.arcs.length <= mostFaint;
  for (const name of ["a", "b"]) addDiagram(view, name, few);
  view.equator = sphereSegments([equatorOf(frames[0])], 1, view.materials.equator);
  view.chosen = new THREE.Group();
  view.pin = spherePin(view.materials.mark);
  scene.add(...view.halves, view.equator, view.chosen, view.pin);
}

function startsBelow(data, { pair, optimum }) {
  return pair !== null ? data.pairs[pair].chart === 1 : (data.optima[optimum]?.direction?.[2] ?? 0) < 0;
}

function sphereLine(name, faint, dash) {
  const material = name === "a" ? new THREE.LineBasicMaterial() : new THREE.LineDashedMaterial({ dashSize: dash, gapSize: 0.6 * dash });
  if (faint) Object.assign(material, { transparent: true, opacity: 0.22, depthFunc: greaterDepth, depthWrite: false });
  return material;
}

function sphereSegments(polylines, radius, material) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(segmentsOf(polylines, radius), 3));
  const lines = new THREE.LineSegments(geometry, material);
  if (material.isLineDashedMaterial) lines.computeLineDistances();
  lines.frustumCulled = false;
  return lines;
}

function addDiagram(view, name, few) {
  const body = view.data.bodies[name],
    halves = halvesOfArcs(body, body.arcs.keys(), view.frames[0].z);
  halves.forEach((polylines, i) => {
    if (polylines.length === 0) return;
    const lines = sphereSegments(polylines, 1, view.materials[name]);
    view.halves[i].add(lines);
    if (few) {
      const far = new THREE.LineSegments(lines.geometry, view.materials[name === "a" ? "faintA" : "faintB"]);
      far.renderOrder = 1; // after the ball, which it is compared with
      view.halves[i].add(far);
    }
  });
}

/** The mark of the optimum: a pin that stands on the sphere, along its own y-axis. */
function spherePin(material) {
  const pin = new THREE.Group();
  const needle = new THREE.Mesh(new THREE.CylinderGeometry(0.008, 0.008, 0.2, 8), material),
    head = new THREE.Mesh(new THREE.SphereGeometry(0.026, 16, 12), material);
  needle.position.set(0, 1.08, 0);
  head.position.set(0, 1.19, 0);
  pin.add(needle, head);
  return pin;
}

// ---- what changes ----

function showSphere(view, state, changed) {
  const { data } = view;
  view.halves.forEach((half, i) => (half.visible = state.hemisphere === "both" || (state.hemisphere === "lower") === (i === 1)));
  const n = data.optima[state.optimum]?.direction;
  view.pin.visible = Boolean(n);
  if (n) view.pin.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(...n).normalize());
  litOnSphere(view, state);
  const first = changed.has("moved") && changed.has("section");
  const asked = state.hemisphere === "both" ? hemisphereOfChoice(data, view.selection.chosen(), changed) : null;
  if (!first && changed.has("hemisphere") && state.hemisphere !== "both") faceHemisphere(view, state.hemisphere === "lower" ? 1 : 0);
  else if (!first && asked !== null) faceHemisphere(view, asked);
  view.picture.render();
}

function faceHemisphere(view, index) {
  if (facingOf(view.camera.position.toArray(), view.frames[0].z) !== index)
    swingSphere(view, stationOf(view.frames[index], sphereDistance));
}

function litOnSphere(view, state) {
  const { data } = view,
    lit = litInDiagrams(data, state),
    pole = view.frames[0].z;
  for (const child of view.chosen.children) child.geometry.dispose();
  view.chosen.clear();
  for (const name of ["a", "b"]) {
    const halves = halvesOfArcs(data.bodies[name], lit[name].arcs, pole),
      material = view.materials[`lit${name.toUpperCase()}`];
    const segments = segmentsOf(halves.filter((_, i) => view.halves[i].visible).flat(), litRadius);
    if (segments.length > 0) {
      const lines = new THREE.LineSegments2(new THREE.LineSegmentsGeometry().setPositions(segments), material);
      if (material.dashed) lines.computeLineDistances();
      view.chosen.add(lines);
    }
    const nodes = lit[name].nodes.flatMap((node) => times(data.bodies[name].nodes[node], name === "a" ? 1.012 : 1.01));
    if (nodes.length > 0) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.Float32BufferAttribute(nodes, 3));
      view.chosen.add(new THREE.Points(geometry, view.materials[`node${name.toUpperCase()}`]));
    }
  }
  if (state.pair === null) return;
  const pair = data.pairs[state.pair];
  view.chosen.add(sphereSegments(stripOnSphere(pair, data.charts[pair.chart], data.bodies), 1.001, view.materials.wall));
}

function colourSphere(view) {
  const { materials } = view,
    set = (material, name) => material.color.set(colour(name));
  for (const name of ["a", "faintA", "litA", "nodeA"]) set(materials[name], "--a");
  for (const name of ["b", "faintB", "litB", "nodeB"]) set(materials[name], "--b");
  set(materials.equator, "--line");
  set(materials.wall, "--lit");
  set(materials.mark, "--true");
  set(view.ball.material, "--ground");
}

// ---- the camera ----

/** Where the camera would stand, turned about v by x and up by y. */
function stationTurned({ camera }, x, y) {
  const distance = camera.position.length(),
    [px, py, pz] = camera.position.toArray();
  const polar = Math.min(3.1, Math.max(0.04, Math.acos(py / distance) - y)),
    azimuth = Math.atan2(px, pz) + x;
  return times([Math.sin(polar) * Math.sin(azimuth), Math.cos(polar), Math.sin(polar) * Math.cos(azimuth)], distance);
}

/** Turns the camera to another station, at once for a reader who asked for less motion. */
function swingSphere(view, to) {
  const from = view.camera.position.toArray(),
    start = performance.now(),
    lasts = calm() ? 0 : 350;
  const distance = norm(to),
    up = view.frames[0].v;
  const swing = (view.swing = () => {
    if (view.swing !== swing) return;
    const t = lasts > 0 ? Math.min(1, (performance.now() - start) / lasts) : 1,
      s = t * t * (3 - 2 * t);
    const between = from.map((x, i) => x + s * (to[i] - x));
    // Half way between opposite stations there is no direction: pass beside it.
    view.picture.look([0, 0, 0], distance, { from: norm(between) > 0.3 ? between : [1, 0.01, 0], up });
    sphereTurned(view);
    if (t < 1) requestAnimationFrame(swing);
  });
  swing();
}

function sphereTurned(view) {
  const facing = facingOf(view.camera.position.toArray(), view.frames[0].z);
  if (facing === view.facing) return;
  view.facing = facing;
  view.section.dispatchEvent(new CustomEvent("facing", { detail: facing }));
}

/** The place of the word n, beyond the head of the pin; null behind the ball. */
function placeOfLabel(view) {
  const n = view.data.optima[view.selection.get().optimum]?.direction,
    camera = view.camera.position.toArray();
  return n && dot(n, camera) > -0.35 * norm(camera) ? times(n, 1.32) : null;
}
