// Moving and turning an object: which one, where to, and by which edit of the program.

import * as vscode from "vscode";
import type { Current } from "./program";
import {
  LayoutRequest,
  MoveRequest,
  overtaken,
  TurnRequest,
  type Choice,
  type Facing,
  type LayoutObject,
  type LayoutResult,
  type PlaceResult,
  type Target,
} from "./protocol";
import { able, type Server } from "./server";
import { target } from "./target";

/** What a caller may say beforehand; the user is asked for the rest. Who says where to gets the best edit. */
export interface Wish {
  /** Its place in the layout, or its path. */
  object?: number | string;
  /** As the user writes it. */
  to?: string;
  facing?: Facing;
}

const FACINGS: readonly { facing: Facing; label: string }[] = [
  { facing: "X+", label: "$(arrow-right) X+" },
  { facing: "Y+", label: "$(arrow-up) Y+" },
  { facing: "X-", label: "$(arrow-left) X-" },
  { facing: "Y-", label: "$(arrow-down) Y-" },
];

const metres = (value: number): string => value.toLocaleString("en", { maximumFractionDigits: 2, useGrouping: false });

export class Places {
  constructor(
    private readonly server: Server,
    private readonly current: Current,
  ) {}

  /** Moves an object to a place, or by a distance. */
  move(wish: Wish): Promise<Choice | undefined> {
    return this.edit(wish, async (object, textDocument) => {
      const to = await where(object, wish.to);
      return to && this.server.ask(MoveRequest, { textDocument, object: object.path, to });
    });
  }

  /** Turns an object. */
  turn(wish: Wish): Promise<Choice | undefined> {
    return this.edit(wish, async (object, textDocument) => {
      const items = FACINGS.map(({ facing, label }) => ({ label, description: facing === object.facing ? "now" : "", facing }));
      const facing = wish.facing ?? (await vscode.window.showQuickPick(items, { title: `Turn ${object.path} to` }))?.facing;
      return facing && this.server.ask(TurnRequest, { textDocument, object: object.path, facing });
    });
  }

  private async edit(
    wish: Wish,
    ask: (object: LayoutObject, textDocument: { uri: string }) => Promise<PlaceResult | undefined>,
  ): Promise<Choice | undefined> {
    const editor = await this.current.editor();
    if (editor === undefined || !able(this.server)) return undefined;
    const { document } = editor;
    const textDocument = { uri: document.uri.toString() };
    try {
      const layout = await this.server.ask(LayoutRequest, { textDocument });
      const object = layout && (await which(layout, editor.selection.active.line, wish.object));
      const result = object && (await ask(object, textDocument));
      if (result === undefined) return undefined;
      const choice = await how(result.choices, wish.to === undefined && wish.facing === undefined);
      return choice && (await this.apply(choice, result.version, document)) ? choice : undefined;
    } catch (error) {
      if (overtaken(error)) changed();
      else void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
      return undefined;
    }
  }

  private async apply(choice: Choice, version: number | null, document: vscode.TextDocument): Promise<boolean> {
    const client = this.server.running;
    if (client === undefined || (version !== null && version !== document.version)) {
      changed();
      return false;
    }
    const done = await vscode.workspace.applyEdit(await client.protocol2CodeConverter.asWorkspaceEdit(choice.edit));
    if (done) vscode.window.setStatusBarMessage(`$(check) ${choice.title}`, 8000);
    return done;
  }
}

function changed(): void {
  void vscode.window.showWarningMessage("The text has changed meanwhile; nothing was done.");
}

/** The object that is meant: the wish, else what the line declares or places, else any; the user chooses among several. */
async function which(layout: LayoutResult, line: number, wish: number | string | undefined): Promise<LayoutObject | undefined> {
  const objects = layout.layout?.objects ?? [];
  if (wish !== undefined) return objects.find(({ path }, index) => path === wish || index === wish);
  const here = objects.filter((_, index) => {
    const place = layout.ranges[index];
    return [place?.declaration, ...(place?.placements ?? [])].some(range => range && range.start.line <= line && line <= range.end.line);
  });
  const asked = here.length > 0 ? here : objects;
  if (asked.length < 2) return asked[0];
  const items = asked.map(object => ({ label: object.path, description: object.name, object }));
  return (await vscode.window.showQuickPick(items, { title: "Which object?" }))?.object;
}

/** Where an object shall go: what was wished, else what the user writes. */
async function where(object: LayoutObject, wish: string | undefined): Promise<Target | undefined> {
  const text =
    wish ??
    (await vscode.window.showInputBox({
      title: `Move ${object.path}`,
      prompt: `Where its center shall be (x=1.2 z=0.5, or 1.2 0 0.5), or how far it shall go (x+0.3 y-0.1). It is at ${object.center.map(metres).join(", ")}.`,
      validateInput: written => (written === "" || target(written, object.center) ? undefined : "As in x=1.2 z=0.5, in 1.2 0 0.5, or in x+0.3 y-0.1"),
    }));
  return text === undefined ? undefined : target(text, object.center);
}

async function how(choices: readonly Choice[], ask: boolean): Promise<Choice | undefined> {
  if (choices.length === 0) void vscode.window.showInformationMessage("No edit of the program does this.");
  if (choices.length < 2 || !ask) return choices[0];
  const items = choices.map(choice => ({
    label: choice.title,
    description: `${choice.exact ? "" : "not quite there, "}${choice.errors} error${choice.errors === 1 ? "" : "s"}`,
    choice,
  }));
  return (await vscode.window.showQuickPick(items, { title: "How?" }))?.choice;
}
