// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 257861 false positives:
//   boxhole_dfsph_04.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 2671 surface
//     sha256 88dad6a2af49e72ca7b4a6ab92831d6a66efd884485edfe3322910c674875a81
//   boxhole_dfsph_18.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 3243 surface
//     sha256 306532064595c3beb4d1634d9f3e5a2229454572ec012f74d9bf63e5868fa8cc
//   crown_dfsph_02.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 9636 surface
//     sha256 fa7f0ed4a821854251fa84485dd2bc11dfcb1508cb32148c736a950f01e0cb6e
//   crown_dfsph_15.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 11198 surface
//     sha256 3bc29c1fcb7e5667d94e22c8e3a510afcdaccb206bc9a240b1ac7e2330d885e7
//   cube_iisph_05.vtkhdf, scene SurfaceTension_NoGravCube_ZR2020: 10648 particles, 2705 surface
//     sha256 3a243a39a6f4e56c648eb2cad97322a730479f9df7f337ce8af18b9d2043fe22
//   dam_dfsph_01.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5136 surface
//     sha256 4061a239939c323ee1040045fab3c96c5ea9e401c9dc4e906aab7d8e2aba06b7
//   dam_dfsph_04.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5118 surface
//     sha256 80c7a2cf5d45f32e03844c8f897968c7644d4d95d3d1bbde5d0cec7726c18647
//   dam_dfsph_08.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 6691 surface
//     sha256 93ba9c4713188a47e717efd3aacc9fb24abd81f3e66bd681a1c885294a2d4ab9
//   dam_dfsph_14.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 7069 surface
//     sha256 6b491735932c687ea48707864705f2d681d977a934cacdad6812ac7a97964769
//   droplet_iisph_01.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 de464399e1c0197987b1ecd2f27b80e8bbf3df6d1d94d82a590c0c437214b162
//   droplet_iisph_04.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 26c39b74b27b63f97406234ca4c579dc7233c49212552dbdc1d46489b2261bb3
//   droplet_iisph_06.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 5e763d0820557e2efebffd21ee496f8b847b0972db99500d6fbbf39ef65cc731
//   droplet_iisph_14.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2650 surface
//     sha256 fd6704ffb9c62ed88017e2355c83a1df564b9cf4fdd979a5fa4941b66378b24f
//   snake_dfsph_05.vtkhdf, scene SurfaceTension_SnakeTestZR2020: 6076 particles, 3026 surface
//     sha256 e32353f47ae34a2b368ffc384421b35e3c9cd44bfe8e1ab5bbf7e037c39b0279
//   crown_dfsph_0000.vtkhdf, scene crown_splash: 7751 particles, 783 surface
//     sha256 44d1a93bf483d2bc1c9d40688041af439fbece080cefbaed222979d2682fa7d5
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 794 surface
//     sha256 3330ec23d91cf42fd9f8489e2cb42161b5df95354fce4612c67a1b8065a47e33
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 1099 surface
//     sha256 ffa4581154f038b351dd38987a643c1618b355a7254170191308c0f08c51794d
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 1028 surface
//     sha256 e9bf9a073cf15b2fe18e6f854bc0e8220527e49bd85b087b6966ff865cacae0f
//   crown_dfsph_0004.vtkhdf, scene crown_splash: 7751 particles, 1118 surface
//     sha256 9b0f21cfbd4775fe5e513b33f6d08741bf85ebd30cae71e2a8c1e1f374ade806
//   crown_iisph_0000.vtkhdf, scene crown_splash: 7751 particles, 783 surface
//     sha256 7607c3847b31cd90887851a533d245586f353c912e62dfe10a1d1af622b533aa
//   crown_iisph_0001.vtkhdf, scene crown_splash: 7751 particles, 846 surface
//     sha256 da9c72f31206f60996ce5d609fec36afdc799f7626aa4da14d73d8d7ec307318
//   crown_iisph_0002.vtkhdf, scene crown_splash: 7751 particles, 1087 surface
//     sha256 baca102901ecd19a6d98629b063439819e58263349387a8ac6e041f5704c1039
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 b6a498eebe5df59d41f7fd413b514284766e97224f451949456ef73802e76ad4
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 455 surface
//     sha256 cda0e82ef58bbe1c59041196855ef088940a48bc786fb145b894088c73a1118e
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 694 surface
//     sha256 f0aa42b094d03302d275f5f518a13632fe6d9ccfb0c5caade9b6c4b7d8019420
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 862 surface
//     sha256 df96f9bd8eabef3fce703e67164a1f653fec292ac782dc54dd9cc68aa1200080
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 829 surface
//     sha256 039d753eec84a6b254e2c5c04e7ccede589c758a113475c9eb51acc2d7dd1f82
//   dam_wcsph_0000.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 df40822d2ca7217446bfff0234c0b1c6a7cb5ab2c581d5fa8d5dccc5b55596e5
//   dam_wcsph_0001.vtkhdf, scene dam_break: 3146 particles, 459 surface
//     sha256 fbf81097dba054fea7f17f202a7192494229a31208ad0c86a2e284df98a2e5ef
//   dam_wcsph_0002.vtkhdf, scene dam_break: 3146 particles, 652 surface
//     sha256 9a02f33b884379cdfc03dd771150254895f65d9a136963a135dc686a805b0e4d
//   double_dam_pcisph_0000.vtkhdf, scene double_dam_break: 3960 particles, 594 surface
//     sha256 926dbce71db53f6df12c01147202d41206ff0a6b7b88f5f01d01ead95443ed92
//   double_dam_pcisph_0001.vtkhdf, scene double_dam_break: 3960 particles, 580 surface
//     sha256 1c2b0b6987ebd54b9b3d45f629a660cf406760921d1f8cca5ed372e8e4c03314
//   double_dam_pcisph_0002.vtkhdf, scene double_dam_break: 3960 particles, 924 surface
//     sha256 f12428c9e1ba608be634d08ff8312460d59ce405e31458ba616f64997df679cb
//   double_dam_pcisph_0003.vtkhdf, scene double_dam_break: 3960 particles, 662 surface
//     sha256 57d3a03e45d148bb8addfa2c0c0f3b408fcd9d2045b0a0e554216fcea38af0c8
//   droplet_iisph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 629a7cc98076523c22aad80940c08456e16e4282f94362a9370932540fe1d5ed
//   droplet_iisph_0001.vtkhdf, scene double_droplet: 3456 particles, 1429 surface
//     sha256 57de24777b5043f50606221984a80039d0cffdf02e24932e5a50f56e8d142447
//   droplet_iisph_0002.vtkhdf, scene double_droplet: 3456 particles, 1420 surface
//     sha256 d2e898bb24ba542096eed0bd8e30e0edb09affc2b579f28ee6d15c933b180916
//   droplet_iisph_0003.vtkhdf, scene double_droplet: 3456 particles, 1362 surface
//     sha256 7a375fa021677325dc94be9e5ffa9313416f34da378d22726869a775e703fcca
//   droplet_iisph_0004.vtkhdf, scene double_droplet: 3456 particles, 1371 surface
//     sha256 0067be22b70fffd3c9fb8bedaa923cd6d8879083459989d571f364a36c27e442
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 33893b0c36eea5a403c736e0caa5ebe01d7dd603109fa4e3d5c4b69bd39db87f
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1437 surface
//     sha256 8b63497b55b1c47ce9549a7626cc5dc5dceb43c2e7b0dbe09878b26653000c36
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1430 surface
//     sha256 d00695a8a92a73fd96cdedaf8a95f21a350cde68f66ef4a487862a5ca9a7afa8
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1409 surface
//     sha256 ba900628c234d56a0e0ec04bf3a0fd5f8e48e1a234757d949614753038065620
//   glass_dfsph_0000.vtkhdf, scene water_glass: 4608 particles, 1542 surface
//     sha256 c14ce5ff8f75b81bc404903418127d1c25cc3e27e1ccfd893de2b751e5fdd06c
//   glass_dfsph_0001.vtkhdf, scene water_glass: 4608 particles, 960 surface
//     sha256 0679ef7f2ac2534a5c033a2ec062face8cb57f7b788f0f56abce61ef51cf8f0a
//   glass_dfsph_0002.vtkhdf, scene water_glass: 4608 particles, 1822 surface
//     sha256 354ca7370565e6a9efb88cb87aa847e2d0f7ccf171291819772ece4f4bb434ea
//   glass_dfsph_0003.vtkhdf, scene water_glass: 4608 particles, 2393 surface
//     sha256 8fe3c1ed6ecbe63022d6e728ceaba66fbf6e3d0f653f6a3d86e48b3d902babb5
//   glass_dfsph_0004.vtkhdf, scene water_glass: 4608 particles, 2972 surface
//     sha256 c9148e8467fd0cbd7c9a8339ce3963c8b8f43676241244093a012ca4eb051397
//   hole_dfsph_0000.vtkhdf, scene box_with_hole: 3136 particles, 268 surface
//     sha256 aff50c928e67a6cfa63d8c615d52f16b8cfa8bbf3edf2bef453f9870aaaee1da
//   hole_dfsph_0001.vtkhdf, scene box_with_hole: 3136 particles, 636 surface
//     sha256 b9ad25f0c1e21ee36b1c556b84ebf0ecef5614e6f4f246139093e3daef40e957
//   hole_dfsph_0002.vtkhdf, scene box_with_hole: 3136 particles, 884 surface
//     sha256 6ff345455887f330d06bacdd9e7ee30070ebf8cfc189c92951264a9226eba4eb
//   hole_dfsph_0003.vtkhdf, scene box_with_hole: 3136 particles, 1016 surface
//     sha256 dafc3c94adb3547d0616520a15c94b88599460dcfca87c9cb1f168480cd7eb45
//   obstacle_dfsph_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 374 surface
//     sha256 cb457b5a95e2f1526ed400516cbb4430feb599315bb6fa0ad50a37cc8b47bdee
//   obstacle_dfsph_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 497 surface
//     sha256 07707215305915a16b146f24642a235ec2482be1927dd9ebd6aca0f641e31748
//   obstacle_dfsph_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 1114 surface
//     sha256 59a76fd2a871ffea6c17d2a4aa8ac9fabaa76ba9536bf0c91cb29986a74a001a
//   obstacle_dfsph_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 928 surface
//     sha256 8b1837f9ba492c3d361447118d71f86f4f316a50748cac5234316dbf4abd7e1a
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 7d9265c1dd26abbdbeb8cdc46c3b23c685b5f200508fd01150c76fd2b95c42d3
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1533 surface
//     sha256 bd79c9739cc4c35f8534798aa66277e62b2fd5fe2174d172608cf2c38c4c9423
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 4108 surface
//     sha256 062e7856a66b2d6e0722cc81aea78f391b44af3fe38342f75e4287f0be17bcc7
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 3595 surface
//     sha256 9e510582c077d474a7e5fef998687d13fd0256325dce667bc43dfe380bd46d3d
//   tank_dfsph_0000.vtkhdf, scene resting_tank: 2560 particles, 256 surface
//     sha256 8ec6eaf6ea9a7aead07aaeb5767762dc153441fc05c8638409b1e029a15a6fd5
//   tank_dfsph_0001.vtkhdf, scene resting_tank: 2560 particles, 320 surface
//     sha256 bc7f0342781e91a2c7c024d0c90444629fea7cbec10e1f6a9e71934ee4177ebe
//   tank_dfsph_0002.vtkhdf, scene resting_tank: 2560 particles, 460 surface
//     sha256 670efdc4b232a1fb649d9cc5104d9aeaae461e69e0c476b73f62fada85c83c51
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_7CFE603A35C590A5
#define MENISCUS_COEFFICIENTS_7CFE603A35C590A5

namespace meniscus {

struct StrictSurfaceCoefficients {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 537.4402441617895;
    /// Neighbors, 0.00294 of them for rounding
    static constexpr double d = 25.966086598510927;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
    /// Least typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_min = 24.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_max = 43.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double spacing_ratio_min = 2.0;
    /// Largest support radius over particle spacing seen in training
    static constexpr double spacing_ratio_max = 2.0;
};

} // namespace meniscus

#endif
