#include "keiko/drawing/hidden/piercings.h"

#include "keiko/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// Distance from an end of the curve, of the body's size, within which nothing is pierced.
constexpr double at_end = 1e-5;
/// Length of the way to an end that may run within the gap of a seam, in at_end and gap.
constexpr double flattest = 100;
/// Parameters of the curve within which piercings of a face are one.
constexpr double same_piercing = 1e-9;

class PiercingSearch {
public:
    PiercingSearch(const ModelCurve& curve, const Tracer& tracer)
        : curve_(curve), tracer_(tracer), end_(at_end * tracer.bounds().size() + curve.reach) {}

    std::vector<Piercing> run() const {
        std::vector<FacePiercing> found;
        const std::vector<Vec3>& points = curve_.course.points;
        std::vector<Ray> chords;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            chords.push_back(chord(points[i], points[i + 1]));
        const std::vector<bool> met = tracer_.any(chords);
        for (std::size_t i = 0; i < chords.size(); ++i) {
            if (!met[i]) continue;
            for (const Hit& hit : tracer_.all(chords[i]))
                if (const auto piercing = refined(hit, static_cast<double>(i)))
                    found.push_back({*piercing, {hit.instance, hit.face}});
        }
        return each_once(std::move(found));
    }

private:
    struct FacePiercing {
        Piercing at;
        PlacedFace face;
    };

    /// By rising parameter. One at a point of the curve is found by both chords that meet there.
    static std::vector<Piercing> each_once(std::vector<FacePiercing> found) {
        std::stable_sort(
            found.begin(), found.end(),
            [](const FacePiercing& a, const FacePiercing& b) { return a.at.t < b.at.t; });
        std::vector<Piercing> once;
        for (std::size_t i = 0; i < found.size(); ++i) {
            bool repeated = false;
            for (std::size_t k = i; k-- > 0 && found[i].at.t - found[k].at.t <= same_piercing;)
                repeated |= found[k].face == found[i].face;
            if (!repeated) once.push_back(found[i].at);
        }
        return once;
    }

    static Ray chord(const Vec3& from, const Vec3& to) {
        Ray ray;
        ray.origin = from, ray.direction = to - from, ray.t_max = 1;
        return ray;
    }

    bool is_own(const Hit& hit) const {
        const PlacedFace face{hit.instance, hit.face};
        return std::find(curve_.faces.begin(), curve_.faces.end(), face) != curve_.faces.end();
    }

    /// True for a hit at an end of the curve: near it, or so flat that the end itself is no deeper
    /// below the face than the curve may lie beside its own. Faces that overlap by the gap of
    /// their seam are pierced so by the edges that end on it, and hide nothing.
    bool is_at_end(const Hit& hit) const {
        const std::vector<Vec3>& points = curve_.course.points;
        const auto ends_at = [&](const Vec3& end) {
            const Vec3 way = end - hit.position;
            return way.length() <= end_ || (way.length() <= flattest * end_ &&
                                            std::abs(way.dot(hit.normal)) <= curve_.reach);
        };
        return ends_at(points.front()) || ends_at(points.back());
    }

    /// The piercing near a hit of the chord that begins at a point of the curve, by ever shorter
    /// chords about it. Those of a level cover a whole chord of the level before to either side: a
    /// flat crossing of the exact curve may lie that far from the chord's.
    std::optional<Piercing> refined(const Hit& hit, double begin) const {
        if (is_own(hit) || is_at_end(hit)) return std::nullopt;
        Piercing found{begin + hit.t, hit.normal};
        constexpr int levels = 8, chords = 8; // chords then deviate less than rounding
        double length = 1;
        for (int level = 0; level < levels; ++level) {
            length /= chords / 2;
            std::optional<Piercing> nearest;
            for (int i = 0; i < chords; ++i) {
                const auto here = on_chord(hit, found.t + (i - chords / 2) * length, length);
                if (here &&
                    (!nearest || std::abs(here->t - found.t) < std::abs(nearest->t - found.t)))
                    nearest = here;
            }
            if (!nearest) break;
            found = *nearest;
        }
        return found;
    }

    /// The piercing of the face of a hit by the chord from a parameter on.
    std::optional<Piercing> on_chord(const Hit& other, double from, double length) const {
        const double low = std::max(from, 0.0), high = std::min(from + length, curve_.course.end());
        if (!(low < high)) return std::nullopt;
        const Ray ray = chord(curve_.course.at(low), curve_.course.at(high));
        for (const Hit& hit : tracer_.all(ray))
            if (hit.instance == other.instance && hit.face == other.face)
                return Piercing{low + hit.t * (high - low), hit.normal};
        return std::nullopt;
    }

    const ModelCurve& curve_;
    const Tracer& tracer_;
    double end_; ///< mm
};

} // namespace

std::vector<ModelCurve> find_piercings(std::vector<ModelCurve> curves, const Tracer& tracer,
                                       const Job& job) {
    parallel_for(curves.size(), job, "", [&](std::size_t i) {
        curves[i].piercings = PiercingSearch(curves[i], tracer).run();
    });
    return curves;
}

} // namespace keiko
