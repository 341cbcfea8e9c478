#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/triage/outer_sides.h"
#include "keiko/triage/standing_eyes.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// The findings of an inspection as the standing views show them.
class FindingSights {
public:
    /// Keeps references to all three. `tracer`: of the model. `ground`: as of StandingEyes.
    FindingSights(const SurfaceModel& model, const Tracer& tracer, const Inspection& inspection,
                  std::optional<double> ground = {});

    /// Sights of all measured stretches, by their indices; empty for those not in `stretches`.
    std::vector<Sight> of_stretches(std::span<const std::uint32_t> stretches,
                                    const Job& job = {}) const;
    /// True unless the check is an opening beside the largest skin of the body: a hole of a wheel
    /// or of a bracket is meant.
    bool is_fault(const Check& check) const;
    /// Sight of the worst place of a check of a face or of lines, or of an opening.
    Sight of(const Check& check) const;

private:
    std::vector<SightPlace> places_of(std::uint32_t stretch, const ModelBorders& borders) const;

    const SurfaceModel& model_;
    const Inspection& inspection_;
    StandingEyes eyes_;
    OuterSides sides_;
};

} // namespace keiko
