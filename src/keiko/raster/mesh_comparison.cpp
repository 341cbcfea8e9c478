#include "keiko/raster/mesh_comparison.h"

#include "keiko/base/units.h"
#include "keiko/math/nearest_rank.h"
#include "keiko/raster/mesh_shading.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double arcsec = 3600; // in a degree

SizeQuantiles quantiles_of(const std::vector<double>& sizes) {
    if (sizes.empty()) return {};
    return {nearest_rank(sizes, 0.5), nearest_rank(sizes, 0.99), nearest_rank(sizes, 1)};
}

/// Visits the pixels of two pictures of one view.
class Comparison {
public:
    Comparison(const MirrorPicture& truth, const MirrorPicture& mesh, const Camera& camera)
        : truth_(truth), mesh_(mesh), camera_(camera), prepared_(camera) {}

    MeshErrors result() {
        for (int y = 0; y < truth_.height; ++y)
            for (int x = 0; x < truth_.width; ++x) compare(x, y);
        errors_.pixels = quantiles_of(pixels_), errors_.on_part = quantiles_of(on_part_);
        errors_.at_lamps = quantiles_of(at_lamps_), errors_.normal = quantiles_of(normals_);
        return errors_;
    }

private:
    void compare(int x, int y) {
        const MirrorPixel &truth = truth_.at(x, y), &mesh = mesh_.at(x, y);
        if (truth.face != 0) ++errors_.body;
        if (is_compared(truth, mesh)) compare_lamps(x, y, truth, mesh);
        if (truth.face == mesh.face) return;
        FacePixels& kind = mesh.face == 0    ? errors_.missed
                           : truth.face == 0 ? errors_.added
                                             : errors_.other_face;
        ++kind.all;
        if (is_inside(x, y)) ++kind.inside;
    }

    /// True if all neighbours show one face in truth, or none.
    bool is_inside(int x, int y) const {
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, truth_.height - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, truth_.width - 1); ++i)
                if (truth_.at(i, j).face != truth_.at(x, y).face) return false;
        return true;
    }

    void compare_lamps(int x, int y, const MirrorPixel& truth, const MirrorPixel& mesh) {
        const double off = std::abs(mesh.coverage - truth.coverage);
        ++errors_.compared;
        if (off > wrong_coverage) ++errors_.wrong;
        if (off > reversed_coverage) ++errors_.reversed;
        if (!(truth.distance > 0)) return; // the surface's image of lamps is nowhere
        normals_.push_back(radians_to_degrees(normal_error(truth.met.normal, mesh.met.normal)) *
                           arcsec);
        const Ray ray = prepared_.ray(x + 0.5, y + 0.5);
        at_lamps_.push_back(mirror_displacement(ray, truth.met, mesh.met, truth.distance));
        if (!(truth.footprint > 0)) return;
        pixels_.push_back(at_lamps_.back() / truth.footprint);
        on_part_.push_back(pixels_.back() * pixel_on_part(ray, truth.met.t));
    }

    /// mm, edge of a pixel across the line of sight at a surface.
    double pixel_on_part(const Ray& ray, double t) const {
        if (camera_.projection == Projection::orthographic) return camera_.pixel_size();
        return camera_.pixel_size() * t * ray.direction.dot(axes_.forward);
    }

    const MirrorPicture &truth_, &mesh_;
    const Camera& camera_;
    PreparedCamera prepared_;
    CameraAxes axes_ = camera_.axes();
    MeshErrors errors_;
    std::vector<double> pixels_, on_part_, at_lamps_, normals_;
};

/// Luminance of the exact surface under a lamp at the eye, in one channel as `float`s of a picture.
Image headlight(const MirrorPicture& truth, const Camera& camera) {
    const PreparedCamera prepared(camera);
    Image image(truth.width, truth.height, 3);
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            const MirrorPixel& pixel = truth.at(x, y);
            if (pixel.face == 0) continue;
            const Vec3 sight = prepared.ray(x + 0.5, y + 0.5).direction;
            std::fill_n(image.pixel(x, y), 3,
                        static_cast<float>(std::abs(sight.dot(pixel.met.normal))));
        }
    return image;
}

/// Middle one of three pixels in a row whose ends show different facets.
struct BorderPlace {
    int x, y, dx, dy;

    /// Size of the second difference.
    double second_difference(const Image& luminance) const {
        const double before = *luminance.pixel(x - dx, y - dy), here = *luminance.pixel(x, y),
                     after = *luminance.pixel(x + dx, y + dy);
        return std::abs(before - 2 * here + after);
    }
};

std::vector<BorderPlace> border_places(const MeshView& view, const MirrorPicture& truth,
                                       const MirrorPicture& mesh) {
    std::vector<BorderPlace> places;
    const auto is_border = [&](const BorderPlace& p) {
        const std::uint32_t face = truth.at(p.x, p.y).face;
        for (int k = -1; k <= 1; ++k) {
            const int x = p.x + k * p.dx, y = p.y + k * p.dy;
            if (face == 0 || truth.at(x, y).face != face || mesh.at(x, y).face != face)
                return false;
        }
        return view.items().at(p.x - p.dx, p.y - p.dy) != view.items().at(p.x + p.dx, p.y + p.dy);
    };
    for (int y = 1; y + 1 < truth.height; ++y)
        for (int x = 1; x + 1 < truth.width; ++x)
            for (const BorderPlace& place : {BorderPlace{x, y, 1, 0}, BorderPlace{x, y, 0, 1}})
                if (is_border(place)) places.push_back(place);
    return places;
}

double p99_of(const std::vector<BorderPlace>& places, const Image& luminance) {
    std::vector<double> sizes;
    for (const BorderPlace& place : places) sizes.push_back(place.second_difference(luminance));
    return sizes.empty() ? 0 : nearest_rank(sizes, 0.99);
}

} // namespace

MeshErrors mesh_errors(const MirrorPicture& truth, const MirrorPicture& mesh,
                       const Camera& camera) {
    return Comparison(truth, mesh, camera).result();
}

FacetBands facet_bands(const MeshView& view, const MirrorPicture& truth, const MirrorPicture& mesh,
                       const Job& job) {
    const std::vector<BorderPlace> places = border_places(view, truth, mesh);
    FacetBands bands{places.size(), p99_of(places, headlight(truth, view.camera()))};
    const PlaceLight light = [](const ShadedPlace& lit) {
        return Rgb(std::abs(lit.eye.dot(lit.place.normal)));
    };
    for (const MeshShading shading :
         {MeshShading::constant, MeshShading::gouraud, MeshShading::phong})
        bands.mesh[static_cast<std::size_t>(shading)] =
            p99_of(places, shaded_mesh(view, shading, light, job));
    return bands;
}

} // namespace keiko
