/** A measured quantity; without a limit and a verdict where it is not judged. */
export interface Measured { value: number; bound: number; limit: number | null; verdict: string | null }

/** A line of words on a quantity, with the class of its verdict. `shown`: how many of `unit` are 1 of the value's. */
export function measureLine(name: string, { value, limit, verdict }: Measured, unit: string, shown = 1): { words: string; verdict: string } {
  const digits = (size: number): string => `${Number((shown * size).toPrecision(3))}${unit}`;
  return { words: `${name} ${digits(value)}, ${limit === null ? "not judged" : `limit ${digits(limit)}`}`, verdict: verdict ?? "soft" };
}
