// The page with the picture. It keeps its last picture, so that a reload shows it at once.

import type { FromPicture, PictureState, ToPicture } from "../messages";
import type { View } from "../protocol";

const VIEWS: readonly View[] = ["top", "perspective", "both"];

const vscode = acquireVsCodeApi<PictureState>();
let state: PictureState = vscode.getState() ?? { uri: "", view: "both", title: "", svg: "" };
let selected: number | null = null;

function element<K extends keyof HTMLElementTagNameMap>(name: K, id: string, parent: Element): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  made.id = id;
  parent.append(made);
  return made;
}

const bar = element("div", "bar", document.body);
const note = element("div", "note", document.body);
const picture = element("div", "picture", document.body);

function say(message: FromPicture): void {
  vscode.postMessage(message);
}

function ask(): void {
  const dark = document.body.classList.contains("vscode-dark") || (document.body.classList.contains("vscode-high-contrast") && !document.body.classList.contains("vscode-high-contrast-light"));
  const width = Math.max(320, Math.min(2400, Math.round(picture.clientWidth)));
  // Two views stand side by side where there is room, else the picture is scaled to the width.
  const height = Math.max(240, Math.min(1600, Math.round(Math.min(picture.clientHeight, state.view === "both" ? width / 2 : width))));
  say({ kind: "ready", view: state.view, theme: dark ? "dark" : "light", width, height });
}

for (const view of VIEWS) {
  const button = element("button", `view-${view}`, bar);
  button.textContent = view === "top" ? "Top" : view === "perspective" ? "Perspective" : "Both";
  button.addEventListener("click", () => {
    keep({ ...state, view });
    pressed();
    ask();
  });
}

function pressed(): void {
  for (const view of VIEWS) document.getElementById(`view-${view}`)?.setAttribute("aria-pressed", String(view === state.view));
}

function keep(next: PictureState): void {
  state = next;
  vscode.setState(state);
}

/** Puts a picture on the page as a tree; a picture has neither scripts nor links, and none would be let in. */
function show(svg: string): void {
  const parsed = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  if (parsed.localName !== "svg" || parsed.querySelector("parsererror, script, foreignObject") !== null) return;
  parsed.removeAttribute("width");
  parsed.removeAttribute("height");
  picture.replaceChildren(document.importNode(parsed, true));
  mark();
}

function mark(): void {
  for (const group of picture.querySelectorAll<SVGGElement>("g.object")) {
    group.classList.toggle("selected", selected !== null && group.dataset.object === String(selected));
  }
}

picture.addEventListener("click", event => {
  const group = event.target instanceof Element ? event.target.closest<SVGGElement>("g.object") : null;
  const index = Number(group?.dataset.object ?? NaN);
  if (Number.isInteger(index)) say({ kind: "select", index });
});

window.addEventListener("message", (event: MessageEvent<ToPicture>) => {
  const message = event.data;
  if (message.kind === "note") {
    note.textContent = message.text;
  } else if (message.kind === "selected") {
    selected = message.index;
    mark();
  } else {
    note.textContent = message.stale ? "Of the last text that could be run." : "";
    picture.classList.toggle("stale", message.stale);
    keep({ ...state, uri: message.uri, title: message.title, svg: message.svg });
    show(message.svg);
  }
});

let asked: number | undefined;
new ResizeObserver(() => {
  window.clearTimeout(asked);
  asked = window.setTimeout(ask, 100);
}).observe(picture);
new MutationObserver(ask).observe(document.body, { attributeFilter: ["class"] });

pressed();
if (state.svg !== "") show(state.svg);
ask();
