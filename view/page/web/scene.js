// SPDX-License-Identifier: GPL-3.0-or-later
// A 3-D picture in the page: canvas, camera, turning, fitting, words in front of it. Frames are drawn on demand only.
//
//   const view = createView(root, "what it shows");   throws NoWebGL where there is none: catch it with withView
//   view.flat                                         whether it shows the plane from +z: it does not turn, and nothing is shaded
//   view.scene, view.camera, view.canvas              three.js's; add what is to be seen
//   view.render()                                     asks for a frame
//   view.fit(points, {from, up})                      shows these points from this direction, and again when the size changes
//   view.look(target, distance, {from, up})           looks at a point from a distance
//   view.beforeFrame(f)                               calls f(view) before each frame; view.pixel(place) is a pixel's size there
//   view.label(text, class, place)                    a word at place(), in front
//   view.onPoint(objects, {over, chosen})             what the pointer is over, and what was clicked: an intersection or null
//   view.drawCalls()                                  those of the last frame
import { cross, dot, plus, times, unit } from "./geometry.js";
import { element, onLook } from "./look.js";

export class NoWebGL extends Error {}

const fieldOfView = 26;  // degrees
const noWebGLText = {
  still: "This browser shows no WebGL: the picture stands still, and numbers and tables are complete.",
  none: "This browser shows no WebGL, which this picture needs; numbers and tables are complete.",
};

/** Calls f(view), or leaves what stands in root and says why. */
export function withView(root, label, f, flat = false) {
  const before = [...root.childNodes];
  try {
    const view = createView(root, label, flat);
    root.replaceChildren(view.stage);
    view.resize();
    return f(view, before);
  } catch (error) {
    if (!(error instanceof NoWebGL)) throw error;
    root.replaceChildren(...before, element("p", { class: "note no-webgl" }, before.length ? noWebGLText.still : noWebGLText.none));
    return {};
  }
}

function rendererOf(canvas) {
  const T = globalThis.THREE;
  // The drawing buffer is kept so that paper and screenshots show the last frame.
  const asked = { alpha: true, antialias: true, preserveDrawingBuffer: true };
  const context = canvas.getContext("webgl2", asked);
  if (!context) throw new NoWebGL();
  const renderer = new T.WebGLRenderer({ canvas, context, ...asked });
  renderer.setClearColor(0x000000, 0);
  renderer.sortObjects = true;
  return renderer;
}

/** From where, and which way up: the four numbers that place a camera. */
function frustum(camera) {
  const tan = Math.tan((camera.fov * Math.PI) / 360);
  return { x: tan * camera.aspect, y: tan };
}

export function createView(root, label, flat = false) {
  const T = globalThis.THREE;
  const canvas = element("canvas", { role: "img", "aria-label": label, tabindex: 0 });
  const renderer = rendererOf(canvas);
  const words = element("div", { class: "words", "aria-hidden": "true" });
  const stage = element("div", { class: flat ? "stage flat" : "stage" }, canvas, words);
  const scene = new T.Scene(), camera = new T.PerspectiveCamera(fieldOfView, 1, 0.01, 100);
  const hemisphere = new T.HemisphereLight(0xffffff, 0xb8bcc4, 2.3), sun = new T.DirectionalLight(0xffffff, 1.5);
  scene.add(hemisphere, camera);
  camera.add(sun);
  sun.position.set(-0.5, 0.9, 0.6);
  const controls = new T.OrbitControls(camera, canvas);
  controls.enableRotate = !flat;
  const hooks = [], labels = [];
  let asked = 0, fitted = null, calls = 0;

  const view = {
    stage, canvas, scene, camera, controls, flat,
    drawCalls: () => calls,
    beforeFrame: (f) => hooks.push(f),
    label(text, name, place) {
      const word = element("span", { class: `word ${name}` }, text);
      words.append(word);
      labels.push({ word, place });
      return word;
    },
    render() {
      asked ||= requestAnimationFrame(view.renderNow);
    },
    renderNow() {
      cancelAnimationFrame(asked);
      asked = 0;
      if (canvas.width < 2 || canvas.height < 2) return;
      const distance = camera.position.distanceTo(controls.target);
      camera.near = distance * 0.05;
      camera.far = distance + 12;
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
      hemisphere.position.copy(camera.up);
      for (const hook of hooks) hook(view);
      renderer.render(scene, camera);
      calls = renderer.info.render.calls;
      placeWords();
    },
    /** How long a pixel of the page is at a place of the scene. */
    pixel(place) {
      const depth = Math.max(1e-9, -new T.Vector3(...place).applyMatrix4(camera.matrixWorldInverse).z);
      return (2 * depth * frustum(camera).y) / Math.max(1, canvas.clientHeight);
    },
    look(target, distance, { from, up }) {
      camera.up.set(...up);
      camera.position.set(...plus(target, times(unit(from), distance)));
      controls.target.set(...target);
      controls.update();
      view.render();
    },
    fit(points, direction) {
      fitted = { points, direction };
      const { target, distance } = fitOf(points, direction, frustum(camera));
      view.look(target, distance, direction);
    },
    resize() {
      const width = stage.clientWidth, height = stage.clientHeight;
      if (!(width > 0 && height > 0)) return;
      renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      if (fitted) view.fit(fitted.points, fitted.direction);
      view.render();
    },
    onPoint: (objects, told) => pointAtScene(view, objects, told),
  };

  function placeWords() {
    for (const { word, place } of labels) {
      const at = place();
      word.hidden = !at;
      if (!at) continue;
      const p = new T.Vector3(...at).project(camera);
      word.style.left = `${(50 * (1 + p.x)).toFixed(2)}%`;
      word.style.top = `${(50 * (1 - p.y)).toFixed(2)}%`;
    }
  }

  controls.addEventListener("change", view.render);
  controls.addEventListener("start", () => { fitted = null; });
  hearKeysOf(view);
  new ResizeObserver(() => view.resize()).observe(stage);
  return view;
}

/** Calls f whenever colours change, and draws at once: paper does not wait for a frame. */
export function onViewLook(view, f) {
  onLook(() => {
    f();
    view.renderNow();
  });
}

/** The target and distance from which all points are seen and fill the picture. */
export function fitOf(points, { from, up }, tan) {
  const back = unit(from), right = unit(cross(up, back)), above = cross(back, right), margin = 1.1;
  const seen = points.map((p) => [dot(p, right), dot(p, above), dot(p, back)]);
  const ends = (i) => seen.reduce(([l, h], p) => [Math.min(l, p[i]), Math.max(h, p[i])], [Infinity, -Infinity]);
  const center = [0, 1, 2].map((i) => { const [l, h] = ends(i); return Number.isFinite(l + h) ? (l + h) / 2 : 0; });
  let distance = 1e-6;
  for (let round = 0; round < 4; ++round) {
    distance = 1e-6;
    for (const p of seen)
      for (const [i, t] of [[0, tan.x], [1, tan.y]])
        distance = Math.max(distance, p[2] - center[2] + (margin * Math.abs(p[i] - center[i])) / t);
    for (const i of [0, 1]) {  // what is near the camera takes more room: aim at the middle of what is seen
      const angles = seen.map((p) => (p[i] - center[i]) / Math.max(1e-9, distance - (p[2] - center[2])));
      const [low, high] = minMax(angles);
      if (low <= high) center[i] += (distance * (low + high)) / 2;
    }
  }
  const target = plus(plus(times(right, center[0]), times(above, center[1])), times(back, center[2]));
  return { target, distance };
}

const minMax = (values) => values.reduce(([l, h], x) => [Math.min(l, x), Math.max(h, x)], [Infinity, -Infinity]);

/** The wheel turns the page until the picture has been clicked; then it zooms. Fingers scroll up and down, and turn sideways. */
function hearKeysOf({ canvas, controls, camera, render, flat }) {
  const T = globalThis.THREE;
  controls.enableZoom = false;
  canvas.style.touchAction = "pan-y";
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
  canvas.addEventListener("focus", () => { controls.enableZoom = true; });
  canvas.addEventListener("blur", () => { controls.enableZoom = false; });
  canvas.addEventListener("keydown", (event) => {
    const away = camera.position.clone().sub(controls.target);
    const side = { ArrowLeft: [0, 1], ArrowRight: [0, -1], ArrowUp: [1, 1], ArrowDown: [1, -1] }[event.key];
    if (side && event.shiftKey && !flat) {
      const axis = side[0] ? new T.Vector3().crossVectors(camera.up, away).normalize() : camera.up;
      const turned = away.clone().applyAxisAngle(axis, side[1] * -0.15);
      if (Math.abs(turned.clone().normalize().dot(camera.up)) < 0.995) away.copy(turned);
    } else if (event.key === "+" || event.key === "=") away.multiplyScalar(0.85);
    else if (event.key === "-") away.multiplyScalar(1.18);
    else return;
    event.preventDefault();
    event.stopPropagation();
    camera.position.copy(controls.target).add(away);
    controls.update();
    render();
  });
}

function pointAtScene(view, objects, { over, chosen }) {
  const T = globalThis.THREE, caster = new T.Raycaster();
  let down = null, pending = 0;
  const hit = (event) => {
    const box = view.canvas.getBoundingClientRect();
    const at = new T.Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    caster.setFromCamera(at, view.camera);
    return caster.intersectObjects(objects, false)[0] ?? null;
  };
  view.canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
  view.canvas.addEventListener("pointermove", (event) => {
    if (event.buttons || event.pointerType === "touch") return;
    cancelAnimationFrame(pending);
    pending = requestAnimationFrame(() => over(hit(event)));
  });
  view.canvas.addEventListener("pointerleave", () => {
    cancelAnimationFrame(pending);
    over(null);
  });
  view.canvas.addEventListener("pointerup", (event) => {
    if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) chosen(hit(event));
    down = null;
  });
}
