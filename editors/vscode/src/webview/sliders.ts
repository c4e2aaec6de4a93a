// The page with the sliders. The green part of a track is where the constant makes no errors.

import type { FromSliders, Slider, ToSliders } from "../messages";
import { literal, nearestGood } from "../number";

const vscode = acquireVsCodeApi();
const note = document.createElement("p");
const list = document.createElement("div");
list.id = "list";
document.body.append(note, list);

interface Row {
  root: HTMLElement;
  name: HTMLButtonElement;
  value: HTMLInputElement;
  range: HTMLInputElement;
  mend: HTMLButtonElement;
  moves: HTMLElement;
  /** What it shows; unset until it was filled. */
  slider: Slider | undefined;
}

const rows: Row[] = [];
let generation = 0;
let dragged: Row | undefined;

function say(message: FromSliders): void {
  vscode.postMessage(message);
}

/** Numbers around a value that a slider offers: half a metre each way at least, twice the value for larger ones. */
function span(value: number): [number, number] {
  const reach = Math.max(0.5, Math.abs(value) * 2);
  return [value - reach, value + reach];
}

/** What the knob of a slider stands for: a round number, at least a hundred of them from end to end. */
function round({ range }: Row): number {
  const step = 10 ** Math.floor(Math.log10((Number(range.max) - Number(range.min)) / 100));
  return Math.round(range.valueAsNumber / step) * step;
}

function set(row: Row, value: number, phase: "first" | "next" | "last"): void {
  row.value.value = literal(value);
  if (row.slider !== undefined) say({ kind: "set", index: row.slider.index, generation, value, phase });
}

function build(): Row {
  const make = <K extends keyof HTMLElementTagNameMap>(tag: K, name: string): HTMLElementTagNameMap[K] => {
    const made = document.createElement(tag);
    made.className = name;
    return made;
  };
  const row = {
    root: make("div", "row"),
    name: make("button", "name"),
    value: make("input", "value"),
    range: make("input", "range"),
    mend: make("button", "mend"),
    moves: make("div", "moves"),
    slider: undefined,
  } satisfies Row as Row;
  row.range.type = "range";
  row.value.type = "text";
  row.value.inputMode = "decimal";
  row.mend.textContent = "fix";
  row.root.append(row.name, row.value, row.mend, row.range, row.moves);
  row.name.addEventListener("click", () => {
    if (row.slider !== undefined) say({ kind: "show", index: row.slider.index, generation });
  });
  row.range.addEventListener("input", () => {
    const phase = dragged === row ? "next" : "first";
    dragged = row;
    set(row, round(row), phase);
  });
  row.range.addEventListener("change", () => {
    dragged = undefined;
    set(row, round(row), "last");
  });
  row.value.addEventListener("change", () => {
    const value = Number(row.value.value);
    if (row.value.value.trim() === "" || !Number.isFinite(value)) row.value.value = row.slider?.text ?? "";
    else once(row, value);
  });
  row.mend.addEventListener("click", () => {
    const value = row.slider && nearestGood(row.slider.value, row.slider.good);
    if (value !== undefined) once(row, value);
  });
  return row;
}

/** A change that is no drag: its own undo. */
function once(row: Row, value: number): void {
  set(row, value, "first");
  set(row, value, "last");
}

/** Paints where the value makes no errors. */
function track(slider: Slider, [low, high]: [number, number]): string {
  const place = (value: number | null, open: number): string => `${((Math.min(high, Math.max(low, value ?? open)) - low) / (high - low)) * 100}%`;
  const stops = slider.good.flatMap(([from, to]) => {
    const [start, end] = [`calc(${place(from, low)} - 1px)`, `calc(${place(to, high)} + 1px)`];
    return [`transparent ${start}`, `var(--good) ${start}`, `var(--good) ${end}`, `transparent ${end}`];
  });
  return stops.length === 0 ? "none" : `linear-gradient(to right, ${stops.join(", ")})`;
}

function fill(row: Row, slider: Slider): void {
  const before = row.slider;
  row.slider = slider;
  row.root.dataset.index = String(slider.index);
  row.root.classList.toggle("wrong", slider.errors > 0);
  row.name.textContent = slider.label;
  row.name.title = `Line ${slider.line}`;
  row.range.setAttribute("aria-label", `${slider.label}, line ${slider.line}`);
  row.value.setAttribute("aria-label", `Value of ${slider.label}, line ${slider.line}`);
  row.value.value = slider.text;
  const errors = slider.errors === 0 ? "" : ` · ${slider.errors} error${slider.errors === 1 ? "" : "s"}`;
  row.moves.textContent = `line ${slider.line}${slider.moves.length === 0 ? "" : ` · moves ${slider.moves.slice(0, 3).join(", ")}${slider.moves.length > 3 ? "…" : ""}`}${errors}`;
  row.mend.hidden = nearestGood(slider.value, slider.good) === undefined;
  // The ends stay while the value is between them, so that the knob does not run away under the hand.
  let [low, high] = [Number(row.range.min), Number(row.range.max)];
  if (before?.label !== slider.label || slider.value <= low || slider.value >= high) [low, high] = span(slider.value);
  row.range.min = String(low);
  row.range.max = String(high);
  row.range.step = "any";
  row.range.value = String(slider.value);
  row.range.style.setProperty("--track", track(slider, [low, high]));
}

window.addEventListener("message", (event: MessageEvent<ToSliders>) => {
  const message = event.data;
  if (message.kind === "note") {
    // The sliders stay: one of them may have made the text what cannot be run, and can take it back.
    note.textContent = message.text;
    list.classList.add("old");
    return;
  }
  if (dragged !== undefined) return;
  generation = message.generation;
  list.classList.remove("old");
  note.textContent = message.constants.length === 0 ? `No constant of ${message.title} can be tuned.` : "";
  while (rows.length < message.constants.length) rows.push(build());
  rows.length = message.constants.length;
  for (const [index, slider] of message.constants.entries()) {
    const row = rows[index];
    if (row !== undefined) fill(row, slider);
  }
  if (list.childElementCount !== rows.length) list.replaceChildren(...rows.map(row => row.root));
});

say({ kind: "ready" });
