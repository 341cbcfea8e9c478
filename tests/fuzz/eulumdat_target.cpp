// EULUMDAT luminaire files
#include "keiko/files/photometric/luminaire_file.h"

#include "tests/fuzz/sound_web.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    fuzz::accepts(
        [&] { fuzz::require_sound(parse_eulumdat(fuzz::text_of(data, size), "fuzz.ldt")); });
    return 0;
}
