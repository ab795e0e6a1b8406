/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS];
 *   int status = skylight_sh_4_bands_1_5pct_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN defined before it, it
 * declares only; the one unit that also defines SKYLIGHT_SH_4_BANDS_1_5PCT_IMPLEMENTATION holds
 * functions and table, for C and C++.
 *
 * Inputs
 *   sun_zenith: [0, 1.57079633] rad
 *   turbidity: [2.5, 6]
 *   sun_azimuth: any finite angle, rad
 * Output
 *   w[channel][l*(l+1)+m], channels red, green, blue: linear radiance, luminance-scaled cd/m2. Real
 *   orthonormal spherical harmonics without the Condon-Shortley sign, z up, m > 0 cosine, m < 0
 *   sine; the azimuth turns from +x towards +y. Below the horizon: black. Returns 0; 1 where an
 *   input lay outside its range and was clamped; 2 (weights zeroed) where one was NaN or the
 *   azimuth infinite.
 *   The glow about the sun is in the weights, its disc is not: with a disc of your own, add no
 *   halo.
 *   Define SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE before this file (where it holds the table) to
 *   multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 1.39 %, E_max 3.73 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 %
 * of its largest in the same set; the window below tames it.
 * Memory: 3261 bytes of constants, laid out for speed.
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-1.5pct
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN)
#error "Define SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN in every unit, \
SKYLIGHT_SH_4_BANDS_1_5PCT_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_API) && defined(SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN) && \
    !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_DECLARED)
#error "Define SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN before this file is included for the first time."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_DECLARED) && !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN)
#error "Leave SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN defined: this file was included with it before."
#endif

#ifndef SKYLIGHT_SH_4_BANDS_1_5PCT_H
#define SKYLIGHT_SH_4_BANDS_1_5PCT_H 0xf3fb27fa

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN
#define SKYLIGHT_SH_4_BANDS_1_5PCT_API static inline
#else
#define SKYLIGHT_SH_4_BANDS_1_5PCT_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_4_BANDS_1_5PCT_API extern "C"
#else
#define SKYLIGHT_SH_4_BANDS_1_5PCT_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE
#define SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE 1
#endif

#define SKYLIGHT_SH_4_BANDS_1_5PCT_VERSION "0.1.0"
#define SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS 4
#define SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS 16
#define SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS 3
#define SKYLIGHT_SH_4_BANDS_1_5PCT_AXES 2
#define SKYLIGHT_SH_4_BANDS_1_5PCT_UNIT "cd/m2"
#define SKYLIGHT_SH_4_BANDS_1_5PCT_E_MEAN 1.394000e-02
#define SKYLIGHT_SH_4_BANDS_1_5PCT_E_MAX 3.729000e-02
#define SKYLIGHT_SH_4_BANDS_1_5PCT_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_bands(float sun_zenith,
    float sun_azimuth, float turbidity, int bands,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. Suns in a
   row that differ in sun_zenith and azimuth alone cost less. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS]);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_gradient(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_4_bands_1_5pct_dominant(weights, direction) \
    skylight_sh_4_bands_1_5pct_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_dominant_of(const float *weights,
    float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_4_BANDS_1_5PCT_API void skylight_sh_4_bands_1_5pct_ground(const float
    albedo[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS],
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API void skylight_sh_4_bands_1_5pct_window(int bands,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS]);

#elif SKYLIGHT_SH_4_BANDS_1_5PCT_H != 0xf3fb27fa
#error "Another table has the prefix skylight_sh_4_bands_1_5pct_4_bands_1_5pct already: export one \
of them under a prefix of its own."
#endif /* SKYLIGHT_SH_4_BANDS_1_5PCT_H */

#if (!defined(SKYLIGHT_SH_4_BANDS_1_5PCT_EXTERN) || \
    defined(SKYLIGHT_SH_4_BANDS_1_5PCT_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_DEFINED)
#define SKYLIGHT_SH_4_BANDS_1_5PCT_DEFINED

typedef float skylight_sh_4_bands_1_5pct_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST 8
#define SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS 5
#define SKYLIGHT_SH_4_BANDS_1_5PCT_SIZES { 8, 5 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_MOST 8
#define SKYLIGHT_SH_4_BANDS_1_5PCT_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_REFLECTED 0.651470006f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float skylight_sh_4_bands_1_5pct_inside[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_4_bands_1_5pct_real
    skylight_sh_4_bands_1_5pct_range[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][2] = { { 0.0f, 1.57079637f },
    { 2.5f, 6.0f } };

/* Rows, in groups of four; a row's outputs, and those that the first 1, 2,
   .. bands take. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_TERMS 24
#define SKYLIGHT_SH_4_BANDS_1_5PCT_GROUPS 6
#define SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH 32
#define SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTHS { 8, 16, 24, 32 }
/* Of each product of the other axes' functions: how many functions of the
   first axis it has. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LENGTHS { 8, 7, 5, 2, 2 }
/* The same: the first product's rows; of each other that has any, first
   row, rows, place. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LEADING 8
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCTS(PRODUCT) \
    PRODUCT(8, 7, 1) \
    PRODUCT(15, 5, 2) \
    PRODUCT(20, 2, 3) \
    PRODUCT(22, 2, 4)
/* Where a row's outputs go: for each band, by channel, degree, order and
   column. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_STORES(BAND, NOTHING, ZONAL, ONE, FOUR) \
    BAND(0, ZONAL(0, 0, 0) ZONAL(1, 0, 1) ZONAL(2, 0, 2)) \
    BAND(1, ZONAL(0, 1, 3) ONE(0, 1, 1, 4) ZONAL(1, 1, 5) ONE(1, 1, 1, 6) ZONAL(2, 1, 7) ONE(2, 1, \
        1, 8)) \
    BAND(2, ZONAL(0, 2, 9) ONE(0, 2, 1, 10) ONE(0, 2, 2, 11) ZONAL(1, 2, 12) ONE(1, 2, 1, 13) \
        ONE(1, 2, 2, 14) ZONAL(2, 2, 15) ONE(2, 2, 1, 16) ONE(2, 2, 2, 17)) \
    BAND(3, FOUR(0, 3, 0, 20) FOUR(1, 3, 0, 24) FOUR(2, 3, 0, 28))

/* A row a term (functions of the other axes, then of the first): its
   coefficient for every output. */
static const skylight_sh_4_bands_1_5pct_real skylight_sh_4_bands_1_5pct_rows[768] = {
    2.3245585f, 2.6417532f, 3.30502224f, 1.79743505f, 0.926050067f, 2.28847837f, 0.716328144f,
    3.21493578f, 0.589277029f, -0.362805843f, 0.738756299f, 0.515161991f, 0.0128569603f,
    0.635395885f, 0.365124464f, 0.66700995f, 0.642988086f, 0.226039171f, 0.0f, 0.0f, -0.849594235f,
    -0.0538070202f, 0.401888728f, 0.258594871f, -0.827798605f, 0.064735055f, 0.315520644f,
    0.18030858f, -0.725667596f, 0.263733864f, 0.253601909f, 0.0801711082f, 0.332267284f,
    -0.22351265f, -1.26776803f, -0.105144858f, 0.666538835f, -0.534820676f, 0.415922284f,
    -1.45161426f, 0.100236058f, -0.792719364f, 0.336888313f, 0.507736802f, -0.70999527f,
    0.205816627f, 0.322333217f, -0.768761039f, 0.0287743807f, 0.103314757f, 0.0f, 0.0f,
    -0.661804795f, -0.400038481f, 0.305608511f, 0.287852526f, -0.46974051f, -0.2757864f,
    0.203860283f, 0.185512424f, -0.245111704f, -0.137321115f, 0.0894840956f, 0.0422900915f,
    -0.019495368f, -0.0736663342f, -0.333247066f, -0.00406193733f, -0.291700363f, -0.0316278934f,
    -0.301628232f, -0.201272488f, -0.461631417f, 0.0744191408f, -0.371181488f, -0.106929183f,
    0.110275269f, -0.368273616f, -0.12102747f, 0.220864892f, -0.506990075f, -0.198951483f, 0.0f,
    0.0f, 0.176500082f, -0.204519868f, -0.184980512f, -0.0312012434f, 0.213215351f, -0.190873981f,
    -0.181949735f, -0.0441602468f, 0.376476407f, -0.211384058f, -0.229557157f, -0.0811676979f,
    -0.0382090807f, -0.006721735f, -0.00733911991f, 0.0167075396f, -0.0352193117f, 0.0359264612f,
    0.0046569109f, 0.041916728f, 0.0587006807f, 0.100127459f, 0.0464804173f, -0.0926698446f,
    0.083789587f, 0.0784130096f, -0.0622756481f, 0.094479084f, 0.141038537f, -0.0381108522f, 0.0f,
    0.0f, 0.0724301338f, 0.165762305f, -0.051576376f, -0.0720044374f, 0.0509366989f, 0.162017584f,
    -0.0285483599f, -0.0527586937f, 0.0538780689f, 0.191695333f, -0.0056347847f, -0.0324926376f,
    -0.00493824482f, 0.000934839249f, 0.0597273111f, -0.00534939766f, -0.00101840496f,
    -0.00560522079f, 0.00585401058f, 0.0349045992f, 0.035261631f, -0.0153273344f, 0.0127702951f,
    0.00816333294f, -0.0250951052f, 0.0104044676f, 0.0166172981f, -0.0461704731f, 0.0254366398f,
    0.0422213078f, 0.0f, 0.0f, -0.0417531729f, 0.00802218914f, 0.0363726616f, -0.00622153282f,
    -0.0477813482f, -0.0062084198f, 0.0378130674f, 0.00229561329f, -0.0813026428f, -0.0244321823f,
    0.0539788008f, 0.0198680162f, 0.00320124626f, 0.0019261837f, -0.0101442337f, 0.00227129459f,
    0.00313913822f, 0.0012909174f, 0.000693202019f, -0.0132601261f, 2.16960907e-05f,
    -0.000594258308f, -0.00221168995f, 0.00222027302f, 0.00086581707f, -0.00543487072f,
    0.000637173653f, -0.00517392159f, -0.0118317604f, 0.00178420544f, 0.0f, 0.0f, 0.00325274467f,
    -0.0143432617f, -0.0020468235f, 0.00561916828f, 0.00727295876f, -0.0147681236f, -0.00555694103f,
    0.00506079197f, 0.0120162964f, -0.022816658f, -0.0103821754f, 0.00712406635f, 0.00041782856f,
    -8.46385956e-05f, -0.000168800354f, -0.000325083733f, 0.00116348267f, -0.000342965126f,
    0.000658631325f, 0.00110161304f, -0.00364470482f, -0.00075006485f, 0.000652313232f,
    0.000995397568f, 3.81469727e-05f, 0.00101363659f, 0.000192761421f, 0.00367212296f,
    -0.00241923332f, -0.00269436836f, 0.0f, 0.0f, 0.000923633575f, 0.00157344341f, -0.000867962837f,
    0.00034737587f, 0.00122117996f, 0.0034173727f, -0.00104534626f, -0.000480413437f,
    0.00458288193f, 0.0049046278f, -0.00361979008f, -0.00250172615f, 0.00027859211f,
    9.77516174e-05f, -0.000445961952f, 6.53266907e-05f, 0.000153779984f, -5.96046448e-06f,
    -1.01327896e-05f, 0.000304579735f, 8.86917114e-05f, -0.000229716301f, -0.000334739685f,
    0.000349998474f, -0.000203371048f, -0.000267863274f, 0.000189304352f, 0.00107133389f,
    0.00149023533f, -0.000875592232f, 0.0f, 0.0f, -0.000234127045f, -0.000641345978f,
    0.000128149986f, 0.000421285629f, -0.000522613525f, -0.000516653061f, 0.000359416008f,
    0.000215053558f, -0.000398278236f, 0.00262403488f, 0.000567913055f, -0.000948190689f,
    0.700646281f, 0.644542217f, 0.488768935f, 0.700005889f, 0.259045243f, 0.763838887f,
    0.139597535f, 0.746255159f, 0.06554389f, 0.169757605f, 0.260031819f, 0.0943664312f,
    0.395144224f, 0.170866489f, 0.00899171829f, 0.658472061f, 0.112710238f, -0.0196385384f, 0.0f,
    0.0f, -0.150762796f, 0.0744326115f, 0.106487632f, 0.0475478172f, 0.0119931698f, 0.0978732109f,
    0.0361039639f, 0.00643074512f, 0.29581964f, 0.116564274f, 0.000279188156f, -0.0112453699f,
    0.0220346451f, -0.220530391f, -0.345490217f, -0.068607688f, 0.160536766f, -0.272407174f,
    0.0527864695f, -0.456577063f, -0.00197768211f, -0.200545311f, 0.110880017f, 0.073469758f,
    -0.187698364f, 0.0471978188f, -0.0136481524f, -0.337105155f, 9.04798508e-05f, -0.0228362083f,
    0.0f, 0.0f, -0.202273011f, -0.0585625172f, 0.0649405718f, 0.0443601608f, -0.11379683f,
    -0.00854241848f, 0.00293493271f, -0.00169467926f, -0.167936563f, -0.00230467319f, -0.014051199f,
    -0.0113624334f, -0.0560889244f, -0.00914955139f, 0.10131228f, -0.0379132032f, -0.106909394f,
    0.00404191017f, -0.0702894926f, 0.0801875591f, -0.0179213285f, 0.0377140045f, -0.137075067f,
    -0.046407342f, 0.0352630615f, -0.0905905962f, -0.0265444517f, -0.00447034836f, -0.0507493019f,
    0.0163656473f, 0.0f, 0.0f, 0.0860693455f, -0.0842421055f, -0.068097353f, -0.0190422535f,
    0.0575140715f, -0.060854435f, -0.038877964f, -0.0123388767f, -0.00621342659f, -0.0736762285f,
    0.000858426094f, 0.00911331177f, -0.0253715515f, 0.0177789927f, 0.0900348425f, -0.00898742676f,
    -0.0038228035f, 0.0214419365f, 0.0214202404f, 0.0766199827f, 0.0513135195f, 0.0281152725f,
    0.0205564499f, -0.0188339949f, 0.012566328f, 0.0364836454f, 0.00426280499f, -0.00235486031f,
    0.0581936836f, 0.0268287659f, 0.0f, 0.0f, 0.0295869112f, 0.0544577837f, -0.0112794638f,
    -0.0149960518f, 0.0022752285f, 0.0414797068f, 0.0069038868f, -0.000222206116f, -0.0304188728f,
    0.0335640907f, 0.0233360529f, 0.0139859915f, 0.0151354074f, -0.00122702122f, -0.0391942263f,
    0.0114728212f, 0.00765073299f, -0.00585961342f, 0.0034058094f, -0.0391933918f, -0.00968778133f,
    -0.00762653351f, 0.00876176357f, 0.00864803791f, -0.0122613907f, -0.000700235367f,
    0.00737309456f, -0.0121639967f, -0.0164512396f, 0.00013589859f, 0.0f, 0.0f, -0.0212695599f,
    -0.000798106194f, 0.0154573917f, 0.00354075432f, -0.0146731138f, -0.0102003813f, 0.00912737846f,
    0.00507962704f, 0.000176310539f, -0.0171868801f, -0.000972509384f, 0.00166082382f,
    -0.000194430351f, -3.65972519e-05f, -0.00229597092f, -0.00155651569f, 0.0020917654f,
    0.000319242477f, -0.00149226189f, 0.00124084949f, -0.00959920883f, -0.00218570232f,
    -0.00116991997f, 0.00185346603f, 0.00199377537f, -0.00345385075f, -0.00129675865f,
    0.00844871998f, -0.00871920586f, -0.00821626186f, 0.0f, 0.0f, 0.00126099586f, -0.006711483f,
    -0.00125849247f, 0.00279951096f, 0.00522148609f, -0.00389575958f, -0.00418484211f,
    0.000424146652f, 0.011557579f, 9.1791153e-05f, -0.00949370861f, -0.00429058075f,
    -0.000429868698f, -0.000288963318f, 0.00238418579f, -0.000279426575f, -0.000969290733f,
    -6.90221786e-05f, -0.000131487846f, 0.00261592865f, 0.00256955624f, 0.000582098961f,
    -0.000987648964f, -0.000619053841f, 0.000434875488f, 0.000660777092f, -0.00050330162f,
    0.000476956367f, 0.00475370884f, 0.000420570374f, 0.0f, 0.0f, 0.00130808353f, 0.000806093216f,
    -0.00114357471f, -0.000582814217f, 0.000296831131f, 0.00231993198f, -0.00025177002f,
    -0.000793099403f, -0.00234127045f, 0.00505256653f, 0.00227546692f, -0.00088596344f,
    -0.00388562679f, -0.0584714413f, -0.174071193f, -0.00691461563f, 0.00157678127f, -0.0567231178f,
    -0.0184679031f, -0.187121511f, -0.0312360525f, -0.0039331913f, -0.00344371796f, -0.00868177414f,
    -0.00433671474f, -0.0221066475f, -0.0196133852f, -0.0581848621f, -0.0405697823f, -0.0163234472f,
    0.0f, 0.0f, 0.00522339344f, -0.00696051121f, -0.00941765308f, -0.00306427479f, 0.0330576897f,
    -0.00997757912f, -0.0208183527f, -0.00812935829f, 0.0521473885f, -0.0243250132f, -0.0218787193f,
    -0.00608062744f, 0.00819015503f, -0.00880730152f, 0.0592101812f, 0.0120797157f, 0.00857818127f,
    0.00393807888f, -0.00387740135f, 0.0757216215f, 0.00135350227f, 0.012902379f, 0.00696074963f,
    -0.00748491287f, 0.0262460709f, 0.000937104225f, -0.0162568092f, 0.0507367849f, 0.00640594959f,
    -0.00682544708f, 0.0f, 0.0f, 0.0123289824f, 0.00171470642f, -0.00683176517f, -0.0023753643f,
    0.0274472237f, 0.0106110573f, -0.0138566494f, -0.00733363628f, 0.0190219879f, 0.0135304928f,
    -0.00710999966f, -0.00290107727f, -0.0112692118f, 0.0053858757f, 0.0363465548f, -0.0130372047f,
    0.00499010086f, 0.00297021866f, 0.0154610872f, 0.0326957703f, 0.033020854f, -0.00721490383f,
    0.0066639185f, 0.00265431404f, -0.00598990917f, 0.020652771f, 0.00816583633f, -0.003510952f,
    0.0412524939f, 0.0159865618f, 0.0f, 0.0f, -0.00286662579f, 0.00365722179f, 0.00393462181f,
    0.00175654888f, -0.0123800039f, 0.0125033855f, 0.01179111f, 0.00382697582f, -0.0291273594f,
    0.0226532221f, 0.0215810537f, 0.00695705414f, -0.00422775745f, 0.00203371048f, 0.00429093838f,
    -0.00501596928f, -0.00213932991f, -0.000246405602f, 0.000151634216f, 0.00308513641f,
    -0.00357568264f, -0.00266861916f, -0.00348293781f, 0.00100052357f, -0.00429654121f,
    -0.00366699696f, 0.00365209579f, -0.0018197298f, -0.00944316387f, 0.00228905678f, 0.0f, 0.0f,
    8.42809677e-05f, -0.00392329693f, 0.000245690346f, 0.00117599964f, -0.00361502171f,
    -0.0087171793f, 0.00213587284f, 0.00296747684f, -0.00321829319f, -0.0142083168f,
    0.000463366508f, 0.00226378441f, 0.00278759003f, -0.00114142895f, -0.00784993172f,
    0.00339639187f, 0.000489115715f, -0.000734806061f, -0.00117754936f, -0.00788891315f,
    -0.00430774689f, 0.00218153f, 0.00079202652f, -0.000430822372f, 0.00121045113f, -0.00141465664f,
    -0.00156271458f, -0.000822305679f, -0.00438690186f, -0.00398588181f, 0.0f, 0.0f, 0.00104320049f,
    0.00119042397f, -0.00070810318f, -0.000365495682f, 0.00295555592f, 0.000188946724f,
    -0.00274550915f, -0.000693440437f, 0.00535202026f, 0.000148415565f, -0.00544047356f,
    -0.00225687027f, 0.00978624821f, 0.0056180954f, 0.000553488731f, 0.0058618784f, 0.00480878353f,
    0.00119924545f, 0.00135159492f, -0.00668668747f, 0.00101804733f, -0.0056040287f, 0.00295329094f,
    0.00109624863f, -0.00783014297f, -8.60691071e-05f, -0.000214338303f, -0.0161247253f,
    -0.000721096992f, 0.00110542774f, 0.0f, 0.0f, -0.00744366646f, -0.00232219696f, 0.000640630722f,
    0.000709891319f, -0.00771188736f, -0.00255417824f, -0.000618338585f, 3.80277634e-05f,
    -0.0141569376f, -0.00372886658f, 0.000618934631f, 0.000542283058f, 0.00368058681f,
    5.4359436e-05f, 0.00405073166f, 0.00276398659f, 0.00438427925f, 0.00117623806f, 0.00206494331f,
    0.00755262375f, 0.00142407417f, -0.00066280365f, 0.00317144394f, 0.0011664629f, 0.00265085697f,
    0.00187408924f, 0.000192523003f, 0.00905406475f, 0.0022251606f, 0.000535011292f, 0.0f, 0.0f,
    -0.000981211662f, -0.000988483429f, 0.000833034515f, 0.000933527946f, 0.00284874439f,
    0.000294804573f, 0.000138998032f, 0.00023317337f, 0.00688862801f, 0.0023458004f,
    0.000671982765f, 0.000172257423f, 0.00196051598f, 0.00110316277f, 0.00068461895f,
    0.00188171864f, 0.000730156898f, 0.001126647f, 0.000107884407f, 0.000916004181f,
    0.000236153603f, 0.000231027603f, 0.000655293465f, 2.38418579e-07f, 0.000128865242f,
    0.000198960304f, -0.000197291374f, 0.000303864479f, 0.000305652618f, 0.000159621239f, 0.0f,
    0.0f, -0.000804901123f, -6.31809235e-06f, 8.01086426e-05f, 2.25305557e-05f, -0.000830054283f,
    0.000151157379f, -3.34978104e-05f, -9.39369202e-05f, -0.000903367996f, 8.34465027e-05f,
    0.00029528141f, 6.15119934e-05f, 0.000195741653f, -0.000536799431f, 0.000541210175f,
    0.000187754631f, 0.000527501106f, -0.000261187553f, -4.76837158e-06f, 0.000660538673f,
    0.000113368034f, 2.47955322e-05f, 0.000462889671f, -4.25577164e-05f, 0.000453591347f,
    6.74724579e-05f, -0.000295042992f, 0.000514745712f, 0.000207304955f, -3.31401825e-05f, 0.0f,
    0.0f, -7.21216202e-05f, 1.43051147e-05f, 3.36170197e-05f, 2.57492065e-05f, 0.000593066216f,
    0.000126600266f, -0.000177502632f, -0.000169992447f, 0.000524401665f, 0.000271439552f,
    -1.2755394e-05f, -4.11272049e-05f
};

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_4_bands_1_5pct_real skylight_sh_4_bands_1_5pct_scale(const
    skylight_sh_4_bands_1_5pct_real *x)
{
    const float chi = (0.444444448f - x[1] * 0.00833333377f) * (3.14159274f - 2.0f * x[0]);
    const float square = chi * chi;
    const float tan_above = chi * (105.0f - 10.0f * square);
    const float tan_below = 105.0f - square * (45.0f - square);
    const float zenith = (4.04530001f * x[1] - 4.97100019f) * tan_above + (2.41919994f -
        0.215499997f * x[1]) * tan_below;
    const float a = 0.1787f * x[1] + (-1.46300006f);
    const float b = (-0.355399996f) * x[1] + 0.42750001f;
    const float up = 1.0f + b * (0.25f + b * 0.03125f);
    const float up2 = up * up;
    const float up4 = up2 * up2;
    const float c = (-0.0227000006f) * x[1] + 5.32509995f;
    const float d = 0.1206f * x[1] + (-2.57710004f);
    const float y = d * x[0];
    const float halo = 1.0f + y * (0.125f + y * 0.0078125f);
    const float halo2 = halo * halo;
    const float halo4 = halo2 * halo2;
    const float halo8 = halo4 * halo4;
    const float e = (-0.0670000017f) * x[1] + 0.370299995f;
    const float z = x[0] * x[0];
    const float cosine = 1.0f - z * (0.5f - z * (0.0416666679f - z * 0.00138888892f));
    return 1000.0f * zenith / (tan_below * (1.0f + a * up4) * (1.0f + c * halo8 + e * (cosine *
        cosine)));
}

/* The functions of sun_zenith (change of variable: reciprocal); 0 where
   there is none. */
static inline void skylight_sh_4_bands_1_5pct_first(const skylight_sh_4_bands_1_5pct_real *x,
    skylight_sh_4_bands_1_5pct_real *out)
{
    out[0] = 1.0f;
    out[1] = 4.36619759f * (x[0] - 0.0f) / (5.0f - x[0]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    out[7] = 2.0f * out[3] * out[4] - out[1];
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_4_bands_1_5pct_others(const skylight_sh_4_bands_1_5pct_real *x,
    skylight_sh_4_bands_1_5pct_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.57142878f) * (x[1] - 2.5f) / ((-2.0f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling. */
static inline void skylight_sh_4_bands_1_5pct_waves(skylight_sh_4_bands_1_5pct_real azimuth,
    skylight_sh_4_bands_1_5pct_real *cosines, skylight_sh_4_bands_1_5pct_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = cosf(azimuth);
    sines[1] = sinf(azimuth);
    cosines[2] = cosines[1] * cosines[1] - sines[1] * sines[1];
    sines[2] = sines[1] * cosines[1] + cosines[1] * sines[1];
    cosines[3] = cosines[1] * cosines[2] - sines[1] * sines[2];
    sines[0] = 0.0f;
    sines[3] = sines[1] * cosines[2] + cosines[1] * sines[2];
}

/* The zonal window's factor for the degree `share` * bands (Habel et al.
   2008, eq. 5). */
static inline float skylight_sh_4_bands_1_5pct_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double skylight_sh_4_bands_1_5pct_slope_range[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][2] = { {
    0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_4_bands_1_5pct_functions(int axis, double v, double *out,
    double *slopes)
{
    if (axis == 0) {
        out[0] = 1.0;
        const double part_1 = 5.0 - v;
        const double part_2 = 4.366197723675814 * (v - 0.0) / part_1;
        out[1] = part_2 - 1.0;
        const double part_3 = 2.0 * out[1];
        out[2] = part_3 * out[1] - 1.0;
        const double part_4 = 2.0 * out[1];
        out[3] = part_4 * out[2] - out[1];
        const double part_5 = 2.0 * out[2];
        out[4] = part_5 * out[2] - 1.0;
        const double part_6 = 2.0 * out[2];
        out[5] = part_6 * out[3] - out[1];
        const double part_7 = 2.0 * out[3];
        out[6] = part_7 * out[3] - 1.0;
        const double part_8 = 2.0 * out[3];
        out[7] = part_8 * out[4] - out[1];
        slopes[0] = 0.0;
        slopes[1] = 4.366197723675814 / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
        slopes[7] = 2.0 * slopes[3] * out[4] + part_8 * slopes[4] - slopes[1];
    }
    if (axis == 1) {
        out[0] = 1.0;
        const double part_1 = (-2.0) - v;
        const double part_2 = (-4.5714285714285712) * (v - 2.5) / part_1;
        out[1] = part_2 - 1.0;
        const double part_3 = 2.0 * out[1];
        out[2] = part_3 * out[1] - 1.0;
        const double part_4 = 2.0 * out[1];
        out[3] = part_4 * out[2] - out[1];
        const double part_5 = 2.0 * out[2];
        out[4] = part_5 * out[2] - 1.0;
        slopes[0] = 0.0;
        slopes[1] = (-4.5714285714285712) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
    }
    (void)v;
}

/* What all weights share, then its slopes after the axes. */
static inline void skylight_sh_4_bands_1_5pct_scale_slopes(const double *x, double *out)
{
    const double part_1 = 4.0453000000000001 * x[1] - 4.9710000000000001;
    const double part_2 = 0.44444444444444442 - x[1] * 0.0083333333333333332;
    const double part_3 = 3.1415926535897931 - 2.0 * x[0];
    const double chi = part_2 * part_3;
    const double square = chi * chi;
    const double part_4 = 105.0 - 10.0 * square;
    const double tan_above = chi * part_4;
    const double part_5 = 2.4192 - 0.2155 * x[1];
    const double part_6 = 45.0 - square;
    const double tan_below = 105.0 - square * part_6;
    const double zenith = part_1 * tan_above + part_5 * tan_below;
    const double a = 0.1787 * x[1] + (-1.4630000000000001);
    const double b = (-0.35539999999999999) * x[1] + 0.42749999999999999;
    const double part_7 = 0.25 + b * 0.03125;
    const double up = 1.0 + b * part_7;
    const double up2 = up * up;
    const double up4 = up2 * up2;
    const double part_8 = 1.0 + a * up4;
    const double part_9 = tan_below * part_8;
    const double c = (-0.022700000000000001) * x[1] + 5.3250999999999999;
    const double d = 0.1206 * x[1] + (-2.5771000000000002);
    const double y = d * x[0];
    const double part_10 = 0.125 + y * 0.0078125;
    const double halo = 1.0 + y * part_10;
    const double halo2 = halo * halo;
    const double halo4 = halo2 * halo2;
    const double halo8 = halo4 * halo4;
    const double e = (-0.067000000000000004) * x[1] + 0.37030000000000002;
    const double z = x[0] * x[0];
    const double part_11 = 0.041666666666666664 - z * 0.0013888888888888889;
    const double part_12 = 0.5 - z * part_11;
    const double cosine = 1.0 - z * part_12;
    const double part_13 = cosine * cosine;
    const double part_14 = 1.0 + c * halo8 + e * part_13;
    const double part_15 = part_9 * part_14;
    out[0] = 1000.0 * zenith / part_15;
    const double part_16 = part_2 * -2.0;
    const double part_17 = part_16 * chi + chi * part_16;
    const double part_18 = -(part_17 * part_6 + square * -part_17);
    const double part_19 = d * part_10 + y * (d * 0.0078125);
    const double part_20 = part_19 * halo + halo * part_19;
    const double part_21 = part_20 * halo2 + halo2 * part_20;
    const double part_22 = x[0] + x[0];
    const double part_23 = -(part_22 * part_12 + z * -(part_22 * part_11 + z * -(part_22 *
        0.0013888888888888889)));
    out[1] = 1000.0 * (part_1 * (part_16 * part_4 + chi * -(10.0 * part_17)) + part_5 * part_18) /
        part_15 - out[0] * (part_18 * part_8 * part_14 + part_9 * (c * (part_21 * halo4 + halo4 *
        part_21) + e * (part_23 * cosine + cosine * part_23))) / part_15;
    const double part_24 = -0.0083333333333333332 * part_3;
    const double part_25 = part_24 * chi + chi * part_24;
    const double part_26 = -(part_25 * part_6 + square * -part_25);
    const double part_27 = (-0.35539999999999999) * part_7 + b * ((-0.35539999999999999) * 0.03125);
    const double part_28 = part_27 * up + up * part_27;
    const double part_29 = 0.1206 * x[0];
    const double part_30 = part_29 * part_10 + y * (part_29 * 0.0078125);
    const double part_31 = part_30 * halo + halo * part_30;
    const double part_32 = part_31 * halo2 + halo2 * part_31;
    out[2] = 1000.0 * (4.0453000000000001 * tan_above + part_1 * (part_24 * part_4 + chi * -(10.0 *
        part_25)) + (-0.2155 * tan_below + part_5 * part_26)) / part_15 - out[0] * ((part_26 *
        part_8 + tan_below * (0.1787 * up4 + a * (part_28 * up2 + up2 * part_28))) * part_14 +
        part_9 * ((-0.022700000000000001) * halo8 + c * (part_32 * halo4 + halo4 * part_32) +
        (-0.067000000000000004) * part_13)) / part_15;
    (void)x;
}

/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot
   remove the test. */
static inline int skylight_sh_4_bands_1_5pct_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_4_bands_1_5pct_finite(float v)
{
    if (skylight_sh_4_bands_1_5pct_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_4_bands_1_5pct_inputs(const float
    inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES], float azimuth,
                                     skylight_sh_4_bands_1_5pct_real
                                         x[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES])
{
    int axis, status = 0, strange = skylight_sh_4_bands_1_5pct_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) strange |=
        skylight_sh_4_bands_1_5pct_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) {
        const float v = skylight_sh_4_bands_1_5pct_finite(inputs[axis]);
        const skylight_sh_4_bands_1_5pct_real low = skylight_sh_4_bands_1_5pct_range[axis][0],
            high = skylight_sh_4_bands_1_5pct_range[axis][1];
        const skylight_sh_4_bands_1_5pct_real at_least = (skylight_sh_4_bands_1_5pct_real)v < low ?
            low : (skylight_sh_4_bands_1_5pct_real)v;
        status |= (v < skylight_sh_4_bands_1_5pct_inside[axis][0]) | (v >
            skylight_sh_4_bands_1_5pct_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_4_bands_1_5pct_place(skylight_sh_4_bands_1_5pct_real value, int l,
    int m,
                                     const skylight_sh_4_bands_1_5pct_real *cosines,
                                         const skylight_sh_4_bands_1_5pct_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* sums[k] = sum over t of products[t] * row[t][k] for 4 * groups terms, four rows a pass: no
   reduction, so that it vectorises. */
static inline void skylight_sh_4_bands_1_5pct_sum(const skylight_sh_4_bands_1_5pct_real *row,
    int groups,
                                   const skylight_sh_4_bands_1_5pct_real *products, int width,
                                   skylight_sh_4_bands_1_5pct_real *sums)
{
    int group, k;
    {
        const skylight_sh_4_bands_1_5pct_real a = products[0], b = products[1], c = products[2],
            d = products[3];
        for (k = 0; k < width; ++k)
            sums[k] = (a * row[k] + b * row[k + SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH]) +
                      (c * row[k + 2 * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH] + d * row[k + 3 *
                          SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH]);
    }
    for (group = 1; group < groups; ++group) {
        const skylight_sh_4_bands_1_5pct_real a = products[4 * group], b = products[4 * group + 1];
        const skylight_sh_4_bands_1_5pct_real c = products[4 * group + 2],
            d = products[4 * group + 3];
        row += 4 * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
        for (k = 0; k < width; ++k)
            sums[k] += (a * row[k] + b * row[k + SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH]) +
                       (c * row[k + 2 * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH] + d * row[k + 3 *
                           SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH]);
    }
}

/* Zeroes what carries nothing. */
static inline void skylight_sh_4_bands_1_5pct_clear(float *weights, int count)
{
    int i;
    for (i = 0; i < count; ++i) weights[i] = 0.0f;
}

/* Four orders m of one degree and channel: m >= 0 forwards, m < 0 backwards (eq. 4 with nothing
   stored for m < 0). */
static inline void skylight_sh_4_bands_1_5pct_place_four(const skylight_sh_4_bands_1_5pct_real
    *sums,
                                          const skylight_sh_4_bands_1_5pct_real *cosines,
                                          const skylight_sh_4_bands_1_5pct_real *sines, float *plus,
                                              float *minus)
{
    float forwards[4], backwards[4];
    int k;
    for (k = 0; k < 4; ++k) backwards[k] = (float)(sums[3 - k] * sines[3 - k]);
    for (k = 0; k < 4; ++k) forwards[k] = (float)(sums[k] * cosines[k]);
    for (k = 0; k < 4; ++k) minus[k] = backwards[k];
    for (k = 0; k < 4; ++k) plus[k] = forwards[k];
}

/* Stores the first `bands` bands of the sums in the order of the weights, turned by the azimuth. */
static inline void skylight_sh_4_bands_1_5pct_store(const skylight_sh_4_bands_1_5pct_real *sums,
    const skylight_sh_4_bands_1_5pct_real *cosines,
                                     const skylight_sh_4_bands_1_5pct_real *sines, int bands,
                                     float
                                         weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
                                         [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
#define SKYLIGHT_SH_4_BANDS_1_5PCT_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING(channel, l) \
    skylight_sh_4_bands_1_5pct_clear(weights[channel] + (l) * (l), 2 * (l) + 1);
#define SKYLIGHT_SH_4_BANDS_1_5PCT_ZONAL(channel, l, column) \
    weights[channel][(l) * ((l) + 1)] = (float)sums[column];
#define SKYLIGHT_SH_4_BANDS_1_5PCT_ONE(channel, l, m, column) \
    weights[channel][(l) * ((l) + 1) - (m)] = (float)(sums[column] * sines[m]); \
    weights[channel][(l) * ((l) + 1) + (m)] = (float)(sums[column] * cosines[m]);
#define SKYLIGHT_SH_4_BANDS_1_5PCT_FOUR(channel, l, m, column) \
    skylight_sh_4_bands_1_5pct_place_four(sums + (column), cosines + (m), sines + (m), \
                           weights[channel] + (l) * ((l) + 1) + (m), \
                           weights[channel] + (l) * ((l) + 1) - (m) - 3);
    SKYLIGHT_SH_4_BANDS_1_5PCT_STORES(SKYLIGHT_SH_4_BANDS_1_5PCT_BAND,
        SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_4_BANDS_1_5PCT_ZONAL,
        SKYLIGHT_SH_4_BANDS_1_5PCT_ONE,
                       SKYLIGHT_SH_4_BANDS_1_5PCT_FOUR)
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_BAND
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_ZONAL
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_ONE
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_FOUR
    (void)cosines;
    (void)sines;
}

/* Sums the table's terms and stores the first `bands` bands. */
static inline void skylight_sh_4_bands_1_5pct_combine(const skylight_sh_4_bands_1_5pct_real *first,
                                       const skylight_sh_4_bands_1_5pct_real *others,
                                       const skylight_sh_4_bands_1_5pct_real *cosines,
                                       const skylight_sh_4_bands_1_5pct_real *sines, int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    static const unsigned short widths[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTHS;
    skylight_sh_4_bands_1_5pct_real products[4 * SKYLIGHT_SH_4_BANDS_1_5PCT_GROUPS + 8],
        sums[SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
    int i;
    /* In fours: each overshoot is overwritten by the next line. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCT(start, count, other) \
    for (i = 0; i < ((count) + 3) / 4 * 4; ++i) products[(start) + i] = first[i] * others[other];
    SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCT(0, SKYLIGHT_SH_4_BANDS_1_5PCT_LEADING, 0)
    SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCTS(SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCT)
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCT
    /* A last group of four may have rows of zeros. */
    for (i = SKYLIGHT_SH_4_BANDS_1_5PCT_TERMS; i < 4 * SKYLIGHT_SH_4_BANDS_1_5PCT_GROUPS; ++i)
        products[i] = 0;
    if (bands == SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS)
        skylight_sh_4_bands_1_5pct_sum(skylight_sh_4_bands_1_5pct_rows,
            SKYLIGHT_SH_4_BANDS_1_5PCT_GROUPS, products, SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH, sums);
    else
        skylight_sh_4_bands_1_5pct_sum(skylight_sh_4_bands_1_5pct_rows,
            SKYLIGHT_SH_4_BANDS_1_5PCT_GROUPS, products, widths[bands - 1], sums);
    skylight_sh_4_bands_1_5pct_store(sums, cosines, sines, bands, weights);
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_1_5pct_combine_double(
    const double *first, const double *others, const skylight_sh_4_bands_1_5pct_real *cosines,
    const skylight_sh_4_bands_1_5pct_real *sines,
        float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    static const unsigned char lengths[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_LENGTHS;
    const skylight_sh_4_bands_1_5pct_real *row = skylight_sh_4_bands_1_5pct_rows;
    double exact[SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
    skylight_sh_4_bands_1_5pct_real sums[SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
    int i, k, other;
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++k) exact[k] = 0.0;
    for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS; ++other) {
        for (i = 0; i < lengths[other]; ++i) {
            const double product = first[i] * others[other];
            for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++k) exact[k] += product *
                (double)row[k];
            row += SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
        }
    }
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++k) sums[k] =
        (skylight_sh_4_bands_1_5pct_real)exact[k];
    skylight_sh_4_bands_1_5pct_store(sums, cosines, sines, SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS,
        weights);
}

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_4_bands_1_5pct_finish(int bands, int lights,
    const skylight_sh_4_bands_1_5pct_real *cosines,
                                      const skylight_sh_4_bands_1_5pct_real *sines,
                                      float
                                          weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
                                          [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    if (bands < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS; ++i) weights[channel][i]
                = 0.0f;
    }
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, clamped like an input)
 * and zeroes the
   rest; returns the status. */
static inline int skylight_sh_4_bands_1_5pct_evaluate(const float
    inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES], float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    skylight_sh_4_bands_1_5pct_real x[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
        first[SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST], others[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS];
    skylight_sh_4_bands_1_5pct_real cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS], scale;
    int i, status = skylight_sh_4_bands_1_5pct_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS *
            SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS;
        status = 1;
    }
    scale = skylight_sh_4_bands_1_5pct_scale(x) *
        (skylight_sh_4_bands_1_5pct_real)SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE;
    skylight_sh_4_bands_1_5pct_first(x, first);
    skylight_sh_4_bands_1_5pct_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS; ++i) others[i] *= scale;
    skylight_sh_4_bands_1_5pct_waves((skylight_sh_4_bands_1_5pct_real)azimuth, cosines, sines);
    skylight_sh_4_bands_1_5pct_combine(first, others, cosines, sines, bands, weights);
    skylight_sh_4_bands_1_5pct_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_4_bands_1_5pct_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES], const float *azimuths,
    float (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    int s, axis, worst = 0;
    /* The rows summed over the other axes once, for all suns in a row that share them. */
    skylight_sh_4_bands_1_5pct_real line[SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST *
        SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH], shared[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES];
    int ready = 0;
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_4_BANDS_1_5PCT_AZIMUTH;
        float sun[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES];
        int status;
        skylight_sh_4_bands_1_5pct_real x[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
            first[SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST], sums[SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
        skylight_sh_4_bands_1_5pct_real cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS],
            sines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS], scale;
        int i;
        for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) sun[axis] = inputs[axis][s];
        status = skylight_sh_4_bands_1_5pct_inputs(sun, azimuth, x);
        worst = status > worst ? status : worst;
        if (status == 2) {
            memset(weights[s], 0, sizeof weights[s]);
            continue;
        }
        ready = ready && !memcmp(x + 1, shared + 1,
            sizeof *x * (SKYLIGHT_SH_4_BANDS_1_5PCT_AXES - 1));
        if (!ready) {
            skylight_sh_4_bands_1_5pct_real others[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS];
            skylight_sh_4_bands_1_5pct_others(x, others);
            for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_LEADING * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
                ++i)
                line[i] = others[0] * skylight_sh_4_bands_1_5pct_rows[i];
            for (; i < SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++i)
                line[i] = 0;
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCT(start, count, other) \
    for (i = 0; i < (count) * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++i) \
        line[i] += others[other] * skylight_sh_4_bands_1_5pct_rows[(start) * \
            SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH + i];
            SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCTS(SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCT)
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCT
            memcpy(shared, x, sizeof shared);
            ready = 1;
        }
        scale = skylight_sh_4_bands_1_5pct_scale(x) *
            (skylight_sh_4_bands_1_5pct_real)SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE;
        skylight_sh_4_bands_1_5pct_first(x, first);
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST; ++i) first[i] *= scale;
        skylight_sh_4_bands_1_5pct_waves((skylight_sh_4_bands_1_5pct_real)azimuth, cosines, sines);
        skylight_sh_4_bands_1_5pct_sum(line, SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST / 4, first,
            SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH, sums);
        skylight_sh_4_bands_1_5pct_store(sums, cosines, sines, SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS,
            weights[s]);
        skylight_sh_4_bands_1_5pct_finish(SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, 1, cosines, sines,
            weights[s]);
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_4_bands_1_5pct_multiply(double *products, int count,
    const double *functions,
                                       int size)
{
    int i, k;
    for (k = count - 1; k >= 0; --k) {
        const double product = products[k];
        for (i = size - 1; i >= 0; --i) products[k * size + i] = product * functions[i];
    }
    return count * size;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_4_bands_1_5pct_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES], float azimuth,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = SKYLIGHT_SH_4_BANDS_1_5PCT_SIZES;
    double x[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
        functions[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_MOST];
    double slopes[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_MOST],
        scale[1 + SKYLIGHT_SH_4_BANDS_1_5PCT_AXES];
    skylight_sh_4_bands_1_5pct_real cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS];
    int axis, other, i;
    const int status = skylight_sh_4_bands_1_5pct_evaluate(inputs, azimuth,
        SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_4_BANDS_1_5PCT_AXES * SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS
                   * SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) {
        const double low = skylight_sh_4_bands_1_5pct_slope_range[axis][0];
        const double high = skylight_sh_4_bands_1_5pct_slope_range[axis][1];
        const double v = (double)skylight_sh_4_bands_1_5pct_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_4_bands_1_5pct_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_4_bands_1_5pct_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++i) scale[i] *=
        (double)SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE;
    skylight_sh_4_bands_1_5pct_waves((skylight_sh_4_bands_1_5pct_real)azimuth, cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) {
        double first[SKYLIGHT_SH_4_BANDS_1_5PCT_MOST], others[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++other) {
            double one[SKYLIGHT_SH_4_BANDS_1_5PCT_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_4_bands_1_5pct_multiply(others, count, one,
                sizes[other]);
        }
        skylight_sh_4_bands_1_5pct_combine_double(first, others, cosines, sines, gradient[axis]);
        skylight_sh_4_bands_1_5pct_finish(SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, 0, cosines, sines,
            gradient[axis]);
    }
    return status;
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate(skylight_sh_4_bands_1_5pct_given, sun_azimuth,
        SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_bands(float sun_zenith,
    float sun_azimuth, float turbidity, int bands,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate(skylight_sh_4_bands_1_5pct_given, sun_azimuth, bands,
        weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    const float *const skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate_batch(count, skylight_sh_4_bands_1_5pct_given,
        sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_gradient(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate_gradient(skylight_sh_4_bands_1_5pct_given,
        sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_dominant_of(const float *weights,
    float direction[3])
{
    static const float luminance[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS + 1;
        x += luminance[channel] * linear[2];
        y += luminance[channel] * linear[0];
        z += luminance[channel] * linear[1];
    }
    length = sqrtf(x * x + y * y + z * z);
    direction[0] = length > 0.0f ? x / length : 0.0f;
    direction[1] = length > 0.0f ? y / length : 0.0f;
    direction[2] = length > 0.0f ? z / length : 1.0f;
    return !(length > 0.0f);
}

/* Adds an even ground of this albedo below the horizon, lit by the sky (before any window): its
   radiance is albedo E / pi, and E, the irradiance on it, a multiple of the weight l = 1, m = 0. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API void skylight_sh_4_bands_1_5pct_ground(
    const float albedo[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS],
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS] = SKYLIGHT_SH_4_BANDS_1_5PCT_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_4_BANDS_1_5PCT_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++l) weights[channel][l * (l + 1)] +=
            radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_4_BANDS_1_5PCT_API void skylight_sh_4_bands_1_5pct_window(
    int bands, float
        weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++l) {
        const float factor = skylight_sh_4_bands_1_5pct_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_4_BANDS_1_5PCT_DEFINED */
