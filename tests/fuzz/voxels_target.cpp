// headers of voxels in TOML
#include "keiko/files/scene/voxel_header.h"

#include "tests/fuzz/fuzz_target.h"

#include <algorithm>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    // Beside the voxels that the seeds name.
    constexpr const char* source = KEIKO_SOURCE_DIR "/surfaces/voxels.toml";
    fuzz::accepts([&] {
        const VoxelFiles files = parse_voxel_header(fuzz::text_of(data, size), source);
        fuzz::require(files.raw.empty() != files.slices.empty(), "voxels have one source");
        fuzz::require(
            files.raw.empty() || *std::min_element(files.nodes.begin(), files.nodes.end()) > 1,
            "a grid has cells");
        fuzz::require(std::min({files.spacing.x, files.spacing.y, files.spacing.z}) > 0,
                      "nodes stand apart");
    });
    return 0;
}
