#include "keiko/io/cad/assembly.h"

#include "keiko/io/cad/alike_shapes.h"
#include "keiko/io/cad/part_conversion.h"
#include "keiko/io/cad/transforms.h"

#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <map>
#include <memory>
#include <unordered_map>

namespace keiko::cad {
namespace {

std::string utf8(const TCollection_ExtendedString& text) {
    return TCollection_AsciiString(text).ToCString();
}

std::string name_of(const TDF_Label& label) {
    opencascade::handle<TDataStd_Name> name;
    return label.FindAttribute(TDataStd_Name::GetID(), name) ? utf8(name->Get()) : "";
}

/// Many programs leave an occurrence of STEP without a name; what OpenCASCADE calls it then is its
/// number in the file.
bool is_number(const std::string& name) {
    return !name.empty() &&
           std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// What a component is called: as it says itself, or else as the product that it places.
std::string name_of(const TDF_Label& component, const TDF_Label& product) {
    const std::string own = name_of(component), of_product = name_of(product);
    const bool says_nothing = own.empty() || (is_number(own) && !of_product.empty());
    return says_nothing ? of_product : own;
}

struct SameShape {
    std::size_t operator()(const TopoDS_Shape& s) const {
        return static_cast<std::size_t>(s.HashCode(2147483647));
    }
    bool operator()(const TopoDS_Shape& a, const TopoDS_Shape& b) const { return a.IsSame(b); }
};
using AttributeMap = std::unordered_map<TopoDS_Shape, FaceAttributes, SameShape, SameShape>;

class AssemblyReader {
public:
    AssemblyReader(const TDF_Label& main, FaceNames face_names, MappedItems& mapped,
                   CadDocument& document)
        : face_names_(std::move(face_names)),
          mapped_(mapped),
          shapes_(XCAFDoc_DocumentTool::ShapeTool(main)),
          colors_(XCAFDoc_DocumentTool::ColorTool(main)),
          layers_(XCAFDoc_DocumentTool::LayerTool(main)),
          document_(document) {}

    void read() {
        TDF_LabelSequence roots;
        shapes_->GetFreeShapes(roots);
        std::vector<TDF_Label> loose_faces, trees;
        for (const TDF_Label& root : roots)
            (shape_of(root).ShapeType() == TopAbs_FACE ? loose_faces : trees).push_back(root);
        for (const TDF_Label& root : trees)
            if (!shown_elsewhere(root, trees)) place_root(root, trees);
        if (!loose_faces.empty()) gather(loose_faces);
    }

private:
    /// One part of all faces that belong to no shell: a file of surfaces is one thing.
    void gather(const std::vector<TDF_Label>& labels) {
        TopoDS_Compound compound;
        BRep_Builder builder;
        builder.MakeCompound(compound);
        auto attributes = std::make_shared<AttributeMap>();
        for (const TDF_Label& label : labels) {
            const TopoDS_Shape face = XCAFDoc_ShapeTool::GetShape(label);
            builder.Add(compound, face);
            FaceAttributes own = own_attributes(label);
            own.name = face_names_ ? face_names_(face) : name_of(label);
            attributes->emplace(face, std::move(own));
        }
        document_.instances.push_back({document_.parts.size(), "", {}});
        document_.parts.push_back({compound, "", [attributes](const TopoDS_Shape& face) {
                                       const auto found = attributes->find(face);
                                       return found == attributes->end() ? FaceAttributes{}
                                                                         : found->second;
                                   }});
    }

    static TopoDS_Shape shape_of(const TDF_Label& label) {
        return XCAFDoc_ShapeTool::GetShape(label);
    }

    /// Whether a root is an assembly and `lump` a place of the same compound as one piece: XCAF
    /// makes both of a compound that is not in its own place.
    static bool spreads_out(const TDF_Label& root, const TDF_Label& lump) {
        TDF_Label referred;
        return XCAFDoc_ShapeTool::IsAssembly(root) &&
               XCAFDoc_ShapeTool::GetReferredShape(lump, referred) &&
               !XCAFDoc_ShapeTool::IsAssembly(referred) &&
               alike(shape_of(root), shape_of(referred));
    }

    bool shown_elsewhere(const TDF_Label& root, const std::vector<TDF_Label>& roots) const {
        return !mapped_.is_product(shape_of(root)) &&
               std::any_of(roots.begin(), roots.end(),
                           [&](const TDF_Label& lump) { return spreads_out(root, lump); });
    }

    void place_root(const TDF_Label& root, const std::vector<TDF_Label>& roots) {
        const Affine correction = mapped_.corrections({shape_of(root)})[0];
        const auto spread = std::find_if(roots.begin(), roots.end(), [&](const TDF_Label& other) {
            return spreads_out(other, root);
        });
        if (spread == roots.end()) return place(root, correction, {}, name_of(root), {});
        place(*spread, correction, affine(place_of(shape_of(root))), name_of(root),
              own_attributes(root));
    }

    /// Walks down to the parts; `inherited` holds what the components above say, `correction` what
    /// comes before the place of the label.
    void place(const TDF_Label& label, const Affine& correction, const Affine& above,
               const std::string& name, const FaceAttributes& inherited) {
        if (XCAFDoc_ShapeTool::IsReference(label)) {
            TDF_Label referred;
            XCAFDoc_ShapeTool::GetReferredShape(label, referred);
            const Affine here = affine(XCAFDoc_ShapeTool::GetLocation(label).Transformation());
            place(referred, {}, above * here * correction, name_of(label, referred),
                  merged(own_attributes(label), inherited));
        } else if (XCAFDoc_ShapeTool::IsAssembly(label)) {
            place_components(label, above * correction, merged(own_attributes(label), inherited));
        } else if (const auto part = part_of(label, inherited)) {
            document_.instances.push_back({*part, name, above * correction});
        }
    }

    void place_components(const TDF_Label& label, const Affine& above,
                          const FaceAttributes& inherited) {
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(label, components);
        std::vector<TopoDS_Shape> shapes;
        for (const TDF_Label& component : components) shapes.push_back(shape_of(component));
        const std::vector<Affine> corrections = mapped_.corrections(shapes);
        for (int i = 0; i < components.Length(); ++i)
            place(components(i + 1), corrections[static_cast<std::size_t>(i)], above,
                  name_of(components(i + 1)), inherited);
    }

    std::optional<std::size_t> part_of(const TDF_Label& label, const FaceAttributes& inherited) {
        TCollection_AsciiString entry;
        TDF_Tool::Entry(label, entry);
        const auto [known, is_new] = part_numbers_.try_emplace(entry.ToCString());
        if (is_new) known->second = new_part(label, inherited);
        return known->second;
    }

    std::optional<std::size_t> new_part(const TDF_Label& label, const FaceAttributes& inherited) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
        const std::string name = name_of(label);
        if (shape.IsNull() || face_count(shape) == 0) {
            document_.diagnostics.push_back(
                {Severity::note, name, "a part without faces left out"});
            return std::nullopt;
        }
        auto known = std::make_shared<AttributeMap>(sub_shape_attributes(label));
        const FaceAttributes fallback = merged(own_attributes(label), inherited);
        document_.parts.push_back(
            {shape, name, [known, fallback, names = face_names_](const TopoDS_Shape& face) {
                 const auto found = known->find(face);
                 FaceAttributes result;
                 if (found != known->end()) result = found->second;
                 if (names) result.name = names(face);
                 return merged(std::move(result), fallback);
             }});
        return document_.parts.size() - 1;
    }

    /// Attributes of the faces that have their own, or that a shell or solid with its own holds.
    AttributeMap sub_shape_attributes(const TDF_Label& part) const {
        AttributeMap map;
        TDF_LabelSequence labels;
        XCAFDoc_ShapeTool::GetSubShapes(part, labels);
        std::vector<std::pair<TopoDS_Shape, FaceAttributes>> larger;
        for (const TDF_Label& label : labels) {
            const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
            if (shape.IsNull() || shape.ShapeType() > TopAbs_FACE) continue;
            FaceAttributes own = own_attributes(label);
            if (shape.ShapeType() == TopAbs_FACE) {
                own.name = name_of(label);
                map[shape] = own;
            } else {
                larger.emplace_back(shape, std::move(own));
            }
        }
        // Smaller shapes first: a face keeps what its shell says before what its solid says.
        std::stable_sort(larger.begin(), larger.end(), [](const auto& a, const auto& b) {
            return a.first.ShapeType() > b.first.ShapeType();
        });
        for (const auto& [shape, attributes] : larger) {
            TopTools_IndexedMapOfShape faces;
            TopExp::MapShapes(shape, TopAbs_FACE, faces);
            for (int i = 1; i <= faces.Extent(); ++i)
                map[faces(i)] = merged(map[faces(i)], attributes);
        }
        return map;
    }

    /// Layer and colour that a label itself carries.
    FaceAttributes own_attributes(const TDF_Label& label) const {
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

    /// `own`, with what it does not say taken from `outer`; names are not inherited.
    static FaceAttributes merged(FaceAttributes own, const FaceAttributes& outer) {
        if (own.layer.empty()) own.layer = outer.layer;
        if (!own.color) own.color = outer.color;
        return own;
    }

    FaceNames face_names_;
    MappedItems& mapped_;
    opencascade::handle<XCAFDoc_ShapeTool> shapes_;
    opencascade::handle<XCAFDoc_ColorTool> colors_;
    opencascade::handle<XCAFDoc_LayerTool> layers_;
    CadDocument& document_;
    std::map<std::string, std::optional<std::size_t>> part_numbers_;
};

} // namespace

opencascade::handle<TDocStd_Document> new_document() {
    // Names like "SOLID" or "=>[0:1:1:2]" are none.
    XCAFDoc_ShapeTool::SetAutoNaming(false);
    opencascade::handle<TDocStd_Document> document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    return document;
}

void read_assembly(const opencascade::handle<TDocStd_Document>& source, const FaceNames& face_names,
                   MappedItems& mapped, CadDocument& document) {
    AssemblyReader(source->Main(), face_names, mapped, document).read();
}

} // namespace keiko::cad
