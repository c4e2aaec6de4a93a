// The constants of the program as sliders. A slider edits the literal; one undo takes back one drag.

import * as vscode from "vscode";
import { Follower } from "./follow";
import type { FromSliders, Slider, ToSliders } from "./messages";
import { literalBefore } from "./number";
import { page, resources } from "./page";
import type { Current } from "./program";
import { ConstantsRequest, VERSION, type Constant } from "./protocol";
import type { Server } from "./server";

/** Constants, and the text that they are of. */
interface Known {
  uri: vscode.Uri;
  version: number;
  /** Counts the texts, so that a page that speaks of an older one is refused, and one that drags is not. */
  generation: number;
  constants: { constant: Constant; range: vscode.Range }[];
}

export class Sliders implements vscode.WebviewViewProvider, vscode.Disposable {
  private readonly parts: vscode.Disposable[];
  private readonly follower: Follower;
  private readonly moves: Follower;
  private view: vscode.WebviewView | undefined;
  private uri: vscode.Uri | undefined;
  private known: Known | undefined;
  private generation = 0;
  /** What the page asked for and was not yet done; a newer value of the same drag replaces an older one. */
  private wanted: (FromSliders & { kind: "set" })[] = [];
  private dragging = false;

  constructor(
    private readonly extension: vscode.Uri,
    private readonly server: Server,
    private readonly current: Current,
  ) {
    const failed = (error: unknown): void => {
      this.send({ kind: "note", text: error instanceof Error ? error.message : String(error) });
    };
    this.follower = new Follower(() => this.load(), failed);
    this.moves = new Follower(() => this.move(), failed);
    const poke = (): void => {
      if (this.view?.visible === true && !this.dragging) this.follower.poke();
    };
    this.parts = [
      vscode.window.registerWebviewViewProvider("psdl.constants", this),
      vscode.window.onDidChangeActiveTextEditor(poke),
      vscode.workspace.onDidChangeTextDocument(({ document }) => {
        if (document.uri.toString() === this.uri?.toString()) poke();
      }),
      server.onDidChange(poke),
    ];
  }

  resolveWebviewView(view: vscode.WebviewView): void {
    this.view = view;
    view.webview.options = { enableScripts: true, localResourceRoots: resources(this.extension) };
    view.webview.onDidReceiveMessage((message: FromSliders) => {
      this.hear(message);
    });
    view.onDidChangeVisibility(() => {
      if (view.visible) this.follower.poke();
    });
    view.onDidDispose(() => {
      this.dragging = false;
      this.view = undefined;
    });
    view.webview.html = page(view.webview, this.extension, "sliders", "Constants");
  }

  dispose(): void {
    this.follower.end();
    this.moves.end();
    for (const part of this.parts) part.dispose();
  }

  private send(message: ToSliders): void {
    void this.view?.webview.postMessage(message);
  }

  private async load(): Promise<void> {
    const uri = this.current.document?.uri ?? this.uri;
    this.uri = uri;
    if (uri === undefined) {
      this.send({ kind: "note", text: "Open a .psdl file to tune its constants." });
      return;
    }
    if (this.server.running !== undefined && this.server.protocol !== VERSION) {
      this.send({ kind: "note", text: "This version of psdl does not tell editors about constants; update it." });
      return;
    }
    const result = await this.server.ask(ConstantsRequest, { textDocument: { uri: uri.toString() } });
    if (result?.version === undefined || result.version === null || this.dragging) return;
    const constants = result.constants.map(constant => {
      const { start, end } = constant.range;
      return { constant, range: new vscode.Range(start.line, start.character, end.line, end.character) };
    });
    const same = this.known?.uri.toString() === uri.toString() && this.known.version === result.version;
    if (!same) this.generation++;
    this.known = { uri, version: result.version, generation: this.generation, constants };
    this.send({ kind: "constants", title: uri.path.slice(uri.path.lastIndexOf("/") + 1), generation: this.generation, constants: constants.map(slider) });
  }

  private hear(message: FromSliders): void {
    if (message.kind === "ready") {
      this.dragging = false; // a page that is new drags nothing
      this.follower.poke();
    } else if (message.kind === "show") {
      void this.show(message.index, message.generation);
    } else {
      const last = this.wanted.at(-1);
      if (last?.phase === "next" && message.phase !== "first") this.wanted.pop();
      this.wanted.push(message);
      this.moves.poke();
    }
  }

  private async show(index: number, generation: number): Promise<void> {
    const known = this.known;
    const range = known?.generation === generation ? known.constants[index]?.range : undefined;
    if (known === undefined || range === undefined) return;
    await vscode.window.showTextDocument(await vscode.workspace.openTextDocument(known.uri), { selection: range });
  }

  /** Does what the page asked for, in order. */
  private async move(): Promise<void> {
    for (let next = this.wanted.shift(); next !== undefined; next = this.wanted.shift()) {
      this.dragging = next.phase !== "last";
      await this.set(next);
      if (!this.dragging) this.follower.poke();
    }
  }

  private async set({ index, generation, value, phase }: FromSliders & { kind: "set" }): Promise<void> {
    const known = this.known;
    const here = known?.generation === generation ? known.constants[index] : undefined;
    const document = vscode.workspace.textDocuments.find(({ uri }) => uri.toString() === known?.uri.toString());
    if (known === undefined || here === undefined || document?.version !== known.version) {
      // The text has changed since these constants were asked for: their places mean nothing any more.
      this.dragging = false;
      this.follower.poke();
      return;
    }
    const { range } = here;
    const text = literalBefore(value, document.lineAt(range.end.line).text.slice(range.end.character));
    if (text !== document.getText(range) && !(await replace(document, range, text, phase))) return;
    known.version = document.version;
    const end = range.start.translate(0, text.length);
    const shift = end.character - range.end.character;
    here.range = new vscode.Range(range.start, end);
    for (const other of known.constants) {
      if (other !== here && other.range.start.line === range.end.line && other.range.start.isAfterOrEqual(range.end)) {
        other.range = new vscode.Range(other.range.start.translate(0, shift), other.range.end.translate(0, shift));
      }
    }
  }
}

/** Writes a text into a range; an edit of a visible editor joins those of the same drag for undo. */
async function replace(document: vscode.TextDocument, range: vscode.Range, text: string, phase: "first" | "next" | "last"): Promise<boolean> {
  const editor = vscode.window.visibleTextEditors.find(visible => visible.document === document);
  if (editor !== undefined) {
    const stops = { undoStopBefore: phase === "first", undoStopAfter: phase === "last" };
    return editor.edit(
      edit => {
        edit.replace(range, text);
      },
      stops,
    );
  }
  const edit = new vscode.WorkspaceEdit();
  edit.replace(document.uri, range, text);
  return vscode.workspace.applyEdit(edit);
}

function slider({ constant, range }: { constant: Constant; range: vscode.Range }, index: number): Slider {
  const moves = constant.moves.map(({ path }) => path);
  const label = constant.name ?? (moves[0] === undefined ? constant.text : moves.length > 1 ? `${moves[0]} +${moves.length - 1}` : moves[0]);
  return { index, label, line: range.start.line + 1, text: constant.text, value: constant.value, good: constant.good, moves, errors: constant.errors };
}
