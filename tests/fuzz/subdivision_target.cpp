// OBJ cages all the way to their limit surface
#include "keiko/import/subdivision/subdivision_model.h"

#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/sound_model.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    static const fuzz::MemoryFile file;
    file.write(fuzz::text_of(data, size));
    fuzz::accepts([] { fuzz::require_sound(read_subdivision_file(file.path())); });
    return 0;
}
