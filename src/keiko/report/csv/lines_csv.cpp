#include "keiko/report/json/lines_json.h"
#include "keiko/report/markup/csv_text.h"

namespace keiko {
namespace {

void append(std::string& text, double value) {
    (text += ',') += csv_number(value);
}

void append(std::string& text, const LineValue& value, bool known) {
    if (!known) {
        text += ",,";
        return;
    }
    append(text, value.value);
    append(text, value.bound);
}

void append_points(std::string& text, const std::string& begin, const SurfaceLine& piece) {
    for (const LinePoint& p : piece.line.points) {
        text += begin;
        for (const double value : {p.place.x, p.place.y, p.place.z}) append(text, value);
        text += '\n';
    }
}

} // namespace

std::string lines_csv(const LineList& list, const SurfaceModel& model) {
    std::string text = "view,line,piece,plane,lamp,face,x,y,z\n";
    std::size_t count = 0;
    for (const ViewLines& view : list.views)
        for (const JoinedLine& line : view.found.lines) {
            const std::string begin = view.view + "," + std::to_string(count++) + ",";
            for (std::size_t i = 0; i < line.pieces.size(); ++i) {
                const SurfaceLine& piece = view.found.pieces[line.pieces[i]];
                append_points(text,
                              begin + std::to_string(i) + "," + std::to_string(piece.plane) + "," +
                                  std::to_string(piece.lamp) + "," +
                                  std::to_string(model.faces[piece.face].id),
                              piece);
            }
        }
    return text;
}

std::string line_inflections_csv(const LineList& list) {
    std::string text = "view,line,plane,lamp,along,x,y,z\n";
    std::size_t count = 0;
    for (const ViewLines& view : list.views)
        for (const JoinedLine& line : view.found.lines) {
            const std::string begin = view.view + "," + std::to_string(count++) + "," +
                                      std::to_string(line.plane) + "," + std::to_string(line.lamp);
            for (const LineInflection& turn : line.inflections) {
                text += begin;
                for (const double value : {turn.along, turn.place.x, turn.place.y, turn.place.z})
                    append(text, value);
                text += '\n';
            }
        }
    return text;
}

std::string crossings_csv(const LineList& list) {
    std::string text =
        "view,line,plane,lamp,faces,verdict,severity,x,y,z,gap,angle,plane_jump,"
        "turn,turn_bound,jump,jump_bound,kink,kink_bound,bend,bend_bound\n";
    std::size_t first_line = 0;
    for (const ViewLines& view : list.views) {
        for (const LineCrossing& c : view.found.crossings) {
            text += view.view + "," + std::to_string(first_line + c.line) + "," +
                    std::to_string(c.plane) + "," + std::to_string(c.lamp) + "," +
                    csv_quoted(c.faces) + ",";
            if (c.verdict) text += name_of(*c.verdict);
            for (const double value :
                 {c.severity, c.place.x, c.place.y, c.place.z, c.gap, c.angle, c.plane_jump})
                append(text, value);
            append(text, c.turn, true);
            for (const LineValue* value : {&c.jump, &c.kink, &c.bend})
                append(text, *value, c.continued());
            text += '\n';
        }
        first_line += view.found.lines.size();
    }
    return text;
}

} // namespace keiko
