// parts.json of runs over many bodies, read and written
#include "keiko/batch/parts_report.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    std::string written;
    if (fuzz::accepts([&] {
            const std::string text(fuzz::text_of(data, size));
            written = parts_json(parse_parts(text, "parts.json"));
        }))
        fuzz::require(parts_json(parse_parts(written, "written.json")) == written,
                      "a written run reads back");
    return 0;
}
