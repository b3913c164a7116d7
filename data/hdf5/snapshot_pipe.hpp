// A snapshot through a pipe between two processes, the sender of which may be out of its mind: what
// arrives is believed piece by piece, and no more of it than was agreed on. For isolated_read.cpp
// only.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <poll.h>
#include <set>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

namespace meniscus {

/// What a child has to say; the number after start_mark.
enum Outcome : std::uint64_t { read_well, bad_input, failed, out_of_memory };

/// What a child says first of all, when it is at work.
inline constexpr std::uint64_t start_mark = 0x6d656e6973637573;

/// The last number, after which nothing is missing.
inline constexpr std::uint64_t end_mark = ~start_mark;

/// The exit status of a child that cannot send.
inline constexpr int cannot_answer = 3;

/// Thrown where the pipe brings less than it should, or what no child sends that is well.
struct BrokenPipe {};

/// Thrown where the time is over before everything is there.
struct TimeIsOver {};

/// The child's end. Arrays are given back to the system as soon as they are sent.
class Sender {
public:
    explicit Sender(int pipe) : descriptor(pipe) {}

    template <class Number>
    void number(const Number& value) {
        send(&value, sizeof value);
    }

    void text(const std::string& text) {
        number(std::uint64_t{text.size()});
        send(text.data(), text.size());
    }

    template <class Value>
    void values(std::vector<Value>& values) {
        number(std::uint64_t{values.size()});
        send(values.data(), values.size() * sizeof(Value));
        std::vector<Value>().swap(values);
    }

    template <class Entries, class Carry>
    void list(Entries& entries, Carry carry) {
        number(std::uint64_t{entries.size()});
        std::for_each(entries.begin(), entries.end(), carry);
    }

private:
    void send(const void* data, std::size_t size) const {
        const auto* bytes = static_cast<const char*>(data);
        while (size > 0) {
            const ssize_t sent = write(descriptor, bytes, size);
            if (sent >= 0) {
                bytes += sent;
                size -= static_cast<std::size_t>(sent);
            } else if (errno != EINTR) {
                _exit(cannot_answer); // nobody is there to receive it
            }
        }
    }

    int descriptor;
};

/// The parent's end. What the child claims to send is believed as it arrives, no more than `max`
/// bytes of it and nothing after that time. Throws FailureError where the pipe itself fails.
class Receiver {
public:
    using Clock = std::chrono::steady_clock;

    Receiver(int pipe, std::uint64_t max, std::chrono::milliseconds time,
             std::filesystem::path its_file)
        : descriptor(pipe), left(max), end(Clock::now() + time), file(std::move(its_file)) {}

    template <class Number>
    void number(Number& value) {
        receive(&value, sizeof value);
    }

    void text(std::string& text) { grow(text, 1); }

    template <class Value>
    void values(std::vector<Value>& values) {
        grow(values, sizeof(Value));
    }

    template <class Entries, class Carry>
    void list(Entries& entries, Carry carry) {
        std::uint64_t count = 0;
        number(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            entries.emplace_back();
            carry(entries.back());
        }
    }

private:
    template <class Values>
    void grow(Values& values, std::size_t value_size) {
        std::uint64_t count = 0;
        number(count);
        while (values.size() < count) {
            const std::size_t before = values.size();
            const std::size_t max = std::max((std::size_t{1} << 20) / value_size, 4 * before);
            values.reserve(std::min<std::uint64_t>(count, max));
            values.resize(std::min<std::uint64_t>(count, max));
            receive(&values[before], (values.size() - before) * value_size);
        }
    }

    void receive(void* data, std::size_t size) {
        if (size > left)
            throw BrokenPipe();
        left -= size;
        auto* bytes = static_cast<char*>(data);
        while (size > 0) {
            wait();
            const ssize_t received = ::read(descriptor, bytes, size);
            if (received > 0) {
                bytes += received;
                size -= static_cast<std::size_t>(received);
            } else if (received == 0) {
                throw BrokenPipe();
            } else if (errno != EINTR) {
                throw FailureError(file.string() +
                                   ": what was read does not arrive: " + std::strerror(errno));
            }
        }
    }

    /// Until there is something to receive, or a signal comes in between.
    void wait() const {
        using std::chrono::milliseconds;
        constexpr std::int64_t hour = 3'600'000;
        const auto rest = std::chrono::duration_cast<milliseconds>(end - Clock::now()).count();
        pollfd watched = {descriptor, POLLIN, 0};
        if (rest <= 0 ||
            poll(&watched, 1, static_cast<int>(std::min<std::int64_t>(rest, hour))) == 0)
            throw TimeIsOver();
    }

    int descriptor;
    std::uint64_t left;
    Clock::time_point end;
    std::filesystem::path file; ///< as it is called in messages
};

template <class Pipe>
void carry_optional(Pipe& pipe, std::optional<double>& value) {
    std::uint64_t known = value ? 1 : 0;
    double number = value.value_or(0);
    pipe.number(known);
    pipe.number(number);
    if (known != 0)
        value = number;
}

/// The values under the number of their type.
template <std::size_t Kind = 0, class Pipe>
void carry_values(Pipe& pipe, ArrayValues& values, std::uint64_t kind) {
    if constexpr (Kind < std::variant_size_v<ArrayValues>) {
        if (kind != Kind)
            return carry_values<Kind + 1>(pipe, values, kind);
        if (values.index() != Kind)
            values.emplace<Kind>();
        pipe.values(std::get<Kind>(values));
    } else {
        throw BrokenPipe();
    }
}

/// One function for both ends, so that they cannot disagree.
template <class Pipe>
void carry(Pipe& pipe, Snapshot& snapshot) {
    std::uint64_t is_single = snapshot.position_precision == Precision::float32 ? 1 : 0;
    pipe.number(is_single);
    snapshot.position_precision = is_single != 0 ? Precision::float32 : Precision::float64;
    pipe.number(snapshot.dimension);
    pipe.number(snapshot.dimension_is_stated);
    pipe.number(snapshot.first_particle);
    pipe.number(snapshot.particles_in_file);
    carry_optional(pipe, snapshot.support_radius);
    carry_optional(pipe, snapshot.particle_spacing);
    carry_optional(pipe, snapshot.particle_volume);
    carry_optional(pipe, snapshot.time);
    pipe.text(snapshot.scene);
    std::vector<std::pair<std::string, std::string>> texts(snapshot.provenance.begin(),
                                                           snapshot.provenance.end());
    pipe.list(texts, [&](auto& entry) {
        pipe.text(entry.first);
        pipe.text(entry.second);
    });
    snapshot.provenance = {texts.begin(), texts.end()};
    pipe.list(snapshot.notes, [&](std::string& note) { pipe.text(note); });
    pipe.values(snapshot.positions);
    pipe.values(snapshot.boundary);
    pipe.list(snapshot.point_data, [&](PointArray& array) {
        pipe.text(array.name);
        pipe.number(array.components);
        std::uint64_t kind = array.values.index();
        pipe.number(kind);
        carry_values(pipe, array.values, kind);
    });
}

/// Damage in the child's memory may have gone unnoticed. Where only arrays of a part were read,
/// whoever takes them knows how many values they have.
inline void check_is_consistent(const Snapshot& snapshot) {
    bool fine = snapshot.dimension == 2 || snapshot.dimension == 3;
    std::set<std::string_view> names;
    for (const PointArray& array : snapshot.point_data) {
        const std::size_t count =
            std::visit([](const auto& values) { return values.size(); }, array.values);
        fine = fine && array.components > 0 && names.insert(array.name).second &&
               (count == snapshot.size() * static_cast<std::size_t>(array.components) ||
                (snapshot.particles_in_file > 0 && snapshot.size() == 0));
    }
    if (!fine)
        throw BrokenPipe();
}

} // namespace meniscus
