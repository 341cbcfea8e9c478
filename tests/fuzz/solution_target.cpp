// solutions of reflected light, read and written
#include "keiko/radiosity/solution_file.h"

#include "tests/fuzz/fuzz_target.h"

#include <string>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace keiko;
    std::string written;
    if (fuzz::accepts(
            [&] { written = solution_text(parse_solution(fuzz::text_of(data, size), "one")); }))
        fuzz::require(solution_text(parse_solution(written, "written")) == written,
                      "written solutions read back");
    return 0;
}
