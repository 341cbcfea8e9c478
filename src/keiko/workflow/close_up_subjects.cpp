#include "keiko/workflow/close_up_subjects.h"

#include "keiko/scene/view.h"
#include "keiko/triage/standing_eyes.h"
#include "keiko/workflow/seen_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

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

/// The views by whose names faults are ordered.
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

    /// True if the subject is a new one that is shown. Faces may have one at each of several
    /// places.
    bool add(CloseUp::Of of, std::uint32_t index, const Vec3& place, bool of_places = false) {
        const auto is_same = [&](const CloseUpSubject& one) {
            return one.of == of && one.index == index && (!of_places || one.place == place);
        };
        if (is_full() || std::any_of(all_.begin(), all_.end(), is_same)) return false;
        auto camera = best_camera(scene_, views_, place);
        if (!camera) camera = best_camera(scene_, others_, place);
        if (camera) all_.push_back({of, index, place, *camera});
        return camera.has_value();
    }
    bool is_full() const { return all_.size() >= most_; }
    const std::vector<CloseUpSubject>& all() const { return all_; }

private:
    const Scene& scene_;
    std::span<const NamedView> views_;
    std::vector<NamedView> others_; ///< for what those do not show
    std::size_t most_;
    std::vector<CloseUpSubject> all_;
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
        if (item.face != no_index) subjects.add(CloseUp::Of::face, item.face, item.place, true);
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

} // namespace

std::vector<CloseUpSubject> close_up_subjects(const Scene& scene, const Report& report,
                                              std::span<const NamedView> views, std::size_t most) {
    Subjects subjects(scene, views, most);
    add_first_screen(report, subjects);
    add_others(report, subjects);
    return subjects.all();
}

} // namespace keiko
