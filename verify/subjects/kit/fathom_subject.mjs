// SPDX-License-Identifier: Apache-2.0
// Lets `fathom certify` put cases to your code: one function that answers a pair of bodies. Copy this file; it needs Node 18 alone.
//
//   import { run } from './fathom_subject.mjs';
//
//   run((a, b) => {
//     const hit = world.collide(a.vertices, b.vertices);
//     return { overlap: hit !== null, depth: hit?.depth, direction: hit?.normal };
//   }, { name: 'my engine', version: '1.0', precision: 'binary32' });
//
// and then `fathom certify --subject 'node my_subject.mjs' cases.jsonl`. It speaks the protocol fathom/subject/1 (verify/PROTOCOL.md):
// answers are written at once, NaN and infinities so that they are judged, whatever your code prints once this file is imported goes to
// standard error, its exceptions become the answer `failed`, and each answer says how many microseconds it took.
import { writeSync } from 'node:fs';
import { createInterface } from 'node:readline';

export const protocol = 'fathom/subject/1';

/** Throw it for a pair that your code does not take: the case is not judged then. Any other error is a failure to answer. */
export class Unsupported extends Error {}

/** The matrix, as rows, of v -> q v q^-1 for a quaternion [w, x, y, z] of any length but 0. */
export function rotationOf(quaternion) {
  const largest = Math.max(...quaternion.map(Math.abs));
  const [w, x, y, z] = quaternion.map((c) => c / largest);
  const s = 2 / (w * w + x * x + y * y + z * z);
  return [
    [1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
    [s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)],
    [s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)],
  ];
}

/**
 * One body of a case: the convex hull of `vertices`; or a shape, if the subject declared some. `faces` are the hull's facets,
 * counter-clockwise from outside, if they were asked for. A shape has its fields as docs/shapes.md names them (radius, half_length, ...),
 * `axis`, `margin` (0 if there is none), and lies at rotation p + translation; `quaternion` is there unless the case gave a matrix. `axis` is
 * the declared one, if one was declared: a cyclic exchange of axes goes before the rotation then. `twist: { v, w }` says that its point p
 * begins to move with the velocity v + w x p, w about the origin of the world; it is null unless the subject declared it and the case has one.
 * A body of the plane is the hull of `vertices`, which have two coordinates, grown by `margin`; its `faces` are edges, one behind the other.
 */
function bodyOf(message, axis, twist = null) {
  const { pose, ...fields } = message;
  const body = { vertices: [], faces: [], pieces: [], shape: null, margin: 0, rotation: rotationOf([1, 0, 0, 0]), translation: [0, 0, 0], twist, ...fields };
  if (Array.isArray(pose)) {
    body.rotation = pose.map((row) => row.slice(0, 3));
    body.translation = pose.map((row) => row[3]);
  } else if (pose) {
    body.quaternion = pose.quaternion;
    body.rotation = rotationOf(pose.quaternion);
    body.translation = pose.translation ?? body.translation;
  }
  if (axis && body.axis) {
    const by = (3 + 'xyz'.indexOf(body.axis) - 'xyz'.indexOf(axis)) % 3;
    body.axis = axis;
    body.rotation = body.rotation.map((row) => [0, 1, 2].map((i) => row[(i + by) % 3]));
    if (by > 0 && body.quaternion) {
      const [w, x, y, z] = body.quaternion, s = by === 1 ? 0.5 : -0.5;  // times the quaternion (0.5, s, s, s)
      body.quaternion = [0.5 * w - s * (x + y + z), 0.5 * x + s * (w + y - z), 0.5 * y + s * (w + z - x), 0.5 * z + s * (w + x - y)];
    }
  }
  return body;
}

// JSON has no NaN and no infinities: they go as texts.
function number(x) {
  const value = Number(x);
  if (Number.isFinite(value)) return value;
  return Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf';
}

// Arrays, typed arrays, and objects with x, y, z, of as many coordinates as there are dimensions.
let coordinates = 3;
function vector(v) {
  const numbers = 'x' in v ? [v.x, v.y, v.z].slice(0, coordinates) : Array.from(v);
  if (numbers.length !== coordinates) throw new TypeError(`${numbers.length} numbers in the place of ${coordinates}`);
  return numbers.map(number);
}

const isGiven = (value) => value !== undefined && value !== null;

const contact = ({ position, depth }) => ({ position: vector(position), ...(isGiven(depth) ? { depth: number(depth) } : {}) });

function replyOf(answer) {
  const reply = { overlap: Boolean(answer.overlap) };
  if (isGiven(answer.depth)) reply.depth = number(answer.depth);
  if (isGiven(answer.direction)) reply.direction = vector(answer.direction);
  if (isGiven(answer.witness)) reply.witness = { a: vector(answer.witness.a), b: vector(answer.witness.b) };
  if (isGiven(answer.distance)) reply.distance = number(answer.distance);
  if (answer.contacts?.length) reply.contacts = answer.contacts.map(contact);
  if (isGiven(answer.derivative)) reply.derivative = number(answer.derivative);
  if (isGiven(answer.hull))
    reply.hull = Object.fromEntries(['a', 'b'].filter((name) => isGiven(answer.hull[name]))
                                        .map((name) => [name, Array.from(answer.hull[name], vector)]));
  if (isGiven(answer.microseconds)) reply.microseconds = number(answer.microseconds);
  return reply;
}

// The text of an error, whatever was thrown. Bytes of UTF-8 hold no lone surrogates.
function said(text) {
  try {
    return Buffer.from(String(text()).slice(0, 1000)).toString();
  } catch {
    return 'a text that cannot be made';
  }
}

async function answerTo(solve, message, axis) {
  const a = bodyOf(message.a, axis, message.twist?.a), b = bodyOf(message.b, axis, message.twist?.b);
  const start = process.hrtime.bigint();
  try {
    const answer = await solve(a, b);
    const microseconds = Number(process.hrtime.bigint() - start) / 1000;
    return { microseconds, ...replyOf(answer) };
  } catch (why) {
    return why instanceof Unsupported ? { unsupported: said(() => why.message) } : { failed: said(() => why) };
  }
}

// The pipe may be full for a moment.
function write(line) {
  const bytes = Buffer.from(line + '\n');
  for (let written = 0; written < bytes.length;) {
    try {
      written += writeSync(1, bytes, written);
    } catch (why) {
      if (why.code !== 'EAGAIN') throw why;
    }
  }
}

// Standard output is for answers: everything else that is printed goes to standard error, also when modules are loaded that are imported later.
process.stdout.write = process.stderr.write.bind(process.stderr);
console.log = console.info = console.debug = console.error;

/**
 * Answers cases until there are no more. solve(a, b) returns, now or by a promise, { overlap, depth, direction, witness: { a, b } }; all but
 * `overlap` may be left out, and what is there is judged. Of bodies that are apart `distance` says how far, `witness` nearest points, and
 * `direction` leads farther apart. `contacts: [{ position, depth }]` are points of both bodies; the largest of their depths, which may be left
 * out, is the depth. `hull: { a, b }`, or one of them, tells the vertices of the hulls that were really
 * used, where they may be others than the asked ones. `derivative`, of bodies with a twist, says how fast the signed depth grows as they begin
 * to move, from then on: deeper is positive, whatever sign depths have, and minus the distance counts of bodies apart. `microseconds` says how long the answer took, where solve measured a part of its
 * time itself. What the subject declares:
 *
 * name, version   of what is tested
 * dimension       2 for bodies of the plane: points and directions then have two coordinates; 3 unless given
 * precision       'binary64' or 'binary32': in which it computes. Bodies are rounded to it before they are sent. Or { points, answers }, if
 *                 points are seen in one and answers are of the other
 * touching        what it says of bodies that touch: 'overlap', 'separate', or 'either' if it makes no promise
 * depth           the sign of the depth of bodies that overlap: 'positive' or 'negative'
 * moves           which body |depth| * direction moves apart: 'a' or 'b'
 * unit            whether directions are promised to have length 1
 * faces           whether bodies of vertices need faces
 * shapes          names of the shapes that it takes, 'margin' if they may have one, 'pieces' if it takes unions; others come as vertices,
 *                 unions in pairs of pieces, or not at all. In the plane of 'circle', 'capsule', 'margin' (of polygons) and 'pieces'
 * promises        which of 'depth', 'direction', 'witness', 'contacts' each answer holds that says 'overlap'; 'distance' of the others; and 'derivative' of
 *                 all about bodies with a twist
 * settings        { iterations: 100, ... }: shown beside the verdicts
 * rounding        a radius by which it rounds all bodies, or { vertices: 0.01, box: ... }, by the names of shapes
 * manifold        { most: 4, margin: 0.01 }: how many contacts an answer has at most, how much less deep those without a depth may be
 * claims          'minimum': no translation is shorter than depth * direction; or 'separating': no more than that this one separates
 * axis            'x', 'y' or 'z': along which the engine's own shapes lie. Bodies then come turned to it; left out: as the case has them
 * twist           whether bodies come with their twists, to be asked for the derivative
 */
export async function run(solve, declared) {
  const { name, version, precision = 'binary64', touching = 'either', depth = 'positive', moves = 'a', unit = true, faces = false,
          shapes = [], promises = [], settings = {}, rounding, manifold, claims = 'minimum', axis, twist = false, dimension = 3 } = declared;
  coordinates = dimension;
  const hello = { type: 'hello', protocol, name, version, ...(dimension === 2 ? { dimension } : {}), precision, conventions: { touching, depth, moves, unit, claims },
                  capabilities: { faces, shapes, twist }, promises, settings, rounding, manifold };
  for await (const line of createInterface({ input: process.stdin, crlfDelay: Infinity })) {
    const message = JSON.parse(line);
    if (message.type === 'hello') write(JSON.stringify(hello));
    else if (message.type === 'run') write(JSON.stringify({ type: 'reply', id: message.id, ...(await answerTo(solve, message, axis)) }));
    else break;
  }
}
