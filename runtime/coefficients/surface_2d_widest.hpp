// clang-format off
// The line that tells surface particles from others: surface where y <= k x + d, with the
// mass offset x and the neighbor count y. Written by `meniscus export`; do not edit.
//
// Trained by neyman-pearson; neighbors: same phase only; boundary particles count by 0.85 of their volume.
// On its training files it has 0 false negatives and 9585 false positives:
//   h3.46_dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 146 surface
//     sha256 aed6315e1a9a8a52a05d65dd0e6782ff0ad4e57b2cf46de92edbf56bc891ffc0
//   h3.46_dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 148 surface
//     sha256 cf2ae964546991a91130a5f7423dee4d830191e54427f209ec0c19b7a0b26b76
//   h3.46_dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 216 surface
//     sha256 48f3e8c3d1aa2214d2b179105a59526421e885bf7af5fd10fdeeb504fe69e531
//   h3.46_dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 301 surface
//     sha256 59698a49a92940779ad9932883a479e8b7f3f4258950c480cb115a66c010f8f6
//   h3.46_dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 362 surface
//     sha256 8df804b237fc11c352f6e0e4bd670fff54c95f66efba87a254553eb77ae280dc
//   h3.46_dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 402 surface
//     sha256 3b20649ec0e3d009e29ac4c1cdfb53eaa39de95f161227ef379b57879649bc95
//   h3.46_drop_light_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 78aca7ce0afe8ab485cea5c7d7389eb8b2ca464e5fa724e3f0cb19e0ffd13a87
//   h3.46_drop_light_0001.vtkhdf, scene drop_2d: 1600 particles, 200 surface
//     sha256 0973ec88e52070956267f391a8e0d373122e0f74e3ce2493c0cc411ec204e1ad
//   h3.46_drop_light_0002.vtkhdf, scene drop_2d: 1600 particles, 196 surface
//     sha256 58872e1deedc81fd560656637e095a643091584699a9161a0c0548db748957a1
//   h3.46_drop_light_0003.vtkhdf, scene drop_2d: 1600 particles, 193 surface
//     sha256 44d0b27352059886c6d69ecc48131319615a3800fb4596dec45f95356c7f12d4
//   h3.46_square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 196 surface
//     sha256 d897ef3acd0b42382dcbd447b4b041c8dfca9e16996bb42abc0535e4dc8efd3d
//   h3.46_square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 193 surface
//     sha256 4fdc50e210c52f83bd95d2a3ef1f02fb9c2ee015b3ac13d9a621125542250765
//   h3.46_square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 221 surface
//     sha256 7b4f10e8c6455e04c3ad4d58c7bd13adbe874c57e5bb39bfa98a54db736b4e22
//   h3.46_square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 293 surface
//     sha256 010e52f84666f8255a904f0861b0cb6f76eb833b616784818c92875a4443f81e
//   h3.46_square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 367 surface
//     sha256 db78a1126681bd942d6ee26c66210f6590a226f1054ec3c44d123dd466a9613c
//   h3.46_square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 433 surface
//     sha256 736cfa59612261a90441c165f32232dd679c00a8a2b2a8a592bdb3257ce0d19c
//   h3.46_square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 507 surface
//     sha256 109ccc13531da05492178ba320aebe11aec1f0c4505b99c57e78bf5ea868122b
//   h3.46_square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 570 surface
//     sha256 0c66c8ae89cae3cdf1da954bb57a6f32ef1507baabd7601175d9d8081d1daef6
//   h3.46_square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 611 surface
//     sha256 a357271517dbd63862a604ed2eabd7852c76afed3a1c1d350ee9057ad6721e3f
//   h3_dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 146 surface
//     sha256 8cee07ee69b411adb84c07ce3d0f3877b7b2183b099b59aeeb990687f847b2b4
//   h3_dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 146 surface
//     sha256 15e5acde0c47a4ae94a95c52916f2c285317b281f70edda8ee0f85d2bd144f54
//   h3_dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 206 surface
//     sha256 1607a4283b0f9e35f901255a239a6b07cb946efb9fa968293444f7c899d0caae
//   h3_dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 290 surface
//     sha256 afe6868de57da6fbe7a606d9d22ef3d5082c07defec52c147195a53fa97f83b7
//   h3_dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 355 surface
//     sha256 c45092f6bab41ff5a7305e31d158c32c2d92cc07d2d0e8346c8abb5ca4cbca89
//   h3_dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 398 surface
//     sha256 6e5d46d69b988cda70eefb4ec4449e53ee92571cb1b008fe7f31d8a0afb4ae0d
//   h3_drop_light_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 5d0f3bec6a30ec84454b6917309960e4caa72e14d0d7ec23578f83d1bd8df75d
//   h3_drop_light_0001.vtkhdf, scene drop_2d: 1600 particles, 197 surface
//     sha256 0c3a2a2b30bf714807d909e4cbd365d54d7ff44220d7f04019c839a1cca81c06
//   h3_drop_light_0002.vtkhdf, scene drop_2d: 1600 particles, 195 surface
//     sha256 defda1e147a7f77d19f8956d14883ebbfe75f0cc3c195a76fc85aacd8de75e9c
//   h3_drop_light_0003.vtkhdf, scene drop_2d: 1600 particles, 193 surface
//     sha256 70e8b24dde879b4eabcfdc05825d4586d2122e7b9878c235e74367a7746be40f
//   h3_square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 196 surface
//     sha256 ae320aa2bd7c6320eb51aaf0b82ffce08314bfa4215f8e6bc3a6698ed3b7fa4a
//   h3_square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 190 surface
//     sha256 7e165a432d1c59d5bb4ca39ca0d01f4338880bf6e8f3808cbc4845b09508deec
//   h3_square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 209 surface
//     sha256 19c3dc17b2abf22c3f3c53d18410e9c87a0acc234695c37c007f3d685b7dc60d
//   h3_square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 287 surface
//     sha256 6d4c2bda7120de601094d013a0ef966432476911b28ae76efefff88a9856e368
//   h3_square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 355 surface
//     sha256 685597eff1db8e24e5fa9ba835c6b954e0ab596bcfba6bf56d183d159a1fcb67
//   h3_square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 416 surface
//     sha256 3f9e497517a6982d313ecdbb1f226bb11b767dbc5dcd05d84a8e34f664246b74
//   h3_square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 491 surface
//     sha256 f520685f5f6f2e480cb9f189f7b83eb8c625abf1f9e775cdbc25bcf72a553cb0
//   h3_square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 554 surface
//     sha256 09cc6b6951db4ca4bb91c7ebf5c0c4be7632d5643f453d8531c84e2c6bd2269f
//   h3_square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 585 surface
//     sha256 3176cd9c6cff22c4e40da36c60ab8c8b58ac8a01056f20fbfec3e0551d5c96ae
//   h4.2_dam_dfsph_0000.vtkhdf, scene dam_break_2d: 1250 particles, 146 surface
//     sha256 7c83fb1d8003ba3138ccd5c8b6776c8a2133213622242aed779f83681828fa7e
//   h4.2_dam_dfsph_0001.vtkhdf, scene dam_break_2d: 1250 particles, 160 surface
//     sha256 f9cacdf910c5483bbeced74bd3b89e034b0024cc3b634060c2d868ee1c1e22eb
//   h4.2_dam_dfsph_0002.vtkhdf, scene dam_break_2d: 1250 particles, 237 surface
//     sha256 e2bdedb0b4facde1c982648668e47ed07a41f00b1b77db4831c483ba524b0bc9
//   h4.2_dam_dfsph_0003.vtkhdf, scene dam_break_2d: 1250 particles, 327 surface
//     sha256 4977f9272b900ba4df639261a203b6539ee8aa28e3c12a7155ede7324f1e6000
//   h4.2_dam_dfsph_0004.vtkhdf, scene dam_break_2d: 1250 particles, 400 surface
//     sha256 2df6ca3438f54c4b9ef85ef1e63b2a2ccb15961fe9cbf8f081556718d92f9bb9
//   h4.2_dam_dfsph_0005.vtkhdf, scene dam_break_2d: 1250 particles, 412 surface
//     sha256 72a6f6b66f5ff8cbfc4e404130c5f1ac31f72aafa090907e7af5425e22039d6e
//   h4.2_drop_light_0000.vtkhdf, scene drop_2d: 1600 particles, 156 surface
//     sha256 07850009a5a6eec6e83831190a02e732b73e2da790282edc39c6bd9eca510356
//   h4.2_drop_light_0001.vtkhdf, scene drop_2d: 1600 particles, 220 surface
//     sha256 c6394c5df31990a4522fd152c12bd630c0824af93018e90eaa4dae949bfc4aeb
//   h4.2_drop_light_0002.vtkhdf, scene drop_2d: 1600 particles, 207 surface
//     sha256 7ba90038d49cf428f740cd59aa4a8cdfcd36c6c5302b188404a2ab579cfb95bf
//   h4.2_drop_light_0003.vtkhdf, scene drop_2d: 1600 particles, 202 surface
//     sha256 2854c575d08422bd9010e07f2237b1e35b6d6ccc363fa6904bc289a3f2a54354
//   h4.2_square_fine_0000.vtkhdf, scene dam_break_2d: 2500 particles, 196 surface
//     sha256 4cad16dad6faf66b17004f85220bcf9fb1880606303b175ee229849f34b20f79
//   h4.2_square_fine_0001.vtkhdf, scene dam_break_2d: 2500 particles, 214 surface
//     sha256 49238dd006f96493d1d7e238e9b3157885d260e527c152401f30b2c030c542a4
//   h4.2_square_fine_0002.vtkhdf, scene dam_break_2d: 2500 particles, 258 surface
//     sha256 62ed88509022206bd904669610537648da05684e5e1af5109669659fbde06a34
//   h4.2_square_fine_0003.vtkhdf, scene dam_break_2d: 2500 particles, 321 surface
//     sha256 f1cbe168f54966045bfda8e93188b206f26c509e2ea1782c1597bbe2988f9343
//   h4.2_square_fine_0004.vtkhdf, scene dam_break_2d: 2500 particles, 402 surface
//     sha256 5f29c7c2969c16a7e49ab1759acd92558a6fa0cbc274da630de416642548d4af
//   h4.2_square_fine_0005.vtkhdf, scene dam_break_2d: 2500 particles, 488 surface
//     sha256 430a0ae00c63b3b4497f88e2c5734f36f66a74a71b2f154ad55f987fda052b20
//   h4.2_square_fine_0006.vtkhdf, scene dam_break_2d: 2500 particles, 576 surface
//     sha256 13f3550d2e3160db499915206f2e4a10b751073b7991d6161c3b20c01a569b52
//   h4.2_square_fine_0007.vtkhdf, scene dam_break_2d: 2500 particles, 622 surface
//     sha256 2275ae01876317dda8ecc7a1f18edb15d6dcbf8e0405023e5ab790216dc54e9a
//   h4.2_square_fine_0008.vtkhdf, scene dam_break_2d: 2500 particles, 669 surface
//     sha256 db3da9a66be6f51734a0cc9ff5f85ab080f14d9dd2687ae12c780f6bd7541bea
#ifndef MENISCUS_COEFFICIENTS_520016FDC0568668
#define MENISCUS_COEFFICIENTS_520016FDC0568668

namespace meniscus {

struct Surface2DWidest {
    /// Slope, in neighbors per unit of mass offset
    static constexpr double k = 18.15017519692926;
    /// Neighbors, 0.000341 of them for rounding
    static constexpr double d = 5.937670652475281;
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
    static constexpr double min_bulk_neighbor_count = 8.0;
    /// Largest typical neighbor count inside seen in training
    static constexpr double max_bulk_neighbor_count = 12.0;
    /// Least support radius over particle spacing seen in training
    static constexpr double min_spacing_ratio = 3.015113445777636;
    /// Largest support radius over particle spacing seen in training
    static constexpr double max_spacing_ratio = 4.695742752749557;
    /// For the candidates that the first lets through, in other features
    struct SecondLine {
        /// x and y
        static constexpr const char* features[] = {"mass_offset", "direction_eigenvalue"};
        /// Whether surface lies above the line, else below
        static constexpr bool surface_above = false;
        /// Slope
        static constexpr double k = 7.731404925487566;
        /// Constant, 0.000239 of it for rounding
        static constexpr double d = 2.4065835789478305;
        static constexpr int dimension = 2;
        /// As of the first
        static constexpr double radius_ratio = 0.8;
    };
};

} // namespace meniscus

#endif
