// Bundles the extension and its pages into dist/.
import esbuild from "esbuild";

const watch = process.argv.includes("--watch");
const shared = { bundle: true, minify: !watch, sourcemap: watch, logLevel: "warning", legalComments: "none" };
// The language client is most of the code: in a file of its own it is read when the server is started, and not before.
const client = {
  name: "client",
  setup: build => build.onResolve({ filter: /^vscode-languageclient\/node$/ }, () => ({ path: "./client.js", external: true })),
};
const node = { ...shared, platform: "node", format: "cjs", target: "node20", external: ["vscode"] };
const parts = [
  { ...node, entryPoints: ["src/extension.ts"], outfile: "dist/extension.js", plugins: [client], supported: { "dynamic-import": false } },
  { ...node, entryPoints: ["vscode-languageclient/node"], outfile: "dist/client.js" },
  {
    ...shared,
    entryPoints: { picture: "src/webview/picture.ts", sliders: "src/webview/sliders.ts" },
    outdir: "dist",
    platform: "browser",
    format: "iife",
    target: "chrome120",
  },
];
if (watch) for (const part of parts) await (await esbuild.context(part)).watch();
else await Promise.all(parts.map(part => esbuild.build(part)));
