#pragma once

#include "keiko/base/export.h"
#include "keiko/compare/outlines/film_difference.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/fixture_spec.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A metric that is not what it was.
struct MetricDifference {
    std::string check, name;             ///< of the metric, as Metric
    Quantity quantity = Quantity::count; ///< that the metric states
    /// Values of the metric; nullopt: there is no such metric any more, or was none before.
    std::optional<std::variant<double, std::string>> before, after;
    double allowed = 0; ///< how far apart two numbers may be
};

/// Metrics that are farther apart than the tolerances, or in one list only; in the order of
/// `after`, then what is gone. Metrics belong together by check and name, which must be unique in a
/// list. A face or seam ("face 3" of "face 3: area") is the same as one that is gone if only its
/// name differs. Programs that write a part anew name and number as they like.
std::vector<MetricDifference> metric_differences(std::span<const Metric> before,
                                                 std::span<const Metric> after,
                                                 const MetricTolerances& tolerances);

/// "seams: face 1 | face 2: gap: 0.05 -> 0.06 mm, 0.01 more; 1e-05 allowed"
std::string text_of(const MetricDifference& difference);

/// A view of a fixture.
struct FixturePicture {
    std::string view; ///< name of the view
    Film film;        ///< its picture
};

/// The eye of a view that is framed by what is seen.
struct FixtureEye {
    std::string asked; ///< name in the fixture or its scene, as "front" or "auto"
    std::string view;  ///< name of the view
    Camera camera;     ///< of the view

    bool operator==(const FixtureEye&) const = default;
};

/// Views and lamps derived from the body, which must not follow it when it changes. A baseline
/// keeps them, so that whatever comes after is viewed from the same place, under the same lamps.
struct FixtureSetup {
    std::vector<FixtureEye> eyes; ///< of the views that are framed by the body
    std::string placed_rig;       ///< text of keiko-rig/1: lamps that were placed; else empty

    /// nullptr where that view was never rendered in this size.
    const FixtureEye* eye(const std::string& asked, int width, int height) const;
    bool operator==(const FixtureSetup&) const = default;
};

/// Record of a fixture: as its baseline keeps it, or as it is now.
struct FixtureRecord {
    std::vector<Metric> metrics;          ///< all of them, in order
    std::vector<FixturePicture> pictures; ///< one a view
    FixtureSetup setup{};                 ///< views and lamps that were derived from the body

    /// nullptr where it has no such view.
    const FixturePicture* picture(const std::string& view) const;
};

/// One view of two records.
struct PictureDifference {
    std::string view;                   ///< name of the view
    std::string problem;                ///< why the pictures could not be compared, or empty
    std::optional<FilmDifference> film; ///< nullopt if they could not be compared

    /// True if the pictures were compared and are within the tolerances.
    bool within() const { return film && film->within(); }
};

/// How two records of a fixture differ.
struct FixtureDifference {
    std::size_t metrics_compared = 0;        ///< of either
    std::vector<MetricDifference> metrics;   ///< those beyond their tolerance
    std::vector<PictureDifference> pictures; ///< every view of either

    /// True if all metrics and pictures are within their tolerances.
    bool within() const;
};

/// Holds a record against the one before, by the tolerances of the fixture. A view or a layer that
/// only one of them has is a difference.
FixtureDifference fixture_difference(const FixtureRecord& before, const FixtureRecord& after,
                                     const FixtureSpec& spec);

} // namespace keiko
