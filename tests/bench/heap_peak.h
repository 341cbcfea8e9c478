#pragma once

#include <cstddef>

namespace keiko::bench {

/// Counting of the heap, between its construction and the question.
class HeapCount {
public:
    /// Begins to count; one at a time.
    HeapCount();
    ~HeapCount();
    HeapCount(const HeapCount&) = delete;
    HeapCount& operator=(const HeapCount&) = delete;

    /// Bytes at the most until now.
    std::size_t peak() const;
};

/// Bytes that a piece of work has on the heap at once, at the most, by all threads, beside what was
/// there before. By operators `new` and `delete` of this program, which count while it runs.
template <class Work>
std::size_t heap_peak(const Work& work) {
    const HeapCount count;
    work();
    return count.peak();
}

} // namespace keiko::bench
