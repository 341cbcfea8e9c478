#include "keiko/cli/symmetry_option.h"

#include "keiko/cli/number_check.h"

namespace keiko::cli {

void SymmetryOption::add_to(CLI::App& command) {
    command
        .add_option("--symmetry", plane_,
                    "plane that the body is to be symmetric about, as y or y=12.5 (mm) [the "
                    "preset's, or none]")
        ->option_text("PLANE");
    command
        .add_option("--symmetry-limit", limit_,
                    "mm that it may be from its mirror image [the preset's, or 0.01]")
        ->check(number_between(1e-6, 1000));
}

void SymmetryOption::apply_to(CriteriaPreset& preset) const {
    std::optional<SymmetryLimit>& limit = preset.surface.symmetry;
    if (!plane_.empty()) {
        if (!limit) limit.emplace();
        limit->plane = MirrorPlane::parse(plane_);
    }
    if (limit_ == 0) return;
    if (!limit) throw Error("", "", "--symmetry-limit asks for --symmetry too");
    limit->distance = limit_;
}

} // namespace keiko::cli
