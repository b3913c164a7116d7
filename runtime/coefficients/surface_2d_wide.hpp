// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles count by 0.85 of their volume.
// On its training files it has 0 false negatives and 1432 false positives:
//   dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 6feb7a2b30e9df41cabaaf37ccdc6cb63e4724b6babbf4297e32b8fb9f68e656
//   dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 103 surface
//     sha256 27d4c36826ecfda26008f96f2a5badfeba319ef3157eece2ff7d173f4920fa62
//   dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 132 surface
//     sha256 6fb1466ec503b5de2ac9b7529470e4fa908b695de8ba2f83ad75738aa1056449
//   dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 160 surface
//     sha256 f156be16ad1468f4b5bb172a7f5985e97d2d8b8d1e846b9e639564a66b3953d4
//   dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 198 surface
//     sha256 3a2ee6839e45d3c128f7e0e81a6e8bc36c38a96a9bbcc12b554d3c489567ae70
//   dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 232 surface
//     sha256 edabd1992b64b02a0c85ee8b59cd759235874f608da371df3b53e01efa1a18bb
//   dam_dfsph_0006.vtkhdf, scene dam_break_2d: 1250 particles, 272 surface
//     sha256 98ada77381f4ebd0f0b01dbea4b415e7a7b7484145cb8dc06c5df63ecda13e09
//   dam_dfsph_0007.vtkhdf, scene dam_break_2d: 1250 particles, 324 surface
//     sha256 8d08d6c68d57bd8dbeeaf144c11a2e83fe94d8e1ed93b46377c02009a558bb04
//   dam_dfsph_0008.vtkhdf, scene dam_break_2d: 1250 particles, 342 surface
//     sha256 c86b1d8d9a5205677a304c09f967e985374d7bd27db552a11aa3eb6f5aac32bc
//   dam_dfsph_0009.vtkhdf, scene dam_break_2d: 1250 particles, 376 surface
//     sha256 d93772a82b151c83c509800f1e7e98fd58d30a029483231367aaa9b7762e0b2d
//   dam_dfsph_0010.vtkhdf, scene dam_break_2d: 1250 particles, 378 surface
//     sha256 183bda7c97a9350c5189ed238c5c2dd8c284206c4123f5371503f3550cadefa8
//   dam_light_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 cce33926e86304a39c1af07a07b39022f74560f4e512f2d741a7411ac99bf773
//   dam_light_0001.vtkhdf, scene dam_break_2d: 1250 particles, 99 surface
//     sha256 b8a768a2797da3105b0088ef1ef7ad70af9162466b5af0ea711ce353d4893bd0
//   dam_light_0002.vtkhdf, scene dam_break_2d: 1250 particles, 125 surface
//     sha256 16effd51853336cc1ebab7ec4d0e7d1589ed4be66cf5d0861ea6c69c792917e8
//   dam_light_0003.vtkhdf, scene dam_break_2d: 1250 particles, 184 surface
//     sha256 daed3cbb37c01f5efa62ca8b05b3d51b3031355a90346453a12d90838f5271b8
//   dam_light_0004.vtkhdf, scene dam_break_2d: 1250 particles, 223 surface
//     sha256 3b12c36144e05dcaa90d63fb4c540dd95a2c39a5abe8a0cee38cfbe0b31fc54c
//   dam_light_0005.vtkhdf, scene dam_break_2d: 1250 particles, 271 surface
//     sha256 77cfd5552076440327f1ff3faf44106922af525af7aa7401d177441bcce42966
//   dam_light_0006.vtkhdf, scene dam_break_2d: 1250 particles, 318 surface
//     sha256 e80f5dad7dca259c0fea86acf5aabd20e896052d5b419d55bf3bbf68b276ddf2
//   dam_light_0007.vtkhdf, scene dam_break_2d: 1250 particles, 367 surface
//     sha256 80cb2825cbccbe394f1c4780b14f21979f8d5efacc8e81001adfa113ead9c025
//   dam_light_0008.vtkhdf, scene dam_break_2d: 1250 particles, 402 surface
//     sha256 b1e62d2cb6d6510b6a374c8c20957a7bac2e68955efc8fd85d2498786ee1905f
//   drop_dfsph_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 f33ce720f0042550c9a11fd42caab204da8415e0f04b68b50daa6a521b8ab490
//   drop_dfsph_0001.vtkhdf, scene drop_2d: 1600 particles, 211 surface
//     sha256 d622b93612e3fc50fe5c5360d8d47919316fbe9d5d6798fe2b3ec2dc2fe61f39
//   drop_dfsph_0002.vtkhdf, scene drop_2d: 1600 particles, 218 surface
//     sha256 619446b7735cba6fdecb4b95f89f510f88d504d80daf0f98ae7e3cdbadfb0ef5
//   drop_dfsph_0003.vtkhdf, scene drop_2d: 1600 particles, 218 surface
//     sha256 1ec2518efa6b2bdb0c734358480f68ba89741a8d2cc1e46669b4eb5cfbf368c9
//   drop_wider_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 cb98ae697b65e4438d3fed2e866ce64b1b76f0b99a73c7b0a32d46c637f09ca7
//   drop_wider_0001.vtkhdf, scene drop_2d: 1600 particles, 217 surface
//     sha256 53043bfe030231c868990795531226bf4ac750c728475aaefb92dc37192964e3
//   drop_wider_0002.vtkhdf, scene drop_2d: 1600 particles, 227 surface
//     sha256 7a7de46d8026a9ca9e4a0104457d94aca031ebf1d97961615f904c519b931c2f
//   square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 99 surface
//     sha256 6cba75beba9fa1d90014646a3e6c851833c7eeb9bbcb61927977abb2ef1d8831
//   square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 161 surface
//     sha256 fa5fcd5452a952932a553b0c0cf7bb5aaf3983373115730e7fed251f8d69abdc
//   square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 204 surface
//     sha256 d240e2b19d70e42d6fda4d5a06b0e0225d0ed8b4817fa425aa0ce983b8a855b6
//   square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 277 surface
//     sha256 b6f2a8a518f7eb68336f2015fe569f1e14d9b6491de363383096733590a1800e
//   square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 345 surface
//     sha256 cccba2435a97644541772d29c60570eef685b188c913b610a3d561c9251dd36d
//   square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 425 surface
//     sha256 932c5f4c22718647d9a5bbd193940a641cd4469e41c35a944440e68f3fdccbe9
//   square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 480 surface
//     sha256 fc96810f5607b9b7128bda45ca55ef8d9ff5cc1bbdf2afcc1ff8cb54be64c05b
//   square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 544 surface
//     sha256 a19cb21eeef527a994368df438a604b28d87ebd4b6722ff29b73b3673774e32a
//   square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 575 surface
//     sha256 85046bef428f8377b1151e9daa7bc2d700b7179e91e16f7d9d4da22d6929505d
#ifndef MENISCUS_COEFFICIENTS_AF59F83862438047
#define MENISCUS_COEFFICIENTS_AF59F83862438047

namespace meniscus {

struct Surface2DWide {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 33.290252285153336;
    /// Neighbors, 0.000416 of them for rounding
    static constexpr double d = 9.43820204308763;
    static constexpr int dimension = 2;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// The lines follow support radius over rest spacing; k and d are for this
    static constexpr double reference_spacing_ratio = 2.0;
    /// Share of its volume that a boundary particle counts for; 0: it only covers
    static constexpr double boundary_weight = 0.85;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 9.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 12.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.51259453814803;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.9068883707497264;
    /// For the candidates that the first lets through, in other features
    struct SecondLine {
        /// x and y
        static constexpr const char* features[] = {"mass_offset", "direction_eigenvalue"};
        /// Whether surface lies above the line, else below
        static constexpr bool surface_above = false;
        /// Slope
        static constexpr double k = 9.140023310626066;
        /// Constant, 0.000246 of it for rounding
        static constexpr double d = 3.3843888411735734;
        static constexpr int dimension = 2;
        /// As of the first
        static constexpr double radius_ratio = 0.8;
    };
};

} // namespace meniscus

#endif
