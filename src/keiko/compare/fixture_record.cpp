#include "keiko/compare/fixture_record.h"

#include "keiko/base/error.h"

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

/// Subject of a metric, "face 3" of "face 3: area", and the rest of its name.
struct Split {
    std::string_view subject, rest;
};

Split split(const Metric& metric) {
    const std::string_view name = metric.name;
    const std::size_t colon = name.rfind(": ");
    if (colon == std::string_view::npos) return {name, {}};
    return {name.substr(0, colon), name.substr(colon)};
}

using Subjects = std::map<Key, std::vector<const Metric*>>; ///< by check and subject

/// The metrics that the other list does not have.
Subjects lone_subjects(std::span<const Metric> metrics, const std::map<Key, const Metric*>& other) {
    Subjects lone;
    for (const Metric& metric : metrics)
        if (!other.contains(key_of(metric)))
            lone[{metric.check, split(metric).subject}].push_back(&metric);
    return lone;
}

bool differ_by_name_alone(const std::vector<const Metric*>& a, const std::vector<const Metric*>& b,
                          const MetricTolerances& tolerances) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [&](const Metric* x, const Metric* y) {
               return x->check == y->check && split(*x).rest == split(*y).rest &&
                      !difference_between(*x, *y, tolerances[y->quantity]);
           });
}

/// The metrics with the names that the later list has for the same things.
std::vector<Metric> renamed(std::span<const Metric> before, std::span<const Metric> after,
                            const MetricTolerances& tolerances) {
    std::map<Key, std::string_view> names; // of subjects
    Subjects fresh = lone_subjects(after, by_key(before));
    for (const auto& old : lone_subjects(before, by_key(after))) {
        const auto found = std::find_if(fresh.begin(), fresh.end(), [&](const auto& candidate) {
            return differ_by_name_alone(old.second, candidate.second, tolerances);
        });
        if (found == fresh.end()) continue;
        names[old.first] = found->first.second;
        fresh.erase(found);
    }
    std::vector<Metric> all(before.begin(), before.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto [subject, rest] = split(before[i]);
        const auto name = names.find({before[i].check, subject});
        if (name != names.end()) all[i].name = std::string(name->second) + std::string(rest);
    }
    return all;
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

std::vector<MetricDifference> metric_differences(std::span<const Metric> baseline,
                                                 std::span<const Metric> after,
                                                 const MetricTolerances& tolerances) {
    const std::vector<Metric> before = renamed(baseline, after, tolerances);
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

namespace {

/// "depth, normal"
std::string layer_list(const Film& film) {
    std::string text = "color";
    for (const auto& [aov, image] : film.aovs) text += ", " + std::string(name_of(aov));
    return text;
}

PictureDifference picture_difference(const std::string& view, const FixturePicture* before,
                                     const FixturePicture* after, const FilmTolerance& tolerance) {
    PictureDifference found{view, "", {}};
    if (!before || !after) {
        found.problem = before ? "is no view of the fixture any more" : "is not in the baseline";
        return found;
    }
    const std::string layers_before = layer_list(before->film),
                      layers_after = layer_list(after->film);
    if (layers_before != layers_after)
        found.problem = "has the layers " + layers_after + "; the baseline has " + layers_before;
    try {
        found.film = film_difference(before->film, after->film, tolerance);
    } catch (const Error& error) {
        found.problem = error.reason();
    }
    if (!found.problem.empty()) found.film.reset();
    return found;
}

} // namespace

const FixtureEye* FixtureSetup::eye(const std::string& asked, int width, int height) const {
    const auto found = std::find_if(eyes.begin(), eyes.end(), [&](const FixtureEye& e) {
        return e.asked == asked && e.camera.width == width && e.camera.height == height;
    });
    return found == eyes.end() ? nullptr : &*found;
}

const FixturePicture* FixtureRecord::picture(const std::string& view) const {
    const auto found = std::find_if(pictures.begin(), pictures.end(),
                                    [&](const FixturePicture& p) { return p.view == view; });
    return found == pictures.end() ? nullptr : &*found;
}

bool FixtureDifference::within() const {
    return metrics.empty() &&
           std::all_of(pictures.begin(), pictures.end(),
                       [](const PictureDifference& picture) { return picture.within(); });
}

FixtureDifference fixture_difference(const FixtureRecord& before, const FixtureRecord& after,
                                     const FixtureSpec& spec) {
    FixtureDifference difference;
    difference.metrics = metric_differences(before.metrics, after.metrics, spec.metric_tolerance);
    const auto gone = std::count_if(difference.metrics.begin(), difference.metrics.end(),
                                    [](const MetricDifference& metric) { return !metric.after; });
    difference.metrics_compared = after.metrics.size() + static_cast<std::size_t>(gone);
    for (const FixturePicture& picture : after.pictures)
        difference.pictures.push_back(picture_difference(picture.view, before.picture(picture.view),
                                                         &picture, spec.film_tolerance));
    for (const FixturePicture& picture : before.pictures)
        if (!after.picture(picture.view))
            difference.pictures.push_back(
                picture_difference(picture.view, &picture, nullptr, spec.film_tolerance));
    return difference;
}

} // namespace keiko
