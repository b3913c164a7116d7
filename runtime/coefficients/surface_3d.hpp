// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 102269 false positives:
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
//   crown_dfsph_0000.vtkhdf, scene crown_splash: 7751 particles, 755 surface
//     sha256 44d1a93bf483d2bc1c9d40688041af439fbece080cefbaed222979d2682fa7d5
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 694 surface
//     sha256 74763727ff2acfd9f0dd19c4c1f6bfb08363ccbcbc52b45257f11a77c6455663
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 771 surface
//     sha256 ba627325f2c16d81c5a462c3f308f7d5bb43ad4f3e3836bea12fa64018efe9c8
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 672 surface
//     sha256 218c6e03810d7355678170b0ccd775c61b181f147fe4631fe98e25dc3068a93c
//   crown_dfsph_0004.vtkhdf, scene crown_splash: 7751 particles, 781 surface
//     sha256 e6c156e6f24988ef8e5a4b86ff91ff8327e11eda566eec70e55245d3155302f4
//   crown_iisph_0000.vtkhdf, scene crown_splash: 7751 particles, 755 surface
//     sha256 7607c3847b31cd90887851a533d245586f353c912e62dfe10a1d1af622b533aa
//   crown_iisph_0001.vtkhdf, scene crown_splash: 7751 particles, 606 surface
//     sha256 aba087c046430a93373e9f816333b848ece439f2f504a354c87a44f9c04101f8
//   crown_iisph_0002.vtkhdf, scene crown_splash: 7751 particles, 784 surface
//     sha256 a39e3d1d3e9862c99d64f57aa887754a99bd2ac43c4c54e959e0e4f173bdb7f2
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 370 surface
//     sha256 b6a498eebe5df59d41f7fd413b514284766e97224f451949456ef73802e76ad4
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 370 surface
//     sha256 b4fce7c2fe53c074428e0fdccdc8bf501f79a7d67d237851c61e9ff960c11f85
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 472 surface
//     sha256 25bd281b32b254fd05a4370822b91cc8b68de6099efe995fb4622fe983a62179
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 588 surface
//     sha256 46b1721cc11aac19e9e73493e300015df6b98fa0ede31dcf4a1e33e189521a9f
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 556 surface
//     sha256 724fce35e2f6de73a951f4c7843358ed5b857d5304be996c5e4c02abcef3afc2
//   dam_wcsph_0000.vtkhdf, scene dam_break: 3146 particles, 370 surface
//     sha256 df40822d2ca7217446bfff0234c0b1c6a7cb5ab2c581d5fa8d5dccc5b55596e5
//   dam_wcsph_0001.vtkhdf, scene dam_break: 3146 particles, 345 surface
//     sha256 02fd977ac138e75a2928bfd9041642431291dd35a2200dda0516e465f8e9ba38
//   dam_wcsph_0002.vtkhdf, scene dam_break: 3146 particles, 448 surface
//     sha256 197fe8f77bd4db30b58527e80ce43304569cc9c1b710998a94054ddd64841982
//   double_dam_pcisph_0000.vtkhdf, scene double_dam_break: 3960 particles, 586 surface
//     sha256 926dbce71db53f6df12c01147202d41206ff0a6b7b88f5f01d01ead95443ed92
//   double_dam_pcisph_0001.vtkhdf, scene double_dam_break: 3960 particles, 430 surface
//     sha256 24959b16cf94161fc1aec4c1c1464a446e286736684c3a91f93700dc528bcb76
//   double_dam_pcisph_0002.vtkhdf, scene double_dam_break: 3960 particles, 737 surface
//     sha256 32e482c822ec0fab604afc15176bbfe329739d4349f23518dd398f9fcc7a410e
//   double_dam_pcisph_0003.vtkhdf, scene double_dam_break: 3960 particles, 495 surface
//     sha256 a6725701316aa0f0585305a3c75d6c342c76536a786f739d47d9562ad11c1c92
//   droplet_iisph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 629a7cc98076523c22aad80940c08456e16e4282f94362a9370932540fe1d5ed
//   droplet_iisph_0001.vtkhdf, scene double_droplet: 3456 particles, 1380 surface
//     sha256 99e26d2a64315e94a4833799f14205eb6db819ba274c738d259a488575493009
//   droplet_iisph_0002.vtkhdf, scene double_droplet: 3456 particles, 1343 surface
//     sha256 69f62a69088d4f2ad6ccee2a45cfa016997539c06572bde2f9bf5fc8cf921229
//   droplet_iisph_0003.vtkhdf, scene double_droplet: 3456 particles, 1324 surface
//     sha256 8a9a58802b9d6d4b2fab0770c3a1671d354b9385923e9a7de653a0677fa53d81
//   droplet_iisph_0004.vtkhdf, scene double_droplet: 3456 particles, 1326 surface
//     sha256 603e15e95d43e01a3438951ee2eea1b5830d1c9ee2611cc01867a594b1c08d7f
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 33893b0c36eea5a403c736e0caa5ebe01d7dd603109fa4e3d5c4b69bd39db87f
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1375 surface
//     sha256 3a0281232cba4af5373a73440003b8e1186bb17ad6bf9cd1253d5a5fae6ec7ce
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 379d6c8a7852f8fe307006bf9e38fc1b10c47ba0db409ee26487a600d896f5c0
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 acf9a950532f4bad179f2177a546ecaef74ed9f8e6f087e6617d1bdf2a325e89
//   glass_dfsph_0000.vtkhdf, scene water_glass: 4608 particles, 1518 surface
//     sha256 c14ce5ff8f75b81bc404903418127d1c25cc3e27e1ccfd893de2b751e5fdd06c
//   glass_dfsph_0001.vtkhdf, scene water_glass: 4608 particles, 766 surface
//     sha256 4480d6b989ce52f56c2f1af11e63a6a552d92b99eced10e4b29481c615e37f0b
//   glass_dfsph_0002.vtkhdf, scene water_glass: 4608 particles, 1605 surface
//     sha256 5292f81e2c30aece81f40c49b4fe866b4c08838e3892e191790eea3bb22f3227
//   glass_dfsph_0003.vtkhdf, scene water_glass: 4608 particles, 2048 surface
//     sha256 6dfd3a32f335e63c07411d0ca2fc3f690f3e3ebf11c78c1213bed263dd3a0fcd
//   glass_dfsph_0004.vtkhdf, scene water_glass: 4608 particles, 2514 surface
//     sha256 4f48bf8883bc031addc7abd0142aeb68965274366162bab6d47c123748e61ebf
//   hole_dfsph_0000.vtkhdf, scene box_with_hole: 3136 particles, 200 surface
//     sha256 aff50c928e67a6cfa63d8c615d52f16b8cfa8bbf3edf2bef453f9870aaaee1da
//   hole_dfsph_0001.vtkhdf, scene box_with_hole: 3136 particles, 455 surface
//     sha256 c6d66368c7f762b4f762753a27cddcff45dcbd94410b9b00430b82f718f21f84
//   hole_dfsph_0002.vtkhdf, scene box_with_hole: 3136 particles, 709 surface
//     sha256 9703ee6dc9e4f894174c552331caee3a5ba06bb413e59c91075e6406e51f071c
//   hole_dfsph_0003.vtkhdf, scene box_with_hole: 3136 particles, 899 surface
//     sha256 19eefac7b4f28a108e06833226daef6ad0dabe3e638446cc6c817652ecd30d9f
//   obstacle_dfsph_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 370 surface
//     sha256 cb457b5a95e2f1526ed400516cbb4430feb599315bb6fa0ad50a37cc8b47bdee
//   obstacle_dfsph_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 349 surface
//     sha256 7b291b1ffc2802271080dcce505b630787b05fe65975bc9d23074b720ae293fa
//   obstacle_dfsph_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 768 surface
//     sha256 dab6a9fc099c86f19c0700f1f08ec010d57fdd5a5f402f6799475ebdc634354b
//   obstacle_dfsph_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 540 surface
//     sha256 c421c6e43e4e6021c0ff268b5fd7aed464b2613eafbd6b0e778a50f9cb24a9a9
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 7d9265c1dd26abbdbeb8cdc46c3b23c685b5f200508fd01150c76fd2b95c42d3
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1532 surface
//     sha256 f2c3af9b2f759c5aef0cb9e39cf331eaf6f8ecd61fe865389793ab01b123e39a
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3371 surface
//     sha256 d4d749c39d335f51a03d5ca32cabacab7da0ba27e9e72bc7f5f197acf70ef867
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 3051 surface
//     sha256 8650e275e603a52457001892e6a82fa1eee6769d761412839ad0d89dce4bee39
//   tank_dfsph_0000.vtkhdf, scene resting_tank: 2560 particles, 252 surface
//     sha256 8ec6eaf6ea9a7aead07aaeb5767762dc153441fc05c8638409b1e029a15a6fd5
//   tank_dfsph_0001.vtkhdf, scene resting_tank: 2560 particles, 268 surface
//     sha256 bc7f0342781e91a2c7c024d0c90444629fea7cbec10e1f6a9e71934ee4177ebe
//   tank_dfsph_0002.vtkhdf, scene resting_tank: 2560 particles, 284 surface
//     sha256 670efdc4b232a1fb649d9cc5104d9aeaae461e69e0c476b73f62fada85c83c51
#ifndef MENISCUS_COEFFICIENTS_D4300B583FBC3D81
#define MENISCUS_COEFFICIENTS_D4300B583FBC3D81

namespace meniscus {

struct Surface3D {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 116.70585542106969;
    /// Neighbors, 0.000834 of them for rounding
    static constexpr double d = 25.969491900681017;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.02;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 24.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 43.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.0;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.0;
};

} // namespace meniscus

#endif
