// Which instruction set a kernel runs with.
#include <meniscus/runtime/simd/dispatch.hpp>

#include <gtest/gtest.h>
#include <string>

namespace meniscus {
namespace {

constexpr InstructionSet set_of(CompiledFor<InstructionSet::baseline> /*tag*/) {
    return InstructionSet::baseline;
}
constexpr InstructionSet set_of(CompiledFor<InstructionSet::avx2> /*tag*/) {
    return InstructionSet::avx2;
}
constexpr InstructionSet set_of(CompiledFor<InstructionSet::avx512> /*tag*/) {
    return InstructionSet::avx512;
}

TEST(InstructionSets, AreTheWidestOfTheMachineUpToTheOneAskedFor) {
    EXPECT_TRUE(is_supported(InstructionSet::baseline));
    for (const InstructionSet widest : instruction_sets) {
        const InstructionSet found =
            with_instruction_set(widest, [](auto set) { return set_of(set); });
        EXPECT_LE(found, widest);
        EXPECT_TRUE(is_supported(found));
        EXPECT_EQ(found == widest, is_supported(widest)) << name_of(widest);
        EXPECT_EQ(found, instruction_set_up_to(widest));
    }
}

TEST(InstructionSets, HaveNamesOfTheirOwn) {
    EXPECT_EQ(name_of(InstructionSet::baseline), std::string("baseline"));
    EXPECT_EQ(name_of(InstructionSet::avx2), std::string("AVX2"));
    EXPECT_EQ(name_of(InstructionSet::avx512), std::string("AVX-512"));
}

} // namespace
} // namespace meniscus
