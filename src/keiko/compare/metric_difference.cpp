#include "keiko/compare/metric_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

namespace keiko {
namespace {

using Value = std::variant<double, std::string>;
using Key = std::pair<std::string_view, std::string_view>;

Key key_of(const Metric& metric) {
    return {metric.check, metric.name};
}

std::map<Key, const Metric*> by_key(std::span<const Metric> metrics) {
    std::map<Key, const Metric*> found;
    for (const Metric& metric : metrics) found[key_of(metric)] = &metric;
    return found;
}

/// Infinite where one of them is no number, so that it is never within a tolerance.
double distance(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double apart = std::abs(a - b);
    return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

double allowed_between(double a, double b, const MetricTolerance& tolerance) {
    const double size = std::max(std::abs(a), std::abs(b));
    return tolerance.absolute + (std::isfinite(size) ? tolerance.relative * size : 0);
}

std::optional<MetricDifference> difference_between(const Metric& before, const Metric& after,
                                                   const MetricTolerance& tolerance) {
    MetricDifference found{after.check, after.name, after.quantity, before.value, after.value, 0};
    const double *a = std::get_if<double>(&before.value), *b = std::get_if<double>(&after.value);
    if (before.quantity != after.quantity || !a || !b)
        return before.value == after.value && before.quantity == after.quantity
                   ? std::nullopt
                   : std::optional(found);
    found.allowed = allowed_between(*a, *b, tolerance);
    if (distance(*a, *b) <= found.allowed) return std::nullopt;
    return found;
}

std::string number(double value, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string text_of_value(const std::optional<Value>& value) {
    if (!value) return "none";
    const double* real = std::get_if<double>(&*value);
    return real ? number(*real, "%.9g") : std::get<std::string>(*value);
}

/// ", 0.01 more; 1e-05 allowed" of two numbers.
std::string change_text(const MetricDifference& d) {
    const double* a = d.before ? std::get_if<double>(&*d.before) : nullptr;
    const double* b = d.after ? std::get_if<double>(&*d.after) : nullptr;
    if (!a || !b) return "";
    return ", " + number(std::abs(*b - *a), "%.3g") + (*b > *a ? " more; " : " less; ") +
           number(d.allowed, "%.3g") + " allowed";
}

} // namespace

std::vector<MetricDifference> metric_differences(std::span<const Metric> before,
                                                 std::span<const Metric> after,
                                                 const MetricTolerances& tolerances) {
    std::vector<MetricDifference> differences;
    std::map<Key, const Metric*> left = by_key(before);
    for (const Metric& metric : after) {
        const auto found = left.find(key_of(metric));
        if (found == left.end()) {
            differences.push_back({metric.check, metric.name, metric.quantity, {}, metric.value});
            continue;
        }
        if (auto changed = difference_between(*found->second, metric, tolerances[metric.quantity]))
            differences.push_back(std::move(*changed));
        left.erase(found);
    }
    for (const Metric& metric : before)
        if (left.contains(key_of(metric)))
            differences.push_back({metric.check, metric.name, metric.quantity, metric.value, {}});
    return differences;
}

std::string text_of(const MetricDifference& difference) {
    std::string text = difference.check + ": " + difference.name + ": " +
                       text_of_value(difference.before) + " -> " + text_of_value(difference.after);
    const std::string_view unit = unit_of(difference.quantity);
    if (!unit.empty()) text += " " + std::string(unit);
    return text + change_text(difference);
}

} // namespace keiko
