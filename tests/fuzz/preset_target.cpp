// criteria presets in TOML
#include "keiko/files/scene/preset_file.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    fuzz::accepts([&] {
        const CriteriaPreset preset = parse_preset(fuzz::text_of(data, size), "preset.toml");
        fuzz::require(!preset.name.empty(), "a preset has a name");
        fuzz::require(preset.gap > 0 && preset.angle > 0 && preset.feature_angle >= preset.angle,
                      "every limit can be met and missed");
    });
    return 0;
}
