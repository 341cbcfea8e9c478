#include "keiko/base/error.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/manifest.h"
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace keiko::cad {
namespace {

std::size_t placed_faces(const SurfaceModel& model) {
    std::size_t count = model.lost_faces.size();
    for (const Instance& instance : model.instances) count += model.parts[instance.part].face_count;
    return count;
}

TEST(SharedModels, EachLoadsWithoutSilentLossOrFailsInOneLine) {
    KEIKO_NEEDS_SHARED_MODEL("MANIFEST.tsv");
    for (const test::ManifestRow& row : test::cad_manifest()) {
        const auto start = std::chrono::steady_clock::now();
        std::string result;
        try {
            const SurfaceModel model = load_model(test::shared_model(row.file));
            EXPECT_EQ(static_cast<int>(placed_faces(model)), row.faces) << row.file;
            EXPECT_EQ(model.lost_faces.empty() || row.bad(), true) << row.file;
            result = std::to_string(model.faces.size()) + " faces, " +
                     std::to_string(model.lost_faces.size()) + " lost, " +
                     std::to_string(model.patches.size()) + " patches, " +
                     std::to_string(model.diagnostics.size()) + " remarks";
        } catch (const Error& e) {
            EXPECT_LE(row.faces, 0) << e.what();
            result = e.reason();
        }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::printf("%-50s %6.2f s  %s\n", row.file.c_str(), seconds.count(), result.c_str());
    }
}

} // namespace
} // namespace keiko::cad
