#include "keiko/import/subdivision/cage.h"
#include "keiko/import/subdivision/subdivision_model.h"

#include "tests/support/paths.h"
#include "tests/unit/import/limit_oracle.h"
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <set>

namespace keiko::subdivision {
namespace {

std::set<std::filesystem::path> cages() {
    std::set<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(test::shared_model("")))
        if (entry.path().extension() == ".obj") paths.insert(entry.path());
    return paths;
}

/// Faces that must come back: those of the cage that are no holes, n for an n-gon.
std::size_t wanted_faces(const Cage& cage) {
    std::size_t count = 0;
    for (const CageFace& face : cage.faces)
        if (!face.hole)
            count += cage.scheme == Scheme::loop || face.corner_count == 4 ? 1 : face.corner_count;
    return count;
}

TEST(SharedCages, EachIsItsLimitSurface) {
    KEIKO_NEEDS_SHARED_MODEL("subd-bigguy.obj");
    for (const std::filesystem::path& path : cages()) {
        const std::string name = path.filename().string();
        const Cage cage = read_cage(path);
        const auto start = std::chrono::steady_clock::now();
        const SurfaceModel model = read_subdivision_file(path);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_EQ(model.faces.size(), wanted_faces(cage)) << name;
        const bool loop = cage.scheme == Scheme::loop;
        const bool large = cage.faces.size() > 2000;
        const auto masks = loop ? test::rays_from_limit_masks(cage, model, 3)
                                : test::from_limit_masks(cage, model, large ? 2 : 4);
        const auto bfr =
            loop ? test::rays_from_bfr(cage, model, 8) : test::from_bfr(cage, model, large ? 3 : 8);
        for (const auto& deviation : {masks, bfr}) {
            EXPECT_EQ(deviation.missed, 0u) << name;
            EXPECT_LE(deviation.position, 1e-6) << name;
            EXPECT_LE(deviation.normal, 1e-5) << name;
        }
        std::printf("%-40s %6.2f s %6zu faces %7zu patches\n  masks %s\n  Bfr   %s\n  %s\n",
                    name.c_str(), seconds.count(), model.faces.size(), model.patches.size(),
                    masks.text().c_str(), bfr.text().c_str(),
                    model.diagnostics.empty() ? "" : model.diagnostics.back().message.c_str());
    }
}

} // namespace
} // namespace keiko::subdivision
