// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 253507 false positives:
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
//     sha256 207a1b6efabd01495caf67ed9c9aa66003d9016e550f240cfdc48ab3906d1550
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 794 surface
//     sha256 33b1a7dfc02d687524b82f61be49ee0de33cc58804b76359b8798276025ad9c3
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 1091 surface
//     sha256 f089a1b26c4a935c942c11bb08b074c54a0ce2ea23d2bda15592676bbe353996
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 1025 surface
//     sha256 d6eae2ca37df45b657cd73c8080f006e87a9d0a0eb90c3d477815a703f0c4836
//   crown_dfsph_0004.vtkhdf, scene crown_splash: 7751 particles, 1110 surface
//     sha256 04b1a601dc4cf8bc7dfe334e1b33bc51d1254f14c35b0d8e1c4e23ace103b4c9
//   crown_iisph_0000.vtkhdf, scene crown_splash: 7751 particles, 783 surface
//     sha256 99a0e5777acf87ff7ed707c5ecc0929237db72d5246d894913311985a2d8ffad
//   crown_iisph_0001.vtkhdf, scene crown_splash: 7751 particles, 846 surface
//     sha256 a9ffaf57f0698d1deef22759a024eaa32f43dcf1a05e08586e4b30d1bc72e14b
//   crown_iisph_0002.vtkhdf, scene crown_splash: 7751 particles, 1088 surface
//     sha256 119ec09d4e33dfa689800314db134db695f2aab1cbf68430190300b6c3276ff9
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 fd2cfe856f8ecba1645603ec119c1fa6d5a5c068edb053616813ae8ffe997c57
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 455 surface
//     sha256 edcd40649d221d6ceea93d4114e9fadd1e7e40e96553f9a0fae4bc94fa2e77b2
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 702 surface
//     sha256 e9eb206dfc796068199cd9b2d7f0ff1fc142aa7ce9f3d865465a7c5bdc49c458
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 877 surface
//     sha256 41eec4f7d248ca82fcaceb2aed26d0e440298ef950df8d8745c462f17069d425
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 801 surface
//     sha256 79325bdcdb026099e329f0bc36feb871b85a9cbbc1b86ea94df4e38278a2ad46
//   dam_wcsph_0000.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 6d509f916091a4a2f018c432438a9ba74edadb1048d8d3bbfd4c1e28104bfb3d
//   dam_wcsph_0001.vtkhdf, scene dam_break: 3146 particles, 455 surface
//     sha256 ae2e32e727e185c16a9ccddab59ceba1ae467b6a89a45b5013b6f15eafc277c7
//   dam_wcsph_0002.vtkhdf, scene dam_break: 3146 particles, 666 surface
//     sha256 38db5eaa7b107e61f4ceedcb6c4d812f0203222b346a63d3004ef344a001508f
//   double_dam_pcisph_0000.vtkhdf, scene double_dam_break: 3960 particles, 594 surface
//     sha256 39f27254a1d9025a0e7caab8d955357163e9f9352b0660189e1c385e3800cde7
//   double_dam_pcisph_0001.vtkhdf, scene double_dam_break: 3960 particles, 579 surface
//     sha256 0ea68aaa878407453039d87b13a31e34594f02d8ff10a8638fb55ab0ef3fc3b2
//   double_dam_pcisph_0002.vtkhdf, scene double_dam_break: 3960 particles, 925 surface
//     sha256 f51320bda00b165224ce55f92b772b028383dff8e282082b8d9ce3e8bc3ed66e
//   double_dam_pcisph_0003.vtkhdf, scene double_dam_break: 3960 particles, 642 surface
//     sha256 bfdeddf7e1e54ca3e3e946f55d3273ee75cf185d976e321134a2f5e80943057a
//   droplet_iisph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 bd8ca70fae51c376d791d51a9c1d542ff852dc3ef6af58a667d445cf624391ca
//   droplet_iisph_0001.vtkhdf, scene double_droplet: 3456 particles, 1429 surface
//     sha256 30e5733811722602b99c42a7aa048f48b94925d46ec00f92e2831d40f03a59a6
//   droplet_iisph_0002.vtkhdf, scene double_droplet: 3456 particles, 1420 surface
//     sha256 8226d83f12c060084ba848677144795e18ad671fbc1a959cd70af38e46ff9b3b
//   droplet_iisph_0003.vtkhdf, scene double_droplet: 3456 particles, 1362 surface
//     sha256 721e822cc9f2423574fd2148e81343d9b77c83f9c5c761980ed9a7d3ab642ebf
//   droplet_iisph_0004.vtkhdf, scene double_droplet: 3456 particles, 1371 surface
//     sha256 5934234fa469e5785e36d88bd6a3c83e0b8f2365d04d254f61054edfbdf4dc1d
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 abdef04ed937d2ae7ac7831db13921a2040dfef8cf3c008a7d5f49871b8a55d5
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1437 surface
//     sha256 caa597f2b38e635debac1631f57e7613745d2c8adef407d543af234093ce48a6
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1430 surface
//     sha256 ce4d5a97c39783b4f39c1020e59bcb9b2df18de37ad226cd8722b63d7643df2a
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1409 surface
//     sha256 62bbb524d5af6d23b4ffde90122f153d514e3fb2293680ac73051c6a9355bc19
//   glass_dfsph_0000.vtkhdf, scene water_glass: 4620 particles, 1353 surface
//     sha256 90be29ed6e0bc939e5192eb98721c9630e46d3699669b41ee8ef6fb2d748a44b
//   glass_dfsph_0001.vtkhdf, scene water_glass: 4620 particles, 852 surface
//     sha256 4ddd0ee41732de77811605c48b39a761edbe1b17f1d7bd20247cef237bb4e993
//   glass_dfsph_0002.vtkhdf, scene water_glass: 4620 particles, 1974 surface
//     sha256 c1734fe4d9d5ebbc650e26d245f19ae91cf40c541f636b4e2099221d97639386
//   glass_dfsph_0003.vtkhdf, scene water_glass: 4620 particles, 2528 surface
//     sha256 45bbcc66b511adf4ef9dd9cf7abd1fa8361155d932908e40c49ee349076bc446
//   glass_dfsph_0004.vtkhdf, scene water_glass: 4620 particles, 2855 surface
//     sha256 82e7035087f15b1c661c4dc5d490066c07d922c16d71f22bed53244a338e1aa9
//   hole_dfsph_0000.vtkhdf, scene box_with_hole: 3136 particles, 268 surface
//     sha256 8c987dd10dee4d6997788005447bdf6a5aab9451694b943aac20f6b33257bd0f
//   hole_dfsph_0001.vtkhdf, scene box_with_hole: 3136 particles, 697 surface
//     sha256 5e43f2180701f127e6ed115e5bf7eb928e778e20564e4976cc79889d4d40f336
//   hole_dfsph_0002.vtkhdf, scene box_with_hole: 3136 particles, 935 surface
//     sha256 de9598d890d68e6b0a87a35270c4ca501de12c4727ad9751c54132eb1c0fab5d
//   hole_dfsph_0003.vtkhdf, scene box_with_hole: 3136 particles, 1133 surface
//     sha256 6c7cd7238c71da846354cc5d2bb054dae2de2d076fc1124e57059b5373961575
//   obstacle_dfsph_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 374 surface
//     sha256 20af2d1c3e93fa893d3b508f32c3a1b23afba2f0495ade429d63c2139a60818e
//   obstacle_dfsph_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 496 surface
//     sha256 501133db2779eeb06bb4457e92c6b2cc5b51a5f9049d1cac6afb5a7c0ac8b537
//   obstacle_dfsph_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 1100 surface
//     sha256 b623df8a81948c489a853a483764f999eec7604b1437f71ac57c9f50ed76eba3
//   obstacle_dfsph_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 927 surface
//     sha256 e8f81401a08617b1c734cb5fdfc1ac404e7143683f6dd722a75b1f860b0c6375
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 0a66e2f546cb5747b1a1819b2cab2e665f5f1f269e9c80bfa4f324aa78e11110
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1537 surface
//     sha256 a6ed2ae3b409b6a8e6e2cba8b78f032a1035342e3a43bd3d085ccc3bb4d24533
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 4146 surface
//     sha256 a414147fbf0afc37d97208d505315ea66b6e45096b39b03a473b74da029719d2
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 3651 surface
//     sha256 2e722e18d27397d45a354deb7f68be6239e3c3829cf7d8c11a162e3697fd0539
//   tank_dfsph_0000.vtkhdf, scene resting_tank: 2560 particles, 256 surface
//     sha256 f69964abcbaaad38e2347280cfd0ea10d4554a6198a46e57671649f37d49c6b3
//   tank_dfsph_0001.vtkhdf, scene resting_tank: 2560 particles, 320 surface
//     sha256 9246caf1f062dfe3e748406641e5cd0127b2c955ac1d32a4be56c871ef65724a
//   tank_dfsph_0002.vtkhdf, scene resting_tank: 2560 particles, 452 surface
//     sha256 fa5905c13c0b8d11fdc98add7d3e81b5c377f620ccd780a816c5308050fda6d4
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_0E13A1B34A408E2E
#define MENISCUS_COEFFICIENTS_0E13A1B34A408E2E

namespace meniscus {

struct StrictSurfaceCoefficients {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 515.8884943460284;
    /// Neighbors, 0.00283 of them for rounding
    static constexpr double d = 25.959199637159664;
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
