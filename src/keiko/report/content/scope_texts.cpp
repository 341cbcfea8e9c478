#include "keiko/report/content/scope_texts.h"

#include "keiko/base/text.h"

#include <algorithm>

namespace keiko {
namespace {

/// "; 3 stretches and 1 face pass by these alone"; empty if nothing does.
std::string excused_words(const ZoneFacts& zone) {
    std::string words;
    if (zone.excused_seams > 0)
        words = std::to_string(zone.excused_seams) +
                (zone.excused_seams == 1 ? " stretch" : " stretches") + " of seams";
    if (zone.excused_faces > 0)
        words += (words.empty() ? "" : " and ") + counted(zone.excused_faces, "face");
    if (words.empty()) return "";
    const bool one = zone.excused_seams + zone.excused_faces == 1;
    return "; " + words + (one ? " passes" : " pass") + " by these alone";
}

std::string zone_sentence(const ZoneFacts& zone, const CriteriaPreset& preset) {
    std::string text =
        "zone " + zone.name + ": " + counted(zone.faces, "face") + " (" + zone.selection + ")";
    if (zone.looser.empty()) return text + ", no limit looser than those of " + preset.name;
    return text + ", looser than " + preset.name + ": " + comma_list(zone.looser) +
           excused_words(zone);
}

template <class Test>
bool any_limits(const CriteriaPreset& preset, const Test& test) {
    return test(preset) || std::any_of(preset.zones.begin(), preset.zones.end(),
                                       [&](const Zone& zone) { return test(zone.limits); });
}

} // namespace

std::string scope_words(const std::optional<JudgedScope>& scope) {
    if (!scope || scope->selection.empty()) return "";
    return std::to_string(scope->faces) + " of " + counted(scope->all_faces, "face") + " judged (" +
           scope->selection + ")";
}

std::vector<std::string> scope_sentences(const std::optional<JudgedScope>& scope,
                                         const CriteriaPreset& preset) {
    std::vector<std::string> sentences;
    if (!scope) return sentences;
    if (!scope->selection.empty()) {
        std::string text =
            "out of scope, not judged: " + counted(scope->all_faces - scope->faces, "face") +
            " of " + std::to_string(scope->all_faces);
        if (scope->all_seams > 0)
            text += ", " + counted(scope->all_seams - scope->seams, "seam") + " of " +
                    std::to_string(scope->all_seams);
        sentences.push_back(text + "; judged: " + scope->selection);
    }
    for (const ZoneFacts& zone : scope->zones) sentences.push_back(zone_sentence(zone, preset));
    if (!scope->zones.empty())
        sentences.push_back("in no zone: " + counted(scope->zoneless, "face") +
                            ", judged by the limits of " + preset.name + " itself");
    return sentences;
}

bool judges_faces(const CriteriaPreset& preset) {
    return any_limits(
        preset, [](const CriteriaPreset& limits) { return limits.surface != SurfaceLimits{}; });
}

bool searches_flaws(const CriteriaPreset& preset) {
    return any_limits(preset,
                      [](const CriteriaPreset& limits) { return !limits.flaw_limits().empty(); });
}

bool judges_slopes(const CriteriaPreset& preset) {
    return any_limits(
        preset, [](const CriteriaPreset& limits) { return limits.curvature_slope.has_value(); });
}

std::string with_limit(const std::string& name, const std::string& limit,
                       const CriteriaPreset& preset) {
    return preset.zones.empty() ? name + limit : name;
}

} // namespace keiko
