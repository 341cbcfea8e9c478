// intensity tables of lamps in CSV
#include "keiko/files/photometric/intensity_csv.h"

#include "tests/fuzz/memory_file.h"

namespace {

using namespace keiko;

void require_sound(const IntensityTable& table) {
    const double most = table.largest();
    for (int vertical = 0; vertical <= 180; vertical += 15)
        for (int horizontal = 0; horizontal < 360; horizontal += 15) {
            const double cd = table(vertical, horizontal);
            fuzz::require(cd >= 0 && cd <= most * (1 + 1e-12),
                          "no direction is brighter than the table");
        }
    fuzz::require(table.lit_up_to() <= 180, "a table ends behind the lamp");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFile file;
    file.write(fuzz::text_of(data, size));
    fuzz::accepts([] {
        const IntensityColumns columns = read_intensity_csv(file.path());
        for (const auto rule : {TableInterpolation::linear, TableInterpolation::cosine})
            require_sound(intensity_table(columns, rule));
    });
    return 0;
}
