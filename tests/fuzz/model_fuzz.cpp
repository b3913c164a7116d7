// Models: what is read is written so that it reads back the same.
#include "fuzz_file.hpp"

#include <meniscus/classifier/model/model.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return meniscus::run_reader(data, size, [](const std::filesystem::path& file) {
        const std::string text = meniscus::model_to_json(meniscus::read_model(file));
        meniscus::require(meniscus::model_to_json(meniscus::model_from_json(text, "again")) == text,
                          "a model that is written reads back the same");
        return meniscus::Snapshot{};
    });
}
