#pragma once

#include "keiko/geometry/bezier/parameter_metric.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/trim/monotone_piece.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Which side of a face's trim loops a place of its parameter plane is on.
enum class TrimSide { inside, outside, mixed };

/// The material of one trimmed face, for point and box questions: p-curves split into
/// bi-monotone pieces, answered by the even-odd rule along a line of constant v, decided at each
/// piece by bracketing in one dimension, never by a polyline. A loop is a closed chain: where
/// the file's curves do not quite meet, a straight piece joins their ends.
class TrimRegion {
public:
    /// `seam_widths`, a trim curve of the model: how far beyond it nearest_edge looks, mm; without
    /// them that is the edges' tolerances.
    TrimRegion(const SurfaceModel& model, const Face& face,
               std::span<const double> seam_widths = {});

    /// Whether the point of the parameter plane is material. Points on a curve itself may go
    /// either way.
    bool contains(const Vec2& face_parameters) const;
    /// Between which places a line on which coordinate `axis` (0 is u, 1 is v) is `at` is either
    /// inside or outside, to rounding: the other coordinate of where trim curves meet it, rising.
    std::vector<double> crossings(unsigned axis, double at) const;
    /// inside or outside when no trim curve can touch the box.
    TrimSide classify(const Box2& box) const;
    /// The nearest point of any trim curve within `radius` mm of the point, or nothing.
    struct NearCurve {
        double distance = 0;            ///< by the metric, i.e. about mm
        std::uint32_t curve = no_index; ///< into SurfaceModel::trim_curves
        double t = 0;                   ///< on that curve
        Vec2 place{0};                  ///< face parameters of it
    };
    std::optional<NearCurve> nearest_curve(const Vec2& face_parameters,
                                           const ParameterMetric& metric, double radius) const;
    /// The nearest point of an edge's curves that lies within that curve's seam width (at most
    /// `most` mm) by the metric; only of the edges of the sorted `among`, when it is not empty.
    /// Curves without an edge, or of a seam too narrow, hide none behind them.
    struct NearEdge {
        NearCurve at;
        std::uint32_t edge = no_index; ///< into SurfaceModel::edges
    };
    std::optional<NearEdge> nearest_edge(const Vec2& face_parameters, const ParameterMetric& metric,
                                         double most,
                                         std::span<const std::uint32_t> among = {}) const;
    /// Whether nearest_edge may find a place in the box, of face parameters: by what boxes
    /// and strips hold the curves, much quicker.
    bool may_be_near_edge(const Box2& around) const;
    /// Edges of the face's loops, sorted.
    std::span<const std::uint32_t> edges() const { return edges_; }
    /// True for a face without loops.
    bool untrimmed() const { return pieces_.empty(); }
    /// Box of all trim curves in face parameters; empty for a face without loops.
    const Box2& bounds() const { return bounds_; }
    /// Of its arrays.
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

    /// Of one of pieces_.
    struct PieceEdge {
        std::uint32_t edge = no_index;
        double width = 0; ///< mm; 0 without an edge
    };

    std::vector<MonotonePiece> pieces_;
    std::vector<PieceEdge> piece_edges_;
    std::vector<std::uint32_t> edges_;
    Box2 bounds_;
    // Rows of constant v between neighbouring entries of row_borders_; row r holds the pieces
    // row_pieces_[row_begin_[r]] .. row_pieces_[row_begin_[r + 1] - 1], those that reach
    // farthest right first.
    std::vector<double> row_borders_;
    std::vector<std::uint32_t> row_begin_, row_pieces_;
};

} // namespace keiko
