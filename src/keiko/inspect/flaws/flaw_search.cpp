#include "keiko/inspect/flaws/flaw_search.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/approximation_error.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/flaws/dent_depth.h"
#include "keiko/inspect/flaws/face_ripples.h"
#include "keiko/inspect/flaws/wave_section.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// Depth as a share of the window beyond which a deviation is form, not a flaw.
constexpr double deepest_share = 1.0 / 50;
/// Relative change of a depth with the extent of its surroundings beyond which it may be form.
constexpr double form_share = 0.25;
/// Factor by which a form's error may be larger where it is continued to a border, not across a
/// gap.
constexpr double one_sided_factor = 3;
/// Ratio of a dent's depth to its ripple's possible depth beyond which it is form. Planted dents
/// reach 5.3, or 10 if their middle lies beyond a border.
constexpr double most_beyond_ripple = 12;
/// Largest distance of the turns of the curvature of a dent that a border cuts, as a share of the
/// window. Dents of a third of the window turn at 0.65 of their width, located to the next samples
/// (docs/theory/verdict.md).
constexpr double widest_cut_share = 0.65 / 3 + 0.1;
/// Numbers of the deepest crests and troughs of a flaw that are measured and that are tried; in a
/// corner the surroundings may be too small.
constexpr std::size_t most_measured = 6, most_tried = 30;

struct PlacedFlaw {
    Flaw flaw;
    std::size_t face = 0;        ///< into FaceAdjacency
    bool alone = false;          ///< of a dent: nothing around deviates as much
    std::vector<Vec3> ripples{}; ///< world, mm: the places of all that show it
};

bool is_measured(const Flaw& flaw) {
    return flaw.depth.bound <= form_share * flaw.depth.value;
}

class FlawMeasure {
public:
    FlawMeasure(const FaceAdjacency& faces, const WavinessLimit& limit)
        : faces_(faces), limit_(limit) {}

    /// A flaw measured from its ripples, the deepest first. Ripples that resemble waves but are
    /// fewer than two, as those of a dent that a border cuts, are none.
    std::optional<PlacedFlaw> measured(const std::vector<FaceRipple>& ripples) const {
        if (!to_and_fro(ripples))
            return limit_.waves_only ? std::nullopt : deepest_of(ripples, &FlawMeasure::dent);
        auto waves = deepest_of(ripples, &FlawMeasure::wave);
        if (!waves) return without_two_waves(ripples);
        if (limit_.waves_only) return waves;
        auto deepest = dent(ripples.front());
        const bool dented = deepest && !is_form(*deepest) && is_no_wave(*deepest, *waves);
        return dented ? deepest : waves;
    }

private:
    std::optional<PlacedFlaw> deepest_of(
        const std::vector<FaceRipple>& ripples,
        std::optional<PlacedFlaw> (FlawMeasure::*measure)(const FaceRipple&) const) const {
        std::optional<PlacedFlaw> deepest;
        std::vector<const FaceRipple*> measured;
        std::vector<Vec3> places; // of dents
        for (std::size_t i = 0, tried = 0; i < ripples.size() && tried < most_tried; ++i) {
            if (is_beside(measured, ripples[i]) || is_at(places, ripples[i])) continue;
            ++tried;
            const auto flaw = (this->*measure)(ripples[i]);
            if (!flaw) continue;
            if (!deepest || flaw->flaw.depth.value > deepest->flaw.depth.value) deepest = flaw;
            measured.push_back(&ripples[i]);
            if (flaw->flaw.kind != Flaw::Kind::waves) places.push_back(flaw->flaw.depth.place);
            if (measured.size() == most_measured) break;
        }
        if (!deepest || is_form(*deepest) || deepest->flaw.depth.value < limit_.depth / 2)
            return std::nullopt;
        return deepest;
    }
    bool is_form(const PlacedFlaw& flaw) const {
        return flaw.flaw.depth.value > limit_.window * deepest_share;
    }

    /// True if it belongs to a measured crest or trough, which another line shows too.
    bool is_beside(const std::vector<const FaceRipple*>& measured, const FaceRipple& ripple) const {
        return std::any_of(measured.begin(), measured.end(), [&](const FaceRipple* other) {
            const Vec3 apart = ripple.position - other->position;
            return std::abs(apart.dot(ripple.along)) < ripple.width / 4 &&
                   apart.length() < limit_.window / 2;
        });
    }

    /// True if it belongs to a measured dent.
    bool is_at(const std::vector<Vec3>& places, const FaceRipple& ripple) const {
        return std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
            return (place - ripple.position).length() < limit_.window / 4;
        });
    }

    MeasuredValue depth(double value, double bound, const Vec3& place) const {
        constexpr double doubtful = 2; // fits that disagree say little of their errors
        const bool form = bound > form_share * value;
        if (form) bound *= doubtful;
        Verdict verdict = judge(value, bound, limit_.depth);
        if (form) verdict = std::min(verdict, Verdict::undecided);
        return {value, bound, limit_.depth, place, verdict, false};
    }

    std::optional<PlacedFlaw> wave(const FaceRipple& r) const {
        const auto found = wave_section(faces_, r.at, r.along, r.depth > 0, r.width);
        constexpr double slack = 1.1; // the length of waves that fade is not sharp
        if (!found || found->length > slack * widest_share * limit_.window) return std::nullopt;
        return PlacedFlaw{{Flaw::Kind::waves, depth(found->depth, found->bound, found->position),
                           found->length, limit_.window},
                          found->at.face};
    }

    /// Waves on a surface too narrow for two of them are undecided: they may be form.
    std::optional<PlacedFlaw> narrow_wave(const FaceRipple& r) const {
        const auto found = narrow_wave_section(faces_, r.at, r.along, r.depth > 0, r.width);
        if (!found || found->length > widest_share * limit_.window ||
            found->bound > form_share * found->depth)
            return std::nullopt;
        MeasuredValue value = depth(found->depth, found->bound, found->position);
        value.verdict = std::min(value.verdict, Verdict::undecided);
        return PlacedFlaw{{Flaw::Kind::waves, value, found->length, limit_.window}, found->at.face};
    }

    /// A dent that is measured, or else narrow waves.
    std::optional<PlacedFlaw> without_two_waves(const std::vector<FaceRipple>& ripples) const {
        std::optional<PlacedFlaw> dented;
        if (!limit_.waves_only) dented = deepest_of(ripples, &FlawMeasure::dent);
        if (dented && is_measured(dented->flaw)) return dented;
        const auto narrow = deepest_of(ripples, &FlawMeasure::narrow_wave);
        return narrow ? narrow : dented;
    }

    std::optional<PlacedFlaw> dent(const FaceRipple& r) const {
        if (r.cut && r.width > widest_cut_share * limit_.window) return std::nullopt;
        const auto found = dent_depth(faces_, r.at, limit_.window / 2);
        if (!found) return std::nullopt;
        // With form on one side only, many bends near a border would be undecided. So would be
        // feature lines that run askew.
        if (std::abs(found->offset) > most_beyond_ripple * r.deepest) return std::nullopt;
        const bool form = found->bound > form_share * std::abs(found->offset);
        if (form && (found->one_sided || r.cut || r.askew)) return std::nullopt;
        const double bound = found->bound * (found->one_sided ? one_sided_factor : 1);
        return PlacedFlaw{
            {found->offset < 0 ? Flaw::Kind::dent : Flaw::Kind::bump,
             depth(std::abs(found->offset), bound, found->position), r.width, limit_.window},
            found->at.face,
            found->alone};
    }

    /// True if a dent appears as waves by its rims, or beside another bend.
    static bool is_no_wave(const PlacedFlaw& dent, const PlacedFlaw& waves) {
        const MeasuredValue &a = dent.flaw.depth, &b = waves.flaw.depth;
        return dent.alone && (a.value - a.bound > b.value || a.verdict > b.verdict);
    }

    /// True if there are crests and troughs that are nearly as deep.
    static bool to_and_fro(const std::vector<FaceRipple>& ripples) {
        const double first = ripples.front().depth;
        return std::any_of(ripples.begin(), ripples.end(), [first](const FaceRipple& r) {
            return r.depth * first < 0 && std::abs(r.depth) > std::abs(first) / 2;
        });
    }

    const FaceAdjacency& faces_;
    WavinessLimit limit_;
};

std::vector<FaceRipple> all_ripples(const FaceAdjacency& faces, const std::vector<bool>& searched,
                                    const WavinessLimit& limit, const Job& job) {
    std::vector<std::vector<FaceRipple>> found(faces.size());
    parallel_for(found.size(), job, "ripples", [&](std::size_t i) {
        if (searched[i] && is_searchable(faces.face(i), limit))
            found[i] = find_face_ripples(faces, i, limit);
    });
    std::vector<FaceRipple> all;
    for (const std::vector<FaceRipple>& of_face : found)
        all.insert(all.end(), of_face.begin(), of_face.end());
    return all;
}

/// All flaws found with one window.
std::vector<PlacedFlaw> flaws_in_window(const FaceAdjacency& faces,
                                        const std::vector<bool>& searched,
                                        const WavinessLimit& limit, const Job& job) {
    const std::vector<std::vector<FaceRipple>> groups =
        ripple_groups(faces, all_ripples(faces, searched, limit, job), limit.window / 4);
    std::vector<std::optional<PlacedFlaw>> measured(groups.size());
    parallel_for(groups.size(), job, "flaws", [&](std::size_t i) {
        measured[i] = FlawMeasure(faces, limit).measured(groups[i]);
    });
    std::vector<PlacedFlaw> flaws;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (!measured[i]) continue;
        flaws.push_back(*measured[i]);
        for (const FaceRipple& ripple : groups[i]) flaws.back().ripples.push_back(ripple.position);
    }
    return flaws;
}

/// The placed faces that FaceAdjacency numbers.
std::vector<PlacedFace> faces_with_patches(const SurfaceModel& model) {
    std::vector<PlacedFace> faces = placed_faces(model);
    std::erase_if(faces, [&](const PlacedFace& f) { return model.faces[f.face].patch_count == 0; });
    return faces;
}

/// mm by which a height over the surroundings may be off on a face that approximates one of the
/// file: both are.
double height_error(const SurfaceModel& model, const PlacedFace& face) {
    const double scale = scale_of(model.instances[face.instance]);
    return 2 * approximation_error(model, face.face, scale).position;
}

/// True if what a face is off its file hides flaws of the limit, or makes patches of several sizes.
bool is_rough(double error, const FaceSurface& surface, const WavinessLimit& limit) {
    constexpr double most = 0.25; // of the limit: flaws are found from half of it on
    return error > 0 && (error > most * limit.depth || !surface.is_grid());
}

/// A face that is not searched, and whether for what it approximates or for its size.
PlacedFlaw unsearched(const FaceAdjacency& faces, std::size_t face, const WavinessLimit& limit,
                      Flaw::Kind kind) {
    const FaceSurface& surface = faces.face(face);
    const Vec2 spans(static_cast<double>(surface.spans_u()),
                     static_cast<double>(surface.spans_v()));
    const auto place = surface.evaluate_beyond(spans / 2, 0);
    const MeasuredValue none{
        0, 0, limit.depth, place ? place->position() : Vec3(0), Verdict::undecided, false};
    return {{kind, none, surface.size(), limit.window}, face};
}

/// Counts the error of an approximation in.
void widen(MeasuredValue& depth, double error) {
    if (!(error > 0)) return;
    depth.bound += error;
    if (depth.verdict != Verdict::undecided)
        depth.verdict = judge(depth.value, depth.bound, depth.limit);
}

/// True if a flaw of a wider window appears in a narrower one too, anywhere on it. A far deeper
/// flaw and longer waves count as different.
bool is_same(const PlacedFlaw& narrower, const PlacedFlaw& wider) {
    const Flaw &a = narrower.flaw, &b = wider.flaw;
    if (!(a.window < b.window)) return false;
    constexpr double deeper = 3, longer = 1.25;
    if (is_measured(a) && b.depth.value > deeper * a.depth.value) return false;
    const bool waves = a.kind == Flaw::Kind::waves && b.kind == Flaw::Kind::waves;
    if (waves && b.width > longer * a.width) return false;
    const auto passes = [&](const PlacedFlaw& flaw, const Vec3& place) {
        return std::any_of(flaw.ripples.begin(), flaw.ripples.end(), [&](const Vec3& ripple) {
            return (ripple - place).length() < b.window / 4;
        });
    };
    return passes(narrower, b.depth.place) || passes(wider, a.depth.place);
}

/// Adds a flaw of a wider window. It replaces flaws there that narrower windows find but cannot
/// measure; it is dropped if one of them measures it.
void add(std::vector<PlacedFlaw>& flaws, const PlacedFlaw& wider) {
    const bool measured = is_measured(wider.flaw);
    const bool known = std::any_of(flaws.begin(), flaws.end(), [&](const PlacedFlaw& other) {
        return is_same(other, wider) && (is_measured(other.flaw) || !measured);
    });
    if (known) return;
    flaws.erase(std::remove_if(flaws.begin(), flaws.end(),
                               [&](const PlacedFlaw& other) { return is_same(other, wider); }),
                flaws.end());
    flaws.push_back(wider);
}

} // namespace

std::vector<std::vector<Flaw>> find_flaws(const SurfaceModel& model,
                                          std::span<const MeasuredSeam> seams,
                                          std::span<const Seam> pieces, std::vector<bool> searched,
                                          std::span<const WavinessLimit> limits, const Job& job) {
    const FaceAdjacency faces(model, seams, pieces, limits.front().window / 20);
    const std::vector<PlacedFace> origin = faces_with_patches(model);
    std::vector<PlacedFlaw> placed, unknown;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!searched[i]) continue;
        const bool rough = is_rough(height_error(model, origin[i]), faces.face(i), limits.front());
        if (!rough && is_searchable(faces.face(i), limits.front())) continue;
        unknown.push_back(unsearched(faces, i, limits.front(),
                                     rough ? Flaw::Kind::rough : Flaw::Kind::unsearched));
        if (rough) searched[i] = false;
    }
    for (const WavinessLimit& limit : limits)
        for (const PlacedFlaw& flaw : flaws_in_window(faces, searched, limit, job))
            add(placed, flaw);
    std::vector<std::vector<Flaw>> flaws(faces.size());
    for (PlacedFlaw& flaw : placed) widen(flaw.flaw.depth, height_error(model, origin[flaw.face]));
    placed.insert(placed.end(), unknown.begin(), unknown.end());
    for (const PlacedFlaw& flaw : placed) flaws[flaw.face].push_back(flaw.flaw);
    for (std::vector<Flaw>& of_face : flaws)
        std::stable_sort(of_face.begin(), of_face.end(), [](const Flaw& a, const Flaw& b) {
            return a.depth.value > b.depth.value;
        });
    return flaws;
}

} // namespace keiko
