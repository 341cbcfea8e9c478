#include "keiko/scene/suggestion.h"

#include "keiko/base/error_text.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace keiko {
namespace {

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal
/// string alignment); letters of either case are the same.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
    };
    std::vector<std::size_t> before, last, row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = std::move(last);
        last = std::move(row);
        row.assign(b.size() + 1, i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min(
                {last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0u : 1u)});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row.back();
}

} // namespace

std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates) {
    std::size_t least = std::max<std::size_t>(1, typed.size() / 3) + 1;
    const std::string* nearest = nullptr;
    for (const std::string& candidate : candidates)
        // Words that share no letter are not like each other, however short they are.
        if (const std::size_t d = edit_distance(typed, candidate);
            d < least && d < std::max(typed.size(), candidate.size()))
            least = d, nearest = &candidate;
    return nearest ? " (did you mean '" + shortened(*nearest) + "'?)" : "";
}

std::string comma_list(std::span<const std::string> words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    // Our own names are all told; those of a file's materials may be many.
    constexpr std::size_t longest = 1000;
    return shortened(list, longest);
}

} // namespace keiko
