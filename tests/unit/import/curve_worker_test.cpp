#include "keiko/base/error.h"
#include "keiko/files/model/curve_serialization.h"
#include "keiko/import/worker/curve_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace keiko {
namespace {

namespace fs = std::filesystem;

CurveSet curves() {
    CurveSet set{"part"};
    NamedCurve curve{"reflection line 0: fail", Rgb(1, 0, 0), 0.01};
    curve.pieces.push_back({3,
                            {0, 0, 0, 0, 10.5, 30, 30, 30, 30},
                            {{1234.5678901234, -987.6543210987, 0.1, 1},
                             {1240, -980, 1.0 / 3, 1},
                             {1250, -970, 2, 1},
                             {1255, -960, 1e-5, 1},
                             {1260.1, -950.7, 0, 1}}});
    set.curves.push_back(curve);
    return set;
}

std::string error_of(const std::function<void()>& act) {
    try {
        act();
        return "none";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(CurveWorker, FilesReadBackToABillionthOfAMillimetre) {
    for (const char* name : {"curves.step", "curves.stp", "curves.iges", "curves.IGS"}) {
        const fs::path path = fs::path(testing::TempDir()) / name;
        std::ofstream(path, std::ios::binary) << curve_file(curves(), path);
        const CurveSet read = read_curves(path);
        ASSERT_EQ(read.curves.size(), 1u) << name;
        EXPECT_EQ(read.curves[0].name, "reflection line 0: fail");
        const std::vector<Vec4> before = curves().curves[0].pieces[0].points;
        const auto& after = read.curves[0].pieces.at(0).points;
        ASSERT_EQ(after.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i)
            EXPECT_LT((euclidean(after[i]) - euclidean(before[i])).length(), 1e-9);
        fs::remove(path);
    }
}

TEST(CurveWorker, OtherEndingsAreRefused) {
    EXPECT_FALSE(is_curve_file("curves.brep"));
    EXPECT_EQ(error_of([] { curve_file(curves(), "curves.brep"); }),
              "curves.brep: ends in none of .step, .stp, .iges and .igs");
}

TEST(CurveWorker, AMissingWorkerIsAnErrorOfTheFile) {
    LoadOptions options;
    options.worker = "/nowhere/keiko-import";
    EXPECT_EQ(error_of([&] { curve_file(curves(), "curves.step", options); }),
              "curves.step: cannot be written: no reader at /nowhere/keiko-import");
}

TEST(CurveSerialization, DamagedBytesAreRefused) {
    const std::string bytes = serialize(curves());
    EXPECT_EQ(serialize(deserialize_curves(bytes, "f")), bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(deserialize_curves(bytes.substr(0, size), "f"), Error) << size;
    EXPECT_THROW(deserialize_curves(bytes + "x", "f"), Error);
    CurveSet falling = curves();
    falling.curves[0].pieces[0].knots[4] = 40;
    EXPECT_THROW(deserialize_curves(serialize(falling), "f"), Error);
    CurveSet weightless = curves();
    weightless.curves[0].pieces[0].points[2].w = 0;
    EXPECT_THROW(deserialize_curves(serialize(weightless), "f"), Error);
}

} // namespace
} // namespace keiko
