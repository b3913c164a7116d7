// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 5939 false positives:
//   dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 41f4cea4682789cf8804cd468dca01bececa1521525052cb12a9317504431e0c
//   dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 131 surface
//     sha256 63af1051303ffe351bc8b2f9485435bc28666be19c229152beaee4a44905a68b
//   dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 199 surface
//     sha256 1f06f5a1ab6fd85f2f9a27f2ee1fe28e980483fb6b719f5b163afa59ffed738b
//   dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 273 surface
//     sha256 4e09e28913cb351b43eb78d15bde5ff8a5d79eea2f104fa4de4d55c4d65e4f36
//   dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 332 surface
//     sha256 9764a996472ebbd2411efb7143ad9c9c1228275ec775798e33c3b7036d16767c
//   dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 365 surface
//     sha256 6dd81cd2c3a7b5e775a8b48c8e5d9193da5cd0d5b6a6770bd5b7ea175eaa0e85
//   dam_light_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 5b7d5e460071092a5b15756b0e6b7a8c0b10b936a1acdedffe02692c71499844
//   dam_light_0001.vtkhdf, scene dam_break_2d: 1250 particles, 125 surface
//     sha256 205cb4028fc4ed7af2819efc5eacd2f64e2bbcb0158f35e720b7559c94cbf02e
//   dam_light_0002.vtkhdf, scene dam_break_2d: 1250 particles, 221 surface
//     sha256 447d9df044efa26b0fc127ad6f3025fe090e795fb6f9d37bda26101fa0cdb3b8
//   dam_light_0003.vtkhdf, scene dam_break_2d: 1250 particles, 315 surface
//     sha256 3fdc9b63770c847330ec0aee59d4f27b07a14603d7bc763044607efdf3e113e2
//   dam_light_0004.vtkhdf, scene dam_break_2d: 1250 particles, 399 surface
//     sha256 476fbfede3b6727f05b0238f1fedb03b73878ce4b7ba0b82c5480c12dd06b5c7
//   drop_dfsph_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 5d2e47ccf6966be8003d86b814d3f31505e02ef1929802b5688d0d0b248f7312
//   drop_dfsph_0001.vtkhdf, scene drop_2d: 1600 particles, 206 surface
//     sha256 aec073ebe6caee58b862e9efdd48fddc567018a408daee41ed07cde0fd477739
//   drop_dfsph_0002.vtkhdf, scene drop_2d: 1600 particles, 217 surface
//     sha256 4a06b5c4ad2ce4896df98c9cecfdc42655900f2f2481c7f55cf0a83c27fa51a0
//   drop_dfsph_0003.vtkhdf, scene drop_2d: 1600 particles, 218 surface
//     sha256 b078d4b1cd4b927d97cea9261c43c6a4915217053ba2a2a9438f75d6574aae38
//   drop_wider_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 f3ce11703a1426ae66772cb07344972db1abe923c3f198fef527791dd487b06b
//   drop_wider_0001.vtkhdf, scene drop_2d: 1600 particles, 222 surface
//     sha256 3cece0daf54c5e92d0414ad005e95be616189b1977a8a4384d36b405cb42f68f
//   drop_wider_0002.vtkhdf, scene drop_2d: 1600 particles, 232 surface
//     sha256 1c152b389e458a91e83a608e1e147df8dd910018759e336457d29423df961b6c
//   square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 99 surface
//     sha256 bb36552735e5d7ad54a5bc5ad35933c568130ae4145b278e8abe7f0d1896dade
//   square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 161 surface
//     sha256 920c265e7baae5105f3f2554fda17979a6f7c744577ab5ab660af230d80e14e5
//   square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 205 surface
//     sha256 84b28287a664493d70a86684e1a218fe9fcccb80259910a8512b50f9c46db041
//   square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 277 surface
//     sha256 61ad9404062e6f124c83a61bf96acaa79efa849f4787a342fad4df80a7fe57cd
//   square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 350 surface
//     sha256 cbf270e1aca31fd56ae252f1904eb2e9c820af0f7693733d2029a3037d81355c
//   square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 417 surface
//     sha256 876cf084c93c48e7e3d4bf673683faedcd18ad48e894d27727bafa6332f01732
//   square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 485 surface
//     sha256 43819066fe0473c18e30380735a9d07f02663117fe56f9ee2365b0282b746c4d
//   square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 540 surface
//     sha256 a5c81752fe21a5de2323827ccefcac0f5dbd435b4c5ddfed888d40ac8715c8a0
//   square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 557 surface
//     sha256 6f4390f93a83eddf63b19621f85fcd1a55c3bf9235b503877017af3a58ddd298
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_60673BE2132B5B22
#define MENISCUS_COEFFICIENTS_60673BE2132B5B22

namespace meniscus {

struct WideSurfaceCoefficients2D {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 51.49784646601718;
    /// Neighbors, 0.000507 of them for rounding
    static constexpr double d = 11.633610271615069;
    static constexpr int dimension = 2;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
    /// Least typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_min = 17.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_max = 24.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double spacing_ratio_min = 2.5;
    /// Largest support radius over particle spacing seen in training
    static constexpr double spacing_ratio_max = 2.6;
};

} // namespace meniscus

#endif
