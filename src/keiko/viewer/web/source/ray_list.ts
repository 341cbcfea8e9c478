import { rayNumbers } from "./ray";

/** The array, or one of twice the length with its numbers, so that it has `needed`. */
export function grown<A extends Float32Array | Float64Array | Uint32Array>(array: A, needed: number): A {
  if (array.length >= needed) return array;
  const larger = new (array.constructor as new (size: number) => A)(Math.max(needed, 2 * array.length));
  larger.set(array);
  return larger;
}

/** Reflected rays: 18 numbers each, the length of their way to the next surface, mm, and the weight of their light. */
export class RayList {
  count = 0;
  numbers = new Float32Array(rayNumbers);
  ways = new Float32Array(1);
  weights = new Float32Array(3);

  /** Takes over the memory of a list that is not used any more. */
  takeOver(spent: RayList): void {
    ({ numbers: this.numbers, ways: this.ways, weights: this.weights } = spent);
  }

  /** Makes room for so many rays. */
  reserve(count: number): void {
    this.numbers = grown(this.numbers, count * rayNumbers);
    this.ways = grown(this.ways, count);
    this.weights = grown(this.weights, 3 * count);
  }

  /** Adds a ray; `weight` is what the reflections so far leave of its light, red, green and blue. */
  add(ray: Float64Array, way: number, weight: Float64Array): void {
    const i = this.count++;
    if (this.ways.length <= i) this.reserve(2 * i + 1);
    // Loops are faster than `set` from doubles to floats.
    const { numbers, weights } = this;
    for (let k = 0; k < rayNumbers; ++k) numbers[i * rayNumbers + k] = ray[k];
    for (let k = 0; k < 3; ++k) weights[3 * i + k] = weight[k];
    this.ways[i] = way;
  }
}
