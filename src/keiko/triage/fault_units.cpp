#include "keiko/triage/fault_units.h"

#include "keiko/inspect/seams/course_distance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

class UnitMaker {
public:
    explicit UnitMaker(const Inspection& inspection) : inspection_(inspection) {
        const std::size_t findings = inspection.findings.size();
        for (std::size_t i = 0; i < findings; ++i)
            if (!is_of_lines(inspection.findings[i])) add(i, {});
        for (std::size_t i = 0; i < findings; ++i)
            if (is_of_lines(inspection.findings[i])) add_line(i);
        for (std::size_t i = 0; i < inspection.looks.size(); ++i)
            if (inspection.looks[i].opening_length > 0) add_opening(findings + i);
    }
    std::vector<FaultUnit> units() && { return std::move(units_); }

private:
    using Key = std::tuple<std::uint32_t, std::uint32_t, Mending, std::string>;

    void add(std::size_t finding, const std::string& line_over) {
        const Check& check = inspection_.findings[finding];
        const Mending mending = check.seam == no_index ? mending_of(check) : Mending::layout;
        const auto [at, is_new] =
            known_.try_emplace(Key(check.seam, check.face, mending, line_over), units_.size());
        if (is_new) units_.push_back({check.seam, check.face, mending_of(check), false, {}, {}});
        FaultUnit& unit = units_[at->second];
        unit.mending = std::min(unit.mending, mending_of(check));
        if (check.code == "G-SU-NS") unit.jumps = true;
        unit.findings.push_back(finding);
    }
    void add_line(std::size_t finding) {
        const Check& check = inspection_.findings[finding];
        FaultUnit* nearest = nullptr;
        double distance = HUGE_VAL;
        for (FaultUnit& unit : units_) {
            if (unit.seam == no_index || inspection_.seams[unit.seam].faces != check.faces)
                continue;
            const double own =
                distance_from_course(inspection_.seams[unit.seam], check.worst.place);
            if (!nearest || own < distance) nearest = &unit, distance = own;
        }
        if (!nearest) return add(finding, check.faces);
        nearest->mending = std::min(nearest->mending, mending_of(check));
        nearest->findings.push_back(finding);
    }
    void add_opening(std::size_t number) {
        const Check& check = numbered_check(inspection_, number);
        units_.push_back({no_index, check.face, mending_of(check), false, {number}, {}});
    }

    const Inspection& inspection_;
    std::vector<FaultUnit> units_;
    std::map<Key, std::size_t> known_;
};

} // namespace

bool is_of_lines(const Check& check) {
    return check.seam == no_index && check.face == no_index;
}

bool FaultUnit::is_fine() const {
    return seam != no_index && mending == Mending::curvature && jumps && !sight.is_hidden() &&
           !sight.is_resolved();
}

std::vector<FaultUnit> fault_units(const Inspection& inspection) {
    return UnitMaker(inspection).units();
}

} // namespace keiko
