#include "campaign.hpp"

#include <meniscus/data/ranks/packing.hpp>

#include <algorithm>
#include <numeric>
#include <system_error>

namespace meniscus {

/// Found by argument, as the others are.
template <class Pack>
static void carry(Pack& pack, StateHead& head) {
    LabelledState& state = head.state;
    carry(pack, state.file);
    carry(pack, state.hash);
    carry(pack, state.scene);
    pack.number(state.dimension);
    carry(pack, state.support_radius);
    pack.number(state.radius_ratio);
    carry(pack, state.boundary_weight);
    carry(pack, state.spacing_ratio);
    pack.number(state.features);
    pack.number(state.count_scale);
    pack.number(head.particles);
    pack.number(head.surface);
    carry(pack, head.bulk_neighbor_count);
}

namespace {

StateHead head_of(const LabelledState& state, double label_threshold) {
    StateHead head;
    LabelledState& own = head.state;
    own.file = state.file;
    own.hash = state.hash;
    own.scene = state.scene;
    own.dimension = state.dimension;
    own.support_radius = state.support_radius;
    own.radius_ratio = state.radius_ratio;
    own.boundary_weight = state.boundary_weight;
    own.spacing_ratio = state.spacing_ratio;
    own.features = state.features;
    own.count_scale = state.count_scale;
    head.particles = state.size();
    head.surface = static_cast<std::size_t>(
        std::count_if(state.uncovered_fraction.begin(), state.uncovered_fraction.end(),
                      [&](double lambda) { return lambda > label_threshold; }));
    head.bulk_neighbor_count = bulk_neighbor_count(state);
    return head;
}

/// The places of the files that a rank works on.
std::vector<std::size_t> share_of(const std::vector<std::filesystem::path>& files,
                                  const Ranks& ranks) {
    std::vector<std::uint64_t> bytes;
    for (const auto& file : files) {
        std::error_code unknown;
        const auto size = std::filesystem::file_size(file, unknown);
        bytes.push_back(unknown ? 0 : size);
    }
    std::vector<std::size_t> by_size(files.size());
    std::iota(by_size.begin(), by_size.end(), std::size_t{0});
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](std::size_t a, std::size_t b) { return bytes[a] > bytes[b]; });
    std::vector<std::uint64_t> given(static_cast<std::size_t>(ranks.size()));
    std::vector<std::size_t> own;
    for (const std::size_t place : by_size) {
        const auto least = std::min_element(given.begin(), given.end());
        *least += bytes[place] + 1;
        if (least - given.begin() == ranks.rank())
            own.push_back(place);
    }
    std::sort(own.begin(), own.end());
    return own;
}

/// A head with its place, so that all ranks have them in the order of the files.
struct PlacedHead {
    std::size_t place = 0;
    StateHead head;
};

template <class Pack>
void carry(Pack& pack, PlacedHead& placed) {
    pack.number(placed.place);
    carry(pack, placed.head);
}

void gather_heads(const std::vector<PlacedHead>& own, Ranks& ranks, Campaign& campaign) {
    for (const std::string& said : gather(ranks, packed(own)))
        for (PlacedHead& placed : unpacked<std::vector<PlacedHead>>(said))
            campaign.heads.at(placed.place) = std::move(placed.head);
}

} // namespace

std::vector<LabelledState> Campaign::states() const {
    std::vector<LabelledState> all;
    all.reserve(heads.size());
    for (const StateHead& head : heads)
        all.push_back(head.state);
    return all;
}

Campaign campaign_of(const std::vector<LabelledState>& states, double label_threshold) {
    Campaign campaign;
    for (const LabelledState& state : states)
        campaign.heads.push_back(head_of(state, label_threshold));
    campaign.in_memory = &states;
    campaign.visit = [&states](const VisitState& visit) {
        for (std::size_t place = 0; place < states.size(); ++place)
            visit(place, states[place]);
    };
    return campaign;
}

Campaign campaign_of(const std::vector<std::filesystem::path>& files, const std::string& scene,
                     const FeaturePair& features, double label_threshold, Ranks& ranks) {
    Campaign campaign;
    campaign.ranks = &ranks;
    campaign.heads.resize(files.size());
    campaign.visit = [&ranks, files, scene, features,
                      own = share_of(files, ranks)](const VisitState& visit) {
        do_together(ranks, [&] {
            for (const std::size_t place : own)
                visit(place, read_labelled_state(files[place], scene, features));
        });
    };
    std::vector<PlacedHead> own;
    campaign.visit([&](std::size_t place, const LabelledState& state) {
        own.push_back({place, head_of(state, label_threshold)});
    });
    gather_heads(own, ranks, campaign);
    return campaign;
}

} // namespace meniscus
