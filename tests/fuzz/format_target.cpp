// the kind of a model file, recognized by its content
#include "keiko/files/model/model_format.h"

#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    static const fuzz::MemoryFile file;
    file.write(fuzz::text_of(data, size));
    fuzz::accepts([] { detect_model_format(file.path()); });
    return 0;
}
