// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 88023 false positives:
//   boxhole_dfsph_04.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 2671 surface
//     sha256 be8736a9dc72fe72bf4bedf212d3e66eeaa7ccb18b4325bd9afbc527884e155d
//   boxhole_dfsph_18.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 3243 surface
//     sha256 ceb4c97ad579bbe537c526423ad033502db7063ab5d76acc085e1297acf9c2bf
//   crown_dfsph_02.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 9636 surface
//     sha256 8c5713dd862c5639f3bd74d5d1955a47cca9c653c67ba284da6704d3844c86b3
//   crown_dfsph_15.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 11198 surface
//     sha256 979589ddf7e607a1e660ddaa23a7ebd625ce7096c7b97be67e5cedcd32197164
//   cube_iisph_05.vtkhdf, scene SurfaceTension_NoGravCube_ZR2020: 10648 particles, 2705 surface
//     sha256 bf08473eecd726442928b70b40d498bd09f42390adc1a62fc4cf7ee3bf13caa6
//   dam_dfsph_01.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5136 surface
//     sha256 7c042c6108a1f36852ab6aaf573313e7b4261964fc0c47e0c0648527d891404a
//   dam_dfsph_04.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5118 surface
//     sha256 3bd0074fdaf1db6a1fb54d763e92caae370bfaadec71a5756d966a2a2677e603
//   dam_dfsph_08.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 6691 surface
//     sha256 41e0eb3f29a23ca604b62c2d083b20ff39a31f0111259ed9e088c4a976eb9304
//   dam_dfsph_14.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 7069 surface
//     sha256 98631a3237ef20ef903cc241e2d5449cb1990823dc5e6f0b4055d366dc7c5b46
//   droplet_iisph_01.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 b190c3f9ccee933c94d1550532f974d0dddc001b695c0a904173af62f6a714b1
//   droplet_iisph_04.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 ec9ca4dc9963ddb3e85eaabf6320962a3f3c319df9149d8250a0ef26b14bf2f0
//   droplet_iisph_06.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 b3aa70a9b663881e09519b5c586b5d031479830eb03da9678233df81d4984b2b
//   droplet_iisph_14.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2650 surface
//     sha256 d77cf518ccfc87a54d6b6bf6c812132b04e1a5027c95352cacb77b0c417c52bf
//   snake_dfsph_05.vtkhdf, scene SurfaceTension_SnakeTestZR2020: 6076 particles, 3026 surface
//     sha256 334bd81a64e53de57aecf91abb061db949d2258bf2e8845b5da572ac35935907
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_4FAE2C0255DC7276
#define MENISCUS_COEFFICIENTS_4FAE2C0255DC7276

namespace meniscus {

struct StrictSurfaceCoefficients {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 73.44967141220009;
    /// Neighbors, 0.000617 of them for rounding
    static constexpr double d = 34.57487845280154;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
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
