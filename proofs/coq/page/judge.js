// SPDX-License-Identifier: GPL-3.0-or-later
// The worker: `program`, which the build puts before this, is fathom-check-proved as js_of_ocaml has translated it. It runs from its
// beginning for each file, as a process would, with the file as the only one there is; so nothing is left of one file for the next.
'use strict';

const ended = { toString: () => 'the program has ended' };

/** Its bytes as the characters 0 to 255. */
function characters(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode.apply(null, bytes.subarray(i, i + 32768));
  return text;
}

/** {lines, code}: what `fathom-check-proved [--width] NAME` prints, and its exit code. Throws what stops it otherwise. */
function judged({ name, bytes, width }) {
  const self = globalThis, { process, console } = self;
  const said = [], blamed = [];
  let code = null;
  const file = { name: unescape(encodeURIComponent(name)), content: characters(bytes) };
  self.process = { argv: ['', 'fathom-check-proved', ...(width ? ['--width'] : []), '--', name],
    stdout: { write: (text) => said.push(text) }, stderr: { write: (text) => blamed.push(text) } };
  self.caml_fs_tmp = [file];
  self.jsoo_fs_tmp = [file];  // js_of_ocaml from 5 on, which writes to the console: lines without their ends
  self.console = { log: (line) => said.push(line, '\n'), error: (line) => blamed.push(line, '\n') };
  self.jsoo_create_file = undefined;
  self.quit = (number) => {
    code = number;
    throw ended;
  };
  try {
    program();
  } catch (stop) {
    if (stop !== ended) throw stop;
  } finally {
    Object.assign(self, { process, console });
  }
  if (blamed.length || code === null) throw new Error(blamed.join('') || 'the program has not ended');
  return { lines: said.join('').split('\n').filter((line) => line), code };
}

onmessage = ({ data }) => {
  try {
    postMessage(judged(data));
  } catch (stop) {
    postMessage({ lines: [], code: null, why: String(stop) });
  }
};
