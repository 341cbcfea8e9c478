// views in TOML
#include "keiko/files/scene/scene_file.h"

#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    static const fuzz::MemoryFile file;
    file.write(fuzz::text_of(data, size));
    fuzz::accepts([] {
        const Camera camera = read_view(file.path());
        fuzz::require((camera.target - camera.eye).cross(camera.up).length() > 0,
                      "a camera knows what is up");
    });
    return 0;
}
