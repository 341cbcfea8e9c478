#include "keiko/base/error.h"
#include "keiko/files/model/bezier_file.h"
#include "keiko/files/model/model_serialization.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

// keiko_fuzz_seeds FOLDER: what the fuzz targets begin with, a folder for each: the kept inputs of
// corpus/, and more made of the models and rigs that come with the sources.

namespace {

namespace fs = std::filesystem;
using namespace keiko;

const fs::path sources = KEIKO_SOURCE_DIR;

void write(const fs::path& path, const std::string& content) {
    fs::create_directories(path.parent_path());
    if (!(std::ofstream(path, std::ios::binary) << content))
        throw Error(path.string(), "", "cannot write");
}

void copy_to(const fs::path& folder, const fs::path& from) {
    fs::create_directories(folder);
    fs::copy_file(from, folder / from.filename(), fs::copy_options::overwrite_existing);
}

void copy_surfaces(const fs::path& seeds) {
    for (const char* name : {"dome.bpt", "saddle.bpt"})
        for (const char* target : {"bezier", "format"})
            copy_to(seeds / target, sources / "surfaces" / name);
    for (const char* name : {"cage-cube.obj", "cage-icosahedron.obj", "cage-panel.obj"})
        for (const char* target : {"cage", "subdivision", "format"})
            copy_to(seeds / target, sources / "surfaces" / name);
    for (const char* name : {"concept-car-scene.toml", "hood-scene.toml", "seams-scene.toml"})
        copy_to(seeds / "scene", sources / "surfaces" / name);
    copy_to(seeds / "scene", sources / "surfaces/casting-scene.toml");
    copy_to(seeds / "voxels", sources / "surfaces/casting-voxels.toml");
    copy_to(seeds / "format", sources / "surfaces/trimmed-hole.step");
}

void copy_rigs(const fs::path& seeds) {
    for (const fs::directory_entry& entry : fs::directory_iterator(sources / "lightrigs")) {
        if (entry.path().extension() != ".toml") continue;
        const bool materials = entry.path().filename() == "materials.toml";
        copy_to(seeds / (materials ? "materials" : "rig"), entry.path());
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(sources / "lightrigs/presets"))
        copy_to(seeds / "preset", entry.path());
}

void copy_suite(const fs::path& seeds) {
    for (const char* name : {"hood.toml", "lights.toml", "seams.toml", "seam-g0-gap.toml"})
        copy_to(seeds / "fixture", sources / "surfaces" / name);
    for (const char* name : {"metrics.json", "manifest.json"})
        copy_to(seeds / "record", sources / "surfaces/baselines/seam-g0-gap" / name);
}

void copy_luminaires(const fs::path& seeds) {
    for (const auto& entry :
         fs::directory_iterator(sources / "tests/data/oracle/photometric_files"))
        copy_to(seeds / (entry.path().extension() == ".ldt" ? "eulumdat" : "ies"), entry.path());
}

/// Whole and, because the target adds a header of its own, as what follows the header.
void write_model(const fs::path& seeds, const SurfaceModel& model) {
    constexpr std::size_t header = 8 + 4 + 8 + 8;
    constexpr char largest_pieces = '\xff';
    const std::string bytes = serialize(model);
    write(seeds / "model/whole", bytes);
    write(seeds / "model/payload", bytes.substr(header));
    write(seeds / "worker_answer/model", largest_pieces + ("progress 0.5\nmodel\n" + bytes));
}

/// With something in every list.
SurfaceModel full_model() {
    SurfaceModel saddle = read_bezier_file(sources / "surfaces/saddle.bpt");
    saddle.edges.push_back({});
    saddle.trim_curves.front().edge = 0;
    saddle.lost_faces.push_back({7, "lost", "no reason"});
    saddle.diagnostics.push_back({Severity::warning, "face 7", "it is lost"});
    saddle.faces.front().color = Rgb(0.5);
    return saddle;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: keiko_fuzz_seeds FOLDER\n";
        return 2;
    }
    try {
        fs::copy(sources / "tests/fuzz/corpus", argv[1],
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
        copy_surfaces(argv[1]);
        copy_rigs(argv[1]);
        copy_suite(argv[1]);
        copy_luminaires(argv[1]);
        write_model(argv[1], full_model());
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
    return 0;
}
