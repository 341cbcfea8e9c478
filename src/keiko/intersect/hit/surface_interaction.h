#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include <optional>

namespace keiko {

/// A place of a surface with its first two derivatives; SurfaceDerivatives without what few ask.
struct SurfaceJet {
    Vec3 position{0};            ///< mm
    Vec3 du{0}, dv{0};           ///< first derivatives by the parameters, mm
    Vec3 duu{0}, duv{0}, dvv{0}; ///< second derivatives by the parameters, mm

    /// SurfaceDerivatives of these numbers, with zeros for every higher derivative.
    SurfaceDerivatives derivatives() const;
};

/// Point and derivatives of a homogeneous jet in space. A rational jet is projected by the quotient
/// rule; without `rational` the weight counts as constant and only scales. Requires a weight other
/// than 0.
SurfaceJet projected(const HomogeneousJet& jet, bool rational);

/// Unit normal, where a surface is seen edge-on, to the side to which it bends along the way there:
/// from which that is seen. Nothing next to where that changes, a cusp.
std::optional<Vec3> bending_side(const SurfaceJet& place, const Vec3& way);

/// Makes hits of crossings: everything about them, in world coordinates. Several are evaluated
/// side by side, those on one sub-patch together where enough of them follow soon: it costs half as
/// much.
class SurfaceInteraction {
public:
    /// Evaluates hits of a model, which must outlive it as the kernels must. Hit::second stays
    /// empty without `second_derivatives`.
    SurfaceInteraction(const TracedModel& model, const SubPatchKernels& kernels,
                       bool second_derivatives)
        : model_(model), kernels_(kernels), second_derivatives_(second_derivatives) {}

    /// Fetches what will be read of a crossing on a sub-patch, by number.
    static void announce(const TracedModel& model, std::uint32_t sub_patch);
    /// Fetches what add() will read of a crossing that soon follows.
    void announce(const Crossing& crossing);
    /// `hit` is written at the latest by finish(); both must stay where they are until then.
    void add(const Crossing& crossing, Hit& hit);
    /// Writes the hits that still wait for others beside them.
    void finish();
    /// Writes a hit at once, by itself.
    void write_whole(const Crossing& crossing, Hit& hit);
    /// Writes what HitDetail::face names, and nothing else.
    void write_face(const Crossing& crossing, Hit& hit) const;

private:
    /// Crossings that wait for others beside them.
    struct Group {
        std::size_t count = 0;
        HitPacket::Lanes<const Crossing*> crossings;
        HitPacket::Lanes<Hit*> hits;

        bool full() const { return count == HitPacket::capacity; }
        void add(const Crossing* crossing, Hit* hit) {
            crossings[count] = crossing;
            hits[count++] = hit;
        }
    };

    /// Makes room in a group: what it holds is evaluated beside others.
    void mix(Group& group);
    void evaluate(Group& group);
    void ask(const Crossing& crossing, std::size_t lane);
    void write(const Crossing& crossing, std::size_t lane, Hit& hit) const;
    /// Writes everything that depends on the derivatives, except the bound.
    void write_surface(std::size_t lane, const PartPlacement& placement, Hit& hit) const;
    /// mm, of the world.
    double position_bound(std::size_t lane, const SubPatch& sub_patch,
                          const PartPlacement& placement) const;

    HitPacket block_;
    std::array<Group, 8> by_sub_patch_; ///< each of one sub-patch; by the last digits of its number
    Group mixed_;
    const TracedModel& model_;
    const SubPatchKernels& kernels_;
    bool second_derivatives_;
    std::uint32_t announced_ = no_index; ///< the last sub-patch that was
};

/// Hit at one crossing, in world coordinates, as SurfaceInteraction makes it.
Hit evaluated(const TracedModel& model, const SubPatchKernels& kernels, const Crossing& crossing,
              bool second_derivatives);

} // namespace keiko
