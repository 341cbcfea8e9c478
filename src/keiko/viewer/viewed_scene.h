#pragma once

#include "keiko/api/check.h"
#include "keiko/api/lines.h"
#include "keiko/api/place.h"
#include "keiko/api/render.h"
#include "keiko/api/view.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keiko::viewer {

/// The state of the server: a scene with the view and the rig that it was opened with, and perhaps
/// an earlier revision of it. The rig may be replaced, nothing else. May be used by several
/// threads.
class ViewedScene {
public:
    /// `check`: how the geometry is judged once somebody asks. `report`: an inspection whose
    /// findings are shown instead.
    ViewedScene(Scene scene, NamedView view, LightRig rig, CheckOptions check,
                const std::optional<ReportFolder>& report = {});

    /// The scene.
    const Scene& scene() const { return scene_; }
    /// The view that it was opened with.
    const NamedView& view() const { return view_; }
    /// Shows an earlier revision beside the scene; to be called before anybody asks.
    void set_against(Scene earlier) { against_.emplace(std::move(earlier)); }
    /// Names the file of the scene's reflected light, for lamps at other levels than its own; to be
    /// called before anybody asks.
    void set_solution(std::filesystem::path file) { solution_ = std::move(file); }
    /// The earlier revision; null without one.
    const Scene* against() const { return against_ ? &*against_ : nullptr; }
    /// The deep buffer of a request, without the faces that it hides. Throws FieldError for a face
    /// that is not there, and Cancelled.
    DeepBuffer deep(const ViewRequest& request, const DeepOptions& options, const Job& job) const;
    /// Reflected light of the solution under a rig; null without a solution. Throws Error for lamps
    /// that differ from the solution's in more than levels, and Cancelled.
    std::shared_ptr<const ReflectedLight> reflected(const LightRig& rig, const Job& job);
    /// The picture of a request under a rig, without the faces that it hides. Shadows of the last
    /// faces left are kept, and reflected light is that of the whole scene. Throws as deep and
    /// reflected.
    Film still(const ViewRequest& request, const LightRig& rig, const Job& job);
    /// The scene as a page needs it, with the views and changed files of the report.
    ViewFacts facts_of_view() const;
    /// The analysis that it was opened with, "keiko-view-analysis/1".
    std::string analysis() const { return view_analysis_json(scene_.analysis, rig()); }
    /// The rig that is shown.
    LightRig rig() const;
    /// Shows other lamps.
    void set_rig(LightRig rig);

    /// The camera of a request, or that of the view.
    NamedView view_of(const ViewRequest& request) const;
    /// The rig with the rows of lamps that a request has.
    LightRig rig_of(const ViewRequest& request) const;
    /// Summary of the body, "keiko-model-facts/1". It is made once; who asks meanwhile waits.
    /// Throws Cancelled.
    std::string facts(const Job& job);
    /// The judged geometry, "keiko-inspection/1", made as the facts. Throws Error, and Cancelled.
    /// That of a report is its own text, "keiko-report/1".
    std::string inspection(const Job& job);
    /// The quantities along a stretch of a seam by its number, from 1, "keiko-profiles/1". Those of
    /// a report are measured anew on the opened body. Throws Error for another text, and for a
    /// stretch of a report that is not on the body or whose files have changed; and Cancelled.
    std::string profile(const std::string& digits, const Job& job);
    /// Its faults in the order of mending, "keiko-faults/1", made as the inspection.
    std::string faults(const Job& job);
    /// The reflection lines of a request's lamps in its view, judged as the geometry is. Throws
    /// Error for lamps without lines, and Cancelled.
    LineList lines(const ViewRequest& request, const Job& job) const;
    /// The faults of the judged geometry and of the reflection lines of a request's lamps in its
    /// view, "keiko-faults/1". Throws Cancelled.
    std::string faults_with_lines(const ViewRequest& request, const Job& job);
    /// The sections of the body with a plane such as "y=120" and their curvature combs,
    /// "keiko-combs/1". Throws Error for other words, and Cancelled.
    std::string section(const std::string& plane, const Job& job) const;

private:
    /// A value that takes long.
    template <class Value>
    struct Kept {
        std::timed_mutex making;
        std::optional<Value> value{};

        /// The value, by `make` unless it is there. It never changes.
        const Value& get(const Job& job, const std::function<Value()>& make);
    };

    /// Occluders of the scene while some faces are hidden.
    struct PartOccluders {
        std::vector<std::uint32_t> hidden; ///< as in ViewRequest
        Occluders occluders;
    };

    /// Reflected light of the scene under a rig.
    struct RigLight {
        std::string rig; ///< its text
        std::shared_ptr<const ReflectedLight> light;
    };

    std::optional<Occluders> occluders(const std::vector<std::uint32_t>& hidden, const Job& job);
    const Inspection& judged(const Job& job);
    std::uint32_t seam_of_report(std::uint32_t number, const Inspection& inspection) const;

    Scene scene_;
    NamedView view_;
    CheckOptions check_;
    std::optional<Scene> against_;
    std::vector<NamedView> own_views_;
    Diagnostics remarks_;
    mutable std::mutex rig_access_;
    LightRig rig_;
    std::timed_mutex part_access_;
    std::optional<PartOccluders> part_; ///< the last that was requested
    std::filesystem::path solution_;
    std::timed_mutex light_access_;
    std::optional<RigLight> light_; ///< the last that was requested
    Kept<Inspection> judged_;
    Kept<std::string> facts_, inspection_, faults_;
    bool is_report_ = false; ///< inspection and faults are those of a report
};

} // namespace keiko::viewer
