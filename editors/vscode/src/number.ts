// Numbers as they are written into a program.

/** A float literal of Python: always with a dot, and no longer than it need be. */
export function literal(value: number): string {
  const text = value.toFixed(6).replace(/0+$/, "");
  if (Number(text) === 0) return "0.0";
  return text.endsWith(".") ? `${text}0` : text;
}

/** The same for a place in a program: what follows may bind closer than a sign does. */
export function literalBefore(value: number, following: string): string {
  const text = literal(value);
  return value < 0 && /^\s*\*\*/.test(following) ? `(${text})` : text;
}

/** The number with the fewest decimals near a value that lies between two bounds; the value itself if they are too close. */
function short(value: number, low: number, high: number): number {
  for (let digits = 0; digits <= 6; digits++) {
    const rounded = Number(value.toFixed(digits));
    if (low <= rounded && rounded <= high) return rounded;
  }
  return value;
}

/** The nearest value without errors, a little inside of its interval; undefined if there is none, or the value is in one. */
export function nearestGood(value: number, good: readonly [number | null, number | null][]): number | undefined {
  let best: number | undefined;
  for (const [from, to] of good) {
    const low = from ?? -Infinity;
    const high = to ?? Infinity;
    if (low <= value && value <= high) return undefined;
    const inset = Math.min(0.01, (high - low) / 2);
    const candidate = short(value < low ? low + inset : high - inset, low + inset / 2, high - inset / 2);
    if (best === undefined || Math.abs(candidate - value) < Math.abs(best - value)) best = candidate;
  }
  return best;
}
