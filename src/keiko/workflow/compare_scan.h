#pragma once

#include "keiko/base/export.h"
#include "keiko/files/scan/scan_file.h"
#include "keiko/import/worker/axes_frame.h"
#include "keiko/report/content/scan_comparison.h"
#include "keiko/workflow/open_scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The views in which the deviations of a scan are mapped.
struct ScanViewsOptions {
    std::vector<std::string> views; ///< names; empty: three automatic ones of the nominal
    int width = 0, height = 0;      ///< pixels; 0: the size of the nominal's scene
};

/// Points on the surface of one value of voxels (keiko-voxels/1), mm: where it crosses the lines
/// between neighbouring nodes. `millimetres`: those in one unit of the file. Throws Error.
std::vector<Vec3> read_voxel_surface(const std::filesystem::path& voxels, double value,
                                     double millimetres = 1, const Job& job = {});

/// Options of compare_points.
struct CompareScanOptions {
    std::string scan{};  ///< file of the points, or what they are named in report and errors
    ScanLimits limits{}; ///< by which the points are judged
    bool align = true;   ///< moves the points onto the nominal first
    double reach = 0;    ///< mm; 0: a fiftieth of the nominal's size
    AlignmentOptions alignment{.samples = 20000, .most_steps = 60}; ///< of the points
    std::optional<ScanViewsOptions> views{};                        ///< none: numbers alone
};

/// A comparison, and the deviation of each point.
struct ScanResult {
    ScanComparison comparison;          ///< with its statistics and maps
    std::vector<PointDeviation> points; ///< in the order of the scan
};

/// Aligns points with the exact surface of a scene, and measures and judges how far they lie from
/// it. Throws Error for points that are none, not finite or too few to align, for limits out of
/// range, and for an unknown view; Cancelled.
ScanResult compare_points(const Scene& nominal, std::span<const Vec3> points,
                          const CompareScanOptions& options = {}, const Job& job = {});

/// compare.html, compare.json and the maps, for a folder.
FolderContent scan_files(const ScanComparison& comparison);

} // namespace keiko
