/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS];
 *   int status = skylight_sh_4_bands_0_1pct_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN defined before it, it
 * declares only; the one unit that also defines SKYLIGHT_SH_4_BANDS_0_1PCT_IMPLEMENTATION holds
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
 *   Define SKYLIGHT_SH_4_BANDS_0_1PCT_EXPOSURE before this file (where it holds the table) to
 *   multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 0.078 %, E_max 0.208 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 %
 * of its largest in the same set; the window below tames it.
 * Memory: 5310 bytes of constants, laid out for speed.
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-0.1pct
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_1PCT_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN)
#error "Define SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN in every unit, \
SKYLIGHT_SH_4_BANDS_0_1PCT_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_1PCT_API) && defined(SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_DECLARED)
#error "Define SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN before this file is included for the first time."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_1PCT_DECLARED) && !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN)
#error "Leave SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN defined: this file was included with it before."
#endif

#ifndef SKYLIGHT_SH_4_BANDS_0_1PCT_H
#define SKYLIGHT_SH_4_BANDS_0_1PCT_H 0x5bfc17ae

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN
#define SKYLIGHT_SH_4_BANDS_0_1PCT_API static inline
#else
#define SKYLIGHT_SH_4_BANDS_0_1PCT_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_4_BANDS_0_1PCT_API extern "C"
#else
#define SKYLIGHT_SH_4_BANDS_0_1PCT_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_4_BANDS_0_1PCT_EXPOSURE
#define SKYLIGHT_SH_4_BANDS_0_1PCT_EXPOSURE 1
#endif

#define SKYLIGHT_SH_4_BANDS_0_1PCT_VERSION "0.1.0"
#define SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS 4
#define SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS 16
#define SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS 3
#define SKYLIGHT_SH_4_BANDS_0_1PCT_AXES 2
#define SKYLIGHT_SH_4_BANDS_0_1PCT_UNIT "cd/m2"
#define SKYLIGHT_SH_4_BANDS_0_1PCT_E_MEAN 7.803000e-04
#define SKYLIGHT_SH_4_BANDS_0_1PCT_E_MAX 2.080000e-03
#define SKYLIGHT_SH_4_BANDS_0_1PCT_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights_bands(float sun_zenith,
    float sun_azimuth, float turbidity, int bands,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. Suns in a
   row that differ in sun_zenith and azimuth alone cost less. */
SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS]);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights_gradient(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_4_bands_0_1pct_dominant(weights, direction) \
    skylight_sh_4_bands_0_1pct_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_dominant_of(const float *weights,
    float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_4_BANDS_0_1PCT_API void skylight_sh_4_bands_0_1pct_ground(const float
    albedo[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS],
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_4_BANDS_0_1PCT_API void skylight_sh_4_bands_0_1pct_window(int bands,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS]);

#elif SKYLIGHT_SH_4_BANDS_0_1PCT_H != 0x5bfc17ae
#error "Another table has the prefix skylight_sh_4_bands_0_1pct_4_bands_0_1pct already: export one \
of them under a prefix of its own."
#endif /* SKYLIGHT_SH_4_BANDS_0_1PCT_H */

#if (!defined(SKYLIGHT_SH_4_BANDS_0_1PCT_EXTERN) || \
    defined(SKYLIGHT_SH_4_BANDS_0_1PCT_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_DEFINED)
#define SKYLIGHT_SH_4_BANDS_0_1PCT_DEFINED

typedef float skylight_sh_4_bands_0_1pct_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST 12
#define SKYLIGHT_SH_4_BANDS_0_1PCT_OTHERS 6
#define SKYLIGHT_SH_4_BANDS_0_1PCT_SIZES { 10, 6 }
#define SKYLIGHT_SH_4_BANDS_0_1PCT_MOST 12
#define SKYLIGHT_SH_4_BANDS_0_1PCT_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_REFLECTED 0.651470006f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float skylight_sh_4_bands_0_1pct_inside[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_4_bands_0_1pct_real
    skylight_sh_4_bands_0_1pct_range[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][2] = { { 0.0f, 1.57079637f },
    { 2.5f, 6.0f } };

/* Rows, in groups of four; a row's outputs, and those that the first 1, 2,
   .. bands take. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_TERMS 40
#define SKYLIGHT_SH_4_BANDS_0_1PCT_GROUPS 10
#define SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH 32
#define SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTHS { 8, 16, 24, 32 }
/* Of each product of the other axes' functions: how many functions of the
   first axis it has. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_LENGTHS { 10, 9, 8, 7, 5, 1 }
/* The same: the first product's rows; of each other that has any, first
   row, rows, place. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_LEADING 10
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCTS(PRODUCT) \
    PRODUCT(10, 9, 1) \
    PRODUCT(19, 8, 2) \
    PRODUCT(27, 7, 3) \
    PRODUCT(34, 5, 4) \
    PRODUCT(39, 1, 5)
/* Where a row's outputs go: for each band, by channel, degree, order and
   column. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_STORES(BAND, NOTHING, ZONAL, ONE, FOUR) \
    BAND(0, ZONAL(0, 0, 0) ZONAL(1, 0, 1) ZONAL(2, 0, 2)) \
    BAND(1, ZONAL(0, 1, 3) ONE(0, 1, 1, 4) ZONAL(1, 1, 5) ONE(1, 1, 1, 6) ZONAL(2, 1, 7) ONE(2, 1, \
        1, 8)) \
    BAND(2, ZONAL(0, 2, 9) ONE(0, 2, 1, 10) ONE(0, 2, 2, 11) ZONAL(1, 2, 12) ONE(1, 2, 1, 13) \
        ONE(1, 2, 2, 14) ZONAL(2, 2, 15) ONE(2, 2, 1, 16) ONE(2, 2, 2, 17)) \
    BAND(3, FOUR(0, 3, 0, 20) FOUR(1, 3, 0, 24) FOUR(2, 3, 0, 28))

/* A row a term (functions of the other axes, then of the first): its
   coefficient for every output. */
static const skylight_sh_4_bands_0_1pct_real skylight_sh_4_bands_0_1pct_rows[1280] = {
    2.32449198f, 2.64175558f, 3.30527544f, 1.79734671f, 0.92602694f, 2.28846478f, 0.716334105f,
    3.21511984f, 0.589407086f, -0.362872005f, 0.73872757f, 0.515166163f, 0.0128310919f,
    0.635383487f, 0.365136027f, 0.666910529f, 0.643048167f, 0.226192355f, 0.0f, 0.0f, -0.84962213f,
    -0.0538249016f, 0.401886225f, 0.258595109f, -0.827794909f, 0.0647082329f, 0.315501094f,
    0.180326462f, -0.72586906f, 0.263578296f, 0.253747702f, 0.0802822113f, 0.332231522f,
    -0.223514676f, -1.26770115f, -0.105171204f, 0.66652894f, -0.534824014f, 0.415923834f,
    -1.45153356f, 0.100257516f, -0.792714834f, 0.336892366f, 0.507710218f, -0.709991336f,
    0.205788732f, 0.32233572f, -0.768730879f, 0.0288155079f, 0.103325725f, 0.0f, 0.0f, -0.6618191f,
    -0.400010467f, 0.305615783f, 0.287815094f, -0.469713211f, -0.275849462f, 0.203841805f,
    0.185527444f, -0.245134473f, -0.137316585f, 0.0895234346f, 0.0422751904f, -0.0194787979f,
    -0.0736693144f, -0.332981467f, -0.00404524803f, -0.291726947f, -0.0316121578f, -0.301629663f,
    -0.200960994f, -0.461525559f, 0.0744290352f, -0.37121141f, -0.106922746f, 0.110322952f,
    -0.368288994f, -0.121041656f, 0.221025467f, -0.506803036f, -0.198938251f, 0.0f, 0.0f,
    0.176531553f, -0.204538107f, -0.185001254f, -0.0311751366f, 0.213274717f, -0.190888524f,
    -0.18197f, -0.0441710949f, 0.376461029f, -0.211142898f, -0.229500651f, -0.0811841488f,
    -0.0383034945f, -0.00673139095f, -0.00722384453f, 0.0166026354f, -0.0352241993f, 0.0359270573f,
    0.00465261936f, 0.0420655012f, 0.0587269068f, 0.100067973f, 0.0464916229f, -0.092679739f,
    0.0838117599f, 0.0783975124f, -0.0622817278f, 0.0945714712f, 0.141125917f, -0.0381178856f, 0.0f,
    0.0f, 0.0723725557f, 0.16579783f, -0.0515537262f, -0.0720348358f, 0.0509645939f, 0.161992908f,
    -0.0285558701f, -0.0527647734f, 0.0538569689f, 0.191864848f, -0.00558924675f, -0.0325405598f,
    -0.0049456358f, 0.000926017761f, 0.0593553782f, -0.00535476208f, -0.00105071068f,
    -0.00561451912f, 0.00586664677f, 0.0345605612f, 0.0351419449f, -0.015327096f, 0.0127379894f,
    0.00815880299f, -0.0251085758f, 0.0104403496f, 0.0166325569f, -0.0461860895f, 0.0253684521f,
    0.0421094894f, 0.0f, 0.0f, -0.0417448282f, 0.00800263882f, 0.036365509f, -0.00621581078f,
    -0.0478146076f, -0.00616025925f, 0.0378491879f, 0.00230073929f, -0.0811405182f, -0.0243127346f,
    0.0538424253f, 0.0198329687f, 0.00319540501f, 0.00193679333f, -0.0102971792f, 0.00230240822f,
    0.00311982632f, 0.00128149986f, 0.000706672668f, -0.0135015249f, -6.19888306e-06f,
    -0.000530838966f, -0.00217676163f, 0.00217366219f, 0.000829458237f, -0.00544893742f,
    0.000659942627f, -0.00541245937f, -0.0120007992f, 0.00188314915f, 0.0f, 0.0f, 0.00324928761f,
    -0.0142487288f, -0.00203669071f, 0.00558447838f, 0.00726139545f, -0.0148278475f,
    -0.00556397438f, 0.00509345531f, 0.0118517876f, -0.0231664181f, -0.0102828741f, 0.00719928741f,
    0.000468969345f, -8.9764595e-05f, -0.000371932983f, -0.000295519829f, 0.00118970871f,
    -0.000346183777f, 0.000633955002f, 0.00101649761f, -0.00379884243f, -0.000767469406f,
    0.000646114349f, 0.0010342598f, 4.16040421e-05f, 0.000965833664f, 0.000181674957f,
    0.00390923023f, -0.00241887569f, -0.00292170048f, 0.0f, 0.0f, 0.000952363014f, 0.00151705742f,
    -0.000895857811f, 0.000392794609f, 0.00122618675f, 0.00335073471f, -0.00105547905f,
    -0.000487089157f, 0.00493431091f, 0.00527763367f, -0.00387370586f, -0.00264716148f,
    0.000160813332f, 6.1750412e-05f, -0.00046646595f, 1.09672546e-05f, 6.43730164e-05f,
    -8.58306885e-06f, -4.80413437e-05f, -2.07424164e-05f, 0.000254273415f, -0.000181078911f,
    -0.000303268433f, 0.000246047974f, -0.00017952919f, -0.000230669975f, 0.00016283989f,
    0.000376105309f, 0.00126874447f, -0.000450015068f, 0.0f, 0.0f, -0.000336766243f,
    -0.000453829765f, 0.000210404396f, 0.000301241875f, -0.00061237812f, -0.000408411026f,
    0.000455856323f, 0.000156283379f, -0.000993013382f, 0.00166654587f, 0.000932216644f,
    -0.000583291054f, -3.42130661e-05f, 1.07288361e-05f, 0.000254750252f, -4.39882278e-05f,
    3.81469727e-05f, 1.25169754e-05f, 3.20672989e-05f, 0.000159740448f, 1.91926956e-05f,
    2.18153e-05f, 8.34465027e-07f, 7.27176666e-06f, 4.58955765e-05f, 1.12056732e-05f,
    -1.75237656e-05f, -0.00022995472f, -1.53779984e-05f, 0.000168442726f, 0.0f, 0.0f,
    0.000149726868f, -3.05175781e-05f, -0.000118017197f, 4.92334366e-05f, 0.00016438961f,
    -5.69820404e-05f, -0.000132083893f, 3.51667404e-05f, -0.000368356705f, -0.000414848328f,
    0.000262379646f, 8.57114792e-05f, 2.40802765e-05f, -1.31130219e-06f, -6.10351562e-05f,
    7.9870224e-06f, 2.14576721e-05f, -7.62939453e-06f, 2.74181366e-06f, -6.10351562e-05f,
    2.07424164e-05f, -1.70469284e-05f, -7.15255737e-07f, 3.37362289e-05f, -1.3589859e-05f,
    1.07288361e-06f, 1.1920929e-05f, -1.66893005e-06f, -3.2544136e-05f, -3.33786011e-06f, 0.0f,
    0.0f, -1.93119049e-05f, 3.33786011e-06f, 1.38282776e-05f, 2.61068344e-05f, -1.90734863e-05f,
    2.68220901e-05f, 1.40666962e-05f, -2.62260437e-06f, 0.000107765198f, -0.000108957291f,
    -7.35521317e-05f, 3.86238098e-05f, 0.700553775f, 0.644515276f, 0.488860011f, 0.699888945f,
    0.259017706f, 0.763802409f, 0.139597774f, 0.746222615f, 0.0656228065f, 0.169682503f,
    0.260008097f, 0.094381094f, 0.39511621f, 0.170859575f, 0.00900220871f, 0.658198237f,
    0.112657547f, -0.0194481611f, 0.0f, 0.0f, -0.150772333f, 0.0744358301f, 0.106476307f,
    0.0475758314f, 0.0119867325f, 0.097848177f, 0.0361019373f, 0.00644624233f, 0.295527935f,
    0.11618638f, 0.000463724136f, -0.011092782f, 0.02196908f, -0.220518351f, -0.345546007f,
    -0.0686533451f, 0.160464287f, -0.272406816f, 0.052781105f, -0.456612587f, -0.00196588039f,
    -0.20054388f, 0.1108464f, 0.0734075308f, -0.18771112f, 0.0471936464f, -0.0136474371f,
    -0.33706224f, 6.59227371e-05f, -0.022867322f, 0.0f, 0.0f, -0.202326417f, -0.0585075617f,
    0.0649466515f, 0.0442817211f, -0.11378932f, -0.00850772858f, 0.00290942192f, -0.0016977787f,
    -0.167816877f, -0.00237870216f, -0.0141329765f, -0.0113668442f, -0.0560655594f, -0.00917363167f,
    0.101532698f, -0.0378544331f, -0.106979966f, 0.00404083729f, -0.0702940226f, 0.0804891586f,
    -0.0178469419f, 0.0378087759f, -0.137138128f, -0.0464479923f, 0.0353367329f, -0.0907170773f,
    -0.0265558958f, -0.00425136089f, -0.0505313873f, 0.0163303614f, 0.0f, 0.0f, 0.0861836672f,
    -0.084251523f, -0.0681679249f, -0.0190485716f, 0.0576761961f, -0.0611101389f, -0.0389587879f,
    -0.0123097897f, -0.00618958473f, -0.0733128786f, 0.000900745392f, 0.00905323029f,
    -0.0254825354f, 0.0177744627f, 0.0908441544f, -0.00915062428f, -0.00377845764f, 0.0214556456f,
    0.0214679241f, 0.0775680542f, 0.0514891148f, 0.0279505253f, 0.0206054449f, -0.0188108683f,
    0.0126248598f, 0.0365307331f, 0.00427436829f, -0.0019197464f, 0.0586345196f, 0.0269010067f,
    0.0f, 0.0f, 0.0294178724f, 0.0544781685f, -0.0111960173f, -0.0150283575f, 0.00238251686f,
    0.0415405035f, 0.00687098503f, -0.000207304955f, -0.0306259394f, 0.0341809988f, 0.0236722231f,
    0.0138663054f, 0.0150352716f, -0.00124120712f, -0.0400124788f, 0.0113624334f, 0.00756680965f,
    -0.00587308407f, 0.00341510773f, -0.0400693417f, -0.00980889797f, -0.00766766071f,
    0.00868558884f, 0.00864422321f, -0.012270093f, -0.000631690025f, 0.00737786293f, -0.01245749f,
    -0.0166203976f, 1.43051147e-05f, 0.0f, 0.0f, -0.0212221146f, -0.000806331635f, 0.015395999f,
    0.00360453129f, -0.0147049427f, -0.010048151f, 0.0091534853f, 0.00506222248f, 0.000373721123f,
    -0.0172997713f, -0.00123536587f, 0.00170779228f, -0.000383496284f, -6.48498535e-05f,
    -0.00122618675f, -0.00171911716f, 0.00204896927f, 0.000327706337f, -0.00159537792f,
    0.00245952606f, -0.00946736336f, -0.00222814083f, -0.00110161304f, 0.00174462795f,
    0.00202023983f, -0.00348126888f, -0.00136864185f, 0.00891959667f, -0.0083116293f,
    -0.00804591179f, 0.0f, 0.0f, 0.00109684467f, -0.00649797916f, -0.00118076801f, 0.00262832642f,
    0.0050971508f, -0.00380992889f, -0.004098773f, 0.00030875206f, 0.0111373663f, 0.000615954399f,
    -0.00889706612f, -0.00441527367f, -0.00044798851f, -0.000290036201f, 0.00175476074f,
    -0.000390529633f, -0.000987648964f, -4.95910645e-05f, -0.000152111053f, 0.00210905075f,
    0.00258100033f, 0.000416755676f, -0.00113415718f, -0.000520467758f, 0.00045478344f,
    0.000708460808f, -0.000529766083f, 0.000561237335f, 0.00501048565f, 0.000220417976f, 0.0f, 0.0f,
    0.0013487339f, 0.000535130501f, -0.00121724606f, -0.000455260277f, 0.000247597694f,
    0.0024381876f, -0.000205874443f, -0.000842809677f, -0.00206077099f, 0.00554955006f,
    0.00212335587f, -0.000969290733f, -0.000198841095f, -2.86102295e-06f, 0.000512242317f,
    -7.86781311e-06f, -0.000103831291f, 2.22921371e-05f, -8.01086426e-05f, -6.92605972e-05f,
    0.000415444374f, 0.000301480293f, 0.000160098076f, -0.000255465508f, -7.79628754e-05f,
    -2.43186951e-05f, 1.52587891e-05f, -0.00130486488f, -0.000190496445f, 0.00103247166f, 0.0f,
    0.0f, 2.12192535e-05f, 0.000524997711f, 4.67300415e-05f, -0.000232219696f, -0.000429391861f,
    -0.000177741051f, 0.000347733498f, -2.69412994e-05f, -0.00159657001f, -0.00174915791f,
    0.00114834309f, 0.000756978989f, 8.98838043e-05f, -7.15255737e-07f, -0.00027179718f,
    7.12871552e-05f, 4.48226929e-05f, 9.89437103e-06f, 1.01327896e-05f, -0.000238776207f,
    -9.10758972e-05f, -5.40018082e-05f, 7.17639923e-05f, 5.07831573e-05f, 2.30073929e-05f,
    1.3589859e-05f, -1.41859055e-05f, 0.000119805336f, -0.000296592712f, -8.79764557e-05f, 0.0f,
    0.0f, -0.000131845474f, -3.75509262e-05f, 0.000105142593f, 2.14576721e-05f, 7.43865967e-05f,
    -4.529953e-05f, -4.70876694e-05f, 1.22785568e-05f, 0.000569581985f, -0.000324010849f,
    -0.000437736511f, 0.000110507011f, -0.00410366058f, -0.0584887266f, -0.175257802f,
    -0.00716090202f, 0.00147545338f, -0.0567222834f, -0.0184614658f, -0.188179135f, -0.0316590071f,
    -0.00406289101f, -0.00349915028f, -0.00869309902f, -0.00430679321f, -0.0220483541f,
    -0.0196224451f, -0.0581835508f, -0.0408483744f, -0.0166362524f, 0.0f, 0.0f, 0.00518369675f,
    -0.00689148903f, -0.00944161415f, -0.00304222107f, 0.0330665112f, -0.00984847546f,
    -0.0208005905f, -0.00815689564f, 0.0526388884f, -0.024075985f, -0.0221977234f, -0.00620031357f,
    0.00836777687f, -0.00879359245f, 0.0590366125f, 0.0123486519f, 0.00853037834f, 0.00392127037f,
    -0.00382995605f, 0.0753560066f, 0.00130772591f, 0.0131460428f, 0.00689148903f, -0.00754916668f,
    0.026181221f, 0.000946521759f, -0.0161950588f, 0.0502934456f, 0.00594568253f, -0.00670981407f,
    0.0f, 0.0f, 0.012455225f, 0.00164139271f, -0.00687408447f, -0.00245022774f, 0.0274012089f,
    0.0105133057f, -0.0138245821f, -0.00725972652f, 0.018838644f, 0.0125123262f, -0.00711131096f,
    -0.00278925896f, -0.011775732f, 0.00539636612f, 0.0352108479f, -0.0136244297f, 0.00476431847f,
    0.0029219389f, 0.0155233145f, 0.0318768024f, 0.0327033997f, -0.00756514072f, 0.00660479069f,
    0.00259256363f, -0.00613379478f, 0.0208257437f, 0.00822925568f, -0.00313770771f, 0.0415110588f,
    0.015596509f, 0.0f, 0.0f, -0.00306117535f, 0.00394630432f, 0.00390553474f, 0.00175607204f,
    -0.0125511885f, 0.0127584934f, 0.0118602514f, 0.00387430191f, -0.028547287f, 0.0239052773f,
    0.021365881f, 0.00676417351f, -0.00436794758f, 0.0020070076f, 0.0035597086f, -0.00512754917f,
    -0.00231349468f, -0.000265717506f, 1.46627426e-05f, 0.00248396397f, -0.00396180153f,
    -0.00266814232f, -0.00365495682f, 0.000869989395f, -0.00430130959f, -0.00376260281f,
    0.00355708599f, -0.001745224f, -0.00989294052f, 0.00207281113f, 0.0f, 0.0f, 4.17232513e-05f,
    -0.00397789478f, 0.000186562538f, 0.00103020668f, -0.00367665291f, -0.00865364075f,
    0.00210809708f, 0.00285351276f, -0.00296890736f, -0.0145117044f, 0.000412225723f,
    0.00205278397f, 0.00287568569f, -0.00116288662f, -0.00805342197f, 0.00356197357f,
    0.000347495079f, -0.000750184059f, -0.00118732452f, -0.00816476345f, -0.00422918797f,
    0.00239419937f, 0.000712275505f, -0.000499606133f, 0.00123298168f, -0.00146460533f,
    -0.00157809258f, -0.000993490219f, -0.00436592102f, -0.00401425362f, 0.0f, 0.0f, 0.00127923489f,
    0.00127243996f, -0.000846862793f, -0.000322818756f, 0.00303351879f, 9.2625618e-05f,
    -0.00279951096f, -0.000682711601f, 0.00544142723f, 2.43186951e-05f, -0.00564539433f,
    -0.00212109089f, -0.000721931458f, -0.000130534172f, 0.00235414505f, -0.000913739204f,
    8.55922699e-05f, 7.30752945e-05f, -0.000270366669f, 0.00295567513f, 0.000400900841f,
    -0.000687718391f, 0.000163793564f, 3.02791595e-05f, 0.000309348106f, 0.000229120255f,
    -0.000308871269f, 0.00166797638f, 0.00138497353f, 0.000108480453f, 0.0f, 0.0f, -0.000600576401f,
    0.000222921371f, 0.000260591507f, -0.000170469284f, -0.000125646591f, 0.0011087656f,
    0.000169873238f, -0.000532269478f, -0.000365972519f, 0.00221168995f, 0.00104284286f,
    -0.000459671021f, -4.30345535e-05f, 6.92605972e-05f, 0.000168919563f, 2.03847885e-05f,
    -0.000227808952f, 7.92741776e-05f, 7.84397125e-05f, -6.11543655e-05f, 0.000785946846f,
    0.000141739845f, -0.000278353691f, -0.0001090765f, -3.39746475e-05f, 0.000125169754f,
    6.1750412e-05f, -0.00061917305f, 0.000764369965f, 0.000592947006f, 0.0f, 0.0f, 0.000191092491f,
    -0.000229597092f, -0.000113248825f, -2.70605087e-05f, -0.000209331512f, -8.14199448e-05f,
    0.000208735466f, 6.24656677e-05f, -0.000913739204f, -0.000193476677f, 0.000744342804f,
    0.000477910042f, 7.71284103e-05f, 2.18153e-05f, -0.00020802021f, 6.74724579e-05f,
    0.000100135803f, -2.14576721e-06f, 4.4465065e-05f, -0.000249385834f, -0.000186085701f,
    -9.05990601e-06f, 0.000131368637f, 5.45978546e-05f, -4.51803207e-05f, 1.21593475e-05f,
    5.17368317e-05f, -9.64403152e-05f, -0.000404000282f, -4.76837158e-06f, 0.0f, 0.0f,
    -4.93526459e-05f, 8.96453857e-05f, 5.93662262e-05f, 3.67164612e-05f, -1.21593475e-05f,
    -6.96182251e-05f, 1.16825104e-05f, 5.24520874e-05f, 0.000165224075f, -0.000471234322f,
    -0.000191926956f, 7.33137131e-05f, 0.00928783417f, 0.00560867786f, -0.000507354736f,
    0.00533413887f, 0.00452113152f, 0.00116276741f, 0.00142967701f, -0.00756466389f,
    0.000638604164f, -0.00584161282f, 0.00275909901f, 0.00102126598f, -0.00791084766f,
    6.43730164e-05f, -0.000139474869f, -0.0159751177f, -0.000789403915f, 0.000744223595f, 0.0f,
    0.0f, -0.00754463673f, -0.00221800804f, 0.000587701797f, 0.000693202019f, -0.00782132149f,
    -0.00239241123f, -0.000527501106f, 9.52482224e-05f, -0.0136376619f, -0.00304484367f,
    0.000315546989f, 0.000353097916f, 0.00428056717f, 3.01599503e-05f, 0.00409340858f,
    0.00348591805f, 0.00462055206f, 0.00117850304f, 0.00203382969f, 0.00734233856f, 0.00138473511f,
    -0.000186443329f, 0.003277421f, 0.00118517876f, 0.00272488594f, 0.00178468227f, 0.00015771389f,
    0.00853836536f, 0.00160098076f, 0.000738739967f, 0.0f, 0.0f, -0.000700473785f, -0.00119030476f,
    0.000829815865f, 0.000876188278f, 0.00297760963f, 0.000192523003f, 6.73532486e-05f,
    0.000212073326f, 0.00659012794f, 0.000954985619f, 0.000711679459f, 0.000322341919f,
    -0.00148487091f, 0.000135302544f, -0.00296711922f, -0.00170302391f, -0.000577807426f,
    -7.64131546e-05f, 0.000296473503f, -0.00246405602f, -0.000824451447f, -0.000993847847f,
    -0.000188231468f, -0.00014269352f, -0.000608563423f, 0.00109910965f, 0.000278115273f,
    0.000290393829f, 0.00020635128f, -0.000787258148f, 0.0f, 0.0f, -0.000594496727f, 0.00067281723f,
    -9.41753387e-06f, -3.93390656e-06f, -0.00109028816f, 0.0017105341f, 0.000616312027f,
    8.34465027e-05f, 0.00105130672f, 0.00215518475f, -0.000408649445f, -0.000376701355f,
    -0.000109314919f, 2.51531601e-05f, -0.00424826145f, 8.63075256e-05f, -0.000718474388f,
    -7.18832016e-05f, -0.0003926754f, -0.004119277f, -0.00159943104f, 0.000338673592f,
    -0.000658392906f, -0.000397920609f, -0.000182390213f, -0.000707864761f, -0.000174283981f,
    -0.00068962574f, -0.00209653378f, -0.000978112221f, 0.0f, 0.0f, 0.000208497047f,
    -0.00016438961f, -0.000347852707f, -0.000290036201f, -0.00010740757f, -0.000838398933f,
    -0.000237584114f, -0.000125169754f, 0.00136649609f, -0.00155997276f, -0.00109052658f,
    -0.00046312809f, -8.40425491e-05f, -0.000117182732f, 0.00211656094f, -3.67164612e-05f,
    -2.14576721e-05f, -4.63724136e-05f, -5.10215759e-05f, 0.00226092339f, 0.000563025475f,
    0.000110030174f, 6.41345978e-05f, -6.91413879e-05f, 0.00016784668f, -7.15255737e-06f,
    -0.000115871429f, 0.000837683678f, 0.000824332237f, 0.000135540962f, 0.0f, 0.0f,
    0.000190496445f, 0.000201940536f, -5.38825989e-05f, -9.50098038e-05f, 0.000302195549f,
    0.000150561333f, -0.000171780586f, -8.36849213e-05f, -0.000134348869f, 0.000724315643f,
    0.000175952911f, 2.90870667e-05f, -9.05990601e-06f, 4.78029251e-05f, 8.34465027e-05f,
    -3.33786011e-05f, 6.07967377e-05f, 3.85046005e-05f, 6.52074814e-05f, -6.35385513e-05f,
    0.000449895859f, -7.02142715e-05f, 4.19616699e-05f, 5.29289246e-05f, -2.99215317e-05f,
    9.50098038e-05f, 6.52074814e-05f, -0.000365614891f, 0.000452637672f, 0.000366687775f, 0.0f,
    0.0f, -9.56058502e-05f, -3.52859497e-05f, 7.82012939e-05f, 4.42266464e-05f, -0.000109910965f,
    6.90221786e-05f, 0.000114798546f, 3.82661819e-05f, -0.000513553619f, 6.67572021e-05f,
    0.000443339348f, 0.000210881233f, 3.55243683e-05f, 2.0980835e-05f, -0.000137090683f,
    2.39610672e-05f, 3.67164612e-05f, 7.74860382e-06f, 2.68220901e-05f, -0.000149607658f,
    -0.00018465519f, -1.12056732e-05f, 1.58548355e-05f, 3.9100647e-05f, -2.28881836e-05f,
    2.62260437e-06f, 3.12328339e-05f, -2.93254852e-05f, -0.000299453735f, -5.73396683e-05f, 0.0f,
    0.0f, -6.55651093e-06f, -3.39746475e-05f, 1.3589859e-05f, 4.19616699e-05f, -1.97887421e-05f,
    -5.71012497e-05f, 1.58548355e-05f, 3.61204147e-05f, 0.000122904778f, -0.000281333923f,
    -0.000143408775f, 7.9870224e-06f, 0.00170588493f, 0.00115919113f, 2.47955322e-05f,
    0.00158262253f, 0.000617861748f, 0.00118541718f, 0.000100851059f, 0.000293374062f,
    -3.5405159e-05f, 5.00679016e-05f, 0.000581860542f, -4.92334366e-05f, 0.000178098679f,
    0.000128507614f, -0.000221610069f, 0.000265717506f, 3.56435776e-05f, -5.34057617e-05f, 0.0f,
    0.0f, -0.000914335251f, 5.8889389e-05f, 4.8160553e-05f, -4.529953e-06f, -0.000729322433f,
    3.9935112e-05f, -0.00012087822f, -9.08374786e-05f, -0.000571846962f, 7.87973404e-05f,
    2.20537186e-05f, -2.7179718e-05f, 0.000362992287f, -0.000474333763f, 9.27448273e-05f,
    0.0003657341f, 0.000477433205f, -0.000232577324f, 5.68628311e-05f, 0.000235557556f,
    -2.99215317e-05f, 8.0704689e-05f, 0.000458955765f, -0.000118374825f, 0.000383496284f,
    0.000159978867f, -0.00024163723f, 0.000428557396f, 4.92334366e-05f, -7.00950623e-05f, 0.0f,
    0.0f, -0.000114321709f, 6.89029694e-05f, 3.09944153e-06f, -4.26769257e-05f, 0.000479221344f,
    0.000192046165f, -0.000114679337f, -0.000117182732f, 0.000558376312f, 0.000149250031f,
    -6.43730164e-06f, -4.35113907e-05f, -0.000313878059f, 4.4465065e-05f, -0.000287890434f,
    -0.000274062157f, -0.000166893005f, 8.70227814e-06f, -1.8954277e-05f, -0.000444889069f,
    -9.4294548e-05f, -7.74860382e-06f, -0.000164866447f, -6.74724579e-05f, -7.11679459e-05f,
    1.50203705e-05f, 1.69277191e-05f, -0.000373005867f, -0.000170826912f, -2.53915787e-05f, 0.0f,
    0.0f, 8.32080841e-05f, -3.05175781e-05f, -7.10487366e-05f, -2.5510788e-05f, -9.52482224e-05f,
    7.09295273e-05f, 2.28881836e-05f, -9.77516174e-06f, -9.29832458e-05f, -0.0001475811f,
    -7.46250153e-05f, -1.03712082e-05f, 1.82390213e-05f, 8.54730606e-05f, -0.00051009655f,
    6.10351562e-05f, -5.23328781e-05f, 4.94718552e-05f, 4.48226929e-05f, -0.000594258308f,
    -8.95261765e-05f, 9.91821289e-05f, -3.50475311e-05f, -1.51395798e-05f, -4.61339951e-05f,
    -3.57627869e-06f, 4.63724136e-05f, -0.000303030014f, -0.000140428543f, -1.87158585e-05f, 0.0f,
    0.0f, 7.66515732e-05f, 2.15768814e-05f, -2.51531601e-05f, -1.47819519e-05f, -4.91142273e-05f,
    -8.47578049e-05f, 1.78813934e-05f, 2.99215317e-05f, -1.40666962e-05f, -0.000132083893f,
    -5.45978546e-05f, 2.62260437e-06f, 1.32322311e-05f, -1.08480453e-05f, 0.000321030617f,
    -1.37090683e-05f, 4.10079956e-05f, -1.08480453e-05f, 2.15768814e-05f, 0.00040435791f,
    8.13007355e-05f, -5.40018082e-05f, 2.75373459e-05f, 3.55243683e-05f, 1.1920929e-07f,
    1.58548355e-05f, 1.54972076e-05f, 0.000256180763f, 0.000132799149f, 2.99215317e-05f, 0.0f, 0.0f,
    -4.60147858e-05f, -1.57356262e-05f, 2.99215317e-05f, 2.81333923e-05f, 1.23977661e-05f,
    1.1920929e-07f, 7.62939453e-06f, 1.93119049e-05f, 6.6280365e-05f, 0.000126838684f,
    5.50746918e-05f, 1.76429749e-05f, 0.000424742699f, 0.000306129456f, 0.000151991844f,
    0.000359177589f, 0.000179052353f, 0.000278830528f, 3.60012054e-05f, 0.000164628029f,
    8.70227814e-06f, -1.7285347e-05f, 0.000145554543f, 8.34465027e-07f, 3.0875206e-05f,
    2.67028809e-05f, -2.41994858e-05f, 8.04662704e-05f, 1.57356262e-05f, 1.90734863e-06f, 0.0f,
    0.0f, -0.000158667564f, -5.84125519e-06f, 4.05311584e-06f, 8.70227814e-06f, -8.04662704e-05f,
    -2.2649765e-06f, -2.22921371e-05f, -6.55651093e-06f, 2.53915787e-05f, 2.61068344e-05f,
    1.78813934e-06f, -2.86102295e-06f
};

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_4_bands_0_1pct_real skylight_sh_4_bands_0_1pct_scale(const
    skylight_sh_4_bands_0_1pct_real *x)
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
static inline void skylight_sh_4_bands_0_1pct_first(const skylight_sh_4_bands_0_1pct_real *x,
    skylight_sh_4_bands_0_1pct_real *out)
{
    out[0] = 1.0f;
    out[1] = 4.36619759f * (x[0] - 0.0f) / (5.0f - x[0]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    out[7] = 2.0f * out[3] * out[4] - out[1];
    out[8] = 2.0f * out[4] * out[4] - 1.0f;
    out[9] = 2.0f * out[4] * out[5] - out[1];
    out[10] = 0;
    out[11] = 0;
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_4_bands_0_1pct_others(const skylight_sh_4_bands_0_1pct_real *x,
    skylight_sh_4_bands_0_1pct_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.57142878f) * (x[1] - 2.5f) / ((-2.0f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling. */
static inline void skylight_sh_4_bands_0_1pct_waves(skylight_sh_4_bands_0_1pct_real azimuth,
    skylight_sh_4_bands_0_1pct_real *cosines, skylight_sh_4_bands_0_1pct_real *sines)
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
static inline float skylight_sh_4_bands_0_1pct_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double skylight_sh_4_bands_0_1pct_slope_range[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][2] = { {
    0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_4_bands_0_1pct_functions(int axis, double v, double *out,
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
        const double part_9 = 2.0 * out[4];
        out[8] = part_9 * out[4] - 1.0;
        const double part_10 = 2.0 * out[4];
        out[9] = part_10 * out[5] - out[1];
        slopes[0] = 0.0;
        slopes[1] = 4.366197723675814 / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
        slopes[7] = 2.0 * slopes[3] * out[4] + part_8 * slopes[4] - slopes[1];
        slopes[8] = 2.0 * slopes[4] * out[4] + part_9 * slopes[4];
        slopes[9] = 2.0 * slopes[4] * out[5] + part_10 * slopes[5] - slopes[1];
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
        const double part_6 = 2.0 * out[2];
        out[5] = part_6 * out[3] - out[1];
        slopes[0] = 0.0;
        slopes[1] = (-4.5714285714285712) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
    }
    (void)v;
}

/* What all weights share, then its slopes after the axes. */
static inline void skylight_sh_4_bands_0_1pct_scale_slopes(const double *x, double *out)
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
static inline int skylight_sh_4_bands_0_1pct_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_4_bands_0_1pct_finite(float v)
{
    if (skylight_sh_4_bands_0_1pct_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_4_bands_0_1pct_inputs(const float
    inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES], float azimuth,
                                     skylight_sh_4_bands_0_1pct_real
                                         x[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES])
{
    int axis, status = 0, strange = skylight_sh_4_bands_0_1pct_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_AXES; ++axis) strange |=
        skylight_sh_4_bands_0_1pct_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_AXES; ++axis) {
        const float v = skylight_sh_4_bands_0_1pct_finite(inputs[axis]);
        const skylight_sh_4_bands_0_1pct_real low = skylight_sh_4_bands_0_1pct_range[axis][0],
            high = skylight_sh_4_bands_0_1pct_range[axis][1];
        const skylight_sh_4_bands_0_1pct_real at_least = (skylight_sh_4_bands_0_1pct_real)v < low ?
            low : (skylight_sh_4_bands_0_1pct_real)v;
        status |= (v < skylight_sh_4_bands_0_1pct_inside[axis][0]) | (v >
            skylight_sh_4_bands_0_1pct_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_4_bands_0_1pct_place(skylight_sh_4_bands_0_1pct_real value, int l,
    int m,
                                     const skylight_sh_4_bands_0_1pct_real *cosines,
                                         const skylight_sh_4_bands_0_1pct_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* sums[k] = sum over t of products[t] * row[t][k] for 4 * groups terms, four rows a pass: no
   reduction, so that it vectorises. */
static inline void skylight_sh_4_bands_0_1pct_sum(const skylight_sh_4_bands_0_1pct_real *row,
    int groups,
                                   const skylight_sh_4_bands_0_1pct_real *products, int width,
                                   skylight_sh_4_bands_0_1pct_real *sums)
{
    int group, k;
    {
        const skylight_sh_4_bands_0_1pct_real a = products[0], b = products[1], c = products[2],
            d = products[3];
        for (k = 0; k < width; ++k)
            sums[k] = (a * row[k] + b * row[k + SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH]) +
                      (c * row[k + 2 * SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH] + d * row[k + 3 *
                          SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH]);
    }
    for (group = 1; group < groups; ++group) {
        const skylight_sh_4_bands_0_1pct_real a = products[4 * group], b = products[4 * group + 1];
        const skylight_sh_4_bands_0_1pct_real c = products[4 * group + 2],
            d = products[4 * group + 3];
        row += 4 * SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH;
        for (k = 0; k < width; ++k)
            sums[k] += (a * row[k] + b * row[k + SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH]) +
                       (c * row[k + 2 * SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH] + d * row[k + 3 *
                           SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH]);
    }
}

/* Zeroes what carries nothing. */
static inline void skylight_sh_4_bands_0_1pct_clear(float *weights, int count)
{
    int i;
    for (i = 0; i < count; ++i) weights[i] = 0.0f;
}

/* Four orders m of one degree and channel: m >= 0 forwards, m < 0 backwards (eq. 4 with nothing
   stored for m < 0). */
static inline void skylight_sh_4_bands_0_1pct_place_four(const skylight_sh_4_bands_0_1pct_real
    *sums,
                                          const skylight_sh_4_bands_0_1pct_real *cosines,
                                          const skylight_sh_4_bands_0_1pct_real *sines, float *plus,
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
static inline void skylight_sh_4_bands_0_1pct_store(const skylight_sh_4_bands_0_1pct_real *sums,
    const skylight_sh_4_bands_0_1pct_real *cosines,
                                     const skylight_sh_4_bands_0_1pct_real *sines, int bands,
                                     float
                                         weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS]
                                         [SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
#define SKYLIGHT_SH_4_BANDS_0_1PCT_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_4_BANDS_0_1PCT_NOTHING(channel, l) \
    skylight_sh_4_bands_0_1pct_clear(weights[channel] + (l) * (l), 2 * (l) + 1);
#define SKYLIGHT_SH_4_BANDS_0_1PCT_ZONAL(channel, l, column) \
    weights[channel][(l) * ((l) + 1)] = (float)sums[column];
#define SKYLIGHT_SH_4_BANDS_0_1PCT_ONE(channel, l, m, column) \
    weights[channel][(l) * ((l) + 1) - (m)] = (float)(sums[column] * sines[m]); \
    weights[channel][(l) * ((l) + 1) + (m)] = (float)(sums[column] * cosines[m]);
#define SKYLIGHT_SH_4_BANDS_0_1PCT_FOUR(channel, l, m, column) \
    skylight_sh_4_bands_0_1pct_place_four(sums + (column), cosines + (m), sines + (m), \
                           weights[channel] + (l) * ((l) + 1) + (m), \
                           weights[channel] + (l) * ((l) + 1) - (m) - 3);
    SKYLIGHT_SH_4_BANDS_0_1PCT_STORES(SKYLIGHT_SH_4_BANDS_0_1PCT_BAND,
        SKYLIGHT_SH_4_BANDS_0_1PCT_NOTHING, SKYLIGHT_SH_4_BANDS_0_1PCT_ZONAL,
        SKYLIGHT_SH_4_BANDS_0_1PCT_ONE,
                       SKYLIGHT_SH_4_BANDS_0_1PCT_FOUR)
#undef SKYLIGHT_SH_4_BANDS_0_1PCT_BAND
#undef SKYLIGHT_SH_4_BANDS_0_1PCT_NOTHING
#undef SKYLIGHT_SH_4_BANDS_0_1PCT_ZONAL
#undef SKYLIGHT_SH_4_BANDS_0_1PCT_ONE
#undef SKYLIGHT_SH_4_BANDS_0_1PCT_FOUR
    (void)cosines;
    (void)sines;
}

/* Sums the table's terms and stores the first `bands` bands. */
static inline void skylight_sh_4_bands_0_1pct_combine(const skylight_sh_4_bands_0_1pct_real *first,
                                       const skylight_sh_4_bands_0_1pct_real *others,
                                       const skylight_sh_4_bands_0_1pct_real *cosines,
                                       const skylight_sh_4_bands_0_1pct_real *sines, int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    static const unsigned short widths[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS] =
        SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTHS;
    skylight_sh_4_bands_0_1pct_real products[4 * SKYLIGHT_SH_4_BANDS_0_1PCT_GROUPS + 8],
        sums[SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH];
    int i;
    /* In fours: each overshoot is overwritten by the next line. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCT(start, count, other) \
    for (i = 0; i < ((count) + 3) / 4 * 4; ++i) products[(start) + i] = first[i] * others[other];
    SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCT(0, SKYLIGHT_SH_4_BANDS_0_1PCT_LEADING, 0)
    SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCTS(SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCT)
#undef SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCT
    /* A last group of four may have rows of zeros. */
    for (i = SKYLIGHT_SH_4_BANDS_0_1PCT_TERMS; i < 4 * SKYLIGHT_SH_4_BANDS_0_1PCT_GROUPS; ++i)
        products[i] = 0;
    if (bands == SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS)
        skylight_sh_4_bands_0_1pct_sum(skylight_sh_4_bands_0_1pct_rows,
            SKYLIGHT_SH_4_BANDS_0_1PCT_GROUPS, products, SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH, sums);
    else
        skylight_sh_4_bands_0_1pct_sum(skylight_sh_4_bands_0_1pct_rows,
            SKYLIGHT_SH_4_BANDS_0_1PCT_GROUPS, products, widths[bands - 1], sums);
    skylight_sh_4_bands_0_1pct_store(sums, cosines, sines, bands, weights);
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_0_1pct_combine_double(
    const double *first, const double *others, const skylight_sh_4_bands_0_1pct_real *cosines,
    const skylight_sh_4_bands_0_1pct_real *sines,
        float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    static const unsigned char lengths[SKYLIGHT_SH_4_BANDS_0_1PCT_OTHERS] =
        SKYLIGHT_SH_4_BANDS_0_1PCT_LENGTHS;
    const skylight_sh_4_bands_0_1pct_real *row = skylight_sh_4_bands_0_1pct_rows;
    double exact[SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH];
    skylight_sh_4_bands_0_1pct_real sums[SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH];
    int i, k, other;
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH; ++k) exact[k] = 0.0;
    for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_1PCT_OTHERS; ++other) {
        for (i = 0; i < lengths[other]; ++i) {
            const double product = first[i] * others[other];
            for (k = 0; k < SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH; ++k) exact[k] += product *
                (double)row[k];
            row += SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH;
        }
    }
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH; ++k) sums[k] =
        (skylight_sh_4_bands_0_1pct_real)exact[k];
    skylight_sh_4_bands_0_1pct_store(sums, cosines, sines, SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS,
        weights);
}

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_4_bands_0_1pct_finish(int bands, int lights,
    const skylight_sh_4_bands_0_1pct_real *cosines,
                                      const skylight_sh_4_bands_0_1pct_real *sines,
                                      float
                                          weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS]
                                          [SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    if (bands < SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS; ++i) weights[channel][i]
                = 0.0f;
    }
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS, clamped like an input)
 * and zeroes the
   rest; returns the status. */
static inline int skylight_sh_4_bands_0_1pct_evaluate(const float
    inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES], float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    skylight_sh_4_bands_0_1pct_real x[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES],
        first[SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST], others[SKYLIGHT_SH_4_BANDS_0_1PCT_OTHERS];
    skylight_sh_4_bands_0_1pct_real cosines[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS], scale;
    int i, status = skylight_sh_4_bands_0_1pct_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS *
            SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS;
        status = 1;
    }
    scale = skylight_sh_4_bands_0_1pct_scale(x) *
        (skylight_sh_4_bands_0_1pct_real)SKYLIGHT_SH_4_BANDS_0_1PCT_EXPOSURE;
    skylight_sh_4_bands_0_1pct_first(x, first);
    skylight_sh_4_bands_0_1pct_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_1PCT_OTHERS; ++i) others[i] *= scale;
    skylight_sh_4_bands_0_1pct_waves((skylight_sh_4_bands_0_1pct_real)azimuth, cosines, sines);
    skylight_sh_4_bands_0_1pct_combine(first, others, cosines, sines, bands, weights);
    skylight_sh_4_bands_0_1pct_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_4_bands_0_1pct_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES], const float *azimuths,
    float (*weights)[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    int s, axis, worst = 0;
    /* The rows summed over the other axes once, for all suns in a row that share them. */
    skylight_sh_4_bands_0_1pct_real line[SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST *
        SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH], shared[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES];
    int ready = 0;
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_4_BANDS_0_1PCT_AZIMUTH;
        float sun[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES];
        int status;
        skylight_sh_4_bands_0_1pct_real x[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES],
            first[SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST], sums[SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH];
        skylight_sh_4_bands_0_1pct_real cosines[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS],
            sines[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS], scale;
        int i;
        for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_AXES; ++axis) sun[axis] = inputs[axis][s];
        status = skylight_sh_4_bands_0_1pct_inputs(sun, azimuth, x);
        worst = status > worst ? status : worst;
        if (status == 2) {
            memset(weights[s], 0, sizeof weights[s]);
            continue;
        }
        ready = ready && !memcmp(x + 1, shared + 1,
            sizeof *x * (SKYLIGHT_SH_4_BANDS_0_1PCT_AXES - 1));
        if (!ready) {
            skylight_sh_4_bands_0_1pct_real others[SKYLIGHT_SH_4_BANDS_0_1PCT_OTHERS];
            skylight_sh_4_bands_0_1pct_others(x, others);
            for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_1PCT_LEADING * SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH;
                ++i)
                line[i] = others[0] * skylight_sh_4_bands_0_1pct_rows[i];
            for (; i < SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST * SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH; ++i)
                line[i] = 0;
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCT(start, count, other) \
    for (i = 0; i < (count) * SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH; ++i) \
        line[i] += others[other] * skylight_sh_4_bands_0_1pct_rows[(start) * \
            SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH + i];
            SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCTS(SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCT)
#undef SKYLIGHT_SH_4_BANDS_0_1PCT_PRODUCT
            memcpy(shared, x, sizeof shared);
            ready = 1;
        }
        scale = skylight_sh_4_bands_0_1pct_scale(x) *
            (skylight_sh_4_bands_0_1pct_real)SKYLIGHT_SH_4_BANDS_0_1PCT_EXPOSURE;
        skylight_sh_4_bands_0_1pct_first(x, first);
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST; ++i) first[i] *= scale;
        skylight_sh_4_bands_0_1pct_waves((skylight_sh_4_bands_0_1pct_real)azimuth, cosines, sines);
        skylight_sh_4_bands_0_1pct_sum(line, SKYLIGHT_SH_4_BANDS_0_1PCT_FIRST / 4, first,
            SKYLIGHT_SH_4_BANDS_0_1PCT_WIDTH, sums);
        skylight_sh_4_bands_0_1pct_store(sums, cosines, sines, SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS,
            weights[s]);
        skylight_sh_4_bands_0_1pct_finish(SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS, 1, cosines, sines,
            weights[s]);
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_4_bands_0_1pct_multiply(double *products, int count,
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
static inline int skylight_sh_4_bands_0_1pct_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES], float azimuth,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES] = SKYLIGHT_SH_4_BANDS_0_1PCT_SIZES;
    double x[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES],
        functions[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_MOST];
    double slopes[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_MOST],
        scale[1 + SKYLIGHT_SH_4_BANDS_0_1PCT_AXES];
    skylight_sh_4_bands_0_1pct_real cosines[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS];
    int axis, other, i;
    const int status = skylight_sh_4_bands_0_1pct_evaluate(inputs, azimuth,
        SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_4_BANDS_0_1PCT_AXES * SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS
                   * SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_AXES; ++axis) {
        const double low = skylight_sh_4_bands_0_1pct_slope_range[axis][0];
        const double high = skylight_sh_4_bands_0_1pct_slope_range[axis][1];
        const double v = (double)skylight_sh_4_bands_0_1pct_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_4_bands_0_1pct_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_4_bands_0_1pct_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_4_BANDS_0_1PCT_AXES; ++i) scale[i] *=
        (double)SKYLIGHT_SH_4_BANDS_0_1PCT_EXPOSURE;
    skylight_sh_4_bands_0_1pct_waves((skylight_sh_4_bands_0_1pct_real)azimuth, cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_AXES; ++axis) {
        double first[SKYLIGHT_SH_4_BANDS_0_1PCT_MOST], others[SKYLIGHT_SH_4_BANDS_0_1PCT_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_1PCT_AXES; ++other) {
            double one[SKYLIGHT_SH_4_BANDS_0_1PCT_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_4_bands_0_1pct_multiply(others, count, one,
                sizes[other]);
        }
        skylight_sh_4_bands_0_1pct_combine_double(first, others, cosines, sines, gradient[axis]);
        skylight_sh_4_bands_0_1pct_finish(SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS, 0, cosines, sines,
            gradient[axis]);
    }
    return status;
}

SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_0_1pct_given[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_0_1pct_evaluate(skylight_sh_4_bands_0_1pct_given, sun_azimuth,
        SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights_bands(float sun_zenith,
    float sun_azimuth, float turbidity, int bands,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_0_1pct_given[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_0_1pct_evaluate(skylight_sh_4_bands_0_1pct_given, sun_azimuth, bands,
        weights);
}

SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    const float *const skylight_sh_4_bands_0_1pct_given[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_0_1pct_evaluate_batch(count, skylight_sh_4_bands_0_1pct_given,
        sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_weights_gradient(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    const float skylight_sh_4_bands_0_1pct_given[SKYLIGHT_SH_4_BANDS_0_1PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_4_bands_0_1pct_evaluate_gradient(skylight_sh_4_bands_0_1pct_given,
        sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_4_BANDS_0_1PCT_API int skylight_sh_4_bands_0_1pct_dominant_of(const float *weights,
    float direction[3])
{
    static const float luminance[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS] =
        SKYLIGHT_SH_4_BANDS_0_1PCT_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS + 1;
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
SKYLIGHT_SH_4_BANDS_0_1PCT_API void skylight_sh_4_bands_0_1pct_ground(
    const float albedo[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS],
    float weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS] = SKYLIGHT_SH_4_BANDS_0_1PCT_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_4_BANDS_0_1PCT_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS; ++l) weights[channel][l * (l + 1)] +=
            radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_4_BANDS_0_1PCT_API void skylight_sh_4_bands_0_1pct_window(
    int bands, float
        weights[SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_4_BANDS_0_1PCT_BANDS; ++l) {
        const float factor = skylight_sh_4_bands_0_1pct_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_4_BANDS_0_1PCT_DEFINED */
