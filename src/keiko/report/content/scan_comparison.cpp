#include "keiko/report/content/scan_comparison.h"

#include "keiko/base/text.h"
#include "keiko/report/content/comparison.h"
#include "keiko/report/markup/html_text.h"

#include <cmath>

namespace keiko {
namespace {

/// "shifts along (1, 0, 0) and (0, 1, 0)"; empty without directions.
std::string free_words(const std::string& kind, const std::vector<Vec3>& directions) {
    std::vector<std::string> triples;
    const auto without_rounding = [](double x) { return std::abs(x) < 1e-9 ? 0 : x; };
    for (const Vec3& v : directions)
        triples.push_back(
            triple({without_rounding(v.x), without_rounding(v.y), without_rounding(v.z)}, 6));
    std::string words;
    for (std::size_t i = 0; i < triples.size(); ++i)
        words += (i == 0 ? kind : i + 1 < triples.size() ? ", " : " and ") + triples[i];
    return words;
}

} // namespace

std::optional<bool> ScanComparison::passes() const {
    if (!limits.tolerance) return std::nullopt;
    constexpr double rounding = 1e-12; // of both shares
    return deviation.within && *deviation.within >= limits.least_share * (1 - rounding);
}

std::string verdict_of(const ScanComparison& c) {
    const auto passes = c.passes();
    if (!passes) return "not judged";
    return *passes ? "pass" : "fail";
}

std::string verdict_reason(const ScanComparison& c) {
    const ScanDeviation& d = c.deviation;
    if (!c.limits.tolerance) return counted(d.measured, "point") + " measured, without a tolerance";
    if (!d.within) return "no point lies above or below the nominal";
    const std::size_t judged = d.measured + d.beyond;
    constexpr int digits = 5;
    return short_number(100 * *d.within, digits) + " % of " + counted(judged, "point") +
           " within " + short_number(*c.limits.tolerance) + " mm; " +
           short_number(100 * c.limits.least_share, digits) + " % needed";
}

std::string fit_words(const PointAlignment& a) {
    std::string words = short_number(100 * a.used) + " % of the points used";
    if (a.free.empty()) return words;
    const std::string shifts = free_words("shifts along ", a.free.shifts);
    const std::string turns = free_words("turns about ", a.free.turns);
    return words + "; left free and not moved: " + shifts +
           (shifts.empty() || turns.empty() ? "" : ", ") + turns;
}

} // namespace keiko
