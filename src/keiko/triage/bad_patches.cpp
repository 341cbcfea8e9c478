#include "keiko/triage/bad_patches.h"

#include <map>
#include <set>
#include <utility>

namespace keiko {
namespace {

/// Share of the length of a face's seams that its faults hold at least.
constexpr double least_share = 2.0 / 3;

/// A fault on the seams of one face.
struct PatchFault {
    std::size_t group = 0;
    double weight = 0; ///< pooled, in the fault's best view
    double length = 0; ///< mm
};

/// A face and the faults on it that no patch has taken.
struct Candidate {
    std::vector<PatchFault> faults;
    double length = 0; ///< mm, of all seams of the face

    /// Weight of its faults if the face is a bad patch, else 0.
    double weight() const {
        double weight = 0, of_faults = 0;
        for (const PatchFault& fault : faults) weight += fault.weight, of_faults += fault.length;
        return faults.size() > 1 && of_faults >= least_share * length ? weight : 0;
    }
};

class Candidates {
public:
    Candidates(const Inspection& inspection, std::span<const FaultUnit> units)
        : inspection_(inspection), units_(units), of_faces_(inspection.faces.size()) {
        for (std::uint32_t i = 0; i < inspection.faces.size(); ++i)
            numbers_[{inspection.faces[i].instance, inspection.faces[i].face}] = i;
        for (const MeasuredSeam& seam : inspection.seams)
            for (const std::uint32_t face : faces_of(seam)) of_faces_[face].length += seam.length;
    }

    /// Adds a fault to the faces on whose seams alone it lies.
    void add(std::size_t number, const FaultGroup& group) {
        const std::size_t view = group.sight.best_view();
        std::map<std::uint32_t, PatchFault> shares;
        for (const std::size_t i : group.units) {
            if (units_[i].seam == no_index) continue;
            const MeasuredSeam& seam = inspection_.seams[units_[i].seam];
            for (const std::uint32_t face : faces_of(seam)) {
                PatchFault& share = shares[face];
                share.group = number;
                share.weight += units_[i].sight.weight[view], share.length += seam.length;
            }
        }
        // A view may show both images of a fault, each with half of its weight.
        const double all = group.sight.weight[view] * (group.mirrored ? 0.5 : 1);
        for (const auto& [face, share] : shares)
            if (share.weight > 0 && share.weight >= spread_share * all)
                of_faces_[face].faults.push_back(share);
    }

    /// Takes the patch whose faults weigh most out of all candidates. It has no faults if no face
    /// is a bad patch any more.
    BadPatch take() {
        BadPatch worst;
        double weight = 0;
        for (std::uint32_t i = 0; i < of_faces_.size(); ++i)
            if (const double own = of_faces_[i].weight(); own > weight)
                weight = own, worst.face = i;
        if (!(weight > 0)) return worst;
        for (const PatchFault& fault : of_faces_[worst.face].faults)
            worst.groups.push_back(fault.group);
        const std::set<std::size_t> taken(worst.groups.begin(), worst.groups.end());
        for (Candidate& candidate : of_faces_)
            std::erase_if(candidate.faults,
                          [&](const PatchFault& fault) { return taken.count(fault.group) > 0; });
        return worst;
    }

private:
    /// The faces of a seam, into Inspection::faces: one if it is inside a face.
    std::set<std::uint32_t> faces_of(const MeasuredSeam& seam) const {
        std::set<std::uint32_t> faces;
        for (const PlacedFace& side : {seam.side_a(), seam.side_b()})
            if (const auto found = numbers_.find({side.instance, side.face});
                found != numbers_.end())
                faces.insert(found->second);
        return faces;
    }

    const Inspection& inspection_;
    std::span<const FaultUnit> units_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
    std::vector<Candidate> of_faces_;
};

} // namespace

std::vector<BadPatch> bad_patches(const Inspection& inspection, std::span<const FaultUnit> units,
                                  std::span<const FaultGroup> groups,
                                  const std::vector<bool>& may_belong) {
    Candidates candidates(inspection, units);
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (may_belong[i]) candidates.add(i, groups[i]);
    std::vector<BadPatch> patches;
    for (BadPatch patch = candidates.take(); !patch.groups.empty(); patch = candidates.take())
        patches.push_back(patch);
    return patches;
}

} // namespace keiko
