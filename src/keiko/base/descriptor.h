#pragma once

#include <unistd.h>

#include <utility>

namespace keiko {

/// File descriptor that is closed at the end of its scope.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        reset(std::exchange(other.number_, -1));
        return *this;
    }
    ~Descriptor() { close(); }

    int number() const { return number_; }
    bool open() const { return number_ >= 0; }
    void reset(int number) { close(), number_ = number; }
    void close() {
        if (open()) ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

} // namespace keiko
