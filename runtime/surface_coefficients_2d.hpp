// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles do not count.
// On its training files it has 0 false negatives and 46686 false positives:
//   dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 d8040b4f4111b8ce0925d7b427ed25530d96ca98e21199e681b4fe98ccf0d2c7
//   dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 70 surface
//     sha256 93ef9763df8b68e9c80b569a5ddee620d42930b5789ddf6c58ce9e387a6fe97e
//   dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 104 surface
//     sha256 7d70d185f2d2f5bbe7d837fcaec46ba35d251216335d3dc3c648791bff90c947
//   dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 164 surface
//     sha256 f01ce4144299e1f65a364053c4ad0cdf36dad1f4b1e8aad8f5a5015246b19d12
//   dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 228 surface
//     sha256 8687802d3e8c45a75110d7c7b470f65c600d1dc78847767bda7ab64d398ce229
//   dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 261 surface
//     sha256 fb5bda77f6c1c9c70c9b4fa397959335ea27a200a58ae0e6bf45d6f21b7afe62
//   dam_fine_0000.vtkhdf, scene dam_break_2d: 5000 particles, 149 surface
//     sha256 1db1f7333c8a7f4a4d24e99fc7bd22414e426680b3d0d201b7d14c32b2fdd342
//   dam_fine_0001.vtkhdf, scene dam_break_2d: 5000 particles, 148 surface
//     sha256 e0586310f0d61b2afc7f07584d98751ad200fdbd71030b0d9e69a0dc82807ad8
//   dam_fine_0002.vtkhdf, scene dam_break_2d: 5000 particles, 146 surface
//     sha256 f61ae591fd1926fe98f02e7e4b0df222a1cc543753d14d74e896c8d45e80ffc4
//   dam_fine_0003.vtkhdf, scene dam_break_2d: 5000 particles, 158 surface
//     sha256 f9459608767441fa88b3238755dded0bb256ca4f71d58b63006ffb6f7c5a4aa0
//   dam_fine_0004.vtkhdf, scene dam_break_2d: 5000 particles, 219 surface
//     sha256 379cc95b3a271194b2f2bb9597a591bf680891e864d94f3094bcf8873aed307e
//   dam_fine_0005.vtkhdf, scene dam_break_2d: 5000 particles, 264 surface
//     sha256 45f64775100979c5f4789a965d9d39f46a05dc4f75e33e5f02e478e1feb933f7
//   dam_fine_0006.vtkhdf, scene dam_break_2d: 5000 particles, 368 surface
//     sha256 a1153cf0f7a9ad5aa1062010685df374a17e66233bfca64c70e4fa7d63e496f3
//   dam_fine_0007.vtkhdf, scene dam_break_2d: 5000 particles, 434 surface
//     sha256 ecddd5cfeb5067f281a7ac8485b83be5d3a7d50b30380f78820f009f096bbce7
//   dam_fine_0008.vtkhdf, scene dam_break_2d: 5000 particles, 471 surface
//     sha256 bd0b6903de74e83674d3bfdbbaae675d045c1f1f69dd8482190c9623b3446233
//   dam_fine_0009.vtkhdf, scene dam_break_2d: 5000 particles, 518 surface
//     sha256 4d482427c7ef560b63ad87afebac7d45d3d0a888cff3ad01d8ffad2f07c13596
//   dam_fine_0010.vtkhdf, scene dam_break_2d: 5000 particles, 562 surface
//     sha256 fc52609c002a9082e06fd532a1427fa04cec019dcbdbddfb19dbad57a964eba5
//   dam_light_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 94b20f7f1f2645f84798432d59231ff0393b6b92f1e6286c629346e40da0beb0
//   dam_light_0001.vtkhdf, scene dam_break_2d: 1250 particles, 73 surface
//     sha256 68ffe5cb3627e98c1b6617e4280efa5e2e33366030871e65753dcb1128d22428
//   dam_light_0002.vtkhdf, scene dam_break_2d: 1250 particles, 115 surface
//     sha256 dc0fbe20f06b9c4951878557b5d214f3fe67f48871735e4b5bb031ff1b1f7282
//   dam_light_0003.vtkhdf, scene dam_break_2d: 1250 particles, 181 surface
//     sha256 e718aae896db47395b2d2c3c18e5c03ad7b2e9a48f6445048e3b7eb1689c3d59
//   dam_light_0004.vtkhdf, scene dam_break_2d: 1250 particles, 249 surface
//     sha256 ec8dc63b3e05956b5954e6ff0ee726f55a16b45d915ff59e5972b79dc37e10dd
//   drop_iisph_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 9fa0d9f983de3223f4693d768a65c347169ba355dc63e9fa7c07c4383f719151
//   drop_iisph_0001.vtkhdf, scene drop_2d: 1600 particles, 174 surface
//     sha256 c38b395f4289b727b5dbc98162441ce7c210b8b8faf2aa3079502adc74c78706
//   drop_iisph_0002.vtkhdf, scene drop_2d: 1600 particles, 178 surface
//     sha256 e7619f1f92745c23fa7053b41a4e01f0dc2364a29c401c0ec5cd08ac7d4a6f89
//   drop_iisph_0003.vtkhdf, scene drop_2d: 1600 particles, 180 surface
//     sha256 c9c352023cbc5418ab5706a17a78756d4c003d71c9506bfdcee1068af02075a1
//   drop_light_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 8451a7e5c0dfc9111a8116470259e25df5f8954cead51ecd649a81fdd8a39156
//   drop_light_0001.vtkhdf, scene drop_2d: 1600 particles, 193 surface
//     sha256 b12aa1ca06ddcd146b54ff2049b88d792b1e570274fa203d17ebf3b5aea0a7e4
//   drop_light_0002.vtkhdf, scene drop_2d: 1600 particles, 195 surface
//     sha256 544edbb318515af4e512a37a5af7affe3274a335833fff90f8f74c349c27930d
//   drop_light_0003.vtkhdf, scene drop_2d: 1600 particles, 193 surface
//     sha256 22cfc15c50b87b74f72717686de9a6b3f88d83631a21fe65065e81c96ddd077b
//   square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 99 surface
//     sha256 0abe2745d5edd33d15035c9813b86ef2f2b35105af5bf30514c91d70ad82b1b5
//   square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 94 surface
//     sha256 5bff9fbe2544d05d50ddcb965be6d15e58ef1e3dbca23f426d53b8a038c8e339
//   square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 95 surface
//     sha256 e68ab469d1904dc166f81d7e2911003c70b1fcbe8feac83fe6504ae27c3ec125
//   square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 153 surface
//     sha256 f35307afce133e442813132bfd72aa4fafaf864aebd0f12a7b64e500c9dbf725
//   square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 195 surface
//     sha256 b96844c149a864084266828e5c4e2eba13c29c67b4eaafabc1c330a3f25a957f
//   square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 235 surface
//     sha256 c88431efea84c5b25bc1964ba4e639a50efe513ff34e9ba1f20e2e52d6622fd6
//   square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 287 surface
//     sha256 c5230ffbc693d4ffb6fb06699679c9cd5774656f936ec76039cb1cdce6500b82
//   square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 327 surface
//     sha256 c7597e65ca54240909b806f8afad7faf99124082b0364be7d47b95b81eb40b32
//   square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 368 surface
//     sha256 574c2c2056958a923748b07714ec2953a2a3fc29204a21990d1369bcd2857967
//   square_pcisph_0000.vtkhdf, scene dam_break_2d: 625 particles, 49 surface
//     sha256 2c4d22dd8868de42ec9459eeb8832f7cdf15b8a296d3fd9c1ade83389b427191
//   square_pcisph_0001.vtkhdf, scene dam_break_2d: 625 particles, 64 surface
//     sha256 65e768b72c8b7f203e56a44356313c0d88d48b7fc972e02751174b5f1b5d67dd
//   square_pcisph_0002.vtkhdf, scene dam_break_2d: 625 particles, 121 surface
//     sha256 aa022042568c8ef33fbf11f099e3363fe2ce7956b449eec27c654586acef0e8d
//   square_pcisph_0003.vtkhdf, scene dam_break_2d: 625 particles, 181 surface
//     sha256 bdea19b5ff2cb5ecb6a392a955dec1e1e3f4dc9dc105b539bf6711a9c6870942
// clang-format off
#ifndef MENISCUS_COEFFICIENTS_D9477B6D59A7E4C4
#define MENISCUS_COEFFICIENTS_D9477B6D59A7E4C4

namespace meniscus {

struct SurfaceCoefficients2D {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 68.65934140418499;
    /// Neighbors, 0.000593 of them for rounding
    static constexpr double d = 7.228096435581206;
    static constexpr int dimension = 2;
    /// r2 / r1 of the labels; neighbors closer than r1 - r2 do not count
    static constexpr double radius_ratio = 0.8;
    /// 0: neighbor counts are taken as they are
    static constexpr double reference_neighbor_count = 0.0;
    /// Surface means an uncovered fraction above this
    static constexpr double label_threshold = 0.0;
    /// Least typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_min = 8.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double bulk_neighbor_count_max = 16.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double spacing_ratio_min = 2.0;
    /// Largest support radius over particle spacing seen in training
    static constexpr double spacing_ratio_max = 2.0;
};

} // namespace meniscus

#endif
