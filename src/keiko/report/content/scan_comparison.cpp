#include "keiko/report/content/scan_comparison.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {

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

} // namespace keiko
