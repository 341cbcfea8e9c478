#include "keiko/inspect/openings/face_area.h"

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/placed_face.h"

#include <algorithm>

namespace keiko {
namespace {

constexpr int lines = 8; ///< of a patch, and places of each stretch of a line

/// Adds the area of a patch by lines of constant v: of the stretches of each that are material.
class PatchArea {
public:
    PatchArea(const SurfaceModel& model, const PlacedFace& of, std::uint32_t patch,
              const TrimRegion& trims)
        : model_(model), of_(of), patch_(patch), trims_(trims) {}

    double all() const {
        double area = 0;
        for (int j = 0; j < lines; ++j) area += along((j + 0.5) / lines) / lines;
        return area;
    }

private:
    double along(double v) const {
        if (trims_.untrimmed()) return stretch(0, 1, v);
        const Patch& patch = model_.patches[patch_];
        std::vector<double> ends{0, 1};
        for (const double u : trims_.crossings(1, patch.map_v.to_face(v)))
            ends.push_back(std::clamp(patch.map_u.to_patch(u), 0.0, 1.0));
        std::sort(ends.begin(), ends.end());
        double sum = 0;
        for (std::size_t i = 1; i < ends.size(); ++i) {
            const Vec2 middle((ends[i - 1] + ends[i]) / 2, v);
            if (trims_.contains(model_.face_parameters(patch_, middle)))
                sum += stretch(ends[i - 1], ends[i], v);
        }
        return sum;
    }

    double stretch(double from, double to, double v) const {
        double sum = 0;
        for (int i = 0; i < lines && to > from; ++i) {
            const Vec2 uv(from + (to - from) * (i + 0.5) / lines, v);
            const SurfaceDerivatives s = placed_derivatives(model_, of_.instance, patch_, uv);
            sum += s.du().cross(s.dv()).length() * (to - from) / lines;
        }
        return sum;
    }

    const SurfaceModel& model_;
    const PlacedFace& of_;
    std::uint32_t patch_;
    const TrimRegion& trims_;
};

} // namespace

double rough_area(const SurfaceModel& model, const PlacedFace& of) {
    const Face& face = model.faces[of.face];
    const TrimRegion trims(model, face);
    double area = 0;
    for (std::uint32_t k = 0; k < face.patch_count; ++k)
        area += PatchArea(model, of, face.first_patch + k, trims).all();
    return area;
}

} // namespace keiko
