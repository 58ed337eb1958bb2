// SPDX-License-Identifier: Apache-2.0
// A subject on fathom_subject.mjs: the boxes around two bodies, which are right about boxes along the axes.
import { run } from './fathom_subject.mjs';

run((a, b) => {
  let depth = Infinity, direction;  // how far along which axis A must go
  for (const axis of [0, 1, 2]) {
    const [p, q] = [a, b].map((body) => body.vertices.map((vertex) => vertex[axis]));
    for (const [sign, length] of [[1, Math.max(...q) - Math.min(...p)], [-1, Math.max(...p) - Math.min(...q)]])
      if (length < depth) [depth, direction] = [length, [0, 1, 2].map((i) => (i === axis ? sign : 0))];
  }
  return { overlap: depth > 0, depth, direction };
}, { name: 'boxes-javascript', version: '1' });
