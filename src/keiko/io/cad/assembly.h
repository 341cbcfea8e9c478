#pragma once

#include "keiko/io/cad/cad_document.h"
#include "keiko/io/cad/mapped_items.h"

#include <TDocStd_Document.hxx>

namespace keiko::cad {

/// An empty document for a reader to fill.
opencascade::handle<TDocStd_Document> new_document();

/// The name a file gives a face, or an empty one.
using FaceNames = std::function<std::string(const TopoDS_Shape& face)>;

/// Parts, instances, names, layers and colours of a document that a reader has filled. A part
/// without faces is left out with a note; faces that lie loose at the top become one part.
/// `face_names` may be empty: then the document's own are used. `mapped` says what OpenCASCADE has
/// put in the wrong place.
void read_assembly(const opencascade::handle<TDocStd_Document>& source, const FaceNames& face_names,
                   MappedItems& mapped, CadDocument& document);

} // namespace keiko::cad
