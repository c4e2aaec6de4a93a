// The picture of a scene beside its text. It follows typing; a click in it selects the statement that placed the object.

import * as vscode from "vscode";
import { Follower } from "./follow";
import type { FromPicture, PictureState, ToPicture } from "./messages";
import { page, resources } from "./page";
import type { Current } from "./program";
import { RenderRequest, VERSION, type RenderResult, type View } from "./protocol";
import type { Server } from "./server";

const TYPE = "psdl.picture";

/** All pictures: at most one for each program. */
export class Pictures implements vscode.Disposable {
  private readonly open = new Map<string, Picture>();
  private readonly parts: vscode.Disposable[];

  constructor(
    private readonly extension: vscode.Uri,
    private readonly server: Server,
    private readonly current: Current,
  ) {
    this.parts = [
      vscode.commands.registerCommand("psdl.showScene", () => this.show()),
      vscode.window.registerWebviewPanelSerializer(TYPE, {
        deserializeWebviewPanel: async (panel, state: PictureState | undefined) => {
          await this.revive(panel, state);
        },
      }),
    ];
  }

  async show(): Promise<void> {
    const document = (await this.current.editor())?.document;
    if (document === undefined) return;
    const before = this.open.get(document.uri.toString());
    if (before !== undefined) {
      before.reveal();
      return;
    }
    const where = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    this.adopt(vscode.window.createWebviewPanel(TYPE, "Scene", where), document.uri);
  }

  dispose(): void {
    for (const part of [...this.parts, ...this.open.values()]) part.dispose();
  }

  private async revive(panel: vscode.WebviewPanel, state: PictureState | undefined): Promise<void> {
    if (state?.uri === undefined || this.open.has(state.uri)) {
      panel.dispose();
      return;
    }
    const uri = vscode.Uri.parse(state.uri, true);
    try {
      await vscode.workspace.openTextDocument(uri); // the server only draws what is open
    } catch {
      panel.dispose();
      return;
    }
    this.adopt(panel, uri);
  }

  private adopt(panel: vscode.WebviewPanel, uri: vscode.Uri): void {
    const key = uri.toString();
    this.open.set(key, new Picture(panel, uri, this.extension, this.server));
    panel.onDidDispose(() => {
      this.open.get(key)?.dispose();
      this.open.delete(key);
    });
  }
}

class Picture implements vscode.Disposable {
  private readonly parts: vscode.Disposable[];
  private readonly follower: Follower;
  private result: RenderResult | undefined;
  private wanted: { view: View; theme: "light" | "dark"; width: number; height: number } | undefined;

  constructor(
    private readonly panel: vscode.WebviewPanel,
    private readonly uri: vscode.Uri,
    extension: vscode.Uri,
    private readonly server: Server,
  ) {
    this.follower = new Follower(
      () => this.draw(),
      error => {
        this.send({ kind: "note", text: error instanceof Error ? error.message : String(error) });
      },
    );
    const name = uri.path.slice(uri.path.lastIndexOf("/") + 1);
    panel.title = `Scene of ${name}`;
    panel.iconPath = { light: vscode.Uri.joinPath(extension, "media", "file-light.svg"), dark: vscode.Uri.joinPath(extension, "media", "file-dark.svg") };
    panel.webview.options = { enableScripts: true, localResourceRoots: resources(extension) };
    this.parts = [
      panel.webview.onDidReceiveMessage((message: FromPicture) => {
        void this.hear(message);
      }),
      vscode.workspace.onDidChangeTextDocument(({ document }) => {
        // A template beside it changes the scene as well.
        if (this.concerns(document.uri)) this.follower.poke();
      }),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => {
        if (textEditor.document.uri.toString() === uri.toString()) this.mark(textEditor.selection.active);
      }),
      server.onDidChange(({ kind }) => {
        if (kind === "running") this.follower.poke();
      }),
    ];
    panel.webview.html = page(panel.webview, extension, "picture", "Scene");
  }

  reveal(): void {
    this.panel.reveal(undefined, true);
  }

  dispose(): void {
    this.follower.end();
    for (const part of this.parts) part.dispose();
  }

  private concerns(changed: vscode.Uri): boolean {
    return changed.toString() === this.uri.toString() || changed.path === this.uri.path.replace(/\.psdl$/, ".template.json");
  }

  private send(message: ToPicture): void {
    void this.panel.webview.postMessage(message);
  }

  private async draw(): Promise<void> {
    if (this.wanted === undefined) return;
    const { running, protocol } = this.server;
    if (running !== undefined && protocol !== VERSION) {
      this.send({ kind: "note", text: "This version of psdl cannot draw for editors; update it." });
      return;
    }
    const textDocument = { uri: this.uri.toString() };
    const result = await this.server.ask(RenderRequest, { textDocument, format: "svg", errors: true, ...this.wanted });
    if (result === undefined) {
      this.send({ kind: "note", text: "The server of psdl is not running." });
      return;
    }
    this.result = result;
    const paths = Object.fromEntries(result.objects.map(({ index, path }) => [index, path]));
    this.send({ kind: "picture", uri: this.uri.toString(), title: this.panel.title, svg: result.data, stale: result.stale, paths });
    const editor = this.editor();
    if (editor !== undefined) this.mark(editor.selection.active);
  }

  private async hear(message: FromPicture): Promise<void> {
    if (message.kind === "ready") {
      this.wanted = { view: message.view, theme: message.theme, width: message.width, height: message.height };
      this.follower.poke();
      return;
    }
    const range = this.result?.objects.find(({ index }) => index === message.index)?.range;
    if (range === null || range === undefined) return;
    const selection = new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character);
    const viewColumn = this.editor()?.viewColumn ?? vscode.ViewColumn.One;
    await vscode.window.showTextDocument(await vscode.workspace.openTextDocument(this.uri), { selection, viewColumn });
    this.send({ kind: "selected", index: message.index });
  }

  private editor(): vscode.TextEditor | undefined {
    return vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === this.uri.toString());
  }

  /** Shows which object the statement under the cursor placed. */
  private mark({ line }: vscode.Position): void {
    const here = this.result?.objects.find(({ range }) => range !== null && range.start.line <= line && line <= range.end.line);
    this.send({ kind: "selected", index: here?.index ?? null });
  }
}
