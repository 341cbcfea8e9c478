import { Facts, Material } from "./facts";

/** Share of the light that a dielectric of refractive index n reflects at the cosine c. */
function dielectric(c: number, n: number): number {
  const g2 = n * n - 1 + c * c;
  if (!(g2 > 0)) return 1;
  const g = Math.sqrt(g2), a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * a * a * (1 + b * b);
}

/** Share of the light that a conductor of index n + ik reflects at the cosine c. */
function conductor(c: number, n: number, k: number): number {
  const c2 = c * c, s2 = 1 - c2, m = n * n - k * k - s2, root = Math.sqrt(m * m + 4 * n * n * k * k);
  const a = Math.sqrt(Math.max(0.5 * (root + m), 0)), across = root + c2, along = 2 * a * c;
  const s = (across - along) / (across + along), level = c2 * root + s2 * s2, side = along * s2;
  return 0.5 * s * (1 + (level - side) / (level + side));
}

/** What the materials of a scene reflect, by the faces of deep buffers. */
export class Mirrors {
  private readonly materials: Material[];
  private readonly ofFace: Uint16Array; // by `face` of a sample plus 1: the ground, nothing, the faces

  constructor(facts: Facts) {
    this.materials = facts.materials;
    this.ofFace = Uint16Array.from([facts.ground?.material ?? 0, 0, ...facts.faces.map((face) => face.material)]);
  }

  /** Number of a face's material. */
  material(face: number): number {
    return this.ofFace[face + 1];
  }

  /** Multiplies a weight, red, green and blue, by what a face reflects at a cosine. */
  weigh(weight: Float64Array, face: number, cosine: number): void {
    const m = this.materials[this.material(face)], c = Math.abs(cosine);
    if (!m.mirror) weight.fill(0);
    else if (!m.metal) {
      const share = dielectric(c, m.n[0]);
      for (let k = 0; k < 3; ++k) weight[k] *= share;
    } else for (let k = 0; k < 3; ++k) weight[k] *= conductor(c, m.n[k], m.k[k]);
  }
}
