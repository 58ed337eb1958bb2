// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles the part of three.js that the page uses into three.bundle.js, a classic script that defines THREE: npm ci && npm run build.
// The bundle is committed, so that a build of fathom needs no Node; this script only refreshes it.
import { build } from "esbuild";
import { readFileSync } from "node:fs";

const version = JSON.parse(readFileSync("node_modules/three/package.json", "utf8")).version;

await build({
  entryPoints: ["exports.js"],
  outfile: "three.bundle.js",
  bundle: true,
  minify: true,
  format: "iife",
  globalName: "THREE",
  target: "es2020",
  charset: "ascii",
  legalComments: "none",
  footer: { js: "globalThis.THREE = THREE;" },
  banner: { js: `/* three.js ${version}, MIT licence: Copyright (c) 2010-2025 three.js authors. See LICENSE beside this file. */` },
});
