#include "unforeseen_end.hpp"

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <unistd.h>

namespace meniscus {
namespace {

bool is_at_work = false;

/// There may be no memory for anything more.
[[noreturn]] void end_with(std::string_view line) {
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line.data(), line.size());
    _exit(3);
}

void end_after_exit() {
    if (is_at_work)
        end_with("meniscus: a library gave up; the machine lacks memory or threads\n");
}

[[noreturn]] void end_after_exception() {
    try {
        if (const std::exception_ptr thrown = std::current_exception())
            std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        end_with("meniscus: out of memory\n");
    } catch (...) { // printing it may be what fails
    }
    end_with("meniscus: an error came up that nothing was ready for\n");
}

} // namespace

UnforeseenEnd::UnforeseenEnd() {
    is_at_work = true;
    std::atexit(end_after_exit);
    std::set_terminate(end_after_exception);
}

UnforeseenEnd::~UnforeseenEnd() {
    is_at_work = false;
}

} // namespace meniscus
