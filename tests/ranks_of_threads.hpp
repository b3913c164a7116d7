// Ranks that are threads of one process, so that what is shared among ranks is tested without MPI.
#pragma once

#include <meniscus/data/ranks/ranks.hpp>

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace meniscus {

/// What the threads share.
class SharedDesk {
public:
    explicit SharedDesk(std::size_t ranks) : mail(ranks, std::vector<std::string>(ranks)) {}

    /// Waits until all ranks have come.
    void meet() {
        std::unique_lock<std::mutex> guard(lock);
        const std::uint64_t round = rounds;
        if (++waiting == mail.size()) {
            waiting = 0;
            ++rounds;
            all_came.notify_all();
            return;
        }
        all_came.wait(guard, [&] { return rounds != round; });
    }

    std::vector<std::vector<std::string>> mail; ///< [to][from]

private:
    std::mutex lock;
    std::condition_variable all_came;
    std::size_t waiting = 0;
    std::uint64_t rounds = 0;
};

class ThreadRank final : public Ranks {
public:
    ThreadRank(SharedDesk& desk, int number) : desk(desk), number(number) {}

    [[nodiscard]] int rank() const override { return number; }
    [[nodiscard]] int size() const override { return static_cast<int>(desk.mail.size()); }

    std::vector<std::string> exchange(std::vector<std::string> for_rank) override {
        const auto own = static_cast<std::size_t>(number);
        for (std::size_t to = 0; to < for_rank.size(); ++to)
            desk.mail[to][own] = std::move(for_rank[to]);
        desk.meet();
        std::vector<std::string> received = desk.mail[own];
        desk.meet();
        return received;
    }

    void sum(std::vector<std::uint64_t>& values) override {
        reduce(values, [](auto a, auto b) { return a + b; });
    }
    void min(std::vector<double>& values) override {
        reduce(values, [](auto a, auto b) { return std::min(a, b); });
    }
    void max(std::vector<double>& values) override {
        reduce(values, [](auto a, auto b) { return std::max(a, b); });
    }

private:
    SharedDesk& desk;
    int number;

    template <class Value, class Combine>
    void reduce(std::vector<Value>& values, const Combine& combine) {
        const std::string own(reinterpret_cast<const char*>(values.data()),
                              values.size() * sizeof(Value));
        const auto all = exchange(std::vector<std::string>(desk.mail.size(), own));
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto of = [&](const std::string& bytes) {
                return reinterpret_cast<const Value*>(bytes.data())[i];
            };
            values[i] = of(all[0]);
            for (std::size_t r = 1; r < all.size(); ++r)
                values[i] = combine(values[i], of(all[r]));
        }
    }
};

/// Calls work(ranks) on so many threads at a time. Throws what the first of them throws, which is
/// to be what all throw: one that comes to an end alone leaves the others waiting.
inline void on_thread_ranks(int count, const std::function<void(Ranks&)>& work) {
    SharedDesk desk(static_cast<std::size_t>(count));
    std::vector<std::thread> threads;
    std::vector<std::exception_ptr> errors(static_cast<std::size_t>(count));
    for (int number = 0; number < count; ++number)
        threads.emplace_back([&desk, &work, &errors, number] {
            ThreadRank rank(desk, number);
            try {
                work(rank);
            } catch (...) {
                errors[static_cast<std::size_t>(number)] = std::current_exception();
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const std::exception_ptr& error : errors)
        if (error)
            std::rethrow_exception(error);
}

} // namespace meniscus
