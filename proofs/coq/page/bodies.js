// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies of a certificate, for the picture alone: numbers become binary64, and nothing here decides anything. What is judged the program
// reads by itself.

const isHeader = (line) => line.startsWith('fathom-certificate');

/** The lines of each certificate that a verdict is about: the program goes on behind an `end`, and from what is malformed to the next header. */
function certificatesOf(text, verdicts) {
  const lines = text.split('\n'), found = [];
  let at = 0;
  for (const verdict of verdicts) {
    while (at < lines.length && lines[at].startsWith('#')) ++at;
    const first = at++;
    if (verdict.startsWith('s MALFORMED')) while (at < lines.length && !isHeader(lines[at])) ++at;
    else while (at < lines.length && !lines[at - 1].startsWith('end ')) ++at;
    found.push(lines.slice(first, at).filter((line) => !line.startsWith('#')));
  }
  return found;
}

/** Their lines up to the claim: what there is to compare with one's own. */
function bodyLines(lines) {
  const claim = lines.findIndex((line) => line.startsWith('claim '));
  return lines.slice(0, claim < 0 ? lines.length : claim);
}

/** A rational as binary64: of very long ones as many digits are left out above as below. */
function valueOf(text) {
  const [above, below = '1'] = text.split('/'), long = Math.max(above.length, below.length) - 300;
  if (long <= 0) return Number(above) / Number(below);
  return Number(above.slice(0, Math.max(0, above.length - long)) || 0) / Number(below.slice(0, Math.max(0, below.length - long)) || 0);
}

/** Vectors of space; those of the plane have z = 0. */
function vectorsOf(words, dimension) {
  const values = words.map(valueOf), vectors = [];
  for (let i = 0; i + dimension <= values.length; i += dimension) vectors.push([...values.slice(i, i + dimension), 0].slice(0, 3));
  return vectors;
}

/** Where a point is of a body that is turned by the quaternion r + v and whose origin is at p. */
function placed(r, v, p, x) {
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2], w = dot(v, v), cross = (i, j) => v[i] * x[j] - v[j] * x[i];
  const turned = [cross(1, 2), cross(2, 0), cross(0, 1)];
  return p.map((place, i) => place + ((r * r - w) * x[i] + 2 * dot(v, x) * v[i] + 2 * r * turned[i]) / (r * r + w));
}

/**
 * {a, b, flat}: of each body its parts, and its edges if it is given by a mesh. A part is convex: {terms, radius}, the sum of terms, each the
 * hull of atoms [center, ...axes]; or {plane: [normal, offset]}. A certificate of one solid has no b. Bodies of the plane are flat. Moving
 * bodies are where they are at the time 0.
 */
function bodiesOf(lines) {
  const flat = lines.some((line) => line.startsWith('plane ')), dimension = flat ? 2 : 3;
  const bodies = { a: { parts: [], edges: [] }, b: { parts: [], edges: [] }, flat };
  let at = 0;
  const atoms = (count) => lines.slice(at + 1, at += 1 + count).map((line) =>
    vectorsOf(line.split(' ').filter((word) => !/^[a-z]/.test(word)), dimension));
  while (at < lines.length && !lines[at].startsWith('claim ')) {
    const [word, ...rest] = lines[at].split(' '), [, what, whose] = /^(?:(\w+)_)?([ab])$/.exec(word) ?? [];
    const body = bodies[whose], count = Number(rest[0]);
    if (body && (what === undefined || what === 'solid')) {
      const points = atoms(count);
      if (what === undefined) body.parts.push({ terms: [points], radius: 0 });
      else body.points = points.map(([p]) => p);
    } else if (body && what === 'shape') {
      ++at;
      const terms = [];
      while (terms.length < count && lines[at]?.startsWith('term ')) terms.push(atoms(Number(lines[at].split(' ')[1])));
      body.parts.push({ terms, radius: 0 });
    } else if (body && what === 'halfspace') {
      body.parts.push({ plane: [vectorsOf(rest, dimension)[0], valueOf(rest[dimension])], terms: [], radius: 0 });
      ++at;
    } else if (body && what === 'radius') {
      body.parts.at(-1).radius = valueOf(rest[0]);
      ++at;
    } else if (body && what === 'motion') {
      const [[r, ...v]] = lines.slice(at + 1).map((line) => line.split(' ').map(valueOf)), [p] = vectorsOf(lines[at + 3].split(' '), 3);
      body.parts[0].terms[0].forEach((atom) => { atom[0] = placed(r, v, p, atom[0]); });
      at += 5;
    } else if (word === 'mesh') {
      const solid = bodies.b.points ? bodies.b : bodies.a;
      for (const line of lines.slice(at + 1, at += 1 + count)) {
        const corners = line.split(' ').map((i) => solid.points[i]);
        corners.forEach((p, i) => solid.edges.push([p, corners[(i + 1) % corners.length]]));
      }
    } else {
      ++at;
    }
  }
  return bodies;
}
