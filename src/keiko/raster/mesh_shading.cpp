#include "keiko/raster/mesh_shading.h"

#include "keiko/base/parallel.h"
#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <array>
#include <vector>

namespace keiko {
namespace {

void put(Image& image, int x, int y, const Rgb& color) {
    float* pixel = image.pixel(x, y);
    pixel[0] = static_cast<float>(color.r);
    pixel[1] = static_cast<float>(color.g);
    pixel[2] = static_cast<float>(color.b);
}

/// Calls `shade`(x, y, triangle) for the pixels that show one, rows on several threads.
template <class Shade>
void each_pixel(const MeshView& view, const Job& job, const Shade& shade) {
    const ItemBuffer& items = view.items();
    parallel_for(static_cast<std::size_t>(items.height), job, "shade", [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < items.width; ++x)
            if (const std::uint32_t t = items.at(x, y); t != no_index) shade(x, y, t);
    });
}

/// Luminances of places that many pixels share, each computed once.
class SharedLight {
public:
    /// `of`(number) is the luminance of a place.
    template <class Of>
    SharedLight(const std::vector<bool>& needed, const Of& of, const Job& job)
        : luminance_(needed.size()) {
        constexpr std::size_t chunk = 256;
        parallel_for((needed.size() + chunk - 1) / chunk, job, "shade", [&](std::size_t c) {
            for (std::size_t i = c * chunk; i < std::min(needed.size(), (c + 1) * chunk); ++i)
                if (needed[i]) luminance_[i] = of(i);
        });
    }
    const Rgb& operator[](std::size_t i) const { return luminance_[i]; }

private:
    std::vector<Rgb> luminance_;
};

/// A place that no pixel is the centre of, seen from the eye.
ShadedPlace lit_place(const Camera& camera, const Vec3& position, const Vec3& normal) {
    const Vec3 sight = camera.projection == Projection::perspective
                           ? (position - camera.eye).normalized()
                           : camera.axes().forward;
    ShadedPlace lit;
    lit.place.position = position;
    lit.place.normal = normal.dot(sight) > 0 ? -normal : normal;
    lit.eye = -sight;
    lit.mirrored.origin = position, lit.mirrored.direction = reflect(sight, normal);
    return lit;
}

Image constant(const MeshView& view, const PlaceLight& light, const Job& job) {
    std::vector<bool> seen(view.mesh().triangles.size());
    for (const std::uint32_t t : view.items().shown)
        if (t != no_index) seen[t] = true;
    const auto of_triangle = [&](std::size_t t) {
        const auto triangle = static_cast<std::uint32_t>(t);
        ShadedPlace lit = lit_place(view.camera(), mixed(Vec3(1.0 / 3), view.corners(triangle)),
                                    view.facet_normal(triangle));
        lit.place.triangle = triangle;
        return light(lit);
    };
    const SharedLight shared(seen, of_triangle, job);
    Image image(view.items().width, view.items().height, 3);
    each_pixel(view, job, [&](int x, int y, std::uint32_t t) { put(image, x, y, shared[t]); });
    return image;
}

Image gouraud(const MeshView& view, const PlaceLight& light, const Job& job) {
    const SurfaceMesh& mesh = view.mesh();
    std::vector<bool> seen(mesh.positions.size());
    std::vector<std::uint32_t> triangle_of(mesh.positions.size()); // one that has the corner
    for (const std::uint32_t t : view.items().shown)
        if (t != no_index)
            for (const std::uint32_t corner : mesh.triangles[t])
                seen[corner] = true, triangle_of[corner] = t;
    const auto of_corner = [&](std::size_t c) {
        const Vec3& own = mesh.normals[c];
        ShadedPlace lit = lit_place(view.camera(), mesh.positions[c],
                                    own == Vec3(0) ? view.facet_normal(triangle_of[c]) : own);
        lit.place.triangle = triangle_of[c];
        return light(lit);
    };
    const SharedLight shared(seen, of_corner, job);
    Image image(view.items().width, view.items().height, 3);
    each_pixel(view, job, [&](int x, int y, std::uint32_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 weights = view.at(x, y)->weights;
        put(image, x, y, mixed(weights, std::array{shared[a], shared[b], shared[c]}));
    });
    return image;
}

Image phong(const MeshView& view, const PlaceLight& light, const Job& job) {
    Image image(view.items().width, view.items().height, 3);
    each_pixel(view, job, [&](int x, int y, std::uint32_t) {
        ShadedPlace lit{*view.at(x, y)};
        lit.eye = -view.camera().ray(x + 0.5, y + 0.5).direction;
        lit.mirrored = view.mirrored(x, y, lit.place);
        if (lit.place.normal.dot(lit.eye) < 0) lit.place.normal = -lit.place.normal;
        put(image, x, y, light(lit));
    });
    return image;
}

} // namespace

std::string_view name_of(MeshShading shading) {
    constexpr std::array<std::string_view, 3> names{"constant", "gouraud", "phong"};
    return names[static_cast<std::size_t>(shading)];
}

Image shaded_mesh(const MeshView& view, MeshShading shading, const PlaceLight& light,
                  const Job& job) {
    if (shading == MeshShading::constant) return constant(view, light, job);
    return shading == MeshShading::gouraud ? gouraud(view, light, job) : phong(view, light, job);
}

} // namespace keiko
