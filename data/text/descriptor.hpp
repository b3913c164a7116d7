// An open file of the system that closes itself.
#pragma once

#include <unistd.h>
#include <utility>

namespace meniscus {

class Descriptor {
public:
    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(Descriptor&& other) noexcept : number(std::exchange(other.number, -1)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() {
        if (number >= 0)
            close(number);
    }

    /// Negative where it could not be opened.
    operator int() const { return number; }

private:
    int number;
};

} // namespace meniscus
