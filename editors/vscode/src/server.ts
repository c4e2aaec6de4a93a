// The life of the language server, and requests to it.

import * as vscode from "vscode";
// Only types: the client is much code, and is loaded after the extension has become active.
import type {
  LanguageClient,
  LanguageClientOptions,
  WorkDoneProgressBegin,
  WorkDoneProgressEnd,
  WorkDoneProgressReport,
} from "vscode-languageclient/node";
import { findServer, goesWith, type Found } from "./find";
import { overtaken, VERSION, type About, type Request } from "./protocol";

type Library = typeof import("vscode-languageclient/node");

export type Work = WorkDoneProgressBegin | WorkDoneProgressReport | WorkDoneProgressEnd;

/** How the server is. */
export type Health =
  | { kind: "starting" }
  | { kind: "running"; version: string; found: Found; matches: boolean }
  | { kind: "stopped"; why: string };

const INSTALL = "https://github.com/psdl-lang/psdl#readme";
/** So often a question that was overtaken is asked again, and so many milliseconds later. */
const [TRIES, PAUSE] = [5, 50];
/** After so many deaths in three minutes it is not started again. */
const DEATHS = 4;

export class Server implements vscode.Disposable {
  private client: LanguageClient | undefined;
  private found: Found | undefined;
  private deaths: number[] = [];
  /** Starts and stops wait for each other. */
  private turn: Promise<void> = Promise.resolve();
  private readonly changed = new vscode.EventEmitter<Health>();
  private readonly worked = new vscode.EventEmitter<{ token: string | number; work: Work }>();
  private readonly output = vscode.window.createOutputChannel("PSDL", { log: true });
  private readonly trace = vscode.window.createOutputChannel("PSDL Trace", { log: true });

  readonly onDidChange = this.changed.event;
  readonly onDidWork = this.worked.event;
  health: Health = { kind: "starting" };

  constructor(private readonly extension: vscode.ExtensionContext) {}

  /** The running client. */
  get running(): LanguageClient | undefined {
    return this.client?.isRunning() === true ? this.client : undefined;
  }

  start(): Promise<void> {
    return this.next(() => this.begin());
  }

  restart(): Promise<void> {
    this.deaths = [];
    return this.next(async () => {
      await this.end();
      await this.begin();
    });
  }

  stop(): Promise<void> {
    return this.next(() => this.end());
  }

  showLog(): void {
    this.output.show();
  }

  showTrace(): void {
    this.trace.show();
  }

  /** Asks, if there is a server that speaks our version of these requests; undefined else. */
  async ask<P extends About, R>(request: Request<P, R>, params: P, token?: vscode.CancellationToken): Promise<R | undefined> {
    const client = this.running;
    if (client === undefined || this.protocol !== VERSION) return undefined;
    const version = versionOf(params);
    for (let left = TRIES; ; left--) {
      try {
        // Without a token its place must stay empty: undefined would be taken for a second parameter.
        return await (token === undefined ? client.sendRequest<R>(request.method, params) : client.sendRequest<R>(request.method, params, token));
      } catch (error) {
        if (this.running !== client) return undefined; // it ended over this question; who follows a text asks the next one
        // Where not this text has changed, but its template or the configuration, the same question is asked again.
        if (left === 0 || !overtaken(error) || token?.isCancellationRequested === true || versionOf(params) !== version) throw error;
        await new Promise(resolve => setTimeout(resolve, PAUSE));
      }
    }
  }

  /** The version of `psdl/…` that the server speaks. */
  get protocol(): number | undefined {
    const experimental = this.running?.initializeResult?.capabilities.experimental as { psdl?: { version?: number } } | undefined;
    return experimental?.psdl?.version;
  }

  dispose(): void {
    void this.stop().finally(() => {
      for (const part of [this.changed, this.worked, this.output, this.trace]) part.dispose();
    });
  }

  private next(action: () => Promise<void>): Promise<void> {
    this.turn = this.turn.then(action, action);
    return this.turn;
  }

  private set(health: Health): void {
    this.health = health;
    this.changed.fire(health);
  }

  private async begin(): Promise<void> {
    this.set({ kind: "starting" });
    const search = await findServer(this.extension);
    if ("missing" in search) {
      this.set({ kind: "stopped", why: search.missing });
      void this.explain(search.missing);
      return;
    }
    this.found = search.found;
    this.output.info(`starting ${search.found.path} (from ${search.found.by})`);
    const level = vscode.workspace.getConfiguration("psdl").get("server.logLevel", "warn");
    const run = { command: search.found.path, args: ["lsp", "--log-level", level] };
    const library = await import("vscode-languageclient/node");
    this.client = new library.LanguageClient("psdl", "PSDL", { run, debug: run }, this.options(library));
    this.client.onDidChangeState(({ newState }) => {
      if (newState === library.State.Running) this.runs();
    });
    try {
      await this.client.start();
    } catch (error) {
      const why = `${search.found.path} does not answer as a server for PSDL: ${error instanceof Error ? error.message : String(error)}`;
      this.set({ kind: "stopped", why });
      void this.explain(why);
    }
  }

  private async end(): Promise<void> {
    const client = this.client;
    this.client = undefined;
    try {
      await client?.dispose();
    } catch (error) {
      this.output.warn(`the server did not end in order: ${String(error)}`);
    }
    this.set({ kind: "stopped", why: "It was stopped." });
  }

  private options({ CloseAction, ErrorAction }: Library): LanguageClientOptions {
    return {
      documentSelector: [{ language: "psdl" }, { scheme: "file", pattern: "**/*.template.json" }, { scheme: "file", pattern: "**/psdl.toml" }],
      initializationOptions: vscode.workspace.getConfiguration("psdl"),
      outputChannel: this.output,
      traceOutputChannel: this.trace,
      diagnosticPullOptions: { onChange: true, onSave: true, onTabs: true },
      markdown: { isTrusted: false, supportHtml: false },
      initializationFailedHandler: () => false,
      errorHandler: {
        error: () => ({ action: ErrorAction.Continue }),
        closed: () => (this.died() ? { action: CloseAction.Restart, handled: true } : { action: CloseAction.DoNotRestart, handled: true }),
      },
      middleware: {
        handleWorkDoneProgress: (token, work, next) => {
          this.worked.fire({ token, work });
          next(token, work);
        },
      },
    };
  }

  private runs(): void {
    if (this.found === undefined) return;
    const version = this.client?.initializeResult?.serverInfo?.version ?? "of an unknown version";
    const mine = (this.extension.extension.packageJSON as { version: string }).version;
    const matches = goesWith(version, mine) && this.protocol === VERSION;
    this.set({ kind: "running", version, found: this.found, matches });
    if (!matches) {
      const older = goesWith(version, mine) || version.localeCompare(mine, undefined, { numeric: true }) < 0;
      const text = `psdl ${version} (${this.found.path}) does not go with this extension (${mine}): some commands will not work. Update ${older ? "the program" : "the extension"}.`;
      void this.explain(text, "warning");
    }
  }

  /** Notes that the server ended unasked; whether it is worth another start. */
  private died(): boolean {
    const now = Date.now();
    this.deaths = [...this.deaths.filter(then => now - then < 180_000), now];
    if (this.deaths.length < DEATHS) return true;
    const why = `The server ended ${DEATHS} times within three minutes and is not started again.`;
    this.set({ kind: "stopped", why });
    void this.explain(why);
    return false;
  }

  /** Says what is wrong, and offers what helps. */
  private async explain(text: string, how: "error" | "warning" = "error"): Promise<void> {
    const [log, choose, install] = ["Show Log", "Choose the Program…", "How to Install It"] as const;
    const show = how === "error" ? vscode.window.showErrorMessage : vscode.window.showWarningMessage;
    switch (await show<string>(text, choose, install, log)) {
      case log:
        this.showLog();
        break;
      case install:
        await vscode.env.openExternal(vscode.Uri.parse(INSTALL));
        break;
      case choose: {
        const picked = await vscode.window.showOpenDialog({ title: "The program psdl", canSelectMany: false });
        const file = picked?.[0];
        if (file !== undefined) {
          await vscode.workspace.getConfiguration("psdl").update("server.path", file.fsPath, vscode.ConfigurationTarget.Global);
        }
        break;
      }
    }
  }
}

/** The version of the text that a request is about, if it is open. */
function versionOf({ textDocument }: About): number | undefined {
  return vscode.workspace.textDocuments.find(({ uri }) => uri.toString() === textDocument.uri)?.version;
}

/** Whether a server runs that knows our requests; says what to do, else. */
export function able({ health, protocol }: Server): boolean {
  if (protocol === VERSION) return true;
  const text = health.kind === "running" ? `psdl ${health.version} cannot do this; update it.` : "The server of psdl is not running.";
  void vscode.window.showErrorMessage(text);
  return false;
}
