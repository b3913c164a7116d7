// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles count by 0.85 of their volume.
// On its training files it has 0 false negatives and 305964 false positives:
//   boxhole_dfsph_04.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 2671 surface
//     sha256 9223d9b6879fb64b01a58d202f63650d3002a179736c1c806d30d5dffe404e82
//   boxhole_dfsph_18.vtkhdf, scene SurfaceTension_BoxHole_ZR2020: 11616 particles, 3243 surface
//     sha256 d3cf6a3893e5db3dd34b0ed089dcbf7d717b33ac80e1e6cc0d0d1d8cc1481a7e
//   crown_dfsph_02.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 9636 surface
//     sha256 c13d9bec4f000c7b1691de697db5a62e58bf1e71e8d3bd6775f8bde62aeafefd
//   crown_dfsph_15.vtkhdf, scene SurfaceTension_Crown_ZR2020: 61992 particles, 11198 surface
//     sha256 7e4fd4c6144a69913bfe4d1a160917f5b87d09e0b15e2b3f951eafe737072bd7
//   cube_iisph_05.vtkhdf, scene SurfaceTension_NoGravCube_ZR2020: 10648 particles, 2705 surface
//     sha256 689132613d4f93737dde6edc1c022f6b6f0d59189ca1f36113d492450d4dc78a
//   dam_dfsph_01.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5136 surface
//     sha256 eaba35e7d2f72b1cf7997b9b807fdc6bcd5b817b3faa0a51a4f1449c68fc8871
//   dam_dfsph_04.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 5118 surface
//     sha256 92acc3d0b7ac231e8f033a0512a0e0c32693fdaf0f6769384ca9f29935bcd8b2
//   dam_dfsph_08.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 6691 surface
//     sha256 0a3a7d1633f3a70e8f9179e6c94cd7e1fbb36e968cb315996d50b008c9df3d8e
//   dam_dfsph_14.vtkhdf, scene SurfaceTension_BreakDamZR2020: 26136 particles, 7069 surface
//     sha256 8e120b98af1177e263dc9fc46de6be6532cffafb79b4fff190ea8f6992407050
//   droplet_iisph_01.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 9b287953d1d2b0b9312180a1783cf9ce873f685644ce28c2dbd56e5ce911348e
//   droplet_iisph_04.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 245eeb77428c47bb99ea0708f7f769f62198128ff47b0d8cd7ff0b32cddcb49a
//   droplet_iisph_06.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2704 surface
//     sha256 4323e737ff216d95caff5c6f5ae96936bfa387a1ab0421837430f512aa601055
//   droplet_iisph_14.vtkhdf, scene SurfaceTension_DoubleDroplet_ZR2020: 8192 particles, 2650 surface
//     sha256 7c9dd061470dddd6f6ef402ee4c7b83653930d4380f283f0cb5df6d56affe4ce
//   snake_dfsph_05.vtkhdf, scene SurfaceTension_SnakeTestZR2020: 6076 particles, 3026 surface
//     sha256 db979c306b7bb52894932f3580d14095de95b26ba2c097006d5d93774b557fdf
//   crown_dfsph_0000.vtkhdf, scene crown_splash: 7751 particles, 783 surface
//     sha256 09d83cfc939b7e2357aed17e9735aa9e828dfbc4aa905e26909beb659f0b090e
//   crown_dfsph_0001.vtkhdf, scene crown_splash: 7751 particles, 721 surface
//     sha256 3677b231b420f80c60c02f90327cca72019b031cc34acab15fdcd6a3900a6cd5
//   crown_dfsph_0002.vtkhdf, scene crown_splash: 7751 particles, 794 surface
//     sha256 f5c00bc44c850c6eb12b1ea3730302136fd82707bf5b95cf2ca7bac5c1bae52a
//   crown_dfsph_0003.vtkhdf, scene crown_splash: 7751 particles, 926 surface
//     sha256 8ba5d0bb105235c1b84bb18df5eba9b692c3d93b887c2423709c8458bac32ef6
//   crown_dfsph_0004.vtkhdf, scene crown_splash: 7751 particles, 1114 surface
//     sha256 70bc9c77f394e6fbcefa00dda1e0b15fa9a33b6185058c42d8e3f7e62f241896
//   crown_dfsph_0005.vtkhdf, scene crown_splash: 7751 particles, 1020 surface
//     sha256 1fe95bfdb550445fc2836c67c7f18dae903364792c61cceca2a3a58cc8b0a978
//   crown_dfsph_0006.vtkhdf, scene crown_splash: 7751 particles, 1038 surface
//     sha256 c7e7bfa83e86dd4e468e289fd1c698e97c9da619254a093d072cdd169f508463
//   crown_dfsph_0007.vtkhdf, scene crown_splash: 7751 particles, 1090 surface
//     sha256 e7aa40b7f266a035191b1a60bb6b9a3e86087b0fe73db89285132ff4c4a917fd
//   crown_dfsph_0008.vtkhdf, scene crown_splash: 7751 particles, 1100 surface
//     sha256 af2a01679519e2a7243991509f13882b10ad336675c302f34902e5ded6e38cc8
//   crown_iisph_0000.vtkhdf, scene crown_splash: 7751 particles, 783 surface
//     sha256 457f35f7a16a809515cf9d0f87e2ca48a9eda3ec7552c3a7357bec31744730a6
//   crown_iisph_0001.vtkhdf, scene crown_splash: 7751 particles, 838 surface
//     sha256 e8176fca1f7a5083402a12f9c2df3d1e273e40ac80dba82f6b0a37802874efe0
//   crown_iisph_0002.vtkhdf, scene crown_splash: 7751 particles, 1094 surface
//     sha256 86cb654a5fe21c59fcf0daee8705ca819b5e9efd7745be95e61bc7a233fc1ecc
//   dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 87f3afc819f58b2bee792a1a01ab9862ea9e3e74d9ce63d45f8bbb95d4603a9d
//   dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 378 surface
//     sha256 db39562c9fa683939549b06f82b3c948e00f2f4316ba96452e20c147364cb5e8
//   dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 451 surface
//     sha256 12ceb0ec16ea62aa6aabd5e4a38d89c941a4c45bf443b35c2be4c52b954c24d7
//   dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 504 surface
//     sha256 adf4e6063c9be5fdebd19d21c4ecd5a3804a86fa11ed277aca47f0773ea66b98
//   dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 733 surface
//     sha256 c47093acf47413e2b755d6bc4b600b58892216408d4729581699dcbfd81c88ae
//   dam_dfsph_0005.vtkhdf, scene dam_break: 3146 particles, 805 surface
//     sha256 215775128561522761a08056fcc4f3bccda8604e5d4f01475e81dd132c19ae53
//   dam_dfsph_0006.vtkhdf, scene dam_break: 3146 particles, 854 surface
//     sha256 741be6e7ab3228cc691ddcb758b5333fb8e3c09757bfac44fc24dee123726999
//   dam_dfsph_0007.vtkhdf, scene dam_break: 3146 particles, 846 surface
//     sha256 99e32740a86c8afa50ec652fded92d6d7968c3368ebfca2d3ff07225e0c952a4
//   dam_dfsph_0008.vtkhdf, scene dam_break: 3146 particles, 813 surface
//     sha256 9301194852d81c2c8f849b713b118b68d5afc9060d66532b5b069e8a0317144b
//   dam_iisph_0000.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 029d00a2d5ad77e92a070bd8db3cf8c7910ff6628550276fe7855375686f59ef
//   dam_iisph_0001.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 ccf114ce5872ec1b21e23fbeafa3e049a95077d847edba64f193797579e050f4
//   dam_iisph_0002.vtkhdf, scene dam_break: 3146 particles, 394 surface
//     sha256 4d04851b2b7123c1333f4149f7fab87b5db49fdc90ff35344f7bee030f17f700
//   dam_iisph_0003.vtkhdf, scene dam_break: 3146 particles, 406 surface
//     sha256 bf2527b51246aa7e365015e457a790e69782a025ecc992e2f7cbe7aa8ba0c148
//   dam_iisph_0004.vtkhdf, scene dam_break: 3146 particles, 371 surface
//     sha256 946bb88c3e768dc9fef98446ab31a30f3ad82b61591e760fb7e99b13af6f9a48
//   dam_iisph_0005.vtkhdf, scene dam_break: 3146 particles, 459 surface
//     sha256 782d81f2975792b3f53d5272b6a05035915386789080a931b4e207920cbbf928
//   dam_iisph_0006.vtkhdf, scene dam_break: 3146 particles, 549 surface
//     sha256 78b4501d86c03be4364193c4b4aee21fa2c9d37871e8fe021f82b58dc124472d
//   dam_iisph_0007.vtkhdf, scene dam_break: 3146 particles, 587 surface
//     sha256 fa9d5fe3c5cf7ac1a3d311438ba28e6d683b12e9c697dcdb026b6ff74a1de12e
//   dam_iisph_0008.vtkhdf, scene dam_break: 3146 particles, 612 surface
//     sha256 ac9bbba3dd45b2a4e08f712389e7b295f8fc0d6670be48da01d1fce27d79ab56
//   dam_iisph_0009.vtkhdf, scene dam_break: 3146 particles, 651 surface
//     sha256 c2fc7467e7863089b8abea76118e9417f18b5dc2e4c599c70d00c58626be887e
//   dam_iisph_0010.vtkhdf, scene dam_break: 3146 particles, 678 surface
//     sha256 35326f33fe4a3c0db23edf2843678288ab4aed6a0f6c6d9268fa312b0afed8f6
//   dam_iisph_0011.vtkhdf, scene dam_break: 3146 particles, 641 surface
//     sha256 6da8231e029341b823d812ba6404e4ff9bfd92ac5837b5d834c9ae81722a2cd8
//   dam_iisph_0012.vtkhdf, scene dam_break: 3146 particles, 596 surface
//     sha256 ec982d70ae1791a8f227cead967fd349add98c1b973a5dd964f9ec7e40917d77
//   dam_wcsph_0000.vtkhdf, scene dam_break: 3146 particles, 374 surface
//     sha256 0c53074ada3fb5cf89b8dd1aecc30eb6150f81aaa42cc4e7d050e01bd51d61c9
//   dam_wcsph_0001.vtkhdf, scene dam_break: 3146 particles, 451 surface
//     sha256 12bbab60252fe139cc372f8980da0d387bee93cf2d249dbfd9df66574f1ee36f
//   dam_wcsph_0002.vtkhdf, scene dam_break: 3146 particles, 646 surface
//     sha256 27b276eaf78433f73cb41dfbb5ba5118b9f9a65ce513044175d7dce25493c898
//   double_dam_dfsph_0000.vtkhdf, scene double_dam_break: 3960 particles, 594 surface
//     sha256 f294069c6f0fd002264a18f719a968881af1f016adfc79e22fe9a2a1a3f0f8ce
//   double_dam_dfsph_0001.vtkhdf, scene double_dam_break: 3960 particles, 594 surface
//     sha256 a610bbf69e8b47c39a6503490ab1277bf765c52ac85506145dbc6cb9d7cd8b54
//   double_dam_dfsph_0002.vtkhdf, scene double_dam_break: 3960 particles, 618 surface
//     sha256 067296a7967432b68d48491358862869e023e4db2cefdebdf8fe54f43c327013
//   double_dam_dfsph_0003.vtkhdf, scene double_dam_break: 3960 particles, 568 surface
//     sha256 1f72ffa796b91bed4f286ee2636a8b8c46a58fb9b9079f2cf3886c6da35554ba
//   double_dam_dfsph_0004.vtkhdf, scene double_dam_break: 3960 particles, 562 surface
//     sha256 559108714bc3c18d47336a8f103565e76468d9052224a4035b557cf665f18fb8
//   double_dam_dfsph_0005.vtkhdf, scene double_dam_break: 3960 particles, 717 surface
//     sha256 290cf05085548e8d1e7f42a6230d1c800cb9a9132cfbf0ade82d1268bfe0170b
//   double_dam_dfsph_0006.vtkhdf, scene double_dam_break: 3960 particles, 782 surface
//     sha256 6ffeffad6d254814d0f5a0ece3b20a3975b1e78cf2ef72f9adee24afb58ac089
//   double_dam_dfsph_0007.vtkhdf, scene double_dam_break: 3960 particles, 869 surface
//     sha256 b16f0d4d9c8841188bc4a385bee71923d443d8033205624cfa347099ee1881ec
//   double_dam_dfsph_0008.vtkhdf, scene double_dam_break: 3960 particles, 918 surface
//     sha256 e435db100bc6df2d37403e04f5a04eaf0604428d190a2653803c392af4727c77
//   double_dam_dfsph_0009.vtkhdf, scene double_dam_break: 3960 particles, 906 surface
//     sha256 20f61f72bb94f302e7997b987ff6f68bf343ae1846aeb81d57abc1fe5fbf99b0
//   double_dam_dfsph_0010.vtkhdf, scene double_dam_break: 3960 particles, 898 surface
//     sha256 3045ec698517b2648e13ef9ad56cf897940be367ef05dc7f74b9e352f1309032
//   double_dam_dfsph_0011.vtkhdf, scene double_dam_break: 3960 particles, 776 surface
//     sha256 50b124aca3ed8a8590e096dcbb4b43a8477cb4dae06e4bd67cd03a8fe0a0f353
//   double_dam_dfsph_0012.vtkhdf, scene double_dam_break: 3960 particles, 658 surface
//     sha256 75c2c064e774f672df4fc2817dfcdd247f12efccf0700922d5d30d7f1a5bdca0
//   double_dam_pcisph_0000.vtkhdf, scene double_dam_break: 3960 particles, 594 surface
//     sha256 35b724da1eeb6a5a8fa00ce8b462c7e5d52b1056d96880faf3284c33c83c1b8c
//   double_dam_pcisph_0001.vtkhdf, scene double_dam_break: 3960 particles, 618 surface
//     sha256 705ef01861edf3c39a0896b4d360f31585c00a93c94b4c86ac982e1379a66f05
//   double_dam_pcisph_0002.vtkhdf, scene double_dam_break: 3960 particles, 564 surface
//     sha256 53184173544ac542bfc8b934f90138fdcfbc538d9b75c3cfc1224c2d0c865fc5
//   double_dam_pcisph_0003.vtkhdf, scene double_dam_break: 3960 particles, 823 surface
//     sha256 121cd7615cc4b9b7f815e46c74aa2804a3d1c6ed334c67790c5fdb74292b2d4f
//   double_dam_pcisph_0004.vtkhdf, scene double_dam_break: 3960 particles, 906 surface
//     sha256 bb9f982a024e73174a99d7f07170b2597b5472befedd7f02d9e459e4629f22f8
//   double_dam_pcisph_0005.vtkhdf, scene double_dam_break: 3960 particles, 879 surface
//     sha256 84a091e8e492109dc7a31ed9527da632053fd8167e5f22985ff29dd6b7aad5f9
//   double_dam_pcisph_0006.vtkhdf, scene double_dam_break: 3960 particles, 658 surface
//     sha256 46264a50fbaf3afa91add6a86a01307ff461acec157919d445d94a6c899ad156
//   droplet_iisph_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 3879c1114f870ab3169bc3824bb02a8627a6150e1b7167c919c5af5f17e7811d
//   droplet_iisph_0001.vtkhdf, scene double_droplet: 3456 particles, 1387 surface
//     sha256 c5d68d55bbb5c05beeda2dbbf12a828c21c04f8b4abde65f2fddeba04669f721
//   droplet_iisph_0002.vtkhdf, scene double_droplet: 3456 particles, 1373 surface
//     sha256 87d4c8395e02af478dda406ceb4a6386065c1adab17be1827431eb48fd895cb8
//   droplet_iisph_0003.vtkhdf, scene double_droplet: 3456 particles, 1334 surface
//     sha256 f21f2242f26bdd07529e09732c1f928cd0f4c8442a2ac83db9dc142627aa9a9f
//   droplet_iisph_0004.vtkhdf, scene double_droplet: 3456 particles, 1327 surface
//     sha256 c1913c12631848d121711e9cac4b5624c166fa4b9538530b00cd831015202468
//   formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 e15cfa1de14ecacf9966569771470e4818bda885026bf4115b3b3b1af54fc084
//   formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1380 surface
//     sha256 01590b5112e832dd7cd5db2231bfd3fe25da31e0b93139fc4c808c2aea3e8b0a
//   formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 c41d3424e46f57e5cc9cbde538abe745517aa8f1e2a64e438f348bdf432b6e3e
//   formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 80e54d4eb694c56bdc91f5c2f682191342899956aba770946bb7a5759458d195
//   glass_dfsph_0000.vtkhdf, scene water_glass: 4608 particles, 1542 surface
//     sha256 63cef591cfbfed7dd789ecef7ceb01629dc347f1e421c955c6da05208bee1a7e
//   glass_dfsph_0001.vtkhdf, scene water_glass: 4608 particles, 1088 surface
//     sha256 ebf6923699a661e57d09b7f5c0188f6a09e3e74c778b885349a7020a76522fd5
//   glass_dfsph_0002.vtkhdf, scene water_glass: 4608 particles, 941 surface
//     sha256 0dec110912cb29653aef180111d350c35b297c0eeb757bc31098d7b121c66dd6
//   glass_dfsph_0003.vtkhdf, scene water_glass: 4608 particles, 1476 surface
//     sha256 8a150c35e3da897dec503422e0e137bdfc1c47efff48c2fb636c53f414520dd5
//   glass_dfsph_0004.vtkhdf, scene water_glass: 4608 particles, 1818 surface
//     sha256 5c89d36e95c3c6e7ab91b45dfdb070139f0c7e9fd6eb5e6c450f866645e77396
//   glass_dfsph_0005.vtkhdf, scene water_glass: 4608 particles, 2146 surface
//     sha256 18bccf2150bc0c90a3ef1458e8bbc3ecaeb0bf7f6dbfea6accd863965ec41609
//   glass_dfsph_0006.vtkhdf, scene water_glass: 4608 particles, 2397 surface
//     sha256 22bc789c9fea14983970bf36fd91762a711624418fe26c69c33bf251fbbb8af2
//   glass_dfsph_0007.vtkhdf, scene water_glass: 4608 particles, 2695 surface
//     sha256 30b649a3fd46e7a076730b81936eaa52447bfe6666e4459cd4d00a7157b2bd54
//   glass_dfsph_0008.vtkhdf, scene water_glass: 4608 particles, 2962 surface
//     sha256 d21152d01616aa513dcef3738556037f7ebe777d226388429fcfad36efc077ae
//   glass_dfsph_0009.vtkhdf, scene water_glass: 4608 particles, 3163 surface
//     sha256 223b439c2f5d55c4b33fa5e9eb18a7bffd6ee9d4b9ecb8dacb640ac784ad73e6
//   glass_dfsph_0010.vtkhdf, scene water_glass: 4608 particles, 3217 surface
//     sha256 79a7dbe51444e4ab477da6d333d5f1a2e7b5aec2f7e8ef237894533ad156e5b7
//   hole_dfsph_0000.vtkhdf, scene box_with_hole: 3136 particles, 268 surface
//     sha256 44a347d851d74cf5009a1bdb1991656df1da9a1945b429309bbc5823e46adb52
//   hole_dfsph_0001.vtkhdf, scene box_with_hole: 3136 particles, 635 surface
//     sha256 4b715154ddf9eb0dc32cb6802448ca7beddbc317bbc68c064e5a9b036bfc75f2
//   hole_dfsph_0002.vtkhdf, scene box_with_hole: 3136 particles, 876 surface
//     sha256 ccfc3eb0ff694fe2d8ea51486dd276600314a66a945a703187accbb3ccd2fe67
//   hole_dfsph_0003.vtkhdf, scene box_with_hole: 3136 particles, 1031 surface
//     sha256 46e11a932edcbacdb1a615190199dfae0eb1ffed9379dd3e7f7361c59da4533d
//   obstacle_dfsph_0000.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 374 surface
//     sha256 92b00366315b19cbdc9a4a83bc68ede0c9c779bad40c34cead88f55de3de2ddd
//   obstacle_dfsph_0001.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 378 surface
//     sha256 038b84b0a13358a590cb0ddb6b6733eaa4d9bfcee5c3b0660e05db56b0d13b81
//   obstacle_dfsph_0002.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 491 surface
//     sha256 cfbb879287bb468f52805acaba6fe2bff533595f1e3f332db58e82c44fb42c34
//   obstacle_dfsph_0003.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 862 surface
//     sha256 4be719c8db8e4f3d49c72d9c4a84594ba9a0da324c7576da1d57285215fb1824
//   obstacle_dfsph_0004.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 1083 surface
//     sha256 6645a0d4e372dd6e09f1fa9fd53fdc6c02aa7f31a5b369b028deceef331500d4
//   obstacle_dfsph_0005.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 1090 surface
//     sha256 da82c32f4cf808e6b9c99fe97fb4e9302048f3b0eb59417928846499a321525c
//   obstacle_dfsph_0006.vtkhdf, scene dam_break_with_obstacle: 3146 particles, 835 surface
//     sha256 556f432b4b74e781439f3669595d6af2ef3f7d4503de50cedea63797b7eb6367
//   sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 bedc8096c1267e4baaaace3695ba66d4902a4cc81ae1e92c736d85ef4001f86f
//   sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 d76a5b0073c13533a0dd54963672601a0b6476011b657d458264d62c328b3a9b
//   sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 1536 surface
//     sha256 58fa440a9ade8842e8c2256a604071496fee963f39812679f54c29b422c206ef
//   sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 2402 surface
//     sha256 937d8e4a57e2c3793f1ac00cb7b41e5a72f605ca1d7b1ed4254ad2f628df2f4d
//   sphere_dfsph_0004.vtkhdf, scene fluid_over_sphere: 5120 particles, 4149 surface
//     sha256 91b4e61b86f657ca2f7bf2207a582a702ca557ae8833319ec3cbd050c88667f6
//   sphere_dfsph_0005.vtkhdf, scene fluid_over_sphere: 5120 particles, 3384 surface
//     sha256 66be4d99bbdce38514c07e59cd10def12c74f67c0b456e46aba181600e870273
//   sphere_dfsph_0006.vtkhdf, scene fluid_over_sphere: 5120 particles, 3585 surface
//     sha256 81ed4ae2e9492492618aaa64129be12edb621fd5c44e6d046e50111fad5cd2b7
//   tank_dfsph_0000.vtkhdf, scene resting_tank: 2560 particles, 256 surface
//     sha256 27f1c899b07b8698870b992bd75604cbaa951aa943ef393e4cd5a8918e0eee34
//   tank_dfsph_0001.vtkhdf, scene resting_tank: 2560 particles, 320 surface
//     sha256 0b569fa6f17436dc8f8011d09af84655c3e98734577d664df28c0deb6621df62
//   tank_dfsph_0002.vtkhdf, scene resting_tank: 2560 particles, 460 surface
//     sha256 17d720fe1ac6301561f5cfad4898d63096a4a9c75710abf28b39989b15dbb60e
#ifndef MENISCUS_COEFFICIENTS_EA3E6E4D72C821CA
#define MENISCUS_COEFFICIENTS_EA3E6E4D72C821CA

namespace meniscus {

struct Surface3DStrict {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 755.9651636357032;
    /// Neighbors, 0.00403 of them for rounding
    static constexpr double d = 20.70028488149998;
    static constexpr int dimension = 3;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// The lines follow support radius over rest spacing; k and d are for this
    static constexpr double reference_spacing_ratio = 2.0;
    /// Share of its volume that a boundary particle counts for; 0: it only covers
    static constexpr double boundary_weight = 0.85;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 20.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 36.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 1.9999999999999996;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.15524994853508;
    /// For the candidates that the first lets through, in other features
    struct SecondLine {
        /// x and y
        static constexpr const char* features[] = {"mass_offset", "direction_eigenvalue"};
        /// Whether surface lies above the line, else below
        static constexpr bool surface_above = false;
        /// Slope
        static constexpr double k = 3.1011105818835283;
        /// Constant, 0.000216 of it for rounding
        static constexpr double d = 9.973315042103122;
        static constexpr int dimension = 3;
        /// As of the first
        static constexpr double radius_ratio = 0.8;
    };
};

} // namespace meniscus

#endif
