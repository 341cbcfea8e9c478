#include "keiko/workflow/analysis_file.h"

#include "keiko/base/input_file.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/inspect/combs/section_plane.h"
#include "keiko/report/json/json_parts.h"
#include "keiko/report/markup/json_errors.h"
#include "keiko/report/markup/json_members.h"
#include "keiko/workflow/analysis_mode.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace keiko {
namespace {

constexpr const char* format = "keiko-analysis/1";

/// Calls `read` with each entry of a list. Its errors name the list and the number from 1.
template <class Read>
void for_each_of(const Json& json, const char* key, const Read& read) {
    std::size_t number = 0;
    for (const Json& entry : list_at(json, key))
        with_errors_named("", std::string(key) + " " + std::to_string(++number),
                          [&] { read(entry); });
}

AnalysisView view_from(const Json& json) {
    require_known_keys(json, {"name", "look", "across", "camera"});
    AnalysisView view{text_at(json, "name"), {}, text_at(json, "look")};
    if (json.contains("across")) view.across = place_at(json, "across");
    with_errors_named("", "camera",
                      [&] { view.camera = checked_camera_from(value_at(json, "camera")); });
    return view;
}

HiddenFace hidden_from(const Json& json) {
    require_known_keys(json, {"face", "name", "place"});
    HiddenFace hidden{count_from<std::uint32_t>(value_at(json, "face"), "face"),
                      text_at(json, "name", true), std::nullopt};
    if (json.contains("place")) hidden.place = place_at(json, "place");
    require(!hidden.name.empty() || hidden.place, "", "has neither name nor place to be found by");
    return hidden;
}

AnalysisNote note_from(const Json& json) {
    require_known_keys(json, {"text", "place", "face"});
    AnalysisNote note{text_at(json, "text"), place_at(json, "place")};
    if (json.contains("face")) note.face = count_at<std::uint32_t>(json, "face");
    return note;
}

/// The lines of a rig's text, as one text.
std::string rig_lines_from(const Json& json) {
    std::string text;
    for (const Json& line : list_at(json, "rig")) {
        require(line.is_string(), "rig", "is no list of lines of text");
        text += line.get<std::string>() + "\n";
    }
    return text;
}

using RigReader = std::function<LightRig(const std::string& text)>;

/// Errors of the rig have the line of its text. Those of a file that it names keep that.
LightRig rig_from_lines(const std::string& text, const std::string& source, const RigReader& read) {
    try {
        return read(text);
    } catch (const Error& error) {
        if (error.file() != source) throw Error("", "rig", error.what());
        throw Error("", error.where().empty() ? "rig" : "rig, line " + error.where(),
                    error.reason());
    }
}

Analysis analysis_from(const std::string& text, const std::string& source,
                       const RigReader& read_rig_text) {
    const Json json = Json::parse(text);
    require(json.is_object() && json.contains("format") && json["format"] == format, "",
            std::string("is not of the format ") + format);
    require_known_keys(json, {"format", "views", "sections", "rig", "hidden", "notes"});
    Analysis analysis;
    for_each_of(json, "views",
                [&](const Json& view) { analysis.views.push_back(view_from(view)); });
    for_each_of(json, "sections", [&](const Json& section) {
        require(section.is_string(), "", "is no text");
        analysis.sections.push_back(section.get<std::string>());
    });
    if (json.contains("rig"))
        analysis.rig = rig_from_lines(rig_lines_from(json), source, read_rig_text);
    for_each_of(json, "hidden",
                [&](const Json& face) { analysis.hidden.push_back(hidden_from(face)); });
    for_each_of(json, "notes",
                [&](const Json& note) { analysis.notes.push_back(note_from(note)); });
    require_valid(analysis);
    return analysis;
}

bool is_plain_name(const std::string& name) {
    constexpr std::size_t longest = 64;
    return !name.empty() && name.size() <= longest &&
           std::all_of(name.begin(), name.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_';
           });
}

/// Throws Error for a view whose name is taken, is another view's, or names no file.
void require_name(std::span<const AnalysisView> views, std::size_t at) {
    const std::string& name = views[at].name;
    require(is_plain_name(name), "name",
            in_quotes(name) + " is not 1 to 64 letters, digits, hyphens and underscores");
    require(name != "auto" && name != "scene", "name", in_quotes(name) + " has another meaning");
    for (std::size_t i = 0; i < at; ++i)
        require(views[i].name != name, "name",
                in_quotes(name) + " is that of view " + std::to_string(i + 1) + ", too");
}

void require_look(const AnalysisView& view) {
    const std::string& look = view.look;
    const bool has_mode = look != "lamps" && look != "faces";
    const bool has_sections = has_mode && look_from(look).mode == AnalysisMode::section;
    require(!view.across || has_sections, "across", "is for the look curvature:section");
    require(!view.across || (view.across->length() > 0 && std::isfinite(view.across->length())),
            "across", "is no direction");
    require(!has_mode || look_from(look).mode != AnalysisMode::below_radius, "look",
            in_quotes(look) + " needs a radius, which no analysis holds");
}

void require_views(std::span<const AnalysisView> views) {
    for (std::size_t i = 0; i < views.size(); ++i)
        with_errors_named("", "views " + std::to_string(i + 1), [&] {
            require_name(views, i);
            require_look(views[i]);
        });
}

void require_sections(std::span<const std::string> sections) {
    for (std::size_t i = 0; i < sections.size(); ++i)
        with_errors_named("", "sections " + std::to_string(i + 1), [&] {
            section_plane(sections[i]);
            require(std::count(sections.begin(), sections.end(), sections[i]) == 1, "",
                    in_quotes(sections[i]) + " stands there twice");
        });
}

Json hidden_json(const HiddenFace& hidden) {
    Json json{{"face", hidden.face}};
    if (!hidden.name.empty()) json["name"] = hidden.name;
    if (hidden.place) json["place"] = point(*hidden.place);
    return json;
}

Json note_json(const AnalysisNote& note) {
    Json json{{"text", note.text}, {"place", point(note.place)}};
    if (note.face > 0) json["face"] = note.face;
    return json;
}

Json lines_of(const std::string& text) {
    Json lines = Json::array();
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

template <class Entries, class ToJson>
Json array_of(const Entries& entries, const ToJson& to_json) {
    Json array = Json::array();
    for (const auto& entry : entries) array.push_back(to_json(entry));
    return array;
}

} // namespace

Analysis read_analysis(const std::filesystem::path& file) {
    const std::string text = read_text_file(file);
    Analysis analysis = with_errors_named(file.string(), "", [&] {
        return analysis_from(text, file.string(),
                             [&](const std::string& rig) { return parse_rig(rig, file.string()); });
    });
    analysis.file = file.string();
    return analysis;
}

Analysis parse_analysis_alone(const std::string& text, const std::string& source) {
    return with_errors_named(source, "", [&] {
        return analysis_from(text, source,
                             [&](const std::string& rig) { return parse_rig_alone(rig, source); });
    });
}

void require_valid(const Analysis& analysis) {
    require_views(analysis.views);
    require_sections(analysis.sections);
    constexpr std::size_t longest = 1000;
    for (std::size_t i = 0; i < analysis.notes.size(); ++i) {
        const std::string& text = analysis.notes[i].text;
        require(!text.empty() && text.size() <= longest, "notes " + std::to_string(i + 1),
                "needs a text of 1 to 1000 bytes");
    }
}

std::string analysis_text(const Analysis& analysis, const std::filesystem::path& folder) {
    const auto view_json = [](const AnalysisView& view) {
        Json entry{{"name", view.name}, {"look", view.look}, {"camera", camera_json(view.camera)}};
        if (view.across) entry["across"] = point(*view.across);
        return entry;
    };
    Json json{{"format", format},
              {"views", array_of(analysis.views, view_json)},
              {"sections", analysis.sections}};
    if (analysis.rig) json["rig"] = lines_of(rig_text(*analysis.rig, folder));
    json["hidden"] = array_of(analysis.hidden, hidden_json);
    json["notes"] = array_of(analysis.notes, note_json);
    return text_of(json);
}

} // namespace keiko
