// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of `fathom explain` for the tests, each with the data that it was made of.
import { nearest } from '../../view/page/web/numbers.js';
import { cases, fathom, made } from './lib.mjs';

const known = new Map();

/** The page of a case, a line of JSON: {page, depth, stages, id}. Made once. */
export function explained(line, words = []) {
  const { id } = JSON.parse(line);
  if (!known.has(id)) {
    const file = made(`${id.replace(/\W+/g, '_')}.jsonl`, `${line}\n`);
    const page = file.replace(/\.jsonl$/, '.html');
    fathom(['explain', file, '-o', page, ...words]);
    const answer = (...command) => JSON.parse(fathom([...command, file, '--json']));
    known.set(id, { id, page, depth: answer('depth', '--patch'), stages: answer('stages') });
  }
  return known.get(id);
}

/** The numbers that a page tells of patches: places of corners, each rounded once, and how many there are. */
export const numbersOfPatches = ({ manifold: { patches } }) => (patches ?? []).flatMap(({ corners }) => [...corners.keys(), corners.length,
  ...corners.flatMap(({ a, b }) => [a, b].flatMap((place) => (place.core ? [] : place.map(nearest))))]);

/** A case of a family: `drawn('random_ball', 20)`. */
export const drawn = (family, size, seed = 1) =>
  fathom(['cases', '--family', family, '--size', `${size}`, '--count', '1', '--seed', `${seed}`]).trim();

/** A case of two mesh files. */
export const meshes = (id, a, b) => JSON.stringify({ ...JSON.parse(fathom(['cases', '--from', a, b])), id });

/** The case of a file by its id. */
export const stored = (file, id) => JSON.stringify(cases(file).find((each) => each.id === id));
