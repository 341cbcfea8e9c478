// registered hits, read and written
#include "keiko/report/json/placement_json.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    std::string written;
    if (fuzz::accepts([&] {
            const std::string text(fuzz::text_of(data, size));
            written = hits_json(hits_from_json(text, "hits.json"), "1");
        }))
        fuzz::require(hits_json(hits_from_json(written, "written.json"), "1") == written,
                      "written hits read back");
    return 0;
}
