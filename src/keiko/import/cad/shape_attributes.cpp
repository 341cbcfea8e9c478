#include "keiko/import/cad/shape_attributes.h"

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>

#include <algorithm>
#include <memory>
#include <set>
#include <unordered_map>

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

namespace {

using Entity = opencascade::handle<Standard_Transient>;
using RemarkMap = std::unordered_map<const TopoDS_TShape*, std::vector<std::string>>;

class RemarkReader {
public:
    RemarkReader(const opencascade::handle<XSControl_WorkSession>& session,
                 Diagnostics& diagnostics)
        : session_(session),
          process_(session->TransferReader()->TransientProcess()),
          diagnostics_(diagnostics) {}

    std::shared_ptr<RemarkMap> read() {
        for (int i = 1; i <= process_->NbMapped(); ++i) {
            const auto binder = process_->MapItem(i);
            if (binder.IsNull()) continue;
            const auto check = binder->Check();
            for (int k = 1; k <= check->NbWarnings(); ++k)
                take(process_->Mapped(i), words(check->CWarning(k)));
        }
        return std::move(remarks_);
    }

private:
    static std::string words(std::string text) {
        text.erase(0, text.find_first_not_of(' '));
        return text;
    }

    void take(const Entity& entity, const std::string& remark) {
        const std::set<const TopoDS_TShape*> faces = faces_from(entity);
        for (const TopoDS_TShape* face : faces) (*remarks_)[face].push_back(remark);
        if (faces.empty())
            diagnostics_.push_back({Severity::note, label(entity), "CAD reader: " + remark});
    }

    std::string label(const Entity& entity) const {
        const auto text = session_->Model()->StringLabel(entity);
        return text.IsNull() ? "" : std::string("entity ") + text->ToCString();
    }

    /// Faces that the entity became, or that were made from it.
    std::set<const TopoDS_TShape*> faces_from(const Entity& entity) const {
        constexpr std::size_t most_visited = 1000;
        std::set<const TopoDS_TShape*> faces;
        std::vector<Entity> open{entity};
        std::set<const Standard_Transient*> visited{entity.get()};
        for (std::size_t i = 0; i < open.size() && i < most_visited; ++i) {
            const TopoDS_Shape shape = TransferBRep::ShapeResult(process_, open[i]);
            if (!shape.IsNull() && shape.ShapeType() <= TopAbs_FACE) {
                if (shape.ShapeType() == TopAbs_FACE) faces.insert(shape.TShape().get());
                continue;
            }
            for (Interface_EntityIterator user = session_->Graph().Sharings(open[i]); user.More();
                 user.Next())
                if (visited.insert(user.Value().get()).second) open.push_back(user.Value());
        }
        return faces;
    }

    opencascade::handle<XSControl_WorkSession> session_;
    opencascade::handle<Transfer_TransientProcess> process_;
    Diagnostics& diagnostics_;
    std::shared_ptr<RemarkMap> remarks_ = std::make_shared<RemarkMap>();
};

} // namespace

FaceRemarks reader_remarks(const opencascade::handle<XSControl_WorkSession>& session,
                           Diagnostics& diagnostics) {
    return [remarks = RemarkReader(session, diagnostics).read()](const TopoDS_Shape& face) {
        const auto found = remarks->find(face.TShape().get());
        return found == remarks->end() ? std::vector<std::string>{} : found->second;
    };
}

} // namespace keiko::cad
