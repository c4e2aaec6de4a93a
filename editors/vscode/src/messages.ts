// What the extension and its web pages say to each other.

import type { View } from "./protocol";

/** From the extension to the picture. */
export type ToPicture =
  | { kind: "picture"; uri: string; title: string; svg: string; stale: boolean; paths: Record<number, string> }
  | { kind: "selected"; index: number | null }
  | { kind: "note"; text: string };

/** From the picture to the extension. */
export type FromPicture =
  | { kind: "ready"; view: View; theme: "light" | "dark"; width: number; height: number }
  | { kind: "select"; index: number };

/** What the picture keeps over a reload of the window. */
export interface PictureState {
  uri: string;
  view: View;
  title: string;
  svg: string;
}

/** A constant as the sliders show it. */
export interface Slider {
  /** Its place among the constants of the program. */
  index: number;
  label: string;
  line: number;
  text: string;
  value: number;
  good: [number | null, number | null][];
  moves: string[];
  errors: number;
}

/** From the extension to the sliders. */
export type ToSliders =
  | { kind: "constants"; title: string; generation: number; constants: Slider[] }
  | { kind: "note"; text: string };

/** From the sliders to the extension. */
export type FromSliders =
  | { kind: "ready" }
  | { kind: "set"; index: number; generation: number; value: number; phase: "first" | "next" | "last" }
  | { kind: "show"; index: number; generation: number };
