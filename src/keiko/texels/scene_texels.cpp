#include "keiko/texels/scene_texels.h"

#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/math/reach.h"
#include "keiko/texels/fibre_blocks.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

namespace keiko {
namespace {

/// A placed face with texels.
struct TexelFace {
    std::uint32_t instance, face;
    std::size_t spec; ///< into the specifications
};

void warn_of(const ShellLattice& lattice, const SurfaceModel& model) {
    if (lattice.limited)
        log_warning("face " + std::to_string(model.faces[lattice.face].id) +
                    ": its texels leave it by more than a hundredth of their thickness");
}

} // namespace

bool have_texels(std::span<const Material> materials) {
    return std::any_of(materials.begin(), materials.end(),
                       [](const Material& material) { return material.texels.has_value(); });
}

SceneTexels::SceneTexels(const SurfaceModel& model, std::span<const Material> materials,
                         const Job& job) {
    std::vector<TexelFace> faces;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            if (!materials[f].texels) continue;
            const auto found = std::find_if(specs_.begin(), specs_.end(), [&](const auto& known) {
                return *known == *materials[f].texels;
            });
            const auto number = static_cast<std::size_t>(found - specs_.begin());
            if (found == specs_.end())
                specs_.push_back(std::make_shared<const TexelSpec>(*materials[f].texels));
            faces.push_back({i, f, number});
        }
    }
    std::vector<std::shared_ptr<const TexelBlock>> blocks(specs_.size());
    parallel_for(specs_.size(), job, "", [&](std::size_t i) {
        blocks[i] = std::make_shared<const TexelBlock>(fibre_block(*specs_[i]));
    });
    std::vector<std::optional<TexelShell>> shells(faces.size());
    parallel_for(faces.size(), job, "", [&](std::size_t i) {
        const TexelFace& of = faces[i];
        shells[i].emplace(model, of.instance, of.face, *specs_[of.spec], blocks[of.spec]);
    });
    for (std::optional<TexelShell>& shell : shells) {
        warn_of(shell->lattice(), model);
        shells_.push_back(std::move(*shell));
    }
}

std::vector<Box3> SceneTexels::boxes() const {
    std::vector<Box3> boxes;
    for (const TexelShell& shell : shells_) boxes.push_back(shell.bounds());
    return boxes;
}

double SceneTexels::reach_from(const Vec3& place) const {
    return keiko::reach_from(place, boxes());
}

double SceneTexels::optical_depth(const Segment& segment, double most) const {
    constexpr int level = 1;
    double depth = 0;
    for (const TexelShell& shell : shells_) {
        const int coarse = std::min(level, shell.block().coarsest());
        for (const ShellRun& run : shell.runs(segment)) {
            shell.each_sample(run, coarse, [&](const Vec3&, const Fibres& fibres, double length) {
                depth += fibres.extinction * length;
                return depth <= most;
            });
            if (depth > most) return depth;
        }
    }
    return depth;
}

} // namespace keiko
