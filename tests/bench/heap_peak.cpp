#include "tests/bench/heap_peak.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> counting{false};
std::atomic<long long> now{0}, most{0};

void count(void* memory, int sign) {
    if (!counting.load(std::memory_order_relaxed)) return;
    const long long bytes = now += sign * static_cast<long long>(malloc_usable_size(memory));
    long long before = most.load();
    while (bytes > before && !most.compare_exchange_weak(before, bytes)) {
    }
}

} // namespace

void* operator new(std::size_t size) {
    void* memory = std::malloc(std::max(size, std::size_t{1}));
    if (!memory) throw std::bad_alloc();
    count(memory, 1);
    return memory;
}
void operator delete(void* memory) noexcept {
    if (memory) count(memory, -1);
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    operator delete(memory);
}

namespace keiko::bench {

HeapCount::HeapCount() {
    now = 0, most = 0, counting = true;
}
HeapCount::~HeapCount() {
    counting = false;
}
std::size_t HeapCount::peak() const {
    return static_cast<std::size_t>(most.load());
}

} // namespace keiko::bench
