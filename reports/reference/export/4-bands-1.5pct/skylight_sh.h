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
 * Accuracy, as shipped: E_mean 1.45 %, E_max 4.08 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 %
 * of its largest in the same set; the window below tames it.
 * Memory: 1492 bytes of constants, laid out for speed.
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 08540d17388f71b0, table 4-bands-1.5pct
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
#define SKYLIGHT_SH_4_BANDS_1_5PCT_H 0xa138fdfa

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
#define SKYLIGHT_SH_4_BANDS_1_5PCT_E_MEAN 1.453000e-02
#define SKYLIGHT_SH_4_BANDS_1_5PCT_E_MAX 4.085000e-02
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
/* Evaluates `count` suns from arrays; returns the largest status. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS]);
/* The same with the suns of each weight side by side:
   [SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS][count]. */
SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_columns(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity, float *weights);
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

#elif SKYLIGHT_SH_4_BANDS_1_5PCT_H != 0xa138fdfa
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
#define SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST 4
#define SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS 4
#define SKYLIGHT_SH_4_BANDS_1_5PCT_SIZES { 4, 4 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_MOST 4
#define SKYLIGHT_SH_4_BANDS_1_5PCT_AZIMUTH 0.0f
/* The axis of the sun's zenith angle. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_SUN 0
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

/* Classes; a row's numbers, one a sum, and those of the first 1, 2, ..
   bands; room for a class's sums. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES 3
#define SKYLIGHT_SH_4_BANDS_1_5PCT_OTHER_CLASSES(CLASS) CLASS(1) CLASS(2)
#define SKYLIGHT_SH_4_BANDS_1_5PCT_FACTORS 9
#define SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH 10
#define SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTHS { 1, 3, 6, 10 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_ROOM 16
/* All rows; of each class the first row, how many, and the place of its
   first product. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_TERMS 28
#define SKYLIGHT_SH_4_BANDS_1_5PCT_STARTS { 0, 12, 19 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_COUNTS { 12, 7, 9 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PLACES { 0, 12, 20 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCTS_ROOM 36
/* Of each class and product of the other axes' functions: how many
   functions of the first axis it has. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LENGTHS { { 4, 4, 3, 1 }, { 3, 3, 1, 0 }, { 4, 3, 1, 1 } }
/* The same: of each that has any, class, place of the first product, how
   many, the other axes' product. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PRODUCTS(PRODUCT) \
    PRODUCT(0, 0, 4, 0) \
    PRODUCT(0, 4, 4, 1) \
    PRODUCT(0, 8, 3, 2) \
    PRODUCT(0, 11, 1, 3) \
    PRODUCT(1, 12, 3, 0) \
    PRODUCT(1, 15, 3, 1) \
    PRODUCT(1, 18, 1, 2) \
    PRODUCT(2, 20, 4, 0) \
    PRODUCT(2, 24, 3, 1) \
    PRODUCT(2, 27, 1, 2) \
    PRODUCT(2, 28, 1, 3)
/* The same: of each class the first row of each polynomial, its rows, the
   other axes' product. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIALS(CLASS, NOTHING, POLYNOMIAL) \
    CLASS(0, NOTHING POLYNOMIAL(0, 4, 0) POLYNOMIAL(4, 4, 1) POLYNOMIAL(8, 3, 2) POLYNOMIAL(11, 1, \
        3)) \
    CLASS(1, NOTHING POLYNOMIAL(12, 3, 0) POLYNOMIAL(15, 3, 1) POLYNOMIAL(18, 1, 2)) \
    CLASS(2, NOTHING POLYNOMIAL(19, 4, 0) POLYNOMIAL(23, 3, 1) POLYNOMIAL(26, 1, 2) POLYNOMIAL(27, \
        1, 3))
/* Where sums go: of each degree, the first column, or -1 where it carries
   nothing. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_COLUMNS { 0, 1, 3, 6 }
/* The same for vectors of four: places, two vectors of sums and the numbers
   of both, order. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_FOURS 3
#define SKYLIGHT_SH_4_BANDS_1_5PCT_STORES(BAND, NOTHING, MINUS, PLUS) \
    BAND(0, PLUS(0, 0, 0, 0, 1, 2, 3, 0)) \
    BAND(1, MINUS(1, 0, 0, 2, 1, 0, 0, 1) PLUS(2, 0, 1, 1, 2, 3, 4, 0)) \
    BAND(2, MINUS(4, 0, 1, 5, 4, 3, 2, 2) PLUS(6, 0, 1, 3, 4, 5, 6, 0)) \
    BAND(3, MINUS(9, 1, 2, 5, 4, 3, 2, 3) PLUS(12, 1, 2, 2, 3, 4, 5, 0))

/* Of each class, a row a term (functions of the other axes, then of the
   first): its number for every sum. */
static const skylight_sh_4_bands_1_5pct_real skylight_sh_4_bands_1_5pct_rows[286] = {
    2.71036887f, 2.21448374f, 1.31027937f, -0.310139179f, 1.19046283f, 0.829240799f, -1.20676076f,
    0.110528708f, 0.796098113f, 0.464569449f, -0.214407682f, -0.536228776f, -0.262592554f,
    -0.661141038f, -0.695368886f, -0.125739813f, -0.250524163f, -0.864032984f, -0.482918859f,
    -0.063446641f, -0.12364006f, 0.0491325855f, -0.143055916f, 0.406592131f, 0.0468857288f,
    -0.107987404f, 0.543285131f, 0.474843264f, 0.0244641304f, -0.0768451691f, -0.0109963417f,
    0.0244078636f, -0.0203537941f, 0.000539779663f, 0.0382456779f, -0.026260376f, -0.18768692f,
    0.00107431412f, 0.0365800858f, -0.0291938782f, 0.593055725f, 0.680009007f, 0.252006173f,
    0.301952958f, 0.294134378f, 0.0665383339f, -0.0717055798f, 0.142194271f, 0.116286755f,
    0.0439218283f, -0.177490115f, -0.225158453f, -0.122981787f, -0.145694375f, -0.197974324f,
    -0.0891722441f, -0.0388871431f, -0.192261934f, -0.143307209f, -0.0565336943f, 0.0151786804f,
    0.0531821251f, 0.0173301697f, 0.106891394f, 0.0736715794f, 0.0145332813f, 0.13567543f,
    0.150677204f, 0.0575268269f, 0.0112535954f, 0.0108809471f, -0.00162506104f, 0.0139164925f,
    -0.0417928696f, -0.00300312042f, 0.009349823f, -0.0869398117f, -0.0513439178f, -0.00461387634f,
    0.00792884827f, -0.127428055f, -0.120130062f, -0.0677673817f, 0.000617265701f, -0.0817391872f,
    -0.0746092796f, 0.0909204483f, -0.037050724f, -0.0834977627f, -0.039137125f, 0.0114605427f,
    0.0287168026f, 0.0481178761f, 0.0414230824f, 0.0776572227f, 0.0268476009f, 0.0313272476f,
    0.0744533539f, 0.0535879135f, 0.0213644505f, 0.00954532623f, -0.00500106812f, 0.00732660294f,
    -0.0353069305f, -0.00939512253f, 0.00465011597f, -0.0517258644f, -0.0369167328f, -0.0112719536f,
    0.00246143341f, 0.0282177925f, 0.0100641251f, 0.0185689926f, -0.0303888321f, 0.01040411f,
    0.00802326202f, -0.0324378014f, -0.011039257f, 0.00550603867f, 0.00511407852f, 0.0057259798f,
    -0.00378262997f, 0.0448281765f, -0.0110957623f, 0.0348397493f, 0.0256174803f, 0.00284790993f,
    -0.0011600256f, 0.0178817511f, 0.00795948505f, -0.00406014919f, -0.0168597698f, -0.00898265839f,
    -0.0261495113f, -0.0207589865f, -0.00134706497f, -0.015147686f, -0.0229728222f, -0.00734877586f,
    0.000554800034f, -0.00250959396f, 0.00432038307f, -0.00164031982f, 0.0141599178f,
    0.00359630585f, -0.000581979752f, 0.0132892132f, 0.00806927681f, 0.00249505043f,
    7.65323639e-05f, -0.00443089008f, -0.0160171986f, 0.0257219076f, -0.022003293f, 0.0215574503f,
    0.0250566006f, -0.00752985477f, 0.000386834145f, 0.0205187798f, 0.0119540691f, 0.00132811069f,
    -0.00744783878f, -0.00420951843f, -0.017332077f, -0.0136271715f, 0.00109302998f, -0.0123172998f,
    -0.0192130804f, -0.00552904606f, 0.0016617775f, -0.00307059288f, 0.00224781036f,
    -0.00622820854f, 0.0111281872f, -0.00182723999f, -0.00485825539f, 0.0112235546f, 0.00799489021f,
    -0.00144720078f, -0.00392436981f, -0.00169324875f, -0.00593495369f, 0.00533342361f,
    -0.00913333893f, 0.00368070602f, 0.00703024864f, -0.00556588173f, -0.00200152397f,
    0.00606966019f, 0.00345468521f, 0.281488419f, 0.345803022f, -0.00585639477f, 0.182788372f,
    0.0413312912f, -0.0399206877f, -0.0215264559f, 0.0840568542f, -0.0133179426f, -0.0409493446f,
    -0.070256114f, -0.0637993813f, -0.0653244257f, -0.0171017647f, -0.0455733538f, -0.0384428501f,
    -0.0136059523f, 0.00560724735f, -0.0103006363f, -0.0254266262f, 0.0214195251f, 0.0255019665f,
    0.0256810188f, 0.0151553154f, 0.0290503502f, 0.0186753273f, 0.00784039497f, 0.0062892437f,
    0.0227911472f, 0.0123000145f, 0.0117588043f, -0.000473499298f, 0.0181179047f, -0.0187540054f,
    -0.00171661377f, 0.0175795555f, -0.0112981796f, -0.0248003006f, -0.00274276733f, 0.0166392326f,
    0.0339305401f, 0.0700016022f, 0.00461685658f, 0.0898149014f, 0.0128002167f, -0.00179851055f,
    0.0649954081f, 0.0226230621f, -0.0042566061f, -0.00537395477f, -0.0171990395f, -0.0272532701f,
    -0.00518262386f, -0.0264713764f, -0.0101498365f, 0.00316274166f, -0.0174312592f, -0.0116474628f,
    0.00309538841f, 0.00522732735f, 0.00944280624f, 0.0118918419f, 0.00717830658f, 0.00811243057f,
    0.00657272339f, 0.00423526764f, 0.00430583954f, -0.000423431396f, 0.00261759758f,
    0.00202393532f, -0.0304598808f, -0.0380885601f, 0.00385689735f, -0.0181879997f,
    -0.000399589539f, 0.00709152222f, 0.0103538036f, -0.00616955757f, 0.00303244591f,
    0.00461673737f, 0.00375318527f, 0.00166702271f, 0.000535488129f, -0.00467634201f,
    0.000748157501f, 0.000751972198f, -0.00795555115f, -0.000540733337f, 0.00102519989f,
    0.000305175781f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f
};

/* What all weights share: the closed form preetham_classes. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_EARLY 16

static inline void skylight_sh_4_bands_1_5pct_begin_factors(const skylight_sh_4_bands_1_5pct_real
    *x, skylight_sh_4_bands_1_5pct_real *early)
{
    const float chi = (0.888888896f - x[1] * 0.0166666675f) * (1.57079637f - x[0]);
    const float square = chi * chi;
    early[0] = 945.0f - square * (420.0f - 15.0f * square);
    early[1] = (4045.30005f * x[1] - 4971.0f) * (chi * (945.0f - square * (105.0f - square))) +
        (2419.19995f - 215.5f * x[1]) * early[0];
    const float part_1 = (-0.355399996f) * x[1] + 0.42750001f;
    const float up = 1.0f + part_1 * (0.25f + part_1 * 0.03125f);
    const float up2 = up * up;
    early[2] = 1.0f + (0.1787f * x[1] + (-1.46300006f)) * (up2 * up2);
    early[3] = (-0.0227000006f) * x[1] + 5.32509995f;
    const float y = (0.1206f * x[1] + (-2.57710004f)) * x[0] * 0.25f;
    const float halo = 1.0f + y * (0.99999845f + y * (0.499975085f + y * (0.166515172f + y *
        (0.0412233174f + y * (0.00765432511f + y * 0.000849007862f)))));
    early[4] = halo * halo;
    const float z = x[0] * x[0];
    const float cosine = 1.0f - z * (0.5f - z * 0.03125f);
    const float cosine2 = cosine * cosine;
    early[5] = ((-0.0670000017f) * x[1] + 0.370299995f) * cosine2;
    early[6] = ((((0.00274999999f * x[1] + (-0.0421399996f)) * x[1] + 0.153459996f) * x[0] +
        (((-0.00609999988f) * x[1] + 0.0896999985f) * x[1] + (-0.267560005f))) * x[0] +
        ((0.00316999992f * x[1] + (-0.0415299982f)) * x[1] + 0.0666999966f)) * x[0] +
        (0.00516000018f * x[1] + 0.266880006f);
    early[7] = 0.00249999994f * x[1] + 0.733200014f;
    early[8] = (-0.00039999999f) * x[1] + 0.212500006f;
    const float y_2 = ((-0.0640999973f) * x[1] + (-0.898899972f)) * x[0] * 0.25f;
    const float halo_2 = 1.0f + y_2 * (0.99999845f + y_2 * (0.499975085f + y_2 * (0.166515172f + y_2
        * (0.0412233174f + y_2 * (0.00765432511f + y_2 * 0.000849007862f)))));
    early[9] = halo_2 * halo_2;
    early[10] = ((-0.00329999998f) * x[1] + 0.0452000014f) * cosine2;
    early[11] = ((((0.00165999995f * x[1] + (-0.0290300008f)) * x[1] + 0.11693f) * x[0] +
        (((-0.00374999992f) * x[1] + 0.0637700036f) * x[1] + (-0.211960003f))) * x[0] +
        ((0.00209000008f * x[1] + (-0.0320199989f)) * x[1] + 0.0605200008f)) * x[0] + (0.0039400002f
        * x[1] + 0.258859992f);
    early[12] = 0.00992999971f * x[1] + 0.734399974f;
    early[13] = (-0.00789999962f) * x[1] + 0.210199997f;
    const float y_3 = ((-0.0441000015f) * x[1] + (-1.65369999f)) * x[0] * 0.25f;
    const float halo_3 = 1.0f + y_3 * (0.99999845f + y_3 * (0.499975085f + y_3 * (0.166515172f + y_3
        * (0.0412233174f + y_3 * (0.00765432511f + y_3 * 0.000849007862f)))));
    early[14] = halo_3 * halo_3;
    early[15] = ((-0.0109000001f) * x[1] + 0.0529000014f) * cosine2;
    (void)x;
    (void)early;
}

/* The rest of it. */
static inline void skylight_sh_4_bands_1_5pct_end_factors(const skylight_sh_4_bands_1_5pct_real *x,
    const skylight_sh_4_bands_1_5pct_real *early, skylight_sh_4_bands_1_5pct_real *out)
{
    const float halo4 = early[4] * early[4];
    const float shape_y = early[2] * (1.0f + early[3] * halo4 + early[5]);
    const float halo4_2 = early[9] * early[9];
    const float shape_x = early[7] * (1.0f + early[8] * halo4_2 + early[10]);
    const float one = early[1] / (early[0] * shape_y * early[6] * shape_x);
    const float halo4_3 = early[14] * early[14];
    const float shape_z = early[12] * (1.0f + early[13] * halo4_3 + early[15]);
    const float of_x = one * early[11] * shape_z;
    out[1] = 3.73898554f * of_x;
    const float of_y = one * early[6] * shape_x;
    const float of_s = one * shape_z * shape_x;
    out[2] = (-0.498531401f) * of_s;
    out[0] = out[1] + (-1.03860712f) * of_y + out[2];
    out[4] = (-1.01082206f) * of_x;
    out[5] = 0.0415560007f * of_s;
    out[3] = out[4] + 1.83445477f * of_y + out[5];
    out[7] = (-1.00158179f) * of_x;
    out[8] = 1.05722523f * of_s;
    out[6] = out[7] + (-1.26125109f) * of_y + out[8];
    (void)x;
    (void)early;
}

/* The functions of sun_zenith (change of variable: even); 0 where there is
   none. */
static inline void skylight_sh_4_bands_1_5pct_first(const skylight_sh_4_bands_1_5pct_real *x,
    skylight_sh_4_bands_1_5pct_real *out)
{
    out[0] = 1.0f;
    out[1] = (-13.3479729f) * (x[0] * x[0] - 0.0f) / ((-14.0f) - x[0] * x[0]) - 1.0f;
    out[2] = out[1] * out[1];
    out[3] = out[1] * out[2];
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_4_bands_1_5pct_others(const skylight_sh_4_bands_1_5pct_real *x,
    skylight_sh_4_bands_1_5pct_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.85714293f) * (x[1] - 2.5f) / ((-2.5f) - x[1]) - 1.0f;
    out[2] = out[1] * out[1];
    out[3] = out[1] * out[2];
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power
   of `radius`, by doubling. */
static inline void skylight_sh_4_bands_1_5pct_waves(skylight_sh_4_bands_1_5pct_real azimuth,
    skylight_sh_4_bands_1_5pct_real radius, skylight_sh_4_bands_1_5pct_real *cosines,
    skylight_sh_4_bands_1_5pct_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = radius * cosf(azimuth);
    sines[1] = radius * sinf(azimuth);
    cosines[2] = cosines[1] * cosines[1] - sines[1] * sines[1];
    sines[2] = sines[1] * cosines[1] + cosines[1] * sines[1];
    cosines[3] = cosines[1] * cosines[2] - sines[1] * sines[2];
    sines[0] = 0.0f;
    sines[3] = sines[1] * cosines[2] + cosines[1] * sines[2];
}

/* The sine of the sun's zenith angle, whose powers the sums of order m
   lack. */
static inline skylight_sh_4_bands_1_5pct_real skylight_sh_4_bands_1_5pct_sine(const
    skylight_sh_4_bands_1_5pct_real *x)
{
    const float part_1 = x[SKYLIGHT_SH_4_BANDS_1_5PCT_SUN] * x[SKYLIGHT_SH_4_BANDS_1_5PCT_SUN];
    return x[SKYLIGHT_SH_4_BANDS_1_5PCT_SUN] + x[SKYLIGHT_SH_4_BANDS_1_5PCT_SUN] * (part_1 *
        ((-0.166666597f) + part_1 * (0.00833306555f + part_1 * ((-0.000198095426f) + part_1 *
        2.60563934e-06f))));
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
        const double part_1 = (-14.0) - v * v;
        const double part_2 = (-13.347972567941833) * (v * v - 0.0) / part_1;
        out[1] = part_2 - 1.0;
        out[2] = out[1] * out[1];
        out[3] = out[1] * out[2];
        slopes[0] = 0.0;
        slopes[1] = (-13.347972567941833) * (v + v) / part_1 - part_2 * -(v + v) / part_1;
        slopes[2] = slopes[1] * out[1] + out[1] * slopes[1];
        slopes[3] = slopes[1] * out[2] + out[1] * slopes[2];
    }
    if (axis == 1) {
        out[0] = 1.0;
        const double part_1 = (-2.5) - v;
        const double part_2 = (-4.8571428571428568) * (v - 2.5) / part_1;
        out[1] = part_2 - 1.0;
        out[2] = out[1] * out[1];
        out[3] = out[1] * out[2];
        slopes[0] = 0.0;
        slopes[1] = (-4.8571428571428568) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = slopes[1] * out[1] + out[1] * slopes[1];
        slopes[3] = slopes[1] * out[2] + out[1] * slopes[2];
    }
    (void)v;
}

/* The factors, then their slopes after each axis. */
static inline void skylight_sh_4_bands_1_5pct_factor_slopes(const double *x, double *out)
{
    const double part_1 = 4045.3000000000002 * x[1] - 4971.0;
    const double part_2 = 0.88888888888888884 - x[1] * 0.016666666666666666;
    const double part_3 = 1.5707963267948966 - x[0];
    const double chi = part_2 * part_3;
    const double square = chi * chi;
    const double part_4 = 105.0 - square;
    const double part_5 = 945.0 - square * part_4;
    const double part_6 = chi * part_5;
    const double part_7 = 2419.1999999999998 - 215.5 * x[1];
    const double part_8 = 420.0 - 15.0 * square;
    const double below = 945.0 - square * part_8;
    const double zenith = part_1 * part_6 + part_7 * below;
    const double part_9 = 0.1787 * x[1] + (-1.4630000000000001);
    const double part_10 = (-0.35539999999999999) * x[1] + 0.42749999999999999;
    const double part_11 = 0.25 + part_10 * 0.03125;
    const double up = 1.0 + part_10 * part_11;
    const double up2 = up * up;
    const double part_12 = up2 * up2;
    const double part_13 = 1.0 + part_9 * part_12;
    const double part_14 = (-0.022700000000000001) * x[1] + 5.3250999999999999;
    const double part_15 = 0.1206 * x[1] + (-2.5771000000000002);
    const double y = part_15 * x[0] * 0.25;
    const double part_16 = 0.0076543250999999996 + y * 0.00084900787100000003;
    const double part_17 = 0.041223317699999998 + y * part_16;
    const double part_18 = 0.16651516699999999 + y * part_17;
    const double part_19 = 0.49997509099999998 + y * part_18;
    const double part_20 = 0.99999845399999998 + y * part_19;
    const double halo = 0.99999998400000001 + y * part_20;
    const double halo2 = halo * halo;
    const double halo4 = halo2 * halo2;
    const double part_21 = (-0.067000000000000004) * x[1] + 0.37030000000000002;
    const double z = x[0] * x[0];
    const double part_22 = 0.5 - z * 0.03125;
    const double cosine = 1.0 - z * part_22;
    const double cosine2 = cosine * cosine;
    const double part_23 = 1.0 + part_14 * halo4 + part_21 * cosine2;
    const double shape_y = part_13 * part_23;
    const double part_24 = below * shape_y;
    const double part_25 = 0.0027499999999999998 * x[1] + (-0.042139999999999997);
    const double part_26 = part_25 * x[1] + 0.15346000000000001;
    const double part_27 = (-0.0061000000000000004) * x[1] + 0.089700000000000002;
    const double part_28 = part_26 * x[0] + (part_27 * x[1] + (-0.26756000000000002));
    const double part_29 = 0.0031700000000000001 * x[1] + (-0.041529999999999997);
    const double part_30 = part_28 * x[0] + (part_29 * x[1] + 0.066699999999999995);
    const double y_zenith = part_30 * x[0] + (0.0051599999999999997 * x[1] + 0.26688000000000001);
    const double part_31 = part_24 * y_zenith;
    const double part_32 = 0.0025000000000000001 * x[1] + 0.73319999999999996;
    const double part_33 = (-0.00040000000000000002) * x[1] + 0.21249999999999999;
    const double part_34 = (-0.064100000000000004) * x[1] + (-0.89890000000000003);
    const double y_2 = part_34 * x[0] * 0.25;
    const double part_35 = 0.0076543250999999996 + y_2 * 0.00084900787100000003;
    const double part_36 = 0.041223317699999998 + y_2 * part_35;
    const double part_37 = 0.16651516699999999 + y_2 * part_36;
    const double part_38 = 0.49997509099999998 + y_2 * part_37;
    const double part_39 = 0.99999845399999998 + y_2 * part_38;
    const double halo_2 = 0.99999998400000001 + y_2 * part_39;
    const double halo2_2 = halo_2 * halo_2;
    const double halo4_2 = halo2_2 * halo2_2;
    const double part_40 = (-0.0033) * x[1] + 0.045199999999999997;
    const double part_41 = 1.0 + part_33 * halo4_2 + part_40 * cosine2;
    const double shape_x = part_32 * part_41;
    const double part_42 = part_31 * shape_x;
    const double one = zenith / part_42;
    const double part_43 = 0.00166 * x[1] + (-0.02903);
    const double part_44 = part_43 * x[1] + 0.11693000000000001;
    const double part_45 = (-0.0037499999999999999) * x[1] + 0.063769999999999993;
    const double part_46 = part_44 * x[0] + (part_45 * x[1] + (-0.21196000000000001));
    const double part_47 = 0.0020899999999999998 * x[1] + (-0.03202);
    const double part_48 = part_46 * x[0] + (part_47 * x[1] + 0.060519999999999997);
    const double x_zenith = part_48 * x[0] + (0.0039399999999999999 * x[1] + 0.25885999999999998);
    const double part_49 = one * x_zenith;
    const double part_50 = 0.0099299999999999996 * x[1] + 0.73440000000000005;
    const double part_51 = (-0.0079000000000000008) * x[1] + 0.2102;
    const double part_52 = (-0.0441) * x[1] + (-1.6536999999999999);
    const double y_3 = part_52 * x[0] * 0.25;
    const double part_53 = 0.0076543250999999996 + y_3 * 0.00084900787100000003;
    const double part_54 = 0.041223317699999998 + y_3 * part_53;
    const double part_55 = 0.16651516699999999 + y_3 * part_54;
    const double part_56 = 0.49997509099999998 + y_3 * part_55;
    const double part_57 = 0.99999845399999998 + y_3 * part_56;
    const double halo_3 = 0.99999998400000001 + y_3 * part_57;
    const double halo2_3 = halo_3 * halo_3;
    const double halo4_3 = halo2_3 * halo2_3;
    const double part_58 = (-0.0109) * x[1] + 0.052900000000000003;
    const double part_59 = 1.0 + part_51 * halo4_3 + part_58 * cosine2;
    const double shape_z = part_50 * part_59;
    const double of_x = part_49 * shape_z;
    out[1] = 3.7389855999999999 * of_x;
    const double part_60 = one * y_zenith;
    const double of_y = part_60 * shape_x;
    const double part_61 = one * shape_z;
    const double of_s = part_61 * shape_x;
    out[2] = (-0.49853140000000001) * of_s;
    out[0] = out[1] + (-1.0386070999999999) * of_y + out[2];
    out[4] = (-1.0108219999999999) * of_x;
    out[5] = 0.041556000000000003 * of_s;
    out[3] = out[4] + 1.8344548000000001 * of_y + out[5];
    out[7] = (-1.0015818000000001) * of_x;
    out[8] = 1.0572252 * of_s;
    out[6] = out[7] + (-1.2612511) * of_y + out[8];
    const double part_62 = part_2 * -1.0;
    const double part_63 = part_62 * chi + chi * part_62;
    const double part_64 = -(part_63 * part_8 + square * -(15.0 * part_63));
    const double part_65 = part_15 * 0.25;
    const double part_66 = part_65 * part_20 + y * (part_65 * part_19 + y * (part_65 * part_18 + y *
        (part_65 * part_17 + y * (part_65 * part_16 + y * (part_65 * 0.00084900787100000003)))));
    const double part_67 = part_66 * halo + halo * part_66;
    const double part_68 = x[0] + x[0];
    const double part_69 = -(part_68 * part_22 + z * -(part_68 * 0.03125));
    const double part_70 = part_69 * cosine + cosine * part_69;
    const double part_71 = (part_26 * x[0] + part_28) * x[0] + part_30;
    const double part_72 = part_34 * 0.25;
    const double part_73 = part_72 * part_39 + y_2 * (part_72 * part_38 + y_2 * (part_72 * part_37 +
        y_2 * (part_72 * part_36 + y_2 * (part_72 * part_35 + y_2 * (part_72 *
        0.00084900787100000003)))));
    const double part_74 = part_73 * halo_2 + halo_2 * part_73;
    const double part_75 = part_32 * (part_33 * (part_74 * halo2_2 + halo2_2 * part_74) + part_40 *
        part_70);
    const double part_76 = (part_1 * (part_62 * part_5 + chi * -(part_63 * part_4 + square *
        -part_63)) + part_7 * part_64) / part_42 - one * (((part_64 * shape_y + below * (part_13 *
        (part_14 * (part_67 * halo2 + halo2 * part_67) + part_21 * part_70))) * y_zenith + part_24 *
        part_71) * shape_x + part_31 * part_75) / part_42;
    const double part_77 = part_52 * 0.25;
    const double part_78 = part_77 * part_57 + y_3 * (part_77 * part_56 + y_3 * (part_77 * part_55 +
        y_3 * (part_77 * part_54 + y_3 * (part_77 * part_53 + y_3 * (part_77 *
        0.00084900787100000003)))));
    const double part_79 = part_78 * halo_3 + halo_3 * part_78;
    const double part_80 = part_50 * (part_51 * (part_79 * halo2_3 + halo2_3 * part_79) + part_58 *
        part_70);
    const double part_81 = (part_76 * x_zenith + one * ((part_44 * x[0] + part_46) * x[0] +
        part_48)) * shape_z + part_49 * part_80;
    out[10] = 3.7389855999999999 * part_81;
    const double part_82 = (part_76 * y_zenith + one * part_71) * shape_x + part_60 * part_75;
    const double part_83 = (part_76 * shape_z + one * part_80) * shape_x + part_61 * part_75;
    out[11] = (-0.49853140000000001) * part_83;
    out[9] = out[10] + (-1.0386070999999999) * part_82 + out[11];
    out[13] = (-1.0108219999999999) * part_81;
    out[14] = 0.041556000000000003 * part_83;
    out[12] = out[13] + 1.8344548000000001 * part_82 + out[14];
    out[16] = (-1.0015818000000001) * part_81;
    out[17] = 1.0572252 * part_83;
    out[15] = out[16] + (-1.2612511) * part_82 + out[17];
    const double part_84 = -0.016666666666666666 * part_3;
    const double part_85 = part_84 * chi + chi * part_84;
    const double part_86 = -(part_85 * part_8 + square * -(15.0 * part_85));
    const double part_87 = (-0.35539999999999999) * part_11 + part_10 * ((-0.35539999999999999) *
        0.03125);
    const double part_88 = part_87 * up + up * part_87;
    const double part_89 = 0.1206 * x[0] * 0.25;
    const double part_90 = part_89 * part_20 + y * (part_89 * part_19 + y * (part_89 * part_18 + y *
        (part_89 * part_17 + y * (part_89 * part_16 + y * (part_89 * 0.00084900787100000003)))));
    const double part_91 = part_90 * halo + halo * part_90;
    const double part_92 = (((0.0027499999999999998 * x[1] + part_25) * x[0] +
        ((-0.0061000000000000004) * x[1] + part_27)) * x[0] + (0.0031700000000000001 * x[1] +
        part_29)) * x[0] + 0.0051599999999999997;
    const double part_93 = (-0.064100000000000004) * x[0] * 0.25;
    const double part_94 = part_93 * part_39 + y_2 * (part_93 * part_38 + y_2 * (part_93 * part_37 +
        y_2 * (part_93 * part_36 + y_2 * (part_93 * part_35 + y_2 * (part_93 *
        0.00084900787100000003)))));
    const double part_95 = part_94 * halo_2 + halo_2 * part_94;
    const double part_96 = 0.0025000000000000001 * part_41 + part_32 * ((-0.00040000000000000002) *
        halo4_2 + part_33 * (part_95 * halo2_2 + halo2_2 * part_95) + (-0.0033) * cosine2);
    const double part_97 = (4045.3000000000002 * part_6 + part_1 * (part_84 * part_5 + chi *
        -(part_85 * part_4 + square * -part_85)) + (-215.5 * below + part_7 * part_86)) / part_42 -
        one * (((part_86 * shape_y + below * ((0.1787 * part_12 + part_9 * (part_88 * up2 + up2 *
        part_88)) * part_23 + part_13 * ((-0.022700000000000001) * halo4 + part_14 * (part_91 *
        halo2 + halo2 * part_91) + (-0.067000000000000004) * cosine2))) * y_zenith + part_24 *
        part_92) * shape_x + part_31 * part_96) / part_42;
    const double part_98 = (-0.0441) * x[0] * 0.25;
    const double part_99 = part_98 * part_57 + y_3 * (part_98 * part_56 + y_3 * (part_98 * part_55 +
        y_3 * (part_98 * part_54 + y_3 * (part_98 * part_53 + y_3 * (part_98 *
        0.00084900787100000003)))));
    const double part_100 = part_99 * halo_3 + halo_3 * part_99;
    const double part_101 = 0.0099299999999999996 * part_59 + part_50 * ((-0.0079000000000000008) *
        halo4_3 + part_51 * (part_100 * halo2_3 + halo2_3 * part_100) + (-0.0109) * cosine2);
    const double part_102 = (part_97 * x_zenith + one * ((((0.00166 * x[1] + part_43) * x[0] +
        ((-0.0037499999999999999) * x[1] + part_45)) * x[0] + (0.0020899999999999998 * x[1] +
        part_47)) * x[0] + 0.0039399999999999999)) * shape_z + part_49 * part_101;
    out[19] = 3.7389855999999999 * part_102;
    const double part_103 = (part_97 * y_zenith + one * part_92) * shape_x + part_60 * part_96;
    const double part_104 = (part_97 * shape_z + one * part_101) * shape_x + part_61 * part_96;
    out[20] = (-0.49853140000000001) * part_104;
    out[18] = out[19] + (-1.0386070999999999) * part_103 + out[20];
    out[22] = (-1.0108219999999999) * part_102;
    out[23] = 0.041556000000000003 * part_104;
    out[21] = out[22] + 1.8344548000000001 * part_103 + out[23];
    out[25] = (-1.0015818000000001) * part_102;
    out[26] = 1.0572252 * part_104;
    out[24] = out[25] + (-1.2612511) * part_103 + out[26];
    (void)x;
}

/* The sine of the sun's zenith angle, then its slope. */
static inline void skylight_sh_4_bands_1_5pct_sine_slope(const double *x, double *out)
{
    out[0] = sin(x[SKYLIGHT_SH_4_BANDS_1_5PCT_SUN]);
    out[1] = cos(x[SKYLIGHT_SH_4_BANDS_1_5PCT_SUN]);
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

/* Numbers side by side where the compiler has vector types: as many as the processor's registers
   hold, and four. */
#if defined(__GNUC__) && (defined(__SSE__) || defined(__ARM_NEON) || defined(__ALTIVEC__) || \
                          defined(__wasm_simd128__) || defined(__loongarch_sx))
#if defined(__AVX512F__)
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LANES 16
#elif defined(__AVX__)
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LANES 8
#else
#define SKYLIGHT_SH_4_BANDS_1_5PCT_LANES 4
#endif
#endif
/* What is worth its place in every caller. */
#ifdef __GNUC__
#define SKYLIGHT_SH_4_BANDS_1_5PCT_INLINE static inline __attribute__((always_inline))
#else
#define SKYLIGHT_SH_4_BANDS_1_5PCT_INLINE static inline
#endif
#ifdef SKYLIGHT_SH_4_BANDS_1_5PCT_LANES
#ifdef __FMA__
/* One operation for a product and a sum, which standard C may not choose by itself. */
#include <immintrin.h>
#endif
typedef float skylight_sh_4_bands_1_5pct_lanes __attribute__((vector_size(4 *
    SKYLIGHT_SH_4_BANDS_1_5PCT_LANES)));
typedef float skylight_sh_4_bands_1_5pct_four __attribute__((vector_size(16)));
typedef int skylight_sh_4_bands_1_5pct_order __attribute__((vector_size(16)));

/* The same number in all places: v - 0 is v, which 0 + v need not be. */
static inline skylight_sh_4_bands_1_5pct_lanes skylight_sh_4_bands_1_5pct_spread(float v)
{
    const skylight_sh_4_bands_1_5pct_lanes zeros = {0};
    return v - zeros;
}

static inline skylight_sh_4_bands_1_5pct_lanes skylight_sh_4_bands_1_5pct_load(const float *from)
{
    skylight_sh_4_bands_1_5pct_lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* a * b + c. */
static inline skylight_sh_4_bands_1_5pct_lanes
    skylight_sh_4_bands_1_5pct_add(skylight_sh_4_bands_1_5pct_lanes a,
    skylight_sh_4_bands_1_5pct_lanes b,
                                                skylight_sh_4_bands_1_5pct_lanes c)
{
#if defined(__FMA__) && SKYLIGHT_SH_4_BANDS_1_5PCT_LANES == 16
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && SKYLIGHT_SH_4_BANDS_1_5PCT_LANES == 8
    return _mm256_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline skylight_sh_4_bands_1_5pct_four skylight_sh_4_bands_1_5pct_spread_four(float v)
{
    const skylight_sh_4_bands_1_5pct_four zeros = {0};
    return v - zeros;
}

static inline skylight_sh_4_bands_1_5pct_four skylight_sh_4_bands_1_5pct_load_four(const float
    *from)
{
    skylight_sh_4_bands_1_5pct_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline skylight_sh_4_bands_1_5pct_four
    skylight_sh_4_bands_1_5pct_add_four(skylight_sh_4_bands_1_5pct_four a,
    skylight_sh_4_bands_1_5pct_four b,
                                                    skylight_sh_4_bands_1_5pct_four c)
{
#ifdef __FMA__
    return _mm_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline void skylight_sh_4_bands_1_5pct_keep(float *to, skylight_sh_4_bands_1_5pct_four v)
{
    memcpy(to, &v, sizeof v);
}

/* Four of the eight numbers of two vectors. */
#ifdef __clang__
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PICK(v, w, a, b, c, d) __builtin_shufflevector(v, w, a, b, c, d)
#else
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PICK(v, w, a, b, c, d) skylight_sh_4_bands_1_5pct_pick(v, w, a, \
    b, c, d)
static inline skylight_sh_4_bands_1_5pct_four
    skylight_sh_4_bands_1_5pct_pick(skylight_sh_4_bands_1_5pct_four v,
    skylight_sh_4_bands_1_5pct_four w, int a,
                                                int b, int c, int d)
{
    const skylight_sh_4_bands_1_5pct_order order = {a, b, c, d};
    return __builtin_shuffle(v, w, order);
}
#endif
#endif

/* One channel's sums, from those of its classes. */
static inline void skylight_sh_4_bands_1_5pct_mix(skylight_sh_4_bands_1_5pct_real
    sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_ROOM],
                                   int channel, const skylight_sh_4_bands_1_5pct_real *factors,
                                   skylight_sh_4_bands_1_5pct_real *mixed)
{
    int i;
    int k;
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++i)
        mixed[i] = factors[channel * SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES] * sums[0][i];
    for (k = 1; k < SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES; ++k)
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++i)
            mixed[i] += factors[channel * SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES + k] * sums[k][i];
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST_ORDER(l) 0

/* Stores one weight of degree l and order m turned by the azimuth. */
static inline void skylight_sh_4_bands_1_5pct_place(skylight_sh_4_bands_1_5pct_real value, int l,
    int m,
                                     const skylight_sh_4_bands_1_5pct_real *cosines,
                                         const skylight_sh_4_bands_1_5pct_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* Stores the first `bands` bands of the channels' weights, turned by the azimuth (Habel et al.
 * 2008,
   eq. 4 with nothing for m < 0). */
static inline void skylight_sh_4_bands_1_5pct_store(
    skylight_sh_4_bands_1_5pct_real
        sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_ROOM],
        const skylight_sh_4_bands_1_5pct_real *factors,
    const skylight_sh_4_bands_1_5pct_real *cosines, const skylight_sh_4_bands_1_5pct_real *sines,
        int bands,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    int channel;
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_LANES) && SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS > 3
    /* In fours; each overshoot is overwritten by what follows. */
    float plus[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS], minus[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS + 3] = {0};
    int m, q;
    for (m = 0; m < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++m) {
        plus[m] = cosines[m];
        minus[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS - 1 - m] = sines[m];
    }
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel) {
        float *const w = weights[channel];
        skylight_sh_4_bands_1_5pct_four v[SKYLIGHT_SH_4_BANDS_1_5PCT_FOURS];
        for (q = 0; q < SKYLIGHT_SH_4_BANDS_1_5PCT_FOURS; ++q) {
            int k;
            v[q] = factors[channel * SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES] *
                skylight_sh_4_bands_1_5pct_load_four(sums[0] + 4 * q);
            for (k = 1; k < SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES; ++k)
                v[q] = skylight_sh_4_bands_1_5pct_add_four(
                    skylight_sh_4_bands_1_5pct_spread_four(factors[channel *
                        SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES + k]),
                    skylight_sh_4_bands_1_5pct_load_four(sums[k] + 4 * q), v[q]);
        }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING(place, count) memset(w + (place), 0, sizeof(float) * \
    (count));
#define SKYLIGHT_SH_4_BANDS_1_5PCT_MINUS(place, q, r, a, b, c, d, order) \
    skylight_sh_4_bands_1_5pct_keep(w + (place), \
                     SKYLIGHT_SH_4_BANDS_1_5PCT_PICK(v[q], v[r], a, b, c, d) * \
                         skylight_sh_4_bands_1_5pct_load_four(minus + \
                             SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS - 1 - (order)));
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PLUS(place, q, r, a, b, c, d, order) \
    skylight_sh_4_bands_1_5pct_keep(w + (place), SKYLIGHT_SH_4_BANDS_1_5PCT_PICK(v[q], v[r], a, b, \
        c, d) * \
                                      skylight_sh_4_bands_1_5pct_load_four(plus + (order)));
        SKYLIGHT_SH_4_BANDS_1_5PCT_STORES(SKYLIGHT_SH_4_BANDS_1_5PCT_BAND,
            SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_4_BANDS_1_5PCT_MINUS,
                           SKYLIGHT_SH_4_BANDS_1_5PCT_PLUS)
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_BAND
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_MINUS
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_PLUS
    }
#else
    static const short columns[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_COLUMNS;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel) {
        skylight_sh_4_bands_1_5pct_real v[SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
        int l, m;
        skylight_sh_4_bands_1_5pct_mix(sums, channel, factors, v);
        for (l = 0; l < bands; ++l) {
            float *const w = weights[channel] + l * (l + 1);
            const int column = columns[l];
            for (m = 1; m <= l; ++m)
                w[-m] = column < 0 ? 0.0f : (float)(v[column + m] * sines[m]);
            for (m = 0; m <= l; ++m)
                w[m] = column < 0 ? 0.0f : (float)(v[column + m] * cosines[m]);
        }
    }
#endif
    (void)cosines;
    (void)sines;
}

#ifdef SKYLIGHT_SH_4_BANDS_1_5PCT_LANES

/* Vectors that the first `count` numbers of a row take, and those that are summed at once, in
   registers. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_VECTORS(count) (((count) + SKYLIGHT_SH_4_BANDS_1_5PCT_LANES - \
    1) / SKYLIGHT_SH_4_BANDS_1_5PCT_LANES)
#define SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCKS \
    ((SKYLIGHT_SH_4_BANDS_1_5PCT_VECTORS(SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH) + 6) / 7)
#define SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK \
    ((SKYLIGHT_SH_4_BANDS_1_5PCT_VECTORS(SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH) + \
        SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCKS - 1) / SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCKS)
#endif
#ifdef SKYLIGHT_SH_4_BANDS_1_5PCT_LANES

/* One class's sums, for SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK vectors of each row: over the products of
 * the other axes'
   functions, each times a polynomial in powers of u, by Horner's scheme. */
SKYLIGHT_SH_4_BANDS_1_5PCT_INLINE void skylight_sh_4_bands_1_5pct_sum_block(const
    skylight_sh_4_bands_1_5pct_real *rows, int class_,
                                              skylight_sh_4_bands_1_5pct_real u,
                                                  const skylight_sh_4_bands_1_5pct_real *others,
                                              skylight_sh_4_bands_1_5pct_real *sums)
{
    const skylight_sh_4_bands_1_5pct_lanes power = skylight_sh_4_bands_1_5pct_spread(u);
    int i, k;
#define SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS(which, polynomials) \
    if (class_ == (which)) { \
        skylight_sh_4_bands_1_5pct_lanes total[SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK]; \
        polynomials \
        for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK; ++k) \
            memcpy(sums + k * SKYLIGHT_SH_4_BANDS_1_5PCT_LANES, &total[k], sizeof total[k]); \
    }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING \
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK; ++k) total[k] = \
        skylight_sh_4_bands_1_5pct_spread(0);
#define SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIAL(start, count, other) \
    { \
        const skylight_sh_4_bands_1_5pct_real *term = rows + ((start) + (count) - 1) * \
            SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; \
        const skylight_sh_4_bands_1_5pct_lanes factor = \
            skylight_sh_4_bands_1_5pct_spread(others[other]); \
        skylight_sh_4_bands_1_5pct_lanes sum[SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK]; \
        for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK; ++k) \
            sum[k] = skylight_sh_4_bands_1_5pct_load(term + k * SKYLIGHT_SH_4_BANDS_1_5PCT_LANES); \
        for (i = 1; i < (count); ++i) { \
            term -= SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; \
            for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK; ++k) \
                sum[k] = skylight_sh_4_bands_1_5pct_add(sum[k], power, \
                                         skylight_sh_4_bands_1_5pct_load(term + k * \
                                             SKYLIGHT_SH_4_BANDS_1_5PCT_LANES)); \
        } \
        for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK; ++k) SKYLIGHT_SH_4_BANDS_1_5PCT_TOTAL(k) \
    }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_TOTAL(k) total[k] = skylight_sh_4_bands_1_5pct_add(sum[k], \
    factor, total[k]);
    SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIALS(SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS,
        SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIAL)
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIAL
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_TOTAL
}

/* One class's sums, for one vector of each row. */
static inline void skylight_sh_4_bands_1_5pct_sum_vector(const skylight_sh_4_bands_1_5pct_real *row,
    const unsigned char *lengths,
                                          skylight_sh_4_bands_1_5pct_real u,
                                              const skylight_sh_4_bands_1_5pct_real *others,
                                          skylight_sh_4_bands_1_5pct_real *sums)
{
    const skylight_sh_4_bands_1_5pct_lanes power = skylight_sh_4_bands_1_5pct_spread(u);
    skylight_sh_4_bands_1_5pct_lanes total = skylight_sh_4_bands_1_5pct_spread(0);
    int other;
    for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS; ++other) {
        const int length = lengths[other];
        const skylight_sh_4_bands_1_5pct_real *term = row + (length - 1) *
            SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
        skylight_sh_4_bands_1_5pct_lanes sum;
        if (!length) continue;
        sum = skylight_sh_4_bands_1_5pct_load(term);
        while (term != row) {
            term -= SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
            sum = skylight_sh_4_bands_1_5pct_add(sum, power, skylight_sh_4_bands_1_5pct_load(term));
        }
        total = skylight_sh_4_bands_1_5pct_add(sum,
            skylight_sh_4_bands_1_5pct_spread(others[other]), total);
        row += length * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
    }
    memcpy(sums, &total, sizeof total);
}
#else

/* One class's sums, with plain numbers. */
static inline void skylight_sh_4_bands_1_5pct_sum(const skylight_sh_4_bands_1_5pct_real *row,
    const unsigned char *lengths,
                                   skylight_sh_4_bands_1_5pct_real u,
                                       const skylight_sh_4_bands_1_5pct_real *others, int count,
                                   skylight_sh_4_bands_1_5pct_real *sums)
{
    int other, i, k;
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_ROOM; ++k) sums[k] = 0;
    for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS; ++other) {
        skylight_sh_4_bands_1_5pct_real product = others[other];
        for (i = 0; i < (int)lengths[other]; ++i) {
            for (k = 0; k < count; ++k) sums[k] += product * row[k];
            product *= u;
            row += SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
        }
    }
}
#endif

/* The sums of one class's rows, one a term, for the first `bands` bands. */
SKYLIGHT_SH_4_BANDS_1_5PCT_INLINE void skylight_sh_4_bands_1_5pct_sum_class(const
    skylight_sh_4_bands_1_5pct_real *rows, int class_,
                                              const skylight_sh_4_bands_1_5pct_real *first,
                                              const skylight_sh_4_bands_1_5pct_real *others,
                                                  int bands,
                                              skylight_sh_4_bands_1_5pct_real *sums)
{
    static const unsigned short starts[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_STARTS;
    static const unsigned char
        lengths[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_LENGTHS;
    static const unsigned short widths[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTHS;
    const skylight_sh_4_bands_1_5pct_real *const row = rows + (int)starts[class_] *
        SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
#ifdef SKYLIGHT_SH_4_BANDS_1_5PCT_LANES
    int i;
    if (bands == SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS) {
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCKS; ++i) {
            /* The last block may overlap the one before. */
            const int at = i + 1 < SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCKS
                               ? i * SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK
                               : SKYLIGHT_SH_4_BANDS_1_5PCT_VECTORS(
                                   SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH) -
                                   SKYLIGHT_SH_4_BANDS_1_5PCT_BLOCK;
            skylight_sh_4_bands_1_5pct_sum_block(rows + at * SKYLIGHT_SH_4_BANDS_1_5PCT_LANES,
                class_, first[1], others,
                                  sums + at * SKYLIGHT_SH_4_BANDS_1_5PCT_LANES);
        }
        return;
    }
    memset(sums, 0, sizeof *sums * SKYLIGHT_SH_4_BANDS_1_5PCT_ROOM);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_VECTORS(widths[bands - 1]); ++i)
        skylight_sh_4_bands_1_5pct_sum_vector(row + i * SKYLIGHT_SH_4_BANDS_1_5PCT_LANES,
            lengths[class_], first[1], others,
                               sums + i * SKYLIGHT_SH_4_BANDS_1_5PCT_LANES);
#else
    skylight_sh_4_bands_1_5pct_sum(row, lengths[class_], first[1], others, widths[bands - 1], sums);
#endif
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_1_5pct_sum_rows_double(
    const skylight_sh_4_bands_1_5pct_real *rows, const double *first, const double *others,
    double sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH])
{
    static const unsigned char
        lengths[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_LENGTHS;
    int c, i, k, other;
    for (c = 0; c < SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES; ++c) {
        for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++k) sums[c][k] = 0.0;
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS; ++other) {
            for (i = 0; i < (int)lengths[c][other]; ++i) {
                const double product = first[i] * others[other];
                for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++k) sums[c][k] += product *
                    (double)rows[k];
                rows += SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH;
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored. */
static inline void skylight_sh_4_bands_1_5pct_finish(int bands, int lights,
                                      float
                                          weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
                                          [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    (void)bands;
    (void)lights;
    (void)weights;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, clamped like an input)
 * and zeroes the
   rest; returns the status. `rows` are the table's; those of a packed table may be missing. */
static inline int skylight_sh_4_bands_1_5pct_evaluate(const skylight_sh_4_bands_1_5pct_real *rows,
                                       const float inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
                                           float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    skylight_sh_4_bands_1_5pct_real x[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
        first[SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST], others[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS];
    skylight_sh_4_bands_1_5pct_real cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS];
    skylight_sh_4_bands_1_5pct_real
        sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_ROOM];
    skylight_sh_4_bands_1_5pct_real factors[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS *
        SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES];
    skylight_sh_4_bands_1_5pct_real light = SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE, radius = 1;
    skylight_sh_4_bands_1_5pct_real early[SKYLIGHT_SH_4_BANDS_1_5PCT_EARLY];
    int i, all, status = skylight_sh_4_bands_1_5pct_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS *
            SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS;
        status = 1;
    }
    /* First what the library computes: calls keep no registers. */
    radius = skylight_sh_4_bands_1_5pct_sine(x);
    skylight_sh_4_bands_1_5pct_waves((skylight_sh_4_bands_1_5pct_real)azimuth, radius, cosines,
        sines);
    skylight_sh_4_bands_1_5pct_first(x, first);
    skylight_sh_4_bands_1_5pct_others(x, others);
    skylight_sh_4_bands_1_5pct_begin_factors(x, early);
    all = bands;
        skylight_sh_4_bands_1_5pct_sum_class(rows, 0, first, others, all, sums[0]);
    /* Between sums: what has begun above waits for itself, and there is more to do meanwhile. */
    skylight_sh_4_bands_1_5pct_end_factors(x, early, factors);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS * SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES; ++i)
        factors[i] *= light;
    {
#define SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS(k) skylight_sh_4_bands_1_5pct_sum_class(rows, k, first, \
    others, all, sums[k]);
        SKYLIGHT_SH_4_BANDS_1_5PCT_OTHER_CLASSES(SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS)
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS
    }
    skylight_sh_4_bands_1_5pct_store(sums, factors, cosines, sines, all, weights);
    skylight_sh_4_bands_1_5pct_finish(bands, 1, weights);
    if (bands < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS) {
        int channel;
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS; ++i) weights[channel][i]
                = 0.0f;
    }
    return status;
}

/* One of many suns by itself. */
static inline int skylight_sh_4_bands_1_5pct_evaluate_one(const skylight_sh_4_bands_1_5pct_real
    *rows,
                                           const float *const
                                               inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
                                           const float *azimuths, int sun,
                                           float
                                               weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
                                               [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    float given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES];
    int axis;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) given[axis] = inputs[axis][sun];
    return skylight_sh_4_bands_1_5pct_evaluate(rows, given,
        azimuths ? azimuths[sun] : SKYLIGHT_SH_4_BANDS_1_5PCT_AZIMUTH,
                                SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, weights);
}
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_LANES) && SKYLIGHT_SH_4_BANDS_1_5PCT_LANES > 4
/* As many suns side by side as a vector has numbers. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS SKYLIGHT_SH_4_BANDS_1_5PCT_LANES

/* The weights of SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS suns from `start` on, a row a weight; returns the
 * largest status. */
static inline int skylight_sh_4_bands_1_5pct_evaluate_suns(
    const skylight_sh_4_bands_1_5pct_real *rows,
        const float *const inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
    const float *azimuths, int start,
    float out[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS *
        SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS][SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS])
{
    static const short columns[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_COLUMNS;
    float x[SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS][SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
        light[SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS], u[SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS];
    float others[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS][SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS];
    float factors[SKYLIGHT_SH_4_BANDS_1_5PCT_FACTORS][SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS];
    float cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS][SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS],
        sines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS][SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS];
    skylight_sh_4_bands_1_5pct_lanes
        sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
    int s, i, k, l, m, channel, worst = 0;
    for (s = 0; s < SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS; ++s) {
        float given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES], plus[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS],
            minus[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS];
        float azimuth = azimuths ? azimuths[start + s] : SKYLIGHT_SH_4_BANDS_1_5PCT_AZIMUTH,
            radius = 1.0f;
        int status;
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++i) given[i] = inputs[i][start + s];
        status = skylight_sh_4_bands_1_5pct_inputs(given, azimuth, x[s]);
        worst = status > worst ? status : worst;
        light[s] = SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE;
        if (status == 2) {
            light[s] = azimuth = 0.0f;
            for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++i) x[s][i] =
                skylight_sh_4_bands_1_5pct_range[i][0];
        }
        radius = skylight_sh_4_bands_1_5pct_sine(x[s]);
        skylight_sh_4_bands_1_5pct_waves(azimuth, radius, plus, minus);
        for (m = 0; m < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++m) {
            cosines[m][s] = plus[m];
            sines[m][s] = minus[m];
        }
    }
    for (s = 0; s < SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS; ++s) {
        float first[SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST], products[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS];
        skylight_sh_4_bands_1_5pct_first(x[s], first);
        skylight_sh_4_bands_1_5pct_others(x[s], products);
        u[s] = first[1];
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS; ++i) others[i][s] = products[i];
    }
    for (s = 0; s < SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS; ++s) {
        float early[SKYLIGHT_SH_4_BANDS_1_5PCT_EARLY], found[SKYLIGHT_SH_4_BANDS_1_5PCT_FACTORS];
        skylight_sh_4_bands_1_5pct_begin_factors(x[s], early);
        skylight_sh_4_bands_1_5pct_end_factors(x[s], early, found);
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_FACTORS; ++i) factors[i][s] = found[i] *
            light[s];
    }
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; ++i) {
        const skylight_sh_4_bands_1_5pct_lanes power = skylight_sh_4_bands_1_5pct_load(u);
        int t;
#define SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS(which, polynomials) \
    { \
        skylight_sh_4_bands_1_5pct_lanes total; \
        polynomials sums[which][i] = total; \
    }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING total = skylight_sh_4_bands_1_5pct_spread(0);
#define SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIAL(begin, count, other) \
    { \
        const float *term = rows + ((begin) + (count) - 1) * SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH + i; \
        skylight_sh_4_bands_1_5pct_lanes sum = skylight_sh_4_bands_1_5pct_spread(*term); \
        for (t = 1; t < (count); ++t) { \
            term -= SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH; \
            sum = skylight_sh_4_bands_1_5pct_add(sum, power, \
                skylight_sh_4_bands_1_5pct_spread(*term)); \
        } \
        total = skylight_sh_4_bands_1_5pct_add(sum, \
            skylight_sh_4_bands_1_5pct_load(others[other]), total); \
    }
        SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIALS(SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS,
            SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIAL)
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_CLASS
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_4_BANDS_1_5PCT_POLYNOMIAL
    }
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel) {
        for (l = 0; l < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++l) {
            float(*const w)[SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS] = out + channel *
                SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS + l * (l + 1);
            for (m = 0; m <= l; ++m) {
                skylight_sh_4_bands_1_5pct_lanes v = skylight_sh_4_bands_1_5pct_spread(0);
                if (columns[l] >= 0) {
                    for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES; ++k)
                        v = skylight_sh_4_bands_1_5pct_add(
                            skylight_sh_4_bands_1_5pct_load(factors[channel *
                                SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES + k]),
                            sums[k][columns[l] + m], v);
                }
                {
                    const skylight_sh_4_bands_1_5pct_lanes plus = v *
                        skylight_sh_4_bands_1_5pct_load(cosines[m]);
                    const skylight_sh_4_bands_1_5pct_lanes minus = v *
                        skylight_sh_4_bands_1_5pct_load(sines[m]);
                    memcpy(w[-m], &minus, sizeof minus);
                    memcpy(w[m], &plus, sizeof plus);
                }
            }
        }
    }
    (void)k;
    return worst;
}
#endif

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_4_bands_1_5pct_evaluate_batch(
    const skylight_sh_4_bands_1_5pct_real *rows, int count,
        const float *const inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
    const float *azimuths, float
        (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    int s, status, worst = 0;
    for (s = 0; s < count; ++s) {
        status = skylight_sh_4_bands_1_5pct_evaluate_one(rows, inputs, azimuths, s, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* The same with the suns of each weight side by side: `weights` is [channels][weights][count]. */
static inline int skylight_sh_4_bands_1_5pct_evaluate_columns(const skylight_sh_4_bands_1_5pct_real
    *rows, int count,
                                               const float *const
                                                   inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
                                               const float *azimuths, float *weights)
{
    const size_t step = count > 0 ? (size_t)count : 0;
    int s = 0, i, status, worst = 0;
#ifdef SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS
    for (; s + SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS <= count; s += SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS) {
        float out[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS *
            SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS][SKYLIGHT_SH_4_BANDS_1_5PCT_SUNS];
        status = skylight_sh_4_bands_1_5pct_evaluate_suns(rows, inputs, azimuths, s, out);
        worst = status > worst ? status : worst;
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS * SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS;
            ++i)
            memcpy(weights + (size_t)i * step + (size_t)s, out[i], sizeof out[i]);
    }
#endif
    while (s < count) {
        /* Some at once, so that what is written lies together. */
        float some[16][SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS];
        const int now = count - s < 16 ? count - s : 16;
        int k;
        for (k = 0; k < now; ++k) {
            status = skylight_sh_4_bands_1_5pct_evaluate_one(rows, inputs, azimuths, s + k,
                some[k]);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS * SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS;
            ++i)
            for (k = 0; k < now; ++k)
                weights[(size_t)i * step + (size_t)(s + k)] =
                    some[k][i / SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS][i %
                        SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS];
        s += now;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_4_bands_1_5pct_multiply_double(double *products, int count,
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

/* The sums of all terms in double, of the axes' functions. */
static inline void skylight_sh_4_bands_1_5pct_sum_double(
    const skylight_sh_4_bands_1_5pct_real *rows,
        double functions[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_MOST],
    double sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH])
{
    static const int sizes[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = SKYLIGHT_SH_4_BANDS_1_5PCT_SIZES;
    double others[SKYLIGHT_SH_4_BANDS_1_5PCT_OTHERS];
    int axis, count = 1;
    others[0] = 1.0;
    for (axis = 1; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis)
        count = skylight_sh_4_bands_1_5pct_multiply_double(others, count, functions[axis],
            sizes[axis]);
    skylight_sh_4_bands_1_5pct_sum_rows_double(rows, functions[0], others, sums);
    (void)count;
}

/* One channel's sum in double, at a column. */
static inline double skylight_sh_4_bands_1_5pct_mixed_double(double
    sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH],
                                              int channel, int column, const double *factors)
{
    double sum = 0.0;
    int k;
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES; ++k)
        sum += factors[channel * SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES + k] * sums[k][column];
    return sum;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_4_bands_1_5pct_evaluate_gradient(
    const skylight_sh_4_bands_1_5pct_real *rows,
        const float inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES], float azimuth,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    static const short columns[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_COLUMNS;
    double x[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES],
        functions[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_MOST];
    double slopes[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_MOST];
    double factors[1 + SKYLIGHT_SH_4_BANDS_1_5PCT_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_FACTORS];
    double sums[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
    double sloped[SKYLIGHT_SH_4_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_4_BANDS_1_5PCT_WIDTH];
    double powers[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS], power_slopes[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS];
    skylight_sh_4_bands_1_5pct_real cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS];
    int axis, channel, i, l, m, sunk = 0;
    const int status =
        skylight_sh_4_bands_1_5pct_evaluate(rows, inputs, azimuth, SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS,
            weights);
    memset(gradient, 0,
           sizeof(float) * SKYLIGHT_SH_4_BANDS_1_5PCT_AXES * SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS *
               SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS);
    if (status == 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) {
        const double low = skylight_sh_4_bands_1_5pct_slope_range[axis][0];
        const double high = skylight_sh_4_bands_1_5pct_slope_range[axis][1];
        const double v = (double)skylight_sh_4_bands_1_5pct_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_4_bands_1_5pct_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_4_bands_1_5pct_factor_slopes(x, &factors[0][0]);
    for (axis = 0; axis < 1 + SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis)
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_FACTORS; ++i)
            factors[axis][i] *= (double)SKYLIGHT_SH_4_BANDS_1_5PCT_EXPOSURE;
    for (m = 0; m < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++m) {
        powers[m] = 1.0;
        power_slopes[m] = 0.0;
    }
    {
        double sine[2];
        skylight_sh_4_bands_1_5pct_sine_slope(x, sine);
        for (m = 1; m < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++m) {
            powers[m] = powers[m - 1] * sine[0];
            power_slopes[m] = (double)m * powers[m - 1] * sine[1];
        }
    }
    skylight_sh_4_bands_1_5pct_waves((skylight_sh_4_bands_1_5pct_real)azimuth, 1, cosines, sines);
    skylight_sh_4_bands_1_5pct_sum_double(rows, functions, sums);
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_AXES; ++axis) {
        double kept[SKYLIGHT_SH_4_BANDS_1_5PCT_MOST];
        memcpy(kept, functions[axis], sizeof kept);
        memcpy(functions[axis], slopes[axis], sizeof kept);
        skylight_sh_4_bands_1_5pct_sum_double(rows, functions, sloped);
        memcpy(functions[axis], kept, sizeof kept);
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS; ++channel) {
            float *const w = gradient[axis][channel];
            for (l = 0; l < SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS; ++l) {
                for (m = SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST_ORDER(l); m <= l && columns[l] >= 0; ++m)
                    {
                    const int order = m < 0 ? -m : m;
                    const int column = columns[l] + m - SKYLIGHT_SH_4_BANDS_1_5PCT_FIRST_ORDER(l);
                    double value =
                        powers[order] *
                        (skylight_sh_4_bands_1_5pct_mixed_double(sloped, channel, column,
                            factors[0]) +
                         skylight_sh_4_bands_1_5pct_mixed_double(sums, channel, column,
                             factors[1 + axis]));
                    if (axis == SKYLIGHT_SH_4_BANDS_1_5PCT_SUN && !sunk)
                        value += power_slopes[order] *
                                 skylight_sh_4_bands_1_5pct_mixed_double(sums, channel, column,
                                     factors[0]);
                    skylight_sh_4_bands_1_5pct_place((skylight_sh_4_bands_1_5pct_real)value, l, m,
                        cosines, sines, w);
                }
            }
        }
        skylight_sh_4_bands_1_5pct_finish(SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, 0, gradient[axis]);
    }
    (void)power_slopes;
    (void)sunk;
    return status;
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate(skylight_sh_4_bands_1_5pct_rows,
        skylight_sh_4_bands_1_5pct_given, sun_azimuth, SKYLIGHT_SH_4_BANDS_1_5PCT_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_bands(float sun_zenith,
    float sun_azimuth, float turbidity, int bands,
    float weights[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate(skylight_sh_4_bands_1_5pct_rows,
        skylight_sh_4_bands_1_5pct_given, sun_azimuth, bands, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_WEIGHTS])
{
    const float *const skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate_batch(skylight_sh_4_bands_1_5pct_rows, count,
        skylight_sh_4_bands_1_5pct_given, sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_API int skylight_sh_4_bands_1_5pct_weights_columns(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity, float *weights)
{
    const float *const skylight_sh_4_bands_1_5pct_given[SKYLIGHT_SH_4_BANDS_1_5PCT_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_1_5pct_evaluate_columns(skylight_sh_4_bands_1_5pct_rows, count,
        skylight_sh_4_bands_1_5pct_given, sun_azimuth, weights);
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
    return skylight_sh_4_bands_1_5pct_evaluate_gradient(skylight_sh_4_bands_1_5pct_rows,
        skylight_sh_4_bands_1_5pct_given, sun_azimuth, weights, gradient);
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
