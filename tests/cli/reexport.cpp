/// Reads a STEP or BREP file and writes it anew through OpenCASCADE, as another program would.
///
/// usage: reexport IN OUT, both ending in .step, .igs or .brep

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>

#include <cstdio>
#include <string>

namespace {

bool ends_with(const std::string& text, const char* ending) {
    return std::string(text).ends_with(ending);
}

template <class Reader>
bool read_with(const std::string& path, TopoDS_Shape& shape) {
    Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return false;
    reader.TransferRoots();
    shape = reader.OneShape();
    return !shape.IsNull();
}

bool read(const std::string& path, TopoDS_Shape& shape) {
    if (ends_with(path, ".step")) return read_with<STEPControl_Reader>(path, shape);
    if (ends_with(path, ".igs")) return read_with<IGESControl_Reader>(path, shape);
    return BRepTools::Read(shape, path.c_str(), BRep_Builder());
}

bool write(const std::string& path, const TopoDS_Shape& shape) {
    if (ends_with(path, ".brep")) return BRepTools::Write(shape, path.c_str());
    if (ends_with(path, ".igs")) {
        IGESControl_Writer writer;
        return writer.AddShape(shape) && writer.Write(path.c_str());
    }
    STEPControl_Writer writer;
    return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
           writer.Write(path.c_str()) == IFSelect_RetDone;
}

} // namespace

int main(int argc, char** argv) {
    TopoDS_Shape shape;
    if (argc == 3 && read(argv[1], shape) && write(argv[2], shape)) return 0;
    std::fprintf(stderr, "reexport: cannot read or write\n");
    return 1;
}
