// The commands: correct, draw, export, and a menu of them.

import { execFile } from "node:child_process";
import * as path from "node:path";
import * as vscode from "vscode";
import { Places, type Wish } from "./place";
import type { Current } from "./program";
import { FixRequest, overtaken, RenderRequest, type FixParams, type FixResult } from "./protocol";
import { able, type Server } from "./server";
import type { Status } from "./status";

const PICTURES = ["svg", "png"] as const;

/** The formats of `psdl export`, and what their files end in. */
const EXPORTS: readonly { to: string; ends: string; what: string }[] = [
  { to: "glb", ends: "glb", what: "glTF 2.0, binary" },
  { to: "usda", ends: "usda", what: "Universal Scene Description, text" },
  { to: "obj", ends: "obj", what: "Wavefront OBJ" },
  { to: "html", ends: "html", what: "One page that shows the scene in 3D" },
  { to: "layout", ends: "json", what: "Boxes, facings, anchors and errors as JSON" },
  { to: "csv", ends: "csv", what: "A table, one row an object" },
  { to: "visualizer", ends: "json", what: "The JSON of the SceneVisualizer" },
  { to: "mjcf", ends: "xml", what: "Static boxes for MuJoCo" },
  { to: "urdf", ends: "urdf", what: "Static boxes as links of a URDF" },
];

let tokens = 0;

async function fix(server: Server, status: Status, current: Current, selection: boolean): Promise<FixResult | undefined> {
  const editor = await current.editor();
  const client = server.running;
  if (editor === undefined || !able(server) || client === undefined) return undefined;
  const document = editor.document;
  const token = `psdl-fix-${tokens++}`;
  const params: FixParams = { textDocument: { uri: client.code2ProtocolConverter.asUri(document.uri) }, workDoneToken: token };
  if (selection) params.range = client.code2ProtocolConverter.asRange(editor.selection);
  const { WorkDoneProgress } = await import("vscode-languageclient/node");
  const result = await vscode.window.withProgress(
    { location: vscode.ProgressLocation.Notification, title: "Correcting the scene", cancellable: true },
    async (progress, cancel) => {
      let told = 0;
      const listening = client.onProgress(WorkDoneProgress.type, token, work => {
        status.note(token, work);
        if (work.kind === "end") return;
        const percentage = work.percentage ?? told;
        const message = work.message ?? "";
        progress.report({ message, increment: percentage - told });
        told = percentage;
      });
      try {
        return await server.ask(FixRequest, params, cancel);
      } catch (error) {
        if (cancel.isCancellationRequested) return undefined;
        if (!overtaken(error)) throw error;
        changed();
        return undefined;
      } finally {
        listening.dispose();
        status.note(token, { kind: "end" });
      }
    },
  );
  if (result === undefined) return undefined;
  if (result.edits.length === 0) {
    const left = result.before.errors;
    void vscode.window.showInformationMessage(left === 0 ? "There is nothing to correct." : `No correction was found; ${count(left, "error")} left.`);
    return result;
  }
  if (result.version !== null && result.version !== document.version) {
    changed();
    return undefined;
  }
  await vscode.workspace.applyEdit(await client.protocol2CodeConverter.asWorkspaceEdit(result.edit));
  const text = `${count(result.edits.length, "edit")}, errors ${result.before.errors} → ${result.after.errors}, ${count(result.moved, "object")} moved`;
  vscode.window.setStatusBarMessage(`$(check) ${text}`, 8000);
  return result;
}

function changed(): void {
  void vscode.window.showWarningMessage("The text has changed meanwhile; nothing was corrected.");
}

function count(number: number, word: string): string {
  return `${number} ${word}${number === 1 ? "" : "s"}`;
}

/** Where to write a file beside a program. */
async function place(document: vscode.TextDocument, ends: string, given: vscode.Uri | undefined): Promise<vscode.Uri | undefined> {
  if (given !== undefined) return given;
  const stem = path.basename(document.fileName, path.extname(document.fileName));
  const beside = document.uri.scheme === "file" ? vscode.Uri.joinPath(document.uri, "..", `${stem}.${ends}`) : undefined;
  return vscode.window.showSaveDialog({ ...(beside && { defaultUri: beside }), filters: { [ends.toUpperCase()]: [ends] } });
}

async function render(server: Server, current: Current, format?: string, target?: vscode.Uri): Promise<vscode.Uri | undefined> {
  const editor = await current.editor();
  if (editor === undefined || !able(server)) return undefined;
  const picked = PICTURES.find(known => known === format) ?? ((await vscode.window.showQuickPick([...PICTURES], { title: "Format of the picture" })) as (typeof PICTURES)[number] | undefined);
  const file = picked && (await place(editor.document, picked, target));
  if (picked === undefined || file === undefined) return undefined;
  const textDocument = { uri: editor.document.uri.toString() };
  const result = await server.ask(RenderRequest, { textDocument, format: picked, view: "both", theme: "light", width: 1600, height: 800 });
  if (result === undefined) return undefined;
  await vscode.workspace.fs.writeFile(file, Buffer.from(result.data, picked === "png" ? "base64" : "utf8"));
  if (target === undefined) await vscode.commands.executeCommand("vscode.open", file, vscode.ViewColumn.Beside);
  return file;
}

async function exportScene(server: Server, current: Current, to?: string, target?: vscode.Uri): Promise<vscode.Uri | undefined> {
  const editor = await current.editor();
  const health = server.health;
  if (editor === undefined) return undefined;
  if (health.kind !== "running") {
    void vscode.window.showErrorMessage("The server of psdl is not running.");
    return undefined;
  }
  const items = EXPORTS.map(format => ({ label: format.to, description: format.what, format }));
  const picked = EXPORTS.find(known => known.to === to) ?? (await vscode.window.showQuickPick(items, { title: "Format of the export" }))?.format;
  const document = editor.document;
  const file = picked && (await place(document, picked.ends, target));
  if (picked === undefined || file === undefined) return undefined;
  // A file is exported from the disk, where its template is found; a text without a file through standard input.
  const onDisk = document.uri.scheme === "file";
  if (onDisk && document.isDirty) await document.save();
  const args = ["export", "--to", picked.to, "--output", file.fsPath, onDisk ? document.fileName : "-"];
  try {
    await run(health.found.path, args, onDisk ? "" : document.getText());
  } catch (error) {
    void vscode.window.showErrorMessage(`The scene could not be exported: ${error instanceof Error ? error.message : String(error)}`);
    return undefined;
  }
  if (target === undefined) void vscode.window.showInformationMessage(`Wrote ${file.fsPath}`);
  return file;
}

function run(command: string, args: string[], input: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const child = execFile(command, args, { timeout: 60_000 }, (error, _, complaint) => {
      if (error === null) resolve();
      else reject(new Error(complaint.trim() === "" ? error.message : complaint.trim()));
    });
    child.stdin?.on("error", () => undefined); // it may end before it has read all
    child.stdin?.end(input);
  });
}

async function menu(server: Server): Promise<void> {
  const items = [
    { label: "$(wand) Correct All Errors", command: "psdl.fixAll" },
    { label: "$(open-preview) Show the Scene", command: "psdl.showScene" },
    { label: "$(move) Move the Object…", command: "psdl.move" },
    { label: "$(sync) Turn the Object…", command: "psdl.turn" },
    { label: "$(save-as) Export…", command: "psdl.export" },
    { label: "$(debug-restart) Restart the Server", command: "psdl.restart" },
    { label: "$(output) Show the Log", command: "psdl.showLog" },
  ];
  const health = server.health;
  const title = health.kind === "running" ? `psdl ${health.version}` : health.kind === "stopped" ? health.why : "psdl is being started";
  const picked = await vscode.window.showQuickPick(items, { title });
  if (picked !== undefined) await vscode.commands.executeCommand(picked.command);
}

async function example(extension: vscode.ExtensionContext): Promise<void> {
  const text = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(extension.extensionUri, "walkthrough", "lamp.psdl"));
  const document = await vscode.workspace.openTextDocument({ language: "psdl", content: Buffer.from(text).toString("utf8") });
  await vscode.window.showTextDocument(document);
}

/** Registers them all. */
export function commands(extension: vscode.ExtensionContext, server: Server, status: Status, current: Current): vscode.Disposable[] {
  const on = (name: string, action: (...args: never[]) => unknown): vscode.Disposable => vscode.commands.registerCommand(name, action);
  const places = new Places(server, current);
  return [
    on("psdl.fixAll", () => fix(server, status, current, false)),
    on("psdl.fixSelection", () => fix(server, status, current, true)),
    on("psdl.move", (wish?: Wish) => places.move(wish ?? {})),
    on("psdl.turn", (wish?: Wish) => places.turn(wish ?? {})),
    on("psdl.render", (format?: string, target?: vscode.Uri) => render(server, current, format, target)),
    on("psdl.export", (to?: string, target?: vscode.Uri) => exportScene(server, current, to, target)),
    on("psdl.restart", () => server.restart()),
    on("psdl.showLog", () => {
      server.showLog();
    }),
    on("psdl.showTrace", () => {
      server.showTrace();
    }),
    on("psdl.menu", () => menu(server)),
    on("psdl.openExample", () => example(extension)),
  ];
}
