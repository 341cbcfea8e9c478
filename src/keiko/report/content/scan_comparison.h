#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/compare/scan/point_alignment.h"
#include "keiko/compare/scan/scan_deviation.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Limits of the points of a scan.
struct ScanLimits {
    std::optional<double> tolerance{}; ///< mm, either way; nullopt: nothing is judged
    double least_share = 1;            ///< of the points that must be within it, 0 to 1
};

/// The map of the deviations in one view.
struct ScanView {
    std::string name; ///< of the view
    std::string map;  ///< name of its PNG file
    int width = 0;    ///< pixels of the map
    int height = 0;   ///< pixels of the map
};

/// Comparison of the points of a scan with the exact surface that they were measured on.
struct ScanComparison {
    std::string tool_version;                  ///< version of Keiko that compared
    std::string nominal;                       ///< file of the exact surface
    std::string scan;                          ///< file of the points, or what they were given as
    ScanLimits limits{};                       ///< by which the scan is judged
    std::optional<PointAlignment> alignment{}; ///< of the points, if they were aligned
    double reach = 0;                          ///< mm, beyond which the surface is not sought
    ScanDeviation deviation{};                 ///< of the points from the surface
    std::vector<std::string> faces{};          ///< names, as ScanDeviation::faces
    double map_radius = 0;                     ///< mm around a place whose points a map averages
    std::vector<ScanView> views{};             ///< one a view
    FolderContent pngs{};                      ///< that the views name

    /// Whether the share of points within the tolerance suffices; nullopt without a tolerance.
    std::optional<bool> passes() const;
};

/// "pass", "fail" or "not judged".
std::string verdict_of(const ScanComparison& comparison);
/// "99.2 % of 12000 points within 0.1 mm; 95 % needed", or that there is no tolerance.
std::string verdict_reason(const ScanComparison& comparison);

/// "99.2 % of the points used", and the directions that the surface leaves free, if there are any.
std::string fit_words(const PointAlignment& alignment);

/// The comparison for people, in a few lines; the same text for any number of threads.
std::string scan_text(const ScanComparison& comparison);
/// The comparison as "keiko-scan/1"; see docs/file-formats.md. It holds no times: every run gives
/// the same bytes.
std::string scan_json(const ScanComparison& comparison);
/// The comparison as a self-contained page, pictures included: verdict first.
std::string scan_html(const ScanComparison& comparison);
/// The histogram of the deviations as SVG for a page; empty without measured points.
std::string histogram_svg(const ScanComparison& comparison);

} // namespace keiko
