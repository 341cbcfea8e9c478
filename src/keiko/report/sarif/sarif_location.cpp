#include "keiko/report/sarif/sarif_location.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace keiko {
namespace {

constexpr const char* root = "ROOT"; ///< the folder that absolute paths begin in

/// A path as a relative URI reference: every byte that is not plain is escaped.
std::string uri_of(std::string_view path) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    path.remove_prefix(std::min(path.find_first_not_of('/'), path.size()));
    std::string uri;
    for (const char c : path) {
        if (plain.find(c) != std::string_view::npos) {
            uri += c;
            continue;
        }
        char escaped[4];
        std::snprintf(escaped, sizeof escaped, "%%%02X", static_cast<unsigned char>(c));
        uri += escaped;
    }
    return uri;
}

SarifPlace place_of(std::uint32_t face, const Inspection& inspection) {
    const std::vector<FaceFacts>& faces = inspection.facts.face_list;
    if (face >= faces.size()) return {};
    const FaceFacts& facts = faces[face];
    return {facts.name.empty() ? "face " + std::to_string(facts.id) : facts.name, facts.file,
            std::max(facts.line, 1u)};
}

std::vector<SarifPlace> sides_of(const MeasuredSeam& seam, const Inspection& inspection) {
    std::vector<SarifPlace> places{place_of(seam.face_a, inspection)};
    if (!seam.internal) places.push_back(place_of(seam.face_b, inspection));
    return places;
}

} // namespace

std::vector<SarifPlace> places_of(const Check& check, const Inspection& inspection) {
    if (check.seam != no_index) return sides_of(inspection.seams.at(check.seam), inspection);
    if (check.face != no_index) return {place_of(inspection.faces.at(check.face).face, inspection)};
    const auto crossed =
        std::find_if(inspection.seams.begin(), inspection.seams.end(),
                     [&](const MeasuredSeam& seam) { return seam.faces == check.faces; });
    if (crossed != inspection.seams.end()) return sides_of(*crossed, inspection);
    return {SarifPlace{.face = check.faces}};
}

Json artifact_location(const std::filesystem::path& file, std::size_t index) {
    Json json = {{"uri", uri_of(file.string())}};
    if (file.is_absolute()) json["uriBaseId"] = root;
    json["index"] = index;
    return json;
}

Json physical_location(const SarifPlace& place, SarifFiles files) {
    if (files.empty()) return nullptr;
    const std::size_t file = place.file < files.size() ? place.file : 0;
    return {{"artifactLocation", artifact_location(files[file], file)},
            {"region", {{"startLine", place.line}}}};
}

Json uri_bases(SarifFiles files) {
    Json bases = Json::object();
    if (std::any_of(files.begin(), files.end(),
                    [](const auto& file) { return file.is_absolute(); }))
        bases[root] = {{"uri", "file:///"}};
    return bases;
}

} // namespace keiko
