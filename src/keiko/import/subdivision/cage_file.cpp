#include "keiko/base/input_file.h"
#include "keiko/base/job.h"
#include "keiko/base/text.h"
#include "keiko/import/subdivision/cage.h"
#include "keiko/import/subdivision/cage_statements.h"

#include <algorithm>
#include <array>
#include <map>

namespace keiko::subdivision {
namespace {

/// mm; as for .bpt files.
constexpr double largest_coordinate = 1e15;
/// An n-gon, or as many faces around a vertex, becomes n patches a level around its middle.
constexpr std::size_t most_corners = 256;

constexpr std::array skipped{"vt",    "vn",       "vp",         "s",        "mg",     "mtllib",
                             "bevel", "c_interp", "lod",        "d_interp", "usemap", "maplib",
                             "p",     "l",        "shadow_obj", "trace_obj"};
constexpr std::array free_form{"curv", "curv2", "surf", "cstype", "deg", "bmat", "step",  "parm",
                               "trim", "hole",  "scrv", "sp",     "end", "con",  "ctech", "stech"};

template <class List>
bool in_list(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

std::string joined(const Statement& statement) {
    std::string name;
    for (std::size_t i = 1; i < statement.words.size(); ++i)
        name += (i > 1 ? " " : "") + std::string(statement.words[i]);
    return name;
}

class CageReader {
public:
    explicit CageReader(const std::filesystem::path& path)
        : lines_(path.string(), read_text_file(path)) {}

    Cage read() {
        Statement statement;
        while (lines_.next(statement)) {
            check_stop();
            take(statement);
        }
        if (cage_.faces.empty())
            throw Error(lines_.file(), "", "no faces in the file (an OBJ file needs v and f)");
        apply(tags_, lines_, cage_);
        if (lines_.ends_open())
            cage_.diagnostics.push_back(
                {Severity::warning, "", "its last line has no end: the file may be cut short"});
        make_manifold(cage_, lines_);
        check_areas(cage_, lines_);
        return std::move(cage_);
    }

private:
    void take(const Statement& s) {
        const std::string_view kind = s.words.front();
        if (kind == "v") return take_vertex(s);
        if (kind == "f" || kind == "fo") return take_face(s);
        if (kind == "t") return tags_.push_back(read_tag(s, lines_));
        if (kind == "g" || kind == "o") return set_name(group_, joined(s));
        if (kind == "usemtl") return set_name(material_, joined(s));
        if (in_list(skipped, kind)) return;
        if (in_list(free_form, kind))
            lines_.fail(s.line, "free-form geometry is not supported: only the faces of a cage");
        lines_.fail(s.line, "not an OBJ statement: " + in_quotes(kind));
    }

    void take_vertex(const Statement& s) {
        if (s.words.size() < 4) lines_.fail(s.line, "a vertex needs x, y and z");
        Vec3 p(0);
        for (unsigned k = 0; k < 3; ++k) {
            p[k] = lines_.number(s, s.words[k + 1]);
            if (!(std::abs(p[k]) <= largest_coordinate))
                lines_.fail(s.line, "a coordinate must be from -1e15 to 1e15");
        }
        cage_.vertices.push_back(p);
    }

    void take_face(const Statement& s) {
        const std::size_t count = s.words.size() - 1;
        if (count < 3) lines_.fail(s.line, "a face needs at least three corners");
        if (count > most_corners)
            lines_.fail(s.line,
                        "a face may have at most " + std::to_string(most_corners) + " corners");
        CageFace face;
        face.first_corner = static_cast<std::uint32_t>(cage_.corners.size());
        face.corner_count = static_cast<std::uint32_t>(count);
        face.line = s.line, face.group = group_, face.material = material_;
        for (std::size_t i = 1; i <= count; ++i) {
            const std::uint32_t vertex = vertex_index(s, s.words[i]);
            const auto begin = cage_.corners.begin() + face.first_corner;
            if (std::find(begin, cage_.corners.end(), vertex) != cage_.corners.end())
                lines_.fail(s.line,
                            "the face names vertex " + std::to_string(vertex + 1) + " twice");
            cage_.corners.push_back(vertex);
        }
        cage_.faces.push_back(face);
    }

    /// Vertex index of a corner "v", "v/vt", "v//vn" or "v/vt/vn"; what follows the vertex must be
    /// numbers too.
    std::uint32_t vertex_index(const Statement& s, std::string_view word) const {
        const std::size_t slash = word.find('/');
        if (slash != std::string_view::npos &&
            word.substr(slash).find_first_not_of("/-+0123456789") != std::string_view::npos)
            lines_.fail(s.line, "not a corner v/vt/vn: " + in_quotes(word));
        const long number = lines_.whole(s, word.substr(0, slash));
        const auto count = static_cast<long>(cage_.vertices.size());
        const long index = number < 0 ? count + number : number - 1;
        if (index < 0 || index >= count)
            lines_.fail(s.line,
                        "there is no vertex " + std::to_string(number) + " before this line");
        return static_cast<std::uint32_t>(index);
    }

    void set_name(std::uint32_t& current, const std::string& name) {
        const auto count = static_cast<std::uint32_t>(cage_.names.size());
        const auto [known, fresh] = name_index_.try_emplace(name, count);
        if (fresh) cage_.names.push_back(name);
        current = known->second;
    }

    CageLines lines_;
    Cage cage_;
    std::vector<CageTag> tags_;
    std::map<std::string, std::uint32_t> name_index_{{"", 0}};
    std::uint32_t group_ = 0, material_ = 0;
};

} // namespace

Cage read_cage(const std::filesystem::path& path) {
    return CageReader(path).read();
}

} // namespace keiko::subdivision
