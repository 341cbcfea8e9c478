#include "keiko/inspect/seams/narrow_faces.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/inspect/seams/face_strips.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

class StripSearch {
public:
    StripSearch(const SurfaceModel& model, const PlacedFace& face,
                const std::vector<SeamSide>& sides, double join)
        : strips_(model, face, sides), face_(face), join_(join) {}

    std::optional<NarrowFace> run() {
        NarrowFace found{.face = face_};
        double negligible = 0;
        for (std::uint32_t i = 0; i < strips_.chords().size(); ++i) {
            const SeamSide& side = side_of(strips_.chords()[i]);
            if (!side.is_crease) continue;
            const double length = narrow_length(i, found);
            found.length += length;
            if (length > 0) negligible = std::max(negligible, side.negligible);
        }
        return found.length > negligible ? std::optional(found) : std::nullopt;
    }

private:
    const SeamSide& side_of(const SideChord& chord) const { return strips_.sides()[chord.side]; }
    double narrow_length(std::uint32_t i, NarrowFace& found);
    void take(const StripPlace& at, const SeamSide& near, double t, NarrowFace& found) const;

    FaceStrips strips_;
    PlacedFace face_;
    double join_;
};

/// mm of a chord along which the face has a strip; `found` takes the worst place.
double StripSearch::narrow_length(std::uint32_t i, NarrowFace& found) {
    const SideChord& from = strips_.chords()[i];
    std::vector<ParameterInterval> narrow;
    for (const std::uint32_t j : strips_.near(from.box().padded(join_))) {
        const SideChord& to = strips_.chords()[j];
        const SeamSide& near = side_of(from);
        if (side_of(to).is_crease && j <= i) continue; // found from there
        const auto part = part_beside(from, to, join_);
        if (!part) continue;
        const auto take_at = [&](double share) {
            const double t = from.t(share);
            const auto at = strips_.across(near.own.curve, t, to, join_);
            if (at) take(*at, near, t, found);
            return at.has_value();
        };
        if (!take_at((part->begin + part->end) / 2)) continue;
        narrow.push_back(*part);
        take_at(part->begin), take_at(part->end);
    }
    return IntervalSet(std::move(narrow)).measure() * from.length();
}

/// The frame of the seam's other side at a place.
std::optional<BoundaryFrame> beyond(const SeamSide& side, double t, const Vec3& place) {
    return side.beyond.curve.frame(parameter_beyond(side, t, place));
}

void StripSearch::take(const StripPlace& at, const SeamSide& near, double t,
                       NarrowFace& found) const {
    const SeamSide& far = strips_.sides()[at.side_far];
    const auto a = beyond(near, t, at.near.position);
    const auto b = beyond(far, at.t_far, at.far.position);
    const Vec3 way = at.far.position - at.near.position, run = at.near.tangent;
    double step = 0, angle = 0;
    if (a && b) {
        const auto across = [&](const Vec3& v) { return v - run * v.dot(run); };
        step = std::max(std::abs(way.dot(a->normal)), std::abs(way.dot(b->normal)));
        angle = radians_to_degrees(angle_between(across(-a->inward), across(b->inward)));
        if (angle <= angle_rounding) angle = 0;
    }
    if (found.width > 0 && step <= found.step) return;
    found.width = way.length(), found.step = step, found.angle = angle;
    found.place = (at.near.position + at.far.position) / 2;
    found.neighbours = {near.neighbour, far.neighbour};
}

} // namespace

std::vector<NarrowFace> narrow_faces(const ModelBorders& borders,
                                     std::span<const MeasuredSeam> seams,
                                     std::span<const Seam> pieces, double join, const Job& job) {
    const SeamSides sides(borders, seams, pieces);
    std::vector<const SeamSides::ByFace::value_type*> faces;
    for (const auto& face : sides.by_face()) faces.push_back(&face);
    std::vector<std::optional<NarrowFace>> found(faces.size());
    parallel_for(faces.size(), job, "", [&](std::size_t i) {
        const auto& [face, of_face] = *faces[i];
        StripSearch search(borders.model, {face.first, face.second}, of_face, join);
        found[i] = search.run();
    });
    std::vector<NarrowFace> narrow;
    for (const auto& strip : found)
        if (strip) narrow.push_back(*strip);
    return narrow;
}

} // namespace keiko
