#pragma once

#include "keiko/stream/ray_lines.h"

#include <algorithm>
#include <memory>
#include <string>

namespace keiko::test {

/// A source that gives a text `size` bytes at a time.
inline ByteSource cut_text(std::string text, std::size_t size) {
    return [text = std::move(text), size,
            at = std::make_shared<std::size_t>(0)](std::span<char> bytes) {
        const std::size_t count = std::min({size, bytes.size(), text.size() - *at});
        std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(*at), count, bytes.begin());
        *at += count;
        return count;
    };
}

} // namespace keiko::test
