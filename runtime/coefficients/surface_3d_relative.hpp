// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
// The line is relative: scale k and d by your median neighbor count over
// reference_neighbor_count.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 9218 false positives:
//   boxhole_dfsph_04.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 2545 surface
//     sha256 88dad6a2af49e72ca7b4a6ab92831d6a66efd884485edfe3322910c674875a81
//   boxhole_dfsph_18.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 3210 surface
//     sha256 306532064595c3beb4d1634d9f3e5a2229454572ec012f74d9bf63e5868fa8cc
//   crown_dfsph_02.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 8567 surface
//     sha256 fa7f0ed4a821854251fa84485dd2bc11dfcb1508cb32148c736a950f01e0cb6e
//   crown_dfsph_15.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 11070 surface
//     sha256 3bc29c1fcb7e5667d94e22c8e3a510afcdaccb206bc9a240b1ac7e2330d885e7
//   cube_iisph_05.vtkhdf, scene SurfaceTension_NoGravCube_ZR2020: 10648 particles, 2689 surface
//     sha256 3a243a39a6f4e56c648eb2cad97322a730479f9df7f337ce8af18b9d2043fe22
//   dam_dfsph_01.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5136 surface
//     sha256 4061a239939c323ee1040045fab3c96c5ea9e401c9dc4e906aab7d8e2aba06b7
//   dam_dfsph_04.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 4868 surface
//     sha256 80c7a2cf5d45f32e03844c8f897968c7644d4d95d3d1bbde5d0cec7726c18647
//   dam_dfsph_08.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 6127 surface
//     sha256 93ba9c4713188a47e717efd3aacc9fb24abd81f3e66bd681a1c885294a2d4ab9
//   dam_dfsph_14.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 6595 surface
//     sha256 6b491735932c687ea48707864705f2d681d977a934cacdad6812ac7a97964769
//   droplet_iisph_01.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 de464399e1c0197987b1ecd2f27b80e8bbf3df6d1d94d82a590c0c437214b162
//   droplet_iisph_04.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 26c39b74b27b63f97406234ca4c579dc7233c49212552dbdc1d46489b2261bb3
//   droplet_iisph_06.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2701 surface
//     sha256 5e763d0820557e2efebffd21ee496f8b847b0972db99500d6fbbf39ef65cc731
//   droplet_iisph_14.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2610 surface
//     sha256 fd6704ffb9c62ed88017e2355c83a1df564b9cf4fdd979a5fa4941b66378b24f
//   snake_dfsph_05.vtkhdf, scene SurfaceTension_SnakeTestZR2020: 6076 particles, 3026 surface
//     sha256 e32353f47ae34a2b368ffc384421b35e3c9cd44bfe8e1ab5bbf7e037c39b0279
#ifndef MENISCUS_COEFFICIENTS_18F166AA66E45E03
#define MENISCUS_COEFFICIENTS_18F166AA66E45E03

namespace meniscus {

struct Surface3DRelative {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 101.91804334333142;
    /// Neighbors, 0.00076 of them for rounding
    static constexpr double d = 25.20984041450605;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// k and d are for this median neighbor count; scale them to yours
    static constexpr double reference_neighbor_count = 40.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.02;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 26.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 43.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.0;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.0;
};

} // namespace meniscus

#endif
