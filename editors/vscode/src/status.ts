// The item of the status bar: how many errors, or what is being worked on.

import * as vscode from "vscode";
import type { Server, Work } from "./server";

export class Status implements vscode.Disposable {
  private readonly item = vscode.window.createStatusBarItem("psdl.status", vscode.StatusBarAlignment.Right, 100);
  private readonly parts: vscode.Disposable[];
  private readonly changed = new vscode.EventEmitter<string>();
  /** Work that has begun and not ended. */
  private readonly work = new Map<string | number, { title: string; message: string; percentage: number | undefined }>();

  readonly onDidChange = this.changed.event;

  constructor(private readonly server: Server) {
    this.item.name = "PSDL";
    this.item.command = "psdl.menu";
    const draw = (): void => {
      this.draw();
    };
    this.parts = [
      this.item,
      this.changed,
      server.onDidChange(() => {
        this.work.clear();
        draw();
      }),
      server.onDidWork(({ token, work }) => {
        this.note(token, work);
      }),
      vscode.window.onDidChangeActiveTextEditor(draw),
      vscode.languages.onDidChangeDiagnostics(draw),
    ];
    draw();
  }

  /** What stands there now. */
  get text(): string {
    return this.item.text;
  }

  note(token: string | number, work: Work): void {
    if (work.kind === "end") {
      this.work.delete(token);
    } else {
      const before = this.work.get(token);
      this.work.set(token, {
        title: work.kind === "begin" ? work.title : (before?.title ?? ""),
        message: work.message ?? before?.message ?? "",
        percentage: work.percentage ?? before?.percentage,
      });
    }
    this.draw();
  }

  dispose(): void {
    for (const part of this.parts) part.dispose();
  }

  private draw(): void {
    const document = vscode.window.activeTextEditor?.document;
    if (document?.languageId !== "psdl") {
      this.item.hide();
      return;
    }
    const health = this.server.health;
    this.item.backgroundColor = undefined;
    if (health.kind === "stopped") {
      this.item.text = "$(warning) psdl";
      this.item.tooltip = health.why;
      this.item.backgroundColor = new vscode.ThemeColor("statusBarItem.warningBackground");
    } else if (health.kind === "starting") {
      this.item.text = "$(loading~spin) psdl";
      this.item.tooltip = "The server is being started.";
    } else {
      this.item.text = this.busy() ?? tally(document.uri);
      this.item.tooltip = `psdl ${health.version}, ${health.found.path}${health.matches ? "" : "\nIts version differs from that of this extension."}`;
    }
    this.item.show();
    this.changed.fire(this.item.text);
  }

  private busy(): string | undefined {
    const [work] = this.work.values();
    if (work === undefined) return undefined;
    const percentage = work.percentage === undefined ? "" : `${Math.round(work.percentage)} %`;
    return ["$(loading~spin) psdl:", work.title, work.message, percentage].filter(word => word !== "").join(" ");
  }
}

function tally(uri: vscode.Uri): string {
  const found = vscode.languages.getDiagnostics(uri).map(finding => finding.severity);
  const errors = found.filter(severity => severity === vscode.DiagnosticSeverity.Error).length;
  const warnings = found.filter(severity => severity === vscode.DiagnosticSeverity.Warning).length;
  if (errors + warnings === 0) return "$(check) psdl";
  return [errors > 0 ? `$(error) ${errors}` : "", warnings > 0 ? `$(warning) ${warnings}` : "", "psdl"].filter(word => word !== "").join(" ");
}
