#pragma once

#include "keiko/base/error.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/math/affine.h"

#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>

#include <optional>
#include <string>
#include <vector>

namespace keiko::cad {

/// Mapped items of a STEP file whose operators mirror or scale: OpenCASCADE only moves and turns
/// what they map. Items may map representations that hold items, and stand in products of an
/// assembly.
class MappedItems {
public:
    /// None.
    MappedItems() = default;
    /// Mapped items of a file that has been transferred.
    explicit MappedItems(const opencascade::handle<XSControl_WorkSession>& session);

    /// Map that each shape of an assembly needs before it is placed: mostly the identity. A root of
    /// the file is an assembly of one.
    std::vector<Affine> corrections(const std::vector<TopoDS_Shape>& components);

    /// Whether a product of the file that is in no other shows this shape.
    bool is_product(const TopoDS_Shape& shape) const;

    /// A warning for each assembly that corrections() never met: what it places stays as
    /// OpenCASCADE put it.
    void remark_unmet(Diagnostics& diagnostics) const;

private:
    friend class MappedItemReader;

    struct Component {
        TopoDS_Shape shape; ///< where OpenCASCADE put it
        std::optional<Affine> correction{};
    };
    struct Assembly {
        std::vector<Component> components;
        std::string label; ///< of an entity that mirrors or scales
        bool met = false;

        /// The corrections of `shapes` if they are what the assembly is made of.
        std::optional<std::vector<Affine>> match(const std::vector<TopoDS_Shape>& shapes) const;
    };

    std::vector<Assembly> assemblies_;
    std::vector<TopoDS_Shape> products_;
};

/// An empty document for a reader to fill.
opencascade::handle<TDocStd_Document> new_document();

/// Name and line that a file itself gives a face.
struct FaceLabel {
    std::string name;       ///< or empty
    std::uint32_t line = 0; ///< as Face::line
};
/// Label of a face of a document, as the file itself has it.
using FaceLabels = std::function<FaceLabel(const TopoDS_Shape& face)>;

/// Parts, instances, names, layers and colours of a document that a reader has filled. A part
/// without faces is left out with a note; faces that lie loose at the top become one part.
/// `face_labels` may be empty: then the document's own names are used. `mapped` says what
/// OpenCASCADE has put in the wrong place.
void read_assembly(const opencascade::handle<TDocStd_Document>& source,
                   const FaceLabels& face_labels, MappedItems& mapped, CadDocument& document);

} // namespace keiko::cad
