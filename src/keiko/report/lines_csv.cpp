#include "keiko/report/lines_json.h"

#include <array>
#include <charconv>

namespace keiko {
namespace {

/// The shortest text that reads back as the same number.
void append(std::string& text, double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text += ',';
    text.append(digits.data(), end);
}

} // namespace

std::string lines_csv(const LineList& list, const SurfaceModel& model) {
    std::string text = "view,line,plane,lamp,face,x,y,z\n";
    std::size_t count = 0;
    for (const ViewLines& view : list.views)
        for (const SurfaceLine& line : view.lines) {
            const std::string begin = view.view + "," + std::to_string(count++) + "," +
                                      std::to_string(line.plane) + "," + std::to_string(line.lamp) +
                                      "," + std::to_string(model.faces[line.face].id);
            for (const LinePoint& p : line.line.points) {
                text += begin;
                for (const double value : {p.place.x, p.place.y, p.place.z}) append(text, value);
                text += '\n';
            }
        }
    return text;
}

} // namespace keiko
