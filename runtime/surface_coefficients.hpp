// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 23266 false positives:
//   boxhole_dfsph_04.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 2545 surface
//     sha256 fbedf2fdcb2611dbe458216f057d81f11ad411c17b30606a02128b11edfc5006
//   boxhole_dfsph_18.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 3210 surface
//     sha256 d931c1736e812ebfbd25bb568aa495e2fb3475108f8ec892e76385a80b599465
//   crown_dfsph_02.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 8566 surface
//     sha256 35c72e39fd92a4ec86dc7d2539b08e84733aa92233c3c388814793bb327b8f1e
//   crown_dfsph_15.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 11070 surface
//     sha256 3ba574ed444972139ef4c1af6b81188190e8c801b2bf0f8507f06b6a55a4e0d6
//   cube_iisph_05.vtkhdf, scene SurfaceTension_NoGravCube_ZR2020: 10648 particles, 2689 surface
//     sha256 fc73e5b788468af4e0e9f64c337d866478c2947ac33f595536329e215d6d90c0
//   dam_dfsph_01.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5136 surface
//     sha256 057d0d700c0e41b4bf04e42c7fde6fcc8c4079dc6b18fdd976ba652205d9b349
//   dam_dfsph_04.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 4868 surface
//     sha256 c170b121fdddc3a24ed10af28eb91287b5af1c08abf398a03904537c08aa0b0e
//   dam_dfsph_08.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 6127 surface
//     sha256 25750ba848243b628058c1ac2ea2dfd23a0b78937c8d75f11b51fd48b8e48e5b
//   dam_dfsph_14.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 6595 surface
//     sha256 ee8c34cb9fd7cb954957ee351776b6517dc433c681eb750b2333c4d5f68a0c55
//   droplet_iisph_01.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 179cb60f282af6a96d8bca54aa0214863eba03c20924964cd5f2f1b07142b130
//   droplet_iisph_04.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 20daa6bfac4801465def8d3758aefd5935eee810b9b36d42c2186b10adbf801f
//   droplet_iisph_06.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2701 surface
//     sha256 63da8116fc31c88501922178fdda1793baea3a0e8a267ebabd9aef5032499032
//   droplet_iisph_14.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2610 surface
//     sha256 31fd727bbf38f93b4a27a2dbc66a450dcd35ad5f5321d0cba9ccbdef50dadbbe
//   snake_dfsph_05.vtkhdf, scene SurfaceTension_SnakeTestZR2020: 6076 particles, 3026 surface
//     sha256 5a5aa3bf49bc32c9de68feafe4684ac9d157c705b3b21ce486389972a666d5da
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_637E67641A65EC81
#define MENISCUS_COEFFICIENTS_637E67641A65EC81

namespace meniscus {

struct SurfaceCoefficients {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 116.66775196109981;
    /// Neighbors, 0.000833 of them for rounding
    static constexpr double d = 25.971460891431278;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.02;
    /// Least typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_min = 26.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_max = 43.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double spacing_ratio_min = 2.0;
    /// Largest support radius over particle spacing seen in training
    static constexpr double spacing_ratio_max = 2.0;
};

} // namespace meniscus

#endif
