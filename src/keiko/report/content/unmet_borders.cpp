#include "keiko/report/content/unmet_borders.h"

#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

/// mm; shorter gaps between seams that follow each other along a border are rounding.
constexpr double least_length = 0.05;

} // namespace

std::string unmet_borders(const ModelFacts& facts) {
    if (facts.free_length < least_length) return "";
    return fixed_number(facts.free_length, 1) + " of " + fixed_number(facts.border_length, 1) +
           " mm of borders meet no other";
}

std::string nothing_judged(const Inspection& inspection) {
    const std::size_t faces = inspection.facts.placed_faces;
    if (faces < 2 || !inspection.seams.empty()) return "";
    return "no seam was judged: of " + std::to_string(faces) +
           " faces no two have borders that run along each other within the join distance, " +
           short_number(inspection.join) + " mm";
}

} // namespace keiko
