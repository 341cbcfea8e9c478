#include "keiko/import/cad/assembly.h"

#include "keiko/import/cad/shape_attributes.h"
#include "keiko/import/cad/shape_places.h"

#include <BRep_Builder.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <map>
#include <memory>

namespace keiko::cad {
namespace {

bool has_faces(const TopoDS_Shape& shape) {
    return TopExp_Explorer(shape, TopAbs_FACE).More();
}

void label_face(FaceAttributes& face, FaceLabel label) {
    face.name = std::move(label.name);
    face.line = label.line;
}

class AssemblyReader {
public:
    AssemblyReader(const TDF_Label& main, FaceLabels face_labels, MappedItems& mapped,
                   CadDocument& document)
        : face_labels_(std::move(face_labels)),
          mapped_(mapped),
          shapes_(XCAFDoc_DocumentTool::ShapeTool(main)),
          attributes_(main),
          document_(document) {}

    void read() {
        TDF_LabelSequence roots;
        shapes_->GetFreeShapes(roots);
        std::vector<TDF_Label> loose_faces, trees;
        for (const TDF_Label& root : roots)
            (shape_of(root).ShapeType() == TopAbs_FACE ? loose_faces : trees).push_back(root);
        const std::vector<TDF_Label> spread = spread_out(trees);
        for (const TDF_Label& root : trees)
            if (std::find(spread.begin(), spread.end(), root) == spread.end())
                place_root(root, spread);
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
            FaceAttributes own = attributes_.own(label);
            own.name = name_of(label);
            if (face_labels_) label_face(own, face_labels_(face));
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

    /// Whether `assembly` is made of what `lump` places as one piece: XCAF makes both of a compound
    /// that is not in its own place.
    static bool spreads_out(const TDF_Label& assembly, const TDF_Label& lump) {
        TDF_Label referred;
        return XCAFDoc_ShapeTool::GetReferredShape(lump, referred) &&
               !XCAFDoc_ShapeTool::IsAssembly(referred) &&
               alike(shape_of(assembly), shape_of(referred));
    }

    /// The roots that only spread out another, which no product of the file is.
    std::vector<TDF_Label> spread_out(const std::vector<TDF_Label>& roots) const {
        std::vector<TDF_Label> spread;
        for (const TDF_Label& root : roots)
            if (XCAFDoc_ShapeTool::IsAssembly(root) && !mapped_.is_product(shape_of(root)) &&
                std::any_of(roots.begin(), roots.end(),
                            [&](const TDF_Label& lump) { return spreads_out(root, lump); }))
                spread.push_back(root);
        return spread;
    }

    void place_root(const TDF_Label& root, const std::vector<TDF_Label>& spread) {
        const Affine correction = mapped_.corrections({shape_of(root)})[0];
        const auto assembly =
            std::find_if(spread.begin(), spread.end(),
                         [&](const TDF_Label& other) { return spreads_out(other, root); });
        if (assembly == spread.end()) return place(root, correction, {}, name_of(root), {});
        place(*assembly, correction, affine(place_of(shape_of(root))), name_of(root),
              attributes_.own(root));
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
                  merged(attributes_.own(label), inherited));
        } else if (XCAFDoc_ShapeTool::IsAssembly(label)) {
            place_components(label, above * correction, merged(attributes_.own(label), inherited));
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
        if (shape.IsNull() || !has_faces(shape)) {
            document_.diagnostics.push_back(
                {Severity::note, name, "a part without faces left out"});
            return std::nullopt;
        }
        auto known = std::make_shared<AttributeMap>(attributes_.of_faces(label));
        const FaceAttributes fallback = merged(attributes_.own(label), inherited);
        document_.parts.push_back(
            {shape, name, [known, fallback, labels = face_labels_](const TopoDS_Shape& face) {
                 const auto found = known->find(face);
                 FaceAttributes result;
                 if (found != known->end()) result = found->second;
                 if (labels) label_face(result, labels(face));
                 return merged(std::move(result), fallback);
             }});
        return document_.parts.size() - 1;
    }

    FaceLabels face_labels_;
    MappedItems& mapped_;
    opencascade::handle<XCAFDoc_ShapeTool> shapes_;
    ShapeAttributes attributes_;
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

void read_assembly(const opencascade::handle<TDocStd_Document>& source,
                   const FaceLabels& face_labels, MappedItems& mapped, CadDocument& document) {
    AssemblyReader(source->Main(), face_labels, mapped, document).read();
}

} // namespace keiko::cad
