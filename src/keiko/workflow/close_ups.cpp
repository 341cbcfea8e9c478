#include "keiko/workflow/close_ups.h"

#include "keiko/base/job_steps.h"
#include "keiko/base/units.h"
#include "keiko/film/overlay.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/scene/view.h"
#include "keiko/triage/standing_eyes.h"
#include "keiko/workflow/analysis_picture.h"
#include "keiko/workflow/curve_painter.h"
#include "keiko/workflow/report_pictures.h"
#include "keiko/workflow/seen_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

namespace keiko {
namespace {

constexpr int close_up_width = 360, close_up_height = 240;

/// Cosine between a view's direction and the normal of a place, 0 to 1; 0 where it is hidden.
double squareness(const Scene& scene, const Camera& camera, const Vec3& place) {
    const auto hit = seen_place(scene, camera, place);
    if (!hit) return 0;
    return std::abs(hit->normal.dot((place - camera.eye).normalized()));
}

/// The camera that shows a place most squarely; nullopt if none does.
std::optional<Camera> best_camera(const Scene& scene, std::span<const NamedView> views,
                                  const Vec3& place) {
    double best = 0;
    const Camera* camera = nullptr;
    for (const NamedView& view : views)
        if (const double square = squareness(scene, view.camera, place); square > best)
            best = square, camera = &view.camera;
    return camera ? std::optional(*camera) : std::nullopt;
}

/// Camera at the same viewpoint, turned to the place and zoomed in.
Camera close_up_camera(const Scene& scene, const Camera& view, const Vec3& place) {
    Camera camera = view;
    camera.target = place;
    camera.width = close_up_width;
    camera.height = close_up_height;
    const double height = 0.08 * scene.tracer.bounds().size();
    const double distance = (place - view.eye).length();
    camera.vertical_fov = radians_to_degrees(2 * std::atan(height / (2 * distance)));
    camera.orthographic_height = height;
    return camera;
}

/// Subject of a close-up, and from where it is seen.
struct Subject {
    CloseUp::Of of;
    std::uint32_t index;
    Vec3 place;
    Camera view;
};

/// The views by which faults are ordered.
std::vector<NamedView> views_of_triage(const Scene& scene) {
    const Framing framing{.ground = scene.ground()};
    std::vector<NamedView> views;
    for (const std::string_view name : standing_views)
        views.push_back({std::string(name), frame_view(name, scene.tracer.bounds(), framing)});
    return views;
}

/// Subjects that a view shows, each once, `most` at most.
class Subjects {
public:
    Subjects(const Scene& scene, std::span<const NamedView> views, std::size_t most)
        : scene_(scene), views_(views), others_(views_of_triage(scene)), most_(most) {}

    /// True if the subject is a new one that is shown.
    bool add(CloseUp::Of of, std::uint32_t index, const Vec3& place) {
        const auto is_same = [&](const Subject& one) { return one.of == of && one.index == index; };
        if (is_full() || std::any_of(all_.begin(), all_.end(), is_same)) return false;
        auto camera = best_camera(scene_, views_, place);
        if (!camera) camera = best_camera(scene_, others_, place);
        if (camera) all_.push_back({of, index, place, *camera});
        return camera.has_value();
    }
    bool is_full() const { return all_.size() >= most_; }
    const std::vector<Subject>& all() const { return all_; }

private:
    const Scene& scene_;
    std::span<const NamedView> views_;
    std::vector<NamedView> others_; ///< for what those do not show
    std::size_t most_;
    std::vector<Subject> all_;
};

/// Something that may have a close-up.
struct Candidate {
    std::uint32_t index;
    Vec3 place;
};

std::vector<Candidate> seam_candidates(const Report& report) {
    const std::vector<MeasuredSeam>& seams = report.inspection.seams;
    std::vector<Candidate> found;
    for (const std::uint32_t seam : first_seams(report, seams.size()))
        found.push_back({seam, worst_place(seams[seam])});
    return found;
}

std::vector<Candidate> face_candidates(const Inspection& inspection) {
    std::vector<Candidate> found;
    for (const auto* checks : {&inspection.findings, &inspection.looks})
        for (const Check& check : *checks)
            if (check.face != no_index) found.push_back({check.face, check.worst.place});
    return found;
}

std::vector<Candidate> crossing_candidates(const Report& report) {
    std::vector<Candidate> found;
    if (!report.lines) return found;
    for (const CrossingPlace& place : ranked_crossings(*report.lines)) {
        const LineCrossing& crossing = place.in(*report.lines);
        if (*crossing.verdict == Verdict::pass) break;
        found.push_back({static_cast<std::uint32_t>(found.size()), crossing.place});
    }
    return found;
}

void add_first_screen(const Report& report, Subjects& subjects) {
    for (const ShownItem& item : shown_items(report)) {
        if (item.face != no_index) subjects.add(CloseUp::Of::face, item.face, item.place);
        if (item.seam == no_index) continue;
        const Vec3 worst = worst_place(report.inspection.seams[item.seam]);
        for (const Vec3& place : {item.place, worst})
            if (subjects.add(CloseUp::Of::seam, item.seam, place)) break;
    }
}

/// One of each kind in turn, until there are enough of them or no more.
void add_others(const Report& report, Subjects& subjects) {
    struct Kind {
        CloseUp::Of of;
        std::vector<Candidate> candidates;
        std::size_t next = 0;
        bool is_done() const { return next == candidates.size(); }
    };
    std::array<Kind, 3> kinds{{{CloseUp::Of::seam, seam_candidates(report)},
                               {CloseUp::Of::face, face_candidates(report.inspection)},
                               {CloseUp::Of::crossing, crossing_candidates(report)}}};
    const auto is_done = [](const Kind& kind) { return kind.is_done(); };
    while (!subjects.is_full() && !std::all_of(kinds.begin(), kinds.end(), is_done))
        for (Kind& kind : kinds)
            while (!kind.is_done()) {
                const Candidate& one = kind.candidates[kind.next++];
                if (subjects.add(kind.of, one.index, one.place)) break;
            }
}

/// cd/m², of the brightest lamp of a plane; 0 without any.
double brightest_lamp(const LightRig& rig) {
    double brightest = 0;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source))
            brightest = std::max(brightest, luminance(plane->luminance));
    return brightest;
}

/// Share of the middle of a picture that mirrors lamps: it is brighter than diffuse light on paint.
double mirroring_share(const Film& film, double brightest) {
    constexpr double mirrored = 0.01; // of the lamp; a clear coat reflects 0.04 and more
    const Image& color = film.color;
    int bright = 0, all = 0;
    for (int y = color.height / 4; y < color.height * 3 / 4; ++y)
        for (int x = color.width / 4; x < color.width * 3 / 4; ++x, ++all) {
            const float* pixel = color.pixel(x, y);
            const Rgb seen(double{pixel[0]}, double{pixel[1]}, double{pixel[2]});
            if (luminance(seen) > mirrored * brightest) ++bright;
        }
    return static_cast<double>(bright) / std::max(all, 1);
}

/// True if the middle of a picture shows edges of lamps, or if there are none to show.
bool shows_lamps(const Film& film, const LightRig& rig) {
    constexpr double least = 0.02;
    const double brightest = brightest_lamp(rig);
    const double share = mirroring_share(film, brightest);
    return !(brightest > 0) || (share > least && share < 1 - least);
}

/// A picture with a stretch as a row of dots, between which its reflection is seen.
Image with_dots(Image picture, const Film& film, const Camera& camera, const MeasuredSeam& seam) {
    constexpr double step = 2; // pixels
    const CurvePainter painter(film, camera);
    Overlay overlay;
    for (const std::vector<Vec3>& piece : seam.course) {
        const std::vector<Vec2> drawn = painter.drawn(piece, step);
        for (std::size_t i = 1; i < drawn.size(); i += 4)
            overlay.lines.push_back(
                {.points = {drawn[i - 1], drawn[i]}, .color = Rgb(1, 0.85, 0), .width = 2});
    }
    return with_overlay(std::move(picture), overlay);
}

/// The stripes of the lamps, or zebra where the place mirrors none.
Image picture_of(const Scene& scene, const LightRig& rig, const Camera& camera,
                 PictureOptions options, const MeasuredSeam* seam, const Job& job) {
    options.aovs = look_layers(AnalysisMode::zebra);
    options.aovs.push_back(Aov::depth);
    const Film film = render_to_show(scene, rig, camera, options, job);
    Image picture = shows_lamps(film, rig)
                        ? tone_mapped(film)
                        : analysis_picture(AnalysisMode::zebra, film, camera, rig);
    return seam ? with_dots(std::move(picture), film, camera, *seam) : picture;
}

} // namespace

std::vector<CloseUp> close_ups(const Scene& scene, const LightRig& rig, const Report& report,
                               std::span<const NamedView> views, const PictureOptions& options,
                               std::size_t most, const Job& job) {
    Subjects subjects(scene, views, most);
    add_first_screen(report, subjects);
    add_others(report, subjects);
    std::vector<CloseUp> pictures;
    for (const Subject& subject : subjects.all()) {
        const Camera camera = close_up_camera(scene, subject.view, subject.place);
        const std::string title = "close-up-" + std::to_string(pictures.size() + 1);
        const MeasuredSeam* seam =
            subject.of == CloseUp::Of::seam ? &report.inspection.seams[subject.index] : nullptr;
        const Image picture = picture_of(scene, rig, camera, options, seam, job);
        pictures.push_back({subject.of, subject.index, report_picture(title, picture, {})});
    }
    return pictures;
}

} // namespace keiko
