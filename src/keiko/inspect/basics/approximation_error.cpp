#include "keiko/inspect/basics/approximation_error.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Markov's inequality: the largest first, second and third derivative over [0, 1] of a polynomial
/// of degree 9 that is at most 1 there. Of what patches of degree 8 leave out, that degree is the
/// largest part.
constexpr double first = 2 * 81, second = 4 * 81 * 80 / 3.0, third = 8 * 81 * 80 * 77 / 15.0;

/// mm, of the unplaced face: the shorter of a patch's lengths along u and along v, halfway across.
double width_of(const BezierPatchView& patch) {
    const auto length = [&](const Vec2& along) {
        const Vec2 across(0.5 - along.x / 2, 0.5 - along.y / 2);
        const Vec3 middle = evaluate(patch, Vec2(0.5), 0).position();
        return (evaluate(patch, across, 0).position() - middle).length() +
               (evaluate(patch, across + along, 0).position() - middle).length();
    };
    return std::min(length({1, 0}), length({0, 1}));
}

} // namespace

bool has_irregular_patch(const SurfaceModel& model, std::uint32_t face) {
    const auto by_face = [](const IrregularPatch& patch, std::uint32_t f) {
        return patch.face < f;
    };
    const auto found = std::lower_bound(model.irregular_patches.begin(),
                                        model.irregular_patches.end(), face, by_face);
    return found != model.irregular_patches.end() && found->face == face;
}

double scale_of(const Instance& instance) {
    return std::cbrt(std::abs(instance.transform.determinant()));
}

ApproximationError approximation_error(const SurfaceModel& model, std::uint32_t index,
                                       double scale) {
    const Face& face = model.faces[index];
    if (!(face.approximated > 0) || has_irregular_patch(model, index)) return {};
    double width = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < face.patch_count; ++k)
        width = std::min(width, width_of(model.patch(face.first_patch + k)));
    width *= scale;
    const double off = scale * face.approximated;
    return {off, radians_to_degrees(std::atan(first * off / width)), second * off / (width * width),
            third * off / (width * width * width)};
}

} // namespace keiko
