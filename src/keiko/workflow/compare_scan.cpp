#include "keiko/workflow/compare_scan.h"

#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/compare/scan/scan_map.h"
#include "keiko/files/scene/voxel_header.h"
#include "keiko/film/image_file.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/volumes/iso_points.h"
#include "keiko/volumes/read_voxels.h"
#include "keiko/workflow/choose_views.h"
#include "keiko/workflow/version.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr int automatic_views = 3;

void require_limits(const ScanLimits& limits) {
    if (limits.tolerance && !(*limits.tolerance >= 0 && std::isfinite(*limits.tolerance)))
        throw FieldError("tolerance", "must be 0 mm or more");
    if (!(limits.least_share >= 0 && limits.least_share <= 1))
        throw FieldError("least_share", "must be from 0 to 1");
}

void require_points(std::span<const Vec3> points, const std::string& scan) {
    if (points.empty()) throw Error(scan, "points", "there are none");
    if (!std::all_of(points.begin(), points.end(), is_finite))
        throw Error(scan, "points", "a coordinate is not finite");
}

PointAlignment aligned(std::span<const Vec3> points, const ClosestPointQuery& nominal,
                       const CompareScanOptions& options, const Job& job) try {
    return align_points(points, nominal, options.alignment, job);
} catch (const FieldError& error) {
    throw Error(options.scan, error.field(), error.reason());
}

/// Draws the map of each view. Adds views and pictures to the comparison.
void draw_maps(const Scene& nominal, std::span<const PointDeviation> points,
               const ScanViewsOptions& options, ScanComparison& comparison, JobSteps& steps) {
    const int width = options.width > 0 ? options.width : nominal.width;
    const int height = options.height > 0 ? options.height : nominal.height;
    const std::vector<NamedView> views =
        choose_views(nominal, options.views, automatic_views, width, height, steps.next(1));
    require_different_names(views);
    const ScanDeviation& d = comparison.deviation;
    const double most =
        round_scale(std::max({d.percent_99_9, comparison.limits.tolerance.value_or(0), 1e-9}));
    for (const NamedView& view : views) {
        const DeviationMap map = scan_map(nominal.tracer, view.camera, points,
                                          comparison.map_radius, steps.next(1, 1, view.name));
        const Image picture = signed_color_picture(map.distance, map.facing, {-most, most}, "mm");
        const std::string name = view.name + "-deviation.png";
        comparison.views.push_back({view.name, name, picture.width, picture.height});
        comparison.pngs[name] = encode_png(picture);
    }
}

} // namespace

std::vector<Vec3> read_voxel_surface(const std::filesystem::path& voxels, double value,
                                     double millimetres, const Job& job) {
    const VoxelFiles files = read_voxel_header(voxels);
    std::vector<Vec3> points = iso_points(read_voxels(files, {}, job), value);
    for (Vec3& point : points) point = (files.origin + files.spacing * point) * millimetres;
    return points;
}

ScanResult compare_points(const Scene& nominal, std::span<const Vec3> points,
                          const CompareScanOptions& options, const Job& job) {
    require_limits(options.limits), require_points(points, options.scan);
    const std::size_t views = !options.views                 ? 0
                              : options.views->views.empty() ? automatic_views
                                                             : options.views->views.size();
    constexpr double preparing = 1, aligning = 3, measuring = 6;
    JobSteps steps(job, preparing + aligning + measuring + 1 + static_cast<double>(views));
    const ClosestPointQuery query(placed_model(nominal.model), steps.next(preparing));
    const double size = material_bounds(nominal.model, job).size();
    ScanResult result;
    ScanComparison& comparison = result.comparison;
    comparison.tool_version = version(), comparison.nominal = source_of(nominal);
    comparison.scan = options.scan;
    comparison.limits = options.limits;
    constexpr double fiftieth = 0.02;
    comparison.reach = options.reach > 0 ? options.reach : fiftieth * size;
    for (const PlacedFace& face : query.body().origin)
        comparison.faces.push_back(placed_face_name(nominal.model, face.instance, face.face));
    const Job to_align = steps.next(aligning);
    if (options.align) comparison.alignment = aligned(points, query, options, to_align);
    const Affine motion = comparison.alignment ? comparison.alignment->rigid.motion : Affine{};
    result.points =
        point_deviations(points, motion, query, {.reach = comparison.reach}, steps.next(measuring));
    comparison.deviation =
        scan_deviation(result.points, comparison.faces.size(), options.limits.tolerance);
    comparison.map_radius = map_radius(result.points, size);
    if (options.views) draw_maps(nominal, result.points, *options.views, comparison, steps);
    return result;
}

FolderContent scan_files(const ScanComparison& comparison) {
    FolderContent files = comparison.pngs;
    files["compare.json"] = scan_json(comparison);
    files["compare.html"] = scan_html(comparison);
    return files;
}

} // namespace keiko
