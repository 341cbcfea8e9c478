// Bezier patches: .bpt files
#include "keiko/files/model/bezier_file.h"

#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/sound_model.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    static const fuzz::MemoryFile file;
    file.write(fuzz::text_of(data, size));
    fuzz::accepts([] { fuzz::require_sound(read_bezier_file(file.path())); });
    return 0;
}
