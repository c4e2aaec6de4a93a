// Where the program `psdl` is.

import * as fs from "node:fs";
import * as os from "node:os";
import * as path from "node:path";
import * as vscode from "vscode";

export interface Found {
  path: string;
  /** Who said so. */
  by: "setting" | "bundled" | "PATH";
}

/** The server, or what to tell the user. */
export type Search = { found: Found } | { missing: string };

const NAME = process.platform === "win32" ? "psdl.exe" : "psdl";

async function executable(file: string): Promise<boolean> {
  try {
    await fs.promises.access(file, fs.constants.X_OK);
    return (await fs.promises.stat(file)).isFile();
  } catch {
    return false;
  }
}

/** `~` and the first folder of the workspace may stand in the setting. */
function expanded(setting: string): string {
  const folder = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath ?? "";
  return setting.replace(/^~(?=[/\\]|$)/, os.homedir()).replaceAll("${workspaceFolder}", folder);
}

/** Looks in the setting, in the extension, and in PATH, in this order. */
export async function findServer(extension: vscode.ExtensionContext): Promise<Search> {
  const setting = vscode.workspace.getConfiguration("psdl").get("server.path", "").trim();
  if (setting !== "") {
    const file = expanded(setting);
    // What was asked for counts: another one in its place would be a surprise.
    return (await executable(file))
      ? { found: { path: file, by: "setting" } }
      : { missing: `psdl.server.path is “${setting}”, but there is no program at ${file}.` };
  }
  const bundled = path.join(extension.extensionPath, "server", NAME);
  if (await executable(bundled)) return { found: { path: bundled, by: "bundled" } };
  for (const folder of (process.env.PATH ?? "").split(path.delimiter)) {
    const file = path.join(folder, NAME);
    if (folder !== "" && (await executable(file))) return { found: { path: file, by: "PATH" } };
  }
  return { missing: "The program psdl was not found: this package brings none for your platform, and there is none in PATH." };
}

/** Whether a server goes with this extension: the first two numbers of their versions agree. */
export function goesWith(server: string, extension: string): boolean {
  const head = (version: string): string => version.split(".").slice(0, 2).join(".");
  return head(server) === head(extension);
}
