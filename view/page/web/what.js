// SPDX-License-Identifier: GPL-3.0-or-later
// Section 1, What happens: the two bodies, the way out, and A moving along it.
import { bodyParts, ghostOf, isFaint } from "./bodies.js";
import { arrowOf, contactText, meetingOf, wayOf } from "./contact.js";
import { dot, frameOf, middle, minus, norm, planeView, plus, sideView, times } from "./geometry.js";
import { calm, element } from "./look.js";
import { carrierOf } from "./motions.js";
import { placesOf } from "./places.js";
import { onViewLook, withView } from "./scene.js";
import { secondNormal } from "./uniondata.js";
import { arrow, axes, carry, emptied, feature, layer, planeSquare, recolour, segments } from "./solids.js";

const mostContactsDrawn = 60;
const unseen = 0.012;  // of the picture: a shorter arrow is not seen

export function mountWhat(root, data, selection) {
  if (!data.bodies.a.vertices.length || !data.bodies.b.vertices.length) return {};
  return withView(root, whatLabel(data), (view) => whatPicture(root, view, data, selection), data.plane);
}

function whatLabel(data) {
  const way = wayOf(data, { facet: null, optimum: 0 });
  const seen = `Bodies A, toned, and B, hatched, in ${data.plane ? "the plane" : "space"}. ${contactText(way, data)}`;
  return data.plane ? `${seen} Plus and minus zoom.` : `${seen} Shift and arrow keys turn, plus and minus zoom.`;
}

/** The way that is shown before anything is chosen; nothing to move where there is none. */
function firstWay(data) {
  return wayOf(data, { facet: null, optimum: 0 }) ?? { translation: [0, 0, 0], direction: [0, 0, 1], a: [], b: [], facet: null, patches: [] };
}

/** What touches once A has moved: of convex bodies one pair of features, of unions one for each pair of pieces. */
function contactsOf(way) {
  return way.contacts ?? [{ direction: way.direction, a: way.a, b: way.b }];
}

function whatPicture(root, view, data, selection) {
  const { a, b } = data.bodies, first = firstWay(data);
  const frame = frameOf([...a.vertices, ...b.vertices, ...a.vertices.map((p) => plus(p, first.translation))]);
  const bodies = [bodyParts(a, frame, false, data.plane), bodyParts(b, frame, true, data.plane)];
  const moving = movingParts(view, data, frame, bodies);
  view.scene.add(bodies[1].group);
  selection.subscribe((state, changed) => {
    if (changed.has("optimum") || changed.has("facet")) moving.setWay(wayOf(data, state) ?? first);
    if (changed.has("pair") || changed.has("coincidence")) moving.setLit(litEdges(data, state));
    moving.moveTo(state.moved, carrierOf(data, state));
    view.render();
  });
  letters(view, bodies, moving, frame);
  const corner = data.plane ? axesIn(view) : [];

  const views = viewsOf(view, data, frame, moving, corner);
  root.append(controlsOf(view, selection, views, bodies, data, norm(first.translation) > 0), legend(data, frame, bodies, first));
  views.fit();
  onViewLook(view, () => recolour(view.scene));
  return { drawCalls: view.drawCalls, lit: () => ({ bodies: moving.lit() }), contact: () => contactDrawn(data, frame, moving) };
}

/** A with what moves with it, the contact, the plane and the arrow: they follow the way that is looked at. */
function movingParts(view, data, frame, [bodyA, bodyB]) {
  const T = globalThis.THREE, { a, b } = data.bodies, group = () => new T.Group();
  const movingA = group(), start = ghostOf(a, frame), out = ghostOf(a, frame), plane = group(), shaft = arrow(view, "--true");
  const contact = { a: group(), b: group() }, litGroup = { a: group(), b: group() };
  const half = Math.min(1.1, Math.max(0.25, 1.05 * Math.max(bodyA.size, bodyB.size)));  // of the plane's side
  let way = firstWay(data), ends = arrowOf(data, way), lit = [], share = 0, motion = null;
  movingA.add(bodyA.group, contact.a, litGroup.a);
  view.scene.add(movingA, start, out, contact.b, litGroup.b, plane, shaft.group);
  const self = {
    group: movingA,
    way: () => way,
    ends: () => ends,
    lit: () => lit,
    share: () => share,
    /** Where a place of A in the frame is now. */
    carried: (p) => (motion ? frame.place(motion(frame.back(p))) : plus(p, frame.move(times(way.translation, share)))),
    setWay(next) {
      way = next;
      ends = arrowOf(data, way);
      const placed = (body, vertices) => vertices.map((v) => frame.place(body.vertices[v])), contacts = contactsOf(way);
      for (const group of [contact.a, contact.b, plane]) emptied(group);
      for (const each of contacts.slice(0, mostContactsDrawn)) {
        const normal = frame.normal(each.direction), at = frame.place(contacts.length > 1 ? meetingOf(data, { ...way, contacts: [each] }) : ends.to);
        contact.a.add(feature(placed(a, each.a), "--a", normal));
        contact.b.add(feature(placed(b, each.b), "--b", normal));
        plane.add(planeSquare(at, normal, contacts.length > 1 ? half / 3 : half, "--true", view.flat));
      }
      for (const patch of way.patches.slice(0, mostContactsDrawn)) {
        contact.a.add(feature(patch.a.map(frame.place), "--true", frame.normal(patch.direction)));
        contact.b.add(feature(patch.b.map(frame.place), "--true", frame.normal(patch.direction)));
      }
      shaft.place(frame.place(ends.from), frame.place(ends.to));
      out.position.set(...frame.move(way.translation));
      self.moveTo(share, motion);
    },
    /** A share of the way out; or where a motion carries A, if it does. */
    moveTo(next, carrier) {
      [share, motion] = [next, carrier];
      const far = norm(frame.move(way.translation)) > 0;
      carry(movingA, self.carried);
      start.visible = motion !== null || (far && share > 0.02);
      out.visible = motion === null && far && share < 0.98;
    },
    setLit(edges) {
      lit = edges;
      for (const [of, body] of [["a", a], ["b", b]]) {
        const own = lit.filter(([colour]) => colour === of).flatMap(([, e]) => body.edges[e].map((v) => frame.place(body.vertices[v])));
        const seen = { width: 4, depthWrite: false }, behind = { ...seen, opacity: 0.5, depthTest: false };
        emptied(litGroup[of]).add(segments(own, "--lit", layer.faint, behind), segments(own, "--lit", layer.strong, seen));
      }
    },
  };
  return self;
}

/** The letters stand in the bodies, apart along the way where the bodies' middles are one. */
function letters(view, [bodyA, bodyB], moving, frame) {
  const aside = (body, by) => {
    const way = frame.move(moving.way().translation), length = norm(way);
    const shift = length > 0 ? times(way, (by * body.stand) / length) : [0, 0, by * body.stand];
    return body.middle && plus(body.middle, shift);
  };
  view.label("A", "of-a", () => { const at = aside(bodyA, 0.35); return at && moving.carried(at); });
  view.label("B", "of-b", () => aside(bodyB, -0.35));
}

/** The axes, left of and below all bodies; returns their places. */
function axesIn(view) {
  const corner = [-1.06, -1.06, 0], { lines, ends } = axes(corner, 0.2);
  view.scene.add(lines);
  ["x", "y"].forEach((name, i) => view.label(name, "of-axis", () => ends[i]));
  return [corner, ...ends];
}

function viewsOf(view, data, frame, moving, corner) {
  const { a, b } = data.bodies;
  const places = a.vertices.map(frame.place);
  const all = () => [...[...b.vertices, ...a.vertices.map((p) => plus(p, moving.way().translation))].map(frame.place), ...places, ...places.map(moving.carried), ...corner];
  const side = () => (data.plane ? planeView : sideView(frame.move(moving.way().translation), secondNormal(moving.way())));
  return {
    fit: () => view.fit(all(), side()),
    alongN: () => view.fit(all(), { from: frame.normal(moving.way().direction), up: side().up }),
    contact: () => lookAtContact(view, frame, data, moving),
  };
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

function lookAtContact(view, frame, data, moving) {
  const way = moving.way(), ends = moving.ends(), length = norm(frame.move(way.translation));
  const ofA = way.a.map((v) => plus(data.bodies.a.vertices[v], way.translation)), ofB = way.b.map((v) => data.bodies.b.vertices[v]);
  const features = [...ofA, ...ofB].map(frame.place);
  const span = Math.max(0, ...features.map((p) => norm(minus(p, frame.place(ends.to)))));
  const radius = length > 0 ? Math.max(1.3 * length, 1e-5) : Math.max(0.6 * span, 0.2);
  view.look(times(plus(frame.place(ends.from), frame.place(ends.to)), 0.5), radius * 4.4, data.plane ? planeView : sideView(frame.move(way.translation)));
}

/** What tests ask: the features in places of the data, A's where it is drawn, and how far A's is before B's along n, in input's units. */
function contactDrawn(data, frame, moving) {
  const way = moving.way(), moved = (p) => plus(p, times(way.translation, moving.share()));
  const drawn = { a: way.a.map((v) => moved(data.bodies.a.vertices[v])), b: way.b.map((v) => data.bodies.b.vertices[v]) };
  const witness = { a: moved(moving.ends().from), b: moving.ends().to };
  const height = (points, other) => dot(points.length ? middle(points) : other, way.direction);
  const gap = height(drawn.b, witness.b) - height(drawn.a, witness.a);
  const { back } = placesOf(data.stages), heightOf = (points, n) => dot(middle(points), n);
  const gaps = contactsOf(way).map((each) => back(heightOf(each.b.map((v) => data.bodies.b.vertices[v]), each.direction) -
    heightOf(each.a.map((v) => moved(data.bodies.a.vertices[v])), each.direction)));
  return { ...drawn, witness, direction: way.direction, gap: back(gap), gaps };
}

function controlsOf(view, selection, views, bodies, data, canMove) {
  const button = (name, title, act) => element("button", { type: "button", title, onclick: act }, name);
  const wires = button("wireframe", "Edges without faces", () => {
    const on = wires.getAttribute("aria-pressed") !== "true";
    wires.setAttribute("aria-pressed", String(on));
    for (const body of bodies) body.setWires(on);
    view.render();
  });
  wires.setAttribute("aria-pressed", "false");
  const buttons = element("div", { class: "buttons", role: "group", "aria-label": "Views" },
    button("fit", "All of both bodies, across the way out", views.fit),
    data.plane ? null : button("along n", "Against the direction of the way out", views.alongN),
    button("contact", "Close to where the bodies meet", views.contact), wires);
  return element("div", { class: "controls" }, canMove ? sliderOf(selection, data.status) : null, buttons);
}

/** The slider that moves A out, and a button that lets it move by itself. */
function sliderOf(selection, status) {
  const range = element("input", { type: "range", min: 0, max: 1, step: 0.001, id: "moved", "aria-label": "How far A has moved" });
  let playing = 0;
  range.addEventListener("input", () => {
    cancelAnimationFrame(playing);
    selection.set({ moved: Number(range.value), step: 0 });
  });
  const play = (to) => () => {
    cancelAnimationFrame(playing);
    const from = selection.get().moved, began = performance.now(), time = calm() ? 1 : 900 * Math.abs(to - from);
    const step = (now) => {
      const share = Math.min(1, Math.max(0, (now - began) / Math.max(1, time))), eased = share * share * (3 - 2 * share);
      selection.set({ moved: share === 1 ? to : from + (to - from) * eased, step: 0 });
      if (share < 1) playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
  };
  selection.subscribe((state) => {
    if (state.step > 0) cancelAnimationFrame(playing);  // A stands on a motion now
    range.value = String(state.moved);
    range.setAttribute("aria-valuetext", `${Math.round(100 * state.moved)} % of the way`);
  });
  return element("div", { class: "slider" },
    element("button", { type: "button", class: "plain", onclick: play(0) }, "A now"), range,
    element("button", { type: "button", class: "plain", onclick: play(1) }, status === "disjoint" ? "A moved to B" : "A moved out"));
}

function endOf(data, way) {
  const line = data.plane ? "line" : "plane";
  if (way.contacts) return `where pieces touch; ${data.plane ? "lines separate those" : "squares: planes between those"}`;
  return `at the ${line} that then separates both`;
}

function legend(data, frame, bodies, way) {
  const overlap = data.status === "penetrating", apart = data.status === "disjoint", touching = data.status === "touching";
  const length = norm(frame.move(way.translation));
  const arrowText = overlap ? "Arrow: the way out of A" : apart ? "Arrow: the shortest way of A to B." : touching ? `${data.plane ? "Line" : "Plane"}: it separates them.` : "";
  const where = overlap ? "where they touch then" : apart ? "where they are nearest" : "where they touch", most = mostContactsDrawn;
  const drawn = way.patches.length > most ? `the first ${most} of ${way.patches.length} places` : "all points";
  const result = element("p", { class: "soft legend" },
    element("span", { class: "of-a" }, "A solid"), ", ", element("span", { class: "of-b" }, "B hatched"),
    way.a.length ? `; ${data.plane ? "vertices and edges" : "faces"} that meet are thick. ` : ". ",
    way.patches.length ? element("span", { class: "of-true" }, `Green: ${drawn} ${where}. `) : null,
    element("span", { class: "of-true" }, arrowText),
    overlap ? `, ending ${endOf(data, way)}; ${isFaint(data.bodies.a) ? "faint" : "dashed"}: A at its end.` : "");
  const strong = (text) => result.append(element("strong", {}, ` ${text}`));
  if (frame.apart) strong("Axes scaled apart: the extents differ more than a hundredfold.");
  for (const [i, body] of bodies.entries()) if (body.isSpeck) strong(`${"AB"[i]} is too small to be seen: a dot stands for it.`);
  if (length > 0 && length < unseen) strong("The arrow is too short to be seen from here: press contact.");
  return result;
}
