#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/inspect/seams/seam_chain.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/integration/opencascade_seams.h"
#include "tests/integration/opencascade_tracer.h"
#include "tests/support/file_test_name.h"
#include "tests/support/paths.h"
#include <TopoDS_Shape.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>

namespace keiko {
namespace {

using namespace test;

constexpr double join = 0.5; // mm
/// Steps of each smooth piece of each border.
constexpr int steps = 60;
/// degrees: borders that turn by more against each other meet at a corner and are no seam.
constexpr double corner = 30;
/// mm: the ends of Keiko's pieces are known to some 1e-8 of their parameters.
constexpr double same_place = 1e-7, same_gap = 1e-7;
/// mm: ends of seams are known to this, as vertices of files are.
constexpr double same_vertex = 0.01;
/// mm: borders of different edges this near are meant to meet.
constexpr double together = 0.001;
constexpr double same_angle = 1e-8; ///< degrees
/// Share of 1: a mismatch may change from 0 to 1 within a few mm, or by this within `same_place`.
constexpr double same_mismatch = 1e-7;

/// A piece of a stretch, and the borders of the file that its sides are parts of.
struct StretchPiece {
    std::size_t stretch = 0;
    SurfaceCurve curve; ///< side a
    BoundaryInterval on;
    std::vector<std::size_t> borders_a, borders_b;
    std::array<std::size_t, 2> faces{}; ///< of side a, and of the other
    /// A side is a line by which the import closed a loop: the file has no border there.
    bool closing = false;

    /// mm, from side a
    double distance(const Vec3& p) const {
        constexpr int places = 64;
        double guess = on.begin, least = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= places; ++i) {
            const double t = on.begin + (on.end - on.begin) * i / places;
            const double away = (curve.at(t).position - p).length();
            if (away < least) guess = t, least = away;
        }
        return closest_point(curve, p, guess, on.begin, on.end).distance;
    }
};

/// One quantity of a stretch, as stated, and as OpenCASCADE has it.
struct Quantity {
    std::string name;
    double tolerance;
    std::function<std::optional<MeasuredValue>(const MeasuredSeam&)> stated;
    std::function<std::optional<double>(const PeerSeamPlace&)> peer;
    double excess = -std::numeric_limits<double>::infinity(); ///< over value and bound, anywhere
    double difference = 0;                                    ///< at the worst place
};

/// Every seam of a file, measured by Keiko and place by place by OpenCASCADE alone.
class SeamTable : public testing::TestWithParam<const char*> {
protected:
    void compare(const std::filesystem::path& file) {
        model_ = load_model(file);
        measured_ = measure_seams(model_, pair_seams(model_, join), {}, join);
        peer_ = std::make_unique<OpenCascadeSeams>(read_shape(file));
        ASSERT_EQ(peer_->face_count(), model_.faces.size());
        // Each face is placed once.
        ASSERT_EQ(model_.instances.size(), model_.parts.size());
        list_quantities();
        list_pieces();
        for (std::size_t border = 0; border < peer_->border_count(); ++border) sample(border);
        visit_worst_places();
        print(file.filename().string());
        EXPECT_GT(places_, 50U);
        // Of slivers alone.
        EXPECT_LE(elsewhere_, places_ / 100);
    }

private:
    void list_quantities() {
        const CriteriaPreset preset;
        quantities_ = {{"gap", same_gap, [](const MeasuredSeam& s) { return std::optional(s.gap); },
                        [](const PeerSeamPlace& p) { return std::optional(p.gap); }},
                       {"angle", same_angle, [](const MeasuredSeam& s) { return s.angle; },
                        [](const PeerSeamPlace& p) { return p.angle; }},
                       {"mismatch", same_mismatch,
                        [](const MeasuredSeam& s) {
                            return s.curvature ? std::optional(s.curvature->worst) : std::nullopt;
                        },
                        [preset](const PeerSeamPlace& p) -> std::optional<double> {
                            if (!p.angle) return std::nullopt;
                            return curvature_mismatch(preset.curvature->formula, p.curvature_a,
                                                      p.curvature_b, preset.flat_radius);
                        }}};
    }

    void list_pieces() {
        curves_.emplace(model_);
        for (std::size_t i = 0; i < measured_.seams.size(); ++i)
            for (const std::uint32_t number : measured_.seams[i].pieces) {
                const Seam& piece = measured_.pieces[number];
                pieces_.push_back({i,
                                   curves_->curve(piece.a),
                                   piece.a,
                                   borders_of(piece.a),
                                   borders_of(piece.b),
                                   {piece.a.face, piece.b.face},
                                   closes(piece.a) || closes(piece.b)});
                const StretchPiece& first = pieces_.back();
                others_.push_back({i,
                                   curves_->curve(piece.b),
                                   piece.b,
                                   first.borders_b,
                                   first.borders_a,
                                   {piece.b.face, piece.a.face},
                                   first.closing});
            }
    }

    bool closes(const BoundaryInterval& on) const {
        return on.curve < natural_side && model_.trim_curves[on.curve].edge == no_index;
    }

    /// Borders that run through the middle of an interval.
    std::vector<std::size_t> borders_of(const BoundaryInterval& on) const {
        const Vec3 middle = curves_->curve(on).at((on.begin + on.end) / 2).position;
        std::vector<std::size_t> found;
        for (std::size_t border = 0; border < peer_->border_count(); ++border)
            if (peer_->face_of(border) == on.face && peer_->distance(border, middle) <= same_place)
                found.push_back(border);
        return found;
    }

    static bool is_among(const std::vector<std::size_t>& borders, std::size_t border) {
        return std::find(borders.begin(), borders.end(), border) != borders.end();
    }

    /// The pieces of stretches with a face that a place on a border belongs to: two where they
    /// meet.
    std::vector<const StretchPiece*> pieces_at(std::size_t border, std::size_t face_b,
                                               const Vec3& place) const {
        std::vector<const StretchPiece*> found;
        for (const StretchPiece& piece : pieces_)
            if (!piece.closing && measured_.seams[piece.stretch].face_b == face_b &&
                is_among(piece.borders_a, border) && piece.distance(place) <= same_place)
                found.push_back(&piece);
        return found;
    }

    /// True if border x is faced more than border y of the same face: the nearer one is. Of those
    /// that meet at a corner, in one point, it is the one that goes on straightest.
    static bool faces_more(const PeerSeamPlace& x, const PeerSeamPlace& y) {
        constexpr double one_point = 1e-9; // mm
        if (std::abs(x.gap - y.gap) > one_point) return x.gap < y.gap;
        return x.angle.value_or(180) < y.angle.value_or(180);
    }

    void sample(std::size_t border) {
        std::map<std::pair<double, std::size_t>, PeerSeamPlace> nearest;
        for (const PeerSeamPlace& place : peer_->sample(border, steps, join)) {
            if (place.turn > corner) continue;
            const auto [at, is_new] =
                nearest.try_emplace({place.t, peer_->face_of(place.border_b)}, place);
            if (!is_new && faces_more(place, at->second)) at->second = place;
        }
        for (const auto& [key, place] : nearest) {
            hold(place, key.second);
            if (is_joined(place)) expect_seam(place, key.second);
        }
    }

    /// True if the file states that the borders meet at a place, or they run together there. At
    /// vertices borders also meet that run apart from there.
    static bool is_joined(const PeerSeamPlace& place) {
        constexpr double parallel = 1; // degrees
        return place.is_shared || (place.gap <= together && place.turn <= parallel &&
                                   place.slip <= same_place && place.from_end > same_vertex);
    }

    /// A place where borders meet must belong to a seam of Keiko's between their faces, whichever
    /// side it is on. Where one of two borders ends before the other, so does their seam. In the
    /// tip of a needle the seam may be with a third face that is as near.
    void expect_seam(const PeerSeamPlace& place, std::size_t face_b) {
        const auto is_at = [&](const StretchPiece& piece) {
            return piece.faces[0] == peer_->face_of(place.border_a) &&
                   (piece.faces[1] == face_b || !place.is_shared) &&
                   piece.distance(place.place) <= same_vertex + place.gap;
        };
        ++joined_;
        if (std::any_of(pieces_.begin(), pieces_.end(), is_at) ||
            std::any_of(others_.begin(), others_.end(), is_at))
            return;
        ++missing_;
        ADD_FAILURE() << "no seam of face " << peer_->face_of(place.border_a) + 1 << " with face "
                      << face_b + 1 << " at " << place.place.x << ", " << place.place.y << ", "
                      << place.place.z << ", " << place.gap << " mm apart, "
                      << (place.is_shared ? "of one edge" : "side by side");
    }

    void hold(const PeerSeamPlace& place, std::size_t face_b) {
        const auto pieces = pieces_at(place.border_a, face_b, place.place);
        if (pieces.empty()) return;
        ++places_;
        const bool on_paired = std::any_of(pieces.begin(), pieces.end(), [&](const auto* piece) {
            return is_among(piece->borders_b, place.border_b);
        });
        if (!on_paired) ++elsewhere_;
        for (Quantity& quantity : quantities_)
            if (on_paired || quantity.name == "gap") hold(quantity, place, pieces);
    }

    void hold(Quantity& quantity, const PeerSeamPlace& place,
              const std::vector<const StretchPiece*>& pieces) {
        const std::optional<double> peer = quantity.peer(place);
        double excess = std::numeric_limits<double>::infinity();
        for (const StretchPiece* piece : pieces)
            if (const auto stated = quantity.stated(measured_.seams[piece->stretch]);
                stated && peer)
                excess = std::min(excess, *peer - stated->value - stated->bound);
        if (!std::isfinite(excess)) return;
        quantity.excess = std::max(quantity.excess, excess);
        EXPECT_LE(excess, quantity.tolerance)
            << quantity.name << " " << *peer << " of "
            << measured_.seams[pieces.front()->stretch].faces << " at " << place.place.x << ", "
            << place.place.y << ", " << place.place.z;
    }

    /// OpenCASCADE must find each value at the worst place, between the borders that meet there.
    void visit_worst_places() {
        std::vector<std::vector<const StretchPiece*>> of(measured_.seams.size());
        for (const StretchPiece& piece : pieces_) of[piece.stretch].push_back(&piece);
        for (std::size_t i = 0; i < of.size(); ++i)
            for (Quantity& quantity : quantities_)
                if (const auto stated = quantity.stated(measured_.seams[i]))
                    visit(quantity, of[i], *stated);
    }

    void visit(Quantity& quantity, const std::vector<const StretchPiece*>& pieces,
               const MeasuredValue& stated) {
        double least = std::numeric_limits<double>::infinity();
        for (const StretchPiece* piece : pieces)
            if (piece->distance(stated.place) <= same_place) {
                if (piece->closing) {
                    ++closing_;
                    return;
                }
                least = std::min(least, difference(quantity, *piece, stated));
            }
        quantity.difference = std::max(quantity.difference, least);
        EXPECT_LE(least, quantity.tolerance)
            << quantity.name << " " << stated.value << " of "
            << measured_.seams[pieces.front()->stretch].faces << " at " << stated.place.x << ", "
            << stated.place.y << ", " << stated.place.z;
    }

    double difference(const Quantity& quantity, const StretchPiece& piece,
                      const MeasuredValue& stated) const {
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t border : piece.borders_a)
            for (const PeerSeamPlace& place : peer_->at(border, stated.place, widest_gap * join))
                if (const auto peer = quantity.peer(place);
                    peer && is_among(piece.borders_b, place.border_b))
                    least = std::min(least, std::abs(*peer - stated.value));
        return least;
    }

    void print(const std::string& name) const {
        std::cout << name << ": " << line_count(measured_.seams) << " seams, "
                  << measured_.seams.size() << " stretches, " << places_ << " places, "
                  << elsewhere_ << " facing another border, " << closing_
                  << " worst places without border, " << joined_ << " places where borders meet, "
                  << missing_ << " without a seam; beyond the stated maximum, at the worst places:"
                  << std::scientific << std::setprecision(1);
        for (const Quantity& q : quantities_)
            std::cout << ' ' << q.name << ' ' << q.excess << ", " << q.difference << ';';
        std::cout << '\n';
    }

    SurfaceModel model_;
    MeasuredSeams measured_;
    std::optional<BoundaryCurves> curves_;
    std::unique_ptr<OpenCascadeSeams> peer_;
    std::vector<Quantity> quantities_;
    std::vector<StretchPiece> pieces_; ///< by their sides a
    std::vector<StretchPiece> others_; ///< by their sides b
    std::size_t places_ = 0;
    std::size_t joined_ = 0;    ///< places where the file's borders meet
    std::size_t missing_ = 0;   ///< those of them that belong to no seam
    std::size_t elsewhere_ = 0; ///< places that face another border than the paired one
    std::size_t closing_ = 0;   ///< worst places where the file has no border
};

class SharedSeamTable : public SeamTable {};

TEST_P(SeamTable, AgreesWithOpenCascadeAlone) {
    compare(repository("surfaces") / GetParam());
}

TEST_P(SharedSeamTable, AgreesWithOpenCascadeAlone) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    compare(shared_model(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SeamTable,
                         testing::Values("concept-car.step", "hood.step", "seam-g1-angle.step"),
                         file_test_name);

INSTANTIATE_TEST_SUITE_P(Panels, SharedSeamTable,
                         testing::Values("car-hood.brep", "car-hood-converted.step",
                                         "car-front-fender.brep", "car-rear-deck-half-panel.brep",
                                         "suspension-control-arm.step"),
                         file_test_name);

} // namespace
} // namespace keiko
