// SPDX-License-Identifier: GPL-3.0-or-later
// Section 1, What happens: the two bodies, the way out, and A moving along it.
import { arrowOf, contactText, wayOf } from "./contact.js";
import { frameOf, minus, norm, plus, sideView, times } from "./geometry.js";
import { calm, element } from "./look.js";
import { onViewLook, withView } from "./scene.js";
import { arrow, dots, emptied, feature, hatched, layer, meshGeometry, planeSquare, recolour, segments, surface, triangles } from "./solids.js";

const mostHidden = 200;  // edges: of a body with more, those behind it are not drawn

export function mountWhat(root, data, selection) {
  return withView(root, whatLabel(data), (view) => whatPicture(root, view, data, selection));
}

function whatLabel(data) {
  const way = wayOf(data, { facet: null, optimum: 0 });
  const seen = `Bodies A, toned, and B, hatched, in space. ${contactText(way, data)}`;
  return `${seen} Shift and arrow keys turn, plus and minus zoom.`;
}

/** Faces and edges of a body that stands in a frame; A is solid, B is glass with stripes. */
function bodyParts(view, body, frame, isB) {
  const T = globalThis.THREE, group = new T.Group(), name = isB ? "--b" : "--a", order = isB ? layer.edges : layer.solidEdges;
  const places = body.vertices.map(frame.place), faces = [];
  if (body.facets.length) {
    const geometry = meshGeometry(triangles(places, body.facets)), back = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    if (isB) {
      faces.push(surface(geometry, name, layer.backs, { side: T.BackSide, opacity: 0.14, depthWrite: false }));
      faces.push(surface(geometry, name, layer.glass, { opacity: 0.5, depthWrite: false }, 0.3));
      faces.push(surface(geometry, name, layer.glassDepth, { flat: true, colorWrite: false, ...back }));
    } else faces.push(surface(geometry, name, layer.solid, { opacity: 0.8, ...back }));
  }
  const edges = body.edges.flatMap(([v, w]) => [places[v], places[w]]), hidden = [];
  const lines = segments(edges, name, order + 1, { width: body.facets.length ? 1.6 : 3, depthWrite: false });
  if (body.facets.length && body.edges.length <= mostHidden)
    hidden.push(segments(edges, name, order, { width: 1, dash: 0.035, opacity: 0.55, depthWrite: false, depthFunc: T.GreaterDepth }));
  group.add(...faces, ...hidden, lines);
  if (places.length === 1) group.add(dots(places, name, layer.strong, {}));
  return { group, setWires(on) { for (const part of faces) part.visible = !on; } };
}

/** Outlines of A where it is not: dashed. Of many edges they would be noise; then a faint solid. */
function ghostOf(body, frame) {
  const T = globalThis.THREE, places = body.vertices.map(frame.place);
  if (body.edges.length > 0 && body.edges.length <= mostHidden)
    return segments(body.edges.flatMap(([v, w]) => [places[v], places[w]]), "--a", layer.solidEdges + 2, { width: 1, dash: 0.03, opacity: 0.6, depthWrite: false });
  if (!body.facets.length) return new T.Group();
  return surface(meshGeometry(triangles(places, body.facets)), "--a", layer.backs + 1, { opacity: 0.13, depthWrite: false });
}

function whatPicture(root, view, data, selection) {
  const T = globalThis.THREE, { a, b } = data.bodies;
  const shortest = wayOf(data, { facet: null, optimum: 0 }) ?? { translation: [0, 0, 0], direction: [0, 0, 1], a: [], b: [] };
  const frame = frameOf([...a.vertices, ...b.vertices, ...a.vertices.map((p) => plus(p, shortest.translation))]);
  const bodyA = bodyParts(view, a, frame, false), bodyB = bodyParts(view, b, frame, true);
  const nowhere = ghostOf(a, frame), out = ghostOf(a, frame), contactA = new T.Group(), contactB = new T.Group(), litA = new T.Group(), litB = new T.Group();
  const movingA = new T.Group(), plane = new T.Group(), shaft = arrow(view, "--true");
  movingA.add(bodyA.group, contactA, litA);
  view.scene.add(bodyB.group, movingA, nowhere, out, contactB, litB, plane, shaft.group);

  let way = shortest, ends = arrowOf(data, way), drawn = null, lit = [];
  const letters = { a: labelPlace(a, frame), b: labelPlace(b, frame) };
  view.label("A", "of-a", () => letters.a && plus(letters.a, movingA.position.toArray()));
  view.label("B", "of-b", () => letters.b);

  function drawWay(state) {
    way = wayOf(data, state) ?? shortest;
    ends = arrowOf(data, way);
    const normal = frame.normal(way.direction), placed = (body, vertices) => vertices.map((v) => frame.place(body.vertices[v]));
    emptied(contactA).add(feature(placed(a, way.a), "--a", normal));
    emptied(contactB).add(feature(placed(b, way.b), "--b", normal));
    emptied(plane).add(planeSquare(frame.place(ends.to), normal, planeSize([a, b], frame), "--true"));
    shaft.place(frame.place(ends.from), frame.place(ends.to));
    out.position.set(...frame.move(way.translation));
  }

  function moveTo(share) {
    const by = frame.move(times(way.translation, share));
    movingA.position.set(...by);
    nowhere.visible = share > 0.02 && norm(by) > 0;
    out.visible = share < 0.98 && norm(frame.move(way.translation)) > 0;
  }

  function drawLit(state) {
    lit = litEdges(data, state);
    const draw = (group, name, body, of) => {
      const own = lit.filter(([colour]) => colour === of).flatMap(([, e]) => body.edges[e].map((v) => frame.place(body.vertices[v])));
      emptied(group).add(segments(own, name, layer.faint, { width: 4, opacity: 0.5, depthTest: false, depthWrite: false }), segments(own, name, layer.strong, { width: 4, depthWrite: false }));
    };
    draw(litA, "--lit", a, "a");
    draw(litB, "--lit", b, "b");
  }

  selection.subscribe((state, changed) => {
    if (changed.has("optimum") || changed.has("facet")) drawWay(state);
    if (changed.has("pair") || changed.has("coincidence")) drawLit(state);
    moveTo(state.moved);
    view.render();
  });

  const shown = () => [...b.vertices, ...a.vertices, ...a.vertices.map((p) => plus(p, way.translation))].map(frame.place);
  const views = {
    fit: () => view.fit(shown(), sideView(frame.move(way.translation))),
    "along n": () => view.fit(shown(), { from: times(frame.normal(way.direction), 1), up: sideView(frame.move(way.translation)).up }),
    contact: () => lookAtContact(view, frame, data, way, ends),
  };
  root.append(controlsOf(view, selection, views, [bodyA, bodyB], data), legend(data, frame));
  views.fit();
  onViewLook(view, () => recolour(view.scene));
  return {
    drawCalls: view.drawCalls,
    lit: () => ({ bodies: lit }),
    contact: () => contactDrawn(data, frame, way, movingA, ends),
  };
}

/** The middle of a body. */
function labelPlace(body, frame) {
  if (!body.vertices.length) return null;
  const own = frameOf(body.vertices.map(frame.place));
  return own.center;
}

/** Half of the plane's side: it reaches over both bodies' shadows on it, but not far. */
function planeSize(bodies, frame) {
  const halves = bodies.map((body) => 1 / Math.min(...frameOf(body.vertices.map(frame.place)).scale));
  return Math.min(1.1, Math.max(0.25, 1.3 * Math.max(...halves)));
}

/** The edges that a pair, or a coincidence, is about. */
export function litEdges(data, state) {
  if (state.pair !== null) {
    const pair = data.pairs[state.pair];
    return [...pair.a.map((e) => ["a", e]), ...pair.b.map((e) => ["b", e])];
  }
  const item = state.coincidence === null ? null : data.coincidence(state.coincidence);
  if (!item) return [];
  return ["a", "b"].flatMap((of) => [...new Set(item[of].flatMap((vertices) => data.edgesOf(of, vertices)))].map((e) => [of, e]));
}

function lookAtContact(view, frame, data, way, ends) {
  const length = norm(frame.move(way.translation));
  const features = [...way.a.map((v) => plus(data.bodies.a.vertices[v], way.translation)), ...way.b.map((v) => data.bodies.b.vertices[v])].map(frame.place);
  const span = Math.max(0, ...features.map((p) => norm(minus(p, frame.place(ends.to)))));
  const radius = length > 0 ? Math.max(1.3 * length, 1e-5) : Math.max(0.6 * span, 0.2);
  view.look(times(plus(frame.place(ends.from), frame.place(ends.to)), 0.5), radius * 4.4, sideView(frame.move(way.translation)));
}

/** What tests ask: the features as they are drawn, back in places of the input, with A where it is. */
function contactDrawn(data, frame, way, movingA, ends) {
  const by = movingA.position.toArray().map((x, i) => x / frame.scale[i]);
  const moved = (p) => plus(p, by);
  return {
    a: way.a.map((v) => moved(data.bodies.a.vertices[v])),
    b: way.b.map((v) => data.bodies.b.vertices[v]),
    witness: { a: moved(ends.from), b: ends.to },
    direction: way.direction,
  };
}

function controlsOf(view, selection, views, bodies, data) {
  const button = (name, title, act) => element("button", { type: "button", title, onclick: act }, name);
  const wires = button("wireframe", "Edges without faces", () => {
    const on = wires.getAttribute("aria-pressed") !== "true";
    wires.setAttribute("aria-pressed", String(on));
    for (const body of bodies) body.setWires(on);
    view.render();
  });
  wires.setAttribute("aria-pressed", "false");
  const buttons = element("div", { class: "buttons", role: "group", "aria-label": "Views" },
    button("fit", "All of both bodies, across the way out", views.fit), button("along n", "Against the direction of the way out", views["along n"]),
    button("contact", "Close to where the bodies meet", views.contact), wires);
  const slider = sliderOf(selection);
  const bar = element("div", { class: "controls" });
  if (norm(wayOf(data, { facet: null, optimum: 0 })?.translation ?? [0, 0, 0]) > 0) bar.append(slider);
  bar.append(buttons);
  return bar;
}

/** The slider that moves A out, and a button that lets it move by itself. */
function sliderOf(selection) {
  const range = element("input", { type: "range", min: 0, max: 1, step: 0.001, id: "moved", "aria-label": "How far A has moved out" });
  let playing = 0;
  range.addEventListener("input", () => {
    cancelAnimationFrame(playing);
    selection.set({ moved: Number(range.value) });
  });
  const play = (to) => () => {
    cancelAnimationFrame(playing);
    const from = selection.get().moved, began = performance.now(), time = calm() ? 1 : 900 * Math.abs(to - from);
    const step = (now) => {
      const share = Math.min(1, Math.max(0, (now - began) / Math.max(1, time))), eased = share * share * (3 - 2 * share);
      selection.set({ moved: share === 1 ? to : from + (to - from) * eased });
      if (share < 1) playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
  };
  selection.subscribe((state) => {
    range.value = String(state.moved);
    range.setAttribute("aria-valuetext", `${Math.round(100 * state.moved)} % of the way`);
  });
  return element("div", { class: "slider" },
    element("button", { type: "button", class: "plain", onclick: play(0) }, "A now"), range,
    element("button", { type: "button", class: "plain", onclick: play(1) }, "A moved out"));
}

function legend(data, frame) {
  const apart = data.status === "disjoint";
  const words = [
    element("span", { class: "of-a" }, "A solid"), ", ", element("span", { class: "of-b" }, "B hatched"), "; where they meet is thick. ",
    element("span", { class: "of-true" }, apart ? "Arrow: the shortest way of A to B." : data.status === "penetrating" ? "Arrow: the way out of A" : "Plane: it separates them."),
    data.status === "penetrating" ? ", ending at the plane that then separates both; dashed: A at its end." : "",
  ];
  const legendText = element("p", { class: "soft legend" }, ...words);
  if (frame.apart) legendText.append(element("strong", {}, " Axes scaled apart: the extents differ more than a hundredfold."));
  return legendText;
}
