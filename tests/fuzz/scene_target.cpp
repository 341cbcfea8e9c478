// scenes in TOML
#include "keiko/files/scene/scene_file.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    // Beside the models and rigs that the seeds name.
    constexpr const char* source = KEIKO_SOURCE_DIR "/surfaces/scene.toml";
    fuzz::accepts([&] {
        const SceneSpec scene = parse_scene(fuzz::text_of(data, size), source);
        fuzz::require(!scene.models.empty() || !scene.primitives.empty(), "a scene has a body");
        fuzz::require(scene.width > 0 && scene.height > 0, "a picture has a size");
    });
    return 0;
}
