// Findings of a part that is placed turned, mirrored and scaled.
#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Three sheets: a gap of 0.1 mm with a notch 5 mm deep, an angle of 0.3 degrees, and a kink of as
/// much inside the third.
test::ModelBuilder faulty_part() {
    constexpr double gap = 0.1, length = test::sheet_length;
    test::ModelBuilder builder;
    builder.plane({0, -50 - gap, 0}, {length, 0, 0}, {0, 50, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0.65, 1}, {0.62, 0.9}, {0.6, 1}, {0, 1}});
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, 50, 0});
    const double slope = std::tan(degrees_to_radians(0.3));
    NurbsSurface bent{1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 2}, {}};
    for (const double x : {0.0, length})
        for (const double y : {0.0, 10.0, 20.0, 30.0, 40.0})
            bent.points.emplace_back(x, 50 + y, slope * (y + std::max(0.0, y - 20)), 1);
    builder.nurbs(bent);
    return builder;
}

/// A finding or what is worth a look.
struct Fault {
    std::string code, unit;
    double value;
    Vec3 place;
};

std::vector<Fault> faults_of(const Inspection& inspection, std::uint32_t instance) {
    std::vector<Fault> faults;
    const auto add = [&](const Check& check) {
        const std::uint32_t of = check.seam != no_index ? inspection.seams[check.seam].instance_a
                                                        : inspection.faces[check.face].instance;
        if (of == instance)
            faults.push_back({check.code, check.unit, check.worst.value, check.worst.place});
    };
    std::for_each(inspection.findings.begin(), inspection.findings.end(), add);
    std::for_each(inspection.looks.begin(), inspection.looks.end(), add);
    std::sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
        return std::pair(a.code, a.value) < std::pair(b.code, b.value);
    });
    return faults;
}

TEST(PlacedParts, HaveTheSameFaultsMirroredTurnedAndScaled) {
    const Affine mirror{{Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {0, 0, 0}};
    const Affine turn = Affine::rotate(Vec3(1, 2, 3).normalized(), 1.1);
    struct Placement {
        Affine transform;
        double scale;
    };
    std::vector<Placement> placements{{{}, 1},
                                      {mirror, 1},
                                      {turn, 1},
                                      {Affine::scale(1.7), 1.7},
                                      {Affine::scale(0.6) * turn * mirror, 0.6}};
    test::ModelBuilder builder = faulty_part();
    for (std::size_t i = 0; i < placements.size(); ++i) {
        Affine& transform = placements[i].transform;
        transform = Affine::translate({1000.0 * static_cast<double>(i), 0, 0}) * transform;
        builder.instance(transform);
    }
    const Inspection found = inspect(builder.build());
    const std::vector<Fault> original = faults_of(found, 0);
    std::string codes;
    for (const Fault& fault : original) codes += fault.code + ' ';
    EXPECT_EQ(codes, "G-SU-LG G-SU-LG G-SU-NT G-SU-NT KEIKO-OPENING ");
    for (std::uint32_t i = 1; i < placements.size(); ++i) {
        const std::vector<Fault> placed = faults_of(found, i);
        ASSERT_EQ(placed.size(), original.size()) << i;
        for (std::size_t k = 0; k < placed.size(); ++k) {
            const Fault &was = original[k], &is = placed[k];
            EXPECT_EQ(is.code, was.code) << i;
            const double scale = was.unit == "mm" ? placements[i].scale : 1;
            EXPECT_NEAR(is.value, scale * was.value, 1e-6 * scale * was.value) << i << is.code;
            // Along x all but the notch is the same everywhere.
            Vec3 away = placements[i].transform.inverse().point(is.place) - was.place;
            if (is.code != "KEIKO-OPENING") away.x = 0;
            EXPECT_LT(away.length(), 0.01) << i << is.code;
        }
    }
}

} // namespace
} // namespace keiko
