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

/** The nearest value without errors, a little inside of its interval; undefined if there is none, or the value is in one. */
export function nearestGood(value: number, good: readonly [number | null, number | null][]): number | undefined {
  let best: number | undefined;
  for (const [from, to] of good) {
    const low = from ?? -Infinity;
    const high = to ?? Infinity;
    if (low <= value && value <= high) return undefined;
    const inset = Math.min(0.01, (high - low) / 2);
    const candidate = value < low ? low + inset : high - inset;
    if (best === undefined || Math.abs(candidate - value) < Math.abs(best - value)) best = candidate;
  }
  return best;
}
