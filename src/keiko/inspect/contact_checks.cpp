#include "keiko/inspect/contact_checks.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/check_sentence.h"
#include "keiko/inspect/overlaps/identical_edges.h"
#include "keiko/inspect/overlaps/identical_faces.h"
#include "keiko/inspect/overlaps/self_contact.h"
#include "keiko/inspect/structure/face_structure.h"
#include "keiko/inspect/structure/least_value.h"
#include "keiko/inspect/structure/loop_crossings.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace keiko {
namespace {

Check check_of_identical(const IdenticalFaces& pair, const std::string& other) {
    // Narrow faces lie within the limit of their neighbours' borders and are no second surface.
    MeasuredValue worst{pair.distance, 0, pair.limit, pair.place, Verdict::undecided, true};
    if (pair.deep) worst.verdict = Verdict::fail;
    Check check = check_of_structure("G-SU-EM", worst, "");
    if (!pair.deep)
        check.message = "the face is so narrow that it cannot be told from the border of " + other;
    else
        check.message += pair.mutual ? "; " + other + " is the same surface"
                                     : "; all of the face lies on " + other;
    return check;
}

Check check_of_identical(const IdenticalEdges& pair, const std::string& other) {
    const MeasuredValue worst{pair.distance, 0, pair.limit, pair.place, Verdict::fail, true};
    Check check = check_of_structure("G-CU-EM", worst, "");
    check.message +=
        ", some " + short_number(pair.length) + " mm long; the other one bounds " + other;
    return check;
}

Check check_of_contact(const SelfContact& contact, double limit, const Vec3& place) {
    MeasuredValue worst{contact.distance, contact.distance, limit,
                        contact.place,    Verdict::fail,    true};
    if (!contact.found) worst = {0, limit, limit, place, Verdict::undecided, true};
    Check check = check_of_structure("G-SU-IS", worst, "");
    if (!contact.found)
        check.message = "the face is not shown to keep " + short_number(limit) + " mm from itself";
    else
        check.message += "; its sides meet at " + short_number(contact.angle) + " degrees, " +
                         short_number(contact.way) + " mm apart along the face";
    return check;
}

Check check_of_crossing(const LoopCrossing& crossing, double limit) {
    MeasuredValue worst{crossing.length, 0, limit, crossing.place, Verdict::fail, false};
    if (crossing.unknown) worst.verdict = Verdict::undecided;
    Check check = check_of_structure("G-LO-IS", worst, "");
    if (crossing.unknown)
        check.message =
            "whether borders of the face cross is unknown: it would take too many tests";
    else if (crossing.of_two_loops)
        check.message += "; two loops of the face cross there";
    return check;
}

/// Checks of measured faces, each in a slot of its face.
class ContactChecks {
public:
    ContactChecks(const ModelBorders& borders, std::span<const MeasuredFace> faces,
                  const FaceLimits& limits)
        : borders_(borders), faces_(faces), limits_(limits), checks_(faces.size()) {
        for (std::size_t i = 0; i < faces.size(); ++i)
            numbers_[{faces[i].instance, faces[i].face}] = i;
    }

    void add_pairs(const Job& job) {
        for (const IdenticalFaces& pair : identical_faces(borders_, limits_, job))
            add(pair.faces[0], check_of_identical(pair, name(pair.faces[1])));
        for (const IdenticalEdges& pair : identical_edges(borders_, limits_, job))
            add(pair.faces[limits_.in_scope(pair.faces[0]) ? 0 : 1],
                check_of_identical(
                    pair, pair.faces[0] == pair.faces[1] ? "the same face" : name(pair.faces[1])));
    }

    void add_self_contacts(const Job& job) {
        parallel_for(faces_.size(), job, "", [&](std::size_t i) {
            const auto& limit = limits_of(i).self_distance;
            if (!limit || !faces_[i].in_scope || never_meets_itself(i)) return;
            const PlacedFace face{faces_[i].instance, faces_[i].face};
            if (const auto contact = self_contact(borders_.model, face, *limit))
                checks_[i].push_back(check_of_contact(*contact, *limit, place_of(i)));
        });
    }

    void add_crossings(const Job& job) {
        std::map<FaceKey, Loops> loops;
        for (std::vector<BoundaryInterval>& loop : borders_.curves.loops())
            if (loop.front().curve < natural_side)
                loops[{loop.front().instance, loop.front().face}].push_back(std::move(loop));
        parallel_for(faces_.size(), job, "", [&](std::size_t i) {
            const auto& limit = limits_of(i).loop_crossing;
            const auto of_face = loops.find({faces_[i].instance, faces_[i].face});
            if (!limit || !faces_[i].in_scope || of_face == loops.end()) return;
            if (const auto crossing = loop_crossing(borders_, of_face->second, *limit))
                checks_[i].push_back(check_of_crossing(*crossing, *limit));
        });
    }

    std::vector<Check> take() {
        std::vector<Check> all;
        for (std::uint32_t i = 0; i < checks_.size(); ++i)
            for (Check& check : checks_[i]) {
                check.face = i, check.faces = faces_[i].name;
                all.push_back(std::move(check));
            }
        return all;
    }

private:
    const StructureLimits& limits_of(std::size_t i) const {
        return limits_.of({faces_[i].instance, faces_[i].face}).structure;
    }
    std::string name(const PlacedFace& face) const {
        return placed_face_name(borders_.model, face.instance, face.face);
    }
    void add(const PlacedFace& face, Check check) {
        checks_[numbers_.at({face.instance, face.face})].push_back(std::move(check));
    }
    /// True for surfaces that never meet themselves.
    bool never_meets_itself(std::size_t i) const {
        const std::string& kind = borders_.model.faces[faces_[i].face].surface_kind;
        return kind == "plane" || kind == "cylinder" || kind == "sphere";
    }
    Vec3 place_of(std::size_t i) const {
        const std::uint32_t patch = borders_.model.faces[faces_[i].face].first_patch;
        return placed_derivatives(borders_.model, faces_[i].instance, patch, Vec2(0.5)).position();
    }

    const ModelBorders& borders_;
    std::span<const MeasuredFace> faces_;
    const FaceLimits& limits_;
    std::map<FaceKey, std::size_t> numbers_;
    std::vector<std::vector<Check>> checks_;
};

/// True if `has` holds for the limits of a face in the scope.
template <class Has>
bool any_limit(std::span<const MeasuredFace> faces, const FaceLimits& limits, const Has& has) {
    return std::any_of(faces.begin(), faces.end(), [&](const MeasuredFace& face) {
        return face.in_scope && has(limits.of({face.instance, face.face}).structure);
    });
}

} // namespace

std::vector<Check> contact_checks(const ModelBorders& borders, std::span<const MeasuredFace> faces,
                                  const FaceLimits& limits, const Job& job) {
    ContactChecks checks(borders, faces, limits);
    const auto any = [&](const auto& has) { return any_limit(faces, limits, has); };
    if (any([](const StructureLimits& s) { return s.identical_face || s.identical_edge; }))
        checks.add_pairs(job);
    if (any([](const StructureLimits& s) { return s.self_distance.has_value(); }))
        checks.add_self_contacts(job);
    if (any([](const StructureLimits& s) { return s.loop_crossing.has_value(); }))
        checks.add_crossings(job);
    return checks.take();
}

} // namespace keiko
