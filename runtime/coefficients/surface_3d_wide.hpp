// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 42657 false positives:
//   crown_dfsph_0000.vtkhdf, scene crown_splash: 7751 particles, 663 surface
//     sha256 fac03dad9c2027838054f48e6723162e9b619dc228c86b5ad02f917ae556e7ef
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 618 surface
//     sha256 52b7bcdeb425c5f7eeb46c5592598e08432efbc60058c0c3701a873293359942
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 648 surface
//     sha256 a9e70bb7076e88640fea76792eb4344c2c545d0084dfda12206e2b5f8d24b356
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 666 surface
//     sha256 7c392d88f65051ddb0ef0d4aa564c09de15ac169d1195efe9f91f2a4f0200341
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 352 surface
//     sha256 71039bcb74133aabd05ac9411e1682797c88493860e8c56e4b981c4d7ccea685
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 371 surface
//     sha256 72cde3c0fb63877fa65d09c44bc155b072d22924c5bbb5fbe0acb408e9008b0f
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 431 surface
//     sha256 c9cb0048d07c33686deb195aaaf0fdae153294ea03b8d14f173f38817b361138
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 533 surface
//     sha256 420bb5976ede7b3e30948342e08ff4aaa6f9fe50c9083062fa3b1dfc6fdf2462
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 441 surface
//     sha256 26b827ea491d12239a46b9d25bcdc53b54eb7eea5d64c9bc0f0546d097ea6e23
//   droplet_dfsph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 6954aaffc66c57bd23c43186413b1d08b7d04742b55af5563dca83c177f97bbb
//   droplet_dfsph_0001.vtkhdf, scene double_droplet: 3456 particles, 1508 surface
//     sha256 c0ea10c3dab4cfb8b70a4645f42c7648f53f8f6a2c437886fe60dde276c2750a
//   droplet_dfsph_0002.vtkhdf, scene double_droplet: 3456 particles, 1544 surface
//     sha256 6b2984a8437bf64295320c778767c5d19e74a9f10202e5a3a12c63bf3a0fe271
//   droplet_dfsph_0003.vtkhdf, scene double_droplet: 3456 particles, 1523 surface
//     sha256 c8e983d700d6aa6dc31c6442e974b6b5238080e51611cd156d3b0cab1067f1fb
//   droplet_dfsph_0004.vtkhdf, scene double_droplet: 3456 particles, 1538 surface
//     sha256 fb49f0c3048168413b5034a20095a3db5b420d9d3b11ce5987d5146ffc43469a
//   droplet_light_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 16f20360001ab404ea99c16db612dc4898b883db8a176e18ca91036503747002
//   droplet_light_0001.vtkhdf, scene double_droplet: 3456 particles, 1607 surface
//     sha256 fd894a84e11cae089e89a5c7c89f82880ae8d3cefb8bd912ae37f1371f171367
//   droplet_light_0002.vtkhdf, scene double_droplet: 3456 particles, 1623 surface
//     sha256 0d1d5c3b78c0c873cdb58bfa669d038c5f433dc7b76f683b137d946120aafd5e
//   droplet_light_0003.vtkhdf, scene double_droplet: 3456 particles, 1659 surface
//     sha256 d882ab41b7d5d102c871fb9da589be3ad24225fe203db86446fcd7ff623fe760
//   droplet_light_0004.vtkhdf, scene double_droplet: 3456 particles, 1659 surface
//     sha256 8eabaa47f6ec00812b775112ee640fa16a84c63e3e681bef34a5a9c5e5940e0a
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 f6ab3921a838cbaa96e5b0b4c736c4bd28f7edf980cb7833c3cb075c1ceb0029
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1733 surface
//     sha256 d64188c6c7cffe23b2e8f4fcf63238d99610564fb2af65878b30ce032cd2ef61
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1665 surface
//     sha256 04db5b12af0ca419c0d305d9c86cceb30ad18cd3c103386b4b5ec7125f416487
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1672 surface
//     sha256 67165be0c3057bc709d12371f6c1633b87e464600863f63c380a4642e3778428
//   obstacle_light_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 352 surface
//     sha256 c223a1129243aeb0d98ceb3b2897bd8eeb38865de71498f6e6e51683fac8cfa3
//   obstacle_light_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 361 surface
//     sha256 90a131b758622d5f1e89e809119cf867e45170846e410544a617a2911d18b7e1
//   obstacle_light_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 681 surface
//     sha256 9975875f682465b5dbdf0ffc6c6ab954db0891aee0d8fbdd427c06aef74338b1
//   obstacle_light_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 610 surface
//     sha256 f1d4501ba37b7aa29c3104f1ff4ea9c29d550c00ef058f6625151b9eac7c6031
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 595a8008355a18d19a01340dc1b112edd87809af31e45c74ba93a2eab04609a4
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1536 surface
//     sha256 4d9e6b40387a4a9cd772bc8c1af3f70572d8ded6ddc7828b3dbbcf86278ccf0d
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3906 surface
//     sha256 e6b509bebb5032509b0c803eb1cbe92ba07676b7be36b35cf7bf5fe2b987c4fd
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 2843 surface
//     sha256 ab56d9a488a0c3ff643d8a7653d1c14a317ea7f4a2381140e43f7e5a87357c14
#ifndef MENISCUS_COEFFICIENTS_69C2945B6C90E5FE
#define MENISCUS_COEFFICIENTS_69C2945B6C90E5FE

namespace meniscus {

struct Surface3DWide {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 442.125622007613;
    /// Neighbors, 0.00246 of them for rounding
    static constexpr double d = 34.842534776699765;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.02;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 42.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 82.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.5;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.5;
};

} // namespace meniscus

#endif
