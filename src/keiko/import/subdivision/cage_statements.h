#pragma once

#include "keiko/base/error.h"
#include "keiko/import/subdivision/cage.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace keiko::subdivision {

/// One statement of an OBJ file: its words, comment and line continuations taken away.
struct Statement {
    std::vector<std::string_view> words; ///< at least one
    std::uint32_t line = 0;              ///< of its first word
};

/// Walks through the statements of a text and tells what is wrong with one.
class CageLines {
public:
    /// Statements of a text; `file` is its name for messages.
    CageLines(std::string file, std::string text)
        : file_(std::move(file)), text_(std::move(text)) {}

    /// Moves on to the next statement; false at the end.
    bool next(Statement& statement);

    /// Throws Error with the file, the line and the reason.
    [[noreturn]] void fail(std::uint32_t line, const std::string& reason) const {
        throw Error(file_, std::to_string(line), reason);
    }

    /// Name of the file for messages.
    const std::string& file() const { return file_; }
    /// Whether the text ends within a line, as one that was cut may.
    bool ends_open() const { return !text_.ends_with('\n'); }
    /// A finite number.
    double number(const Statement& statement, std::string_view word) const;
    /// A whole number.
    long whole(const Statement& statement, std::string_view word) const;

private:
    void append_words(std::string_view line, Statement& statement) const;

    std::string file_, text_;
    std::size_t position_ = 0;
    std::uint32_t line_ = 0;
};

/// A line "t NAME INTEGERS/FLOATS/STRINGS values" of an OBJ file.
struct CageTag {
    std::string name;                 ///< such as "crease"
    std::vector<long> integers;       ///< of either sign
    std::vector<double> floats;       ///< finite
    std::vector<std::string> strings; ///< words
    std::uint32_t line = 0;           ///< of the file
};

/// Throws Error when the values are not as many as the tag says.
CageTag read_tag(const Statement& statement, const CageLines& lines);

/// Writes all tags into a cage whose vertices and faces are complete. Throws Error for a tag that
/// is unknown, names what is not there, or has too few values; a crease that is no edge of the
/// cage has no effect and is remarked upon.
void apply(const std::vector<CageTag>& tags, const CageLines& lines, Cage& cage);

/// Throws Error when an edge has more than two faces or two that run the same way along it. A
/// vertex where several fans of faces touch is non-manifold too, but harmless: it is sharp for
/// ever. Each fan gets a copy of it as an infinitely sharp corner, which is the same surface.
/// Creases that are no edges are dropped and remarked upon.
void make_manifold(Cage& cage, const CageLines& lines);

/// Remarks upon faces whose corners lie on a line or in a point. Throws Error for a cage that has
/// no other faces: its surface would be a line.
void check_areas(Cage& cage, const CageLines& lines);

} // namespace keiko::subdivision
