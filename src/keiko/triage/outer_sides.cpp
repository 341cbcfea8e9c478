#include "keiko/triage/outer_sides.h"

#include "keiko/inspect/basics/material_places.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

using Samples = std::vector<AreaSample>;
using FaceKey = std::pair<std::uint32_t, std::uint32_t>; ///< instance and face

FaceKey key_of(const PlacedFace& face) {
    return {face.instance, face.face};
}

/// A few places of each patch of a face, where it is material, with normals along du x dv.
Samples samples_of(const SurfaceModel& model, const PlacedFace& placed) {
    constexpr int side = 3; // places a patch, each way
    const Face& face = model.faces[placed.face];
    const Affine& transform = model.instances[placed.instance].transform;
    Samples samples;
    each_material_place(model, face, side, [&](std::uint32_t patch, const Vec2& uv) {
        const SurfaceDerivatives s = evaluate(model.patch(patch), uv, 1);
        const Vec3 across = transform.vector(s.du()).cross(transform.vector(s.dv()));
        const double size = across.length();
        if (!(size > 0)) return;
        samples.push_back({transform.point(s.position()), across / size, size / (side * side)});
    });
    return samples;
}

/// Null without samples.
const AreaSample* nearest(const Samples& samples, const Vec3& place) {
    const auto closest =
        std::min_element(samples.begin(), samples.end(), [&](const auto& a, const auto& b) {
            return (a.place - place).length2() < (b.place - place).length2();
        });
    return closest == samples.end() ? nullptr : &*closest;
}

double area_of(const Samples& samples) {
    double area = 0;
    for (const AreaSample& sample : samples) area += sample.area;
    return area;
}

/// Faces of a body, and how their normals are oriented to each other.
class Skins {
public:
    Skins(const SurfaceModel& model, const Inspection& inspection) {
        for (const PlacedFace& face : placed_faces(model))
            samples_[key_of(face)] = samples_of(model, face);
        for (const MeasuredSeam& seam : inspection.seams)
            if (!seam.internal && !(seam.side_a() == seam.side_b())) join(seam);
    }

    /// The skin of most area: its faces with 1 or -1, by which their normals are on one side.
    std::map<FaceKey, double> largest() const {
        std::map<FaceKey, double> largest;
        std::map<FaceKey, bool> known;
        double most = 0;
        for (const auto& [face, samples] : samples_) {
            if (known[face]) continue;
            std::map<FaceKey, double> skin = skin_of(face);
            double area = 0;
            for (const auto& [member, sign] : skin)
                known[member] = true, area += area_of(samples_.at(member));
            if (area > most) most = area, largest = std::move(skin);
        }
        return largest;
    }
    const Samples& of(const FaceKey& face) const { return samples_.at(face); }
    /// Places of a skin, with normals on one side.
    Samples samples(const std::map<FaceKey, double>& skin) const {
        Samples all;
        for (const auto& [face, sign] : skin)
            for (AreaSample sample : samples_.at(face)) {
                sample.normal *= sign;
                all.push_back(sample);
            }
        return all;
    }

private:
    struct Neighbour {
        FaceKey face;
        double sign; ///< 1: both normals are on the same side
    };

    void join(const MeasuredSeam& seam) {
        constexpr double steep = 0.5; // cosine of 60 degrees
        const FaceKey a = key_of(seam.side_a()), b = key_of(seam.side_b());
        const AreaSample *of_a = nearest(of(a), seam.middle), *of_b = nearest(of(b), seam.middle);
        if (!of_a || !of_b) return;
        const double turn = of_a->normal.dot(of_b->normal);
        if (std::abs(turn) < steep) return;
        neighbours_[a].push_back({b, std::copysign(1.0, turn)});
        neighbours_[b].push_back({a, std::copysign(1.0, turn)});
    }
    std::map<FaceKey, double> skin_of(const FaceKey& first) const {
        std::map<FaceKey, double> skin{{first, 1}};
        std::vector<FaceKey> open{first};
        while (!open.empty()) {
            const FaceKey face = open.back();
            open.pop_back();
            const auto beside = neighbours_.find(face);
            if (beside == neighbours_.end()) continue;
            for (const Neighbour& next : beside->second)
                if (skin.try_emplace(next.face, skin[face] * next.sign).second)
                    open.push_back(next.face);
        }
        return skin;
    }

    std::map<FaceKey, Samples> samples_;
    std::map<FaceKey, std::vector<Neighbour>> neighbours_;
};

/// 1 if the normals point away from the middle of a skin, -1 if towards it, 0 if some do either.
double bulging_side(const Samples& samples) {
    constexpr double least = 0.5; // of the whole
    Vec3 middle(0);
    for (const AreaSample& sample : samples) middle += sample.place * sample.area;
    middle /= area_of(samples);
    double sum = 0, all = 0;
    for (const AreaSample& sample : samples) {
        const double away = (sample.place - middle).dot(sample.normal) * sample.area;
        sum += away, all += std::abs(away);
    }
    return std::abs(sum) > least * all ? std::copysign(1.0, sum) : 0;
}

/// mm2 that the views see on the side of the normals, times `side`.
double seen_area(const Samples& samples, double side, const StandingEyes& eyes) {
    std::vector<SightPlace> places(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        places[i].place = samples[i].place, places[i].outward = samples[i].normal * side;
    const std::vector<bool> shown = eyes.shown(places);
    double area = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (shown[i]) area += samples[i].area;
    return area;
}

} // namespace

OuterSides::OuterSides(const SurfaceModel& model, const Inspection& inspection,
                       const StandingEyes& eyes) {
    const Skins skins(model, inspection);
    const std::map<FaceKey, double> skin = skins.largest();
    const Samples samples = skins.samples(skin);
    double side = samples.empty() ? 0 : bulging_side(samples);
    if (side != 0 && 2 * seen_area(samples, side, eyes) < seen_area(samples, -side, eyes)) side = 0;
    for (const auto& [face, sign] : skin) faces_[face] = {sign * side, skins.of(face)};
}

Vec3 OuterSides::outward(const PlacedFace& face, const Vec3& normal) const {
    const auto found = faces_.find(key_of(face));
    return found == faces_.end() ? Vec3(0) : normal * found->second.side;
}

bool OuterSides::hold(const PlacedFace& face) const {
    return faces_.count(key_of(face)) > 0;
}

Vec3 OuterSides::outward_near(const PlacedFace& face, const Vec3& place) const {
    const auto found = faces_.find(key_of(face));
    if (found == faces_.end()) return Vec3(0);
    const AreaSample* sample = nearest(found->second.samples, place);
    return sample ? sample->normal * found->second.side : Vec3(0);
}

} // namespace keiko
