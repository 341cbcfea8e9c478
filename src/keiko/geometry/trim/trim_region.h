#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/parameter_metric.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/trim/monotone_piece.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Position of a place of the parameter plane relative to a face's trim loops.
enum class TrimSide {
    inside,  ///< all of it is material
    outside, ///< none of it is
    mixed    ///< a trim curve may cross it
};

/// The material of one trimmed face, for point and box queries. P-curves are split into bi-monotone
/// pieces. Queries use the even-odd rule along a line of constant v, decided at each piece by
/// bracketing in one dimension, never by a polyline. A loop is a closed chain: where the file's
/// curves do not quite meet, a straight piece joins their ends.
class TrimRegion {
public:
    /// `seam_widths`, one for each trim curve of the model: distance beyond it that nearest_edge
    /// searches, mm; without them the edges' tolerances.
    TrimRegion(const SurfaceModel& model, const Face& face,
               std::span<const double> seam_widths = {});

    /// True if the point of the parameter plane is material. Points on a curve itself may be
    /// classified either way.
    bool contains(const Vec2& face_parameters) const;
    /// Ends of the intervals of a line that are either inside or outside, to rounding. The line is
    /// where coordinate `axis` (0 is u, 1 is v) is `at`. Returns the other coordinates of its
    /// crossings with trim curves, rising.
    std::vector<double> crossings(unsigned axis, double at) const;
    /// Bound of the distance, by the metric, of any place of a trim curve in the box from the
    /// segment from `a` to `b`; 0 if the box holds none.
    double most_off(const Box2& box, const Vec2& a, const Vec2& b,
                    const ParameterMetric& metric) const;
    /// Position of a box: inside or outside if no trim curve can touch it.
    TrimSide classify(const Box2& box) const;
    /// The nearest point of any trim curve within `radius` mm of the point; nullopt if there is
    /// none.
    struct NearCurve {
        double distance = 0;            ///< by the metric, i.e. about mm
        std::uint32_t curve = no_index; ///< into SurfaceModel::trim_curves
        double t = 0;                   ///< on that curve
        Vec2 place{0};                  ///< face parameters of it
    };
    /// The nearest point of any trim curve within `radius`; nullopt if there is none.
    std::optional<NearCurve> nearest_curve(const Vec2& face_parameters,
                                           const ParameterMetric& metric, double radius) const;
    /// The nearest point of an edge's curves that lies within that curve's seam width (at most
    /// `most` mm) by the metric; only of the edges of the sorted `among`, if it is not empty.
    /// Curves without an edge, or with too narrow a seam, hide none behind them.
    struct NearEdge {
        NearCurve at;                  ///< the point
        std::uint32_t edge = no_index; ///< into SurfaceModel::edges
    };
    /// The nearest such point; nullopt if there is none.
    std::optional<NearEdge> nearest_edge(const Vec2& face_parameters, const ParameterMetric& metric,
                                         double most,
                                         std::span<const std::uint32_t> among = {}) const;
    /// True if nearest_edge may find a place in the box, of face parameters: tested by boxes and
    /// strips that hold the curves, much faster.
    bool may_be_near_edge(const Box2& around) const;
    /// Edges of the face's loops, sorted.
    std::span<const std::uint32_t> edges() const { return edges_; }
    /// True for a face without loops.
    bool untrimmed() const { return pieces_.empty(); }
    /// Box of all trim curves in face parameters; empty for a face without loops.
    const Box2& bounds() const { return bounds_; }
    /// Memory of its arrays.
    std::size_t bytes() const;

private:
    /// Pieces that meet the rows from the one that holds v = `lower` to the one that holds
    /// `upper`, as [begin, end) of row_pieces_. A piece may occur in several rows.
    std::pair<std::size_t, std::size_t> pieces_between(double lower, double upper) const;
    /// The row that holds v, which is within the bounds.
    std::size_t row_of(double v) const;
    void build_rows();
    void find_row_borders();
    void list_edges(const SurfaceModel& model, std::span<const double> seam_widths);

    /// Edge of one of pieces_.
    struct PieceEdge {
        std::uint32_t edge = no_index;
        double width = 0; ///< mm; 0 without an edge
    };

    std::vector<MonotonePiece> pieces_;
    std::vector<PieceEdge> piece_edges_;
    std::vector<std::uint32_t> edges_;
    Box2 bounds_;
    // Rows of constant v between neighbouring entries of row_borders_. Row r holds the pieces
    // row_pieces_[row_begin_[r]] .. row_pieces_[row_begin_[r + 1] - 1], those that extend farthest
    // right first.
    std::vector<double> row_borders_;
    std::vector<std::uint32_t> row_begin_, row_pieces_;
};

} // namespace keiko
