// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles count by 0.85 of their volume.
// On its training files it has 0 false negatives and 52548 false positives:
//   h3.46_crown_light_0000.vtkhdf, scene crown_splash: 7751 particles, 2368 surface
//     sha256 c314cbdc5d8fbeeb32b8fa7d1c92bce54d58db0d000dc5d46a9b2d073eee51d4
//   h3.46_crown_light_0001.vtkhdf, scene crown_splash: 7751 particles, 2227 surface
//     sha256 4fd48d451ec46fd421b8fc0103815e9c749174c7f6e434f4522f635a456ad2f1
//   h3.46_crown_light_0002.vtkhdf, scene crown_splash: 7751 particles, 2122 surface
//     sha256 db440bf1f1e873633baaef89f664b8df6fb62536d396cbf4a4de6dd76cf0dfb0
//   h3.46_crown_light_0003.vtkhdf, scene crown_splash: 7751 particles, 2103 surface
//     sha256 421719249a90abb01e59982c5d6f156bb32418a03cff968fd622b8d58376f6dc
//   h3.46_crown_light_0004.vtkhdf, scene crown_splash: 7751 particles, 2235 surface
//     sha256 36d52e8f2a48a93ce3b4e14a60c8c13f1140d69b8491ac190ce2e342f9a94981
//   h3.46_dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 1166 surface
//     sha256 5b141eee624769de86236637c823846358f2e75caa51a767ebbf26deaaaa7d24
//   h3.46_dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 1120 surface
//     sha256 3c905e5929c238f9bc5816bb6916b72c6788f15b2ac999aff3b4e18146b7b412
//   h3.46_dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 1173 surface
//     sha256 431e365f4088c385160fc521bd7c978e10de6a13e4974d9b564287765645b420
//   h3.46_dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 1185 surface
//     sha256 2f3d452ac1dd99bd8df1a4e61987570c9d8bcef4e8729128d773a79244293c5e
//   h3.46_dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 1074 surface
//     sha256 39149439349874bbba035eada810427c40c58b72136a6521286fe9d709517a69
//   h3.46_droplet_light_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 4a5345c08683640a70340bcaba42561c75e1dc13e473e184cb6169149a4adf60
//   h3.46_droplet_light_0001.vtkhdf, scene double_droplet: 3456 particles, 1339 surface
//     sha256 f4b2af6b4a37d481fe3231aec78a10d596efdb31d7f7f16f17ddef5c8390762b
//   h3.46_droplet_light_0002.vtkhdf, scene double_droplet: 3456 particles, 1364 surface
//     sha256 bf16832d54d22e20cd19e737625e0ba86d1a84a1c688f53543c02a322342ccf1
//   h3.46_formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 cefbef9e1b6f6d8b9a2a63b87857611bb3e8e1c1ee50ac51fe9f8c4c38a8e1a1
//   h3.46_formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1380 surface
//     sha256 b3f1dcffc1c5533d69f45cac7ce591dc13b6bc95cedefd94f7b6c4baeb220ae6
//   h3.46_formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 df036d958f5b18665b9a6942d8a940664e1ed2c7efcefa4c54aa6b03a279f315
//   h3.46_formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 20f30511ad21a593eca4597a8fe8335cd3935ac8df331b6f069fcefe3b42b4f2
//   h3.46_sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 0984ab5dad96680e697773dbe8c8c79a2f939223babc0ad894042e2d673b4fc1
//   h3.46_sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1718 surface
//     sha256 4ebbeba0258d94bde626ded815b89b3683b23a48378a70424e15789012d07851
//   h3.46_sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3745 surface
//     sha256 651a95b430754c3cd3a6a1436ae2083c76d95b29424fd1a41498ddbdc1f8149d
//   h3.46_sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 3586 surface
//     sha256 6adab60240cdfbb77f0e783099505d88dab2547d8e4760f291cbdb25985739f8
//   h3_crown_light_0000.vtkhdf, scene crown_splash: 7751 particles, 2344 surface
//     sha256 7646e7ae3b4e821055bf4b57964cc38ddf6fc6ff5cdd8591fb4226de9f836674
//   h3_crown_light_0001.vtkhdf, scene crown_splash: 7751 particles, 2239 surface
//     sha256 bc0d77d9ab8570971c57a0d96408d97628cbfe038026e8b6529616b3d210ce21
//   h3_crown_light_0002.vtkhdf, scene crown_splash: 7751 particles, 2136 surface
//     sha256 e7bedba894c930e6e30fe4a641c3978b801a76b5813bd537e61d24b8c6170c3c
//   h3_crown_light_0003.vtkhdf, scene crown_splash: 7751 particles, 2090 surface
//     sha256 fe043c36037c6168d3912f9ae8303e28aa277d9f26459ce956d753984589f0ab
//   h3_crown_light_0004.vtkhdf, scene crown_splash: 7751 particles, 2211 surface
//     sha256 f35400a2ad949c8b831d81acefb45c92ecdcd5d38a9839d3721ebb0b7499c48f
//   h3_dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 1166 surface
//     sha256 d3d64e6b710ac9edda51dcdbbbacf51f9f08dab03f61873d7cb311521cf3a634
//   h3_dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 1105 surface
//     sha256 77acbb3a92cc5ebdbfdb5fdcff74971d577dc2a2f5e44f071b75959d9a0da741
//   h3_dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 1171 surface
//     sha256 188d54536f76dd85ad488271c7b09df53490d3d6338bdf2acbca3199c9e09256
//   h3_dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 1194 surface
//     sha256 e1ec6e39228ea4c83fcb7525e46427289fbb1f2ad7271970b9d3ed10e21bc8aa
//   h3_dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 1082 surface
//     sha256 44c668114e854b833fea55938cc77238e71e2db4ab306dcbd942754ae28ddd93
//   h3_droplet_light_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 b68e0a91a6f957e9719c8974e528a33fa4deca381888936e531a809157b32f22
//   h3_droplet_light_0001.vtkhdf, scene double_droplet: 3456 particles, 1333 surface
//     sha256 29378f9d4acd34e0f208d4f6e5302bb49f7f9515e9d10378313a4c63e8e8d151
//   h3_droplet_light_0002.vtkhdf, scene double_droplet: 3456 particles, 1362 surface
//     sha256 3f00097ad5479fd2598651938f82ce16de944bb7387a96deb89678bd83c6b271
//   h3_formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 410adccb446efbdbbdcfef737f307a4c378142f230760434920d544dd00c0fce
//   h3_formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1378 surface
//     sha256 2336415ce77255476c15b13a311fb7c29e864e8576b6099084165b4dbbdb658e
//   h3_formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 7a30713b688702abc2faedbcc33c0ede469f1ed3dafb085ee442488afcdace49
//   h3_formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 1326f14a2ece06f8a4c9d32d0a3f23f2367f2b0a12584e8941a5a0ea7518afb9
//   h3_sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 aacd435c07881a4916a04ec57472df4686ddb54e5b56ae49a556aa5f11d4c9ba
//   h3_sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1714 surface
//     sha256 307f29553897643a8c2df6e63899816bad0ed9968ef3c8cfcfb6fabded185c31
//   h3_sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3763 surface
//     sha256 acab25634d15b9964336973aca3ffcdd1222f6968ba0c870436a5f5cb6559ead
//   h3_sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 3702 surface
//     sha256 62c58c2955d1869e1eac52061706c47dc780e684793a65740c995b15402d13ca
//   h4.2_crown_light_0000.vtkhdf, scene crown_splash: 7751 particles, 2368 surface
//     sha256 0ce4396e6b55e68d4838773f5622945384e282f368c48a8b0a25b530c888065a
//   h4.2_crown_light_0001.vtkhdf, scene crown_splash: 7751 particles, 2231 surface
//     sha256 de3bf7ca70e9e1fa3186b2a11022a59a33889ca18dc99edf5ccc0ff4942f4dee
//   h4.2_crown_light_0002.vtkhdf, scene crown_splash: 7751 particles, 2111 surface
//     sha256 9e6ef9df20b2aae546f683ff0a4482170f796f1a4b8d24cd4d93db891413e570
//   h4.2_crown_light_0003.vtkhdf, scene crown_splash: 7751 particles, 2159 surface
//     sha256 a8559070fdc1906dc1ef52c6f11635ff56654ea5e946b33b24c6aa60f176d161
//   h4.2_crown_light_0004.vtkhdf, scene crown_splash: 7751 particles, 2246 surface
//     sha256 7f6f3e403921caa287f91c61c5bc4d1cff1b8eca897fd107dd9afcd097ce67fb
//   h4.2_dam_dfsph_0000.vtkhdf, scene dam_break: 3146 particles, 1166 surface
//     sha256 0aff59557b6a3244f0ab949e7cadb63d1965dd78bdac05fd5c5e9c063771f522
//   h4.2_dam_dfsph_0001.vtkhdf, scene dam_break: 3146 particles, 1140 surface
//     sha256 640275adf44a65168399e6093119ac59dc65d87c2d2bff90e002ec4409acd6d8
//   h4.2_dam_dfsph_0002.vtkhdf, scene dam_break: 3146 particles, 1204 surface
//     sha256 61124d794b333fc6447bcb4716d3fa8154fda03a938420f23b903a4aeeabda33
//   h4.2_dam_dfsph_0003.vtkhdf, scene dam_break: 3146 particles, 1173 surface
//     sha256 d2024f8f517af2598ac4dd5356206fc6237aca133c8baf17015c07c52a1fb22f
//   h4.2_dam_dfsph_0004.vtkhdf, scene dam_break: 3146 particles, 1039 surface
//     sha256 fd40ac478883eeb85a1c5655df8113a236e4458051abd447980eab6fb71550eb
//   h4.2_droplet_light_0000.vtkhdf, scene double_droplet: 3456 particles, 1256 surface
//     sha256 9f48b6af9eb672cfaf927f63d1b06499dd990225682f264bf3f3b5aa3221849f
//   h4.2_droplet_light_0001.vtkhdf, scene double_droplet: 3456 particles, 1347 surface
//     sha256 31625249acd44aff5da22dd7552f6a762b4015485360d224b5988fa0a0d61ed5
//   h4.2_droplet_light_0002.vtkhdf, scene double_droplet: 3456 particles, 1366 surface
//     sha256 dafe5d8e0d7e2dc5bdadcbb5eecf8e1bb09809258a7d00c6fb770f0ccb9b2dda
//   h4.2_formation_dfsph_0000.vtkhdf, scene drop_formation: 4096 particles, 1352 surface
//     sha256 86acae377330248d5239adededb377fa4292301ba6cf7255c1ef9b5f5b85a0b9
//   h4.2_formation_dfsph_0001.vtkhdf, scene drop_formation: 4096 particles, 1380 surface
//     sha256 eecb5c253c5a9e2870ab4b2a97c17256b8ec46cb09e4f8f0fe3c76ac968fc0df
//   h4.2_formation_dfsph_0002.vtkhdf, scene drop_formation: 4096 particles, 1380 surface
//     sha256 089605cd57aa9f192a6bf1aa49596d059166fda688d6b2a378431a39200763f0
//   h4.2_formation_dfsph_0003.vtkhdf, scene drop_formation: 4096 particles, 1379 surface
//     sha256 58e1f32148ba63e5d5f7f499b64181dc01df9347ade81a7ae6d07ae7984bc108
//   h4.2_sphere_dfsph_0000.vtkhdf, scene fluid_over_sphere: 5120 particles, 1592 surface
//     sha256 f409d84f512596deb18d9fa6110f29d34cb6e7a1356275d83f265e62d2986e6d
//   h4.2_sphere_dfsph_0001.vtkhdf, scene fluid_over_sphere: 5120 particles, 1737 surface
//     sha256 3825a5484b9ec8157582ce1ca2463c3dbb49fe2f00e39c09e331d1d10c9f6d28
//   h4.2_sphere_dfsph_0002.vtkhdf, scene fluid_over_sphere: 5120 particles, 3729 surface
//     sha256 d7ac087d7b3e7182b5a19b5b306ce8c039873a3e1810e781a254fa282702f028
//   h4.2_sphere_dfsph_0003.vtkhdf, scene fluid_over_sphere: 5120 particles, 3447 surface
//     sha256 db035c2450f5ce96120087c8b104f44fc93c587f4d052047124381512dc2a09b
#ifndef MENISCUS_COEFFICIENTS_C69FBDE604C7DA59
#define MENISCUS_COEFFICIENTS_C69FBDE604C7DA59

namespace meniscus {

struct Surface3DWidest {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 84.12343909417294;
    /// Neighbors, 0.000671 of them for rounding
    static constexpr double d = 14.136264252726479;
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
    static constexpr double min_bulk_neighbor_count = 16.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 32.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.999999999999999;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 4.5243128490669555;
    /// For the candidates that the first lets through, in other features
    struct SecondLine {
        /// x and y
        static constexpr const char* features[] = {"mass_offset", "direction_eigenvalue"};
        /// Whether surface lies above the line, else below
        static constexpr bool surface_above = false;
        /// Slope
        static constexpr double k = 15.430234958805388;
        /// Constant, 0.000277 of it for rounding
        static constexpr double d = 3.8967774778045454;
        static constexpr int dimension = 3;
        /// As of the first
        static constexpr double radius_ratio = 0.8;
    };
};

} // namespace meniscus

#endif
