// SPDX-License-Identifier: GPL-3.0-or-later
// What an accepted line says, in words, and which theorem shows it. The words are a help: what the line means is defined in printed.v.

const proved = {
  1: ['verdict_sound', 'soundness/verdict_sound.v', 'says'],
  2: ['signed_verdict_sound', 'soundness/signed_sound.v', 'says_signed'],
  3: ['union_verdict_sound', 'soundness/union_sound.v', 'says_union'],
  4: ['patched_verdict_sound', 'soundness/patch_verdict_sound.v', 'says_patched'],
  5: ['tiling_verdict_sound', 'soundness/tiling_sound.v', 'says_tiling'],
  6: ['impact_verdict_sound', 'soundness/impact_sound.v', 'says_impact'],
};
const provedWidth = {
  1: ['verdict_width', 'soundness/verdict_sound.v', 'says_width'],
  2: ['signed_verdict_width', 'soundness/signed_sound.v', 'says_width'],
};

const provedPlane = {
  1: ['plane_verdict_sound', 'soundness/plane_sound.v', 'says_plane'],
  2: ['plane_signed_verdict_sound', 'soundness/plane_sound.v', 'says_plane_signed'],
  3: ['plane_union_verdict_sound', 'soundness/plane_sound.v', 'says_plane_union'],
};

const signs = {
  penetrating: 'It is positive: the bodies overlap, and it is the length of a shortest translation that ends this.',
  touching: 'It is 0: the bodies touch.',
  disjoint: 'It is negative: the bodies are apart, and without its sign it is their distance.',
  undecided: 'Its sign is not said.',
};
const ways = (k) => k === '1' ? 'There is exactly one such translation.' : `There are exactly ${k} such translations.`;

/** Each row: what the line may say, and the sentences about it. */
const sayings = [
  [/ dimension=2$/, () => ['A and B are bodies of the plane; translations, distances, directions and interiors are those of the plane.']],
  [/^penetrating depth_squared=(\S+)(?: optima=(\S+))?/, (q, k) => [
    `A and B overlap, and the square of their penetration depth is ${q}: moved by less, in whatever direction, A still overlaps B; ` +
      'some translation of that length ends this.', k && ways(k)]],
  [/^penetrating depth_squared_in=\[(\S+),(\S+)\]/, (low, high) => [
    `A and B overlap, and the square of their penetration depth is at least ${low} and at most ${high}.`]],
  [/^touching depth_squared=/, () => ['A and B touch: they have a point in common, but do not overlap.']],
  [/^disjoint depth_squared=/, () => ['A and B have no point in common.']],
  [/^disjoint distance_squared=(\S+)/, (q) => [
    `A and B are apart, and the square of their distance is ${q}: no two points of them are nearer, and some two are that near.`]],
  [/^(\S+) signed_depth=(-?)sqrt\((\S+)\)\+(\S+)/, (status, sign, q, rho) => [
    `The signed depth of A and B is ${sign ? 'minus ' : ''}the root of ${q}${rho === '0' ? '' : `, plus ${rho}, the sum of their radii`}.`,
    signs[status]]],
  [/^\S+ signed_depth=.* optima=(\S+)/, (k) => [ways(k)]],
  [/ cone=(\d+)\+(\d+)/, (lines, rays) => [
    `The optimal directions of the cores are the sums of ${lines} lines and ${rays} rays, none of which could be spared.`]],
  [/^(\S+) signed_depth_in=\[(\S+),(\S+)\]/, (status, low, high) => [
    `The signed depth of A and B is at least ${low} and at most ${high}.`, signs[status]]],
  [/ pieces=(\d+)x(\d+)/, (m, n) => [
    `A is the union of ${m} convex pieces and B of ${n}, each with an interior; they overlap if the unions' interiors do: seams are no gaps.`]],
  [/ patches=(\S+)/, (counts) => [
    `For each listed direction the contact patch is known: the convex hull of its corners, none of which could be spared (${counts}).`]],
  [/ rates=(\d+)/, (k) => [`The rates of change that the certificate gives for ${k} motions are those of the signed depth.`]],
  [/^solid triangles=(\d+) pieces=(\d+)/, (m, n) => [
    `The mesh of ${m} triangles is closed, its winding number is negative nowhere, and the ${n} convex pieces are the solid that it encloses.`]],
  [/^\w+ until=(\S+)/, (end) => [`A and B move. At each time from 0 to ${end} they have no point in common.`]],
  [/^contact .*\bat=(\S+)/, (time) => [`At the time ${time} they have a point in common.`]],
  [/ near=(\S+)/, (near) => [
    `But between two times in brackets nothing is said, only that at the later one they are as near as the number behind them (${near}).`]],
];

// A line with anything more in it gets no words: they might leave out what matters.
const whole = new RegExp('^(?:(?:penetrating|touching|disjoint|undecided) (?:depth_squared|distance_squared|signed_depth)(?:_in)?=\\S+' +
  '(?: optima=\\S+)?(?: cone=\\S+)?(?:(?: pieces=\\S+)?(?: dimension=2)?| patches=\\S+(?: rates=\\S+)?)|solid triangles=\\S+ pieces=\\S+' +
  '|(?:apart|grazing|contact)(?: until=\\S+)?(?: at=\\S+)?(?: near=\\S+)?)$');

/** The format that a line is about, by what it says. */
function formatOf(said) {
  if (said.startsWith('solid ')) return 5;
  if (/^\w+ (?:until|at)=/.test(said)) return 6;
  if (said.includes(' patches=')) return 4;
  if (said.includes(' pieces=')) return 3;
  return said.includes(' signed_depth') ? 2 : 1;
}

/** {sentences, theorem: [name, file, definition]} of what is between "s VERIFIED " and the certificate's name. */
function inWords(said, width) {
  const sentences = !whole.test(said) ? [] : sayings.flatMap(([pattern, words]) => {
    const found = pattern.exec(said);
    return found ? words(...found.slice(1)).filter(Boolean) : [];
  });
  const format = formatOf(said), known = sentences.length > 0;
  if (!known) sentences.push('This page has no words of its own for that line.');
  const inPlane = said.endsWith(' dimension=2'), asWidth = known && width && !inPlane && provedWidth[format];
  if (asWidth) sentences.push('B is A again, so this depth is the width of A: the least distance of two parallel planes with A between them.');
  return { sentences, theorem: known ? asWidth || (inPlane ? provedPlane : proved)[format] : null };
}
