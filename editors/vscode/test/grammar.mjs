// The grammar in the engine that VS Code uses, on top of the grammar for Python that VS Code brings.
import assert from "node:assert";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const workbench = path.join(path.dirname(process.env.CODE_SERVER), "../../lib/vscode");
const load = createRequire(`${workbench}/`);
const oniguruma = load("vscode-oniguruma");
const { Registry, INITIAL, parseRawGrammar } = load("vscode-textmate");
const here = path.join(import.meta.dirname, "..");
const files = {
  "source.psdl": path.join(here, "syntaxes/psdl.tmLanguage.json"),
  "psdl.names": path.join(here, "syntaxes/psdl.names.tmLanguage.json"),
  "source.python": path.join(workbench, "extensions/python/syntaxes/MagicPython.tmLanguage.json"),
  "source.regexp.python": path.join(workbench, "extensions/python/syntaxes/MagicRegExp.tmLanguage.json"),
};
await oniguruma.loadWASM(fs.readFileSync(load.resolve("vscode-oniguruma/release/onig.wasm")));
const registry = new Registry({
  onigLib: Promise.resolve({ createOnigScanner: patterns => new oniguruma.OnigScanner(patterns), createOnigString: text => new oniguruma.OnigString(text) }),
  loadGrammar: async scope => (files[scope] ? parseRawGrammar(fs.readFileSync(files[scope], "utf8"), files[scope]) : null),
  getInjections: scope => (scope === "source.psdl" ? ["psdl.names"] : []),
});
const grammar = await registry.loadGrammar("source.psdl");

/** The scopes of the first token with a text, in a line. */
function scopes(line, text) {
  const { tokens } = grammar.tokenizeLine(line, INITIAL);
  const token = tokens.find(({ startIndex, endIndex }) => line.slice(startIndex, endIndex) === text);
  assert.ok(token, `no token ${text} in ${line}: ${tokens.map(({ startIndex, endIndex }) => line.slice(startIndex, endIndex)).join("|")}`);
  return token.scopes.join(" ");
}

const cases = [
  ['bed = Object("Bed 2.5", width=1.6)', "Object", /support\.class\.psdl/],
  ['bed = Object("Bed 2.5", width=1.6)', "1.6", /constant\.numeric\.float\.tunable\.psdl/],
  ['bed = Object("Bed 2.5", width=1.6)', "Bed 2.5", /string\.quoted.*python$/],
  ["set_coordinate_frame(bed)", "set_coordinate_frame", /support\.function\.psdl/],
  ["bed.facing = Y_MIN  # Y_MAX", "Y_MIN", /constant\.language\.direction\.psdl/],
  ["bed.facing = Y_MIN  # Y_MAX", "facing", /support\.variable\.property\.anchor\.psdl/],
  ["bed.facing = Y_MIN  # Y_MAX", " Y_MAX", /comment/],
  ["bed.max.y = scene.max.y - .25", "scene", /variable\.language\.scene\.psdl/],
  ["bed.max.y = scene.max.y - .25", ".25", /constant\.numeric\.float\.tunable\.psdl/],
  ["bed.max.y = scene.max.y - 25", "25", /constant\.numeric\.dec\.python/],
  ["x = Object(support=MOUNTED)", "MOUNTED", /constant\.language\.support\.psdl/],
  ["for i in range(3):", "for", /keyword\.control/],
  ["def place(o, gap=0.1):", "place", /entity\.name\.function/],
  ["def place(o, gap=0.1):", "0.1", /tunable\.psdl/],
  ["rows[2].center.x = 1e-3", "1e-3", /tunable\.psdl/],
];
let failed = 0;
for (const [line, text, expected] of cases) {
  try {
    assert.match(scopes(line, text), expected);
    console.log(`ok - ${text} in ${line}`);
  } catch (error) {
    failed++;
    console.log(`not ok - ${text} in ${line}: ${error.message}`);
  }
}
console.log(`${cases.length - failed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
