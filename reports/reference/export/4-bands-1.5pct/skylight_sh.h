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
 * Accuracy, as shipped: E_mean 1.36 %, E_max 3.84 % of the least radiance (per-set), at azimuth 0.
 * Memory: 3266 bytes of constants, laid out for speed.
 *
 * Provenance
 *   config preetham, table 4-bands-1.5pct
 *   selection 51c23129d5fd5611f42bd97426a3d94ed0a299f15ab08a767174d51d46439254
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

/* One row a term (powers of the other axes, then of the first); a row holds the term's coefficient for every output. */
static const skylight_sh_real skylight_sh_rows[768] = {
    2.32453871f, 2.64175081f, 3.30517864f, 1.79739761f, 0.926038504f, 2.28847075f, 0.716331005f, 3.21496272f,
    0.589320421f, -0.362842262f, 0.738723755f, 0.515180588f, 0.0128516806f, 0.635389149f, 0.365126997f, 0.666820824f,
    0.642820776f, 0.226223037f, 0.0f, 0.0f, -0.849599659f, -0.053844668f, 0.401884139f, 0.258614421f,
    -0.827785254f, 0.064726308f, 0.315505594f, 0.180315197f, -0.725702584f, 0.263321906f, 0.253599197f, 0.0803453773f,
    0.33227393f, -0.223527893f, -1.26783836f, -0.105127826f, 0.666551113f, -0.534829915f, 0.415919989f, -1.45159698f,
    0.100250892f, -0.79270184f, 0.336914241f, 0.507714927f, -0.709988594f, 0.20580624f, 0.322328627f, -0.768647373f,
    0.0289575644f, 0.103222661f, 0.0f, 0.0f, -0.66181761f, -0.400009453f, 0.305615515f, 0.287826031f,
    -0.46974194f, -0.275811285f, 0.203868404f, 0.185514882f, -0.245169446f, -0.137029767f, 0.0895777047f, 0.0421842933f,
    -0.0195150767f, -0.0736597031f, -0.333311528f, -0.00409672596f, -0.291717172f, -0.0316168442f, -0.301622719f, -0.201296881f,
    -0.461653322f, 0.0743879229f, -0.371210396f, -0.106911741f, 0.110292025f, -0.368259132f, -0.121035948f, 0.220933482f,
    -0.506955802f, -0.199005559f, 0.0f, 0.0f, 0.176500261f, -0.204540879f, -0.184989288f, -0.0311711598f,
    0.213250592f, -0.190843344f, -0.181974247f, -0.0441684499f, 0.376538336f, -0.211260602f, -0.229579866f, -0.0812072083f,
    -0.0382491015f, -0.00672570383f, -0.00743539771f, 0.0166722145f, -0.0352347605f, 0.0359156132f, 0.00465306034f, 0.0418890901f,
    0.0586741939f, 0.100122422f, 0.046468664f, -0.0926787779f, 0.0837724209f, 0.0783816278f, -0.0622593798f, 0.0945713893f,
    0.141124979f, -0.0382012278f, 0.0f, 0.0f, 0.072416693f, 0.165768832f, -0.0515675694f, -0.0720210075f,
    0.0508952886f, 0.161955506f, -0.0285162684f, -0.0527391098f, 0.0538754426f, 0.191923469f, -0.00561788585f, -0.0325863622f,
    -0.00492396671f, 0.000929872214f, 0.0595207848f, -0.00534111587f, -0.00102014607f, -0.0056180344f, 0.00585527299f, 0.0347568244f,
    0.0352182053f, -0.0153311966f, 0.0127518931f, 0.00817143265f, -0.0251172315f, 0.0103974296f, 0.0166348871f, -0.046125114f,
    0.0255049672f, 0.042118255f, 0.0f, 0.0f, -0.0417554714f, 0.00799580291f, 0.0363709927f, -0.0062021073f,
    -0.0478242338f, -0.00622524926f, 0.0378460176f, 0.00231100642f, -0.0812915862f, -0.0242219381f, 0.0539714918f, 0.0197901167f,
    0.00312467781f, 0.00192183687f, -0.0100315772f, 0.00226480281f, 0.0030980166f, 0.0012899529f, 0.000693151029f, -0.0133361751f,
    1.17896052e-05f, -0.000507675053f, -0.00210742f, 0.00211369316f, 0.000877656508f, -0.00541070569f, 0.000621131971f, -0.00547132082f,
    -0.0121784303f, 0.00202425546f, 0.0f, 0.0f, 0.00330918236f, -0.0141374674f, -0.00206980063f, 0.00549382949f,
    0.00732800225f, -0.0147061246f, -0.00560420472f, 0.00504035596f, 0.0120054977f, -0.0234725494f, -0.010440195f, 0.00735656312f,
    0.000531322323f, -9.00712766e-05f, -0.000363008032f, -0.00029182111f, 0.00122061244f, -0.000347328547f, 0.000644693093f, 0.00110895862f,
    -0.00366692757f, -0.000836155785f, 0.000525845739f, 0.00112702243f, 2.48010292e-05f, 0.000990775763f, 0.000198059482f, 0.00397161394f,
    -0.00208532461f, -0.00296030496f, 0.0f, 0.0f, 0.000826276257f, 0.00132899475f, -0.000816129439f, 0.000511265825f,
    0.00115316268f, 0.00336875184f, -0.000991470297f, -0.000476099289f, 0.00460175611f, 0.00560494605f, -0.00357525796f, -0.00275527313f,
    0.700611711f, 0.644499958f, 0.488899261f, 0.699945033f, 0.25903523f, 0.763800561f, 0.139593169f, 0.74620378f,
    0.0656130463f, 0.169703558f, 0.259990036f, 0.0943981186f, 0.395141006f, 0.170846939f, 0.00899407081f, 0.658155262f,
    0.112519436f, -0.0193818156f, 0.0f, 0.0f, -0.150778204f, 0.074386999f, 0.106488064f, 0.0475918204f,
    0.011997899f, 0.097834304f, 0.0361115001f, 0.00644035777f, 0.295690775f, 0.116009861f, 0.000338494079f, -0.0110059949f,
    0.0220359769f, -0.220524877f, -0.345469117f, -0.0685764924f, 0.160525829f, -0.272404015f, 0.052791886f, -0.456499904f,
    -0.00198673457f, -0.200500041f, 0.110911995f, 0.0734172761f, -0.187688649f, 0.0472009256f, -0.0136532234f, -0.336982995f,
    0.000132788235f, -0.0229019895f, 0.0f, 0.0f, -0.202272907f, -0.0585008934f, 0.0649366453f, 0.0442939363f,
    -0.113746017f, -0.00851712935f, 0.00289088138f, -0.00169741537f, -0.167860985f, -0.00219938415f, -0.0140728848f, -0.0114283636f,
    -0.0561233759f, -0.00916074682f, 0.101106554f, -0.037954092f, -0.106934495f, 0.00403023697f, -0.0702788159f, 0.0800596401f,
    -0.0179902259f, 0.0376968347f, -0.137102678f, -0.0464083329f, 0.0352596156f, -0.0906039029f, -0.0265311506f, -0.00434341142f,
    -0.0507182591f, 0.0162358694f, 0.0f, 0.0f, 0.0860728472f, -0.0842411891f, -0.0681118593f, -0.0190184787f,
    0.0575098433f, -0.0609113686f, -0.0388636142f, -0.0123149063f, -0.00602748711f, -0.0734443069f, 0.000757204136f, 0.009034588f,
    -0.0253812019f, 0.0177723132f, 0.0900700986f, -0.00899803359f, -0.00383170694f, 0.021438282f, 0.0214345455f, 0.0767147243f,
    0.0512927398f, 0.0281000342f, 0.0205589198f, -0.0188450795f, 0.0125933513f, 0.0364781208f, 0.00425741356f, -0.00224597519f,
    0.0582647882f, 0.0267780535f, 0.0f, 0.0f, 0.0295699965f, 0.0544602014f, -0.0112764509f, -0.0150319887f,
    0.00236690673f, 0.0414808989f, 0.00684185792f, -0.000216273082f, -0.0304469354f, 0.0337567702f, 0.0233794861f, 0.0139028681f,
    0.0150716873f, -0.00124834571f, -0.0395671688f, 0.0113895359f, 0.00762078958f, -0.00587727083f, 0.00340708066f, -0.0395282619f,
    -0.00979822967f, -0.00767806312f, 0.00872221775f, 0.00866228808f, -0.0122525357f, -0.000691279129f, 0.00736993412f, -0.0121574793f,
    -0.0165184587f, -1.00963925e-05f, 0.0f, 0.0f, -0.0212741718f, -0.000809332356f, 0.0154439462f, 0.00357763283f,
    -0.0146440994f, -0.0101612695f, 0.00911199488f, 0.0050741951f, 0.000365129934f, -0.0170799401f, -0.00115272566f, 0.00159724639f,
    -0.000235844476f, -4.42462187e-05f, -0.00206484878f, -0.00149820209f, 0.0020323908f, 0.000313403114f, -0.00151467766f, 0.00127053529f,
    -0.00957829226f, -0.00203581131f, -0.00105927733f, 0.00171416358f, 0.00196728227f, -0.00347644137f, -0.00129144301f, 0.008145364f,
    -0.0090408856f, -0.00793536846f, 0.0f, 0.0f, 0.00131212547f, -0.00646865042f, -0.00126764982f, 0.00263984036f,
    0.00511390995f, -0.00395818427f, -0.00410304964f, 0.000423521939f, 0.0114807496f, -0.000586684793f, -0.00949755125f, -0.00404179934f,
    -0.000372142211f, -0.000307627575f, 0.00194372283f, -0.00034728396f, -0.00090884947f, -7.20348253e-05f, -0.000131122069f, 0.00244323863f,
    0.00240141409f, 0.000387289387f, -0.00111537415f, -0.000457848917f, 0.000470346451f, 0.000694782764f, -0.000535320374f, 0.000907707377f,
    0.00496597541f, -1.72209111e-05f, 0.0f, 0.0f, 0.00126150355f, 0.000523496419f, -0.00116078986f, -0.00040665819f,
    0.000382628728f, 0.00240639132f, -0.000312848773f, -0.000825871306f, -0.00198944542f, 0.00586421369f, 0.0020633447f, -0.00124115113f,
    -0.000230323698f, -3.88582521e-05f, 0.000807766453f, 5.59798063e-05f, -0.000158400857f, 2.53598355e-05f, -9.40386963e-05f, -0.000132165413f,
    0.000324890891f, 0.000411187328f, 0.000326707261f, -0.000394526956f, 2.13949784e-06f, 8.58718849e-05f, -7.84436343e-05f, -0.00162375637f,
    -0.00105874776f, 0.00136293215f, 0.0f, 0.0f, 0.000161018252f, 0.000726522412f, -2.25454787e-05f, -0.000417184056f,
    -0.000218983725f, 9.92377754e-05f, 0.000183986573f, -0.000140316348f, -0.000806181401f, -0.00293519627f, 0.00037028201f, 0.00122638652f,
    -0.00394927431f, -0.0584711954f, -0.174371332f, -0.00699206581f, 0.00153210235f, -0.0567206591f, -0.0184599627f, -0.1874125f,
    -0.031324327f, -0.00397476833f, -0.00349766552f, -0.00866744295f, -0.004331192f, -0.022081295f, -0.019608425f, -0.0582324378f,
    -0.040645916f, -0.0163784996f, 0.0f, 0.0f, 0.00522265304f, -0.00698077912f, -0.00942743849f, -0.00303752697f,
    0.0330597982f, -0.00992586557f, -0.0208117906f, -0.00813324749f, 0.0522506163f, -0.0243140124f, -0.0219596364f, -0.00608314574f,
    0.0081990445f, -0.00885873009f, 0.0596603937f, 0.0121324444f, 0.00856081303f, 0.00390183809f, -0.00385959097f, 0.0760029703f,
    0.00147216942f, 0.0129832719f, 0.00698251929f, -0.00753616728f, 0.0262625087f, 0.000925422122f, -0.0162499342f, 0.0505334549f,
    0.00621910254f, -0.00656711403f, 0.0f, 0.0f, 0.0123666991f, 0.00176553987f, -0.00684567727f, -0.00243108347f,
    0.0274699926f, 0.010531784f, -0.0138385883f, -0.00730707729f, 0.0188699141f, 0.0128903827f, -0.00702197943f, -0.00271410751f,
    -0.011322014f, 0.0053675333f, 0.036200244f, -0.0130952485f, 0.00498201186f, 0.0029546353f, 0.0154631529f, 0.0326240845f,
    0.0329737738f, -0.00724839978f, 0.0066904733f, 0.0026337821f, -0.00597693771f, 0.0206276271f, 0.00816585496f, -0.00338292099f,
    0.041325599f, 0.0158760641f, 0.0f, 0.0f, -0.00287351944f, 0.00371424714f, 0.00392017467f, 0.00173850637f,
    -0.0123385228f, 0.0124669401f, 0.0117682992f, 0.00383701874f, -0.0289780907f, 0.022935193f, 0.0214946568f, 0.00689104991f,
    -0.00417156378f, 0.00204782397f, 0.00455073221f, -0.00494679762f, -0.00212488626f, -0.000231635742f, 0.000143945072f, 0.00328083755f,
    -0.00352006964f, -0.00262654922f, -0.00346886343f, 0.000990211149f, -0.00428966898f, -0.00367631158f, 0.00364714279f, -0.00187164883f,
    -0.00951303169f, 0.00241489056f, 0.0f, 0.0f, 9.33379197e-05f, -0.00392826041f, 0.000249940669f, 0.0011530976f,
    -0.00361542986f, -0.00871381257f, 0.00213203928f, 0.00296026282f, -0.00328495377f, -0.0144496178f, 0.000511098246f, 0.00234264461f,
    0.00271984329f, -0.00116650912f, -0.00795786642f, 0.00332307094f, 0.000428367581f, -0.000739342417f, -0.00118688133f, -0.00803604629f,
    -0.00432385225f, 0.00214679958f, 0.000761140662f, -0.000433500332f, 0.00124365429f, -0.00140052545f, -0.00158415793f, -0.000914628152f,
    -0.00445972709f, -0.00396949099f, 0.0f, 0.0f, 0.00102538732f, 0.00123867206f, -0.000713303976f, -0.000355152006f,
    0.00297772931f, 0.000236019041f, -0.00274435338f, -0.000721504155f, 0.00538380723f, 2.83861464e-05f, -0.00549261598f, -0.00220386544f,
    0.00967242289f, 0.00560588529f, 0.000294698169f, 0.00575739751f, 0.00475453166f, 0.00117126503f, 0.0013695932f, -0.00686287507f,
    0.000905756024f, -0.00562159205f, 0.00289863953f, 0.00107245601f, -0.00787032489f, -6.9336711e-05f, -0.000175705121f, -0.0160089824f,
    -0.000715554401f, 0.000959561847f, 0.0f, 0.0f, -0.00742127514f, -0.00234509213f, 0.000612394535f, 0.00070573407f,
    -0.00774963712f, -0.00255221128f, -0.00058640138f, 6.85153718e-05f, -0.0139829507f, -0.00347790821f, 0.000522955204f, 0.000444669946f,
    0.00357859465f, 0.000146994993f, 0.00418777019f, 0.00267605623f, 0.00421326747f, 0.00121598912f, 0.00209352397f, 0.00748995133f,
    0.00151227508f, -0.000659278594f, 0.00305239717f, 0.0011787659f, 0.0025558921f, 0.00194126612f, 0.000262806774f, 0.00861941464f,
    0.00203546393f, 0.000777259644f, 0.0f, 0.0f, -0.000953678624f, -0.000925572647f, 0.00084205193f, 0.000907231995f,
    0.00272012036f, 0.000397065043f, 0.000194619075f, 0.000269512704f, 0.006430001f, 0.00172753318f, 0.000791214581f, 0.000348321133f,
    0.00205996563f, 0.00113172317f, 0.000536149542f, 0.001946987f, 0.000899910694f, 0.00116922788f, 0.000112767048f, 0.000827775628f,
    0.000156350929f, 0.000181114214f, 0.000800030539f, -2.52370337e-05f, 0.00018058953f, 0.000168354891f, -0.000221887065f, 0.000425079197f,
    0.000270029122f, 5.66322851e-05f, 0.0f, 0.0f, -0.000902102096f, 4.50084735e-06f, 8.03233343e-05f, 3.28141105e-05f,
    -0.000770412327f, 9.0083784e-05f, -7.2261173e-05f, -9.50029134e-05f, -0.000695463677f, 0.000186744219f, 0.000199933158f, 5.59912678e-06f,
    0.000464402896f, 0.000335670804f, -4.09600107e-05f, 0.000405350991f, 0.000164081634f, 0.000293954421f, 2.57736701e-05f, 4.37805227e-07f,
    -5.44861941e-05f, 1.67751914e-05f, 0.000114165792f, 2.00408322e-05f, 1.52185103e-05f, -2.97440656e-05f, -5.26437816e-06f, 0.000102809805f,
    -3.82667495e-05f, -4.58557442e-05f, 0.0f, 0.0f, -0.000129103661f, -3.63524341e-05f, 6.0926609e-06f, 2.04746812e-05f,
    -9.61222904e-05f, -9.52062837e-05f, -1.90512801e-05f, 1.09736866e-05f, 0.000128871921f, 6.70946756e-05f, -6.97442811e-05f, -1.50526857e-05f
};

/* acc[k] = sum over t of phi[t] * rows[t][k], four rows a pass: no reduction, so that it vectorises under strict arithmetic. */
static inline void skylight_sh_sum(const skylight_sh_real *phi, int width, skylight_sh_real *acc)
{
    const skylight_sh_real *row = skylight_sh_rows;
    int k;
    {
        const skylight_sh_real p0 = phi[0], p1 = phi[1], p2 = phi[2], p3 = phi[3];
        for (k = 0; k < width; ++k) acc[k] = (p0 * row[k] + p1 * row[k + 32]) + (p2 * row[k + 64] + p3 * row[k + 96]);
        row += 128;
        phi += 4;
    }
    int t;
    for (t = 0; t < 5; ++t) {
        const skylight_sh_real p0 = phi[0], p1 = phi[1], p2 = phi[2], p3 = phi[3];
        for (k = 0; k < width; ++k) acc[k] += (p0 * row[k] + p1 * row[k + 32]) + (p2 * row[k + 64] + p3 * row[k + 96]);
        row += 128;
        phi += 4;
    }
    (void)row;
    (void)phi;
}

/* Four orders m of one band and channel: m >= 0 forwards, m < 0 backwards (eq. 4 with nothing stored for m < 0). */
static inline void skylight_sh_four(const skylight_sh_real *acc, const skylight_sh_real *wave_cos, const skylight_sh_real *wave_sin, float *plus, float *minus)
{
    float a[4], b[4];
    int k;
    for (k = 0; k < 4; ++k) b[k] = (float)(acc[3 - k] * wave_sin[3 - k]);
    for (k = 0; k < 4; ++k) a[k] = (float)(acc[k] * wave_cos[k]);
    for (k = 0; k < 4; ++k) minus[k] = b[k];
    for (k = 0; k < 4; ++k) plus[k] = a[k];
}



/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot remove the test. */
static inline int skylight_sh_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* Clamps v to [low, high]; *status becomes 1 where v lay beyond the slack. An infinity is made finite by its sign bit. */
static inline skylight_sh_real skylight_sh_clamp(float v, skylight_sh_real low, skylight_sh_real high, skylight_sh_real slack, int *status)
{
    skylight_sh_real x;
    if (skylight_sh_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    x = (skylight_sh_real)v;
    *status |= (x < low - slack) | (x > high + slack);
    x = x < low ? low : x;
    return x > high ? high : x;
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

/* preetham_zenith: a closed form that all weights share; the fit divided by the same. */
static inline skylight_sh_real skylight_sh_prefactor(skylight_sh_real sun_zenith, skylight_sh_real turbidity)
{
    static const skylight_sh_real k[10] = { 0.1787f, -1.46300006f, -0.355399996f, 0.42750001f, -0.0227000006f, 5.32509995f, 0.1206f, -2.57710004f, -0.0670000017f, 0.370299995f };
    const float a = k[0] * turbidity + k[1], b = k[2] * turbidity + k[3], c = k[4] * turbidity + k[5];
    const float d = k[6] * turbidity + k[7], e = k[8] * turbidity + k[9];
    const float chi = (0.44444444444444444f - turbidity * 0.0083333333333333333f) * (3.1415926535897932f - 2.0f * sun_zenith);
    const float square = chi * chi;
    const float tan_above = chi * (105.0f - 10.0f * square), tan_below = 105.0f - square * (45.0f - square);
    const float y = d * sun_zenith, z = sun_zenith * sun_zenith;
    const float cosine = 1.0f - z * (0.5f - z * (0.041666666666666667f - z * 0.0013888888888888889f));
    float up = 1.0f + b * (0.25f + b * 0.03125f), halo = 1.0f + y * (0.125f + y * 0.0078125f);
    up = up * up;
    up = up * up;
    halo = halo * halo;
    halo = halo * halo;
    halo = halo * halo;
    return 1000.0f * ((4.0453f * turbidity - 4.9710f) * tan_above + (2.4192f - 0.2155f * turbidity) * tan_below)
        / (tan_below * (1.0f + a * up) * (1.0f + c * halo + e * (cosine * cosine)));
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_BANDS, clamped likewise) and zeroes the rest. */
static inline int skylight_sh_weights_bands(float sun_zenith, float sun_azimuth, float turbidity, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int status = 0, i, m, channel;
    skylight_sh_real scale = 1;
    skylight_sh_real wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS];
    skylight_sh_real x0, t0[8];
    skylight_sh_real x1, t1[8];
    skylight_sh_real rest[6];

    if (skylight_sh_kind(sun_azimuth) | skylight_sh_kind(sun_zenith) | skylight_sh_kind(turbidity)) {
        if (skylight_sh_kind(sun_azimuth) != 0 || skylight_sh_kind(sun_zenith) == 2 || skylight_sh_kind(turbidity) == 2) {
            memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
            return 2;
        }
    }
    if (bands < 1) { bands = 1; status = 1; }
    if (bands > SKYLIGHT_SH_BANDS) { bands = SKYLIGHT_SH_BANDS; status = 1; }
    x0 = skylight_sh_clamp(sun_zenith, 0.0f, 1.57079637f, 1.57079637e-06f, &status);
    x1 = skylight_sh_clamp(turbidity, 2.5f, 6.0f, 3.50000005e-06f, &status);
    scale = skylight_sh_prefactor(x0, x1);
    {
        const skylight_sh_real u = skylight_sh_map_0(x0);
        skylight_sh_real *t = t0;
        const int n = 8;
        for (i = 0; i < 8; ++i) t[i] = 0;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 6;
        for (i = 0; i < 8; ++i) t[i] = 0;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    {
        int r = 0;
        int i1;
        for (i1 = 0; i1 < 6; ++i1)
            rest[r++] = scale * t1[i1];
    }
    /* The waves of the azimuth, by doubling: m = h + k. */
    wave_cos[0] = 1;
    wave_sin[0] = 0;
    wave_cos[1] = cosf((skylight_sh_real)sun_azimuth);
    wave_sin[1] = sinf((skylight_sh_real)sun_azimuth);
    for (m = 2; m < SKYLIGHT_SH_BANDS; ++m) {
        const int h = m / 2, k = m - h;
        wave_cos[m] = wave_cos[h] * wave_cos[k] - wave_sin[h] * wave_sin[k];
        wave_sin[m] = wave_sin[h] * wave_cos[k] + wave_cos[h] * wave_sin[k];
    }
    {
        skylight_sh_real phi[32], acc[32];
        /* Products in fours; each overshoot is overwritten by the next line. */
        for (i = 0; i < 8; ++i) phi[0 + i] = t0[i] * rest[0];
        for (i = 0; i < 8; ++i) phi[7 + i] = t0[i] * rest[1];
        for (i = 0; i < 8; ++i) phi[15 + i] = t0[i] * rest[2];
        for (i = 0; i < 4; ++i) phi[20 + i] = t0[i] * rest[3];
        for (i = 0; i < 4; ++i) phi[22 + i] = t0[i] * rest[4];
        for (i = 0; i < 4; ++i) phi[23 + i] = t0[i] * rest[5];
        if (bands == SKYLIGHT_SH_BANDS) skylight_sh_sum(phi, 32, acc);
        else {
            static const unsigned short width[4] = { 8, 16, 24, 32 };
            skylight_sh_sum(phi, width[bands - 1], acc);
        }
        {
            weights[0][0] = (float)acc[0];
            weights[1][0] = (float)acc[1];
            weights[2][0] = (float)acc[2];
        }
        if (bands > 1) {
            weights[0][2] = (float)acc[3];
            weights[0][1] = (float)(acc[4] * wave_sin[1]);
            weights[0][3] = (float)(acc[4] * wave_cos[1]);
            weights[1][2] = (float)acc[5];
            weights[1][1] = (float)(acc[6] * wave_sin[1]);
            weights[1][3] = (float)(acc[6] * wave_cos[1]);
            weights[2][2] = (float)acc[7];
            weights[2][1] = (float)(acc[8] * wave_sin[1]);
            weights[2][3] = (float)(acc[8] * wave_cos[1]);
        }
        if (bands > 2) {
            weights[0][6] = (float)acc[9];
            weights[0][5] = (float)(acc[10] * wave_sin[1]);
            weights[0][7] = (float)(acc[10] * wave_cos[1]);
            weights[0][4] = (float)(acc[11] * wave_sin[2]);
            weights[0][8] = (float)(acc[11] * wave_cos[2]);
            weights[1][6] = (float)acc[12];
            weights[1][5] = (float)(acc[13] * wave_sin[1]);
            weights[1][7] = (float)(acc[13] * wave_cos[1]);
            weights[1][4] = (float)(acc[14] * wave_sin[2]);
            weights[1][8] = (float)(acc[14] * wave_cos[2]);
            weights[2][6] = (float)acc[15];
            weights[2][5] = (float)(acc[16] * wave_sin[1]);
            weights[2][7] = (float)(acc[16] * wave_cos[1]);
            weights[2][4] = (float)(acc[17] * wave_sin[2]);
            weights[2][8] = (float)(acc[17] * wave_cos[2]);
        }
        if (bands > 3) {
            skylight_sh_four(acc + 20, wave_cos + 0, wave_sin + 0, weights[0] + 12, weights[0] + 9);
            skylight_sh_four(acc + 24, wave_cos + 0, wave_sin + 0, weights[1] + 12, weights[1] + 9);
            skylight_sh_four(acc + 28, wave_cos + 0, wave_sin + 0, weights[2] + 12, weights[2] + 9);
        }
    }

    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
        for (i = bands * bands; i < SKYLIGHT_SH_WEIGHTS; ++i) weights[channel][i] = 0.0f;
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
