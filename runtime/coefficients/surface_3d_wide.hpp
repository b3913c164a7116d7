// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles count by 0.85 of their volume.
// On its training files it has 0 false negatives and 17079 false positives:
//   crown_dfsph_0000.vtkhdf, scene crown_splash: 7751 particles, 663 surface
//     sha256 f75e3c154ebe2b7aed8e27fc9b6f0f53ee8f3f027aa023145776d3f1c576d548
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 618 surface
//     sha256 1ac475e896386952491c87091e286f0dbe712728331bf5088059dab61de343de
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 648 surface
//     sha256 8921245d74fe257adb5232677a26a08cbee600c6304db55e7ad474865b0316ac
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 666 surface
//     sha256 d55ae6af7f7e30a314e9dbc58fdda9ad24b6c31cd6700d0130d72080234e1256
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 352 surface
//     sha256 5676834cd794d1622f9e327c888a56c6443ec817b4682fac85e9754980486b03
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 363 surface
//     sha256 eff3f373dea5dbf16feab89b13abb887047c332db625c58ffad4876af241e7aa
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 371 surface
//     sha256 a5ba80632b0db1d3df83ff0480df2cac09bc044b79905d8e01451319bf67cfe5
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 fa882c96df6d6ad2cc7981d24cefb874dcdc7c5536ff335626d772e3fec210c3
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 428 surface
//     sha256 e17b20c1aa4071c4a1e9ef8541eaa11fa3749096a60c89b5fe0332956cb6540f
//   dam_dfsph_0005.vtkhdf, scene dam_break: 3146 particles, 500 surface
//     sha256 56b8253714c149e636e251934cf6c33d361856c3a153a54cc27c345ff82aa5d6
//   dam_dfsph_0006.vtkhdf, scene dam_break: 3146 particles, 528 surface
//     sha256 02b95ec3042a30bb3c476a3f3f42cad18781d5e0843f1d6fa9768c66e6784d72
//   dam_dfsph_0007.vtkhdf, scene dam_break: 3146 particles, 482 surface
//     sha256 90b8e0a2519e94312346d3fef45332226701108f81864256abdd4efd9573e9ad
//   dam_dfsph_0008.vtkhdf, scene dam_break: 3146 particles, 435 surface
//     sha256 19c3aa749103f46b9595a184d6d929f216aed064e988f619d5d7e0288a70e4e1
//   double_dam_dfsph_0000.vtkhdf, scene double_dam_break: 3960 particles, 550 surface
//     sha256 0a8746afaf99f8a6a0b6a928e34d731faee60e2af554856d1351c4094e138ec7
//   double_dam_dfsph_0001.vtkhdf, scene double_dam_break: 3960 particles, 552 surface
//     sha256 9f2c97f9909b902e3f168e0a0063753fbea156bc34997ddb1916179b7f16a3c3
//   double_dam_dfsph_0002.vtkhdf, scene double_dam_break: 3960 particles, 566 surface
//     sha256 06409e6feaf8899378fcaf7b4b6a8465ecd119b7f0806f9dbab3df23f81ff5e7
//   double_dam_dfsph_0003.vtkhdf, scene double_dam_break: 3960 particles, 546 surface
//     sha256 98e1b9967ccdaa7b2f88fc6bf720b3f6094a13ca16cb2240acb7e82ac8c377fe
//   double_dam_dfsph_0004.vtkhdf, scene double_dam_break: 3960 particles, 474 surface
//     sha256 cab3b3dcc6eea8307a5088aa051157bd5e982db7c4f4f002373a4600573832a6
//   double_dam_dfsph_0005.vtkhdf, scene double_dam_break: 3960 particles, 572 surface
//     sha256 d21fd15491b9dc719b51681e3d4ba96f8c8c986c17acc3150a8d02e26d54c6df
//   double_dam_dfsph_0006.vtkhdf, scene double_dam_break: 3960 particles, 576 surface
//     sha256 81c586f0903379046ab2ff6119dbb6ea67cf2b8cd653161797af7df071d0437f
//   double_dam_dfsph_0007.vtkhdf, scene double_dam_break: 3960 particles, 659 surface
//     sha256 a7f7ed9446278d6bc9609b5e6b713a4f5e076cb371012379da7d77d0e576f2b4
//   double_dam_dfsph_0008.vtkhdf, scene double_dam_break: 3960 particles, 671 surface
//     sha256 a048fd097edcb01823f93d139e19c62a1ccf08356e138c032655e75ba46dd12c
//   double_dam_dfsph_0009.vtkhdf, scene double_dam_break: 3960 particles, 673 surface
//     sha256 6408090d89b7c5e4f5d8cd67eb85d6ba748a7d92145308f08e79371d6699d583
//   double_dam_dfsph_0010.vtkhdf, scene double_dam_break: 3960 particles, 651 surface
//     sha256 2c4d5fac7b8ee6bdd47fde0a3e7e1a9c2e13633b04248cc4845b362d249ae689
//   double_dam_dfsph_0011.vtkhdf, scene double_dam_break: 3960 particles, 551 surface
//     sha256 55c0b0d96d2e69bd2a49f88ab83afae23313e0d8907f9e318b5c00bd87a719b5
//   double_dam_dfsph_0012.vtkhdf, scene double_dam_break: 3960 particles, 366 surface
//     sha256 05e5c1101522f3f309acb556484937ec5e11045573e60e9853420e65aab2278f
//   droplet_dfsph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 86e0d97d9444c40610a060b00a6035b0f2ea925b5591efe2a0753381d256bd91
//   droplet_dfsph_0001.vtkhdf, scene double_droplet: 3456 particles, 1508 surface
//     sha256 ec972d9b0bc0eecaf92b9fbdcbd89691cd6dae7f4d946728712e2be8e10cb791
//   droplet_dfsph_0002.vtkhdf, scene double_droplet: 3456 particles, 1544 surface
//     sha256 c9d47eb1ff39c3a65f224530224434e1bda74d82ef1f19f77be4b850ff92d41d
//   droplet_dfsph_0003.vtkhdf, scene double_droplet: 3456 particles, 1523 surface
//     sha256 888a8842989e8a1595cbc67c3fb7e306edd84f93ce1d700eee9cf32301ad5dce
//   droplet_dfsph_0004.vtkhdf, scene double_droplet: 3456 particles, 1538 surface
//     sha256 6a368f783bcd285727888551b8853673cf6b3e96de775faa0059c8a613540173
//   droplet_light_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 6e68894fda6ab29eea718905131323ddb168596d322fc814d254968a562739e9
//   droplet_light_0001.vtkhdf, scene double_droplet: 3456 particles, 1607 surface
//     sha256 8f0ff853cd9c437ada8803714d855a2795b3ab5ddce2375c3e00715d5cb9367f
//   droplet_light_0002.vtkhdf, scene double_droplet: 3456 particles, 1623 surface
//     sha256 810f395f8ce5af7a4a8b679af3b63dc473ba6b16388a4d999f8fd854f3648430
//   droplet_light_0003.vtkhdf, scene double_droplet: 3456 particles, 1652 surface
//     sha256 31e5c221ba9fd3cb5de33e68d3aa798de070613956bcd23659a00a3d391c8cf0
//   droplet_light_0004.vtkhdf, scene double_droplet: 3456 particles, 1659 surface
//     sha256 474a833b4e862666f3e509e9359d7ef0d581d8ea3bea87daac54572f9694824b
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 6e912ad6b37670c9fdff4ac994c24afb72dc028e6abc42feb6e9b8550012acb6
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1733 surface
//     sha256 af76e4bfcefc1eae9699bd85962224fef9d081499cce8d969df09dfbb05d4595
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1665 surface
//     sha256 f589351105e0d15fd5f54a21d22d3885b251309dee3c68e87a6a0b7db8eb09fe
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1672 surface
//     sha256 cc756c1d25d9c02ede5577818d11113a152f9ef7de83c5725be3d65bf4495d92
//   obstacle_light_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 352 surface
//     sha256 6a8aba01b5f9856d0b5a3388388aa7c3fde68e1f19975edbb2be9e6c2218fd97
//   obstacle_light_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 360 surface
//     sha256 93b0750f5a12371d4cab682bbcf20b502f50b54f051ccd393fd741542b61aedb
//   obstacle_light_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 361 surface
//     sha256 f4eadf3313589ee7ce5e10e6e7407e2ae6a0f91f3d3132db2dc3fc693b2c7de8
//   obstacle_light_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 552 surface
//     sha256 911e3f512c3fa10ab9f58373b59810fdf45eacd6b41120b956587fb965650b95
//   obstacle_light_0004.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 692 surface
//     sha256 1d5429a4f7eaa901acd4ae42ac0aca29a2387038aaee268f8139f80c44d20876
//   obstacle_light_0005.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 643 surface
//     sha256 56e7c7b6472a96a0cd87df1b8b964532a2af6b8157cc0501e751f268003b0576
//   obstacle_light_0006.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 598 surface
//     sha256 4987b07e2187b9b74f433b6309e708b8dbd411e63179eee89cc056924dca5a5f
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 ffef11dfe75550697d3196fea736374472dd56be54bef38e67c9cf6a40362393
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1536 surface
//     sha256 e0566e27cc442c397435a17e69e56ac36bc20f7f7828f904806f289a5bc987a0
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3906 surface
//     sha256 ba69f9b4447060abf8031bcef9cefa4e93c3e5e735bb8246ea47bcf46df1def4
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 2843 surface
//     sha256 089091d8730924c60e1cccb4b7cf43fa2db504b5a281d9cd52965175f4d25565
#ifndef MENISCUS_COEFFICIENTS_A69D50154127C24F
#define MENISCUS_COEFFICIENTS_A69D50154127C24F

namespace meniscus {

struct Surface3DWide {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 86.28370990950012;
    /// Neighbors, 0.000681 of them for rounding
    static constexpr double d = 24.929690571205086;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// The lines follow support radius over rest spacing; k and d are for this
    static constexpr double reference_spacing_ratio = 2.0;
    /// Share of its volume that a boundary particle counts for; 0: it only covers
    static constexpr double boundary_weight = 0.85;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.02;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 29.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 40.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.4999999999999996;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.6930433625398544;
    /// For the candidates that the first lets through, in other features
    struct SecondLine {
        /// x and y
        static constexpr const char* features[] = {"mass_offset", "direction_eigenvalue"};
        /// Whether surface lies above the line, else below
        static constexpr bool surface_above = false;
        /// Slope
        static constexpr double k = 17.34327779682296;
        /// Constant, 0.000287 of it for rounding
        static constexpr double d = 5.546628749458784;
        static constexpr int dimension = 3;
        /// As of the first
        static constexpr double radius_ratio = 0.8;
    };
};

} // namespace meniscus

#endif
