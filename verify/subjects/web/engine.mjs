// SPDX-License-Identifier: GPL-3.0-or-later
// What the adapters of engines for the web share: words of the command line, the placing of bodies, and the way from an engine to the
// protocol, which the kit speaks.                                                                            [verify/PROTOCOL.md]
//
//   node ENGINE.mjs MODE [KEY=VALUE ...]
//
// Exit codes: 0; 2 for a wrong command line; 70 where the engine's WebAssembly module is broken: nothing that it says later counts.
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { run, Unsupported } from './fathom_subject.mjs';

export { Unsupported };

const me = basename(process.argv[1] ?? 'engine', '.mjs');
const [word = '', ...rest] = process.argv.slice(2);
const given = new Map();
const inForce = {};

/** The mode that was asked for. */
export const mode = word;

/** Where engines print: standard output is for answers. */
export const quiet = { print: (...words) => console.error(...words), printErr: (...words) => console.error(...words) };

/** Ends the program for a wrong command line. */
export function refuse(why) {
  process.stderr.write(`${me}: ${why}\n`);  // an engine's noise may be off by now, and console.error with it
  process.exit(2);
}

for (const pair of rest) {
  const at = pair.indexOf('=');
  const key = pair.slice(0, at);
  if (at < 1) refuse(`expected KEY=VALUE instead of ${JSON.stringify(pair)}`);
  if (given.has(key)) refuse(`${key} is given twice`);
  given.set(key, pair.slice(at + 1));
}

/** The value of a setting: the engine's own, unless KEY=VALUE was given. The hello lists all that were asked for. */
export function setting(key, usual) {
  const text = given.get(key);
  given.delete(key);
  let value = usual;
  if (text !== undefined) {
    value = typeof usual === 'number' ? Number(text) : text;
    if (typeof usual === 'number' && (text.trim() === '' || !Number.isFinite(value)))
      refuse(`expected a number for ${key} instead of ${JSON.stringify(text)}`);
  }
  inForce[key] = String(value);
  return value;
}

/** Tells of something that cannot be changed. */
export function note(key, text) {
  inForce[key] = text;
}

/** What a package's package.json says of its version. */
export function versionOf(name) {
  return JSON.parse(readFileSync(new URL(`node_modules/${name}/package.json`, import.meta.url), 'utf8')).version;
}

/** The engine makes no hull of these points. It is then not asked about a flat body, and fails with a solid one, which it ought to take. */
export class Refused extends Error {}

const axes = ['x', 'y', 'z'];

/** The product p q of two quaternions [w, x, y, z]: first q turns, then p. */
export function product(p, q) {
  const [a, b, c, d] = p, [e, f, g, h] = q;
  return [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];
}

/** The quaternion that turns one axis to another: a cyclic exchange of all three, whose numbers are halves and so exact in every precision. */
export function turnOfAxis(from, to) {
  const steps = (axes.indexOf(to) - axes.indexOf(from) + 3) % 3;
  return [[1, 0, 0, 0], [0.5, 0.5, 0.5, 0.5], [0.5, -0.5, -0.5, -0.5]][steps];
}

/** The unit quaternion of a rotation matrix, by the largest of its four numbers, so that no small one is divided by. */
export function quaternionOf([[a, b, c], [d, e, f], [g, h, i]]) {
  const squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i];  // four times w w, x x, y y, z z
  const largest = squares.indexOf(Math.max(...squares));
  const q = [[squares[0], h - f, c - g, d - b], [h - f, squares[1], b + d, c + g], [c - g, b + d, squares[2], f + h],
             [d - b, c + g, f + h, squares[3]]][largest];
  return unit(q);
}

/** The vector that a unit quaternion [w, x, y, z] turns v to. */
export function turned([w, x, y, z], v) {
  const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
  return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]];
}

function unit(q) {
  const largest = Math.max(...q.map(Math.abs));
  const scaled = q.map((x) => x / largest), length = Math.hypot(...scaled);
  return scaled.map((x) => x / length);
}

// An engine takes rotations alone; what is one but for the rounding of its numbers is taken for it, as by the other adapters.
function demandRotation(rows) {
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const [u, v, w] = rows;
  const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const off = Math.max(...[[u, u], [v, v], [w, w]].map(([p, q]) => Math.abs(dot(p, q) - 1)), Math.abs(dot(u, v)), Math.abs(dot(v, w)),
                       Math.abs(dot(w, u)));
  if (!(off < 1e-5) || !(dot(cross, w) > 0)) throw new Unsupported('a pose that is no rotation');
}

/**
 * A body as engines take it: `points` about the place `at`, with `faces`; or the shape with its fields, turned by the unit quaternion
 * `turn` ([w, x, y, z]) and placed at `at`. Vertices are relative to their mean, rounded to the engine's numbers, as engines expect a
 * body about its own origin.
 */
function placed(body, round, dimension) {
  if (body.shape) {
    demandRotation(body.rotation);
    return { ...body, turn: body.quaternion ? unit(body.quaternion) : quaternionOf(body.rotation), at: body.translation.map(round) };
  }
  const count = body.vertices.length;
  const at = Array.from({ length: dimension }, (_, i) => round(body.vertices.reduce((sum, p) => sum + p[i] / count, 0)));
  const points = body.vertices.map((p) => p.map((x, i) => round(x - at[i])));
  return { shape: null, points, faces: body.faces, at, turn: [1, 0, 0, 0], margin: body.margin };
}

/** The corners of a placed polygon, counter-clockwise. Throws Refused without an interior, Unsupported beyond `most`. */
export function cornersOf({ points, faces }, most = Infinity) {
  if (!faces.length) throw new Refused('it has no interior');
  if (faces.length > most) throw new Unsupported(`${faces.length} corners: this engine takes ${most}`);
  return faces.map(([from]) => points[from]);
}

/** The shape's quaternion for an engine that lays such shapes along `axis`. */
export const turnFrom = (body, axis) => product(body.turn, turnOfAxis(axis, body.axis ?? axis));

/**
 * Answers cases with one mode of an engine.
 *
 * name, version, precision, dimension  as in the hello
 * modes                     for each mode { call, depth, moves, unit, claims, shapes, manifold, ask(a, b) }: the conventions, and what it
 *                           answers for two made bodies
 * make(body)                what the engine makes of a placed body. Throws Refused where it makes no hull of the points
 * free(made)                gives it back
 * hulls(a, b)               { a, b }: the vertices of the hulls that the engine uses of two made bodies, in the world; undefined of a shape
 *
 * The time told is that of `ask` alone: the bodies are made before.
 */
export async function serve({ name, version, precision, dimension = 3, modes, make, free = () => {}, hulls = () => ({}) }) {
  const own = modes[mode];
  if (!own) refuse(`expected a mode, one of ${Object.keys(modes).join(', ')}, instead of ${JSON.stringify(mode)}`);
  if (given.size) refuse(`${[...given.keys()].join(', ')}: no such setting (there are ${Object.keys(inForce).join(', ')})`);
  note('call', own.call);
  note('centre', 'mean of the vertices');
  const { depth, moves, unit: isUnit = true, claims, shapes = [], manifold: limits } = own;
  const round = (precision.points ?? precision) === 'binary32' ? Math.fround : (x) => x;

  const solve = (a, b) => {
    const made = [];
    try {
      for (const body of [a, b]) {
        if (dimension === 3) demandDeclared(body, shapes);  // in the plane nothing else is put
        made.push(make(placed(body, round, dimension)));
      }
      const start = process.hrtime.bigint();
      const answer = own.ask(made[0], made[1]);
      const microseconds = Number(process.hrtime.bigint() - start) / 1000;
      return { ...answer, microseconds, ...hullMember(hulls(made[0], made[1])) };
    } catch (why) {
      if (why instanceof WebAssembly.RuntimeError || why?.name === 'ExitStatus') {
        process.stderr.write(`${me}: ${why?.stack ?? why}\n`);
        process.exit(70);
      }
      if (why instanceof Refused && isFlat(a, b)) throw new Unsupported(`a flat body: ${why.message}`);
      throw why;
    } finally {
      for (const body of made) free(body);
    }
  };
  await run(solve, { name: `${name}-${mode}`, version, dimension, precision, depth, moves, unit: isUnit, claims, faces: true, shapes, settings: inForce,
                     manifold: limits || undefined });
}

const hullMember = (hull) => (hull.a || hull.b ? { hull } : {});

function demandDeclared({ shape, margin }, shapes) {
  if (shape && !shapes.includes(shape)) throw new Unsupported(`${shape}: this mode declares ${shapes.join(', ') || 'no shapes'}`);
  if (margin > 0 && !shapes.includes('margin')) throw new Unsupported('a margin');
}

// fathom sends the faces of every solid body of vertices.
const isFlat = (...bodies) => bodies.some((body) => !body.shape && body.faces.length === 0 && !(body.margin > 0));

/** The answer that a separation is: the distance of bodies that are apart, or else their depth below 0. */
export const signed = (separation) => (separation > 0 ? { overlap: false, distance: separation } : { overlap: true, depth: separation });

/** The least of some separations, each with its direction and points; that there is no overlap where there is none. */
export function nearest(separations) {
  if (separations.length === 0) return { overlap: false };
  const { depth, ...rest } = separations.reduce((best, each) => (best.depth <= each.depth ? best : each));
  return { ...signed(depth), ...rest };
}

/**
 * What a manifold answers: its deepest point, { depth, direction, position } with depths below 0; if it is to tell positions, also all
 * others, those that are still to come among them; or that there is no overlap. Answers have one direction: normals that differ by rounding
 * alone count as the deepest's, and a manifold with others is not told.
 */
export function manifold(points, tellsPositions = false) {
  const rounding = 1e-5;
  const found = points.filter(({ depth }) => depth <= 0);
  if (found.length === 0) return { overlap: false };
  const { depth, direction } = found.reduce((best, each) => (best.depth <= each.depth ? best : each));
  if (!tellsPositions) return { overlap: true, depth, direction };
  const isAlong = (each) => each.direction.every((x, k) => Math.abs(x - direction[k]) <= rounding);
  if (!points.every(isAlong)) throw new Unsupported('contacts along several normals');
  return { overlap: true, depth, direction, contacts: points.map((each) => ({ position: each.position, depth: each.depth })) };
}
