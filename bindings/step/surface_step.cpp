#include "surface_step.hpp"

#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace meniscus {
namespace {

void check_setup(const StepSetup& setup) {
    if (setup.dimension != 2 && setup.dimension != 3)
        throw std::invalid_argument("dimension must be 2 or 3, found " +
                                    std::to_string(setup.dimension));
    if (setup.threads < 0 || setup.threads > max_threads)
        throw std::invalid_argument("threads must be between 0 and " + std::to_string(max_threads) +
                                    ", found " + std::to_string(setup.threads));
}

/// Threads that do nothing, all there at one time, until this ends.
class IdleThreads {
public:
    explicit IdleThreads(int count) {
        threads.reserve(static_cast<std::size_t>(count));
        try {
            for (int i = 0; i < count; ++i)
                threads.emplace_back([this] { wait(); });
        } catch (...) {
            end();
            throw;
        }
    }
    IdleThreads(const IdleThreads&) = delete;
    IdleThreads& operator=(const IdleThreads&) = delete;
    ~IdleThreads() { end(); }

private:
    std::mutex access;
    std::condition_variable changed;
    bool ended = false;
    std::vector<std::thread> threads;

    void wait() {
        std::unique_lock<std::mutex> lock(access);
        changed.wait(lock, [this] { return ended; });
    }

    void end() {
        {
            const std::lock_guard<std::mutex> lock(access);
            ended = true;
        }
        changed.notify_all();
        for (std::thread& thread : threads)
            thread.join();
    }
};

/// libgomp ends the process, which is the host's, where it cannot start its threads.
void check_threads_start(int threads) {
    try {
        const IdleThreads all(threads - 1);
    } catch (const std::system_error& error) {
        throw std::runtime_error(std::to_string(threads) +
                                 " threads cannot be started: " + error.what() + "; take fewer");
    }
}

} // namespace

std::unique_ptr<SurfaceStep> surface_step(const SurfaceTensionOptions& options,
                                          const StepSetup& setup, InstructionSet widest) {
    check_setup(setup);
    StepSetup resolved = setup;
    if (setup.threads == 0)
        resolved.threads = usual_threads();
    check_threads_start(resolved.threads);
    return with_instruction_set(widest,
                                [&](auto set) { return surface_step(set, options, resolved); });
}

} // namespace meniscus
