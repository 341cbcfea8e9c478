#include "keiko/triage/triage.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/seams/course_distance.h"
#include "keiko/inspect/seams/seam_chain.h"
#include "keiko/math/disjoint_sets.h"
#include "keiko/scene/symmetry.h"
#include "keiko/triage/seam_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

/// Mendings of criteria, by their codes. All others ask for another layout.
constexpr std::array<std::pair<std::string_view, Mending>, 13> mendings{
    {{"G-SU-LG", Mending::position},
     {"KEIKO-SYMMETRY", Mending::position},
     {"G-SU-NT", Mending::tangent},
     {"KEIKO-LINE-JUMP", Mending::tangent},
     {"KEIKO-LINE-TURN", Mending::tangent},
     {"G-SU-NS", Mending::curvature},
     {"KEIKO-G3", Mending::curvature},
     {"KEIKO-RUN-OUT", Mending::curvature},
     {"G-SU-CR", Mending::curvature},
     {"G-SU-WV", Mending::curvature},
     {"KEIKO-DENT", Mending::curvature},
     {"KEIKO-LINE-KINK", Mending::curvature},
     {"KEIKO-LINE-BEND", Mending::curvature}}};

Mending mending_of(const Check& check) {
    for (const auto& [code, mending] : mendings)
        if (code == check.code) return mending;
    return Mending::layout;
}

/// Findings that are one fault wherever they lie: those of one stretch, those of one face that ask
/// for the same mending, or those of lines over what has no other finding.
struct Unit {
    std::uint32_t seam = no_index, face = no_index;
    Mending mending = Mending::layout;
    std::vector<std::size_t> findings;
    Sight sight;
};

/// Findings by what they are of.
class UnitMaker {
public:
    explicit UnitMaker(const Inspection& inspection) : inspection_(inspection) {
        const auto is_of_line = [&](std::size_t i) {
            const Check& check = inspection.findings[i];
            return check.seam == no_index && check.face == no_index;
        };
        for (std::size_t i = 0; i < inspection.findings.size(); ++i)
            if (!is_of_line(i)) add(i, {});
        for (std::size_t i = 0; i < inspection.findings.size(); ++i)
            if (is_of_line(i)) add_line(i);
    }
    std::vector<Unit> units() && { return std::move(units_); }

private:
    using Key = std::tuple<std::uint32_t, std::uint32_t, Mending, std::string>;

    void add(std::size_t finding, const std::string& line_over) {
        const Check& check = inspection_.findings[finding];
        const Mending mending = check.seam == no_index ? mending_of(check) : Mending::layout;
        const auto [at, is_new] =
            known_.try_emplace(Key(check.seam, check.face, mending, line_over), units_.size());
        if (is_new) units_.push_back({check.seam, check.face, mending_of(check), {}, {}});
        units_[at->second].findings.push_back(finding);
    }
    void add_line(std::size_t finding) {
        const Check& check = inspection_.findings[finding];
        Unit* nearest = nullptr;
        double distance = HUGE_VAL;
        for (Unit& unit : units_) {
            if (unit.seam == no_index || inspection_.seams[unit.seam].faces != check.faces)
                continue;
            const double own =
                distance_from_course(inspection_.seams[unit.seam], check.worst.place);
            if (!nearest || own < distance) nearest = &unit, distance = own;
        }
        if (nearest)
            nearest->findings.push_back(finding);
        else
            add(finding, check.faces);
    }

    const Inspection& inspection_;
    std::vector<Unit> units_;
    std::map<Key, std::size_t> known_;
};

/// An end of a stretch and the direction in which the stretch leads out of it.
struct CourseEnd {
    Vec3 place{0}, out{0};
};

std::array<CourseEnd, 2> ends_of(const MeasuredSeam& seam) {
    const std::vector<Vec3>&first = seam.course.front(), &last = seam.course.back();
    return {CourseEnd{first.front(), first.front() - first[1]},
            CourseEnd{last.back(), last.back() - last[last.size() - 2]}};
}

/// True if one stretch goes on where the other ends.
bool continue_each_other(const MeasuredSeam& a, const MeasuredSeam& b) {
    constexpr double bend = 0.5; // sine of the largest angle between them
    for (const CourseEnd& of_a : ends_of(a))
        for (const CourseEnd& of_b : ends_of(b))
            if ((of_a.place - of_b.place).length() <= same_vertex && of_a.out.dot(of_b.out) < 0 &&
                nearly_parallel(of_a.out, of_b.out, bend))
                return true;
    return false;
}

/// True if two stretches are images of each other, within a share of their length.
bool are_images(const MeasuredSeam& a, const MeasuredSeam& b, const MirrorPlane& mirror) {
    constexpr double share = 0.01;
    const double slack = share * std::max(a.length, b.length);
    return std::abs(a.length - b.length) <= slack &&
           (mirror.image(a.middle) - b.middle).length() <= slack &&
           std::abs(mirror.distance(a.middle)) > slack;
}

/// Units joined into faults.
class Grouping {
public:
    Grouping(const Inspection& inspection, std::vector<Unit> units)
        : inspection_(inspection),
          units_(std::move(units)),
          sets_(units_.size()),
          has_image_(units_.size()) {}

    void join(const MirrorPlane& mirror) {
        for (std::size_t j = 1; j < units_.size(); ++j) {
            check_stop();
            for (std::size_t i = 0; i < j; ++i) join_pair(i, j, mirror);
        }
    }

    Triage items() {
        std::map<std::size_t, std::vector<std::size_t>> groups;
        for (std::size_t i = 0; i < units_.size(); ++i) groups[sets_.root(i)].push_back(i);
        Triage triage;
        for (auto& [root, members] : groups) {
            TriageItem item = item_of(std::move(members));
            (item.visible > hidden_share ? triage.items : triage.hidden).push_back(std::move(item));
        }
        for (auto* items : {&triage.items, &triage.hidden})
            std::stable_sort(items->begin(), items->end(),
                             [](const TriageItem& a, const TriageItem& b) {
                                 return std::tuple(b.weight, a.findings.front()) <
                                        std::tuple(a.weight, b.findings.front());
                             });
        return triage;
    }

private:
    const MeasuredSeam& seam(std::size_t unit) const {
        return inspection_.seams[units_[unit].seam];
    }

    void join_pair(std::size_t i, std::size_t j, const MirrorPlane& mirror) {
        if (units_[i].seam == no_index || units_[j].seam == no_index ||
            units_[i].mending != units_[j].mending)
            return;
        const MeasuredSeam &a = seam(i), &b = seam(j);
        const bool images = are_images(a, b, mirror);
        if (images) has_image_[i] = has_image_[j] = true;
        if (images || a.line == b.line || continue_each_other(a, b)) sets_.join(i, j);
    }

    TriageItem item_of(std::vector<std::size_t> members) const;

    const Inspection& inspection_;
    std::vector<Unit> units_;
    DisjointSets sets_;
    std::vector<bool> has_image_; ///< of each unit, in its own set
};

TriageItem Grouping::item_of(std::vector<std::size_t> members) const {
    const auto seen = [&](std::size_t i) {
        return units_[i].sight.weight[units_[i].sight.best_view()];
    };
    std::stable_sort(members.begin(), members.end(),
                     [&](std::size_t a, std::size_t b) { return seen(a) > seen(b); });
    TriageItem item;
    Sight all;
    for (const std::size_t i : members) {
        const Unit& unit = units_[i];
        all.add(unit.sight);
        item.findings.insert(item.findings.end(), unit.findings.begin(), unit.findings.end());
        if (unit.seam != no_index) item.seams.push_back(unit.seam);
        if (has_image_[i]) item.mirrored = true;
    }
    std::sort(item.findings.begin(), item.findings.end());
    const std::size_t view = all.best_view();
    item.mending = units_[members.front()].mending, item.face = units_[members.front()].face;
    item.length = all.length, item.width = all.width, item.weight = all.weight[view];
    item.visible = all.length > 0 ? all.visible / all.length : 0;
    item.view = standing_views[view];
    item.place = units_[members.front()].sight.place;
    return item;
}

} // namespace

std::string_view name_of(Mending mending) {
    switch (mending) {
        case Mending::position:
            return "position";
        case Mending::tangent:
            return "tangent";
        case Mending::curvature:
            return "curvature";
        case Mending::layout:
            return "layout";
    }
    return "";
}

Triage triage(const SurfaceModel& model, const Tracer& tracer, const Inspection& inspection,
              std::optional<double> ground, const Job& job) {
    if (inspection.findings.empty()) return {};
    const StopScope scope(job);
    std::vector<Unit> units = UnitMaker(inspection).units();
    std::vector<std::uint32_t> stretches;
    for (const Unit& unit : units)
        if (unit.seam != no_index) stretches.push_back(unit.seam);
    const FindingSights of_findings(model, tracer, inspection, ground);
    const std::vector<Sight> sights = of_findings.of_stretches(stretches, job);
    parallel_for(units.size(), job, "sights", [&](std::size_t i) {
        Unit& unit = units[i];
        if (unit.seam != no_index) {
            unit.sight = sights[unit.seam];
            return;
        }
        for (const std::size_t finding : unit.findings)
            unit.sight.add(of_findings.of(inspection.findings[finding]));
    });
    Grouping grouping(inspection, std::move(units));
    grouping.join({1, (tracer.bounds().lower.y + tracer.bounds().upper.y) / 2});
    return grouping.items();
}

} // namespace keiko
