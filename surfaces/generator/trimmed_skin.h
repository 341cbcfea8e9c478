#pragma once

#include "shape_pool.h"
#include <Geom2d_Curve.hxx>

#include <set>

namespace keiko::fixtures {

/// A trim curve as a boundary on one of its skins: `side` says which. What is kept lies to its
/// left in the (u, v) plane, or to its right if reversed.
struct Boundary {
    const TrimCurve* curve;
    std::size_t side;
    bool reversed = false;
};

/// One part of a skin: what its boundaries leave, and the whole cells that `keeps` wants among
/// those that no boundary runs through.
struct Region {
    std::string name;
    std::vector<Boundary> boundaries;
    std::function<bool(Cell)> keeps;
};

/// Cuts a skin into faces, one for each cell and region (more where the cell falls apart), with
/// edges and vertices shared between neighbours.
class TrimmedSkin {
public:
    /// `curves` are all the trim curves on the skin, whatever regions they bound. `outward` says
    /// that du x dv points out of the body. Skin, curves and pool are only referred to.
    TrimmedSkin(const Skin& skin, const std::vector<Boundary>& curves, bool outward,
                ShapePool& pool);

    std::vector<NamedFace> faces(const Region& region);

private:
    /// The line from a cell's lower left corner along u (axis 0) or v (axis 1).
    struct Border {
        int axis;
        Cell from;
        auto operator<=>(const Border&) const = default;
    };
    struct OrientedEdge {
        TopoDS_Edge edge;
        /// The edge's curve in the cell's own parameters.
        Handle(Geom2d_Curve) uv_curve;
        bool reversed;
    };
    /// A boundary inside a cell, with the places around the cell's rim (0 to 4, counter-clockwise
    /// from the lower left corner) where it comes in and goes out.
    struct Chord {
        std::vector<OrientedEdge> edges{};
        double enters = 0.0;
        double leaves = 0.0;
        bool closed = false;
        /// Twice the enclosed area if closed, negative for a hole.
        double area = 0.0;
    };
    using Loop = std::vector<OrientedEdge>;

    void note_border_point(gp_XY uv);
    /// For each face that the region has in the cell, its outer loop and its holes.
    std::vector<std::vector<Loop>> face_loops(const Region& region, Cell cell);
    std::vector<Chord> chords(const Boundary& boundary, Cell cell) const;
    Chord chord(const Boundary& boundary, const std::vector<const TrimPiece*>& run,
                bool closed) const;
    /// Walks along chords and, between them, counter-clockwise along the rim.
    std::vector<Loop> loops(const std::vector<Chord>& open_chords, Cell cell);
    Loop rim(Cell cell, double from, double to);
    OrientedEdge border_edge(Cell cell, int side, double from, double to);
    Border border_of(Cell cell, int side) const;
    TopoDS_Face face(Cell cell, const std::vector<Loop>& loops) const;

    const Skin& skin_;
    bool outward_;
    ShapePool& pool_;
    std::map<Border, std::set<double>> border_points_;
    std::map<std::pair<Border, double>, TopoDS_Edge> border_edges_;
};

} // namespace keiko::fixtures
