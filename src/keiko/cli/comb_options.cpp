#include "keiko/cli/comb_options.h"

#include "keiko/base/error.h"
#include "keiko/cli/output_place.h"

#include <CLI/Validators.hpp>

#include <algorithm>

namespace keiko::cli {

void CombArguments::add_to(CLI::App& command) {
    command
        .add_option("--section", planes_,
                    "plane x=MM, y=MM, z=MM or A,B,C=MM: the curvature comb of its section; may "
                    "repeat")
        ->allow_extra_args(false);
    constexpr int most = 1000;
    command
        .add_option("--iso-curves", iso_curves_,
                    "curvature combs of so many iso-curves a face, each way")
        ->check(CLI::Range(1, most));
}

void CombArguments::add_files(CLI::App& command) {
    command
        .add_option("--combs", files_,
                    "file to write the combs to, .json, .csv or .svg; may repeat")
        ->allow_extra_args(false);
}

CombOptions CombArguments::options(double join) const {
    CombOptions options;
    for (const std::string& plane : planes_) {
        if (std::count(planes_.begin(), planes_.end(), plane) > 1)
            throw Error("", "--section", "'" + plane + "' is asked for twice");
        options.planes.push_back(section_plane(plane));
    }
    options.iso_curves = iso_curves_, options.join = join;
    return options;
}

void CombArguments::require_places() const {
    const bool asked = !planes_.empty() || iso_curves_ > 0;
    if (asked && files_.empty())
        throw Error("", "--combs", "names no file for the combs of --section and --iso-curves");
    if (!asked && !files_.empty()) throw Error("", "--combs", "needs --section or --iso-curves");
    for (const std::filesystem::path& file : files_) {
        require_place_for_file(file);
        if (std::count(files_.begin(), files_.end(), file) > 1)
            throw Error("", "--combs", "'" + file.string() + "' is asked for twice");
        const std::filesystem::path ending = file.extension();
        if (ending != ".json" && ending != ".csv" && ending != ".svg")
            throw Error("", "--combs",
                        "'" + file.string() + "' ends in none of .json, .csv and .svg");
    }
}

void CombArguments::add_to(FileTransaction& batch, const Combs& combs) const {
    for (const std::filesystem::path& file : files_) {
        if (file.extension() == ".json") batch.add(file, combs.json);
        if (file.extension() == ".csv") batch.add(file, combs.csv);
        if (file.extension() != ".svg") continue;
        for (const CombPicture& picture : combs.pictures) {
            std::filesystem::path named = file;
            if (planes_.size() > 1 || iso_curves_ > 0)
                named.replace_filename(file.stem().string() + "-" + picture.name + ".svg");
            batch.add(named, picture.svg);
        }
    }
}

} // namespace keiko::cli
