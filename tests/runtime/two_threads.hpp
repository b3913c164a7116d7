// A loop over a second thread that stays, for hosts whose loop allocates nothing.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>

namespace meniscus {

class TwoThreads {
public:
    TwoThreads() : second([this] { serve(); }) {}
    ~TwoThreads() {
        hand_over(nullptr, nullptr, 0);
        second.join();
    }
    TwoThreads(const TwoThreads&) = delete;
    TwoThreads& operator=(const TwoThreads&) = delete;

    [[nodiscard]] static int workers() { return 2; }

    /// The second thread has the back half.
    template <class Body>
    void operator()(std::size_t count, Body&& body) const {
        using Plain = std::remove_reference_t<Body>;
        const auto call = [](const void* what, std::size_t begin, std::size_t end) {
            (*static_cast<const Plain*>(what))(begin, end, 1);
        };
        hand_over(call, &body, count);
        if (count / 2 > 0)
            body(std::size_t{0}, count / 2, 0);
        std::unique_lock<std::mutex> lock(mutex);
        changed.wait(lock, [&] { return !has_work; });
    }

private:
    using Call = void (*)(const void*, std::size_t, std::size_t);

    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    mutable bool has_work = false;
    mutable Call work = nullptr; ///< none: the end
    mutable const void* body_of_work = nullptr;
    mutable std::size_t count_of_work = 0;
    std::thread second;

    void hand_over(Call call, const void* body, std::size_t count) const {
        const std::lock_guard<std::mutex> lock(mutex);
        work = call;
        body_of_work = body;
        count_of_work = count;
        has_work = true;
        changed.notify_all();
    }

    void serve() const {
        std::unique_lock<std::mutex> lock(mutex);
        for (;;) {
            changed.wait(lock, [&] { return has_work; });
            if (work == nullptr)
                return;
            lock.unlock();
            if (count_of_work > 0)
                work(body_of_work, count_of_work / 2, count_of_work);
            lock.lock();
            has_work = false;
            changed.notify_all();
        }
    }
};

} // namespace meniscus
