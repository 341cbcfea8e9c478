#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/report/markup/json_text.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// The files of a SARIF run, in the order of FaceFacts::file.
using SarifFiles = std::span<const std::filesystem::path>;

/// Place of a face in one of the files, by line from 1.
struct SarifPlace {
    std::string face;       ///< its name, or else "face 12"
    std::uint32_t file = 0; ///< into the files of the run
    std::uint32_t line = 1; ///< at least 1
};

/// The one or two faces of a check. Without a known face: line 1 of the first file.
std::vector<SarifPlace> places_of(const Check& check, const Inspection& inspection);

/// SARIF artifactLocation of a file: a percent-encoded relative reference [RFC3986], to the base
/// `ROOT` where the path is absolute.
Json artifact_location(const std::filesystem::path& file, std::size_t index);

/// SARIF physicalLocation of a place; null without files.
Json physical_location(const SarifPlace& place, SarifFiles files);

/// SARIF originalUriBaseIds of a run: of `ROOT`, if a path is absolute; else an empty object.
Json uri_bases(SarifFiles files);

} // namespace keiko
