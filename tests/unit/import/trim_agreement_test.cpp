#include "tests/unit/import/trim_agreement.h"

#include "keiko/base/error.h"
#include "keiko/files/model/model_format.h"
#include "keiko/import/cad/cad_import.h"

#include "tests/support/long_run.h"
#include "tests/support/manifest.h"
#include <gtest/gtest.h>

#include <cstdio>

namespace keiko::cad {
namespace {

/// A usual run takes the models that are read at once.
bool taken(const test::ManifestRow& row) {
    constexpr std::uintmax_t small = 1'500'000;
    return row.faces > 0 &&
           (test::long_run() || std::filesystem::file_size(test::shared_model(row.file)) < small);
}

void print(const TrimDisagreement& d) {
    std::printf(
        "  %s%s at (%.12g, %.12g), %.2g mm from its border: %s for Keiko, not for "
        "OpenCASCADE; the crossings of its p-curves say %s\n",
        d.face.c_str(), d.valid_face ? "" : ", invalid,", d.at.x, d.at.y, d.border_distance,
        d.ours ? "material" : "hole", d.ours == d.curves_agree_with_us ? "material" : "hole");
}

/// Disagreements between Keiko and OpenCASCADE are allowed only where the file's own curves are on
/// Keiko's side. On a face that OpenCASCADE's check calls invalid they may be open, and then bound
/// nothing by themselves.
TEST(TrimAgreement, WithOpenCascadesClassifierOnEveryModel) {
    KEIKO_NEEDS_SHARED_MODEL("MANIFEST.tsv");
    const std::size_t samples = test::ray_count(500, 100'000);
    for (const test::ManifestRow& row : test::cad_manifest()) {
        if (!taken(row)) continue;
        const auto path = test::shared_model(row.file);
        const CadDocument document = read_document(path, detect_model_format(path));
        const TrimTally tally = compare_trims(document, convert_document(document), samples);
        std::size_t theirs = 0, open = 0;
        for (const TrimDisagreement& d : tally.disagreements) {
            constexpr std::size_t shown = 2;
            theirs += d.curves_agree_with_us;
            open += !d.curves_agree_with_us && !d.valid_face;
            if (theirs + open <= shown || (!d.curves_agree_with_us && d.valid_face)) print(d);
        }
        const std::size_t ours = tally.disagreements.size() - theirs - open;
        // tests/model_table.py reads this line.
        std::printf("trims\t%s\t%zu\t%zu\t%zu\t%zu\t%zu\n", row.file.c_str(), tally.samples,
                    tally.at_border + tally.undecided, ours, theirs, open);
        std::fflush(stdout);
        EXPECT_EQ(ours, 0u) << row.file;
        EXPECT_LE(100 * (tally.at_border + tally.undecided), tally.samples) << row.file;
    }
}

} // namespace
} // namespace keiko::cad
