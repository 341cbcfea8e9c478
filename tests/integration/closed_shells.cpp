#include "tests/integration/closed_shells.h"

#include "tests/integration/opencascade_tracer.h"
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>

namespace keiko::test {

bool closed_by_opencascade(const std::filesystem::path& file) {
    const TopoDS_Shape shape = read_shape(file);
    if (TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SHELL).More()) return false;
    for (TopExp_Explorer e(shape, TopAbs_SHELL); e.More(); e.Next())
        if (!BRep_Tool::IsClosed(e.Current())) return false;
    return TopExp_Explorer(shape, TopAbs_SHELL).More();
}

} // namespace keiko::test
