// the metrics and the manifest of a baseline
#include "keiko/base/sha256.h"
#include "keiko/report/record_files.h"

#include "tests/fuzz/fuzz_target.h"

namespace {

using namespace keiko;

/// A baseline of one small picture, with the layers of the one that is a seed.
FolderContent sound_files() {
    FixtureRecord record;
    record.metrics = {{"seams", "gap", Quantity::gap, 0.1}};
    record.pictures = {{"top", {Image(3, 2, 3), Image(3, 2, 1), {}}}};
    for (const Aov aov : {Aov::depth, Aov::face})
        record.pictures.front().film.aovs.emplace(aov, Image(3, 2, 1));
    record.setup.eyes = {{"auto", "top", {}}};
    return files_of({record, "key", {}});
}

/// Names every file, so that it is the file's content that is judged.
std::string manifest_of(const FolderContent& files) {
    std::string text = R"({"format": "keiko-manifest/1", "changes": [], "files": {)";
    const char* between = "";
    for (const auto& [name, bytes] : files) {
        if (name == "manifest.json") continue;
        text += between + ('"' + name + "\": \"" + sha256_hex(bytes) + '"');
        between = ", ";
    }
    return text + "}}";
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const FolderContent sound = sound_files();
    const std::string text(fuzz::text_of(data, size));

    FolderContent other_manifest = sound;
    other_manifest["manifest.json"] = text;
    fuzz::accepts([&] { record_of(other_manifest, "baseline"); });
    changes_in(other_manifest);

    FolderContent other_metrics = sound;
    other_metrics["metrics.json"] = text;
    other_metrics["manifest.json"] = manifest_of(other_metrics);
    FolderContent written;
    if (fuzz::accepts([&] { written = files_of(record_of(other_metrics, "baseline")); }))
        fuzz::require(files_of(record_of(written, "written")) == written,
                      "a written record reads back");
    return 0;
}
