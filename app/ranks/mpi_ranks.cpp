// The ranks of MPI. Only the main thread of a process speaks to MPI.
#include "ranks_of_program.hpp"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fcntl.h>
#include <mutex>
#include <thread>
#include <unistd.h>
#include <utility>

namespace meniscus {
namespace {

/// Largest message: MPI counts bytes by int.
constexpr std::size_t max_message = std::size_t{1} << 30;

int as_int(std::size_t count) {
    return static_cast<int>(count);
}

/// Calls post(place, bytes) for each message that so many bytes make.
template <class Post>
void for_messages(std::size_t size, const Post& post) {
    for (std::size_t place = 0; place < size; place += max_message)
        post(place, as_int(std::min(max_message, size - place)));
}

class MpiRanks final : public Ranks {
public:
    MpiRanks() {
        // Waiting ranks leave the cores to those at work.
        setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        MPI_Comm_rank(MPI_COMM_WORLD, &own);
        MPI_Comm_size(MPI_COMM_WORLD, &all);
    }

    [[nodiscard]] int rank() const override { return own; }
    [[nodiscard]] int size() const override { return all; }

    std::vector<std::string> exchange(std::vector<std::string> for_rank) override {
        const auto count = static_cast<std::size_t>(all);
        std::vector<std::uint64_t> sent(count);
        std::vector<std::uint64_t> received(count);
        for (std::size_t r = 0; r < count; ++r)
            sent[r] = for_rank[r].size();
        MPI_Alltoall(sent.data(), 1, MPI_UINT64_T, received.data(), 1, MPI_UINT64_T,
                     MPI_COMM_WORLD);
        std::vector<std::string> from_rank(count);
        std::vector<MPI_Request> requests;
        for (int r = 0; r < all; ++r) {
            std::string& bytes = from_rank[static_cast<std::size_t>(r)];
            if (r == own)
                continue;
            bytes.resize(received[static_cast<std::size_t>(r)]);
            for_messages(bytes.size(), [&](std::size_t place, int size) {
                MPI_Irecv(&bytes[place], size, MPI_BYTE, r, exchange_tag, MPI_COMM_WORLD,
                          &requests.emplace_back());
            });
        }
        for (int r = 0; r < all; ++r) {
            const std::string& bytes = for_rank[static_cast<std::size_t>(r)];
            if (r != own)
                for_messages(bytes.size(), [&](std::size_t place, int size) {
                    MPI_Isend(&bytes[place], size, MPI_BYTE, r, exchange_tag, MPI_COMM_WORLD,
                              &requests.emplace_back());
                });
        }
        MPI_Waitall(as_int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
        from_rank[static_cast<std::size_t>(own)] =
            std::move(for_rank[static_cast<std::size_t>(own)]);
        return from_rank;
    }

    void sum(std::vector<std::uint64_t>& values) override { reduce(values, MPI_SUM, MPI_UINT64_T); }
    void min(std::vector<double>& values) override { reduce(values, MPI_MIN, MPI_DOUBLE); }
    void max(std::vector<double>& values) override { reduce(values, MPI_MAX, MPI_DOUBLE); }

    static constexpr int exchange_tag = 1;
    static constexpr int request_tag = 2;
    static constexpr int answer_tag = 3;

private:
    int own = 0;
    int all = 1;

    template <class Value>
    static void reduce(std::vector<Value>& values, MPI_Op operation, MPI_Datatype type) {
        MPI_Allreduce(MPI_IN_PLACE, values.data(), as_int(values.size()), type, operation,
                      MPI_COMM_WORLD);
    }
};

/// What launchers tell the processes that they start: which one each is.
const char* launched_rank() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
        if (const char* rank = std::getenv(name))
            return rank;
    return nullptr;
}

MpiRanks* begun = nullptr;

void print_nothing() {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
}

constexpr std::uint64_t nothing = ~std::uint64_t{0};

/// A piece, or `nothing`, and its result.
std::string message_of(std::uint64_t piece, const std::string& result) {
    return std::string(reinterpret_cast<const char*>(&piece), sizeof piece) + result;
}

std::uint64_t piece_of(const std::string& message) {
    std::uint64_t piece = nothing;
    std::copy_n(message.data(), sizeof piece, reinterpret_cast<char*>(&piece));
    return piece;
}

/// Pieces that wait, and results of this process, between the thread that works and the one that
/// speaks to the other ranks.
class Desk {
public:
    explicit Desk(const std::vector<std::size_t>& pieces) : waiting(pieces.begin(), pieces.end()) {}

    std::uint64_t next() {
        const std::lock_guard<std::mutex> alone(lock);
        if (waiting.empty())
            return nothing;
        const std::uint64_t piece = waiting.front();
        waiting.pop_front();
        return piece;
    }

    void stop() {
        const std::lock_guard<std::mutex> alone(lock);
        waiting.clear();
    }

    void hand_in(std::string message) {
        const std::lock_guard<std::mutex> alone(lock);
        done.push_back(std::move(message));
    }

    /// Empty where there is none.
    std::string fetch() {
        const std::lock_guard<std::mutex> alone(lock);
        if (done.empty())
            return {};
        std::string message = std::move(done.front());
        done.pop_front();
        return message;
    }

private:
    std::mutex lock;
    std::deque<std::uint64_t> waiting;
    std::deque<std::string> done;
};

/// The message that waits from any rank, and which rank that is; empty where there is none.
std::pair<std::string, int> receive_request() {
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MpiRanks::request_tag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0)
        return {};
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    std::string message(static_cast<std::size_t>(size), '\0');
    MPI_Recv(message.data(), size, MPI_BYTE, status.MPI_SOURCE, MpiRanks::request_tag,
             MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return {message, status.MPI_SOURCE};
}

/// The first rank: one thread works as the other ranks do, this one answers them.
void serve(int ranks, const std::vector<std::size_t>& pieces, const WorkOnPiece& work,
           const TakeResult& take) {
    Desk desk(pieces);
    std::thread worker([&] {
        for (std::uint64_t piece = desk.next(); piece != nothing; piece = desk.next())
            desk.hand_in(message_of(piece, work(piece)));
        desk.hand_in(message_of(nothing, {}));
    });
    const auto handle = [&](const std::string& message) {
        if (piece_of(message) != nothing && !take(piece_of(message), message.substr(8)))
            desk.stop();
    };
    int at_work = ranks;
    while (at_work > 0) {
        bool is_idle = true;
        if (const std::string message = desk.fetch(); !message.empty()) {
            is_idle = false;
            handle(message);
            at_work -= piece_of(message) == nothing ? 1 : 0;
        }
        if (const auto [message, rank] = receive_request(); !message.empty()) {
            is_idle = false;
            handle(message);
            const std::uint64_t piece = desk.next();
            MPI_Send(&piece, 1, MPI_UINT64_T, rank, MpiRanks::answer_tag, MPI_COMM_WORLD);
            at_work -= piece == nothing ? 1 : 0;
        }
        if (is_idle)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    worker.join();
}

void ask_and_work(const WorkOnPiece& work) {
    std::string message = message_of(nothing, {});
    while (true) {
        MPI_Send(message.data(), as_int(message.size()), MPI_BYTE, 0, MpiRanks::request_tag,
                 MPI_COMM_WORLD);
        std::uint64_t piece = nothing;
        MPI_Recv(&piece, 1, MPI_UINT64_T, 0, MpiRanks::answer_tag, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        if (piece == nothing)
            return;
        message = message_of(piece, work(piece));
    }
}

} // namespace

Ranks& ranks_of_program() {
    if (begun == nullptr) {
        if (launched_rank() == nullptr)
            return one_process();
        begun = new MpiRanks;
        if (begun->rank() > 0)
            print_nothing();
    }
    return *begun;
}

void end_ranks() {
    if (begun == nullptr)
        return;
    MPI_Finalize();
    delete std::exchange(begun, nullptr);
}

bool is_other_rank() {
    const char* rank = launched_rank();
    return rank != nullptr && std::string(rank) != "0";
}

void hand_out(Ranks& ranks, const std::vector<std::size_t>& pieces, const WorkOnPiece& work,
              const TakeResult& take) {
    if (ranks.rank() == 0)
        serve(ranks.size(), pieces, work, take);
    else
        ask_and_work(work);
}

} // namespace meniscus
