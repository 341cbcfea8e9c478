#include "keiko/import/cad/shape_attributes.h"

#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>

namespace keiko::cad {
namespace {

std::string utf8(const TCollection_ExtendedString& text) {
    return TCollection_AsciiString(text).ToCString();
}

/// Many programs leave an occurrence of STEP without a name; what OpenCASCADE calls it then is its
/// number in the file.
bool is_number(const std::string& name) {
    return !name.empty() &&
           std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

} // namespace

std::string name_of(const TDF_Label& label) {
    opencascade::handle<TDataStd_Name> name;
    return label.FindAttribute(TDataStd_Name::GetID(), name) ? utf8(name->Get()) : "";
}

std::string name_of(const TDF_Label& component, const TDF_Label& product) {
    const std::string own = name_of(component), of_product = name_of(product);
    const bool says_nothing = own.empty() || (is_number(own) && !of_product.empty());
    return says_nothing ? of_product : own;
}

FaceAttributes merged(FaceAttributes own, const FaceAttributes& outer) {
    if (own.layer.empty()) own.layer = outer.layer;
    if (!own.color) own.color = outer.color;
    return own;
}

ShapeAttributes::ShapeAttributes(const TDF_Label& main)
    : colors_(XCAFDoc_DocumentTool::ColorTool(main)),
      layers_(XCAFDoc_DocumentTool::LayerTool(main)) {}

FaceAttributes ShapeAttributes::own(const TDF_Label& label) const {
    FaceAttributes result;
    Quantity_Color color;
    if (colors_->GetColor(label, XCAFDoc_ColorSurf, color) ||
        colors_->GetColor(label, XCAFDoc_ColorGen, color))
        result.color = Rgb(color.Red(), color.Green(), color.Blue());
    opencascade::handle<TColStd_HSequenceOfExtendedString> layers;
    if (layers_->GetLayers(label, layers) && !layers.IsNull() && !layers->IsEmpty())
        result.layer = utf8(layers->First());
    return result;
}

AttributeMap ShapeAttributes::of_faces(const TDF_Label& part) const {
    AttributeMap map;
    TDF_LabelSequence labels;
    XCAFDoc_ShapeTool::GetSubShapes(part, labels);
    std::vector<std::pair<TopoDS_Shape, FaceAttributes>> larger;
    for (const TDF_Label& label : labels) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
        if (shape.IsNull() || shape.ShapeType() > TopAbs_FACE) continue;
        FaceAttributes attributes = own(label);
        if (shape.ShapeType() == TopAbs_FACE) {
            attributes.name = name_of(label);
            map[shape] = attributes;
        } else {
            larger.emplace_back(shape, std::move(attributes));
        }
    }
    // Smaller shapes first: a face keeps what its shell says before what its solid says.
    std::stable_sort(larger.begin(), larger.end(), [](const auto& a, const auto& b) {
        return a.first.ShapeType() > b.first.ShapeType();
    });
    for (const auto& [shape, attributes] : larger) {
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        for (int i = 1; i <= faces.Extent(); ++i) map[faces(i)] = merged(map[faces(i)], attributes);
    }
    return map;
}

} // namespace keiko::cad
