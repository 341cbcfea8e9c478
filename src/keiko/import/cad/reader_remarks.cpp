#include "keiko/import/cad/reader_remarks.h"

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>

#include <algorithm>
#include <memory>
#include <set>
#include <unordered_map>

namespace keiko::cad {
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
