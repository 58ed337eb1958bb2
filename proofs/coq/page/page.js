// SPDX-License-Identifier: GPL-3.0-or-later
// The page: files go one after another to the worker, and its lines are shown as they are; below an accepted one, when it is opened, what it
// says in words, and the bodies.

const byId = (id) => document.getElementById(id);

function made(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

// ---- the worker ----
const source = URL.createObjectURL(new Blob([byId('program').textContent], { type: 'text/javascript' }));
let worker = null;

function dismissWorker() {
  worker?.terminate();
  worker = null;
}

/** What the worker answers about a file: {lines, code, why}. One that breaks is replaced. Waits for ever if `stale` by then. */
async function answerAbout(file, width, stale) {
  let bytes;
  try {
    bytes = new Uint8Array(await file.arrayBuffer());
  } catch (error) {
    return { lines: [], code: null, why: `the browser cannot read it: ${error.message}` };
  }
  return new Promise((resolve) => {
    if (stale()) return;
    worker ??= new Worker(source);
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = (event) => {
      event.preventDefault();
      dismissWorker();
      resolve({ lines: [], code: null, why: event.message || 'the worker has stopped' });
    };
    worker.postMessage({ name: file.name, bytes, width }, [bytes.buffer]);
  });
}

// ---- what is shown ----
const words = { VERIFIED: 'accepted', REFUSED: 'refused', MALFORMED: 'malformed' };
const kindOf = (line) => words[line.split(' ')[1]] ?? 'unanswered';
const meant = {
  refused: 'Not accepted: the proved function did not say yes. The line names the place, and what failed there. That does not make the claim ' +
    'false; it is not proved by this text.',
  malformed: 'This text is no certificate: the line names the place, and what the format has there (verify/check/FORMAT.md).',
};
const mostShown = 2000;  // lines of the bodies

async function explained(file, verdicts, k, width) {
  const verdict = verdicts[k], kind = kindOf(verdict);
  if (kind !== 'accepted') return [made('p', {}, meant[kind])];
  const said = verdict.slice('s VERIFIED '.length, verdict.lastIndexOf(' ')), { sentences, theorem } = inWords(said, width);
  const parts = [made('p', {}, sentences.join(' '))];
  if (theorem) {
    const [name, where, definition] = theorem;
    parts.push(made('p', { class: 'soft' }, 'Proved by ', made('code', {}, name), ` (proofs/coq/${where}), where `, made('code', {}, definition),
      ' (proofs/coq/printed.v) defines what the line means, for the points below.'));
  }
  const lines = bodyLines(certificatesOf(await file.text(), verdicts)[k]), bodies = bodiesOf(lines);
  parts.push(made('figure', {}, pictureOf(bodies), made('figcaption', { class: 'soft' }, made('span', { class: 'key-a' }, 'A'), ' and ',
    made('span', { class: 'key-b' }, 'B'), ', drawn in binary64: to recognise them, not to compare. ',
    bodies.flat ? 'x goes to the right, y up.' : 'Dragging and arrow keys turn them.')));
  const rest = lines.length - mostShown;
  parts.push(made('details', {}, made('summary', {}, 'The bodies as the file has them: compare them with your own'),
    made('pre', { tabindex: '0' }, lines.slice(0, mostShown).join('\n') + (rest > 0 ? `\n… and ${rest} lines more` : ''))));
  return parts;
}

/** A line of the program, which opens. */
function shown(file, verdicts, k, width) {
  const details = made('details', { class: `verdict ${kindOf(verdicts[k])}` }, made('summary', {}, made('code', {}, verdicts[k])));
  details.addEventListener('toggle', async () => details.append(...await explained(file, verdicts, k, width)), { once: true });
  return details;
}

// ---- files ----
let given = [], round = 0;

async function judgeAll() {
  const mine = ++round, width = byId('width').checked, counts = new Map();
  byId('verdicts').replaceChildren();
  dismissWorker();
  const say = (begun) => {
    const done = [...counts].map(([kind, n]) => `${n} ${kind}`).join(', ');
    byId('said').textContent = [begun, done].filter(Boolean).join(' ');
  };
  for (const [i, file] of given.entries()) {
    say(`Checking ${file.name} (${i + 1} of ${given.length}, ${file.size} bytes).`);
    const { lines, why } = await answerAbout(file, width, () => mine !== round);
    for (const line of lines) counts.set(kindOf(line), (counts.get(kindOf(line)) ?? 0) + 1);
    const all = lines.map((_, k) => shown(file, lines, k, width));
    if (why) {
      counts.set('unanswered', (counts.get('unanswered') ?? 0) + 1);
      all.push(made('p', { class: 'unanswered' }, `${file.name}: no answer, and nothing is proved by it: ${why}`));
    }
    byId('verdicts').append(...all);
    if (given.length === 1 && all.length === 1 && !why) all[0].open = true;
  }
  say(given.length ? 'All is checked:' : '');
}

function give(files) {
  given = [...files];
  judgeAll();
}

byId('files').addEventListener('click', ({ target }) => { target.value = ''; });  // the same files may have changed
byId('files').addEventListener('change', ({ target }) => give(target.files));
byId('width').addEventListener('change', judgeAll);
addEventListener('dragover', (event) => {
  event.preventDefault();
  document.body.classList.add('over');
});
addEventListener('dragleave', (event) => event.relatedTarget ?? document.body.classList.remove('over'));
addEventListener('drop', (event) => {
  event.preventDefault();
  document.body.classList.remove('over');
  give(event.dataTransfer.files);
});
