#include "keiko/radiosity/occluded_exchange.h"

#include "keiko/radiosity/exchange_area.h"

#include "tests/support/model_builder.h"
#include "tests/support/oracle.h"
#include "tests/unit/radiosity/box_room.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::area_of;
using test::parallelogram;

/// Occluders of planes.
struct Plates {
    SurfaceModel model;
    Tracer tracer;
    Occluders occluders;

    explicit Plates(const std::vector<std::vector<Vec3>>& rectangles)
        : model(model_of(rectangles)), tracer(model), occluders(model, tracer) {}

    static SurfaceModel model_of(const std::vector<std::vector<Vec3>>& rectangles) {
        test::ModelBuilder builder;
        for (const auto& c : rectangles) builder.plane(c[0], c[1] - c[0], c[3] - c[0]);
        return builder.build();
    }
};

std::vector<Vec3> facing(const Vec3& corner, const Vec3& u, const Vec3& v, const Vec3& place) {
    return u.cross(v).dot(place - corner) > 0 ? parallelogram(corner, u, v)
                                              : parallelogram(corner, v, u);
}

struct Row {
    std::vector<Vec3> first, second, plate;

    explicit Row(const test::OracleRow& row) {
        const Vec3 c1 = row.vector("in.c1"), a1 = row.vector("in.a1"), b1 = row.vector("in.b1");
        const Vec3 c2 = row.vector("in.c2"), a2 = row.vector("in.a2"), b2 = row.vector("in.b2");
        first = facing(c1, a1, b1, c2 + (a2 + b2) / 2);
        second = facing(c2, a2, b2, c1 + (a1 + b1) / 2);
        plate = parallelogram(row.vector("in.co"), row.vector("in.ao"), row.vector("in.bo"));
    }
};

TEST(OccludedExchange, IsThatOfTheOracleWithinItsStatedError) {
    test::WorstError of_free("F12_free"), of_vis("vis"), of_F("F12");
    for (const test::OracleRow& row : test::OracleTable("form_factor_occluded")) {
        const Row at(row);
        const Plates plates({at.plate});
        const double area = area_of(at.first);
        const double free = direct_exchange_area(at.first, at.second) / area;
        of_free.compare(row, free, row.number("out.F12_free"), 1e-9);
        const ExchangeArea found =
            occluded_exchange_area(at.first, at.second, plates.occluders, {1e-3, 2000});
        const double factor = found.value / area, expected = row.number("out.F12");
        of_F.compare(row, factor, expected, 1e-3);
        of_vis.compare(row, factor / free, row.number("out.vis"), 1e-3);
        EXPECT_LE(std::abs(factor - expected), found.error / area + 1e-6) << row.id();
        EXPECT_LE(found.error / area, 1e-3 * free) << row.id() << row.text("in.kind");
    }
}

TEST(OccludedExchange, IsOpenWithOccludersBeside) {
    const auto a = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    const auto b = parallelogram(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0));
    const Plates beside({parallelogram(Vec3(5, 0, 0.5), Vec3(1, 0, 0), Vec3(0, 1, 0))});
    const ExchangeArea found = occluded_exchange_area(a, b, beside.occluders);
    EXPECT_EQ(found.value, direct_exchange_area(a, b));
    EXPECT_EQ(found.error, 0);
}

TEST(OccludedExchange, IsNothingBehindAWall) {
    const auto a = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    const auto b = parallelogram(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0));
    const Plates wall({parallelogram(Vec3(-9, -9, 0.5), Vec3(20, 0, 0), Vec3(0, 20, 0))});
    const ExchangeArea found = occluded_exchange_area(a, b, wall.occluders);
    EXPECT_EQ(found.value, 0);
    EXPECT_EQ(found.error, 0);
}

// Beside a far wall, and behind it, at all obliquities: the exchange is that of the one ray.
TEST(OccludedExchange, IsAllOrNothingOfObliqueElements) {
    const Plates walls({parallelogram(Vec3(-50, -50, 1), Vec3(100, 0, 0), Vec3(0, 100, 0)),
                        parallelogram(Vec3(-50, 90, -50), Vec3(100, 0, 0), Vec3(0, 0, 100))});
    const auto a = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    for (const double slope : {1e-6, 1e-4, 1e-2, 0.1, 0.5}) {
        const Vec3 place(3, 0, 0), up = Vec3(slope, 0, 1).normalized();
        const auto b = parallelogram(place + up * 0.1, Vec3(0, 1, 0), up * 0.7);
        const auto open = facing(b[0], b[1] - b[0], b[3] - b[0], Vec3(0));
        const ExchangeArea found = occluded_exchange_area(a, open, walls.occluders);
        const double whole = direct_exchange_area(a, open);
        EXPECT_GT(whole, 0);
        EXPECT_EQ(found.value, whole) << slope;
        auto far = open;
        for (Vec3& corner : far) corner.z += 1.5;
        EXPECT_GT(direct_exchange_area(a, far), 0);
        EXPECT_EQ(occluded_exchange_area(a, far, walls.occluders).value, 0) << slope;
    }
}

// Walls that touch are themselves among the occluders, and do not hide each other.
TEST(OccludedExchange, OfWallsOfARoomIsOpenAmongThemselves) {
    const auto room = test::box_room({2000, 3000, 1500});
    const Plates walls(room);
    for (std::size_t i = 0; i < room.size(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < room.size(); ++j)
            if (i != j)
                sum += occluded_exchange_area(room[i], room[j], walls.occluders, {1e-3, 500}).value;
        EXPECT_NEAR(sum / area_of(room[i]), 1, 1e-6) << i;
    }
}

} // namespace
} // namespace keiko
