import { Camera } from "./camera";
import { Vector } from "./vector";

/** A row of lamps on its C-plane; lengths in mm, luminance in cd/m2. */
export interface Plane {
  origin: Vector;
  u: Vector;
  v: Vector;
  lamps: number;
  pitch: number;
  diameter: number;
  luminance: Vector;
  caps: "dark" | "luminous";
  mirror: "tube" | "flat" | "exact";
}

/** A rig, keiko-view-rig/1. */
export interface Rig {
  name: string;
  planes: Plane[];
  other_lights: number;
  ambient: Vector;
  medium: boolean;
}

export interface Material {
  name: string;
  mirror: boolean;
  metal: boolean;
  diffuse: Vector;
  n: Vector;
  k: Vector;
}

/** The scene, keiko-view-facts/1. */
export interface Facts {
  tool: { name: string; version: string };
  inputs: string[];
  view: string;
  camera: Camera;
  bounds: { lower: Vector; upper: Vector };
  ground: { z: number; material: number } | null;
  background: Vector;
  reflections: number;
  min_weight: number;
  materials: Material[];
  parts: string[];
  faces: { id: number; name: string; layer: string; material: number; part: number }[];
  views: { name: string; camera: Camera }[];
  own_views: { name: string; camera: Camera }[];
  against: boolean;
  remarks: { entity: string; message: string }[];
  rig: Rig;
}
