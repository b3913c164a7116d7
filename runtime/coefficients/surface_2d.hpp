// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 33676 false positives:
//   dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 6299ce1e0ff27f79a0e28a7e12735a9551154c79a5fa207636818dadb8628637
//   dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 70 surface
//     sha256 234fc39afcb44a68cc7872b02dccbc578d50aa9e5b88bad41d2994c7634f3f5a
//   dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 104 surface
//     sha256 737d0df5085cfbb87cd81e9b80f71a9d1014c66d2216144f989b6ccb3d14a35e
//   dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 170 surface
//     sha256 06b23a47f1ad8400c62146ec4c6ea3f587e37cac7252f10646202e23590061f2
//   dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 233 surface
//     sha256 9b0687c6dad15e4a6ff54bdd330b3463aa7ab963927d3055c271d98ad8874493
//   dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 255 surface
//     sha256 215627f348765e0ac63abf050d4f56b2eb155944740bf941389ff38e68e333c0
//   dam_fine_0000.vtkhdf, scene dam_break_2d: 5000 particles, 149 surface
//     sha256 30766507f730ce00ecf0d24e2b5cd0f0208ff0b2da1510e6d265793fa34ee6b1
//   dam_fine_0001.vtkhdf, scene dam_break_2d: 5000 particles, 148 surface
//     sha256 c5aaf4893c2668077c78343044fa65f638f0cdf22de235f0bc1dd8d7390bea98
//   dam_fine_0002.vtkhdf, scene dam_break_2d: 5000 particles, 146 surface
//     sha256 ac79566d4064d4adbfacdc1d874dfc4712ea9db9409918e9d22bcdfb93566b62
//   dam_fine_0003.vtkhdf, scene dam_break_2d: 5000 particles, 157 surface
//     sha256 4a539c3c3dff88a27259426f479e6cf79ad6cc584cabdcbad0fb051b26580af3
//   dam_fine_0004.vtkhdf, scene dam_break_2d: 5000 particles, 218 surface
//     sha256 6fad75d01d6e44f6b5df120444b48f65d6f04db62dbd2f23eda67dc9fb96b6bc
//   dam_fine_0005.vtkhdf, scene dam_break_2d: 5000 particles, 269 surface
//     sha256 1f467618415be0108a24fc89759efb88704701024dc2d7254edcb64548c720a6
//   dam_fine_0006.vtkhdf, scene dam_break_2d: 5000 particles, 353 surface
//     sha256 85a0f7ad3a77264aae9ffbf01d5b9e982ecf538a2b40d9ab7f233b76e86a53d0
//   dam_fine_0007.vtkhdf, scene dam_break_2d: 5000 particles, 426 surface
//     sha256 5dbcc0988ab952dc95643d97882935bf2eaeb36fed2f909197e8edb0c4364c43
//   dam_fine_0008.vtkhdf, scene dam_break_2d: 5000 particles, 479 surface
//     sha256 82e9e024dcc7d41f887db6fb8274305b8e62c7ec3f1ef7205b775a241ad65b59
//   dam_fine_0009.vtkhdf, scene dam_break_2d: 5000 particles, 527 surface
//     sha256 d554a44110550acd351739be3ba4de3b838eb0d00fe6d2e8fa6c4a8f139a9b32
//   dam_fine_0010.vtkhdf, scene dam_break_2d: 5000 particles, 553 surface
//     sha256 4f69607c4be95e63688761a00fdb1bcf8e8095cc541ac905d9012d5212fc7abc
//   dam_light_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 b07e752f7b3b1d0d029c920a7c5e1b91718bc7482a4803f1b108c862c108de78
//   dam_light_0001.vtkhdf, scene dam_break_2d: 1250 particles, 73 surface
//     sha256 e96d5d1d96c5616a426f006591a7dc8d39ab4fd4766dbbb9aad918e054bfb94d
//   dam_light_0002.vtkhdf, scene dam_break_2d: 1250 particles, 115 surface
//     sha256 b6d179e732af76e404f7222f8f28e8be1ed98fe7451651be735f172814d4b051
//   dam_light_0003.vtkhdf, scene dam_break_2d: 1250 particles, 181 surface
//     sha256 b5d433b40928bba9c7b704a8dc0546a9406b24761a0bbda381a51322d1df28c6
//   dam_light_0004.vtkhdf, scene dam_break_2d: 1250 particles, 244 surface
//     sha256 f43fd8b8caf2d3302cb361651026e86d2b65c9e206a4f5e3946db858ced58ef1
//   drop_iisph_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 6adb9f896924f75bdf1391eb4e9e69be9f584bd46a775fa3a82502ffd1fad6d0
//   drop_iisph_0001.vtkhdf, scene drop_2d: 1600 particles, 169 surface
//     sha256 a28ce2d62a28f6ab8766070a3818a7ec800a51cc04e75dec24ff91c4bc5c8681
//   drop_iisph_0002.vtkhdf, scene drop_2d: 1600 particles, 176 surface
//     sha256 51b3cb0eebf0a4c6740b7dc0b6b6c5be6a8b0e5cfdcc8a216739079b6989aaef
//   drop_iisph_0003.vtkhdf, scene drop_2d: 1600 particles, 174 surface
//     sha256 378721e3dcd3b875a0c8d9e4a8c1cc6af3864eebe8aaef79c7ee6e77c43539a0
//   drop_light_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 0bba2e2aa03f7ee0950b1e558036a0db21b34d8076af88b511d8033dce3564b6
//   drop_light_0001.vtkhdf, scene drop_2d: 1600 particles, 194 surface
//     sha256 c9b0f3c3da2ad23ddfceb99a2e1ec6330d77f636b3c88963659764422f3014fb
//   drop_light_0002.vtkhdf, scene drop_2d: 1600 particles, 194 surface
//     sha256 23c9f8931c4a1088ac77aa71d335c573feb9bd0e0211754cb93dcae7efbefeb7
//   drop_light_0003.vtkhdf, scene drop_2d: 1600 particles, 194 surface
//     sha256 2fd1ea68f14592635a1b3ccd74ce02937d61eac555a75499d5d251bc30dee434
//   square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 99 surface
//     sha256 16e6d056b25638e7f3a68f451e211b1ae8a06ac5956c0c38aca8661ecd540428
//   square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 94 surface
//     sha256 93e02ed7e6cb85f6dbe74f24d91191d6f95820fd0308d08bd39f918931042afe
//   square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 95 surface
//     sha256 2bf647559b72defa941e365785d3d46868b0dc6236fdb74ce6e64efaa364fa3f
//   square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 153 surface
//     sha256 aa878717fbbf1d9fbb4580dce689f0168c5ef7ee28bc5e6e9475e7d2fa47ba61
//   square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 195 surface
//     sha256 276e58d128b6479b16f1df33f8de8557d6db9f2dce94274010a9509a64c7bed6
//   square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 236 surface
//     sha256 6e1268ae8723aba4c9d9ecedccfbf7bc490c9e860967aa8dd48f46c0c525316c
//   square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 281 surface
//     sha256 4dbdc48eac7d4ee50ed4d929d20e936147f63c7572e79f9470c7415041f53f6c
//   square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 330 surface
//     sha256 76efea07b2e3730e0815285467a98fdd69b9048381a24a496eae77440de07710
//   square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 369 surface
//     sha256 ed21133562aa33c468b47ecd16b0672756bea7d016819fdf722c113feddf10f8
//   square_pcisph_0000.vtkhdf, scene dam_break_2d: 625 particles, 49 surface
//     sha256 fd52c5e1f4ac5dea6d4415a9bd8427fbf5da4e68921d768881cbd7e77fd67e31
//   square_pcisph_0001.vtkhdf, scene dam_break_2d: 625 particles, 66 surface
//     sha256 3f5e2eb7b699f25efb1c89b15d222a882cbd4ca1352a50acf34ae7527c5595ae
//   square_pcisph_0002.vtkhdf, scene dam_break_2d: 625 particles, 116 surface
//     sha256 a4372bd27435d02bdedb4506cc283f2c056bfc87191d70dee3dadb125a598ae4
//   square_pcisph_0003.vtkhdf, scene dam_break_2d: 625 particles, 176 surface
//     sha256 4d5e6ab4955dce188233f5aeef4937c034dd61049917190fa6f322a322b52167
#ifndef MENISCUS_COEFFICIENTS_6BC6648F456648DE
#define MENISCUS_COEFFICIENTS_6BC6648F456648DE

namespace meniscus {

struct Surface2D {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 40.26314675618238;
    /// Neighbors, 0.000451 of them for rounding
    static constexpr double d = 7.999930042359566;
    static constexpr int dimension = 2;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
    /// Least typical neighbor count inside seen in training
    static constexpr double min_bulk_neighbor_count = 8.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 16.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.0;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.0;
};

} // namespace meniscus

#endif
