#include "keiko/viewer/viewed_scene.h"

#include "keiko/api/light.h"
#include "keiko/api/model.h"
#include "keiko/base/job_steps.h"

#include <charconv>
#include <chrono>
#include <utility>

namespace keiko::viewer {

ViewedScene::ViewedScene(Scene scene, NamedView view, LightRig rig, CheckOptions check,
                         const std::optional<ReportFolder>& report)
    : scene_(std::move(scene)),
      view_(std::move(view)),
      check_(std::move(check)),
      rig_(std::move(rig)) {
    is_report_ = report.has_value();
    if (!report) return;
    own_views_ = report->views;
    remarks_ = report->changes;
    inspection_.value = report->report;
    faults_.value = report->faults;
}

ViewFacts ViewedScene::facts_of_view() const {
    ViewFacts facts = view_facts(scene_, view_);
    facts.own_views = own_views_;
    facts.remarks = remarks_;
    facts.against = against_.has_value();
    return facts;
}

LightRig ViewedScene::rig() const {
    const std::scoped_lock lock(rig_access_);
    return rig_;
}

void ViewedScene::set_rig(LightRig rig) {
    const std::scoped_lock lock(rig_access_);
    rig_ = std::move(rig);
}

NamedView ViewedScene::view_of(const ViewRequest& request) const {
    if (!request.camera) return view_;
    return {"page", *request.camera, 0};
}

LightRig ViewedScene::rig_of(const ViewRequest& request) const {
    return request.planes ? with_planes(rig(), *request.planes) : rig();
}

namespace {

/// A lock of a mutex that others may hold for long. Throws Cancelled.
std::unique_lock<std::timed_mutex> locked(std::timed_mutex& mutex, const Job& job) {
    constexpr std::chrono::milliseconds look{50};
    std::unique_lock lock(mutex, std::defer_lock);
    while (!lock.try_lock_for(look)) job.check();
    return lock;
}

} // namespace

DeepBuffer ViewedScene::deep(const ViewRequest& request, const DeepOptions& options,
                             const Job& job) const {
    return deep_view(scene_, seen_without(scene_, request.hidden), view_of(request).camera, options,
                     job);
}

std::optional<Occluders> ViewedScene::occluders(const std::vector<std::uint32_t>& hidden,
                                                const Job& job) {
    if (!scene_.occluders || hidden.empty()) return scene_.occluders;
    const auto lock = locked(part_access_, job);
    if (!part_ || part_->hidden != hidden)
        part_ = {hidden, *occluders_without(scene_, hidden, job)};
    return part_->occluders;
}

std::shared_ptr<const ReflectedLight> ViewedScene::reflected(const LightRig& rig, const Job& job) {
    if (!scene_.reflected) return nullptr;
    const std::string lamps = rig_text(rig);
    if (lamps == rig_text(*scene_.rig)) return scene_.reflected;
    const auto lock = locked(light_access_, job);
    if (!light_ || light_->rig != lamps)
        light_ = {lamps,
                  reflected_light(scene_, rig, read_solution(solution_), solution_.string())};
    return light_->light;
}

Film ViewedScene::still(const ViewRequest& request, const LightRig& rig, const Job& job) {
    const Tracer seen = seen_without(scene_, request.hidden);
    const std::optional<Occluders> shadows = occluders(request.hidden, job);
    const std::shared_ptr<const ReflectedLight> light = reflected(rig, job);
    const PictureScene part{seen,
                            scene_.seen_materials(),
                            rig,
                            scene_.background,
                            shadows ? &*shadows : nullptr,
                            scene_.maps.get(),
                            {},
                            scene_.volumes.get(),
                            light.get(),
                            request.hidden.empty() ? scene_.texels.get() : nullptr};
    return render_part(scene_, part, view_of(request).camera, {}, job);
}

template <class Value>
const Value& ViewedScene::Kept<Value>::get(const Job& job, const std::function<Value()>& make) {
    const auto lock = locked(making, job);
    if (!value) value = make();
    return *value;
}

std::string ViewedScene::facts(const Job& job) {
    return facts_.get(job, [&] {
        return facts_json(body_info(scene_.model, {.load = {}, .join = check_.join}, job));
    });
}

const Inspection& ViewedScene::judged(const Job& job) {
    return judged_.get(job, [&] { return check_scene(scene_, check_, job); });
}

std::string ViewedScene::inspection(const Job& job) {
    return inspection_.get(job, [&] { return inspection_json(judged(job), version()); });
}

namespace {

/// The number that decimal digits state; 0 for other words.
std::uint32_t number_of(const std::string& digits) {
    std::uint32_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto [rest, fault] = std::from_chars(digits.data(), end, number);
    return fault == std::errc() && rest == end ? number : 0;
}

/// Index of a stretch by its number.
std::uint32_t seam_of(std::uint32_t number, std::size_t count) {
    if (number < 1 || number > count)
        throw Error("request", "seam",
                    "must be the number of a stretch, 1 to " + std::to_string(count));
    return number - 1;
}

} // namespace

std::uint32_t ViewedScene::seam_of_report(std::uint32_t number,
                                          const Inspection& inspection) const {
    const auto seam = stretch_of_report(*inspection_.value, "report.json", number, inspection);
    if (!seam)
        throw Error("request", "seam " + std::to_string(number),
                    "is no stretch of the body as it is read now: state the options that the "
                    "inspection had, such as --preset and --join");
    return *seam;
}

std::string ViewedScene::profile(const std::string& digits, const Job& job) {
    if (is_report_ && !remarks_.empty())
        throw Error("request", "seam",
                    "the files have changed since the inspection: there are no profiles but those "
                    "of the faults in the report");
    const std::uint32_t number = number_of(digits);
    const Inspection& inspection = judged(job);
    const std::uint32_t seam =
        is_report_ ? seam_of_report(number, inspection) : seam_of(number, inspection.seams.size());
    return profiles_json(profiles_of(scene_.model, inspection, {&seam, 1}, job), inspection,
                         version());
}

std::string ViewedScene::section(const std::string& plane, const Job& job) const {
    const CombOptions options{.planes = {section_plane(plane)}, .join = check_.join};
    const FoundCombs found = comb_curves(scene_.model, options, job);
    return combs_json(found, options.planes, scene_.model, version());
}

namespace {

constexpr double judging = 20, following = 5, ordering = 3; // shares of the time

} // namespace

std::string ViewedScene::faults(const Job& job) {
    return faults_.get(job, [&] {
        JobSteps steps(job, judging + ordering);
        const Inspection& inspection = judged(steps.next_of_steps(judging));
        return faults_json(scene_faults(scene_, inspection, steps.next_of_steps(ordering)),
                           inspection, version());
    });
}

LineList ViewedScene::lines(const ViewRequest& request, const Job& job) const {
    LinesOptions options;
    options.preset = check_.preset, options.join = check_.join;
    return lines_in_view(scene_, rig_of(request), view_of(request), options, job);
}

std::string ViewedScene::faults_with_lines(const ViewRequest& request, const Job& job) {
    JobSteps steps(job, judging + following + ordering);
    const Inspection& geometry = judged(steps.next_of_steps(judging));
    const LineList lines = this->lines(request, steps.next_of_steps(following));
    const Inspection whole = with_lines(geometry, lines);
    return faults_json(scene_faults(scene_, whole, steps.next_of_steps(ordering)), whole,
                       version());
}

} // namespace keiko::viewer
