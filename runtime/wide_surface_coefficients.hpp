// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 40577 false positives:
//   crown_dfsph_0000.vtkhdf, scene crown_splash: 7751 particles, 663 surface
//     sha256 fac03dad9c2027838054f48e6723162e9b619dc228c86b5ad02f917ae556e7ef
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 622 surface
//     sha256 c2d57fd3c3cb606eadd669bc6b49495fee1843b3f3ea910ccce5404571f827e1
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 640 surface
//     sha256 a272b3469a7509fdcfc6e7fe44dccd261c82c3aa7ff51469313c881234dadd70
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 695 surface
//     sha256 64a8aa4387952441e2cff519e67bab2e8bdc9103f24fef9ae095c3796e5ba9ee
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 352 surface
//     sha256 71039bcb74133aabd05ac9411e1682797c88493860e8c56e4b981c4d7ccea685
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 370 surface
//     sha256 f3524be9a83a3804e8894d804f96b855d5017277c2c433425e3ef9605a8a9d55
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 412 surface
//     sha256 b6d9080867c5662893d3d90cad84a0f1bb422e019a4b84e86454d8c542ef55f8
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 518 surface
//     sha256 ea2fafd00746a781b3d00de9761c8f875c0300d19d2fb80b039c68ab15fa659e
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 444 surface
//     sha256 730ea5d43518ec4eb37b8bbfb0c777ea40384106a59103c01838fb8db46833cc
//   droplet_dfsph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 6954aaffc66c57bd23c43186413b1d08b7d04742b55af5563dca83c177f97bbb
//   droplet_dfsph_0001.vtkhdf, scene double_droplet: 3456 particles, 1398 surface
//     sha256 b15e50434fae84e6f36bc3401c6401c2fe4350558d5b7c400e9b2e265cbc91e1
//   droplet_dfsph_0002.vtkhdf, scene double_droplet: 3456 particles, 1503 surface
//     sha256 1a12c9d297755b5d80fb2a9d776e8b33bcb3c48f814ffb4d70b84ec143a865dc
//   droplet_dfsph_0003.vtkhdf, scene double_droplet: 3456 particles, 1555 surface
//     sha256 d5e352592f1fcda482e5f8a89a7f62cec53977556be01feabe48d6bcf38176fe
//   droplet_dfsph_0004.vtkhdf, scene double_droplet: 3456 particles, 1536 surface
//     sha256 6a07f5e4be783c3dffab1a09b73c52de7dd79965091e42a071061a44cf220e93
//   droplet_light_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 16f20360001ab404ea99c16db612dc4898b883db8a176e18ca91036503747002
//   droplet_light_0001.vtkhdf, scene double_droplet: 3456 particles, 1551 surface
//     sha256 c465d5aac49e865de1e470f4159c05c923b26b8ad93d91f398c6411e948a79d6
//   droplet_light_0002.vtkhdf, scene double_droplet: 3456 particles, 1598 surface
//     sha256 d265c0829a0f7f2767a7cdaade737be71530f1274369b2bc03ca54bfe2cb04fa
//   droplet_light_0003.vtkhdf, scene double_droplet: 3456 particles, 1679 surface
//     sha256 f4f8938c48737d1d845f75a97de35fc13f99e627a3c134ea473f4acaa08c1feb
//   droplet_light_0004.vtkhdf, scene double_droplet: 3456 particles, 1595 surface
//     sha256 65f024261e6f7d74ddc4f1545e1105b3866dcac484970ce64424c69546b119cb
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 f6ab3921a838cbaa96e5b0b4c736c4bd28f7edf980cb7833c3cb075c1ceb0029
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1737 surface
//     sha256 889d5c493188d74a33db569007c1b98a6d0ce88d8f53767a491747b512d6e57a
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1650 surface
//     sha256 a989516200d4afb0cc9afe3c0bed4d6830ca08bb43d56b56414565d3c8127341
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1661 surface
//     sha256 cbadd60a39bbc016f77f399935a5d8df189195716e041faae728de575cd08845
//   obstacle_light_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 352 surface
//     sha256 c223a1129243aeb0d98ceb3b2897bd8eeb38865de71498f6e6e51683fac8cfa3
//   obstacle_light_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 341 surface
//     sha256 908b3426fc40f595e5e13b388de5d03c79323f3afefb9f8a2d992451ed0a000f
//   obstacle_light_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 648 surface
//     sha256 c79bac6f6aa12ab3e9a9699043fdd07b6f5b20d7fbd9f8df6ff805e9bf93e032
//   obstacle_light_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 573 surface
//     sha256 b432696ffc18d78e46b5939db16b84a0612a48110bc575e8c253b3bde52d29b3
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 595a8008355a18d19a01340dc1b112edd87809af31e45c74ba93a2eab04609a4
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1538 surface
//     sha256 d58a15600d6c889b2cec0abddca9fa07b55b4d8c9103e4c159bf086db9f05086
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3773 surface
//     sha256 2c76f69d46d29e10ce5ce3b63570be1c19af76638d63faaf1249d41022b5b6c9
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 2954 surface
//     sha256 3c613b7d4a9103f9958efb44c09af0312a15e1b855aa848c5eb3710997794675
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_B1F4B29ED86C89D8
#define MENISCUS_COEFFICIENTS_B1F4B29ED86C89D8

namespace meniscus {

struct WideSurfaceCoefficients {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 371.42707280837874;
    /// Neighbors, 0.00211 of them for rounding
    static constexpr double d = 34.18325516206112;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.02;
    /// Least typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_min = 44.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_max = 81.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double spacing_ratio_min = 2.5;
    /// Largest support radius over particle spacing seen in training
    static constexpr double spacing_ratio_max = 2.5;
};

} // namespace meniscus

#endif
