// fixtures of regression suites in TOML
#include "keiko/files/scene/fixture_file.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    // Beside the models and rigs that the seeds name.
    constexpr const char* source = KEIKO_SOURCE_DIR "/surfaces/fixture.toml";
    fuzz::accepts([&] {
        const FixtureSpec fixture = parse_fixture(fuzz::text_of(data, size), source);
        fuzz::require(!fixture.models.empty(), "a fixture has a body");
        fuzz::require(fixture.width > 0 && fixture.height > 0, "a picture has a size");
        fuzz::require(fixture.join > 0, "seams have a width");
    });
    return 0;
}
