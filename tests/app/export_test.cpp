#include "command.hpp"

#include <meniscus/classifier/export/header_export.hpp>

namespace meniscus {
namespace {

class Export : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        const Path labelled = label(save(block(6), "block.vtkhdf"));
        succeed({"train", labelled, "-o", model, "--quiet"});
    }

    const Path model = folder / "model.json";
    const Path header = folder / "surface_coefficients.hpp";
};

TEST_F(Export, HeaderIsWhatTheLibraryGives) {
    expect_mentions(succeed({"export", model, "-o", header}), {"meniscus::SurfaceCoefficients"});
    EXPECT_EQ(bytes_of(header), coefficient_header(read_model(model), "SurfaceCoefficients"));
    EXPECT_EQ(succeed({"export", model, "-o", header, "--name", "Calm", "--quiet"}), "");
    EXPECT_EQ(bytes_of(header), coefficient_header(read_model(model), "Calm"));
}

TEST_F(Export, SameBytesEveryTime) {
    succeed({"export", model, "-o", header});
    const std::string first = bytes_of(header);
    std::filesystem::remove(header);
    succeed({"export", model, "-o", header});
    EXPECT_EQ(bytes_of(header), first);
}

TEST_F(Export, HeaderCompilesAlone) {
    succeed({"export", model, "-o", header});
    const Outcome compiled = run({MENISCUS_CXX_COMPILER, "-std=c++17", "-Wall", "-Wextra",
                                  "-Werror", "-x", "c++", "-c", header, "-o", folder / "alone.o"});
    EXPECT_EQ(compiled.status, 0) << compiled.errors;
}

TEST_F(Export, RefusesNamesThatAreNone) {
    for (const char* name : {"", "2d", "int", "my-line", "a b", "k"})
        fail(2, {"export", model, "-o", header, "--name", name}, {name});
}

TEST_F(Export, DoesNotOverwriteItsInput) {
    const std::string bytes = bytes_of(model);
    fail(2, {"export", model, "-o", model}, {"model.json", "overwrite"});
    EXPECT_EQ(bytes_of(model), bytes);
}

} // namespace
} // namespace meniscus
