// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles count by 0.85 of their volume.
// On its training files it has 0 false negatives and 3045 false positives:
//   dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 038ebe57c3312f4975efdfa4a51447bb1ce066c1900520fcd57b6636bd8be0a6
//   dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 70 surface
//     sha256 6d9175e3d550759154fde0b25c1ab02301d393f8ebab416b09f2d6b532d38354
//   dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 104 surface
//     sha256 9e4b2b3f362d6845a1bac000af0c3234392a32b00ea345040cb0cab1ad4afe35
//   dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 170 surface
//     sha256 105cc3567b2a16fc34e0fd79b344a3be0002b303ecfe554b4d2a46a049a18561
//   dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 233 surface
//     sha256 477aab5d03d739879a1097ca87f4c43c327875c305434eb416d1fe5290351ada
//   dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 255 surface
//     sha256 60546d2062f9ddd8e926cb2e9824bd814a9b6e88e1b766bade331f4ed8d9afd6
//   dam_fine_0000.vtkhdf, scene dam_break_2d: 5000 particles, 149 surface
//     sha256 702b6c9ac75cd05d4b4a218f925342bdc3ad1487fab9f6653a9bfec760647598
//   dam_fine_0001.vtkhdf, scene dam_break_2d: 5000 particles, 148 surface
//     sha256 3c70e872a7f42b075ed20c78f3f137958956e610453cbc13281f2462e6a2b3cc
//   dam_fine_0002.vtkhdf, scene dam_break_2d: 5000 particles, 146 surface
//     sha256 3a596fbafd7556cef1aa7ec1e6214bcb2b610aa62b8593e04a9f2d5ae4d9a650
//   dam_fine_0003.vtkhdf, scene dam_break_2d: 5000 particles, 157 surface
//     sha256 8024c5ed691d8b6aedf670db26cde0b258846bc455d612ba943f632a2847a68a
//   dam_fine_0004.vtkhdf, scene dam_break_2d: 5000 particles, 218 surface
//     sha256 ddd5e94c8f1558a9195638b851630c340dee39c82255eb4a23e04a24bf17fd57
//   dam_fine_0005.vtkhdf, scene dam_break_2d: 5000 particles, 269 surface
//     sha256 3cee29646ba3c633de8344a2d0430fde02be6dd0c73ac550059032f5647ce1ca
//   dam_fine_0006.vtkhdf, scene dam_break_2d: 5000 particles, 353 surface
//     sha256 4ef780db9eaf7b82debfe2b748bb93c048f1fb2b4fdba772f9643750cfaa46ca
//   dam_fine_0007.vtkhdf, scene dam_break_2d: 5000 particles, 426 surface
//     sha256 4d64e19f0c5d08da2f7f6155ec6a9c75870ff9c656266a1efb782c3e734a1ebd
//   dam_fine_0008.vtkhdf, scene dam_break_2d: 5000 particles, 479 surface
//     sha256 8f5b177235f25e248f480b64f0b37c8af243758b4f486e63a4d04c6c284e5e70
//   dam_fine_0009.vtkhdf, scene dam_break_2d: 5000 particles, 527 surface
//     sha256 577a76c1021af3275e2a516c0a1efd799c8b652bd823be26229dce542f15c794
//   dam_fine_0010.vtkhdf, scene dam_break_2d: 5000 particles, 553 surface
//     sha256 caa6f68b8239f066b73ae5de39ccaaa431c523e0b0999a4dc48c0a3d745b494c
//   dam_light_0000.vtkhdf, scene dam_break_2d: 1250 particles, 74 surface
//     sha256 dfb713b11fac91e339c1ae2a932feb4b4ece0bf844421d17aa2d7b17c5764256
//   dam_light_0001.vtkhdf, scene dam_break_2d: 1250 particles, 73 surface
//     sha256 04d13837cafa9871ff29a19cd2077b52eb1da9395758311e6be473654ea619e4
//   dam_light_0002.vtkhdf, scene dam_break_2d: 1250 particles, 115 surface
//     sha256 58b3bdba4c1e7b1180774ef2622ebf922e1d0d23ae7a7d6a72bf3710d8e1a105
//   dam_light_0003.vtkhdf, scene dam_break_2d: 1250 particles, 181 surface
//     sha256 289a119dedf9d0d8c4887463873aa512170c077d9368c030c69edf70a97f9129
//   dam_light_0004.vtkhdf, scene dam_break_2d: 1250 particles, 244 surface
//     sha256 ab1a9c4be4c76421f7911ee7ef41abe46c0290d9ef521d049ddf00abd6d3df79
//   drop_iisph_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 1284e0d2cd6bd51aa6adcc94a98f03fbc96f06630d7b8f1fc7e237847097f858
//   drop_iisph_0001.vtkhdf, scene drop_2d: 1600 particles, 170 surface
//     sha256 98655c2363444b1cbd36ce5cc10bf7f6f04196cc06726731dad2d594ed7f7420
//   drop_iisph_0002.vtkhdf, scene drop_2d: 1600 particles, 174 surface
//     sha256 53c8f7e662d46045e926ba0b1cbedacb81b1caa6254b1c19dd1297c07d90f3ae
//   drop_iisph_0003.vtkhdf, scene drop_2d: 1600 particles, 173 surface
//     sha256 7271e2d9ccb22d5569377c46550dfcf9f34d991804801758dfbb702b52872ebe
//   drop_light_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 478a2418047cab1bbfddeed6831141acd8c3a8e3354b9962592bbd798f5ea423
//   drop_light_0001.vtkhdf, scene drop_2d: 1600 particles, 192 surface
//     sha256 7b605ce84d96a5fa1bf5668437a34366eba5bde3e4f77f985055ba53fd82a824
//   drop_light_0002.vtkhdf, scene drop_2d: 1600 particles, 194 surface
//     sha256 179a2c865210b1b3c7023add45d8679759a1701363628dc465ac4e32afe7340a
//   drop_light_0003.vtkhdf, scene drop_2d: 1600 particles, 193 surface
//     sha256 99add4f40ed8918d68b83af0e34c2d959ad48a337b3b7346745b846111f410e1
//   square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 99 surface
//     sha256 4cbcaca8870a9bae76fc11c5c885000bcbf520c79859a63e1b23ed128769e375
//   square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 94 surface
//     sha256 275562fa536930d1e52cb27398673ffe3030d19500ca394ebbd6caebc668fce4
//   square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 95 surface
//     sha256 70027ddc97221fd291b0e7294bfeb3365bfea27997e45d9d726f595a1b804427
//   square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 153 surface
//     sha256 855a1a6ce8373d2ea416f838da004f8a28d953ed5b6924b19c128700322efdf0
//   square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 195 surface
//     sha256 a2910a808b5cdc20e208d9902ee37de7684ef2fcc6e57d344b92794282fea2e0
//   square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 236 surface
//     sha256 3678470b5d913f1c46a8befdbc1074331886b3970e8e7e93f573af7572dbb814
//   square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 281 surface
//     sha256 8d796638ab2fb2f57f831f8fba1514202eb9006f6b41845ebd708a9ab277909e
//   square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 330 surface
//     sha256 6441233a051ad61de758b90b976eebe9676f7f86ea8693541f5c3da183c453f1
//   square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 369 surface
//     sha256 0fa76accb8e9ac241af410e59c1cc894313bb2809d8f1fe7c0d4d64342c480a6
//   square_pcisph_0000.vtkhdf, scene dam_break_2d: 625 particles, 49 surface
//     sha256 5bec18bd50a1078e98d6f983f4a5c651c92e8c716ada998fb16e3345b3ba86b9
//   square_pcisph_0001.vtkhdf, scene dam_break_2d: 625 particles, 66 surface
//     sha256 a3736e3f25e6993a9a9983d8af203d240854290af4ccb3e531a5deb3165b1079
//   square_pcisph_0002.vtkhdf, scene dam_break_2d: 625 particles, 116 surface
//     sha256 ead63603de60a8d69f9be52fb91cec8801946a79a26441cab99ccf5e5f486411
//   square_pcisph_0003.vtkhdf, scene dam_break_2d: 625 particles, 176 surface
//     sha256 c822e4185a3776665620f07aa0412e7736d37dce31b8574dbf6127fd1b32b8f3
#ifndef MENISCUS_COEFFICIENTS_242F21B4CC639A9A
#define MENISCUS_COEFFICIENTS_242F21B4CC639A9A

namespace meniscus {

struct Surface2D {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 19.963472998415906;
    /// Neighbors, 0.00035 of them for rounding
    static constexpr double d = 8.909515606584012;
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
    static constexpr double min_bulk_neighbor_count = 6.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 12.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 2.010075630518424;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 2.2360679774997894;
    /// For the candidates that the first lets through, in other features
    struct SecondLine {
        /// x and y
        static constexpr const char* features[] = {"mass_offset", "direction_eigenvalue"};
        /// Whether surface lies above the line, else below
        static constexpr bool surface_above = false;
        /// Slope
        static constexpr double k = 9.330351005605653;
        /// Constant, 0.000247 of it for rounding
        static constexpr double d = 3.199963215427554;
        static constexpr int dimension = 2;
        /// As of the first
        static constexpr double radius_ratio = 0.8;
    };
};

} // namespace meniscus

#endif
