// check_part MODEL...: holds the geometry of a body against class-A criteria and prints its worst
// seams. Exits with 0 if all pass, 1 if not, 2 for a file that cannot be read.
#include "keiko/api/check.h"

#include <filesystem>
#include <iostream>
#include <vector>

namespace {

void print_seam(const keiko::MeasuredSeam& seam) {
    std::cout << seam.faces << ": " << keiko::name_of(seam.verdict) << ", gap " << seam.gap.value
              << " +- " << seam.gap.bound << " mm";
    if (seam.angle) std::cout << ", angle " << seam.angle->value << " deg";
    if (seam.curvature)
        std::cout << ", curvature off by " << 100 * seam.curvature->mismatch << " %";
    const keiko::Vec3 place = keiko::worst_place(seam);
    std::cout << ", worst at (" << place.x << ", " << place.y << ", " << place.z << ")\n";
}

} // namespace

int main(int argc, char** argv) try {
    const std::vector<std::filesystem::path> files(argv + 1, argv + argc);
    if (files.empty()) {
        std::cerr << "usage: check_part MODEL...\n";
        return 2;
    }
    keiko::CheckOptions options;
    options.preset.gap = 0.02; // mm; the other limits are those of class-a-outer
    const keiko::Inspection inspection = keiko::check_models(files, options).inspection;
    for (const std::uint32_t seam : keiko::worst_seams(inspection, 5))
        print_seam(inspection.seams[seam]);
    std::cout << "verdict: " << keiko::name_of(inspection.verdict) << '\n';
    return inspection.verdict == keiko::Verdict::pass ? 0 : 1;
} catch (const keiko::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
