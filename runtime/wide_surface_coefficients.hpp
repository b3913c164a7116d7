// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 41019 false positives:
//   crown_dfsph_0000.vtkhdf, scene crown_splash: 7751 particles, 663 surface
//     sha256 8ed50a1bc3c21516cb49d4d0ecc766702237dc364762e078f6e85dbe0c2b6397
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 622 surface
//     sha256 518bd34e28ce6d0932d7cf89fc519342709fed8be0c0484c534c6022b82446e4
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 636 surface
//     sha256 44de93c6766cd0b05a836aea9447d141c46990b0d2df12d10c0bcd95327b965e
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 691 surface
//     sha256 c2e1cfa2d04b4f989e0ccb5bb6584b6303ec537db89f95732619867999047df9
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 352 surface
//     sha256 8e45b45415574487340b4b0466a474746bf3bfb0f8dc9674b3d3c800171bf88a
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 370 surface
//     sha256 39641e55de8aaecd0dc1f403b25a64125ad0a10121303f9e7b3d29ae86b007f7
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 430 surface
//     sha256 e841c5636439087825c89521932854eed22f095ec65785555a1e534b4102edba
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 482 surface
//     sha256 1f02c730da0a1e43c4ce610e1d5505bbb1e0ae4abfc7b7c6a9cd96f87159a2e1
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 445 surface
//     sha256 b8c079dcf65143191ffe0af828efa33f03da00c970a02be28490af4c1f6a3e2d
//   droplet_dfsph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 9367fc2da68fde61abbea9ca24cb91ab5c9ea573938de68fef1fe5ff287b3996
//   droplet_dfsph_0001.vtkhdf, scene double_droplet: 3456 particles, 1398 surface
//     sha256 a75d7b8e4c10e4ac3e291facad94247aa28308d0665de46aa7df88bb6563d3a5
//   droplet_dfsph_0002.vtkhdf, scene double_droplet: 3456 particles, 1503 surface
//     sha256 2c299080d90ffe1c2bd23df7d1f5cd658f7aa85d1194c568e1a5d48bd7a3b3a1
//   droplet_dfsph_0003.vtkhdf, scene double_droplet: 3456 particles, 1555 surface
//     sha256 876cd8631309a9209136132098ef89ddb7928f020ea7a16137dcfcc780fcb123
//   droplet_dfsph_0004.vtkhdf, scene double_droplet: 3456 particles, 1536 surface
//     sha256 fd40e4bb1fa45b8e6bb3d6dfb3102d3eb0d4c591b076d09686427c2195b1d80e
//   droplet_light_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 5d28c360d3c9a9e7fd903a504f69e177dcbdf092c262337f428833b8fead7632
//   droplet_light_0001.vtkhdf, scene double_droplet: 3456 particles, 1551 surface
//     sha256 93ed1ccd6b78fd53746befcd7b9906501854a844ce8c518cd234260dab8c4c3a
//   droplet_light_0002.vtkhdf, scene double_droplet: 3456 particles, 1598 surface
//     sha256 42f567d00a18767bb5c089285c495e65964456d5d1af209078f81f0a8baa3db3
//   droplet_light_0003.vtkhdf, scene double_droplet: 3456 particles, 1679 surface
//     sha256 a312425ba4c8b9feb2a5c688192d2d70ced43364c00b45e7d1907303ffa4420a
//   droplet_light_0004.vtkhdf, scene double_droplet: 3456 particles, 1595 surface
//     sha256 9120f090a725054ae17ddd8b2981d8ebe4262dbe967a0718faf2ec4728a8cfb0
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 2520c69888e9c7b20cce33623fdd6e35e01189e624b59d7a6a3cfe95d247b3c1
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1737 surface
//     sha256 7d95283f0b32c58105fa65b92853a93a150d789f2c88dd507f741397f346b94e
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1650 surface
//     sha256 a0a71b609ed0ff1cebc3713ce51b9cf089135b660b80c042f328400c145788e6
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1661 surface
//     sha256 2a6d0d4678688ee83b2873fd3f4b63b105e65fac53f3095654df90a2f29c5229
//   obstacle_light_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 352 surface
//     sha256 cba912a060a7f3f519f828bc5ac5f6294237772da8f1605df3e545d3ac46f230
//   obstacle_light_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 341 surface
//     sha256 c47ffb8ed65a8601a6be82f3e04f6c52f6925f2f18abd733e8f1d1a8666d38f9
//   obstacle_light_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 654 surface
//     sha256 aefeefbed3528638e7c785e70beca1ef609becff5b9f0ed807081134a79f1a4e
//   obstacle_light_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 598 surface
//     sha256 fb6cfab8f5716fa8c72018908767b351f24348c6cb78525ada095fa0735065c7
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 f0f747a8e436f1e8109279bda5d4831207aa4878d2372fb3d6cd5bc0c7d20279
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1535 surface
//     sha256 415c87183041ff36ea9bb587b4f83136035260dbbade0d8aa45b53e9bc359b70
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3818 surface
//     sha256 765ca896ebb772ff429035949f75fe6934e3d857efb7c88cb90f10237843f7bb
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 2908 surface
//     sha256 c46b01a670520a35634c95465e8b60a16034e34d68959b48842c59d4bb95aa1d
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_6460658F911B747C
#define MENISCUS_COEFFICIENTS_6460658F911B747C

namespace meniscus {

struct WideSurfaceCoefficients {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 335.73996543288087;
    /// Neighbors, 0.00193 of them for rounding
    static constexpr double d = 37.816752163763056;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.02;
    /// Least typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_min = 43.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_max = 81.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double spacing_ratio_min = 2.5;
    /// Largest support radius over particle spacing seen in training
    static constexpr double spacing_ratio_max = 2.5;
};

} // namespace meniscus

#endif
