// Runs inside of VS Code's extension host.
const assert = require("node:assert");
const fs = require("node:fs");
const path = require("node:path");
const vscode = require("vscode");

const ID = "psdl-lang.psdl";

async function until(what, condition, milliseconds = 60_000) {
  let last;
  for (const end = Date.now() + milliseconds; Date.now() < end; await new Promise(resolve => setTimeout(resolve, 20))) {
    last = await condition();
    if (last) return last;
  }
  throw new Error(`never: ${what}`);
}

/** A test that waits for ever would keep those after it from being run. */
function limited(body) {
  const late = new Promise((_, reject) => setTimeout(() => reject(new Error("it did not end")), 120_000).unref());
  return Promise.race([body(), late]);
}

const folder = () => vscode.workspace.workspaceFolders[0].uri;
const file = name => vscode.Uri.joinPath(folder(), name);
const codes = uri => vscode.languages.getDiagnostics(uri).map(finding => (typeof finding.code === "object" ? finding.code.value : finding.code)).sort();
const api = () => vscode.extensions.getExtension(ID).exports;
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/** Waits until VS Code answers at once, for a while: but not for ever, where the machine is busy. */
async function quiet() {
  const end = Date.now() + 8000;
  for (let calm = 0, tries = 0; calm < 10 && Date.now() < end; tries++) {
    const asked = performance.now();
    await vscode.commands.executeCommand("setContext", "psdl.test", tries);
    calm = performance.now() - asked < 20 ? calm + 1 : 0;
    await new Promise(resolve => setTimeout(resolve, 50));
  }
}

async function open(name) {
  const document = await vscode.workspace.openTextDocument(file(name));
  return { document, editor: await vscode.window.showTextDocument(document) };
}

/** Gives a document another text. */
async function write(document, text) {
  const edit = new vscode.WorkspaceEdit();
  edit.replace(document.uri, new vscode.Range(0, 0, document.lineCount, 0), text);
  assert.ok(await vscode.workspace.applyEdit(edit));
}

const findings = (uri, expected) => until(`findings ${expected} (now ${codes(uri)})`, () => same(codes(uri), expected));

function place(document, text) {
  const at = document.getText().indexOf(text);
  assert.ok(at >= 0, `not in the text: ${text}`);
  return document.positionAt(at);
}

/** Code actions can come later than the findings that they are about: ask until they do. */
const actions = (document, range, kind, wanted) =>
  until(`a code action ${kind}`, async () => {
    const all = await vscode.commands.executeCommand("vscode.executeCodeActionProvider", document.uri, range, kind, 20);
    return all?.find(wanted ?? (() => true));
  });

async function perform(action) {
  if (action.edit) assert.ok(await vscode.workspace.applyEdit(action.edit));
  if (action.command) await vscode.commands.executeCommand(action.command.command, ...(action.command.arguments ?? []));
}

const LAMP = "lamp.min.z = table.max.z + 0.25";
let lamp;
let bundled;

const tests = {
  async "the extension becomes active when a program is opened"() {
    const extension = vscode.extensions.getExtension(ID);
    assert.equal(extension.isActive, false, "it is active before");
    // A window that was just opened is busy with itself: have that over, and measure ours.
    await open("plain.py");
    await quiet();
    const begun = performance.now();
    const opened = vscode.workspace.openTextDocument(file("lamp.psdl")).then(document => vscode.window.showTextDocument(document));
    while (!extension.isActive) await new Promise(resolve => setTimeout(resolve, 1));
    const took = performance.now() - begun;
    lamp = (await opened).document;
    return `active after ${took.toFixed(0)} ms`;
  },
  async "the server runs, and its version goes with the extension"() {
    const health = await until("a running server", () => api().health()?.kind === "running" && api().health());
    assert.equal(health.found.by, "bundled");
    bundled = health.found.path;
    assert.match(health.version, /^\d+\.\d+\.\d+/);
    assert.equal(health.matches, true);
  },
  async "a finding stands at its statement"() {
    assert.equal(lamp.languageId, "psdl");
    await findings(lamp.uri, ["standing"]);
    const [finding] = vscode.languages.getDiagnostics(lamp.uri);
    assert.equal(lamp.getText(finding.range), LAMP);
    assert.match(finding.message, /lamp floats 0.25 m above table/);
    assert.match(finding.code.target.toString(), /docs\/findings\/standing/);
    assert.ok(finding.relatedInformation.length > 0);
  },
  async "the status bar counts errors"() {
    await until("one error in the status bar", () => api().status() === "$(error) 1 psdl");
  },
  async "findings follow typing"() {
    await write(lamp, lamp.getText().replace("+ 0.25", "+ 0.3"));
    await until("the new finding", () => vscode.languages.getDiagnostics(lamp.uri).some(finding => /0.30 m/.test(finding.message)));
    await write(lamp, lamp.getText().replace("+ 0.3", "+ 0.25"));
    await until("the old finding", () => vscode.languages.getDiagnostics(lamp.uri).some(finding => /0.25 m/.test(finding.message)));
  },
  async "a quick fix removes Markdown fences"() {
    const { document } = await open("broken.psdl");
    await until("the finding", () => codes(document.uri).includes("markdown-fence"));
    await perform(await actions(document, new vscode.Range(0, 0, 0, 1), "quickfix"));
    assert.ok(!document.getText().includes("```"));
    await findings(document.uri, ["standing"]);
  },
  async "a quick fix corrects a layout error"() {
    await vscode.window.showTextDocument(lamp);
    const action = await actions(lamp, lamp.lineAt(place(lamp, LAMP).line).range, "quickfix", found => found.isPreferred);
    await perform(action);
    await findings(lamp.uri, []);
    await vscode.commands.executeCommand("undo");
    await until("the old text", () => lamp.getText().includes(LAMP));
  },
  async "the command corrects all, and one undo takes it back"() {
    const editor = await vscode.window.showTextDocument(lamp);
    await findings(lamp.uri, ["standing"]);
    const before = editor.document.getText();
    const result = await vscode.commands.executeCommand("psdl.fixAll");
    assert.deepEqual([result.before.errors, result.after.errors], [1, 0]);
    await findings(lamp.uri, []);
    await until("no error in the status bar", () => api().status() === "$(check) psdl");
    await vscode.commands.executeCommand("undo");
    await until("the old text", () => lamp.getText() === before);
  },
  async "the command for the selection keeps to it"() {
    const editor = await vscode.window.showTextDocument(lamp);
    await findings(lamp.uri, ["standing"]);
    editor.selection = new vscode.Selection(0, 0, 6, 0);
    const none = await vscode.commands.executeCommand("psdl.fixSelection");
    assert.equal(none.edits.length, 0);
    assert.ok(lamp.getText().includes(LAMP));
    const { line } = place(lamp, LAMP);
    editor.selection = new vscode.Selection(line, 0, line + 1, 0);
    const some = await vscode.commands.executeCommand("psdl.fixSelection");
    assert.equal(some.after.errors, 0);
    await vscode.commands.executeCommand("undo");
    await until("the old text", () => lamp.getText().includes(LAMP));
  },
  async "the status bar tells of the search"() {
    const { document } = await open("campsite.psdl");
    await until("findings", () => codes(document.uri).length > 0);
    const texts = [];
    const listening = api().onStatus(text => texts.push(text));
    const result = await vscode.commands.executeCommand("psdl.fixAll");
    listening.dispose();
    assert.ok(result.after.errors < result.before.errors, JSON.stringify(result));
    assert.ok(texts.some(text => /^\$\(loading~spin\) psdl: .*\d+ %$/.test(text)), texts.join(" | "));
    await vscode.commands.executeCommand("workbench.action.files.revert");
  },
  async "an object is moved to a place, and by a distance"() {
    await vscode.window.showTextDocument(lamp);
    const before = lamp.getText();
    const placed = await vscode.commands.executeCommand("psdl.move", { object: "lamp", to: "x=1.2" });
    assert.deepEqual([placed.reached[0], placed.exact], [1.2, true]);
    assert.ok(lamp.getText().includes("lamp.center.x = table.center.x + 1.2"));
    const further = await vscode.commands.executeCommand("psdl.move", { object: 1, to: "x-0.2" });
    assert.deepEqual([further.reached[0], further.exact], [1, true]);
    await write(lamp, before);
    await findings(lamp.uri, ["standing"]);
  },
  async "an object is turned"() {
    await vscode.window.showTextDocument(lamp);
    const before = lamp.getText();
    const turned = await vscode.commands.executeCommand("psdl.turn", { object: "lamp", facing: "X+" });
    assert.equal(turned.reached, "X+");
    assert.ok(lamp.getText().includes("lamp.facing = X_MAX"));
    await write(lamp, before);
    await findings(lamp.uri, ["standing"]);
  },
  async "what is behind another tab is corrected too"() {
    await vscode.window.showTextDocument(lamp, { preview: false });
    const before = lamp.getText();
    await vscode.commands.executeCommand("workbench.action.openWalkthrough", `${ID}#start`, false);
    await until("the walkthrough in front", () => vscode.window.activeTextEditor === undefined);
    const result = await vscode.commands.executeCommand("psdl.fixAll");
    assert.equal(result.after.errors, 0);
    await until("the program in front", () => vscode.window.activeTextEditor?.document === lamp);
    await write(lamp, before);
    await findings(lamp.uri, ["standing"]);
  },
  async "fix all on save, as the settings of VS Code ask for it"() {
    const { document } = await open("second.psdl");
    await findings(document.uri, ["standing"]);
    const config = vscode.workspace.getConfiguration("editor", { languageId: "psdl" });
    await config.update("codeActionsOnSave", { "source.fixAll.psdl": "explicit" }, vscode.ConfigurationTarget.Workspace, true);
    await write(document, `${document.getText()}# saved\n`);
    await document.save();
    await findings(document.uri, []);
    await config.update("codeActionsOnSave", undefined, vscode.ConfigurationTarget.Workspace, true);
    assert.ok(!fs.readFileSync(document.uri.fsPath, "utf8").includes(LAMP));
  },
  async "a picture is written as SVG and as PNG"() {
    await vscode.window.showTextDocument(lamp);
    const svg = await vscode.commands.executeCommand("psdl.render", "svg", file("lamp.svg"));
    assert.match(fs.readFileSync(svg.fsPath, "utf8"), /<svg[\s\S]*data-object="0"/);
    const png = await vscode.commands.executeCommand("psdl.render", "png", file("lamp.png"));
    assert.deepEqual([...fs.readFileSync(png.fsPath).subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
  },
  async "a scene is exported"() {
    await vscode.window.showTextDocument(lamp);
    const out = await vscode.commands.executeCommand("psdl.export", "layout", file("lamp.layout.json"));
    const layout = JSON.parse(fs.readFileSync(out.fsPath, "utf8"));
    assert.deepEqual(layout.objects.map(object => object.path), ["table", "lamp", "chairs[0]", "chairs[1]"]);
  },
  async "a text without a file is exported too"() {
    const document = await vscode.workspace.openTextDocument({ language: "psdl", content: lamp.getText() });
    await vscode.window.showTextDocument(document);
    const out = await vscode.commands.executeCommand("psdl.export", "layout", file("untitled.layout.json"));
    assert.equal(JSON.parse(fs.readFileSync(out.fsPath, "utf8")).scene.title, "Lamp");
    await vscode.commands.executeCommand("workbench.action.revertAndCloseActiveEditor");
  },
  async "hover, completion, outline and the rest are there"() {
    await vscode.window.showTextDocument(lamp);
    const at = place(lamp, LAMP);
    const ask = (what, ...rest) => until(what, async () => {
      const answer = await vscode.commands.executeCommand(what, lamp.uri, ...rest);
      return (answer?.items ?? answer?.signatures ?? answer?.data ?? answer)?.length > 0 && answer;
    });
    const hover = await ask("vscode.executeHoverProvider", at);
    assert.match(hover[0].contents.map(part => part.value ?? part).join("\n"), /lamp/i);
    const list = await ask("vscode.executeCompletionItemProvider", at.translate(0, "lamp.".length), ".");
    const labels = list.items.map(item => item.label.label ?? item.label);
    for (const word of ["center", "min", "max", "facing"]) assert.ok(labels.includes(word), `${word} in ${labels.slice(0, 20)}`);
    const symbols = await ask("vscode.executeDocumentSymbolProvider");
    const named = list => list.flatMap(symbol => [symbol.name, ...named(symbol.children ?? [])]);
    assert.ok(named(symbols).includes("lamp"), `lamp in ${named(symbols)}`);
    const [definition] = await ask("vscode.executeDefinitionProvider", at);
    assert.equal((definition.targetSelectionRange ?? definition.targetRange ?? definition.range).start.line, place(lamp, "lamp = Object").line);
    assert.equal((await ask("vscode.executeReferenceProvider", place(lamp, "gap = 0.05"))).length, 3);
    const rename = await vscode.commands.executeCommand("vscode.executeDocumentRenameProvider", lamp.uri, place(lamp, "gap = 0.05"), "distance");
    assert.equal(rename.entries()[0][1].length, 3);
    await ask("vscode.executeFoldingRangeProvider");
    await ask("vscode.executeInlayHintProvider", new vscode.Range(0, 0, lamp.lineCount, 0));
    await ask("vscode.executeCodeLensProvider", 100);
    await ask("vscode.executeDocumentColorProvider");
    await ask("vscode.provideDocumentSemanticTokens");
    await ask("vscode.executeSignatureHelpProvider", place(lamp, 'width=0.2'), "(");
  },
  async "snippets are offered"() {
    const { document } = await open("second.psdl");
    const list = await until("snippets", async () => {
      const found = await vscode.commands.executeCommand("vscode.executeCompletionItemProvider", document.uri, new vscode.Position(document.lineCount - 1, 0));
      return found?.items.some(item => item.kind === vscode.CompletionItemKind.Snippet) && found;
    });
    const labels = list.items.filter(item => item.kind === vscode.CompletionItemKind.Snippet).map(item => item.label.label ?? item.label);
    assert.ok(labels.includes("ontop"), String(labels));
  },
  async "the example opens"() {
    await vscode.commands.executeCommand("psdl.openExample");
    const document = vscode.window.activeTextEditor.document;
    assert.equal(document.languageId, "psdl");
    await findings(document.uri, ["standing"]);
    await vscode.commands.executeCommand("workbench.action.revertAndCloseActiveEditor");
  },
  async "the server is restarted, and findings come back"() {
    await vscode.window.showTextDocument(await vscode.workspace.openTextDocument(lamp.uri));
    await vscode.commands.executeCommand("psdl.restart");
    assert.equal(api().health().kind, "running");
    await findings(lamp.uri, ["standing"]);
  },
  async "a wrong path is said, and not replaced by another program"() {
    const config = vscode.workspace.getConfiguration("psdl");
    await config.update("server.path", "/there/is/no/psdl", vscode.ConfigurationTarget.Global);
    const health = await until("a stopped server", () => api().health().kind === "stopped" && api().health());
    assert.match(health.why, /psdl\.server\.path is “\/there\/is\/no\/psdl”, but there is no program/);
    assert.equal(api().status(), "$(warning) psdl");
    await vscode.commands.executeCommand("notifications.clearAll");
  },
  async "a program that is no server is said"() {
    const config = vscode.workspace.getConfiguration("psdl");
    await config.update("server.path", "/bin/true", vscode.ConfigurationTarget.Global);
    const health = await until("a stopped server", () => api().health().kind === "stopped" && /does not answer/.test(api().health().why) && api().health());
    assert.match(health.why, /\/bin\/true does not answer as a server for PSDL/);
    await vscode.commands.executeCommand("notifications.clearAll");
  },
  async "a server of another version is said, and serves what it can"() {
    // The real server, behind a program that gives it another version of the same length.
    const other = path.join(folder().fsPath, "psdl-of-another-version");
    const rename = `require("node:child_process").spawn(process.argv[1], process.argv.slice(2), { stdio: ["inherit", "pipe", "inherit"] }).stdout.on("data", data => process.stdout.write(Buffer.from(data.toString("latin1").replace('"version":"0.', '"version":"9.'), "latin1")))`;
    fs.writeFileSync(other, `#!/bin/sh\nexec '${process.execPath}' -e '${rename.replaceAll("'", `'\\''`)}' '${bundled}' "$@"\n`, { mode: 0o755 });
    await vscode.workspace.getConfiguration("psdl").update("server.path", other, vscode.ConfigurationTarget.Global);
    const health = await until("a server of another version", () => api().health().kind === "running" && api().health().matches === false && api().health());
    assert.match(health.version, /^9\./);
    assert.equal(health.found.by, "setting");
    await findings(lamp.uri, ["standing"]);
    await vscode.commands.executeCommand("notifications.clearAll");
  },
  async "the setting back, the server is back"() {
    await vscode.workspace.getConfiguration("psdl").update("server.path", undefined, vscode.ConfigurationTarget.Global);
    await until("a running server", () => api().health().kind === "running");
    await findings(lamp.uri, ["standing"]);
  },
  async "the task checks the folder, and its matcher finds the errors"() {
    await vscode.commands.executeCommand("workbench.action.closeAllEditors");
    fs.writeFileSync(path.join(folder().fsPath, "task.psdl"), fs.readFileSync(file("lamp.psdl").fsPath));
    const [task] = await vscode.tasks.fetchTasks({ type: "psdl" });
    assert.equal(task.name, "check");
    const ended = new Promise(resolve => {
      const listening = vscode.tasks.onDidEndTaskProcess(event => {
        listening.dispose();
        resolve(event.exitCode);
      });
    });
    await vscode.tasks.executeTask(task);
    assert.equal(await ended, 1);
    const found = await until("a problem of the task", () => vscode.languages.getDiagnostics(file("task.psdl")).find(finding => /lamp floats/.test(finding.message)));
    assert.equal(found.range.start.line, place(lamp, LAMP).line);
  },
};

exports.run = async () => {
  const only = process.env.PSDL_TEST_ONLY && new RegExp(process.env.PSDL_TEST_ONLY);
  let passed = 0;
  let failed = 0;
  const lines = [`# VS Code ${vscode.version}`];
  const write = () => fs.writeFileSync(process.env.PSDL_TEST_RESULT, `${lines.join("\n")}\n`);
  for (const [name, body] of Object.entries(tests).filter(([name], index) => !only || index < 2 || only.test(name))) {
    const begun = Date.now();
    try {
      const note = await limited(body);
      passed++;
      lines.push(`ok - ${name} (${Date.now() - begun} ms)${note ? `: ${note}` : ""}`);
    } catch (error) {
      failed++;
      lines.push(`not ok - ${name} (${Date.now() - begun} ms): ${error.stack ?? error}`);
    }
    write();
  }
  lines.push(`${passed} passed, ${failed} failed`);
  write();
};
