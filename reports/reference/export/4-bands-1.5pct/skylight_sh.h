/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything (CC0-1.0).
 * C99 and C++11, header only, no allocation, no global written.
 *
 * Usage
 *   float w[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
 *   int status = skylight_sh_weights(0.785000026f, 0.0f, 4.25f, w);
 *
 * Inputs
 *   sun_zenith: [0, 1.57079633] rad
 *   turbidity: [2.5, 6]
 *   sun_azimuth: any finite angle, rad
 * Output
 *   w[channel][l*(l+1)+m], channels red, green, blue, linear, luminance-scaled cd/m2. Real orthonormal
 *   spherical harmonics without the Condon-Shortley sign, z up, m > 0 cosine, m < 0 sine; the azimuth turns from +x
 *   towards +y. The lower hemisphere is black. Returns 0; 1 where an input lay outside its range and was clamped;
 *   2 (weights zeroed) where one was NaN or the azimuth infinite.
 *
 * Accuracy, as shipped: E_mean 1.49 %, E_max 3.83 % of the least radiance (per-set), at azimuth 0.
 * Memory: 2610 bytes of constants.
 *
 * Provenance
 *   config preetham, table 4-bands-1.5pct
 *   selection 1a277e3352e7ffa6dd07af41fa4659b373c8f4cb51430ce60661c64888bcc869
 *   python 3.11.7, numpy 2.4.6, scipy 1.17.1, h5py 3.16.0, dask 2026.8.0
 *   x86_64: AVX512_ICL X86_V2 X86_V3 X86_V4
 */
#ifndef SKYLIGHT_SH_H
#define SKYLIGHT_SH_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define SKYLIGHT_SH_BANDS 4
#define SKYLIGHT_SH_WEIGHTS 16
#define SKYLIGHT_SH_CHANNELS 3

typedef float skylight_sh_real;

static const skylight_sh_real skylight_sh_coefficients[579] = {
    2.30991006f, 0.303173512f, -0.0224130452f, -0.0348740518f, -0.00484658591f, 0.00295653823f, 0.704159498f, 0.017491214f,
    -0.0570671037f, -0.0250253975f, 0.0151718138f, -0.00307031232f, 0.00943901017f, -0.0120073557f, -0.00458223233f, 0.00295676524f,
    0.00868938025f, 0.00429421943f, -0.0015099491f, 0.00147130364f, 2.62845135f, -0.253005981f, -0.073704727f, -0.00242236326f,
    0.000388400105f, 0.0016144776f, 0.650558412f, -0.224555433f, -0.0099103963f, 0.0179002322f, -0.00126880431f, -0.0572806485f,
    -0.00735149439f, 0.00514648668f, 0.00168513635f, 0.00486279279f, 3.29398561f, -1.29745317f, -0.326197714f, -0.000174492292f,
    0.057737425f, -0.0110993544f, 0.498122245f, -0.350209832f, 0.0989644602f, 0.0898335651f, -0.0398771651f, -0.000948124216f,
    0.00177999819f, -0.174221173f, 0.0612346567f, 0.034581203f, 0.00303386734f, -0.00792013574f, 0.00243312167f, -0.00159728341f,
    0.00463737966f, -0.00280435616f, -0.00422864594f, 0.00210949616f, 1.78848219f, -0.12551485f, -0.00481251068f, 0.0190616138f,
    -0.00577127468f, 0.00214821915f, 0.702033937f, -0.074587144f, -0.0384603888f, -0.00841931067f, 0.0114022167f, -0.00185022166f,
    -0.00620311964f, 0.0131987501f, -0.01386589f, -0.0052669323f, 0.00366195966f, 0.00485149631f, 0.00363143766f, -0.00174292643f,
    0.00137590594f, 2.27929831f, -0.558455348f, -0.0303479023f, 0.0393734127f, -0.00651460607f, 0.768089116f, -0.278909266f,
    0.0035970246f, 0.0220116079f, -0.00595601602f, -0.0554652698f, 0.0052033877f, 0.00260252017f, 0.000499922957f, 0.00148397649f,
    3.2058537f, -1.47983897f, -0.19437094f, 0.0480665453f, 0.0326958671f, -0.0140337627f, 0.0013233592f, 0.754150867f,
    -0.464094311f, 0.0789989606f, 0.0774447843f, -0.0400626883f, 0.00262243487f, 0.00213305769f, -0.18682614f, 0.0776052177f,
    0.0310680177f, 0.00192167307f, -0.00798503868f, 0.00303392205f, -0.0086587593f, 0.00804338604f, -0.00235909596f, -0.00413586712f,
    0.00226618908f, 0.91714114f, 0.653325319f, -0.293948025f, -0.0322735943f, -0.000474196626f, 0.00277728261f, 0.00116307393f,
    0.260073453f, 0.15996407f, -0.108417936f, -0.00353871146f, 0.00766095426f, 0.00199201237f, 0.00192834216f, 0.00897791702f,
    0.00455325842f, -0.00250985939f, 0.00429488905f, 0.00447025849f, 0.709968626f, 0.406575203f, -0.302542061f, 0.00726016238f,
    0.00604836643f, 0.141128913f, 0.0531089827f, -0.0714843199f, 0.0214874223f, 0.0034051335f, -0.00160291151f, -0.0180668011f,
    -0.00339800934f, 0.0153708849f, 0.00123203394f, 0.00194273272f, 0.585599244f, 0.0950859562f, -0.459987938f, 0.0618061461f,
    0.0346710533f, -0.000631736999f, -0.00368344318f, 0.0673371553f, -0.00190289761f, -0.0197601262f, 0.0512206778f, -0.00971969776f,
    -0.00931646395f, 0.00260057417f, -0.0313957594f, 0.00163175643f, 0.0325399525f, -0.00418346841f, -0.00416577002f, 0.000446328195f,
    0.00137294165f, -0.000644793035f, -0.00161824317f, -0.355758786f, -0.784146845f, 0.0777081028f, 0.0989429727f, -0.0162966605f,
    0.168189451f, -0.204311743f, 0.038494803f, 0.0285239834f, -0.0078781005f, -0.00224122894f, -0.00401284127f, 0.012918679f,
    -0.00763847725f, -0.00255684904f, 0.00244637462f, -0.00577968219f, 0.0175899081f, -0.706431091f, 0.112793282f, 0.0830717757f,
    -0.0259530991f, 0.39348796f, -0.193484873f, 0.0359290503f, 0.0134680849f, -0.0124420766f, 0.00199553487f, -0.00398878288f,
    0.0261170939f, -0.00633128872f, -0.00426879991f, 0.00131186377f, -0.00793409441f, 0.00305778044f, 0.668524265f, -0.773248255f,
    0.222548112f, 0.094146356f, -0.0470994972f, -0.0049971533f, 0.00403648382f, 0.657920659f, -0.344217092f, -0.0026013162f,
    -0.000414751761f, -0.0127473706f, 0.00876881462f, 0.000576985825f, -0.00130285602f, -0.0573671684f, 0.0508083031f, -0.00364163308f,
    -0.00189449009f, -0.000871886266f, 0.00167682068f, -0.0162432082f, 0.00903886184f, 0.732971013f, 0.328260005f, -0.371685505f,
    0.0492449477f, 0.0126286764f, -0.0026093307f, 0.260570973f, 0.10951446f, -0.138556689f, 0.0212400611f, 0.00875901897f,
    -0.00120707566f, -0.00305698416f, 0.00727664307f, 0.00633860752f, -0.00382764614f, 0.00256756088f, 0.00321202655f, 0.630864501f,
    0.199027374f, -0.368145823f, 0.0809189007f, 0.0100871921f, -0.00585162174f, 0.171870679f, 0.0465147868f, -0.0920850635f,
    0.0369190387f, -0.000612386793f, -0.00351333758f, -0.021643389f, 0.00135215907f, 0.0206008945f, -0.00397343514f, -0.00139927329f,
    -0.000120030316f, 0.00175591523f, 0.00121968449f, 0.639497817f, 0.0236715209f, -0.505213737f, 0.144146442f, 0.0244944021f,
    -0.0125637827f, -0.00217134343f, 0.00131404761f, 0.114214927f, -0.000466634636f, -0.0524648875f, 0.0588522628f, -0.0165022723f,
    -0.00823876169f, 0.00501386588f, -0.0405063927f, 0.00633941591f, 0.0412582867f, -0.0101701729f, -0.00425811764f, 0.00143292069f,
    -0.00100634049f, 0.0016243062f, 0.000410686072f, -0.00215303292f, 0.509256899f, 0.499211669f, -0.108745418f, -0.0910532624f,
    0.00893544126f, 0.00197785604f, 0.0953956023f, 0.0741865411f, -0.0469202846f, -0.0189707987f, 0.00871785451f, 0.0017212705f,
    -0.00837578252f, -0.00716451835f, 0.00255982811f, 0.361066431f, 0.316653758f, -0.12187627f, -0.0608819537f, 0.0170969348f,
    0.0104250489f, -0.0122042652f, -0.0268206317f, 0.00396460295f, 0.00735023897f, -0.00136103027f, -0.0193680134f, -0.0158652421f,
    0.0082276985f, 0.00344155636f, -0.00159226474f, 0.224224702f, 0.101041503f, -0.198152095f, -0.0366181396f, 0.0421636999f,
    0.00145581388f, -0.00293024164f, -0.0183558073f, -0.0221119337f, 0.0154681671f, 0.0263385493f, 5.61740162e-05f, -0.00791336875f,
    -0.0165300518f, -0.00656378502f, 0.0155771803f, 0.00198902446f, -0.00400232757f, -0.840984941f, -0.649004221f, 0.179114819f,
    0.0702709034f, -0.0423115045f, 0.00369389285f, -0.151912332f, -0.202656269f, 0.0873674676f, 0.0294058044f, -0.0215360504f,
    0.00120129576f, 0.00136591389f, 0.00471536396f, 0.0117993876f, -0.00301201781f, 0.000227616547f, 0.00126501743f, -0.00733358739f,
    -0.820146084f, -0.458317727f, 0.214688554f, 0.0486766584f, -0.0481149815f, 0.00774877472f, 0.00120540184f, 0.0095716035f,
    -0.115745679f, 0.0588063486f, 0.00274490053f, -0.0149412826f, 0.00512668118f, 0.0326465964f, 0.026600657f, -0.0125748562f,
    -0.00347021571f, 0.00304781576f, -0.00757481065f, 0.00318396534f, -0.00118290551f, -0.719728172f, -0.237157255f, 0.375473678f,
    0.0507436879f, -0.0811701342f, 0.0126109272f, 0.00484505715f, 0.292195529f, -0.171549439f, -0.00378853828f, -0.0293410495f,
    -3.71276692e-05f, 0.0109812925f, -0.00203269045f, -0.0015926871f, 0.0526037179f, 0.0180455595f, -0.0286141261f, -0.00273927487f,
    0.0054555065f, -0.013389782f, 0.00683198916f, 0.000855021353f, 0.00129875669f, -0.0508511327f, -0.395952791f, -0.202355385f,
    0.166131765f, 0.00688113691f, -0.0143904043f, 0.00174058205f, 0.0740123391f, -0.0600096993f, -0.0845359713f, 0.0553099923f,
    -0.000901408435f, -0.00661034044f, -0.00681357412f, 0.00161113217f, 0.00378985098f, -0.00396532146f, 0.0013391315f, -0.00222067162f,
    0.0662930831f, -0.273950845f, -0.189431876f, 0.162451789f, -0.00713752396f, -0.0149014257f, 0.00357231218f, 0.0974323079f,
    -0.0101813069f, -0.0616637021f, 0.0423057191f, -0.0100736115f, -0.00387264462f, 0.00245448481f, -0.00975289941f, 0.0105400654f,
    0.0125810578f, -0.00870150514f, -0.00242209435f, 0.000292061944f, 0.00177136261f, 0.263219953f, -0.13853626f, -0.210605487f,
    0.1925852f, -0.0252446216f, -0.023153197f, 0.00556033431f, 0.00161577703f, 0.116329402f, -0.00362515938f, -0.0738475472f,
    0.0351049863f, -0.017287083f, 0.000475534325f, 0.00555235613f, -0.00173520588f, -0.0238814987f, 0.0126957353f, 0.0236810092f,
    -0.0146537796f, 0.000137037889f, 0.00222189561f, -0.00314136548f, 0.00103507494f, 0.00224634004f, -0.00164337642f, 0.397913307f,
    0.300108731f, -0.185534105f, -0.0499517992f, 0.0366796032f, -0.00240685185f, 0.107005611f, 0.0649592578f, -0.0687949732f,
    -0.0111155482f, 0.0155505966f, -0.0012514455f, -0.00121944922f, -0.00912840478f, -0.00652968651f, 0.00382061466f, 0.312517345f,
    0.199838683f, -0.18202804f, -0.0271469411f, 0.0379757211f, -0.00592105184f, 0.0370505601f, 0.00354606472f, -0.039476715f,
    0.0067660925f, 0.00923382491f, -0.00411389768f, -0.0205206592f, -0.0134915598f, 0.0118096815f, 0.00197712961f, -0.00279043103f,
    0.251765639f, 0.08717639f, -0.228710681f, -0.00413929857f, 0.0537065528f, -0.0107394652f, -0.0037843294f, 0.00146226247f,
    -0.0136180781f, -1.03248283e-06f, 0.023340201f, -0.00109041738f, -0.0088143656f, 0.0021180585f, -0.0220288802f, -0.00690298341f,
    0.0213050414f, 0.000281974004f, -0.00561377732f, 0.255412549f, 0.283242494f, -0.0322312638f, -0.0711639822f, -0.00562697556f,
    0.00554456888f, 0.0480538793f, 0.0447233468f, -0.0192379374f, -0.0151830753f, 0.00361573207f, 0.00263075554f, -0.00289109442f,
    -0.00226957561f, 0.001731058f, 0.178145677f, 0.1824902f, -0.0446766801f, -0.0520175435f, 0.00268273219f, 0.00500671705f,
    0.0071220533f, -0.000948034693f, -0.012407288f, -0.000430772139f, 0.00501522468f, -0.0080352705f, -0.00710966904f, 0.00386329275f,
    0.00279064337f, 0.079533264f, 0.0414889231f, -0.0807454064f, -0.0318553112f, 0.019904146f, 0.00698682247f, -0.00269269105f,
    -0.0106496448f, -0.0110271405f, 0.00867692474f, 0.0135461213f, 0.00169909291f, -0.00432335259f, -0.00616321899f, -0.00274565001f,
    0.00675045885f, 0.00202202401f, -0.00211759284f
};

/* Coefficients of the first axis, for each weight, channel and product of the other axes' powers. */
static const unsigned char skylight_sh_lengths[150] = {
    6, 5, 5, 3, 1, 6, 5, 4, 1, 0, 6, 7, 6, 5, 0, 6, 6, 5, 3, 1, 5, 5, 3, 2, 0, 7, 7, 6, 5, 0, 7, 6,
    4, 2, 0, 5, 6, 3, 2, 0, 7, 7, 5, 4, 0, 5, 6, 5, 1, 0, 5, 6, 5, 2, 0, 7, 8, 6, 2, 0, 6, 6, 4, 2,
    0, 6, 6, 5, 3, 0, 8, 7, 6, 4, 0, 6, 6, 3, 0, 0, 5, 6, 5, 0, 0, 7, 6, 5, 0, 0, 6, 7, 5, 1, 0, 7,
    6, 5, 3, 0, 7, 8, 5, 4, 0, 7, 6, 5, 1, 0, 7, 7, 4, 3, 0, 8, 8, 6, 4, 0, 6, 7, 3, 0, 0, 6, 6, 5,
    0, 0, 7, 7, 5, 0, 0, 6, 6, 3, 0, 0, 6, 5, 4, 0, 0, 7, 6, 5, 0, 0
};

/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot remove the test. */
static inline int skylight_sh_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    if ((bits & 0x7f800000u) != 0x7f800000u) return 0;
    return (bits & 0x007fffffu) ? 2 : 1;
}

/* Clamps v to [low, high]; *status becomes 1 where v lay beyond the slack. */
static inline skylight_sh_real skylight_sh_clamp(float v, skylight_sh_real low, skylight_sh_real high, skylight_sh_real slack, int *status)
{
    skylight_sh_real x = (skylight_sh_real)v;
    if (skylight_sh_kind(v)) { *status = 1; return v > 0.0f ? high : low; }
    if (x < low) { if (x < low - slack) *status = 1; x = low; }
    if (x > high) { if (x > high + slack) *status = 1; x = high; }
    return x;
}

/* sun_zenith in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_0(skylight_sh_real v)
{
    static const skylight_sh_real k[3] = { 0.0f, 4.36619759f, 5.0f };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* turbidity in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_1(skylight_sh_real v)
{
    static const skylight_sh_real k[3] = { 2.5f, -4.57142878f, -2.0f };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* preetham_zenith: a closed form that all weights share. */
static inline skylight_sh_real skylight_sh_prefactor(skylight_sh_real sun_zenith, skylight_sh_real turbidity)
{
    static const skylight_sh_real k[10] = { 0.1787f, -1.46300006f, -0.355399996f, 0.42750001f, -0.0227000006f, 5.32509995f, 0.1206f, -2.57710004f, -0.0670000017f, 0.370299995f };
    const float chi = (0.44444444444444444f - turbidity * 0.0083333333333333333f) * (3.1415926535897932f - 2.0f * sun_zenith);
    const float zenith = 1000.0f * ((4.0453f * turbidity - 4.9710f) * tanf(chi) - 0.2155f * turbidity + 2.4192f);
    const float c = cosf(sun_zenith);
    const float a = k[0] * turbidity + k[1];
    const float b = k[2] * turbidity + k[3];
    const float halo = (k[4] * turbidity + k[5]) * expf((k[6] * turbidity + k[7]) * sun_zenith);
    const float shape = (1.0f + a * expf(b)) * (1.0f + halo + (k[8] * turbidity + k[9]) * c * c);
    return zenith / shape;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_BANDS, clamped likewise) and zeroes the rest. */
static inline int skylight_sh_weights_bands(float sun_zenith, float sun_azimuth, float turbidity, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int status = 0, l, m, channel, i;
    skylight_sh_real scale = 1;
    skylight_sh_real wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS];
    skylight_sh_real x0, t0[8];
    skylight_sh_real x1, t1[5];
    skylight_sh_real rest[5];
    const skylight_sh_real *coefficient = skylight_sh_coefficients;
    const unsigned char *length = skylight_sh_lengths;

    memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
    if (skylight_sh_kind(sun_azimuth) != 0 || skylight_sh_kind(sun_zenith) == 2 || skylight_sh_kind(turbidity) == 2) return 2;
    if (bands < 1) { bands = 1; status = 1; }
    if (bands > SKYLIGHT_SH_BANDS) { bands = SKYLIGHT_SH_BANDS; status = 1; }
    x0 = skylight_sh_clamp(sun_zenith, 0.0f, 1.57079637f, 1.57079637e-06f, &status);
    x1 = skylight_sh_clamp(turbidity, 2.5f, 6.0f, 3.50000005e-06f, &status);
    scale = skylight_sh_prefactor(x0, x1);
    {
        const skylight_sh_real u = skylight_sh_map_0(x0);
        skylight_sh_real *t = t0;
        t[0] = 1;
        t[1] = u;
        for (i = 2; i < 8; ++i) t[i] = 2 * u * t[i - 1] - t[i - 2];
        (void)u;
    }
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        t[0] = 1;
        t[1] = u;
        for (i = 2; i < 5; ++i) t[i] = 2 * u * t[i - 1] - t[i - 2];
        (void)u;
    }
    {
        int r = 0;
        int i1;
        for (i1 = 0; i1 < 5; ++i1)
            rest[r++] = scale * t1[i1];
    }
    wave_cos[0] = 1;
    wave_sin[0] = 0;
    wave_cos[1] = cosf((skylight_sh_real)sun_azimuth);
    wave_sin[1] = sinf((skylight_sh_real)sun_azimuth);
    for (m = 2; m < SKYLIGHT_SH_BANDS; ++m) {
        wave_cos[m] = wave_cos[m - 1] * wave_cos[1] - wave_sin[m - 1] * wave_sin[1];
        wave_sin[m] = wave_sin[m - 1] * wave_cos[1] + wave_cos[m - 1] * wave_sin[1];
    }
    for (l = 0; l < bands; ++l) {
        for (m = 0; m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
                skylight_sh_real value = 0;
                int r;
                for (r = 0; r < 5; ++r) {
                    const int terms = *length++;
                    skylight_sh_real sum = 0;
                    for (i = 0; i < terms; ++i) sum += coefficient[i] * t0[i];
                    coefficient += terms;
                    value += sum * rest[r];
                }
                /* Orders m < 0 are 0 at azimuth 0, which leaves one term of eq. 4 each. */
                weights[channel][l * (l + 1) - m] = (float)(value * wave_sin[m]);
                weights[channel][l * (l + 1) + m] = (float)(value * wave_cos[m]);
            }
        }
    }
    return status;
}

/* Evaluates all bands. */
static inline int skylight_sh_weights(float sun_zenith, float sun_azimuth, float turbidity, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    return skylight_sh_weights_bands(sun_zenith, sun_azimuth, turbidity, SKYLIGHT_SH_BANDS, weights);
}

/* Optional: tames the ringing of the horizon by the zonal window sinc(pi l / bands) (Habel et al. 2008, eq. 5). */
static inline void skylight_sh_window(int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_BANDS; ++l) {
        const float x = 3.14159265f * (float)l / (float)bands;
        const float factor = sinf(x) / x;
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_H */
