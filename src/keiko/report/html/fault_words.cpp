#include "keiko/report/html/fault_words.h"

#include "keiko/report/markup/html_text.h"
#include "keiko/triage/fault_units.h"
#include "keiko/triage/reflection_break.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <vector>

namespace keiko {
namespace {

/// The effect of a fault on the stripe of a lamp, with its width.
std::string effect_of(const TriageItem& fault) {
    constexpr double coarse = 10; // arc minutes
    if (fault.mending == Mending::position && fault.width >= lamp_width)
        return "counts as a whole stripe torn away";
    const std::string width =
        fixed_number(fault.width, fault.width < coarse ? 1 : 0) + "′ (arc minutes)";
    if (fault.fine)
        return "changes a stripe's width by at most " + width + ", less than an eye resolves";
    if (fault.mending == Mending::position) return "counts as a tear of a stripe by " + width;
    return (fault.torn ? "tears a stripe by up to " : "changes a stripe's width by up to ") + width;
}

/// The mending of a fault in words.
std::string_view task_of(const TriageItem& fault) {
    if (fault.fine) return "one job for the design: a lead-in, at the largest radius first";
    switch (fault.mending) {
        case Mending::position:
            return "mend the position";
        case Mending::tangent:
            return "mend the tangent";
        case Mending::curvature:
            return "mend the curvature";
        case Mending::layout:
            break;
    }
    return "mend the layout";
}

/// ", 96 % of it visible"; empty where all is.
std::string visible_text(double share) {
    const std::string percent = fixed_number(100 * share, 0);
    return percent == "100" ? "" : ", " + percent + " % of it visible";
}

/// A finding in a few words: those of a seam by what jumps there.
std::string short_text(const Check& check) {
    const std::string value = short_number(check.worst.value, 3);
    if (check.opening_length > 0) return "hole, " + value + " mm wide";
    if (is_of_lines(check)) return "reflections of lamps break";
    if (check.seam == no_index) return check.message;
    if (check.code == "G-SU-LG") return "gap of " + value + " mm";
    if (check.code == "G-SU-NT") return "kink of " + value + "°";
    if (check.code == "G-SU-NS") return "curvature jump";
    return check.message;
}

/// The findings of a fault, those that are to be mended first and those furthest beyond their
/// limits before the others. Those of lines follow those of what the lines cross.
std::vector<const Check*> first_to_mend(const TriageItem& fault, const Inspection& inspection) {
    std::vector<const Check*> checks;
    for (const std::size_t number : fault.findings)
        checks.push_back(&numbered_check(inspection, number));
    const auto rank = [](const Check* check) {
        const double share = share_of_limit(check->worst);
        return std::tuple(mending_of(*check), is_of_lines(*check), std::isnan(share) ? 0 : -share);
    };
    std::stable_sort(checks.begin(), checks.end(),
                     [&](const Check* a, const Check* b) { return rank(a) < rank(b); });
    return checks;
}

/// Findings of one seam or face, in words.
struct Others {
    std::string faces, text;
    std::size_t count = 0;
};

/// The findings of a fault without its worst one, at most two different ones a seam or face.
/// Lines that break follow from what else a seam has.
std::vector<Others> other_findings(const TriageItem& fault, const Inspection& inspection) {
    constexpr std::size_t most = 2;
    const Check* worst = &numbered_check(inspection, fault.findings.front());
    std::vector<Others> others;
    for (const Check* check : first_to_mend(fault, inspection)) {
        const std::string text = short_text(*check);
        const bool is_of_worst = check->faces == worst->faces;
        if (is_of_worst && (text == short_text(*worst) || is_of_lines(*check))) continue;
        const auto known = std::find_if(others.begin(), others.end(), [&](const Others& any) {
            return any.faces == check->faces;
        });
        if (known == others.end())
            others.push_back({check->faces, text, 1});
        else if (known->count < most && known->text != text && !is_of_lines(*check))
            known->text += ", " + text, ++known->count;
    }
    return others;
}

/// Number of holes of a fault that a hole leads; 0 for others.
std::size_t holes_of(const TriageItem& fault, const Inspection& inspection) {
    const auto is_hole = [&](std::size_t number) {
        return numbered_check(inspection, number).opening_length > 0;
    };
    if (!is_hole(fault.findings.front())) return 0;
    return static_cast<std::size_t>(
        std::count_if(fault.findings.begin(), fault.findings.end(), is_hole));
}

/// mm: the smaller radius across a stretch, where its curvatures differ most; 0 if it is not known.
double radius_at(const MeasuredSeam& seam) {
    if (!seam.curvature) return 0;
    const double most =
        std::max(std::abs(seam.curvature->curvature_a), std::abs(seam.curvature->curvature_b));
    return most > 0 ? 1 / most : 0;
}

/// The first stretches of a fault by falling radius, the radius with each: "seam 15 (R 40 mm)".
std::string by_radius(const TriageItem& fault, const Inspection& inspection) {
    std::vector<std::uint32_t> seams = fault.seams;
    std::stable_sort(seams.begin(), seams.end(), [&](std::uint32_t a, std::uint32_t b) {
        return radius_at(inspection.seams[a]) > radius_at(inspection.seams[b]);
    });
    constexpr std::size_t most = 10;
    const std::size_t others = seams.size() - std::min(seams.size(), most);
    seams.resize(seams.size() - others);
    std::string text;
    for (const std::uint32_t seam : seams) {
        const double radius = radius_at(inspection.seams[seam]);
        text += (text.empty() ? "seam " : ", seam ") + std::to_string(seam + 1);
        if (radius > 0)
            text += " (R " + (radius < 1000 ? short_number(radius, 3) : fixed_number(radius, 0)) +
                    " mm)";
    }
    if (others > 0) text += "; and " + std::to_string(others) + " more";
    return text;
}

/// The third of an interval in which a number lies, in words.
std::string_view third(double at, double lower, double upper, std::string_view low,
                       std::string_view middle, std::string_view high) {
    const double share = upper > lower ? (at - lower) / (upper - lower) : 0.5;
    return 3 * share < 1 ? low : 3 * share > 2 ? high : middle;
}

} // namespace

std::string message_of_worst(const Check& worst) {
    if (!(worst.opening_length > 0)) return worst.message;
    return "no surface between free edges, " + short_number(worst.worst.value, 3) + " x " +
           short_number(worst.opening_length, 3) + " mm: build what is missing";
}

std::string fault_title(const TriageItem& fault, const Inspection& inspection) {
    if (fault.fine) return "Tangent only (G2), too fine for an eye";
    if (const std::size_t holes = holes_of(fault, inspection); holes > 0)
        return holes == 1 ? "Hole" : std::to_string(holes) + " holes";
    const bool is_of_seams = !fault.seams.empty();
    switch (fault.mending) {
        case Mending::position:
            return is_of_seams ? "Gap (G0)" : "Position";
        case Mending::tangent:
            if (fault.left_of_crease > 0) return "Crease that ends (G1)";
            return is_of_seams ? "Kink (G1)" : "Kink";
        case Mending::curvature:
            return is_of_seams ? "Curvature jump (G2)" : "Form";
        case Mending::layout:
            break;
    }
    return "Layout of patches";
}

std::string words_of_place(const Vec3& place, const Box3& body) {
    const Vec3 &low = body.lower, &up = body.upper;
    std::string words(third(place.x, low.x, up.x, "front", "middle", "rear"));
    const std::string_view side = third(place.y, low.y, up.y, "left", "", "right");
    if (!side.empty()) words += " " + std::string(side);
    return words + std::string(third(place.z, low.z, up.z, ", low", "", ", high"));
}

std::string words_of_view(const std::string& view) {
    constexpr std::string_view standing = "standing-", side = "three-quarter-";
    std::string words = view.rfind(standing, 0) == 0 ? view.substr(standing.size()) : view;
    const bool is_between = words.rfind(side, 0) == 0;
    if (is_between) words.erase(0, side.size());
    std::replace(words.begin(), words.end(), '-', ' ');
    return is_between ? "three-quarter " + words : words;
}

std::string sight_text(const TriageItem& fault, const Inspection& inspection) {
    constexpr double least_width = 0.05; // arc minutes
    std::string text(task_of(fault));
    if (fault.patch != no_index)
        text += " · rebuild " + inspection.faces[fault.patch].name + ", most of whose seams fail";
    if (fault.left_of_crease > 0)
        text += " · a crease fades to " + short_number(fault.left_of_crease, 3) +
                "° and ends: let it run out or keep it sharp";
    if (fault.width >= least_width)
        text += " · " + effect_of(fault) + ", seen from " + words_of_view(fault.view);
    if (!fault.seams.empty())
        text += " · " + fixed_number(fault.length, 1) + " mm on " +
                std::to_string(fault.seams.size()) +
                (fault.seams.size() == 1 ? " seam" : " seams") + visible_text(fault.visible);
    if (fault.mirrored) text += " · on both sides";
    return text + " · weight " + fixed_number(fault.weight, fault.weight < 10 ? 1 : 0) + "′";
}

std::string also_text(const TriageItem& fault, const Inspection& inspection) {
    if (fault.fine) return by_radius(fault, inspection);
    constexpr std::size_t most = 5;
    const std::vector<Others> others = other_findings(fault, inspection);
    std::string text;
    for (std::size_t i = 0; i < std::min(others.size(), most); ++i)
        text += (text.empty() ? "also " : "; ") + others[i].faces + ": " + others[i].text;
    if (others.size() > most)
        text += "; and " + std::to_string(others.size() - most) + " more seams or faces";
    return text;
}

} // namespace keiko
