#pragma once

#include "keiko/base/error.h"
#include "keiko/import/cad/cad_document.h"

#include <TDF_Label.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XSControl_WorkSession.hxx>

#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

namespace keiko::cad {

/// Hash and equality of shapes of one geometry in one place, whatever their orientation.
struct SameShape {
    /// Hash that is the same for either orientation.
    std::size_t operator()(const TopoDS_Shape& s) const {
        return static_cast<std::size_t>(s.HashCode(2147483647));
    }
    /// True if shapes share geometry and place; their orientations may differ.
    bool operator()(const TopoDS_Shape& a, const TopoDS_Shape& b) const { return a.IsSame(b); }
};
/// Attributes by face.
using AttributeMap = std::unordered_map<TopoDS_Shape, FaceAttributes, SameShape, SameShape>;

/// The name of a label; empty without one.
std::string name_of(const TDF_Label& label);
/// Name of a component: its own, or else that of the product that it places.
std::string name_of(const TDF_Label& component, const TDF_Label& product);

/// `own`, with what it does not say taken from `outer`; names are not inherited.
FaceAttributes merged(FaceAttributes own, const FaceAttributes& outer);

/// Names, layers and colours in a document.
class ShapeAttributes {
public:
    /// Attributes of the document whose main label is given.
    explicit ShapeAttributes(const TDF_Label& main);

    /// Layer and colour that a label itself carries.
    FaceAttributes own(const TDF_Label& label) const;
    /// Attributes of the faces of a part that have their own or lie in a shell or solid with its
    /// own.
    AttributeMap of_faces(const TDF_Label& part) const;

private:
    opencascade::handle<XCAFDoc_ColorTool> colors_;
    opencascade::handle<XCAFDoc_LayerTool> layers_;
};

/// Remarks of OpenCASCADE's translator on what it mended, by face.
using FaceRemarks = std::function<std::vector<std::string>(const TopoDS_Shape& face)>;

/// The warnings of a finished transfer from a STEP or IGES file. Those on an entity that no face
/// is made from go to `diagnostics`.
FaceRemarks reader_remarks(const opencascade::handle<XSControl_WorkSession>& session,
                           Diagnostics& diagnostics);

} // namespace keiko::cad
