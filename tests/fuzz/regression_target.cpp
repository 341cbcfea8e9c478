// regression.json, read and written
#include "keiko/report/content/regression.h"

#include "tests/fuzz/fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    std::string written;
    if (fuzz::accepts([&] {
            const std::string text(fuzz::text_of(data, size));
            written = regression_json(parse_regression(text, "regression.json"));
        }))
        fuzz::require(regression_json(parse_regression(written, "written.json")) == written,
                      "a written regression reads back");
    return 0;
}
