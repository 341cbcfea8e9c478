#include "fixtures.h"
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace keiko::fixtures {
namespace {

constexpr double kLength = 60.0, kWidth = 40.0, kHeight = 24.0; // along x, y, z
constexpr double kFillet = 5.0, kBore = 6.0;                    // radii

TopoDS_Shape rounded_box() {
    const TopoDS_Shape box =
        BRepPrimAPI_MakeBox(gp_Pnt(-kLength / 2, -kWidth / 2, 0.0), kLength, kWidth, kHeight)
            .Shape();
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(box, TopAbs_EDGE, edges);
    BRepFilletAPI_MakeFillet fillet(box);
    for (int i = 1; i <= edges.Extent(); ++i) fillet.Add(kFillet, TopoDS::Edge(edges(i)));
    return fillet.Shape();
}

TopoDS_Shape bored_block_shape() {
    const gp_Ax2 axis(gp_Pnt(0.0, 0.0, -1.0), gp_Dir(0.0, 0.0, 1.0));
    return BRepAlgoAPI_Cut(rounded_box(),
                           BRepPrimAPI_MakeCylinder(axis, kBore, kHeight + 2.0).Shape())
        .Shape();
}

std::string kind_of(const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face);
    switch (surface.GetType()) {
        case GeomAbs_Plane:
            return "side";
        case GeomAbs_Sphere:
            return "corner";
        case GeomAbs_Cylinder:
            return std::abs(surface.Cylinder().Radius() - kBore) < 1e-9 ? "bore" : "fillet";
        default:
            return "face";
    }
}

/// Centre of the face, to 1e-6 mm: orders the faces whatever order they were made in.
std::tuple<double, double, double> place_of(const TopoDS_Face& face) {
    GProp_GProps mass;
    BRepGProp::SurfaceProperties(face, mass);
    const gp_Pnt center = mass.CentreOfMass();
    const auto rounded = [](double x) { return std::round(x * 1e6); };
    return {rounded(center.X()), rounded(center.Y()), rounded(center.Z())};
}

std::vector<NamedFace> named_faces(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
        faces.push_back(TopoDS::Face(e.Current()));
    std::sort(faces.begin(), faces.end(),
              [](const TopoDS_Face& a, const TopoDS_Face& b) { return place_of(a) < place_of(b); });
    std::vector<NamedFace> named;
    std::map<std::string, int> count;
    for (const TopoDS_Face& face : faces) {
        const std::string kind = kind_of(face);
        named.push_back({kind + "-" + std::to_string(count[kind]++), face});
    }
    return named;
}

/// The box without its outermost 5 mm, grown by them again (Steiner's formula), less the bore.
double promised_volume() {
    const double a = kLength - 2 * kFillet, b = kWidth - 2 * kFillet, c = kHeight - 2 * kFillet;
    const double pi = std::numbers::pi, r = kFillet;
    return a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) +
           4.0 / 3.0 * pi * r * r * r - pi * kBore * kBore * kHeight;
}

} // namespace

Fixture bored_block() {
    const TopoDS_Shape shape = bored_block_shape();
    GProp_GProps mass;
    BRepGProp::VolumeProperties(shape, mass);
    Fixture fixture{"bored-block.step", named_faces(shape), {}};
    fixture.truths = {{"faces", "", 27.0, static_cast<double>(fixture.faces.size()), 0.0},
                      {"volume", "mm^3", promised_volume(), mass.Mass(), 1e-6 * mass.Mass()}};
    return fixture;
}

} // namespace keiko::fixtures
