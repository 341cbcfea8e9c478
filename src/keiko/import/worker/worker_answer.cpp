#include "keiko/import/worker/worker_answer.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/files/model/model_serialization.h"

#include <charconv>
#include <optional>

namespace keiko {
namespace {

constexpr std::size_t longest_line = 4096; ///< bytes; a reason is a line for a terminal

/// A number from 0 to 1.
std::optional<double> share_of(std::string_view text) {
    double share = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), share);
    const bool whole = code == std::errc() && end == text.data() + text.size();
    return whole && share >= 0 && share <= 1 ? std::optional(share) : std::nullopt;
}

} // namespace

void WorkerAnswer::receive(std::string_view bytes) {
    while (!has_result_ && !bytes.empty()) {
        const std::size_t end = bytes.find('\n');
        line_.append(bytes.substr(0, end));
        if (line_.size() > longest_line) fail(in_quotes(line_) + " is too long a line");
        if (end == std::string_view::npos) return;
        bytes.remove_prefix(end + 1);
        take_line();
        line_.clear();
    }
    if (most_bytes_ > 0 && bytes.size() > most_bytes_ - result_.size())
        fail("its result is larger than the memory it may use");
    result_.append(bytes);
}

void WorkerAnswer::take_line() {
    const std::string_view line = line_;
    constexpr std::string_view progress = "progress ", error = "error ", where = "where ";
    if (line == "model" || line == "curves" || line == "mesh") {
        has_result_ = true;
    } else if (line.starts_with(error)) {
        reason_ = shortened(line.substr(error.size()));
    } else if (line.starts_with(where)) {
        where_ = shortened(line.substr(where.size()));
    } else {
        const auto share =
            line.starts_with(progress) ? share_of(line.substr(progress.size())) : std::nullopt;
        if (!share) fail(in_quotes(line) + " is no line of it");
        job_.report("import", *share);
    }
}

const std::string& WorkerAnswer::result() const {
    if (!reason_.empty()) throw Error(file_, where_, reason_);
    if (!has_result_) fail("it ends before the result");
    return result_;
}

SurfaceModel WorkerAnswer::model() const {
    return deserialize(result(), file_);
}

void WorkerAnswer::fail(const std::string& reason) const {
    throw Error(file_, "", "the reader's answer is damaged: " + reason);
}

} // namespace keiko
