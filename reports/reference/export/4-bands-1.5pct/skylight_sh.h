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
 * Accuracy, as shipped: E_mean 1.41 %, E_max 3.79 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -13.3 % of its largest
 * in the same set; the window below tames it.
 * Memory: 3265 bytes of constants, laid out for speed.
 *
 * Provenance
 *   config preetham, table 4-bands-1.5pct
 *   selection e20f28358e8eeec4c668aa59ee2e88df7566b063480189f3dc5b4345e257eb1d
 *   python 3.11.7, numpy 2.4.6, scipy 1.17.1, h5py 3.16.0, dask 2026.8.0
 *   x86_64: AVX512_ICL X86_V2 X86_V3 X86_V4
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
#define SKYLIGHT_SH_E_MEAN 1.409681e-02
#define SKYLIGHT_SH_E_MAX 3.790307e-02
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
    2.32454848f, 2.64175367f, 3.30516601f, 1.79740691f, 0.926047742f, 2.28847265f, 0.716331065f, 3.21495128f,
    0.589315951f, -0.362840921f, 0.738731861f, 0.515179634f, 0.0128501495f, 0.635388732f, 0.365127981f, 0.66681838f,
    0.642818153f, 0.226219401f, 0.0f, 0.0f, -0.849602163f, -0.0538444705f, 0.401884317f, 0.258614421f,
    -0.827787697f, 0.0647254586f, 0.31550622f, 0.180315822f, -0.725706041f, 0.263325989f, 0.253596216f, 0.0803433508f,
    0.332257718f, -0.223508283f, -1.26786053f, -0.105143316f, 0.66653353f, -0.534820914f, 0.415919662f, -1.45161748f,
    0.100243583f, -0.792704403f, 0.336898595f, 0.507717073f, -0.710006297f, 0.205802694f, 0.322340012f, -0.768652916f,
    0.0289534163f, 0.10321673f, 0.0f, 0.0f, -0.661813676f, -0.400010169f, 0.305615187f, 0.28782621f,
    -0.469765693f, -0.275817037f, 0.203876019f, 0.185521498f, -0.24517715f, -0.1370233f, 0.0895731971f, 0.042180866f,
    -0.0195109323f, -0.0736693591f, -0.333317518f, -0.00409265189f, -0.291711628f, -0.0316250473f, -0.301623404f, -0.201306537f,
    -0.461650968f, 0.0743887648f, -0.37120536f, -0.106912546f, 0.110292174f, -0.368258238f, -0.121036164f, 0.220920041f,
    -0.506953716f, -0.199003488f, 0.0f, 0.0f, 0.176499307f, -0.204540521f, -0.184989184f, -0.0311712865f,
    0.21325393f, -0.190840602f, -0.181973979f, -0.0441689529f, 0.376521111f, -0.21126467f, -0.229574606f, -0.0812072232f,
    -0.0382274613f, -0.00671618711f, -0.00740486989f, 0.016691206f, -0.0352261998f, 0.0359230414f, 0.0046535898f, 0.0419193543f,
    0.0586822368f, 0.100123361f, 0.0464748889f, -0.0926780701f, 0.0837707892f, 0.0783805847f, -0.0622582324f, 0.0945846811f,
    0.141129181f, -0.0381947681f, 0.0f, 0.0f, 0.0724107176f, 0.165767297f, -0.0515672751f, -0.0720201209f,
    0.05089055f, 0.161952794f, -0.0285158381f, -0.0527381338f, 0.0538932085f, 0.1919173f, -0.00561472634f, -0.0325820595f,
    -0.00493531814f, 0.00093534647f, 0.0595403239f, -0.00535184937f, -0.00103152951f, -0.00561266299f, 0.00585582154f, 0.0347767174f,
    0.0352228023f, -0.0153328646f, 0.0127418432f, 0.00817270763f, -0.025115665f, 0.010397072f, 0.0166339744f, -0.0461150818f,
    0.0255072452f, 0.0421219207f, 0.0f, 0.0f, -0.0417526625f, 0.00799544808f, 0.0363707729f, -0.00620204769f,
    -0.0478245169f, -0.00622678827f, 0.0378450863f, 0.00231076241f, -0.0812782869f, -0.024225153f, 0.0539726876f, 0.0197927523f,
    0.00312776654f, 0.00191712601f, -0.0100035658f, 0.00226812507f, 0.0031047028f, 0.00128914381f, 0.000693525479f, -0.0133076264f,
    1.83434931e-05f, -0.000506609038f, -0.0021011522f, 0.0021124871f, 0.000885012618f, -0.0054095583f, 0.000616454519f, -0.00545684109f,
    -0.0121751903f, 0.00202947855f, 0.0f, 0.0f, 0.00330858794f, -0.0141367661f, -0.0020697047f, 0.00549354078f,
    0.00733672455f, -0.0147047099f, -0.00560748577f, 0.0050377734f, 0.0120246876f, -0.0234771091f, -0.0104385354f, 0.00736033311f,
    0.000522525515f, -7.73190332e-05f, -0.000359040627f, -0.000300257205f, 0.00121073588f, -0.00034043318f, 0.000644723943f, 0.00111285981f,
    -0.0036658477f, -0.000837628206f, 0.000517019071f, 0.00112826319f, 1.56278984e-05f, 0.0009887052f, 0.000203980118f, 0.00397324609f,
    -0.00208475231f, -0.00295943604f, 0.0f, 0.0f, 0.000828402175f, 0.0013285426f, -0.000816311862f, 0.000511391961f,
    0.00114001252f, 0.00336503377f, -0.000987622654f, -0.000472554239f, 0.00460394472f, 0.00560409622f, -0.00357479556f, -0.00275470689f,
    0.700630903f, 0.644536912f, 0.488869995f, 0.699961901f, 0.25904268f, 0.763827145f, 0.139594719f, 0.746179342f,
    0.0656004474f, 0.169704363f, 0.259995431f, 0.0943987891f, 0.395129442f, 0.170842394f, 0.00900180265f, 0.658156037f,
    0.112511754f, -0.0193921663f, 0.0f, 0.0f, -0.150783509f, 0.0743856058f, 0.106488325f, 0.0475926138f,
    0.0119744167f, 0.0978236794f, 0.0361156091f, 0.00644581392f, 0.295690805f, 0.116022363f, 0.000328144757f, -0.0110111563f,
    0.0220193043f, -0.220526755f, -0.345496356f, -0.0685920492f, 0.160510972f, -0.272405565f, 0.0527917631f, -0.456526667f,
    -0.00199418096f, -0.200502172f, 0.110899068f, 0.0734187067f, -0.1876885f, 0.0472011156f, -0.0136533324f, -0.336994112f,
    0.000128836022f, -0.0229079835f, 0.0f, 0.0f, -0.20226869f, -0.0585010983f, 0.0649363399f, 0.0442938842f,
    -0.113745265f, -0.00851659663f, 0.00289088371f, -0.00169754738f, -0.167875916f, -0.00219350751f, -0.0140761044f, -0.0114322584f,
    -0.0561256893f, -0.00914717373f, 0.101079911f, -0.037957117f, -0.106944293f, 0.00403796928f, -0.0702786967f, 0.08002913f,
    -0.0179928783f, 0.0376952179f, -0.137112081f, -0.0464062802f, 0.0352507494f, -0.0906060189f, -0.0265254118f, -0.00436706934f,
    -0.0507186688f, 0.016233949f, 0.0f, 0.0f, 0.0860730708f, -0.0842425227f, -0.0681119785f, -0.0190178994f,
    0.0574967228f, -0.0609153174f, -0.0388599411f, -0.0123114213f, -0.00605825242f, -0.0734447837f, 0.000760993746f, 0.0090317633f,
    -0.0253797434f, 0.0177768078f, 0.0901153758f, -0.00899540912f, -0.00381912291f, 0.0214394685f, 0.021434281f, 0.0767610297f,
    0.0513031669f, 0.0281021465f, 0.0205711611f, -0.018847907f, 0.0125872819f, 0.0364771187f, 0.00426128088f, -0.00222211378f,
    0.0582699031f, 0.0267863553f, 0.0f, 0.0f, 0.0295701604f, 0.0544621199f, -0.0112763122f, -0.01503284f,
    0.002359509f, 0.0414795578f, 0.00684454432f, -0.00021411365f, -0.0304153375f, 0.0337496214f, 0.0233819205f, 0.0139089264f,
    0.0150756026f, -0.00123713596f, -0.0395533256f, 0.011393005f, 0.00762263313f, -0.00586769171f, 0.00340788881f, -0.0395155326f,
    -0.00979352091f, -0.00767784333f, 0.00872363336f, 0.00866234675f, -0.0122525692f, -0.000692324771f, 0.00737009896f, -0.0121543817f,
    -0.0165157598f, -6.2636459e-06f, 0.0f, 0.0f, -0.0212752391f, -0.000809561287f, 0.0154440021f, 0.00357777043f,
    -0.0146478377f, -0.0101644546f, 0.00911161304f, 0.00507473527f, 0.000369477231f, -0.017084172f, -0.00114970154f, 0.00159942196f,
    -0.000241438363f, -2.97908518e-05f, -0.00203463598f, -0.00150214951f, 0.0020387664f, 0.000322394131f, -0.00151438185f, 0.00130088953f,
    -0.00957075693f, -0.00203458848f, -0.0010524292f, 0.0017119227f, 0.00195956533f, -0.00347852986f, -0.00128641468f, 0.00815969426f,
    -0.00903704204f, -0.00792933814f, 0.0f, 0.0f, 0.00131407485f, -0.006466805f, -0.0012676405f, 0.00263895956f,
    0.00510161556f, -0.00396237103f, -0.00409994507f, 0.000426680257f, 0.0114998193f, -0.000592230004f, -0.00949506182f, -0.00403763447f,
    -0.00038186062f, -0.000300065818f, 0.00194420293f, -0.000355895463f, -0.000913433905f, -7.06606879e-05f, -0.000131706358f, 0.0024436668f,
    0.00240159151f, 0.000386742031f, -0.0011188963f, -0.000457992806f, 0.000458710681f, 0.000692957197f, -0.00052792026f, 0.000907775597f,
    0.00496607926f, -1.70759449e-05f, 0.0f, 0.0f, 0.00126415084f, 0.000524063245f, -0.00116092875f, -0.000406999257f,
    0.000368795212f, 0.00240412215f, -0.000307662296f, -0.000821781403f, -0.00198934413f, 0.00586404791f, 0.00206347089f, -0.00124107266f,
    -0.00022083045f, -3.36159646e-05f, 0.00082501088f, 6.40038998e-05f, -0.000157386996f, 3.01430246e-05f, -9.35934731e-05f, -0.000113766437f,
    0.000328048976f, 0.000411130983f, 0.00032673683f, -0.000393557071f, 2.81633902e-06f, 8.54497266e-05f, -7.88015095e-05f, -0.00161242124f,
    -0.00105740735f, 0.00136540143f, 0.0f, 0.0f, 0.000158268638f, 0.000725384918f, -2.24440992e-05f, -0.000416587834f,
    -0.000220057118f, 9.77554591e-05f, 0.000183483149f, -0.000140285847f, -0.00079130294f, -0.00293682329f, 0.000369989284f, 0.001228521f,
    -0.00391969969f, -0.0584734082f, -0.174373269f, -0.00696489448f, 0.00155467121f, -0.0567179359f, -0.0184590966f, -0.18741107f,
    -0.0313284062f, -0.00397163257f, -0.00347846234f, -0.00866906811f, -0.00432064198f, -0.0220800713f, -0.0196150765f, -0.0582234263f,
    -0.0406488478f, -0.0163819473f, 0.0f, 0.0f, 0.00521500362f, -0.00698105153f, -0.00942692999f, -0.00303714327f,
    0.0330708064f, -0.00992512703f, -0.0208166577f, -0.00813673623f, 0.0522619635f, -0.0243088156f, -0.021965187f, -0.00608417718f,
    0.00820879638f, -0.00879479572f, 0.0596010685f, 0.0121395281f, 0.00855149422f, 0.00393889565f, -0.00385888433f, 0.0759420097f,
    0.00145881728f, 0.0129814474f, 0.00697234925f, -0.00753269112f, 0.0262221936f, 0.000915588345f, -0.0162238125f, 0.050501328f,
    0.00621263357f, -0.00657772645f, 0.0f, 0.0f, 0.0123633845f, 0.0017626253f, -0.00684567587f, -0.00242968439f,
    0.0274095926f, 0.0105132014f, -0.0138219586f, -0.00729112467f, 0.0188274235f, 0.012899328f, -0.00702470215f, -0.00272197928f,
    -0.0113383541f, 0.00538104214f, 0.0361909159f, -0.0131111294f, 0.00496178539f, 0.00296351057f, 0.0154635347f, 0.0326134637f,
    0.0329727754f, -0.00725145545f, 0.00667222589f, 0.00263653696f, -0.00598306954f, 0.0206257794f, 0.00816987641f, -0.00339100766f,
    0.0413254015f, 0.0158753302f, 0.0f, 0.0f, -0.0028696591f, 0.00371309021f, 0.00391981704f, 0.00173888344f,
    -0.0123489602f, 0.0124630388f, 0.0117706936f, 0.00383962388f, -0.0289886128f, 0.0229351204f, 0.0214958768f, 0.00689004594f,
    -0.00419126824f, 0.00203047181f, 0.00455132686f, -0.00496230787f, -0.00211676583f, -0.000243111208f, 0.000143438519f, 0.00328216259f,
    -0.00352069573f, -0.00262468797f, -0.00345885754f, 0.00098575023f, -0.00428196415f, -0.00367395487f, 0.00364208501f, -0.00186922844f,
    -0.00951353367f, 0.00241435017f, 0.0f, 0.0f, 9.95279261e-05f, -0.00392417563f, 0.000249831442f, 0.00115108362f,
    -0.00360218971f, -0.00870880298f, 0.00212904322f, 0.00295697153f, -0.00328187179f, -0.0144486846f, 0.000509986188f, 0.00234256219f,
    0.00273454422f, -0.00114862609f, -0.00796693563f, 0.00333892438f, 0.000460550917f, -0.000728067884f, -0.00118648179f, -0.00804656837f,
    -0.00432461267f, 0.0021519349f, 0.000791327737f, -0.00043932689f, 0.00123445352f, -0.00140307588f, -0.00157815428f, -0.000923076819f,
    -0.00445975969f, -0.00397002324f, 0.0f, 0.0f, 0.00102257484f, 0.00124206988f, -0.000712843961f, -0.000356553181f,
    0.00296285632f, 0.000230843027f, -0.00274067488f, -0.000717707793f, 0.00537283393f, 2.80295808e-05f, -0.00549111143f, -0.00220479676f,
    0.0097196931f, 0.00562495226f, 0.000273232989f, 0.00579508347f, 0.00473931944f, 0.00119884359f, 0.00137347251f, -0.00688396022f,
    0.000899891078f, -0.00562532898f, 0.00287883868f, 0.0010821356f, -0.00784462411f, -6.86304702e-05f, -0.000191593455f, -0.0160177518f,
    -0.000718666997f, 0.000954842195f, 0.0f, 0.0f, -0.00743592298f, -0.00235417089f, 0.000612698786f, 0.000710241322f,
    -0.0077309045f, -0.00255736173f, -0.000599127088f, 6.11712167e-05f, -0.0139947115f, -0.00347328046f, 0.000520420261f, 0.00044160214f,
    0.00367336487f, 4.61059208e-05f, 0.00444635563f, 0.00277653313f, 0.00440534297f, 0.00116981205f, 0.00209513889f, 0.0077612442f,
    0.00156453229f, -0.000628800248f, 0.00323184114f, 0.00114489044f, 0.00264758267f, 0.00195949199f, 0.000203966149f, 0.00877585448f,
    0.00205922383f, 0.000818458502f, 0.0f, 0.0f, -0.000972536975f, -0.000906263303f, 0.000844865106f, 0.000899368257f,
    0.00284278044f, 0.000426678744f, 0.000155215675f, 0.000235333064f, 0.00663597742f, 0.00169654016f, 0.000794172869f, 0.000381369726f,
    0.0018372247f, 0.00109728298f, 0.000466341036f, 0.00173629262f, 0.000675844029f, 0.0011211785f, 0.00010615163f, 0.000737133727f,
    0.000160767857f, 0.000148269115f, 0.000602146436f, -4.9514906e-08f, 0.000138194082f, 0.00016746769f, -0.000195716479f, 0.000331697025f,
    0.000277446641f, 6.1276929e-05f, 0.0f, 0.0f, -0.000847043702f, -2.56275212e-06f, 7.59621689e-05f, 3.40318184e-05f,
    -0.00080032571f, 9.9428471e-05f, -5.11632861e-05f, -8.30294084e-05f, -0.000815812498f, 0.000170181927f, 0.000226906239f, 6.13043539e-07f,
    0.000216694403f, -0.000539075059f, 0.000588036724f, 0.000235681626f, 0.000492230116f, -0.000257290842f, 6.2863096e-06f, 0.000612150005f,
    0.000123928869f, 7.87386525e-05f, 0.00046252957f, -9.01553431e-05f, 0.000465832069f, 9.50609829e-05f, -0.000299277017f, 0.000341689418f,
    5.7834859e-05f, 9.80234545e-05f, 0.0f, 0.0f, -4.06156541e-05f, 5.30910984e-05f, 6.95745484e-06f, -2.2008373e-05f,
    0.000631933624f, 0.000157983348f, -0.000199246802f, -0.00017490107f, 0.000450600899f, -7.73342908e-05f, 1.43630732e-05f, 7.6236407e-05f
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
    for (i = 0; i < 8; ++i) phi[7 + i] = t0[i] * rest[1];
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
    static const skylight_sh_real k[3] = { 0.0f, 4.36619759f, 5.0f };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* turbidity in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_1(skylight_sh_real v)
{
    static const skylight_sh_real k[3] = { 2.5f, -4.57142878f, -2.0f };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_real skylight_sh_scale(skylight_sh_real sun_zenith, skylight_sh_real turbidity)
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




/* sun_zenith in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_0(double v)
{
    static const double k[3] = { 0.0, 4.366197723675814, 5.0 };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* turbidity in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_1(double v)
{
    static const double k[3] = { 2.5, -4.5714285714285712, -2.0 };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* What all weights share: the closed form preetham_zenith. */
static inline double skylight_sh_wide_scale(double sun_zenith, double turbidity)
{
    static const double k[10] = { 0.1787, -1.4630000000000001, -0.35539999999999999, 0.42749999999999999, -0.022700000000000001, 5.3250999999999999, 0.1206, -2.5771000000000002, -0.067000000000000004, 0.37030000000000002 };
    const double a = k[0] * turbidity + k[1], b = k[2] * turbidity + k[3], c = k[4] * turbidity + k[5];
    const double d = k[6] * turbidity + k[7], e = k[8] * turbidity + k[9];
    const double chi = (0.44444444444444444 - turbidity * 0.0083333333333333333) * (3.1415926535897932 - 2.0 * sun_zenith);
    const double square = chi * chi;
    const double tan_above = chi * (105.0 - 10.0 * square), tan_below = 105.0 - square * (45.0 - square);
    const double y = d * sun_zenith, z = sun_zenith * sun_zenith;
    const double cosine = 1.0 - z * (0.5 - z * (0.041666666666666667 - z * 0.0013888888888888889));
    double up = 1.0 + b * (0.25 + b * 0.03125), halo = 1.0 + y * (0.125 + y * 0.0078125);
    up = up * up;
    up = up * up;
    halo = halo * halo;
    halo = halo * halo;
    halo = halo * halo;
    return 1000.0 * ((4.0453 * turbidity - 4.9710) * tan_above + (2.4192 - 0.2155 * turbidity) * tan_below)
        / (tan_below * (1.0 + a * up) * (1.0 + c * halo + e * (cosine * cosine)));
}

/* The basis of the first axis, `t` of 8, zero where the table has no term. */
static inline void skylight_sh_first(skylight_sh_real x, skylight_sh_real *t)
{
    const skylight_sh_real u = skylight_sh_map_0(x);
    const int n = 8;
    int i;
    for (i = 0; i < 8; ++i) t[i] = 0;
    t[0] = 1;
    if (n > 1) t[1] = u;
    for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
}

/* All products of the other axes' bases, `rest` of 5. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0, i;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 5;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    for (i1 = 0; i1 < 5; ++i1)
        rest[r++] = t1[i1];
    (void)i;
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
            for (i = 0; i < 224; ++i) line[i] += rest[0] * skylight_sh_rows[0 + i];
            for (i = 0; i < 256; ++i) line[i] += rest[1] * skylight_sh_rows[224 + i];
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
    /* Slopes of the map and of the logarithm of the scale, by central differences in double: right to 1e-8. */
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
