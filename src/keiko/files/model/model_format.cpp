#include "keiko/files/model/model_format.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/photometric/luminaire_file.h"
#include "keiko/files/toml/toml_reader.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace keiko {
namespace {

namespace fs = std::filesystem;

constexpr std::streamoff probe_size = 4096;

std::string first_bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string text(probe_size, '\0');
    in.read(text.data(), probe_size);
    text.resize(static_cast<std::size_t>(in.gcount()));
    return text;
}

std::string last_bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = in.tellg();
    in.seekg(std::max<std::streamoff>(0, size - probe_size));
    return {std::istreambuf_iterator<char>(in), {}};
}

bool contains(std::string_view text, std::string_view word) {
    return text.find(word) != std::string_view::npos;
}

/// Text before the first line break.
std::string_view first_line(std::string_view text) {
    return text.substr(0, text.find_first_of("\r\n"));
}

/// IGES marks its sections in column 73: S for the start, T for the last line.
bool is_iges(std::string_view text) {
    const std::string_view line = first_line(text);
    return line.size() >= 73 && (line[72] == 'S' || line[72] == 'C') &&
           line.find_first_not_of("0123456789 ", 73) >= std::min<std::size_t>(line.size(), 80);
}

/// Number of values on a line of numbers separated by blanks or commas; 0 for any other text.
int numbers_on(const std::string& line) {
    std::string spaced = line;
    std::replace(spaced.begin(), spaced.end(), ',', ' ');
    std::istringstream in(spaced);
    int count = 0;
    for (std::string word; in >> word; ++count)
        if (word.find_first_not_of("0123456789+-.eE") != std::string::npos) return 0;
    return count;
}

std::optional<ModelFormat> patch_text(const std::string& text) {
    std::istringstream in(text);
    int counts[2] = {0, 0}, known = 0;
    for (std::string line; known < 2 && std::getline(in, line);) {
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        counts[known++] = numbers_on(line);
    }
    if (counts[0] != 1) return std::nullopt;
    if (counts[1] == 2 || known == 1) return ModelFormat::bezier;
    if (counts[1] == 16) return ModelFormat::teapot;
    return std::nullopt;
}

/// Whether a word is a number or was meant to be one; what is wrong with it the parser knows.
bool like_number(std::string word) {
    word = lower_case(word.erase(0, word.find_first_not_of("+-")));
    return word.find_first_of("0123456789.") == 0 || word.starts_with("nan") ||
           word.starts_with("inf");
}

/// The first statement of an OBJ file is one of these. OBJ has no signature, so a vertex, or
/// a keyword that nothing else begins with, must do.
bool is_obj(const std::string& text) {
    constexpr std::array keywords{"mtllib", "usemtl", "vt", "vn", "vp", "f"};
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        line = line.substr(0, line.find('#'));
        std::istringstream words(line);
        std::string word, next;
        if (!(words >> word)) continue;
        if (word == "v") return words >> next && like_number(next);
        if (std::find(keywords.begin(), keywords.end(), word) != keywords.end()) return true;
        if (word != "g" && word != "o" && word != "s" && word != "t") return false;
    }
    return false;
}

std::optional<ModelFormat> format_of(const std::string& text) {
    if (contains(std::string_view(text).substr(0, 1024), "ISO-10303-21")) return ModelFormat::step;
    if (contains(text, "DBRep_DrawableShape") || contains(text, "CASCADE Topology"))
        return ModelFormat::brep;
    if (is_iges(text)) return ModelFormat::iges;
    if (is_obj(text)) return ModelFormat::cage;
    return patch_text(text);
}

bool ends_as_iges(std::string_view tail) {
    constexpr std::string_view padding(" \r\n\t\032\0", 6);
    const std::size_t end = tail.find_last_not_of(padding);
    if (end == std::string_view::npos) return false;
    const std::size_t begin = tail.find_last_of("\r\n", end);
    const std::string_view line = tail.substr(begin == std::string_view::npos ? 0 : begin + 1);
    return line.size() >= 73 && line[72] == 'T';
}

/// The last thing in a text BREP is the reference to its whole shape, as "+1 0". OpenCASCADE runs
/// forever on some files that are cut before it.
bool ends_as_brep(const std::string& tail) {
    const std::size_t star = tail.rfind('*');
    if (star == std::string::npos) return false;
    std::istringstream in(tail.substr(star + 1));
    const auto is_number = [](const std::string& word, std::size_t from) {
        return word.size() > from && word.find_first_not_of("0123456789", from) == word.npos;
    };
    std::string shape, location;
    in >> shape >> location;
    return !shape.empty() && std::string_view("+-ie").find(shape.front()) != shape.npos &&
           is_number(shape, 1) && is_number(location, 0);
}

bool cut_short(const fs::path& path, ModelFormat format) {
    switch (format) {
        case ModelFormat::step:
            return !contains(last_bytes(path), "END-ISO-10303-21");
        case ModelFormat::iges:
            return !ends_as_iges(last_bytes(path));
        case ModelFormat::brep:
            return !ends_as_brep(last_bytes(path));
        default:
            return false;
    }
}

/// Kind and use of a file that is no model; empty where it is not known.
std::string other_kind(const std::string& text, const fs::path& path) {
    if (is_luminaire_file(path) || text.starts_with("IESNA"))
        return "a luminaire: info takes it, and spotlights of a rig name it";
    const std::size_t begin = text.find("\"keiko-");
    if (begin == std::string::npos) return "";
    return use_of_format(std::string_view(text).substr(begin + 1, text.find('"', begin + 1)));
}

[[noreturn]] void refuse(const std::string& text, const fs::path& path) {
    const std::string kind = other_kind(text, path);
    if (!kind.empty()) throw Error(path.string(), "", "no model, but " + kind);
    throw Error(path.string(), "",
                "not a model file (expected STEP, IGES, BREP, .bpt, teapot text or an OBJ cage)");
}

/// Files as they come by mail.
void refuse_packed(std::string_view bytes, const fs::path& path) {
    if (bytes.starts_with("\x1f\x8b"))
        throw Error(path.string(), "", "is packed with gzip: unpack it first");
    if (bytes.starts_with("PK\x03\x04"))
        throw Error(path.string(), "", "is a zip archive: unpack it first");
}

} // namespace

std::string_view name_of(ModelFormat format) {
    switch (format) {
        case ModelFormat::step:
            return "STEP";
        case ModelFormat::iges:
            return "IGES";
        case ModelFormat::brep:
            return "BREP";
        case ModelFormat::bezier:
            return "BPT";
        case ModelFormat::cage:
            return "OBJ";
        case ModelFormat::teapot:
            break;
    }
    return "teapot text";
}

ModelFormat detect_model_format(const fs::path& path) {
    require_readable_file(path);
    const std::string bytes = first_bytes(path);
    refuse_packed(bytes, path);
    const std::string text = without_byte_order_mark(bytes, path);
    const auto format = format_of(text);
    if (!format) refuse(text, path);
    const bool marked = text.size() < bytes.size();
    if (marked && (*format == ModelFormat::step || *format == ModelFormat::iges))
        throw Error(path.string(), "",
                    "begins with a byte order mark, which " + std::string(name_of(*format)) +
                        " does not allow: save it without");
    if (cut_short(path, *format))
        throw Error(path.string(), "",
                    "the " + std::string(name_of(*format)) + " file is cut short: it has no end");
    return *format;
}

} // namespace keiko
