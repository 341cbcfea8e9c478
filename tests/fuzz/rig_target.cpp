// light rigs in TOML, read and written
#include "keiko/files/scene/rig_file.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    std::string written;
    if (fuzz::accepts(
            [&] { written = rig_text(parse_rig(fuzz::text_of(data, size), "rig.toml")); }))
        fuzz::require(rig_text(parse_rig(written, "written.toml")) == written,
                      "a written rig reads back");
    return 0;
}
