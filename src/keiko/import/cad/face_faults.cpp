#include "keiko/base/error.h"
#include "keiko/import/cad/face_conversion.h"

#include <BRepCheck_Edge.hxx>
#include <BRepCheck_Face.hxx>
#include <BRepCheck_Vertex.hxx>
#include <BRepCheck_Wire.hxx>
#include <BRep_TVertex.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <new>

namespace keiko::cad {

std::string current_failure() {
    std::string text;
    try {
        throw;
    } catch (const Error& e) {
        text = e.reason();
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();
    } catch (const Standard_Failure& e) {
        const std::string message = e.GetMessageString() ? e.GetMessageString() : "";
        text = std::string("OpenCASCADE: ") + e.DynamicType()->Name() +
               (message.empty() ? "" : ": " + message);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        text = e.what();
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

namespace {

bool holds(const BRepCheck_ListOfStatus& statuses) {
    for (const BRepCheck_Status status : statuses)
        if (status != BRepCheck_NoError) return false;
    return true;
}

bool holds(const opencascade::handle<BRepCheck_Result>& check) {
    return holds(check->Status());
}

bool holds_in(const opencascade::handle<BRepCheck_Result>& check, const TopoDS_Shape& shape) {
    check->InContext(shape);
    return holds(check->StatusOnShape(shape));
}

/// Few vertices have parameters of their own on a surface, which can be wrong.
bool has_parameters(const TopoDS_Vertex& vertex) {
    return !opencascade::handle<BRep_TVertex>::DownCast(vertex.TShape())->Points().IsEmpty();
}

bool vertices_hold(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    TopTools_MapOfShape seen;
    for (TopExp_Explorer e(edge, TopAbs_VERTEX); e.More(); e.Next()) {
        if (!seen.Add(e.Current())) continue;
        const TopoDS_Vertex vertex = TopoDS::Vertex(e.Current());
        const opencascade::handle<BRepCheck_Result> check = new BRepCheck_Vertex(vertex);
        if (!holds(check) || !holds_in(check, edge)) return false;
        if (has_parameters(vertex) && !holds_in(check, face)) return false;
    }
    return true;
}

bool edges_hold(const TopoDS_Face& face) {
    TopTools_MapOfShape seen;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        if (!seen.Add(e.Current())) continue;
        const TopoDS_Edge edge = TopoDS::Edge(e.Current());
        const opencascade::handle<BRepCheck_Edge> check = new BRepCheck_Edge(edge);
        if (!holds(check) || check->CheckPolygonOnTriangulation(edge) != BRepCheck_NoError ||
            !vertices_hold(edge, face) || !holds_in(check, face))
            return false;
    }
    return true;
}

bool wires_hold(const TopoDS_Face& face) {
    TopTools_MapOfShape seen;
    for (TopExp_Explorer e(face, TopAbs_WIRE); e.More(); e.Next()) {
        if (!seen.Add(e.Current())) continue;
        const opencascade::handle<BRepCheck_Result> check =
            new BRepCheck_Wire(TopoDS::Wire(e.Current()));
        if (!holds(check) || !holds_in(check, face)) return false;
    }
    return true;
}

/// Each step relies on those before it.
bool is_valid(const TopoDS_Face& face, KnownLoops known) {
    const opencascade::handle<BRepCheck_Face> check = new BRepCheck_Face(face);
    return holds(check) && edges_hold(face) && wires_hold(face) &&
           (known == KnownLoops::one_forward_loop ||
            check->OrientationOfWires() == BRepCheck_NoError);
}

} // namespace

std::string fault_of(const TopoDS_Face& face, KnownLoops known) {
    try {
        if (is_valid(face, known)) return "";
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();
    } catch (const Standard_Failure&) {
        // The check failed on the face: neither does the face pass.
    } catch (...) {
        return "could not be checked: " + current_failure();
    }
    return "invalid in the file, says OpenCASCADE's check";
}

} // namespace keiko::cad
