#include "keiko/math/refract.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

TEST(Refraction, AgreesWithOracle) {
    const test::OracleTable table("refract");
    test::WorstError mirrored("refl"), refracted("refr");
    int total = 0;
    for (const auto& row : table) {
        const Vec3 d = row.unit("in.d"), n = row.unit("in.N");
        const Vec3 back = reflect(d, n), expected = row.vector("out.refl");
        for (unsigned i = 0; i < 3; ++i) mirrored.compare(row, back[i], expected[i], 1e-11, 1e-15);
        const auto through = refract(d, n, row.number("in.n1") / row.number("in.n2"));
        ASSERT_EQ(!through, row.integer("out.tir") == 1) << row.id();
        total += !through;
        if (!through) continue;
        const Vec3 bent = row.vector("out.refr");
        for (unsigned i = 0; i < 3; ++i)
            refracted.compare(row, (*through)[i], bent[i], 1e-11, 1e-15);
    }
    EXPECT_GT(total, 0);
}
