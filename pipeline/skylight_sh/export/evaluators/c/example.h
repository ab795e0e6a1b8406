/* What an export writes of one table, and beside it a packed table's stream: with it these files
 * compile as they
   stand. Written by c_header.example. */
#pragma once
#include "linkage.h"

#define SKYLIGHT_SH_HAS_DIRECTION 1
#define SKYLIGHT_SH_HAS_GROUND 1
#define SKYLIGHT_SH_HAS_LIGHTS 1
#define SKYLIGHT_SH_HAS_ROWS 1
#define SKYLIGHT_SH_HAS_SURROUNDINGS 1
#define SKYLIGHT_SH_HAS_TRANSFER 1
#define SKYLIGHT_SH_IS_MIRRORED 1
#define SKYLIGHT_SH_IS_SINGLE 1
#include "vectors.h"
#define SKYLIGHT_SH_VERSION "0.1.0"
#define SKYLIGHT_SH_BANDS 3
#define SKYLIGHT_SH_WEIGHTS 9
#define SKYLIGHT_SH_CHANNELS 3
#define SKYLIGHT_SH_AXES 2
#define SKYLIGHT_SH_UNIT "cd/m2"
#define SKYLIGHT_SH_E_MEAN 0.000000e+00
#define SKYLIGHT_SH_E_MAX 0.000000e+00
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
typedef float skylight_sh_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_FIRST 8
#define SKYLIGHT_SH_OTHERS 3
#define SKYLIGHT_SH_SIZES { 6, 3 }
#define SKYLIGHT_SH_MOST 8
#define SKYLIGHT_SH_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_LUMINANCE { 1.0f, 1.0f, 1.0f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float skylight_sh_inside[SKYLIGHT_SH_AXES][2] = { { -1.57079626e-06f, 1.5707978f },
    { 2.49999666f, 6.00000334f } };
static const skylight_sh_real skylight_sh_range[SKYLIGHT_SH_AXES][2] = { { 0.0f, 1.57079637f },
    { 2.5f, 6.0f } };

/* Classes; a row's numbers, one a sum, and those of the first 1, 2, ..
   bands; room for a class's sums. */
#define SKYLIGHT_SH_CLASSES 3
#define SKYLIGHT_SH_ALL_CLASSES(CLASS) CLASS(0) CLASS(1) CLASS(2)
/* What multiplies the sum of a class for a channel; the channels side by
   side, in fours. */
#define SKYLIGHT_SH_FACTORS 1
#define SKYLIGHT_SH_FACTOR(channel, class_) ((class_) * 4 + (channel))
#define SKYLIGHT_SH_WIDTH 6
#define SKYLIGHT_SH_WIDTHS { 1, 3, 6 }
#define SKYLIGHT_SH_ROOM 16
/* All rows; of each class the first row, how many, and the place of its
   first product. */
#define SKYLIGHT_SH_TERMS 36
#define SKYLIGHT_SH_STARTS { 0, 15, 27 }
#define SKYLIGHT_SH_COUNTS { 15, 12, 9 }
#define SKYLIGHT_SH_PLACES { 0, 16, 28 }
#define SKYLIGHT_SH_PRODUCTS_ROOM 44
/* Of each class and product of the other axes' functions: how many
   functions of the first axis it has. */
#define SKYLIGHT_SH_LENGTHS { { 6, 5, 4 }, { 5, 4, 3 }, { 4, 3, 2 } }
/* The same: of each that has any, class, place of the first product, how
   many, the other axes' product. */
#define SKYLIGHT_SH_PRODUCTS(PRODUCT) \
    PRODUCT(0, 0, 6, 0) \
    PRODUCT(0, 6, 5, 1) \
    PRODUCT(0, 11, 4, 2) \
    PRODUCT(1, 16, 5, 0) \
    PRODUCT(1, 21, 4, 1) \
    PRODUCT(1, 25, 3, 2) \
    PRODUCT(2, 28, 4, 0) \
    PRODUCT(2, 32, 3, 1) \
    PRODUCT(2, 35, 2, 2)
/* Where sums go: of each degree, the first column, or -1 where it carries
   nothing. */
#define SKYLIGHT_SH_COLUMNS { 0, 1, 3 }

/* Of each class, a row a term (functions of the other axes, then of the
   first): its number for every sum. */
SKYLIGHT_SH_ALIGNED
static const skylight_sh_real skylight_sh_rows[226] = {
    0.335605919f, 2.48176026f, -0.100196339f, -0.885888755f, 0.683635235f, 1.80332017f,
    0.171109587f, -0.778772652f, 0.00668307859f, 0.572662771f, -0.680465996f, -0.3431153f,
    -0.114591978f, 0.579275966f, 0.0739984587f, -0.306678981f, -0.109156139f, -0.212203473f,
    -0.140210018f, 0.00196463102f, -0.0487515107f, 0.110092819f, 0.201823011f, -0.00423400663f,
    0.132652149f, -0.0700664371f, -0.0107418122f, -0.0074555492f, -0.0752880052f, -0.0492782928f,
    -0.029313812f, -0.0448129475f, 0.00473997276f, -0.0071456302f, -0.0160068348f, 0.0130905667f,
    -0.0824306533f, 0.180648848f, -0.576504111f, -0.236564249f, -0.683609366f, 0.0308238138f,
    0.115072228f, -0.0899175331f, -0.137138546f, 0.253376365f, 0.298299521f, -0.136412129f,
    -0.0848701745f, 0.309105754f, 0.088253893f, 0.02958427f, -0.13588126f, -0.0353792869f,
    -0.0668912455f, -0.0291926786f, 0.0576372631f, -0.192063183f, 0.0605519153f, 0.000732275366f,
    0.0250204597f, 0.0045588566f, 0.048620224f, -0.0189912282f, -0.0476851538f, -0.0532532781f,
    -0.228986785f, 0.374932557f, -0.0857867748f, 0.254434437f, 0.282612979f, -0.157040507f,
    0.103121042f, 0.0757214054f, 0.11459405f, 0.229828358f, 0.1391882f, 0.168938488f, 0.024257144f,
    0.0139511311f, 0.0291678868f, -0.0104218982f, -0.0520533212f, -0.0393122546f, -0.00317870732f,
    0.0575833097f, -0.0575684831f, -0.0291760862f, -0.00719216745f, 0.0299141016f, 0.644730568f,
    0.0407164171f, -0.827473283f, -0.739131629f, -1.63941622f, -0.332288533f, -0.422089666f,
    -0.286016524f, -0.346090943f, -0.388817519f, -0.501302302f, 0.411037803f, -0.246776253f,
    0.0098612234f, 0.325837284f, 0.11379651f, -0.0216603559f, -0.534997284f, 0.295992315f,
    0.176901296f, -0.225496456f, 0.25041908f, 0.0900957808f, 0.0864783078f, 0.0413550697f,
    0.0509033352f, -0.0409153216f, 0.0616896264f, 0.0332292654f, 0.0594931841f, -0.175980523f,
    0.0727861524f, 0.679218411f, -0.380405605f, 0.0784901381f, -0.432893097f, -0.0543769151f,
    0.234063849f, 0.0307380445f, -0.252243876f, -0.0274623148f, -0.386282116f, -0.0238941032f,
    -0.0698399097f, -0.0400537252f, -0.0133453645f, 0.16385442f, 0.0258796923f, 0.0110663595f,
    0.174117789f, 0.0258447398f, 0.0157341808f, 0.0278725345f, -0.108054213f, -0.130353436f,
    -0.694470286f, 0.0163941365f, 0.175808147f, -0.18745932f, -0.00650094775f, 0.0795061886f,
    -0.0182672478f, -0.223289698f, -0.0958637297f, -0.0213802028f, 0.0388718769f, 0.000587359304f,
    0.0345002636f, -0.0845831037f, 0.0463503636f, -0.0831888467f, 0.012868179f, -1.05557287f,
    0.78973496f, -1.20911455f, 0.577257037f, -0.170365646f, 1.15141737f, 0.640854895f,
    -0.0953702107f, 0.539735198f, -0.118976995f, 0.617406666f, 0.165115371f, -0.140581742f,
    -0.0872742534f, -0.0899328738f, -0.413953394f, -0.0866116956f, -0.36868912f, 0.0795135722f,
    0.0368601158f, -0.230682522f, -0.0229251459f, 0.107126497f, 0.048759345f, 0.988402903f,
    0.166908592f, -0.0954055786f, -0.191024601f, 0.215126127f, -0.567701817f, 0.17677182f,
    -0.017827699f, -0.250385225f, -0.23884578f, 0.0720245913f, -0.00939682405f, 0.131460711f,
    -0.0823968798f, 0.0645129383f, -0.106912106f, 0.0305694249f, 0.102486745f, 0.218447372f,
    0.370838195f, 0.414977312f, -0.0647580698f, 0.0393163897f, 0.116860859f, -0.120993465f,
    0.0335706733f, -0.0920581147f, -0.204746425f, 0.245035082f, 0.185001075f, 0.0f, 0.0f, 0.0f,
    0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f
};
static const skylight_sh_real skylight_sh_transfer[81] = {
    0.515697837f, 0.00917973649f, -0.0126950908f, -0.0408978797f, 0.0766708031f, -0.0541526899f,
    -0.00442940742f, 0.0322324783f, -0.0173834376f, 0.00301109487f, 0.520389199f, 0.0369735248f,
    0.0440984294f, -0.0431277193f, 0.0162604023f, 0.00333409943f, 0.0635076463f, 0.0177834593f,
    0.0284442287f, -0.00532040372f, 0.487923801f, 0.0650829375f, -0.031629622f, 0.030275926f,
    -0.027479019f, -0.0474293232f, -0.0354317985f, 0.00978842843f, -0.00429459009f, -0.0193785727f,
    0.508540273f, 0.00120246247f, 0.0288132373f, -0.071297057f, -0.0259470809f, 0.0415247008f,
    -0.0254532453f, 0.0209539663f, -0.00255466811f, 0.0971167609f, 0.457251728f, 0.00623375271f,
    -0.0102541773f, -0.0120534869f, -0.060587097f, 0.0653026104f, 0.0283337031f, -0.0512208827f,
    0.0999672189f, -0.0124521293f, 0.576281607f, -0.0678380281f, 0.0386075452f, 0.00817843061f,
    0.0859445706f, 0.0282201134f, -0.0818630457f, 0.00373170804f, -0.0105028562f, -0.0361771882f,
    0.529925227f, 0.00305846357f, -0.00635885028f, 0.0319397673f, -0.0360684656f, -0.0559650324f,
    -0.0297765918f, 0.0976747423f, -0.0338703953f, -0.0395283662f, 0.436718166f, -0.00378684374f,
    0.0232722927f, 0.0924392343f, 0.00236403989f, -0.041630514f, 0.092806071f, 0.00936323404f,
    -0.0194348413f, 0.0287196152f, 0.523822427f
};
static const skylight_sh_real skylight_sh_own[27] = {
    -0.00652415212f, -0.0293503348f, 0.140421003f, -0.0201046653f, -0.0718606859f, -0.0768919885f,
    0.0958862603f, -0.125360772f, 0.170026064f, 0.098043859f, 0.0359305292f, -0.046090629f,
    -0.147879198f, 0.0307120401f, -0.0204344057f, -0.00987053849f, -0.0374042578f, 0.150404051f,
    0.126555845f, 0.101513006f, -0.016518034f, 0.0139440484f, -0.0602301881f, 0.0121125299f,
    0.107538395f, -0.1301267f, 0.0966137126f
};
static const skylight_sh_real skylight_sh_below[27] = {
    0.0809229463f, 0.11038819f, -0.0924603865f, 0.134460241f, -0.03365466f, 0.0737809017f,
    0.107076034f, 0.214297026f, 0.00308857975f, -0.0114939185f, 0.0948944166f, 0.0039443844f,
    -0.104300849f, -0.0124256881f, 0.0649470985f, -0.20889312f, -0.100484125f, 0.028380245f,
    -0.0114066489f, 0.166726708f, -0.0220827274f, 0.0593123212f, -0.0453968905f, -0.0283752978f,
    0.0876577497f, 0.296195447f, 0.138556436f
};
#define SKYLIGHT_SH_UNPACKED 334

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_RUNS 3
#define SKYLIGHT_SH_RUN_PROFILE { 2, 0, -1 }
#define SKYLIGHT_SH_CLASS_PROFILE { 0, 0, 0 }
#define SKYLIGHT_SH_STEP 0.000500000024f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_stream[424] = {
    198, 78, 216, 150, 250, 127, 3, 145, 162, 175, 227, 141, 169, 161, 255, 175, 125, 141, 82, 36,
    250, 4, 250, 255, 80, 90, 72, 204, 42, 54, 251, 127, 17, 150, 141, 76, 62, 83, 156, 243, 255,
    177, 15, 38, 45, 92, 53, 145, 255, 127, 33, 14, 160, 98, 248, 36, 252, 127, 209, 116, 136, 141,
    35, 202, 131, 171, 255, 95, 198, 85, 191, 124, 75, 168, 251, 255, 232, 59, 24, 215, 14, 193, 27,
    67, 103, 116, 76, 153, 240, 202, 164, 174, 88, 226, 183, 176, 209, 183, 169, 176, 226, 135, 128,
    80, 234, 190, 102, 159, 60, 215, 233, 234, 80, 71, 100, 75, 181, 187, 99, 246, 112, 98, 135, 57,
    159, 208, 232, 4, 47, 225, 93, 13, 34, 112, 78, 75, 11, 156, 118, 123, 62, 83, 61, 165, 125,
    188, 74, 212, 128, 147, 34, 68, 71, 107, 38, 160, 147, 214, 56, 154, 202, 224, 160, 140, 90, 78,
    5, 216, 145, 229, 251, 80, 159, 89, 28, 181, 189, 66, 242, 111, 233, 169, 20, 243, 232, 122,
    164, 226, 68, 150, 159, 235, 176, 147, 233, 46, 197, 245, 229, 61, 156, 79, 44, 121, 175, 4,
    249, 147, 164, 191, 236, 149, 76, 87, 164, 80, 66, 253, 81, 0, 137, 3, 67, 37, 124, 76, 25, 143,
    220, 180, 36, 148, 79, 12, 1, 177, 208, 32, 128, 35, 108, 200, 161, 71, 151, 100, 175, 133, 246,
    123, 125, 3, 134, 207, 166, 144, 17, 39, 73, 170, 151, 37, 161, 3, 52, 253, 92, 71, 50, 249,
    203, 65, 125, 49, 139, 79, 3, 147, 0, 109, 4, 191, 253, 182, 46, 216, 190, 179, 103, 115, 197,
    72, 200, 16, 5, 22, 137, 16, 190, 115, 83, 78, 19, 170, 109, 221, 218, 38, 65, 215, 232, 240,
    19, 118, 86, 223, 83, 2, 254, 182, 60, 93, 76, 223, 41, 245, 7, 212, 209, 212, 117, 138, 214,
    51, 19, 119, 188, 160, 154, 154, 65, 32, 107, 77, 137, 169, 44, 205, 30, 214, 20, 132, 213, 36,
    117, 113, 2, 229, 39, 16, 133, 114, 20, 186, 143, 62, 141, 152, 211, 71, 69, 70, 140, 208, 154,
    151, 136, 168, 82, 145, 102, 238, 212, 48, 14, 181, 99, 208, 112, 255, 150, 116, 137, 124, 82,
    29, 227, 61, 88, 248, 48, 36, 175, 248, 78, 164, 206, 229, 124, 146, 97, 204, 78, 105, 16, 237,
    184, 176, 159, 16, 54, 149, 180, 0
};

/* What all weights share: the closed form preetham_zenith. */
static inline void skylight_sh_factors(const skylight_sh_real *x, skylight_sh_real *out)
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
    out[0] = 1000.0f * zenith / (tan_below * (1.0f + a * up4) * (1.0f + c * halo8 + e * (cosine *
        cosine)));
    (void)x;
}

/* The functions of sun_zenith (change of variable: reciprocal); 0 where
   there is none. */
static inline void skylight_sh_first(const skylight_sh_real *x, skylight_sh_real *out)
{
    out[0] = 1.0f;
    out[1] = 4.36619759f * (x[0] - 0.0f) / (5.0f - x[0]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 0;
    out[7] = 0;
    (void)x;
}

/* All products of the functions of turbidity (change of variable: log). */
static inline void skylight_sh_others(const skylight_sh_real *x, skylight_sh_real *out)
{
    out[0] = 1.0f;
    out[1] = 1.97706425f * logf((x[1] - 0.5f) * 0.5f) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power
   of `radius`, by doubling. */
static inline void skylight_sh_waves(skylight_sh_real cosine, skylight_sh_real sine,
    skylight_sh_real radius, skylight_sh_real *cosines, skylight_sh_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = radius * cosine;
    sines[1] = radius * sine;
    cosines[2] = cosines[1] * cosines[1] - sines[1] * sines[1];
    sines[0] = 0.0f;
    sines[2] = sines[1] * cosines[1] + cosines[1] * sines[1];
}

/* Cosine and sine of an angle of at most an eighth of a turn. */
static inline void skylight_sh_quarter(skylight_sh_real angle, skylight_sh_real *out)
{
    const float part_1 = angle * angle;
    out[0] = 1.0f - 0.5f * part_1 + part_1 * part_1 * (0.0416666456f + part_1 * ((-0.00138873665f) +
        part_1 * 2.44383464e-05f));
    out[1] = angle + angle * (part_1 * ((-0.166666552f) + part_1 * (0.0083321603f + part_1 *
        (-0.00019515281f))));
}

/* The zonal window's factor for the degree `share` * bands (Habel et al.
   2008, eq. 5). */
static inline float skylight_sh_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double skylight_sh_slope_range[SKYLIGHT_SH_AXES][2] = { { 0.0, 1.5707963267948966 },
    { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_functions(int axis, double v, double *out, double *slopes)
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
        slopes[0] = 0.0;
        slopes[1] = 4.366197723675814 / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
    }
    if (axis == 1) {
        out[0] = 1.0;
        const double part_1 = (v - 0.5) * 0.5;
        out[1] = 1.9770642522272319 * log(part_1) - 1.0;
        const double part_2 = 2.0 * out[1];
        out[2] = part_2 * out[1] - 1.0;
        slopes[0] = 0.0;
        slopes[1] = 1.9770642522272319 * (0.5 / part_1);
        slopes[2] = 2.0 * slopes[1] * out[1] + part_2 * slopes[1];
    }
    (void)v;
}

/* The factors, then their slopes after each axis. */
static inline void skylight_sh_factor_slopes(const double *x, double *out)
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
