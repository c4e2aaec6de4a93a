// The task `psdl check`.

import * as vscode from "vscode";
import type { Server } from "./server";
import { findServer } from "./find";

interface Definition extends vscode.TaskDefinition {
  /** What to check; the folder, if unset. */
  path?: string;
  args?: string[];
}

export class Tasks implements vscode.TaskProvider {
  constructor(
    private readonly extension: vscode.ExtensionContext,
    private readonly server: Server,
  ) {}

  async provideTasks(): Promise<vscode.Task[]> {
    const command = await this.command();
    if (command === undefined) return [];
    return (vscode.workspace.workspaceFolders ?? []).map(folder => task({ type: "psdl" }, folder, command));
  }

  async resolveTask(asked: vscode.Task): Promise<vscode.Task | undefined> {
    const command = await this.command();
    return command === undefined ? undefined : task(asked.definition, asked.scope ?? vscode.TaskScope.Workspace, command);
  }

  private async command(): Promise<string | undefined> {
    const { health } = this.server;
    if (health.kind === "running") return health.found.path;
    const search = await findServer(this.extension);
    return "found" in search ? search.found.path : undefined;
  }
}

function task(definition: Definition, scope: vscode.WorkspaceFolder | vscode.TaskScope, command: string): vscode.Task {
  const args = ["check", "--color", "never", ...(definition.args ?? []), definition.path ?? "."];
  const made = new vscode.Task(definition, scope, "check", "psdl", new vscode.ProcessExecution(command, args), "$psdl");
  made.group = vscode.TaskGroup.Test;
  made.detail = `psdl check ${definition.path ?? "."}`;
  return made;
}
