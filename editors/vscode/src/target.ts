// Where an object shall go, as a user writes it.

import type { Target } from "./protocol";

const AXES = ["x", "y", "z"];

/** Reads `x=1.2 z=0.5`, `x+0.3 y-0.1` or `1.2 0 0.5` for an object whose center is known; a coordinate that is not named stays. */
export function target(text: string, center: readonly [number, number, number]): Target | undefined {
  const words = text.trim().split(/[\s,]+/);
  const numbers = words.map(word => (word === "" ? NaN : Number(word)));
  const [x, y, z] = numbers;
  if (numbers.length === 3 && x !== undefined && y !== undefined && z !== undefined && numbers.every(Number.isFinite)) return [x, y, z];
  const to: Target = [null, null, null];
  for (const word of words) {
    const [, axis, sign, digits] = /^([xyz])([=+-])(-?\d*\.?\d+)$/i.exec(word) ?? [];
    const index = AXES.indexOf(axis?.toLowerCase() ?? "") as -1 | 0 | 1 | 2;
    if (index === -1 || to[index] !== null) return undefined;
    const value = Number(digits);
    to[index] = sign === "=" ? value : center[index] + (sign === "-" ? -value : value);
  }
  return to;
}
