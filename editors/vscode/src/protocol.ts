// What the server offers beside the language server protocol: `psdl/…`, version 1.

import type { Range, TextDocumentIdentifier, WorkspaceEdit } from "vscode-languageclient/node";

/** The version of these requests that this extension speaks. */
export const VERSION = 1;

/** What all requests say. */
export interface About {
  textDocument: TextDocumentIdentifier;
}

interface Answer {
  /** The version of the document that the answer is for; null if it is not open. */
  version: number | null;
}

export interface Tally {
  errors: number;
  loss: number;
}

export interface FixParams extends About {
  range?: Range;
  kinds?: string[];
  method?: "guided" | "paper";
  maxEdits?: number;
  workDoneToken?: string | number;
}

export interface FixResult extends Answer {
  edit: WorkspaceEdit;
  edits: { range: Range; newText: string; title: string }[];
  before: Tally;
  after: Tally;
  moved: number;
}

export interface Constant {
  range: Range;
  /** As it stands in the program. */
  text: string;
  value: number;
  /** The variable that it is assigned to. */
  name: string | null;
  /** Intervals without errors; a null end is open. */
  good: [number | null, number | null][];
  /** Metres that objects move for each unit more. */
  moves: { path: string; by: number }[];
  /** Errors now among the objects that it moves. */
  errors: number;
}

export interface ConstantsResult extends Answer {
  constants: Constant[];
}

export type Facing = "X+" | "Y+" | "X-" | "Y-";

export interface LayoutObject {
  path: string;
  name: string;
  type: "OBJECT" | "DOOR" | "WINDOW";
  width: number;
  depth: number;
  height: number;
  center: [number, number, number];
  facing: Facing;
}

export interface LayoutResult extends Answer {
  stale: boolean;
  partial: boolean;
  layout: { scene: { title: string; width: number; depth: number; height: number }; objects: LayoutObject[] } | null;
  ranges: { path: string; declaration: Range | null; placements: Range[] }[];
  findings: { code: string; message: string; range: Range; objects: number[] }[];
}

/** Metres in the world; null: as it is. */
export type Target = [number | null, number | null, number | null];

/** An edit that brings an object to a place or a facing. */
export interface Choice {
  title: string;
  edit: WorkspaceEdit;
  reached: [number, number, number] | Facing;
  /** Whether it is what was asked for, or only nearer. */
  exact: boolean;
  /** Errors of the layout then. */
  errors: number;
}

/** Best first. */
export interface PlaceResult extends Answer {
  choices: Choice[];
}

export type View = "top" | "perspective" | "both";

export interface RenderParams extends About {
  format: "svg" | "png";
  view?: View;
  width?: number;
  height?: number;
  theme?: "light" | "dark";
  labels?: "none" | "some" | "all";
  errors?: boolean;
}

export interface RenderResult extends Answer {
  stale: boolean;
  mime: string;
  /** SVG, or a PNG in base64. */
  data: string;
  objects: { path: string; index: number; range: Range | null }[];
}

/** A request: what goes in, and what comes back. */
export interface Request<P, R> {
  method: string;
  /** Never there: they bind the types to the method. */
  params?: P;
  result?: R;
}

export const FixRequest: Request<FixParams, FixResult> = { method: "psdl/fix" };
export const ConstantsRequest: Request<About, ConstantsResult> = { method: "psdl/constants" };
export const LayoutRequest: Request<About, LayoutResult> = { method: "psdl/layout" };
export const MoveRequest: Request<About & { object: string; to: Target }, PlaceResult> = { method: "psdl/move" };
export const TurnRequest: Request<About & { object: string; facing: Facing }, PlaceResult> = { method: "psdl/turn" };
export const RenderRequest: Request<RenderParams, RenderResult> = { method: "psdl/render" };

/** RequestCancelled, ContentModified, ServerCancelled: nothing is wrong, another question gets the answer. */
const OVERTAKEN: readonly unknown[] = [-32800, -32801, -32802];

/** Whether a request failed only because an edit, or a newer request, came before its answer. */
export function overtaken(error: unknown): boolean {
  return error instanceof Error && "code" in error && OVERTAKEN.includes(error.code);
}
