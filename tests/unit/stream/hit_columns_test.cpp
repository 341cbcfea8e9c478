#include "keiko/stream/hit_columns.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

/// Hit on a cylinder of radius 100 mm about the x axis, at its top, the normal outwards.
Hit cylinder_hit() {
    Hit hit;
    hit.t = 0.1, hit.face = 4, hit.patch = 7;
    hit.uv = Vec2(0.25, 1);
    hit.position = Vec3(1e21, -1.0 / 3, 100);
    hit.normal = Vec3(0, 0, 1);
    hit.dpdu = Vec3(1, 0, 0), hit.dpdv = Vec3(0, 1, 0);
    hit.second = SecondDerivatives{Vec3(0), Vec3(0), Vec3(0, 0, -0.01)};
    hit.position_bound = 5e-12;
    return hit;
}

std::string row_of(const Hit& hit, std::string_view columns, const Rgb& seen = {}) {
    std::string text;
    append_row(text, hit_columns(columns), hit, seen);
    return text;
}

std::string refusal_of(std::string_view list) {
    try {
        hit_columns(list);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(HitColumns, AreNamedInAnyOrder) {
    for (const char* list : {"t", "nz,t,face",
                             "t,instance,face,patch,u,v,x,y,z,nx,ny,nz,k1,k2,bound,flags,luminance,"
                             "r,g,b"})
        EXPECT_EQ(header_of(hit_columns(list)), list);
}

TEST(HitColumns, RefuseUnknownEmptyAndDoubleNames) {
    EXPECT_EQ(
        refusal_of("t,hue"),
        "columns: no column is called \"hue\"; there are t,instance,face,patch,u,v,x,y,z,nx,ny,"
        "nz,k1,k2,bound,flags,luminance,r,g,b");
    for (const char* list : {"", "t,", ",t", "t, u", "T"})
        EXPECT_NE(refusal_of(list).find("no column is called"), std::string::npos) << list;
    EXPECT_EQ(refusal_of("t,u,t"), "columns: the column \"t\" stands there twice");
}

TEST(HitColumns, KnowWhichOfThemNeedLight) {
    EXPECT_EQ(light_column(hit_columns("t,bound,flags")), std::nullopt);
    EXPECT_EQ(light_column(hit_columns("t,g,luminance")), "g");
}

TEST(HitRow, HoldsTheShortestDigitsThatReadBack) {
    EXPECT_EQ(row_of(cylinder_hit(), "t,instance,face,patch,u,v,x,y,z,nz,bound"),
              "0.1,0,4,7,0.25,1,1e+21,-0.3333333333333333,100,1,5e-12\n");
}

TEST(HitRow, TellsCurvaturesTowardsTheNormal) {
    EXPECT_EQ(row_of(cylinder_hit(), "k1,k2"), "0,-0.01\n");
}

TEST(HitRow, LeavesTheCurvaturesOfAPoleEmpty) {
    Hit pole = cylinder_hit();
    pole.dpdv = Vec3(0);
    EXPECT_EQ(row_of(pole, "k1,t,k2"), ",0.1,\n");
    Hit plain = cylinder_hit();
    plain.second.reset();
    EXPECT_EQ(row_of(plain, "k1,k2"), ",\n");
}

TEST(HitRow, TellsLuminanceAsTheColourHasIt) {
    EXPECT_EQ(row_of(cylinder_hit(), "luminance,r,g,b", Rgb(100, 0, 0)), "21.26,100,0,0\n");
}

TEST(HitRow, OfAMissIsEmpty) {
    std::string text;
    append_empty_row(text, hit_columns("t,x,flags"));
    append_empty_row(text, hit_columns("t"));
    EXPECT_EQ(text, ",,\n\n");
}

TEST(HitFlagWords, NameThePathThenTheSeam) {
    EXPECT_EQ(flag_words(HitFlags::none), "unique");
    EXPECT_EQ(flag_words(HitFlags::seam), "unique|seam");
    EXPECT_EQ(flag_words(HitFlags::clipped), "clipped");
    EXPECT_EQ(flag_words(HitFlags::tangential | HitFlags::clipped | HitFlags::seam),
              "clipped|tangential|seam");
}

} // namespace
} // namespace keiko
