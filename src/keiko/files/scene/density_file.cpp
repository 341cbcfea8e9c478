#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/job.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/rig_tables.h"

#include <charconv>
#include <cmath>

namespace keiko {
namespace {

constexpr int most_nodes = 1024;
constexpr double largest = 1e9; ///< mm, and times the extinction

/// Words between blanks and line ends, with what follows a # skipped.
class Words {
public:
    Words(std::string_view text, const std::string& source) : rest_(text), source_(source) {}

    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(source_, std::to_string(line_), reason);
    }
    std::string_view next() {
        skip();
        const std::size_t end = std::min(rest_.find_first_of(" \t\r\n#"), rest_.size());
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }
    void expect(std::string_view word) {
        const std::string_view found = next();
        if (found != word) fail("expected '" + std::string(word) + "', found " + in_quotes(found));
    }
    double number() {
        const std::string_view word = next();
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty()) fail("ends too early");
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            fail(in_quotes(word) + " is not a number");
        if (std::abs(value) > largest) fail(in_quotes(word) + " is beyond 1e9");
        return value;
    }
    bool at_end() {
        skip();
        return rest_.empty();
    }

private:
    void skip() {
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == '#') {
                rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
            } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
                line_ += c == '\n' ? 1 : 0;
                rest_.remove_prefix(1);
            } else {
                return;
            }
        }
    }

    std::string_view rest_;
    const std::string& source_;
    std::size_t line_ = 1;
};

Vec3 vector_in(Words& words) {
    const double x = words.number(), y = words.number();
    return {x, y, words.number()};
}

int nodes_in(Words& words) {
    const double count = words.number();
    if (!(count >= 2 && count <= most_nodes && count == std::floor(count)))
        words.fail("nodes must be whole numbers from 2 to " + std::to_string(most_nodes));
    return static_cast<int>(count);
}

} // namespace

VoxelDensity parse_density(std::string_view text, const std::string& source) {
    Words words(text, source);
    words.expect("keiko-density/1");
    words.expect("nodes");
    std::array<int, 3> nodes{};
    for (int& count : nodes) count = nodes_in(words);
    words.expect("low");
    const Vec3 low = vector_in(words);
    words.expect("high");
    const Vec3 high = vector_in(words);
    for (unsigned axis = 0; axis < 3; ++axis)
        if (!(low[axis] < high[axis])) words.fail("low must be below high");
    words.expect("values");
    const auto count = static_cast<std::size_t>(nodes[0]) * static_cast<std::size_t>(nodes[1]) *
                       static_cast<std::size_t>(nodes[2]);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        check_stop();
        values.push_back(words.number());
        if (values.back() < 0) words.fail("a density must not be negative");
    }
    if (!words.at_end()) words.fail("has more values than nodes");
    return {low, high, nodes, std::move(values)};
}

VoxelDensity read_density(const std::filesystem::path& path) {
    return parse_density(read_text_file(path), path.string());
}

} // namespace keiko
