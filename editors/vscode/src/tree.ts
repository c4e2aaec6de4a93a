// The objects of the scene as a tree: lists of objects are branches.

import * as vscode from "vscode";
import { Follower } from "./follow";
import type { Current } from "./program";
import { LayoutRequest, VERSION, type LayoutResult } from "./protocol";
import type { Server } from "./server";

/** A list of objects, or an object by its place in the layout. */
type Node = List | { object: number };

interface List {
  list: string;
  objects: number[];
}

export class SceneTree implements vscode.TreeDataProvider<Node>, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<undefined>();
  private readonly parts: vscode.Disposable[];
  private readonly view: vscode.TreeView<Node>;
  private readonly follower: Follower;
  private uri: vscode.Uri | undefined;
  private result: LayoutResult | undefined;

  readonly onDidChangeTreeData = this.changed.event;

  constructor(
    private readonly server: Server,
    private readonly current: Current,
  ) {
    this.follower = new Follower(
      () => this.load(),
      () => {
        this.show(undefined);
      },
    );
    const poke = (): void => {
      if (this.view.visible) this.follower.poke();
    };
    this.view = vscode.window.createTreeView("psdl.scene", { treeDataProvider: this, showCollapseAll: true });
    this.parts = [
      this.view,
      this.changed,
      this.view.onDidChangeVisibility(poke),
      vscode.window.onDidChangeActiveTextEditor(poke),
      vscode.workspace.onDidChangeTextDocument(({ document }) => {
        if (document.uri.toString() === this.uri?.toString()) poke();
      }),
      server.onDidChange(poke),
    ];
    poke();
  }

  getChildren(node?: Node): Node[] {
    const objects = this.result?.layout?.objects ?? [];
    if (node !== undefined) return "list" in node ? node.objects.map(object => ({ object })) : [];
    const lists = new Map<string, List>();
    const nodes: Node[] = [];
    for (const [object, { path }] of objects.entries()) {
      const list = /^(.*)\[\d+\]$/.exec(path)?.[1];
      if (list === undefined) {
        nodes.push({ object });
        continue;
      }
      const known = lists.get(list);
      if (known !== undefined) {
        known.objects.push(object);
        continue;
      }
      const branch = { list, objects: [object] };
      lists.set(list, branch);
      nodes.push(branch);
    }
    return nodes;
  }

  getTreeItem(node: Node): vscode.TreeItem {
    if ("list" in node) {
      const item = new vscode.TreeItem(node.list, vscode.TreeItemCollapsibleState.Collapsed);
      item.id = `list ${node.list}`;
      item.description = `${node.objects.length} objects`;
      item.iconPath = this.icon(node.objects, "layers");
      return item;
    }
    const object = this.result?.layout?.objects[node.object];
    const item = new vscode.TreeItem(object?.path ?? "");
    if (object === undefined) return item;
    item.id = `object ${object.path}`;
    item.contextValue = "object";
    const metres = (value: number): string => value.toLocaleString("en", { maximumFractionDigits: 2 });
    item.description = `${object.name}, ${[object.width, object.depth, object.height].map(metres).join(" × ")} m`;
    const findings = this.findings(node.object);
    item.tooltip = [`${object.path} at ${object.center.map(metres).join(", ")}, faces ${object.facing}`, ...findings].join("\n");
    item.iconPath = this.icon([node.object], object.type === "OBJECT" ? "symbol-field" : object.type === "DOOR" ? "sign-in" : "window");
    const place = this.result?.ranges[node.object];
    const range = place?.placements.at(-1) ?? place?.declaration;
    if (this.uri !== undefined && range !== null && range !== undefined) {
      const selection = new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character);
      item.command = { title: "Show", command: "vscode.open", arguments: [this.uri, { selection } satisfies vscode.TextDocumentShowOptions] };
    }
    return item;
  }

  dispose(): void {
    this.follower.end();
    for (const part of this.parts) part.dispose();
  }

  private findings(object: number): string[] {
    return (this.result?.findings ?? []).filter(({ objects }) => objects.includes(object)).map(({ code, message }) => `${code}: ${message}`);
  }

  private icon(objects: number[], otherwise: string): vscode.ThemeIcon {
    const wrong = objects.some(object => this.findings(object).length > 0);
    return wrong ? new vscode.ThemeIcon("error", new vscode.ThemeColor("problemsErrorIcon.foreground")) : new vscode.ThemeIcon(otherwise);
  }

  private async load(): Promise<void> {
    this.uri = this.current.document?.uri ?? this.uri;
    if (this.uri === undefined) return;
    if (this.server.running !== undefined && this.server.protocol !== VERSION) {
      this.view.message = "This version of psdl does not tell editors about the scene; update it.";
      return;
    }
    this.show(await this.server.ask(LayoutRequest, { textDocument: { uri: this.uri.toString() } }));
  }

  private show(result: LayoutResult | undefined): void {
    this.result = result;
    const scene = result?.layout?.scene;
    this.view.description = scene?.title ?? "";
    this.view.message = result?.stale === true ? "Of the last text that could be run." : "";
    this.changed.fire(undefined);
  }
}
