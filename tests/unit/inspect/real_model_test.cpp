#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <iostream>

namespace keiko {
namespace {

Inspection inspected(const char* name) {
    const Inspection result = inspect(load_model(test::shared_model(name)));
    double gap = 0, angle = 0;
    for (const MeasuredSeam& seam : result.seams) {
        gap = std::max(gap, seam.gap.value);
        if (seam.angle && seam.is_angle_judged()) angle = std::max(angle, seam.angle->value);
    }
    std::cout << name << ": " << result.seams.size() << " seams, largest gap " << gap
              << " mm, largest angle below a crease " << angle << " degrees\n";
    return result;
}

double seam_length(const Inspection& inspection) {
    double sum = 0;
    for (const MeasuredSeam& seam : inspection.seams) sum += seam.length;
    return sum;
}

TEST(RealModels, FenderIsSewnAndHasNoFoldedSeams) {
    KEIKO_NEEDS_SHARED_MODEL("car-front-fender.brep");
    const Inspection fender = inspected("car-front-fender.brep");
    EXPECT_GT(fender.seams.size(), 80u);
    EXPECT_LT(fender.facts.free_length, 0.2 * fender.facts.border_length);
    // Every border is free or part of a seam of two sides; the needle tips fold nothing back.
    EXPECT_NEAR(2 * seam_length(fender) + fender.facts.free_length, fender.facts.border_length,
                0.002 * fender.facts.border_length);
    for (const MeasuredSeam& seam : fender.seams) {
        EXPECT_LT(seam.angle->value, 170) << seam.faces;
        EXPECT_LT(seam.gap.value, 0.05) << seam.faces;
    }
}

TEST(RealModels, RearDeckHasSeamsThoughItsFacesShareNoEdge) {
    KEIKO_NEEDS_SHARED_MODEL("car-rear-deck-half-panel.brep");
    const Inspection deck = inspected("car-rear-deck-half-panel.brep");
    EXPECT_GT(deck.seams.size(), 60u);
    for (const Seam& piece : deck.pieces) EXPECT_FALSE(piece.edge.has_value());
    EXPECT_LT(deck.facts.free_length, 0.2 * deck.facts.border_length);
}

TEST(RealModels, HoodReadsTheSameFromEveryFormat) {
    KEIKO_NEEDS_SHARED_MODEL("car-hood.brep");
    const Inspection brep = inspected("car-hood.brep");
    const Inspection iges = inspected("car-hood-converted.igs");
    EXPECT_EQ(brep.seams.size(), iges.seams.size());
    EXPECT_NEAR(seam_length(brep), seam_length(iges), 1);
}

} // namespace
} // namespace keiko
