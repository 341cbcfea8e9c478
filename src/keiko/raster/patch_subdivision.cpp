#include "keiko/raster/patch_subdivision.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/raster/picture_map.h"
#include "keiko/raster/triangle_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace keiko {
namespace {

constexpr int band_rows = 32; // rows of a thread at a time
/// Extent in parameters below which a piece beside the eye is left out.
constexpr double smallest = 1e-4;

/// A patch in the picture, homogeneous: x and y in pixels, and the nearness of ScreenCorner. The
/// projection of a rational patch is a rational patch.
std::vector<Vec4> picture_points(const BezierPatchView& patch, const Affine& placed,
                                 const Camera& camera) {
    const PictureMap picture(camera);
    const bool perspective = camera.projection == Projection::perspective;
    std::vector<Vec4> points;
    for (const Vec4& p : patch.points) {
        const Vec3 place = placed.vector(Vec3(p.x, p.y, p.z)) + placed.translation * p.w;
        const Vec3 at = picture.at(place, p.w);
        points.emplace_back(at.x, at.y, perspective ? p.w : -picture.depth(place, p.w), at.z);
    }
    return points;
}

/// Pixels of a piece.
struct PieceExtent {
    PixelBox centres; ///< pixels whose centres lie in the box of its control points
    double size;      ///< the longer side of that box, pixels

    /// True if it counts as one pixel.
    bool is_pixel() const {
        return centres.first_x == centres.last_x && centres.first_y == centres.last_y && size <= 1;
    }
};

/// nullopt for a piece that may reach beside or behind the eye.
std::optional<PieceExtent> extent_of(const std::vector<Vec4>& points) {
    Box2 box;
    for (const Vec4& p : points) {
        if (!(p.w > 0)) return std::nullopt;
        box.extend(Vec2(p.x / p.w, p.y / p.w));
    }
    constexpr double far = 1e6; // beyond any picture
    const auto pixel = [&](double place) { return static_cast<int>(std::clamp(place, -far, far)); };
    return PieceExtent{{pixel(std::ceil(box.lower.x - 0.5)), pixel(std::ceil(box.lower.y - 0.5)),
                        pixel(std::floor(box.upper.x - 0.5)), pixel(std::floor(box.upper.y - 0.5))},
                       std::max(box.extent().x, box.extent().y)};
}

bool is_behind_eye(const std::vector<Vec4>& points) {
    return std::all_of(points.begin(), points.end(), [](const Vec4& p) { return !(p.w > 0); });
}

/// Draws the patches of a model into a band of a picture.
class BandPainter {
public:
    /// `seen`: the pieces of the whole picture. The window is as wide as that.
    BandPainter(const SurfaceModel& model, const std::vector<TrimRegion>& trims,
                const PixelBox& window, std::vector<PatchPiece>& seen)
        : model_(model),
          trims_(trims),
          window_(window),
          seen_(seen),
          nearness_(index(0, window.last_y + 1) - index(0, window.first_y),
                    -std::numeric_limits<double>::infinity()) {}

    void draw(std::uint32_t instance, std::uint32_t patch, const std::vector<Vec4>& points) {
        instance_ = instance, patch_ = patch, face_ = model_.patches[patch].face;
        divide(points, unit_square);
    }

private:
    /// Number of a pixel of the picture, row by row.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(window_.last_x + 1) +
               static_cast<std::size_t>(x);
    }

    BezierPatchView view_of(const std::vector<Vec4>& points) const {
        const Patch& patch = model_.patches[patch_];
        return {patch.degree_u, patch.degree_v, points};
    }

    void divide(const std::vector<Vec4>& points, const Box2& uv) {
        const auto extent = extent_of(points);
        if (!extent && (uv.size() < smallest || is_behind_eye(points))) return;
        if (extent && extent->centres.within(window_).empty()) return;
        if (extent && extent->is_pixel())
            return put(extent->centres.first_x, extent->centres.first_y, points, uv);
        Box2 low = unit_square, high = unit_square, low_uv = uv, high_uv = uv;
        const bool by_u = extent ? is_longer_along_u(points) : uv.extent().x >= uv.extent().y;
        const unsigned axis = by_u ? 0 : 1;
        low.upper[axis] = high.lower[axis] = 0.5;
        low_uv.upper[axis] = high_uv.lower[axis] = uv.center()[axis];
        divide(subpatch(view_of(points), low), low_uv);
        divide(subpatch(view_of(points), high), high_uv);
    }

    bool is_longer_along_u(const std::vector<Vec4>& points) const {
        const BezierPatchView view = view_of(points);
        const int n = view.degree_u, m = view.degree_v;
        const auto step = [&](int i, int j, int k, int l) {
            const Vec4 &a = view.point(i, j), &b = view.point(k, l);
            return Vec2(a.x * b.w - b.x * a.w, a.y * b.w - b.y * a.w).length();
        };
        return step(0, 0, n, 0) + step(0, m, n, m) >= step(0, 0, 0, m) + step(n, 0, n, m);
    }

    void put(int x, int y, const std::vector<Vec4>& points, const Box2& uv) {
        if (!trims_[face_].untrimmed() &&
            !trims_[face_].contains(model_.face_parameters(patch_, uv.center())))
            return;
        double& nearest = nearness_[index(x, y - window_.first_y)];
        const double own = evaluate(view_of(points), Vec2(0.5), 0).position().z;
        if (!(own > nearest)) return;
        nearest = own;
        seen_[index(x, y)] = {instance_, patch_, uv};
    }

    const SurfaceModel& model_;
    const std::vector<TrimRegion>& trims_;
    PixelBox window_;
    std::vector<PatchPiece>& seen_;
    std::vector<double> nearness_;
    std::uint32_t instance_ = 0, patch_ = 0, face_ = 0;
};

} // namespace

std::vector<PatchPiece> subdivided_pieces(const SurfaceModel& model, const Camera& camera,
                                          const Job& job) {
    std::vector<TrimRegion> trims;
    for (const Face& face : model.faces) trims.emplace_back(model, face);
    std::vector<PatchPiece> seen(static_cast<std::size_t>(camera.width) *
                                 static_cast<std::size_t>(camera.height));
    const int bands = (camera.height + band_rows - 1) / band_rows;
    parallel_for(static_cast<std::size_t>(bands), job, "subdivide", [&](std::size_t band) {
        const int first = static_cast<int>(band) * band_rows;
        const int last = std::min(first + band_rows, camera.height) - 1;
        BandPainter painter(model, trims, {0, first, camera.width - 1, last}, seen);
        for (std::uint32_t i = 0; i < model.instances.size(); ++i)
            for (std::uint32_t p = 0; p < model.patches.size(); ++p) {
                const Instance& instance = model.instances[i];
                if (model.faces[model.patches[p].face].part != instance.part) continue;
                check_stop();
                painter.draw(i, p, picture_points(model.patch(p), instance.transform, camera));
            }
    });
    return seen;
}

ItemBuffer subdivided_faces(const SurfaceModel& model, const Camera& camera, const Job& job) {
    const std::vector<PatchPiece> pieces = subdivided_pieces(model, camera, job);
    ItemBuffer faces(camera.width, camera.height);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (pieces[i].instance != no_index) faces.shown[i] = model.patches[pieces[i].patch].face;
    return faces;
}

} // namespace keiko
