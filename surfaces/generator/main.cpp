#include "bpt_file.h"
#include "fixtures.h"
#include "obj_file.h"
#include "step_file.h"
#include "text_file.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    using namespace keiko::fixtures;
    if (argc != 2) {
        std::fprintf(stderr, "usage: keiko-fixtures DIR\nwrites the models of surfaces/ to DIR\n");
        return 2;
    }
    const std::filesystem::path directory = argv[1];
    try {
        for (const auto make : {concept_car, hood, seam_g0_gap, seam_g1_angle, seam_g1_only,
                                seam_g2_only, dent, trimmed_hole, trimmed_two_holes, trimmed_island,
                                pole, sphere, bored_block, shut_line}) {
            const Fixture fixture = make();
            report(fixture.file, fixture.truths);
            write_step(directory / fixture.file, fixture.faces);
        }
        for (const auto make : {saddle, dome, ring, water_glass, ripples, facade, wall, mast,
                                workshop_bay, workbench, teapot, tea, figure}) {
            const BptFixture fixture = make();
            report(fixture.file, fixture.truths);
            write_bpt(directory / fixture.file, fixture.patches);
        }
        for (const auto make : {cage_cube, cage_panel, cage_icosahedron}) {
            const CageFixture fixture = make();
            report(fixture.file, fixture.truths);
            write_obj(directory / fixture.file, fixture);
        }
        for (const auto make : {road_lantern, headlamp}) {
            const TextFixture fixture = make();
            report(fixture.file, fixture.truths);
            write_lines(directory / fixture.file, fixture.lines);
        }
        const RawFixture voxels = casting();
        report(voxels.file, voxels.truths);
        write_bytes(directory / voxels.file, voxels.bytes);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "keiko-fixtures: %s\n", error.what());
        return 1;
    }
    return 0;
}
