#pragma once

#include "keiko/import/cad/cad_document.h"
#include "keiko/import/cad/mapped_items.h"

#include <TDocStd_Document.hxx>

namespace keiko::cad {

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
