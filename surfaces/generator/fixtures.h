#pragma once

#include "fixture.h"

namespace keiko::fixtures {

/// The concept car: 185 faces, each one Bezier patch of degree 3 to 5 in both directions. Vehicle
/// frame in mm: x rearwards, y to the right, z up, ground at z = 0.
Fixture concept_car();

/// A hood with a power dome, whose edges are soft character lines along x: three biquintic faces.
Fixture hood();

/// Two faces that meet along a curved seam in the plane x = 0, with one fault of exactly known
/// size at every point of the seam.
Fixture seam_g0_gap();
Fixture seam_g1_angle();
Fixture seam_g1_only();
Fixture seam_g2_only();

/// A domed panel with a dent 0.1 mm deep: one control point moved.
Fixture dent();

/// One patch with one circular hole, with two, and with an island in the hole.
Fixture trimmed_hole();
Fixture trimmed_two_holes();
Fixture trimmed_island();

/// A cap of four patches, each with an edge collapsed in the top.
Fixture pole();

/// A sphere of radius 100 mm: eight rational biquadratic octants.
Fixture sphere();

/// A sewn solid: a block of 60 x 40 x 24 mm, all edges rounded with 5 mm, bored through with 6 mm.
Fixture bored_block();

/// A door beside a fender, both with rolled edges: a joint that widens upwards, the door proud.
Fixture shut_line();

/// Hyperbolic paraboloid and dome in closed form.
BptFixture saddle();
BptFixture dome();

/// Bodies that throw light on the floor: a band of 100 mm inner radius, water in the shape of a
/// glass, without its bottom's face, and a rippled surface of water, 800 mm wide.
BptFixture ring();
BptFixture water_glass();
BptFixture ripples();

/// Surroundings of a car in pictures of lights, of flat patches in mm: a house front with four
/// barred windows, a wall without, a mast with an arm that holds a lantern.
BptFixture facade();
BptFixture wall();
BptFixture mast();

/// A workshop to be lit, of flat patches in mm: two walls of a bay with a cabinet, and a bench with
/// a shelf below its top.
BptFixture workshop_bay();
BptFixture workbench();

/// Figures of bicubic patches in mm: a teapot with spout and handle, the tea in it, and a figure as
/// of a board game, as tall as a man.
BptFixture teapot();
BptFixture tea();
BptFixture figure();

/// Voxels of a casting in the shape of the bored block, with six pores in the metal and noise: a
/// byte a node, x fastest, as casting-voxels.toml states.
RawFixture casting();

/// A luminaire (LM-63) such as hangs over roads: computed from a formula, not measured.
TextFixture road_lantern();

/// A headlamp (LM-63, type A) with a low beam for traffic on the right: computed from a formula,
/// not measured.
TextFixture headlamp();

/// Cages of subdivision surfaces: a cube with sharp and semi-sharp edges, an open panel of
/// triangles, quads, a pentagon and a hexagon with a hole, and an icosahedron for Loop's scheme.
CageFixture cage_cube();
CageFixture cage_panel();
CageFixture cage_icosahedron();

} // namespace keiko::fixtures
