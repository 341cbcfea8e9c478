#include "keiko/drawing/hidden/curve_pieces.h"

#include "keiko/import/worker/load_model.h"
#include "keiko/scene/view.h"

#include "tests/support/drawn_body.h"
#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace keiko {
namespace {

/// Views from general directions, in which no two edges coincide.
constexpr std::array directions{std::array{-3.0, -2.0, 1.0}, std::array{2.1, 1.3, 1.7}};

/// Chord error as a share of the body's size.
constexpr double usual_error = 1e-5;
/// Chord error for Appel's count, which one crossing that chords miss makes wrong to the end of a
/// curve.
constexpr double fine_error = 1e-6;

test::DrawnBody drawn(const SurfaceModel& model, const std::array<double, 3>& towards_eye,
                      Projection projection, double chord_error = usual_error) {
    const Box3 box = hull_bounds(model);
    Camera camera = frame_direction({towards_eye[0], towards_eye[1], towards_eye[2]}, box);
    camera.projection = projection;
    camera.orthographic_height = box.size();
    return {model, camera, chord_error * box.size()};
}

/// How many places of the pieces of all curves a ray calls otherwise than their piece, and how many
/// it does not decide.
struct RayTally {
    std::size_t places = 0, wrong = 0, undecided = 0;
};

/// Whether a point of a curve is visible, by a rule of its own: nothing lies before it. Undecided
/// where the line of sight only grazes a surface, passes through the gap of a seam, or meets
/// something so near that the point may lie in it. The places just beside ends of pieces are such
/// where the curve goes behind its own face.
std::optional<bool> visible(const Vec3& point, const ModelCurve& curve,
                            const test::DrawnBody& body) {
    constexpr double itself = 1e-9, near = 1e-5, grazing = 0.01; // of the size; a cosine
    const Ray ray = body.projection.sight_line(point, 2 * body.sight.size() + 1);
    const double length = ray.direction.length();
    bool decided = true;
    std::vector<Hit> hits = body.tracer.all(ray);
    if (const auto first = body.tracer.nearest(ray)) hits.push_back(*first); // see Tracer::nearest
    for (const Hit& hit : hits) {
        const double before = (1 - hit.t) * length / body.sight.size();
        if (before < itself) continue;
        const double cosine = std::abs(ray.direction.dot(hit.normal)) / length;
        const double below = before * cosine * body.sight.size();
        if (cosine > grazing && before > near && below > 2 * curve.reach &&
            !has(hit.flags, HitFlags::seam))
            return false;
        decided = false;
    }
    return decided ? std::optional(true) : std::nullopt;
}

/// Rays at random places of a piece, in its middle and just beside its ends.
RayTally rays_along(const CurvePiece& piece, const ModelCurve& curve, const test::DrawnBody& body,
                    test::Random& random) {
    constexpr double way = 2e-5; // of the body's size
    const double longest = 0.1 * (piece.end - piece.begin);
    const auto step = [&](double t) {
        return std::min(longest, way * body.sight.size() / curve.course.derivative(t).length());
    };
    const double begin = piece.begin + step(piece.begin), end = piece.end - step(piece.end);
    std::vector<double> places{begin, (piece.begin + piece.end) / 2, end};
    for (std::size_t i = test::ray_count(5, 500); i > 0; --i)
        places.push_back(test::uniform(random, begin, end));
    RayTally tally;
    for (const double t : places) {
        ++tally.places;
        const auto by_ray = visible(curve.course.at(t), curve, body);
        if (!by_ray) ++tally.undecided;
        if (!by_ray || *by_ray == piece.visible) continue;
        ++tally.wrong;
        ADD_FAILURE() << name_of(curve.kind) << " of face " << curve.faces[0].face << " at "
                      << curve.course.at(t) << " is not " << piece.visible;
    }
    return tally;
}

RayTally rays_along(const test::DrawnBody& body) {
    test::Random random(7);
    RayTally sum;
    for (const ModelCurve* curve : body.curves())
        for (const CurvePiece& piece :
             pieces_by_rays(*curve, body.image.along(*curve), body.sight)) {
            const RayTally tally = rays_along(piece, *curve, body, random);
            sum.places += tally.places, sum.wrong += tally.wrong;
            sum.undecided += tally.undecided;
        }
    return sum;
}

/// mm of a curve on which counted pieces are not as those of rays.
double differing(const ModelCurve& curve, std::span<const CurvePiece> by_rays,
                 std::span<const CountedPiece> by_count) {
    double parameters = 0;
    for (const CurvePiece& a : by_rays)
        for (const CountedPiece& b : by_count)
            if (a.visible != (b.sheets == 0))
                parameters += std::max(0.0, std::min(a.end, b.end) - std::max(a.begin, b.begin));
    return parameters * curve.course.length() / curve.course.end();
}

class CurvePieces : public testing::TestWithParam<std::string> {
protected:
    SurfaceModel model() const {
        return load_model(test::repository("surfaces/" + GetParam() + ".step"));
    }
};

TEST_P(CurvePieces, AreAsRaysAlongThemTell) {
    const SurfaceModel body = model();
    for (const Projection projection : {Projection::perspective, Projection::orthographic})
        for (const auto& direction : directions) {
            const RayTally tally = rays_along(drawn(body, direction, projection));
            EXPECT_EQ(tally.wrong, 0u);
            EXPECT_LT(tally.undecided, tally.places / 2);
        }
}

TEST_P(CurvePieces, AgreeWithQuantitativeInvisibility) {
    const SurfaceModel fixture = model();
    for (const auto& direction : directions) {
        const test::DrawnBody body = drawn(fixture, direction, Projection::perspective, fine_error);
        for (const ModelCurve* curve : body.curves()) {
            const auto changes = body.image.along(*curve);
            const double off = differing(*curve, pieces_by_rays(*curve, changes, body.sight),
                                         pieces_by_count(*curve, changes, body.sight));
            EXPECT_LT(off, 1e-3) << name_of(curve->kind) << " of face " << curve->faces[0].face;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Fixtures, CurvePieces,
                         testing::Values("hood", "bored-block", "dent", "pole", "rational-sphere",
                                         "trimmed-two-holes", "shut-line", "concept-car"),
                         [](const auto& fixture) {
                             std::string name = fixture.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

class SharedCurvePieces : public testing::TestWithParam<std::string> {};

TEST_P(SharedCurvePieces, AreAsRaysAlongThemTell) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    const SurfaceModel model = load_model(test::shared_model(GetParam()));
    for (const auto& direction : directions) {
        const RayTally tally = rays_along(drawn(model, direction, Projection::perspective));
        EXPECT_EQ(tally.wrong, 0u) << "of " << tally.places;
        EXPECT_LT(tally.undecided, tally.places / 4) << "of " << tally.places;
    }
}

INSTANTIATE_TEST_SUITE_P(Panels, SharedCurvePieces, testing::Values("car-hood.brep"),
                         [](const auto& panel) {
                             std::string name = panel.param.substr(0, panel.param.find('.'));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace
} // namespace keiko
