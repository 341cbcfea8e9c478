#include "keiko/report/content/combs_text.h"
#include "keiko/report/markup/csv_text.h"

namespace keiko {
namespace {

void append(std::string& text, double value) {
    (text += ',') += csv_number(value);
}

} // namespace

std::string combs_csv(std::span<const CombCurve> curves, const SurfaceModel& model) {
    std::string text =
        "curve,name,piece,face,instance,along,x,y,z,curvature,normal_curvature,tx,ty,tz\n";
    for (std::size_t c = 0; c < curves.size(); ++c)
        for (std::size_t p = 0; p < curves[c].pieces.size(); ++p) {
            const CombPiece& piece = curves[c].pieces[p];
            const std::string begin = std::to_string(c) + "," + csv_quoted(curves[c].name) + "," +
                                      std::to_string(p) + "," +
                                      std::to_string(model.faces[piece.face].id) + "," +
                                      std::to_string(piece.instance);
            for (const CombSample& s : piece.samples) {
                text += begin;
                for (const double value : {s.along, s.place.x, s.place.y, s.place.z,
                                           s.bend.curvature, s.bend.normal_curvature,
                                           s.bend.towards.x, s.bend.towards.y, s.bend.towards.z})
                    append(text, value);
                text += '\n';
            }
        }
    return text;
}

} // namespace keiko
