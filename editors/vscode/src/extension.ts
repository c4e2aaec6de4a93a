// The extension: what is started when a scene program is opened. In a folder that is not trusted, nothing is.

import * as vscode from "vscode";
import { commands } from "./commands";
import { Pictures } from "./picture";
import { Current } from "./program";
import { Server, type Health } from "./server";
import { Sliders } from "./sliders";
import { Status } from "./status";
import { Tasks } from "./tasks";
import { SceneTree } from "./tree";

/** What other extensions, and our tests, may ask. */
export interface Api {
  /** How the server is; undefined while the folder is not trusted. */
  health(): Health | undefined;
  /** What the status bar says. */
  status(): string | undefined;
  /** Fires with what the status bar says; undefined while the folder is not trusted. */
  onStatus: vscode.Event<string> | undefined;
}

export function activate(extension: vscode.ExtensionContext): Api {
  let parts: { server: Server; status: Status } | undefined;
  const begin = (): void => {
    parts ??= start(extension);
  };
  if (vscode.workspace.isTrusted) begin();
  else extension.subscriptions.push(vscode.workspace.onDidGrantWorkspaceTrust(begin));
  return {
    health: () => parts?.server.health,
    status: () => parts?.status.text,
    get onStatus() {
      return parts?.status.onDidChange;
    },
  };
}

function start(extension: vscode.ExtensionContext): { server: Server; status: Status } {
  const server = new Server(extension);
  const status = new Status(server);
  const current = new Current();
  extension.subscriptions.push(
    server,
    status,
    current,
    ...commands(extension, server, status, current),
    new Pictures(extension.extensionUri, server, current),
    new SceneTree(server, current),
    new Sliders(extension.extensionUri, server, current),
    vscode.tasks.registerTaskProvider("psdl", new Tasks(extension, server)),
    vscode.workspace.onDidChangeConfiguration(event => {
      if (event.affectsConfiguration("psdl.server")) void server.restart();
    }),
  );
  // Not waited for: the extension is active at once, and the server when it is.
  void server.start();
  return { server, status };
}
