// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 6897 false positives:
//   dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 7163cfadc81a6af5ad48a585a2eef3f7ab92f07ae9cf489b5e78edbb6e786a38
//   dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 131 surface
//     sha256 1d9707a78ef7f262caf819fe141fdc3a2b64f734d083d968474bc356c94c89c5
//   dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 199 surface
//     sha256 19c189dc9eb8eb8c9649485422d0a8797e6661d4732bd96c3033636c89cb1516
//   dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 273 surface
//     sha256 4030cdd7591f3b0aa985f67f6aa24181143972a4e013e5f29f03a7302f6e0bc5
//   dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 350 surface
//     sha256 b6b28b9086136f22fbdad015f4fbe777998187660a4e0851558b09b8b8be76a5
//   dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 376 surface
//     sha256 3e11952c8edc328dd6d04f082b2d3ef46e16fc40c634e2f547c871b3d785b251
//   dam_light_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 ba762803726ece1ce6b21fa3ccfc7232d901b9449c43ed777beb40f68612efe1
//   dam_light_0001.vtkhdf, scene dam_break_2d: 1250 particles, 125 surface
//     sha256 6b2d7ab5262503c6863d7158a79af716070e6293b5e6d2910a6172fdb205faf6
//   dam_light_0002.vtkhdf, scene dam_break_2d: 1250 particles, 223 surface
//     sha256 979ec0a81ac6c5dbddff98562fdb204a5806ad74e8d3dc98054458f8ee7c486e
//   dam_light_0003.vtkhdf, scene dam_break_2d: 1250 particles, 317 surface
//     sha256 2902240bbd55081c2a6aa26ab79a6a44f953c2211826bd679b89163cc5604715
//   dam_light_0004.vtkhdf, scene dam_break_2d: 1250 particles, 407 surface
//     sha256 64447da136a4f3f47360c65997b4bc6a494ba5e0c3294ed6f59ea791ea0d852b
//   drop_dfsph_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 369af0e5ac00624394839c986df12a9a4e68aa2dc4a5790bc4da7a182c3c76eb
//   drop_dfsph_0001.vtkhdf, scene drop_2d: 1600 particles, 212 surface
//     sha256 cfefb8e7439c0bf09cf36a90053fc93be2f7ac86fcce6ff14dfe2b3a45abdc7c
//   drop_dfsph_0002.vtkhdf, scene drop_2d: 1600 particles, 216 surface
//     sha256 bb80af6f8b8a965a7d486fa6ad41e2343e228b5d34a98720754c6f55cf528445
//   drop_dfsph_0003.vtkhdf, scene drop_2d: 1600 particles, 217 surface
//     sha256 dcc816fed37005db6543a8534c6c1a189ef56b69056d1dd38653d09ef9f75ad4
//   drop_wider_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 13d7d1c304fdfd20128263e3439a0e22b8175e7445ff3e1c4d574f4bd8e37e18
//   drop_wider_0001.vtkhdf, scene drop_2d: 1600 particles, 218 surface
//     sha256 fb6471244d21c2a607ab24646091ff47b6975dc9d4cbbc61ed16c84b7014d4b9
//   drop_wider_0002.vtkhdf, scene drop_2d: 1600 particles, 227 surface
//     sha256 0ea73c2251ad1f6debd72b8ea313ec4440c79e9bc3974304d8e03060eb6427c3
//   square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 99 surface
//     sha256 be78eba9af014754c9c918da69ef537a7afa56cb08b648ec33681aa7ee100b6c
//   square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 161 surface
//     sha256 f9ba7fcef732976fe08be61b0c0c166ae638971a7afa417a8d20dbaaad7fde61
//   square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 204 surface
//     sha256 540fb6dd342e6a6d10e14dc7174cd2a493ab0f19ee82702c99bb52c006b7a4a2
//   square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 277 surface
//     sha256 b0aba1c3a37a6e9c7e56620a654240c9d5b25f60cd56f9a7d909c53a18bf6797
//   square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 345 surface
//     sha256 45e86104871a00ba65a47f9e32b67083a73b8c1745e1f80a5b53b4e6c87267a1
//   square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 425 surface
//     sha256 967982cb5e0ccdd71d84c9ce7ce5773025861a0c661feb706627df20295278f2
//   square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 480 surface
//     sha256 7ed25160e9a12a050217dc0a8c822ad3967ad34b744f5c89d9c4f6717e88aa55
//   square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 544 surface
//     sha256 bbe58c9906411509a2df87384978c723c6e789d6b0d2647fbe0f9a142aa306cc
//   square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 575 surface
//     sha256 bebfc2f051516cdbabc2d3f196b0dd5269698a3e7d393731a2c8a45db28a6854
#ifndef MENISCUS_COEFFICIENTS_C09C7F1F13CA554D
#define MENISCUS_COEFFICIENTS_C09C7F1F13CA554D

namespace meniscus {

struct Surface2DWide {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 87.96986245812045;
    /// Neighbors, 0.00069 of them for rounding
    static constexpr double d = 8.988832927080255;
    static constexpr int dimension = 2;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 18.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 24.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.5;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.6;
};

} // namespace meniscus

#endif
