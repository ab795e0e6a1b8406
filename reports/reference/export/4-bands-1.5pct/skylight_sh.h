/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything (CC0-1.0).
 * C99 and C++11, header only, no allocation, no global written, nothing static but constants: any thread may call it.
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
 *   w[channel][l*(l+1)+m], channels red, green, blue: linear radiance, luminance-scaled cd/m2. Real orthonormal spherical
 *   harmonics without the Condon-Shortley sign, z up, m > 0 cosine, m < 0 sine; the azimuth turns from +x towards +y.
 *   Below the horizon: black. Returns 0; 1 where an input lay outside its range and was clamped; 2 (weights zeroed) where
 *   one was NaN or the azimuth infinite.
 *   The glow about the sun is in the weights, its disc is not: with a disc of your own, add no halo.
 *   Define SKYLIGHT_SH_EXPOSURE before this file to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 1.39 %, E_max 3.73 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 % of its largest
 * in the same set; the window below tames it.
 * Memory: 3261 bytes of constants, laid out for speed.
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-1.5pct
 */
#ifndef SKYLIGHT_SH_H
#define SKYLIGHT_SH_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define SKYLIGHT_SH_VERSION "0.1.0"
#define SKYLIGHT_SH_BANDS 4
#define SKYLIGHT_SH_WEIGHTS 16
#define SKYLIGHT_SH_CHANNELS 3
#define SKYLIGHT_SH_AXES 2
#define SKYLIGHT_SH_UNIT "cd/m2"
#define SKYLIGHT_SH_E_MEAN 1.394000e-02
#define SKYLIGHT_SH_E_MAX 3.729000e-02
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* One row a term (powers of the other axes, then of the first); a row holds the term's coefficient for every output. */
static const skylight_sh_real skylight_sh_rows[768] = {
    2.3245585f, 2.6417532f, 3.30502224f, 1.79743505f, 0.926050067f, 2.28847837f, 0.716328144f, 3.21493578f,
    0.589277029f, -0.362805843f, 0.738756299f, 0.515161991f, 0.0128569603f, 0.635395885f, 0.365124464f, 0.66700995f,
    0.642988086f, 0.226039171f, 0.0f, 0.0f, -0.849594235f, -0.0538070202f, 0.401888728f, 0.258594871f,
    -0.827798605f, 0.064735055f, 0.315520644f, 0.18030858f, -0.725667596f, 0.263733864f, 0.253601909f, 0.0801711082f,
    0.332267284f, -0.22351265f, -1.26776803f, -0.105144858f, 0.666538835f, -0.534820676f, 0.415922284f, -1.45161426f,
    0.100236058f, -0.792719364f, 0.336888313f, 0.507736802f, -0.70999527f, 0.205816627f, 0.322333217f, -0.768761039f,
    0.0287743807f, 0.103314757f, 0.0f, 0.0f, -0.661804795f, -0.400038481f, 0.305608511f, 0.287852526f,
    -0.46974051f, -0.2757864f, 0.203860283f, 0.185512424f, -0.245111704f, -0.137321115f, 0.0894840956f, 0.0422900915f,
    -0.019495368f, -0.0736663342f, -0.333247066f, -0.00406193733f, -0.291700363f, -0.0316278934f, -0.301628232f, -0.201272488f,
    -0.461631417f, 0.0744191408f, -0.371181488f, -0.106929183f, 0.110275269f, -0.368273616f, -0.12102747f, 0.220864892f,
    -0.506990075f, -0.198951483f, 0.0f, 0.0f, 0.176500082f, -0.204519868f, -0.184980512f, -0.0312012434f,
    0.213215351f, -0.190873981f, -0.181949735f, -0.0441602468f, 0.376476407f, -0.211384058f, -0.229557157f, -0.0811676979f,
    -0.0382090807f, -0.006721735f, -0.00733911991f, 0.0167075396f, -0.0352193117f, 0.0359264612f, 0.0046569109f, 0.041916728f,
    0.0587006807f, 0.100127459f, 0.0464804173f, -0.0926698446f, 0.083789587f, 0.0784130096f, -0.0622756481f, 0.094479084f,
    0.141038537f, -0.0381108522f, 0.0f, 0.0f, 0.0724301338f, 0.165762305f, -0.051576376f, -0.0720044374f,
    0.0509366989f, 0.162017584f, -0.0285483599f, -0.0527586937f, 0.0538780689f, 0.191695333f, -0.0056347847f, -0.0324926376f,
    -0.00493824482f, 0.000934839249f, 0.0597273111f, -0.00534939766f, -0.00101840496f, -0.00560522079f, 0.00585401058f, 0.0349045992f,
    0.035261631f, -0.0153273344f, 0.0127702951f, 0.00816333294f, -0.0250951052f, 0.0104044676f, 0.0166172981f, -0.0461704731f,
    0.0254366398f, 0.0422213078f, 0.0f, 0.0f, -0.0417531729f, 0.00802218914f, 0.0363726616f, -0.00622153282f,
    -0.0477813482f, -0.0062084198f, 0.0378130674f, 0.00229561329f, -0.0813026428f, -0.0244321823f, 0.0539788008f, 0.0198680162f,
    0.00320124626f, 0.0019261837f, -0.0101442337f, 0.00227129459f, 0.00313913822f, 0.0012909174f, 0.000693202019f, -0.0132601261f,
    2.16960907e-05f, -0.000594258308f, -0.00221168995f, 0.00222027302f, 0.00086581707f, -0.00543487072f, 0.000637173653f, -0.00517392159f,
    -0.0118317604f, 0.00178420544f, 0.0f, 0.0f, 0.00325274467f, -0.0143432617f, -0.0020468235f, 0.00561916828f,
    0.00727295876f, -0.0147681236f, -0.00555694103f, 0.00506079197f, 0.0120162964f, -0.022816658f, -0.0103821754f, 0.00712406635f,
    0.00041782856f, -8.46385956e-05f, -0.000168800354f, -0.000325083733f, 0.00116348267f, -0.000342965126f, 0.000658631325f, 0.00110161304f,
    -0.00364470482f, -0.00075006485f, 0.000652313232f, 0.000995397568f, 3.81469727e-05f, 0.00101363659f, 0.000192761421f, 0.00367212296f,
    -0.00241923332f, -0.00269436836f, 0.0f, 0.0f, 0.000923633575f, 0.00157344341f, -0.000867962837f, 0.00034737587f,
    0.00122117996f, 0.0034173727f, -0.00104534626f, -0.000480413437f, 0.00458288193f, 0.0049046278f, -0.00361979008f, -0.00250172615f,
    0.00027859211f, 9.77516174e-05f, -0.000445961952f, 6.53266907e-05f, 0.000153779984f, -5.96046448e-06f, -1.01327896e-05f, 0.000304579735f,
    8.86917114e-05f, -0.000229716301f, -0.000334739685f, 0.000349998474f, -0.000203371048f, -0.000267863274f, 0.000189304352f, 0.00107133389f,
    0.00149023533f, -0.000875592232f, 0.0f, 0.0f, -0.000234127045f, -0.000641345978f, 0.000128149986f, 0.000421285629f,
    -0.000522613525f, -0.000516653061f, 0.000359416008f, 0.000215053558f, -0.000398278236f, 0.00262403488f, 0.000567913055f, -0.000948190689f,
    0.700646281f, 0.644542217f, 0.488768935f, 0.700005889f, 0.259045243f, 0.763838887f, 0.139597535f, 0.746255159f,
    0.06554389f, 0.169757605f, 0.260031819f, 0.0943664312f, 0.395144224f, 0.170866489f, 0.00899171829f, 0.658472061f,
    0.112710238f, -0.0196385384f, 0.0f, 0.0f, -0.150762796f, 0.0744326115f, 0.106487632f, 0.0475478172f,
    0.0119931698f, 0.0978732109f, 0.0361039639f, 0.00643074512f, 0.29581964f, 0.116564274f, 0.000279188156f, -0.0112453699f,
    0.0220346451f, -0.220530391f, -0.345490217f, -0.068607688f, 0.160536766f, -0.272407174f, 0.0527864695f, -0.456577063f,
    -0.00197768211f, -0.200545311f, 0.110880017f, 0.073469758f, -0.187698364f, 0.0471978188f, -0.0136481524f, -0.337105155f,
    9.04798508e-05f, -0.0228362083f, 0.0f, 0.0f, -0.202273011f, -0.0585625172f, 0.0649405718f, 0.0443601608f,
    -0.11379683f, -0.00854241848f, 0.00293493271f, -0.00169467926f, -0.167936563f, -0.00230467319f, -0.014051199f, -0.0113624334f,
    -0.0560889244f, -0.00914955139f, 0.10131228f, -0.0379132032f, -0.106909394f, 0.00404191017f, -0.0702894926f, 0.0801875591f,
    -0.0179213285f, 0.0377140045f, -0.137075067f, -0.046407342f, 0.0352630615f, -0.0905905962f, -0.0265444517f, -0.00447034836f,
    -0.0507493019f, 0.0163656473f, 0.0f, 0.0f, 0.0860693455f, -0.0842421055f, -0.068097353f, -0.0190422535f,
    0.0575140715f, -0.060854435f, -0.038877964f, -0.0123388767f, -0.00621342659f, -0.0736762285f, 0.000858426094f, 0.00911331177f,
    -0.0253715515f, 0.0177789927f, 0.0900348425f, -0.00898742676f, -0.0038228035f, 0.0214419365f, 0.0214202404f, 0.0766199827f,
    0.0513135195f, 0.0281152725f, 0.0205564499f, -0.0188339949f, 0.012566328f, 0.0364836454f, 0.00426280499f, -0.00235486031f,
    0.0581936836f, 0.0268287659f, 0.0f, 0.0f, 0.0295869112f, 0.0544577837f, -0.0112794638f, -0.0149960518f,
    0.0022752285f, 0.0414797068f, 0.0069038868f, -0.000222206116f, -0.0304188728f, 0.0335640907f, 0.0233360529f, 0.0139859915f,
    0.0151354074f, -0.00122702122f, -0.0391942263f, 0.0114728212f, 0.00765073299f, -0.00585961342f, 0.0034058094f, -0.0391933918f,
    -0.00968778133f, -0.00762653351f, 0.00876176357f, 0.00864803791f, -0.0122613907f, -0.000700235367f, 0.00737309456f, -0.0121639967f,
    -0.0164512396f, 0.00013589859f, 0.0f, 0.0f, -0.0212695599f, -0.000798106194f, 0.0154573917f, 0.00354075432f,
    -0.0146731138f, -0.0102003813f, 0.00912737846f, 0.00507962704f, 0.000176310539f, -0.0171868801f, -0.000972509384f, 0.00166082382f,
    -0.000194430351f, -3.65972519e-05f, -0.00229597092f, -0.00155651569f, 0.0020917654f, 0.000319242477f, -0.00149226189f, 0.00124084949f,
    -0.00959920883f, -0.00218570232f, -0.00116991997f, 0.00185346603f, 0.00199377537f, -0.00345385075f, -0.00129675865f, 0.00844871998f,
    -0.00871920586f, -0.00821626186f, 0.0f, 0.0f, 0.00126099586f, -0.006711483f, -0.00125849247f, 0.00279951096f,
    0.00522148609f, -0.00389575958f, -0.00418484211f, 0.000424146652f, 0.011557579f, 9.1791153e-05f, -0.00949370861f, -0.00429058075f,
    -0.000429868698f, -0.000288963318f, 0.00238418579f, -0.000279426575f, -0.000969290733f, -6.90221786e-05f, -0.000131487846f, 0.00261592865f,
    0.00256955624f, 0.000582098961f, -0.000987648964f, -0.000619053841f, 0.000434875488f, 0.000660777092f, -0.00050330162f, 0.000476956367f,
    0.00475370884f, 0.000420570374f, 0.0f, 0.0f, 0.00130808353f, 0.000806093216f, -0.00114357471f, -0.000582814217f,
    0.000296831131f, 0.00231993198f, -0.00025177002f, -0.000793099403f, -0.00234127045f, 0.00505256653f, 0.00227546692f, -0.00088596344f,
    -0.00388562679f, -0.0584714413f, -0.174071193f, -0.00691461563f, 0.00157678127f, -0.0567231178f, -0.0184679031f, -0.187121511f,
    -0.0312360525f, -0.0039331913f, -0.00344371796f, -0.00868177414f, -0.00433671474f, -0.0221066475f, -0.0196133852f, -0.0581848621f,
    -0.0405697823f, -0.0163234472f, 0.0f, 0.0f, 0.00522339344f, -0.00696051121f, -0.00941765308f, -0.00306427479f,
    0.0330576897f, -0.00997757912f, -0.0208183527f, -0.00812935829f, 0.0521473885f, -0.0243250132f, -0.0218787193f, -0.00608062744f,
    0.00819015503f, -0.00880730152f, 0.0592101812f, 0.0120797157f, 0.00857818127f, 0.00393807888f, -0.00387740135f, 0.0757216215f,
    0.00135350227f, 0.012902379f, 0.00696074963f, -0.00748491287f, 0.0262460709f, 0.000937104225f, -0.0162568092f, 0.0507367849f,
    0.00640594959f, -0.00682544708f, 0.0f, 0.0f, 0.0123289824f, 0.00171470642f, -0.00683176517f, -0.0023753643f,
    0.0274472237f, 0.0106110573f, -0.0138566494f, -0.00733363628f, 0.0190219879f, 0.0135304928f, -0.00710999966f, -0.00290107727f,
    -0.0112692118f, 0.0053858757f, 0.0363465548f, -0.0130372047f, 0.00499010086f, 0.00297021866f, 0.0154610872f, 0.0326957703f,
    0.033020854f, -0.00721490383f, 0.0066639185f, 0.00265431404f, -0.00598990917f, 0.020652771f, 0.00816583633f, -0.003510952f,
    0.0412524939f, 0.0159865618f, 0.0f, 0.0f, -0.00286662579f, 0.00365722179f, 0.00393462181f, 0.00175654888f,
    -0.0123800039f, 0.0125033855f, 0.01179111f, 0.00382697582f, -0.0291273594f, 0.0226532221f, 0.0215810537f, 0.00695705414f,
    -0.00422775745f, 0.00203371048f, 0.00429093838f, -0.00501596928f, -0.00213932991f, -0.000246405602f, 0.000151634216f, 0.00308513641f,
    -0.00357568264f, -0.00266861916f, -0.00348293781f, 0.00100052357f, -0.00429654121f, -0.00366699696f, 0.00365209579f, -0.0018197298f,
    -0.00944316387f, 0.00228905678f, 0.0f, 0.0f, 8.42809677e-05f, -0.00392329693f, 0.000245690346f, 0.00117599964f,
    -0.00361502171f, -0.0087171793f, 0.00213587284f, 0.00296747684f, -0.00321829319f, -0.0142083168f, 0.000463366508f, 0.00226378441f,
    0.00278759003f, -0.00114142895f, -0.00784993172f, 0.00339639187f, 0.000489115715f, -0.000734806061f, -0.00117754936f, -0.00788891315f,
    -0.00430774689f, 0.00218153f, 0.00079202652f, -0.000430822372f, 0.00121045113f, -0.00141465664f, -0.00156271458f, -0.000822305679f,
    -0.00438690186f, -0.00398588181f, 0.0f, 0.0f, 0.00104320049f, 0.00119042397f, -0.00070810318f, -0.000365495682f,
    0.00295555592f, 0.000188946724f, -0.00274550915f, -0.000693440437f, 0.00535202026f, 0.000148415565f, -0.00544047356f, -0.00225687027f,
    0.00978624821f, 0.0056180954f, 0.000553488731f, 0.0058618784f, 0.00480878353f, 0.00119924545f, 0.00135159492f, -0.00668668747f,
    0.00101804733f, -0.0056040287f, 0.00295329094f, 0.00109624863f, -0.00783014297f, -8.60691071e-05f, -0.000214338303f, -0.0161247253f,
    -0.000721096992f, 0.00110542774f, 0.0f, 0.0f, -0.00744366646f, -0.00232219696f, 0.000640630722f, 0.000709891319f,
    -0.00771188736f, -0.00255417824f, -0.000618338585f, 3.80277634e-05f, -0.0141569376f, -0.00372886658f, 0.000618934631f, 0.000542283058f,
    0.00368058681f, 5.4359436e-05f, 0.00405073166f, 0.00276398659f, 0.00438427925f, 0.00117623806f, 0.00206494331f, 0.00755262375f,
    0.00142407417f, -0.00066280365f, 0.00317144394f, 0.0011664629f, 0.00265085697f, 0.00187408924f, 0.000192523003f, 0.00905406475f,
    0.0022251606f, 0.000535011292f, 0.0f, 0.0f, -0.000981211662f, -0.000988483429f, 0.000833034515f, 0.000933527946f,
    0.00284874439f, 0.000294804573f, 0.000138998032f, 0.00023317337f, 0.00688862801f, 0.0023458004f, 0.000671982765f, 0.000172257423f,
    0.00196051598f, 0.00110316277f, 0.00068461895f, 0.00188171864f, 0.000730156898f, 0.001126647f, 0.000107884407f, 0.000916004181f,
    0.000236153603f, 0.000231027603f, 0.000655293465f, 2.38418579e-07f, 0.000128865242f, 0.000198960304f, -0.000197291374f, 0.000303864479f,
    0.000305652618f, 0.000159621239f, 0.0f, 0.0f, -0.000804901123f, -6.31809235e-06f, 8.01086426e-05f, 2.25305557e-05f,
    -0.000830054283f, 0.000151157379f, -3.34978104e-05f, -9.39369202e-05f, -0.000903367996f, 8.34465027e-05f, 0.00029528141f, 6.15119934e-05f,
    0.000195741653f, -0.000536799431f, 0.000541210175f, 0.000187754631f, 0.000527501106f, -0.000261187553f, -4.76837158e-06f, 0.000660538673f,
    0.000113368034f, 2.47955322e-05f, 0.000462889671f, -4.25577164e-05f, 0.000453591347f, 6.74724579e-05f, -0.000295042992f, 0.000514745712f,
    0.000207304955f, -3.31401825e-05f, 0.0f, 0.0f, -7.21216202e-05f, 1.43051147e-05f, 3.36170197e-05f, 2.57492065e-05f,
    0.000593066216f, 0.000126600266f, -0.000177502632f, -0.000169992447f, 0.000524401665f, 0.000271439552f, -1.2755394e-05f, -4.11272049e-05f
};

/* acc[k] = sum over t of phi[t] * row[t][k] for 4 * fours terms, four rows a pass: no reduction, so that it vectorises. */
static inline void skylight_sh_sum(const skylight_sh_real *row, int fours, const skylight_sh_real *phi, int width, skylight_sh_real *acc)
{
    int t, k;
    {
        const skylight_sh_real p0 = phi[0], p1 = phi[1], p2 = phi[2], p3 = phi[3];
        for (k = 0; k < width; ++k)
            acc[k] = (p0 * row[k] + p1 * row[k + 32]) + (p2 * row[k + 64] + p3 * row[k + 96]);
    }
    for (t = 1; t < fours; ++t) {
        const skylight_sh_real p0 = phi[4 * t], p1 = phi[4 * t + 1], p2 = phi[4 * t + 2], p3 = phi[4 * t + 3];
        row += 128;
        for (k = 0; k < width; ++k)
            acc[k] += (p0 * row[k] + p1 * row[k + 32]) + (p2 * row[k + 64] + p3 * row[k + 96]);
    }
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

/* Stores the outputs in the order of the weights, turned by the azimuth. */
static inline void skylight_sh_spread(const skylight_sh_real *acc, const skylight_sh_real *wave_cos, const skylight_sh_real *wave_sin, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
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
    (void)wave_cos;
    (void)wave_sin;
    (void)bands;
}

/* Sums the table's terms and stores the first `bands` bands. */
static inline void skylight_sh_combine(const skylight_sh_real *t0, const skylight_sh_real *rest, const skylight_sh_real *wave_cos, const skylight_sh_real *wave_sin, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    skylight_sh_real phi[32], acc[32];
    int i;
    /* Products in fours; each overshoot is overwritten by the next line. */
    for (i = 0; i < 8; ++i) phi[0 + i] = t0[i] * rest[0];
    for (i = 0; i < 8; ++i) phi[8 + i] = t0[i] * rest[1];
    for (i = 0; i < 8; ++i) phi[15 + i] = t0[i] * rest[2];
    for (i = 0; i < 4; ++i) phi[20 + i] = t0[i] * rest[3];
    for (i = 0; i < 4; ++i) phi[22 + i] = t0[i] * rest[4];
    if (bands == SKYLIGHT_SH_BANDS) skylight_sh_sum(skylight_sh_rows, 6, phi, 32, acc);
    else {
        static const unsigned short width[4] = { 8, 16, 24, 32 };
        skylight_sh_sum(skylight_sh_rows, 6, phi, width[bands - 1], acc);
    }
    skylight_sh_spread(acc, wave_cos, wave_sin, bands, weights);
}


/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot remove the test. */
static inline int skylight_sh_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* Clamps v to [low, high]; *status becomes 1 where v is not in [first, last]. An infinity is made finite by its sign bit. */
static inline skylight_sh_real skylight_sh_clamp(float v, float first, float last, skylight_sh_real low, skylight_sh_real high, int *status)
{
    skylight_sh_real x;
    if (skylight_sh_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    *status |= (v < first) | (v > last);
    x = (skylight_sh_real)v;
    x = x < low ? low : x;
    return x > high ? high : x;
}




/* sun_zenith in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_0(skylight_sh_real v)
{
    return 4.36619759f * (v - 0.0f) / (5.0f - v) - 1.0f;
}

/* turbidity in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_1(skylight_sh_real v)
{
    return (-4.57142878f) * (v - 2.5f) / ((-2.0f) - v) - 1.0f;
}

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_real skylight_sh_scale(skylight_sh_real x0, skylight_sh_real x1)
{
    const float chi = (0.444444448f - x1 * 0.00833333377f) * (3.14159274f - 2.0f * x0);
    const float square = chi * chi;
    const float tan_above = chi * (105.0f - 10.0f * square);
    const float tan_below = 105.0f - square * (45.0f - square);
    const float zenith = (4.04530001f * x1 - 4.97100019f) * tan_above + (2.41919994f - 0.215499997f * x1) * tan_below;
    const float a = 0.1787f * x1 + (-1.46300006f);
    const float b = (-0.355399996f) * x1 + 0.42750001f;
    const float up = 1.0f + b * (0.25f + b * 0.03125f);
    const float up2 = up * up;
    const float up4 = up2 * up2;
    const float c = (-0.0227000006f) * x1 + 5.32509995f;
    const float d = 0.1206f * x1 + (-2.57710004f);
    const float y = d * x0;
    const float halo = 1.0f + y * (0.125f + y * 0.0078125f);
    const float halo2 = halo * halo;
    const float halo4 = halo2 * halo2;
    const float halo8 = halo4 * halo4;
    const float e = (-0.0670000017f) * x1 + 0.370299995f;
    const float z = x0 * x0;
    const float cosine = 1.0f - z * (0.5f - z * (0.0416666679f - z * 0.00138888892f));
    return 1000.0f * zenith / (tan_below * (1.0f + a * up4) * (1.0f + c * halo8 + e * (cosine * cosine)));
}




/* sun_zenith in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_0(double v)
{
    return 4.366197723675814 * (v - 0.0) / (5.0 - v) - 1.0;
}

/* turbidity in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_1(double v)
{
    return (-4.5714285714285712) * (v - 2.5) / ((-2.0) - v) - 1.0;
}

/* What all weights share: the closed form preetham_zenith. */
static inline double skylight_sh_wide_scale(double x0, double x1)
{
    const double chi = (0.44444444444444442 - x1 * 0.0083333333333333332) * (3.1415926535897931 - 2.0 * x0);
    const double square = chi * chi;
    const double tan_above = chi * (105.0 - 10.0 * square);
    const double tan_below = 105.0 - square * (45.0 - square);
    const double zenith = (4.0453000000000001 * x1 - 4.9710000000000001) * tan_above + (2.4192 - 0.2155 * x1) * tan_below;
    const double a = 0.1787 * x1 + (-1.4630000000000001);
    const double b = (-0.35539999999999999) * x1 + 0.42749999999999999;
    const double up = 1.0 + b * (0.25 + b * 0.03125);
    const double up2 = up * up;
    const double up4 = up2 * up2;
    const double c = (-0.022700000000000001) * x1 + 5.3250999999999999;
    const double d = 0.1206 * x1 + (-2.5771000000000002);
    const double y = d * x0;
    const double halo = 1.0 + y * (0.125 + y * 0.0078125);
    const double halo2 = halo * halo;
    const double halo4 = halo2 * halo2;
    const double halo8 = halo4 * halo4;
    const double e = (-0.067000000000000004) * x1 + 0.37030000000000002;
    const double z = x0 * x0;
    const double cosine = 1.0 - z * (0.5 - z * (0.041666666666666664 - z * 0.0013888888888888889));
    return 1000.0 * zenith / (tan_below * (1.0 + a * up4) * (1.0 + c * halo8 + e * (cosine * cosine)));
}

/* The basis of the first axis, `t` of 8, zero where the table has no term. */
static inline void skylight_sh_first(skylight_sh_real x, skylight_sh_real *t)
{
    const skylight_sh_real u = skylight_sh_map_0(x);
    int i;
    for (i = 0; i < 8; ++i) t[i] = 0;
    t[0] = 1.0f;
    t[1] = u;
    t[2] = 2.0f * t[1] * t[1] - 1.0f;
    t[3] = 2.0f * t[1] * t[2] - t[1];
    t[4] = 2.0f * t[2] * t[2] - 1.0f;
    t[5] = 2.0f * t[2] * t[3] - t[1];
    t[6] = 2.0f * t[3] * t[3] - 1.0f;
    t[7] = 2.0f * t[3] * t[4] - t[1];
    (void)u;
}

/* All products of the other axes' bases, `rest` of 5. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        t[0] = 1.0f;
        t[1] = u;
        t[2] = 2.0f * t[1] * t[1] - 1.0f;
        t[3] = 2.0f * t[1] * t[2] - t[1];
        t[4] = 2.0f * t[2] * t[2] - 1.0f;
        (void)u;
    }
    for (i1 = 0; i1 < 5; ++i1)
        rest[r++] = t1[i1];
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling: m = h + k. */
static inline void skylight_sh_waves(skylight_sh_real azimuth, skylight_sh_real *wave_cos, skylight_sh_real *wave_sin)
{
    int m;
    wave_cos[0] = 1;
    wave_sin[0] = 0;
    wave_cos[1] = cosf(azimuth);
    wave_sin[1] = sinf(azimuth);
    for (m = 2; m < SKYLIGHT_SH_BANDS; ++m) {
        const int h = m / 2, k = m - h;
        wave_cos[m] = wave_cos[h] * wave_cos[k] - wave_sin[h] * wave_sin[k];
        wave_sin[m] = wave_sin[h] * wave_cos[k] + wave_cos[h] * wave_sin[k];
    }
    (void)azimuth;
}

/* Zeroes bands that were not asked for. */
static inline void skylight_sh_finish(int bands, const skylight_sh_real *wave_cos, const skylight_sh_real *wave_sin, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int channel, i;
    if (bands < SKYLIGHT_SH_BANDS) {
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_WEIGHTS; ++i) weights[channel][i] = 0.0f;
    }
    (void)wave_cos;
    (void)wave_sin;
}

/* Checks and clamps the inputs into x; returns the status. */
static inline int skylight_sh_inputs(float sun_zenith, float sun_azimuth, float turbidity, skylight_sh_real x[SKYLIGHT_SH_AXES])
{
    int status = 0;
    if (skylight_sh_kind(sun_azimuth) | skylight_sh_kind(sun_zenith) | skylight_sh_kind(turbidity)) {
        if (skylight_sh_kind(sun_azimuth) != 0 || skylight_sh_kind(sun_zenith) == 2 || skylight_sh_kind(turbidity) == 2) return 2;
    }
    x[0] = skylight_sh_clamp(sun_zenith, -1.57079626e-06f, 1.5707978f, 0.0f, 1.57079637f, &status);
    x[1] = skylight_sh_clamp(turbidity, 2.49999666f, 6.00000334f, 2.5f, 6.0f, &status);
    return status;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_BANDS, clamped likewise) and zeroes the rest. */
static inline int skylight_sh_weights_bands(float sun_zenith, float sun_azimuth, float turbidity, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[8], rest[5], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
    int i, status = skylight_sh_inputs(sun_zenith, sun_azimuth, turbidity, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    if (bands < 1) { bands = 1; status = 1; }
    if (bands > SKYLIGHT_SH_BANDS) { bands = SKYLIGHT_SH_BANDS; status = 1; }
    scale = skylight_sh_scale(x[0], x[1]) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
    skylight_sh_first(x[0], t0);
    skylight_sh_rest(x[1], rest);
    for (i = 0; i < 5; ++i) rest[i] *= scale;
    skylight_sh_waves((skylight_sh_real)sun_azimuth, wave_cos, wave_sin);
    skylight_sh_combine(t0, rest, wave_cos, wave_sin, bands, weights);
    skylight_sh_finish(bands, wave_cos, wave_sin, weights);
    return status;
}

/* Evaluates all bands. */
static inline int skylight_sh_weights(float sun_zenith, float sun_azimuth, float turbidity, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    return skylight_sh_weights_bands(sun_zenith, sun_azimuth, turbidity, SKYLIGHT_SH_BANDS, weights);
}

/* Evaluates `count` suns from arrays; returns the largest status. Suns in a row that differ in sun_zenith and azimuth alone cost less. */
static inline int skylight_sh_weights_batch(int count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity, float (*weights)[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int s, worst = 0;
    skylight_sh_real line[8 * 32], known[SKYLIGHT_SH_AXES];
    int ready = 0;
    for (s = 0; s < count; ++s) {
        skylight_sh_real x[SKYLIGHT_SH_AXES], t0[8], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], acc[32], scale;
        const int status = skylight_sh_inputs(sun_zenith[s], sun_azimuth[s], turbidity[s], x);
        int i;
        worst = status > worst ? status : worst;
        if (status == 2) {
            memset(weights[s], 0, sizeof weights[s]);
            continue;
        }
        ready = ready && !memcmp(x + 1, known + 1, sizeof *x * (SKYLIGHT_SH_AXES - 1));
        if (!ready) {
            /* The rows summed over the other axes once, for all suns that share them. */
            skylight_sh_real rest[5];
            skylight_sh_rest(x[1], rest);
            for (i = 0; i < 8 * 32; ++i) line[i] = 0;
            for (i = 0; i < 256; ++i) line[i] += rest[0] * skylight_sh_rows[0 + i];
            for (i = 0; i < 224; ++i) line[i] += rest[1] * skylight_sh_rows[256 + i];
            for (i = 0; i < 160; ++i) line[i] += rest[2] * skylight_sh_rows[480 + i];
            for (i = 0; i < 64; ++i) line[i] += rest[3] * skylight_sh_rows[640 + i];
            for (i = 0; i < 64; ++i) line[i] += rest[4] * skylight_sh_rows[704 + i];
            for (i = 0; i < SKYLIGHT_SH_AXES; ++i) known[i] = x[i];
            ready = 1;
        }
        scale = skylight_sh_scale(x[0], x[1]) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
        skylight_sh_first(x[0], t0);
        for (i = 0; i < 8; ++i) t0[i] *= scale;
        skylight_sh_waves((skylight_sh_real)sun_azimuth[s], wave_cos, wave_sin);
        skylight_sh_sum(line, 2, t0, 32, acc);
        skylight_sh_spread(acc, wave_cos, wave_sin, SKYLIGHT_SH_BANDS, weights[s]);
        skylight_sh_finish(SKYLIGHT_SH_BANDS, wave_cos, wave_sin, weights[s]);
    }
    return worst;
}

/* Evaluates all bands and their derivatives after each axis (sun_zenith, turbidity), per unit of the axis; beyond a range, those at its edge. */
static inline int skylight_sh_weights_gradient(float sun_zenith, float sun_azimuth, float turbidity, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], float gradient[SKYLIGHT_SH_AXES][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const double low[SKYLIGHT_SH_AXES] = { 0.0, 2.5 }, high[SKYLIGHT_SH_AXES] = { 1.5707963267948966, 6.0 };
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[8], rest[5], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
    double from[SKYLIGHT_SH_AXES], slope[SKYLIGHT_SH_AXES], grown[SKYLIGHT_SH_AXES];
    int i, a, status = skylight_sh_inputs(sun_zenith, sun_azimuth, turbidity, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        memset(gradient, 0, sizeof(float) * SKYLIGHT_SH_AXES * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    scale = skylight_sh_scale(x[0], x[1]) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
    skylight_sh_waves((skylight_sh_real)sun_azimuth, wave_cos, wave_sin);
    for (a = 0; a < SKYLIGHT_SH_AXES; ++a) from[a] = (double)x[a];
    /* Slopes of the map and of the logarithm of the scale, by central differences in double. At an edge the middle stays
       h inside, which costs the slope up to 2.2e-4 of the axis's largest. */
    for (a = 0; a < SKYLIGHT_SH_AXES; ++a) {
        const double h = 1e-5 * (high[a] - low[a]), middle = from[a];
        double above[2], logarithm[2];
        from[a] = middle < low[a] + h ? low[a] + h : middle > high[a] - h ? high[a] - h : middle;
        for (i = 0; i < 2; ++i) {
            from[a] += i ? 2.0 * h : -h;
            logarithm[i] = log(fabs(skylight_sh_wide_scale(from[0], from[1])));
            above[i] = a == 0 ? skylight_sh_wide_map_0(from[a]) : skylight_sh_wide_map_1(from[a]);
        }
        slope[a] = (above[1] - above[0]) / (2.0 * h);
        grown[a] = (logarithm[1] - logarithm[0]) / (2.0 * h);
        from[a] = middle;
    }
    for (a = -1; a < SKYLIGHT_SH_AXES; ++a) {
        float(*out)[SKYLIGHT_SH_WEIGHTS] = a < 0 ? weights : gradient[a];
        skylight_sh_first(x[0], t0);
        if (a == 0) {
            /* T'(i) = 2 T(i-1) + 2 u T'(i-1) - T'(i-2). */
            skylight_sh_real d[8];
            d[0] = 0;
            d[1] = 1;
            for (i = 2; i < 8; ++i) d[i] = 2 * t0[i - 1] + 2 * t0[1] * d[i - 1] - d[i - 2];
            for (i = 0; i < 8; ++i) t0[i] = (skylight_sh_real)grown[0] * t0[i] + (skylight_sh_real)slope[0] * d[i];
        }
        if (a < 1) skylight_sh_rest(x[1], rest);
        else {
            int r = 0;
            skylight_sh_real t1[8], d1[8];
            int i1;
            t1[0] = 1;
            t1[1] = skylight_sh_map_1(x[1]);
            d1[0] = 0;
            d1[1] = 1;
            for (i = 2; i < 5; ++i) {
                t1[i] = 2 * t1[1] * t1[i - 1] - t1[i - 2];
                d1[i] = 2 * t1[i - 1] + 2 * t1[1] * d1[i - 1] - d1[i - 2];
            }
            if (a == 1)
                for (i = 0; i < 5; ++i) t1[i] = (skylight_sh_real)grown[1] * t1[i] + (skylight_sh_real)slope[1] * d1[i];
            for (i1 = 0; i1 < 5; ++i1)
                rest[r++] = t1[i1];
        }
        for (i = 0; i < 5; ++i) rest[i] *= scale;
        skylight_sh_combine(t0, rest, wave_cos, wave_sin, SKYLIGHT_SH_BANDS, out);
        skylight_sh_finish(SKYLIGHT_SH_BANDS, wave_cos, wave_sin, out);
    }
    return status;
}


/* Unit vector of the dominant light: where the linear part of the weights, summed over channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
static inline int skylight_sh_dominant(float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], float direction[3])
{
    static const float luminance[SKYLIGHT_SH_CHANNELS] = { 0.212672845f, 0.715152144f, 0.0721749961f };
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        x += luminance[channel] * weights[channel][3];
        y += luminance[channel] * weights[channel][1];
        z += luminance[channel] * weights[channel][2];
    }
    length = sqrtf(x * x + y * y + z * z);
    direction[0] = length > 0.0f ? x / length : 0.0f;
    direction[1] = length > 0.0f ? y / length : 0.0f;
    direction[2] = length > 0.0f ? z / length : 1.0f;
    return !(length > 0.0f);
}


/* Optional: an even ground of this albedo below the horizon, lit by the sky (before any window): its radiance is albedo E / pi, and E, the irradiance on it, is a multiple of the weight l = 1, m = 0. */
static inline void skylight_sh_ground(const float albedo[SKYLIGHT_SH_CHANNELS], float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_BANDS] = { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f };
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * 0.65147001587f * weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) weights[channel][l * (l + 1)] += radiance * lower[l];
    }
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
