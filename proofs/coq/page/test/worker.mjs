// SPDX-License-Identifier: GPL-3.0-or-later
// worker.mjs PAGE PROGRAM FILES...   the page's worker, run by Node, answers with the lines and the exit code of the program.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { basename, dirname, resolve } from 'node:path';

const [page, program, ...files] = process.argv.slice(2);
const worker = /<script type="text\/plain" id="program">([^]*?)<\/script>/.exec(readFileSync(page, 'utf8'))[1];
const answer = new Function('postMessage', `let onmessage;\n${worker}\nreturn onmessage;`);
let said = 0;

function compared(path, ...words) {
  const name = basename(path), width = words.length > 0;
  const done = spawnSync(resolve(program), [...words, '--', name], { cwd: dirname(path), encoding: 'utf8', maxBuffer: 1 << 28 });
  let told;
  answer((message) => { told = message; })({ data: { name, bytes: new Uint8Array(readFileSync(path)), width } });
  assert.equal(told.why, undefined, `law: there is an answer about ${name}`);
  assert.equal(told.lines.join('\n') + '\n', done.stdout, `law: the same lines about ${name}`);
  assert.equal(told.code, done.status, `law: the same exit code of ${name}`);
  said += told.lines.length;
}

assert.ok(files.length > 0, 'law: there are files to compare');
for (const path of files) {
  compared(path);
  compared(path, '--width');
}
console.log(`${said} lines of ${files.length} files are the same`);
