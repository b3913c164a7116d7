#include "scratch_streams.hpp"

#include <algorithm>
#include <string>

namespace meniscus {

void ScratchStreams::append(std::size_t stream, std::string_view bytes) {
    if (bytes.empty())
        return;
    auto& of_stream = pieces[stream];
    if (!of_stream.empty() && of_stream.back().first + of_stream.back().size == file.size())
        of_stream.back().size += bytes.size();
    else
        of_stream.push_back({file.size(), bytes.size()});
    file.append(bytes.data(), bytes.size());
}

std::uint64_t ScratchStreams::size(std::size_t stream) const {
    std::uint64_t sum = 0;
    for (const Piece& piece : pieces[stream])
        sum += piece.size;
    return sum;
}

void ScratchStreams::visit(std::size_t stream, std::size_t record, std::size_t at_once,
                           const std::function<void(std::string_view)>& use) const {
    const std::uint64_t most = std::max(at_once / record, std::size_t{1}) * record;
    std::string some;
    for (const Piece& piece : pieces[stream])
        for (std::uint64_t place = 0; place < piece.size; place += most) {
            some.resize(std::min(most, piece.size - place));
            file.read(piece.first + place, some.data(), some.size());
            use(some);
        }
}

} // namespace meniscus
