#include "trimmed_skin.h"

#include <BRep_Builder.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace keiko::fixtures {
namespace {

constexpr double kOnBorder = 1e-9;

/// Place of a point on the unit square's rim: 0 to 4 counter-clockwise from (0, 0).
double rim_place(gp_XY uv) {
    if (std::abs(uv.Y()) < kOnBorder) return uv.X();
    if (std::abs(uv.X() - 1.0) < kOnBorder) return 1.0 + uv.Y();
    if (std::abs(uv.Y() - 1.0) < kOnBorder) return 3.0 - uv.X();
    if (std::abs(uv.X()) < kOnBorder) return 4.0 - uv.Y();
    throw std::runtime_error("a trim curve ends inside a patch");
}

/// How far it is counter-clockwise along the rim: in (0, 4].
double rim_distance(double from, double to) {
    return to > from ? to - from : to - from + 4.0;
}

Handle(Geom2d_Curve) bezier_curve(const std::vector<gp_XY>& poles, Cell cell) {
    TColgp_Array1OfPnt2d array(1, static_cast<int>(poles.size()));
    for (int k = 1; k <= array.Length(); ++k)
        array(k) = gp_Pnt2d(poles[static_cast<std::size_t>(k - 1)] - gp_XY(cell.column, cell.row));
    return new Geom2d_BezierCurve(array);
}

double doubled_area(const std::vector<gp_XY>& poles) {
    double area = 0.0;
    for (std::size_t k = 1; k < poles.size(); ++k) area += poles[k - 1].Crossed(poles[k]);
    return area;
}

/// A side's control points of a patch, always in the direction of growing u or v.
std::vector<gp_XYZ> side_poles(const Handle(Geom_BezierSurface) & patch, int side) {
    const bool along_u = side == 0 || side == 2;
    const int count = along_u ? patch->NbUPoles() : patch->NbVPoles();
    std::vector<gp_XYZ> poles;
    for (int k = 1; k <= count; ++k) {
        const int u = along_u ? k : (side == 1 ? patch->NbUPoles() : 1);
        const int v = along_u ? (side == 2 ? patch->NbVPoles() : 1) : k;
        poles.push_back(patch->Pole(u, v).XYZ());
    }
    return poles;
}

/// "body-c03-r1": the cell's column and row keep names apart.
std::string cell_name(const std::string& region, Cell cell) {
    const std::string column = std::to_string(cell.column);
    return region + (column.size() < 2 ? "-c0" : "-c") + column + "-r" + std::to_string(cell.row);
}

bool is_closed(const TrimCurve& curve) {
    return (curve.front().poles.front() - curve.back().poles.back()).Modulus() < 1e-6;
}

/// The pieces in the direction of the boundary.
std::vector<const TrimPiece*> directed_pieces(const TrimCurve& curve, bool reversed) {
    std::vector<const TrimPiece*> pieces;
    for (const TrimPiece& piece : curve) pieces.push_back(&piece);
    if (reversed) std::reverse(pieces.begin(), pieces.end());
    return pieces;
}

} // namespace

TrimmedSkin::TrimmedSkin(const Skin& skin, const std::vector<Boundary>& curves, bool outward,
                         ShapePool& pool)
    : skin_(skin), outward_(outward), pool_(pool) {
    for (const Boundary& boundary : curves)
        for (const TrimPiece& piece : *boundary.curve) {
            note_border_point(piece.uv_poles[boundary.side].front());
            note_border_point(piece.uv_poles[boundary.side].back());
        }
}

void TrimmedSkin::note_border_point(gp_XY uv) {
    const gp_XY base(std::floor(uv.X() + kOnBorder), std::floor(uv.Y() + kOnBorder));
    const gp_XY local = uv - base;
    const Cell from{skin_.wrapped_column(static_cast<int>(base.X())), static_cast<int>(base.Y())};
    if (std::abs(local.Y()) < kOnBorder)
        border_points_[{0, from}].insert(local.X());
    else if (std::abs(local.X()) < kOnBorder)
        border_points_[{1, from}].insert(local.Y());
}

std::vector<NamedFace> TrimmedSkin::faces(const Region& region) {
    std::vector<NamedFace> faces;
    for (int i = 0; i < skin_.columns(); ++i)
        for (int j = 0; j < skin_.rows(); ++j)
            for (const std::vector<Loop>& loops : face_loops(region, {i, j}))
                faces.push_back({cell_name(region.name, {i, j}), face({i, j}, loops)});
    return faces;
}

std::vector<std::vector<TrimmedSkin::Loop>> TrimmedSkin::face_loops(const Region& region,
                                                                    Cell cell) {
    std::vector<Chord> open;
    std::vector<Loop> outer;
    std::vector<Loop> holes;
    for (const Boundary& boundary : region.boundaries)
        for (const Chord& chord : chords(boundary, cell)) {
            if (!chord.closed)
                open.push_back(chord);
            else
                (chord.area > 0.0 ? outer : holes).push_back(chord.edges);
        }
    if (!open.empty())
        outer = loops(open, cell);
    else if (outer.empty() && (!holes.empty() || region.keeps(cell)))
        outer = {rim(cell, 0.0, 4.0)};

    std::vector<std::vector<Loop>> faces;
    for (const Loop& loop : outer) {
        faces.push_back({loop});
        // Holes in a cell that falls apart would have to be sorted; none of the fixtures has both.
        faces.back().insert(faces.back().end(), holes.begin(), holes.end());
    }
    return faces;
}

std::vector<TrimmedSkin::Chord> TrimmedSkin::chords(const Boundary& boundary, Cell cell) const {
    const auto inside = [&](const TrimPiece* piece) {
        const Cell place = piece->cells[boundary.side];
        return skin_.wrapped_column(place.column) == cell.column && place.row == cell.row;
    };
    std::vector<const TrimPiece*> pieces = directed_pieces(*boundary.curve, boundary.reversed);
    const auto outside = std::find_if_not(pieces.begin(), pieces.end(), inside);
    const bool wholly_inside = outside == pieces.end();
    // A closed curve may pass the cell with its end: start it elsewhere.
    if (is_closed(*boundary.curve)) std::rotate(pieces.begin(), outside, pieces.end());

    std::vector<Chord> chords;
    std::vector<const TrimPiece*> run;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (!inside(pieces[k])) continue;
        run.push_back(pieces[k]);
        if (k + 1 < pieces.size() && inside(pieces[k + 1])) continue;
        chords.push_back(chord(boundary, run, wholly_inside));
        run.clear();
    }
    return chords;
}

TrimmedSkin::Chord TrimmedSkin::chord(const Boundary& boundary,
                                      const std::vector<const TrimPiece*>& run, bool closed) const {
    const auto uv = [&](const TrimPiece* piece) { return piece->uv_poles[boundary.side]; };
    const Cell cell = run.front()->cells[boundary.side];
    Chord chord{.closed = closed};
    for (const TrimPiece* piece : run) {
        chord.edges.push_back(
            {pool_.edge(*piece), bezier_curve(uv(piece), cell), boundary.reversed});
        chord.area += (boundary.reversed ? -1.0 : 1.0) * doubled_area(uv(piece));
    }
    if (closed) return chord;
    const gp_XY corner(cell.column, cell.row);
    const auto start = boundary.reversed ? uv(run.front()).back() : uv(run.front()).front();
    const auto end = boundary.reversed ? uv(run.back()).front() : uv(run.back()).back();
    chord.enters = rim_place(start - corner);
    chord.leaves = rim_place(end - corner);
    return chord;
}

std::vector<TrimmedSkin::Loop> TrimmedSkin::loops(const std::vector<Chord>& open_chords,
                                                  Cell cell) {
    std::vector<Loop> loops;
    std::vector<bool> used(open_chords.size(), false);
    for (std::size_t first = 0; first < open_chords.size(); ++first) {
        if (used[first]) continue;
        Loop loop;
        for (std::size_t current = first; !used[current];) {
            used[current] = true;
            const Chord& chord = open_chords[current];
            loop.insert(loop.end(), chord.edges.begin(), chord.edges.end());
            for (std::size_t k = 0; k < open_chords.size(); ++k)
                if (rim_distance(chord.leaves, open_chords[k].enters) <
                    rim_distance(chord.leaves, open_chords[current].enters))
                    current = k;
            const Loop border = rim(cell, chord.leaves, open_chords[current].enters);
            loop.insert(loop.end(), border.begin(), border.end());
        }
        loops.push_back(loop);
    }
    return loops;
}

TrimmedSkin::Loop TrimmedSkin::rim(Cell cell, double from, double to) {
    const double end = from + rim_distance(from, to);
    Loop loop;
    for (double place = from; place < end;) {
        const int side = static_cast<int>(std::floor(place + kOnBorder));
        double next = std::min(end, side + 1.0);
        for (const double point : border_points_[border_of(cell, side % 4)]) {
            const double there = side + (side % 4 < 2 ? point : 1.0 - point);
            if (there > place + kOnBorder && there < next - kOnBorder) next = there;
        }
        if (next > place + kOnBorder)
            loop.push_back(border_edge(cell, side % 4, place - side, next - side));
        place = next;
    }
    return loop;
}

TrimmedSkin::Border TrimmedSkin::border_of(Cell cell, int side) const {
    if (side == 1) ++cell.column;
    if (side == 2) ++cell.row;
    cell.column = skin_.wrapped_column(cell.column);
    return {side % 2, cell};
}

TrimmedSkin::OrientedEdge TrimmedSkin::border_edge(Cell cell, int side, double from, double to) {
    const bool forward = side < 2;
    const double first = forward ? from : 1.0 - to;
    const double last = forward ? to : 1.0 - from;
    const gp_Pnt2d origin(side == 1 ? 1.0 : 0.0, side == 2 ? 1.0 : 0.0);
    const Handle(Geom2d_Curve) line =
        new Geom2d_Line(origin, side % 2 == 0 ? gp_Dir2d(1.0, 0.0) : gp_Dir2d(0.0, 1.0));
    // Neighbours may differ in the last bits of the parameter, never in the millionth edge.
    const auto key = std::pair{border_of(cell, side), std::round(first * 1e6)};
    auto known = border_edges_.find(key);
    if (known == border_edges_.end()) {
        const Handle(Geom_BezierSurface)& patch = skin_.patch(cell);
        const auto at = [&](double parameter) {
            const gp_Pnt2d uv = line->Value(parameter);
            return pool_.vertex(patch->Value(uv.X(), uv.Y()).XYZ());
        };
        const TopoDS_Edge edge = bezier_edge(side_poles(patch, side), at(first), at(last), first,
                                             last, Precision::Confusion());
        known = border_edges_.emplace(key, edge).first;
    }
    return {known->second, line, !forward};
}

TopoDS_Face TrimmedSkin::face(Cell cell, const std::vector<Loop>& loops) const {
    const BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, skin_.patch(cell), Precision::Confusion());
    for (const Loop& loop : loops) {
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        for (const OrientedEdge& part : loop) {
            const double tolerance = 0.0; // BRep_Builder keeps the larger, the edge's own
            builder.UpdateEdge(part.edge, part.uv_curve, face, tolerance);
            builder.Add(wire, part.edge.Oriented(part.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
        }
        wire.Closed(true);
        builder.Add(face, wire);
    }
    if (!outward_) face.Reverse();
    return face;
}

} // namespace keiko::fixtures
