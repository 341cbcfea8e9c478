#include "keiko/base/text.h"
#include "keiko/report/content/combs_text.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/line_list.h"
#include "keiko/report/content/profiles_text.h"

#include <array>
#include <charconv>
#include <initializer_list>

namespace keiko {
namespace {

/// The shortest text that reads back as the same number.
std::string csv_number(double value) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// A field in quotes, those in it doubled [RFC4180].
std::string csv_quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string field(std::string_view any_text) {
    std::string text = as_utf8(any_text);
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    return csv_quoted(text);
}

std::string row(std::initializer_list<std::string> fields) {
    std::string text;
    for (const std::string& f : fields) text += f + ",";
    text.back() = '\r';
    return text + "\n";
}

std::string row(const Check& check) {
    const MeasuredValue& w = check.worst;
    const auto if_judged = [&](double value) { return check.judged ? csv_number(value) : ""; };
    return row({check.seam == no_index ? "" : std::to_string(check.seam + 1), field(check.view),
                field(check.faces), field(check.code), field(check.quantity),
                check.judged ? std::string(outcome_of(check)) : "not judged", if_judged(w.value),
                if_judged(w.bound), if_judged(w.limit), field(check.unit), field(check.formula),
                if_judged(w.place.x), if_judged(w.place.y), if_judged(w.place.z),
                field(check.message)});
}

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

void append(std::string& text, const std::optional<double>& value) {
    text += ',';
    if (value) text += csv_number(*value);
}

/// The limit of a quantity and the share of the length beyond it, or two empty fields.
void append(std::string& text, const std::optional<ProfileQuantity>& quantity) {
    const bool is_limited = quantity && quantity->limit;
    append(text, is_limited ? quantity->limit : std::nullopt);
    append(text, is_limited ? std::optional(quantity->beyond.value) : std::nullopt);
}

std::string row(const ProfileSample& s) {
    const SeamPoint& p = s.point;
    const auto if_known = [&](double value) { return p.angle ? std::optional(value) : p.angle; };
    std::string text = std::to_string(s.piece);
    for (const double value : {s.along, p.place.x, p.place.y, p.place.z, p.gap})
        append(text, value);
    append(text, p.angle);
    for (const double value :
         {p.curvature_a, p.curvature_b, s.alias, s.catia, p.slope_a, p.slope_b})
        append(text, if_known(value));
    append(text, s.slope);
    return text;
}

void append_points(std::string& text, const std::string& begin, const SurfaceLine& piece) {
    for (const LinePoint& p : piece.line.points) {
        text += begin;
        for (const double value : {p.place.x, p.place.y, p.place.z}) append(text, value);
        text += '\n';
    }
}

} // namespace

std::string checks_csv(const Inspection& inspection) {
    std::string text = row({"seam", "view", "faces", "code", "quantity", "verdict", "value",
                            "bound", "limit", "unit", "formula", "x", "y", "z", "message"});
    for (const Check& check : inspection.checks) text += row(check);
    return text;
}

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

std::string profiles_csv(std::span<const SeamProfile> profiles, const Inspection& inspection) {
    std::string text =
        "seam,line,faces,kind,piece,along,x,y,z,gap,angle,curvature_a,curvature_b,alias,catia,"
        "slope_a,slope_b,slope_change,gap_limit,gap_beyond,angle_limit,angle_beyond,"
        "curvature_limit,curvature_beyond,slope_limit,slope_beyond\n";
    for (const SeamProfile& profile : profiles) {
        const MeasuredSeam& seam = inspection.seams[profile.seam];
        std::string begin = std::to_string(profile.seam + 1) + "," + std::to_string(seam.line + 1) +
                            "," + csv_quoted(as_utf8(seam.faces)) + ",";
        begin.append(name_of(seam.kind)) += ",";
        std::string end;
        for (const auto* quantity :
             {&profile.gap, &profile.angle, &profile.curvature, &profile.slope})
            append(end, *quantity);
        for (const ProfileSample& sample : profile.samples)
            text.append(begin).append(row(sample)).append(end) += "\n";
    }
    return text;
}

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
