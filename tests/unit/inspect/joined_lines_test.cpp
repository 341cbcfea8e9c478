#include "keiko/base/error.h"
#include "keiko/base/units.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/seams/seam_measure.h"
#include "keiko/intersect/hit/reflect_ray.h"

#include "tests/support/paths.h"
#include "tests/unit/inspect/flawed_sheets.h"
#include "tests/unit/inspect/lamps_over_sheets.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

using test::folded_sheets;
using test::joined;
using test::lamps_turned;
using test::parallel_camera;
using test::plane_height;

/// Image of a camera ray that a plane mirrors: the place where it meets the C-plane, less its
/// start, in level.
Vec3 image_of(const Vec3& direction, const Vec3& normal) {
    const Vec3 ray = reflect(direction, normal);
    return ray * (plane_height / ray.z);
}

TEST(JoinedLines, JumpOverAFoldAsFarAsTheMirrorsTurnTheirImages) {
    const Vec3 direction = Vec3(0.2, 0.5, -1).normalized();
    const double fold = 0.4;
    const CPlane plane = lamps_turned(0.9);
    const CPlaneFrame frame(plane);
    const JoinedLines found = joined(folded_sheets(fold), plane, parallel_camera(direction));
    const double angle = degrees_to_radians(fold);
    const Vec3 first(0, 0, 1), second(0, std::sin(angle), std::cos(angle));
    const double jump = (image_of(direction, second) - image_of(direction, first)).dot(frame.v);
    int crossings = 0;
    for (const LineCrossing& crossing : found.crossings) {
        EXPECT_NEAR(crossing.place.y, 0, 1e-9);
        EXPECT_NEAR(crossing.place.z, 0, 1e-9);
        EXPECT_NEAR(crossing.angle, fold, 1e-9);
        EXPECT_NEAR(std::abs(crossing.plane_jump), std::abs(jump), 1e-8);
        EXPECT_LE(std::abs(crossing.turn.value), fold * 1.001);
        if (!crossing.continued()) continue; // by the end of the seam
        ++crossings;
        const double sign = found.pieces[crossing.from].face == 0 ? 1 : -1;
        EXPECT_NEAR(crossing.plane_jump, sign * jump, 1e-8);
        // Along the seam the field grows by frame.v.x a mm, so that the line moves against it.
        const Vec3 head = found.pieces[crossing.to].line.points.front().place;
        EXPECT_NEAR(head.x - crossing.place.x, -sign * jump / frame.v.x, 1e-7);
        EXPECT_LT(crossing.jump.bound, 1e-8);
        EXPECT_LT(crossing.kink.bound, 1e-7);
        EXPECT_LE(std::abs(crossing.jump.value), std::abs(head.x - crossing.place.x));
    }
    EXPECT_GT(crossings, 3);
}

/// A flat sheet that goes on smoothly in a cylinder about an axis below.
SurfaceModel sheet_and_cylinder(double radius) {
    test::ModelBuilder builder;
    test::flat_sheet(builder, {0, -100, 0});
    const double up = std::numbers::pi / 2;
    builder.rational_patch(1, 2, test::arc_sheet(-radius, radius, up, up - 100 / radius));
    return builder.build();
}

/// dv/dy beside the seam for a curvature across of `bend`; see docs/theory/reflection-lines.md.
double slope_across(const Vec3& d, const Vec3& v, double bend) {
    const Vec3 ray(d.x, d.y, -d.z), change = Vec3(0, -d.z, -d.y) * (2 * bend);
    return v.y + plane_height * (change.dot(v) / ray.z - ray.dot(v) * change.z / (ray.z * ray.z));
}

TEST(JoinedLines, KinkWhereACylinderFollowsAPlaneByTheRatioOfTheFieldsSlopes) {
    const Vec3 direction = Vec3(0.2, 0.5, -1).normalized();
    for (const double radius : {500.0, 5000.0}) {
        const CPlane plane = lamps_turned(0.9);
        const Vec3 v = CPlaneFrame(plane).v;
        CriteriaPreset preset;
        const JoinedLines found =
            joined(sheet_and_cylinder(radius), plane, parallel_camera(direction), preset);
        const double flat = std::atan2(slope_across(direction, v, 0), v.x);
        const double bent = std::atan2(slope_across(direction, v, 1 / radius), v.x);
        int crossings = 0;
        for (const LineCrossing& crossing : found.crossings) {
            if (!crossing.continued()) continue;
            ++crossings;
            const double sign = found.pieces[crossing.from].face == 0 ? 1 : -1;
            EXPECT_NEAR(degrees_to_radians(crossing.kink.value), sign * (bent - flat), 1e-9);
            EXPECT_NEAR(crossing.jump.value, 0, 1e-8);
            EXPECT_NEAR(crossing.plane_jump, 0, 1e-8);
            EXPECT_EQ(crossing.kink.limit, 5.7);
            EXPECT_EQ(crossing.kink.verdict, Verdict::fail);
        }
        EXPECT_GT(crossings, 3) << radius;
    }
}

/// Two cylinders that join smoothly on the x axis.
SurfaceModel two_cylinders(double first, double second) {
    test::ModelBuilder builder;
    const double up = std::numbers::pi / 2;
    builder.rational_patch(1, 2, test::arc_sheet(-first, first, up + 100 / first, up));
    builder.rational_patch(1, 2, test::arc_sheet(-second, second, up, up - 100 / second));
    return builder.build();
}

const LineCrossing& worst_crossing(const JoinedLines& found) {
    if (found.crossings.empty()) throw Error("", "", "no line crosses the seam");
    return found.crossings.front();
}

/// Fold that turns the image by `turn` where it does so most.
double fold_with_turn(double turn, const CPlane& plane, const Camera& camera) {
    double fold = turn;
    for (int i = 0; i < 4; ++i) {
        CriteriaPreset any;
        any.lines.turn = turn / 100;
        const JoinedLines found = joined(folded_sheets(fold), plane, camera, any);
        fold *= turn / std::abs(worst_crossing(found).turn.value);
    }
    return fold;
}

/// Each preset's limits: the planted angle and mismatch that they allow, 2 % less and 2 % more.
TEST(JoinedLines, VerdictsOfPlantedFaults) {
    const Vec3 direction = Vec3(0.2, 0.5, -1).normalized();
    const CPlane plane = lamps_turned(0.9);
    const Vec3 v = CPlaneFrame(plane).v;
    constexpr double radius = 1000;
    const auto kink_of = [&](double mismatch) { // mismatch = (R1 - R2) / (R1 + R2)
        const double other = radius * (1 - mismatch) / (1 + mismatch);
        return radians_to_degrees(
            std::abs(std::atan2(slope_across(direction, v, 1 / other), v.x) -
                     std::atan2(slope_across(direction, v, 1 / radius), v.x)));
    };
    for (const CriteriaPreset& preset : standard_presets()) {
        const Camera camera = parallel_camera(direction);
        const double fold = fold_with_turn(*preset.lines.turn, plane, camera);
        EXPECT_GT(fold, *preset.lines.turn);
        EXPECT_LT(fold, 2 * *preset.lines.turn);
        double low = 0, high = 0.9;
        for (int i = 0; i < 50; ++i)
            (kink_of((low + high) / 2) < preset.lines.kink.value_or(0) ? low : high) =
                (low + high) / 2;
        for (const double share : {0.98, 1.02}) {
            const Verdict verdict = share < 1 ? Verdict::pass : Verdict::fail;
            const JoinedLines folded = joined(folded_sheets(fold * share), plane, camera, preset);
            EXPECT_EQ(worst_crossing(folded).turn.verdict, verdict) << preset.name << fold;
            if (!preset.lines.kink) continue;
            const double other = radius * (1 - low * share) / (1 + low * share);
            const JoinedLines bent = joined(two_cylinders(radius, other), plane, camera, preset);
            EXPECT_EQ(worst_crossing(bent).kink.verdict, verdict) << preset.name << low;
            EXPECT_EQ(worst_crossing(bent).kink.limit, preset.lines.kink);
        }
        if (preset.lines.kink) {
            EXPECT_GE(low, std::sin(degrees_to_radians(*preset.lines.kink)) * 0.999)
                << "a smaller mismatch makes the kink that is the largest one";
        }
    }
}

/// Value where the camera ray through a place, mirrored by the tracer, meets the lamps' plane; and
/// the place that it mirrors at.
struct Traced {
    double value = 0;
    Vec3 place{0}, normal{0};
};

std::optional<Traced> traced(const Tracer& tracer, const CPlaneFrame& frame, const Camera& camera,
                             const Vec3& place) {
    Ray ray;
    ray.origin = camera.eye, ray.direction = (place - camera.eye).normalized();
    const std::optional<Hit> hit = tracer.nearest(ray);
    if (!hit) return std::nullopt;
    const Ray mirrored = reflect_ray(ray, *hit);
    const Vec3 from = frame.point(mirrored.origin), slope = frame.vector(mirrored.direction);
    return Traced{from.y - slope.y * from.z / slope.z, hit->position, hit->normal};
}

/// The traced place of the lamp's image beside a place, looked for along `across`.
std::optional<Traced> on_line(const Tracer& tracer, const CPlaneFrame& frame, const Camera& camera,
                              const Vec3& place, const Vec3& across, double level, double within) {
    double low = -within, high = within;
    const auto at = [&](double x) { return traced(tracer, frame, camera, place + across * x); };
    const auto first = at(low), last = at(high);
    if (!first || !last || (first->value < level) == (last->value < level)) return std::nullopt;
    const bool rises = first->value < level;
    std::optional<Traced> middle;
    for (int i = 0; i < 50; ++i) {
        middle = at((low + high) / 2);
        if (!middle) return std::nullopt;
        ((middle->value < level) == rises ? low : high) = (low + high) / 2;
    }
    return middle;
}

struct Side {
    Vec3 place{0}, tangent{0}, normal{0};
};

/// How the traced line leaves a place, from the places h, 2 h and 3 h away: the formula has the
/// error h^3 of the fourth derivative.
std::optional<Side> side_by_rays(const Tracer& tracer, const CPlaneFrame& frame,
                                 const Camera& camera, const Vec3& place, const Vec3& away,
                                 const Vec3& across, double level) {
    constexpr double h = 0.25;
    std::array<Vec3, 3> points;
    Vec3 normal(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const double step = h * static_cast<double>(i + 1);
        const auto found =
            on_line(tracer, frame, camera, place + away * step, across, level, 0.2 * step);
        if (!found) return std::nullopt;
        points[i] = found->place;
        if (i == 0) normal = found->normal;
    }
    const Vec3 tangent = (place * -11 + points[0] * 18 - points[1] * 9 + points[2] * 2) / (6 * h);
    const Vec3 start = points[0] * 3 - points[1] * 3 + points[2];
    return Side{start, tangent.normalized(), normal};
}

/// The seams of the fixtures run in the plane x = 0, so that a normal tells their direction.
double angle_to_seam(const Side& side, const Vec3& normal) {
    const Vec3 along = normal.cross(Vec3(1, 0, 0)).normalized();
    return std::atan2(normal.cross(along).dot(side.tangent), along.dot(side.tangent));
}

/// The surface z = -y^2 / 2 R + e y P(x), P odd about x0, is its own image turned by half a turn
/// about (x0, 0). So is the line of a lamp along y = 0, viewed from above: there it turns over.
TEST(JoinedLines, TurnOverWhereSymmetryHasIt) {
    constexpr double x0 = 17, s = 40;
    const test::Profile across{{-150, 150}, {test::shifted({0, -s * s, 0, 1}, -x0)}};
    const test::Profile along{{-150, 150}, {{0, 1}}};
    const SurfaceModel model = test::sheet(across, along, 2e-8, {0, -1e-3});
    constexpr int lamps = 101;
    const JoinedLines found =
        joined(model, lamps_turned(0, lamps), parallel_camera(Vec3(0, 0, -1)));
    const auto line = std::find_if(found.lines.begin(), found.lines.end(),
                                   [](const JoinedLine& l) { return l.lamp == lamps / 2; });
    ASSERT_NE(line, found.lines.end());
    ASSERT_EQ(line->inflections.size(), 1u);
    EXPECT_EQ(line->shapes.at(0).inflections.size(), 1u);
    const LineInflection& turn = line->inflections[0];
    EXPECT_NEAR(turn.place.x, x0, 1e-6);
    EXPECT_NEAR(turn.place.y, 0, 1e-9);
    EXPECT_NEAR(turn.place.z, 0, 1e-9);
    const std::vector<LinePoint>& points = found.pieces[line->pieces.at(0)].line.points;
    double gone = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const bool beyond = (points[i].place.x - x0) * (points[0].place.x - x0) < 0;
        gone += ((beyond ? turn.place : points[i].place) - points[i - 1].place).length();
        if (beyond) break;
    }
    EXPECT_NEAR(turn.along, gone, 1e-9);
}

TEST(JoinedLines, KinkAndJumpOnFixturesAsTracedRaysShowThem) {
    for (const char* name : {"seam-g1-angle", "seam-g1-only", "seam-g2-only"}) {
        const SurfaceModel model =
            load_model(test::repository("surfaces/" + std::string(name) + ".step"));
        const Tracer tracer(model);
        Camera camera;
        camera.eye = {-900, -700, 1400}, camera.target = Vec3(0);
        const CPlane plane = lamps_turned(0.6, 300);
        const CPlaneFrame frame(plane);
        const JoinedLines found = joined(model, plane, camera);
        int compared = 0;
        for (const LineCrossing& crossing : found.crossings) {
            if (!crossing.continued()) continue;
            const SurfaceLine &from = found.pieces[crossing.from],
                              &into = found.pieces[crossing.to];
            const Vec3 tail = crossing.place, head = into.line.points.front().place;
            const double level = frame.axis(static_cast<int>(crossing.lamp));
            const auto course_of = [&](const SurfaceLine& piece, bool first) {
                const auto& points = piece.line.points;
                const std::size_t n = points.size();
                return first ? (points[1].place - points[0].place).normalized()
                             : (points[n - 1].place - points[n - 2].place).normalized();
            };
            const Vec3 back = -course_of(from, false), on = course_of(into, true);
            const Vec3 up(0, 0, 1);
            const auto before =
                side_by_rays(tracer, frame, camera, tail, back, up.cross(back).normalized(), level);
            const auto after =
                side_by_rays(tracer, frame, camera, head, on, up.cross(on).normalized(), level);
            if (!before || !after) continue;
            ++compared;
            EXPECT_LE((before->place - tail).length(), 1e-6) << name << tail;
            EXPECT_LE((after->place - head).length(), 1e-6) << name << head;
            Side reversed = *before;
            reversed.tangent = -reversed.tangent;
            const double kink = std::remainder(
                angle_to_seam(*after, after->normal) - angle_to_seam(reversed, before->normal),
                2 * std::numbers::pi);
            EXPECT_NEAR(degrees_to_radians(crossing.kink.value), kink, 1e-5) << name << tail;
        }
        EXPECT_GT(compared, 3) << name;
    }
}

/// A crease of 17 degrees at x = 0 that fades without a corner to nothing at x = 100.
SurfaceModel fading_sheets() {
    test::ModelBuilder builder;
    test::flat_sheet(builder, {0, -100, 0});
    std::vector<Vec3> points;
    const double slopes[] = {0.3, 0.3, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = test::sheet_length * double(i) / 3;
        points.push_back({x, 0, 0});
        points.push_back({x, 100, -100 * slopes[i]});
    }
    builder.patch(3, 1, points);
    return builder.build();
}

TEST(JoinedLines, NoCrossingFailsWhereACreaseFadesOut) {
    const SurfaceModel model = fading_sheets();
    const CriteriaPreset preset;
    const auto seams = measure_seams(model, pair_seams(model, 0.5), preset, 0.5).seams;
    for (const MeasuredSeam& seam : seams) EXPECT_EQ(seam.verdict, Verdict::pass);
    const JoinedLines found =
        joined(model, lamps_turned(0.9), test::parallel_camera({0.1, 0.2, -1}), preset);
    int in_run_out = 0;
    for (const LineCrossing& crossing : found.crossings) {
        // Where the angle is within its limit lines may kink all the same: the seam's own curvature
        // does not count how its angle changes along it.
        if (crossing.angle <= preset.angle) continue;
        EXPECT_NE(crossing.verdict, Verdict::fail) << crossing.place.x;
        EXPECT_NE(crossing.verdict, Verdict::undecided) << crossing.place.x;
        in_run_out += crossing.run_out;
    }
    EXPECT_GT(in_run_out, 3);
}

} // namespace
} // namespace keiko
