#pragma once

#include "tests/support/paths.h"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace keiko::test {

/// A CAD file of the collection beside the project.
struct ManifestRow {
    std::string file;
    int faces = -1; ///< -1: OpenCASCADE does not survive the file

    /// Chosen for what is wrong with it.
    bool bad() const { return file.starts_with("bad-"); }
};

/// The STEP, IGES and BREP files of the collection; none where it is absent.
inline std::vector<ManifestRow> cad_manifest() {
    std::ifstream in(shared_model("MANIFEST.tsv"));
    std::vector<ManifestRow> rows;
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> columns;
        std::istringstream words(line);
        for (std::string word; std::getline(words, word, '\t');) columns.push_back(word);
        const std::string extension = std::filesystem::path(columns.at(1)).extension();
        if (extension != ".step" && extension != ".igs" && extension != ".brep") continue;
        rows.push_back({columns[1], columns[3] == "-" ? -1 : std::stoi(columns[3])});
    }
    return rows;
}

} // namespace keiko::test
