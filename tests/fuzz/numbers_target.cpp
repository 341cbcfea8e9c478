// numbers of STEP, IGES and BREP files, before OpenCASCADE sees them
#include "keiko/files/model/cad_text.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    for (const ModelFormat format : {ModelFormat::step, ModelFormat::iges, ModelFormat::brep})
        fuzz::accepts([&] { require_numbers(fuzz::text_of(data, size), format, "model"); });
    return 0;
}
