#include "keiko/cli/symmetry_option.h"

#include "keiko/base/error.h"
#include "keiko/cli/session.h"

namespace keiko::cli {

void SymmetryOption::add_to_placement(CLI::App& command) {
    command
        .add_option("--symmetry", plane_,
                    "plane that lamps are symmetric about where views and body are: auto, off, or "
                    "a plane as y or y=12.5 (mm) [auto]")
        ->option_text("auto|off|PLANE");
}

void SymmetryOption::add_to(CLI::App& command, bool also_places) {
    command
        .add_option(
            "--symmetry", plane_,
            also_places
                ? "plane that the body is to be symmetric about, as y or y=12.5 (mm), and "
                  "placed lamps with it; auto: lamps alone, off: neither [auto, and what "
                  "the preset judges]"
                : "plane that the body is to be symmetric about, as y or y=12.5 (mm); auto: "
                  "one that is found, as worth a look, off: none [the preset's, or none]")
        ->option_text("auto|off|PLANE");
    command
        .add_option("--symmetry-limit", limit_,
                    "mm that it may be from its mirror image [the preset's, or 0.01]")
        ->check(number_between(1e-6, 1000));
}

SymmetryChoice SymmetryOption::choice() const {
    SymmetryChoice choice = SymmetryChoice::parse(plane_.empty() ? "auto" : plane_);
    if (limit_ > 0) choice.distance = limit_;
    return choice;
}

void SymmetryOption::apply_to(CriteriaPreset& preset) const {
    std::optional<SymmetryLimit>& limit = preset.surface.symmetry;
    const SymmetryChoice asked = choice();
    if (!plane_.empty() && asked.kind == SymmetryChoice::Kind::off) limit.reset();
    if (asked.kind == SymmetryChoice::Kind::plane) {
        if (!limit) limit.emplace();
        limit->plane = asked.plane;
    }
    if (limit_ == 0 || plane_ == "auto") return;
    if (!limit) throw Error("", "", "--symmetry-limit asks for --symmetry too");
    limit->distance = limit_;
}

void SymmetryOption::look_in(CriteriaPreset& preset) const {
    if (plane_ == "auto") preset.look.symmetry = choice().distance;
}

} // namespace keiko::cli
