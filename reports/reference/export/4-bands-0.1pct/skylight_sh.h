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
 * Accuracy, as shipped: E_mean 0.0731 %, E_max 0.21 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -13.3 % of its largest
 * in the same set; the window below tames it.
 * Memory: 5314 bytes of constants, laid out for speed.
 *
 * Provenance
 *   config preetham, table 4-bands-0.1pct
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
#define SKYLIGHT_SH_E_MEAN 7.309996e-04
#define SKYLIGHT_SH_E_MAX 2.103968e-03
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* One row a term (powers of the other axes, then of the first); a row holds the term's coefficient for every output. */
static const skylight_sh_real skylight_sh_rows[1280] = {
    2.32449269f, 2.64175582f, 3.30527759f, 1.79734695f, 0.926028609f, 2.28846478f, 0.716334045f, 3.21512127f,
    0.589408159f, -0.362873346f, 0.738728642f, 0.515167058f, 0.012831036f, 0.635383368f, 0.365135998f, 0.66691041f,
    0.64304769f, 0.226192981f, 0.0f, 0.0f, -0.849623919f, -0.0538262352f, 0.401887387f, 0.258595794f,
    -0.827794909f, 0.064708136f, 0.315501124f, 0.180326477f, -0.725868165f, 0.263573796f, 0.253747225f, 0.0802837685f,
    0.332229704f, -0.223514527f, -1.26770353f, -0.105171867f, 0.666525304f, -0.534824014f, 0.415923804f, -1.45153654f,
    0.100259267f, -0.79271251f, 0.336889863f, 0.507708848f, -0.709991574f, 0.205788568f, 0.322335899f, -0.768733263f,
    0.0288156345f, 0.103327207f, 0.0f, 0.0f, -0.661815643f, -0.400008559f, 0.305613667f, 0.287813991f,
    -0.46971333f, -0.275849551f, 0.203841895f, 0.185527623f, -0.245134979f, -0.137320742f, 0.0895236582f, 0.0422771685f,
    -0.0194768086f, -0.0736694187f, -0.332980335f, -0.00404419238f, -0.291723669f, -0.0316121578f, -0.301629603f, -0.200959936f,
    -0.461524844f, 0.0744273216f, -0.371209025f, -0.106921725f, 0.110323004f, -0.368288845f, -0.121041723f, 0.221025735f,
    -0.506802559f, -0.198938176f, 0.0f, 0.0f, 0.176528558f, -0.20453915f, -0.18499966f, -0.031174371f,
    0.213274628f, -0.190888301f, -0.181969926f, -0.0441711806f, 0.376461357f, -0.211143911f, -0.229500547f, -0.0811838731f,
    -0.0383057669f, -0.00673146639f, -0.00722629018f, 0.0166015048f, -0.0352273658f, 0.0359269567f, 0.00465261983f, 0.0420638844f,
    0.0587280691f, 0.100069664f, 0.0464896969f, -0.0926811397f, 0.0838117003f, 0.0783975273f, -0.0622817166f, 0.094574742f,
    0.141121909f, -0.0381200835f, 0.0f, 0.0f, 0.0723754168f, 0.16579859f, -0.0515553243f, -0.0720358342f,
    0.0509644188f, 0.161993101f, -0.0285556819f, -0.0527648889f, 0.053871002f, 0.191852808f, -0.00559896044f, -0.0325375348f,
    -0.00494332053f, 0.000926021254f, 0.059355136f, -0.00535380328f, -0.00104804919f, -0.00561449397f, 0.00586661696f, 0.034559723f,
    0.035142947f, -0.0153288813f, 0.012739026f, 0.0081612654f, -0.0251084212f, 0.0104403757f, 0.0166324936f, -0.0461889915f,
    0.0253723692f, 0.0421113558f, 0.0f, 0.0f, -0.0417477824f, 0.00800231099f, 0.0363674797f, -0.00621395046f,
    -0.0478145182f, -0.00616019219f, 0.0378491245f, 0.00230071251f, -0.0811487287f, -0.0243054386f, 0.053848289f, 0.0198316984f,
    0.00319258915f, 0.00193654082f, -0.0103012696f, 0.00230184593f, 0.00311720115f, 0.00128137972f, 0.000706692575f, -0.0135049252f,
    -6.15112458e-06f, -0.000528392382f, -0.00217642682f, 0.00216858648f, 0.000829905155f, -0.00544895232f, 0.000659507117f, -0.00541010965f,
    -0.0120056365f, 0.00188116974f, 0.0f, 0.0f, 0.00325263129f, -0.0142489402f, -0.00203937502f, 0.00558059802f,
    0.00726221502f, -0.0148286754f, -0.00556460768f, 0.00509362295f, 0.0118642049f, -0.0231775828f, -0.01029131f, 0.00720201759f,
    0.0004739305f, -8.94966506e-05f, -0.000373501825f, -0.000294545869f, 0.00119382353f, -0.000346515095f, 0.000634128985f, 0.00101461273f,
    -0.00379873044f, -0.00077136769f, 0.000644710497f, 0.00104371109f, 4.06079198e-05f, 0.000965780171f, 0.000182620759f, 0.00390769867f,
    -0.00241797091f, -0.00292169279f, 0.0f, 0.0f, 0.000947708264f, 0.00151834579f, -0.000891700678f, 0.000400115241f,
    0.00122461282f, 0.00335256709f, -0.00105445483f, -0.000487173966f, 0.0049319258f, 0.00527868839f, -0.00387278991f, -0.00264753052f,
    0.000151503918f, 6.15891622e-05f, -0.00045451225f, 8.90656975e-06f, 5.64958646e-05f, -8.00928683e-06f, -4.83848635e-05f, -8.78713581e-06f,
    0.000249608333f, -0.000173972046f, -0.000300921762f, 0.000228841614f, -0.000178386894f, -0.00023043032f, 0.000161634918f, 0.000376141135f,
    0.0012752082f, -0.000448487699f, 0.0f, 0.0f, -0.000328830793f, -0.000456287322f, 0.000203380798f, 0.00028787367f,
    -0.000610759482f, -0.000409895671f, 0.000454727822f, 0.000156076057f, -0.00101602881f, 0.0016906223f, 0.000948294066f, -0.000591304502f,
    -1.94150161e-05f, 9.9468316e-06f, 0.000239884568f, -3.98019038e-05f, 4.99748494e-05f, 1.08926415e-05f, 3.26349509e-05f, 0.00014412895f,
    2.40470818e-05f, 1.12576809e-05f, -1.90040998e-06f, 3.17908925e-05f, 4.38437746e-05f, 1.1689016e-05f, -1.58813837e-05f, -0.000232173334f,
    -2.45148531e-05f, 0.000168403902f, 0.0f, 0.0f, 0.000137685172f, -2.77742147e-05f, -0.000107923595f, 6.82085083e-05f,
    0.000161411182f, -5.24188654e-05f, -0.000129784239f, 3.44656e-05f, -0.000344250759f, -0.000445933547f, 0.000245628355f, 9.62859267e-05f,
    0.700555146f, 0.644515932f, 0.488863796f, 0.6998896f, 0.259019434f, 0.763802826f, 0.13959761f, 0.746226847f,
    0.0656232238f, 0.169681355f, 0.260009259f, 0.0943813771f, 0.395116091f, 0.170859277f, 0.00900232606f, 0.658201754f,
    0.112655841f, -0.0194487292f, 0.0f, 0.0f, -0.150774091f, 0.0744354054f, 0.106476858f, 0.0475760996f,
    0.0119864773f, 0.0978481099f, 0.0361019596f, 0.00644632708f, 0.29553476f, 0.116182201f, 0.000459908973f, -0.0110916765f,
    0.0219673123f, -0.22051768f, -0.345548481f, -0.068653658f, 0.160460889f, -0.27240622f, 0.0527809933f, -0.456616968f,
    -0.00196330133f, -0.200541258f, 0.11084418f, 0.0734064877f, -0.187710956f, 0.0471935533f, -0.0136474613f, -0.337068856f,
    6.79114528e-05f, -0.0228647571f, 0.0f, 0.0f, -0.202323034f, -0.0585064255f, 0.0649453178f, 0.0442809649f,
    -0.113789633f, -0.00850784965f, 0.00290949107f, -0.00169776555f, -0.167825609f, -0.002382359f, -0.0141288964f, -0.0113646826f,
    -0.0560646132f, -0.00917344447f, 0.101533361f, -0.0378549509f, -0.106977209f, 0.00404092111f, -0.0702940971f, 0.0804904848f,
    -0.0178458486f, 0.0378057957f, -0.137136698f, -0.0464460775f, 0.0353364721f, -0.0907172263f, -0.0265556276f, -0.00424899347f,
    -0.0505325124f, 0.0163310226f, 0.0f, 0.0f, 0.086180076f, -0.0842532143f, -0.0681660473f, -0.0190471131f,
    0.0576758645f, -0.061110191f, -0.0389585979f, -0.0123097198f, -0.00618376536f, -0.0733179674f, 0.000898696948f, 0.00905500352f,
    -0.0254834928f, 0.0177741684f, 0.0908481404f, -0.0091497954f, -0.00378095033f, 0.0214554891f, 0.0214679167f, 0.0775721893f,
    0.051491458f, 0.0279538687f, 0.0206044596f, -0.0188135765f, 0.0126250191f, 0.0365308635f, 0.00427417876f, -0.00191654521f,
    0.0586319827f, 0.0268998686f, 0.0f, 0.0f, 0.0294220708f, 0.0544794425f, -0.0111985281f, -0.0150302537f,
    0.00238278601f, 0.0415402092f, 0.00687083742f, -0.000207363715f, -0.0306162126f, 0.0341689698f, 0.023665227f, 0.0138698136f,
    0.0150356423f, -0.00124136137f, -0.0400121175f, 0.0113617098f, 0.00756783551f, -0.00587325264f, 0.00341519783f, -0.0400695056f,
    -0.00981137529f, -0.00767003698f, 0.00868631899f, 0.0086466372f, -0.0122701367f, -0.000631772564f, 0.00737788482f, -0.0124621792f,
    -0.0166126397f, 1.56489059e-05f, 0.0f, 0.0f, -0.0212266352f, -0.000805589603f, 0.015399185f, 0.00360570219f,
    -0.0147048468f, -0.0100482982f, 0.0091533754f, 0.00506234681f, 0.000352841365f, -0.0172769371f, -0.0012215171f, 0.00170084229f,
    -0.000383415172f, -6.5405824e-05f, -0.00122847629f, -0.00171938655f, 0.00205058791f, 0.0003271639f, -0.00159533869f, 0.00245695817f,
    -0.00946511887f, -0.0022282633f, -0.00110254122f, 0.00174472062f, 0.00202002982f, -0.00348108681f, -0.00136858097f, 0.00891885441f,
    -0.00831670687f, -0.00804354344f, 0.0f, 0.0f, 0.0011010454f, -0.0065023629f, -0.00118390936f, 0.00263005239f,
    0.00509703904f, -0.00380909815f, -0.00409857929f, 0.000308449817f, 0.0111446818f, 0.000595704943f, -0.00890015345f, -0.00440852577f,
    -0.00044751566f, -0.000289826567f, 0.00175596809f, -0.000388393732f, -0.000990845961f, -4.91458013e-05f, -0.000152454566f, 0.00211098464f,
    0.00257816864f, 0.000419357297f, -0.00113195064f, -0.000523734663f, 0.000455539906f, 0.000708041305f, -0.000530342921f, 0.000564124668f,
    0.00501056062f, 0.00021725292f, 0.0f, 0.0f, 0.00134443387f, 0.000543739821f, -0.00121453137f, -0.000460203155f,
    0.000248475291f, 0.00243645976f, -0.000206644851f, -0.000842530862f, -0.00205871509f, 0.00555872871f, 0.00212028879f, -0.00097282324f,
    -0.000198894064f, -3.13471492e-06f, 0.00051095715f, -1.0966578e-05f, -9.89822438e-05f, 2.1592723e-05f, -7.9830701e-05f, -7.07097352e-05f,
    0.000416639377f, 0.000296293525f, 0.000156917551f, -0.000249052129f, -7.90223276e-05f, -2.42010319e-05f, 1.61250737e-05f, -0.00130645931f,
    -0.000188550912f, 0.00103443488f, 0.0f, 0.0f, 2.44091061e-05f, 0.000512581377f, 4.49215659e-05f, -0.00022410159f,
    -0.000430580723f, -0.000175331661f, 0.000348683738f, -2.72767829e-05f, -0.00160020881f, -0.00174662902f, 0.00115213892f, 0.000757220434f,
    8.92722455e-05f, 3.18326045e-07f, -0.00026993241f, 7.47161757e-05f, 3.91855501e-05f, 1.18214084e-05f, 9.5915475e-06f, -0.000236826978f,
    -9.28167574e-05f, -4.64009827e-05f, 7.45252837e-05f, 4.16947078e-05f, 2.47259431e-05f, 1.38667519e-05f, -1.58473904e-05f, 0.000120779579f,
    -0.000299803942f, -8.8290828e-05f, 0.0f, 0.0f, -0.000130129629f, -2.48492215e-05f, 0.000103200786f, 1.20834811e-05f,
    7.58885944e-05f, -4.81728275e-05f, -4.82832074e-05f, 1.23674627e-05f, 0.000570749282f, -0.000329595903f, -0.000438787392f, 0.000111399408f,
    -0.00410507061f, -0.0584870763f, -0.175253853f, -0.00716186175f, 0.00147368794f, -0.0567207485f, -0.0184618104f, -0.188175738f,
    -0.031658411f, -0.00406184886f, -0.00350053865f, -0.0086931223f, -0.00430667587f, -0.0220485516f, -0.0196224041f, -0.058183033f,
    -0.0408494249f, -0.0166359637f, 0.0f, 0.0f, 0.00518527161f, -0.00688983873f, -0.00944223162f, -0.00304214959f,
    0.0330658071f, -0.0098485807f, -0.0208004043f, -0.00815691333f, 0.0526401103f, -0.0240790937f, -0.022199003f, -0.00619952008f,
    0.00837132335f, -0.00879325252f, 0.0590355136f, 0.0123514552f, 0.00853425171f, 0.00392158702f, -0.00383012695f, 0.075354442f,
    0.00130853546f, 0.0131442631f, 0.00689466018f, -0.00754913781f, 0.0261812862f, 0.000946524902f, -0.0161950346f, 0.0502922311f,
    0.00594673818f, -0.00670991838f, 0.0f, 0.0f, 0.0124523723f, 0.00163812214f, -0.00687322253f, -0.00245005568f,
    0.0274009649f, 0.0105135767f, -0.0138245365f, -0.00725985738f, 0.0188378803f, 0.0125139365f, -0.00711156568f, -0.00278941728f,
    -0.011780045f, 0.00539799035f, 0.0352134816f, -0.0136276651f, 0.00475929817f, 0.00292339991f, 0.0155227147f, 0.0318783596f,
    0.0327055976f, -0.00756354583f, 0.00660097459f, 0.00259302906f, -0.00613376778f, 0.0208252389f, 0.00822945684f, -0.00313964672f,
    0.0415118001f, 0.0155985421f, 0.0f, 0.0f, -0.00305929803f, 0.00394850643f, 0.0039059897f, 0.00175598357f,
    -0.0125517752f, 0.0127576608f, 0.0118604274f, 0.00387466815f, -0.028549891f, 0.0239005275f, 0.0213676859f, 0.00676633045f,
    -0.0043642926f, 0.0020062204f, 0.00357066141f, -0.00512421085f, -0.0023104141f, -0.000266575837f, 1.4913805e-05f, 0.00249529886f,
    -0.0039625261f, -0.00266755535f, -0.00365232141f, 0.000869226409f, -0.00430146232f, -0.00376233435f, 0.00355723454f, -0.00174038589f,
    -0.009892812f, 0.0020725904f, 0.0f, 0.0f, 4.2737116e-05f, -0.00397713855f, 0.000184779434f, 0.00102999387f,
    -0.00367664546f, -0.00865311362f, 0.00210828451f, 0.00285340054f, -0.00296829082f, -0.0145084402f, 0.000412199937f, 0.00205184286f,
    0.00287350756f, -0.00116286706f, -0.00805036351f, 0.0035577768f, 0.000347853231f, -0.000750215491f, -0.00118725933f, -0.00816226657f,
    -0.00422984315f, 0.00238880841f, 0.00070992473f, -0.00049489073f, 0.00123278343f, -0.00146477157f, -0.00157790491f, -0.000996336807f,
    -0.00436293846f, -0.0040112203f, 0.0f, 0.0f, 0.00127321994f, 0.00126661907f, -0.0008421354f, -0.000319251325f,
    0.00303347292f, 9.23288317e-05f, -0.00279943389f, -0.000682523008f, 0.00542870583f, 3.15679645e-05f, -0.0056363428f, -0.00212240615f,
    -0.000720486336f, -0.000130085828f, 0.00235708477f, -0.000907720183f, 8.18777189e-05f, 7.37260707e-05f, -0.000270771241f, 0.00295938365f,
    0.000401791389f, -0.000676790602f, 0.000166542173f, 2.04467833e-05f, 0.000309536059f, 0.000229573052f, -0.00030924927f, 0.00167208875f,
    0.00138265139f, 0.000107899075f, 0.0f, 0.0f, -0.000589034462f, 0.000235556392f, 0.000252099213f, -0.000178357281f,
    -0.00012641793f, 0.00110948947f, 0.000170397732f, -0.000532816921f, -0.000357116311f, 0.00220566406f, 0.00103770022f, -0.000457645569f,
    -4.41379489e-05f, 6.84028346e-05f, 0.000179460141f, 1.3151267e-05f, -0.00022251319f, 7.81919589e-05f, 7.85075026e-05f, -5.03077245e-05f,
    0.000786429038f, 0.000127061139f, -0.00028190462f, -9.53839626e-05f, -3.44619439e-05f, 0.000125145802f, 6.20309947e-05f, -0.000616408477f,
    0.000770085433f, 0.000593116798f, 0.0f, 0.0f, 0.000175554145f, -0.000247215386f, -0.000101631209f, -1.59904721e-05f,
    -0.000209299789f, -8.11923237e-05f, 0.000208852827f, 6.25221292e-05f, -0.000921484025f, -0.000181188618f, 0.000749887724f, 0.00047456735f,
    7.64583747e-05f, 2.20081165e-05f, -0.000212358646f, 7.22471741e-05f, 9.50956164e-05f, -2.15553928e-06f, 4.50551306e-05f, -0.00025358249f,
    -0.000186773366f, 3.54281747e-06f, 0.000133795213f, 4.23334604e-05f, -4.50171574e-05f, 1.18644148e-05f, 5.19597306e-05f, -9.65056533e-05f,
    -0.000407675951f, -5.0598378e-06f, 0.0f, 0.0f, -3.53532196e-05f, 0.000104635743f, 4.90105886e-05f, 2.69043321e-05f,
    -1.10630144e-05f, -7.10303648e-05f, 1.09820567e-05f, 5.33484745e-05f, 0.000171293592f, -0.00047722875f, -0.000196107183f, 7.4873853e-05f,
    0.00928693358f, 0.00560666155f, -0.000507437915f, 0.00533167506f, 0.00452412991f, 0.00116109662f, 0.00143032731f, -0.0075657987f,
    0.000639021397f, -0.0058453721f, 0.00276029063f, 0.00102304947f, -0.00791072566f, 6.48955029e-05f, -0.000139718584f, -0.0159777142f,
    -0.000789053738f, 0.000744723598f, 0.0f, 0.0f, -0.00754778646f, -0.00222152332f, 0.000589450006f, 0.000694941322f,
    -0.00782028399f, -0.00239238143f, -0.000527649769f, 9.51988986e-05f, -0.01364078f, -0.00304462924f, 0.000316417951f, 0.00035315298f,
    0.00427981f, 3.65989072e-05f, 0.0041000573f, 0.00348818628f, 0.0046150214f, 0.0011839025f, 0.00203170977f, 0.00734981708f,
    0.00138511672f, -0.000179947441f, 0.00327531481f, 0.00118188723f, 0.00272389548f, 0.00178261078f, 0.000159288451f, 0.00854228344f,
    0.00160169147f, 0.000739045208f, 0.0f, 0.0f, -0.00069395575f, -0.00118384848f, 0.00082663889f, 0.000872781442f,
    0.00297386269f, 0.000191855055f, 6.8668036e-05f, 0.000212594605f, 0.0065915077f, 0.000956778647f, 0.000711810659f, 0.00032212041f,
    -0.00148678909f, 0.000134754766f, -0.00296500488f, -0.00170610251f, -0.000578199397f, -7.67993479e-05f, 0.000296562299f, -0.00246204273f,
    -0.000823681534f, -0.000997520285f, -0.000189906685f, -0.000138978896f, -0.000608352828f, 0.00109909871f, 0.000277926796f, 0.000291147328f,
    0.000206793047f, -0.000786836143f, 0.0f, 0.0f, -0.000598546409f, 0.000669031346f, -5.7001057e-06f, -1.08530071e-06f,
    -0.00108984567f, 0.0017104178f, 0.000616076635f, 8.34028251e-05f, 0.00105207728f, 0.0021548816f, -0.000408952212f, -0.000376048032f,
    -0.000106663218f, 2.47898497e-05f, -0.0042464952f, 8.97231876e-05f, -0.000718916883f, -7.22033947e-05f, -0.000392874063f, -0.00411867863f,
    -0.00160033524f, 0.000341788429f, -0.000658332894f, -0.000400076475f, -0.000182393953f, -0.000708013074f, -0.000174436325f, -0.000691613473f,
    -0.00209668744f, -0.000978025142f, 0.0f, 0.0f, 0.000211803388f, -0.000161772899f, -0.000351016904f, -0.000291788019f,
    -0.000107218249f, -0.000838474021f, -0.000237695553f, -0.000125152495f, 0.00136245042f, -0.00155618705f, -0.00108990865f, -0.000464170473f,
    -8.56676124e-05f, -0.000116057039f, 0.00211355044f, -3.90445857e-05f, -1.8477398e-05f, -4.52558888e-05f, -5.10293939e-05f, 0.00225908053f,
    0.000562848989f, 0.000107262153f, 6.72090682e-05f, -6.89063381e-05f, 0.000167986436f, -6.91877995e-06f, -0.000115702234f, 0.000840155757f,
    0.000822745089f, 0.000134425893f, 0.0f, 0.0f, 0.000186808596f, 0.000200647439f, -5.12435545e-05f, -9.45233842e-05f,
    0.000301187043f, 0.000150596257f, -0.000170849336f, -8.36000327e-05f, -0.000127608975f, 0.000722025696f, 0.000172591608f, 2.94878173e-05f,
    -7.80585924e-06f, 5.03364208e-05f, 8.58135681e-05f, -3.13290948e-05f, 5.51139419e-05f, 4.05658357e-05f, 6.48059067e-05f, -6.10092284e-05f,
    0.000449845858f, -6.75038464e-05f, 3.66692766e-05f, 5.36751468e-05f, -3.06331385e-05f, 9.45561478e-05f, 6.60843361e-05f, -0.000364307314f,
    0.000453673973f, 0.000365905958f, 0.0f, 0.0f, -9.22175968e-05f, -3.36706071e-05f, 7.59163886e-05f, 4.39644355e-05f,
    -0.000111658439f, 6.8801739e-05f, 0.0001156527f, 3.85541207e-05f, -0.000513717125f, 7.00847886e-05f, 0.000443161436f, 0.000209759193f,
    3.29214199e-05f, 1.85223907e-05f, -0.000139185984f, 2.13670028e-05f, 3.88600056e-05f, 5.44633849e-06f, 2.73802052e-05f, -0.000151189146f,
    -0.000182210366f, -1.23616464e-05f, 1.87560381e-05f, 3.75783166e-05f, -2.27859291e-05f, 2.59507647e-06f, 3.07755436e-05f, -2.73445676e-05f,
    -0.000300815358f, -5.74183978e-05f, 0.0f, 0.0f, -8.19350134e-06f, -3.3779892e-05f, 1.49340185e-05f, 4.11276669e-05f,
    -1.77964794e-05f, -5.73685502e-05f, 1.45775339e-05f, 3.60916092e-05f, 0.000132734771f, -0.000288007577f, -0.000149293177f, 1.08936447e-05f,
    0.00169727346f, 0.0011503537f, 2.00429931e-05f, 0.00157727674f, 0.000607868773f, 0.0011773936f, 0.00010251256f, 0.000287424366f,
    -3.61359525e-05f, 5.32782578e-05f, 0.000577159633f, -5.27256052e-05f, 0.000177820737f, 0.000130036758f, -0.000222430303f, 0.00026174169f,
    3.32990894e-05f, -5.29659155e-05f, 0.0f, 0.0f, -0.000911116425f, 6.47244815e-05f, 4.78574075e-05f, -9.09389473e-06f,
    -0.000725499063f, 4.06297913e-05f, -0.000121663252f, -9.11590178e-05f, -0.000573418743f, 7.53394852e-05f, 2.12026807e-05f, -2.60677953e-05f,
    0.000371567585f, -0.000489005353f, 8.26175892e-05f, 0.000368478883f, 0.000495602435f, -0.000245159754f, 6.13300144e-05f, 0.00022553117f,
    -2.92253753e-05f, 7.31704276e-05f, 0.000466543686f, -0.000111534893f, 0.000384826446f, 0.000163814126f, -0.000244468276f, 0.000425689155f,
    4.88664737e-05f, -6.80502708e-05f, 0.0f, 0.0f, -0.000117999909f, 5.5867622e-05f, 3.73022294e-06f, -3.35859404e-05f,
    0.000487842859f, 0.000192693376f, -0.000117758733f, -0.000117864227f, 0.000559922948f, 0.000145902086f, -3.5450596e-06f, -4.19525531e-05f,
    -0.000316254649f, 3.54753538e-05f, -0.000289396732f, -0.000276294071f, -0.000167721664f, 1.25580641e-06f, -1.68786628e-05f, -0.000444817124f,
    -9.61905826e-05f, -8.45472732e-06f, -0.000161985969f, -7.51667685e-05f, -7.00287637e-05f, 1.68392799e-05f, 1.48845766e-05f, -0.000369081477f,
    -0.000170346393f, -2.87500206e-05f, 0.0f, 0.0f, 8.27535987e-05f, -2.39068395e-05f, -7.48482053e-05f, -3.24433859e-05f,
    -9.01185122e-05f, 7.16052236e-05f, 2.11273764e-05f, -1.0666522e-05f, -8.77245257e-05f, -0.000140005301f, -7.83510914e-05f, -1.34315096e-05f,
    2.51896563e-05f, 8.73703684e-05f, -0.000514488493f, 6.69420479e-05f, -4.60315678e-05f, 5.12648367e-05f, 4.40949079e-05f, -0.000600873958f,
    -9.00311497e-05f, 9.88722677e-05f, -3.31217234e-05f, -8.99560746e-06f, -4.60856754e-05f, -4.14913393e-06f, 4.66851852e-05f, -0.000310611329f,
    -0.000140403252f, -1.68643928e-05f, 0.0f, 0.0f, 7.45776269e-05f, 1.45025688e-05f, -2.1637039e-05f, -8.56338829e-06f,
    -5.0052382e-05f, -8.49028365e-05f, 1.82137028e-05f, 3.00537977e-05f, -2.43133036e-05f, -0.000132485831f, -4.96965113e-05f, 2.58421846e-06f,
    7.60329021e-06f, -8.96455913e-06f, 0.000318650506f, -1.85163972e-05f, 3.53146897e-05f, -9.42854786e-06f, 2.12114428e-05f, 0.00040275979f,
    8.07783872e-05f, -5.37801061e-05f, 2.52554128e-05f, 3.13165256e-05f, -3.48909708e-07f, 1.55406087e-05f, 1.61552289e-05f, 0.000258136541f,
    0.000131179448f, 2.82837227e-05f, 0.0f, 0.0f, -4.42790479e-05f, -1.05699437e-05f, 2.72743837e-05f, 2.3741417e-05f,
    1.09104976e-05f, 6.428143e-08f, 8.33595095e-06f, 1.96826077e-05f, 7.22227633e-05f, 0.000124793267f, 5.17532935e-05f, 1.73582284e-05f,
    0.000402084203f, 0.00031085196f, 0.000150298263f, 0.000349551643f, 0.000131620807f, 0.000282704394f, 3.32663985e-05f, 0.000161262302f,
    6.86026169e-06f, 5.47610171e-07f, 0.000113114838f, 6.4065116e-06f, 3.0072657e-05f, 2.43249979e-05f, -2.3044975e-05f, 7.51109619e-05f,
    1.41536184e-05f, 2.79792584e-06f, 0.0f, 0.0f, -0.000144194302f, 8.89048988e-06f, 1.04121291e-05f, 6.08293158e-06f,
    -8.33683443e-05f, -2.90833736e-06f, -2.1383501e-05f, -6.25019038e-06f, 1.6441867e-05f, 2.42477508e-05f, 4.87533453e-06f, -2.76176183e-06f,
    3.41609157e-05f, -9.39547172e-05f, -4.34103385e-05f, 1.06210873e-05f, 8.37861735e-05f, -8.00390553e-05f, 2.8409122e-05f, -4.26284569e-05f,
    -1.84228747e-06f, -3.32563723e-05f, 5.53977443e-05f, -8.7747876e-06f, 9.55086489e-06f, 2.58722466e-05f, -1.91530489e-05f, -1.05173049e-05f,
    -4.54259998e-06f, -2.85536217e-08f, 0.0f, 0.0f, -2.31123413e-05f, -2.75581842e-05f, -1.18189382e-05f, 6.07459469e-06f,
    5.34766914e-05f, 6.75629735e-06f, -1.87573951e-05f, -5.41293048e-06f, 1.13386386e-05f, -7.29407157e-06f, -1.1472705e-06f, 1.26697444e-06f
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
    skylight_sh_real phi[48], acc[32];
    int i;
    /* Products in fours; each overshoot is overwritten by the next line. */
    for (i = 0; i < 12; ++i) phi[0 + i] = t0[i] * rest[0];
    for (i = 0; i < 12; ++i) phi[9 + i] = t0[i] * rest[1];
    for (i = 0; i < 8; ++i) phi[18 + i] = t0[i] * rest[2];
    for (i = 0; i < 8; ++i) phi[26 + i] = t0[i] * rest[3];
    for (i = 0; i < 8; ++i) phi[33 + i] = t0[i] * rest[4];
    for (i = 0; i < 4; ++i) phi[38 + i] = t0[i] * rest[5];
    if (bands == SKYLIGHT_SH_BANDS) skylight_sh_sum(skylight_sh_rows, 10, phi, 32, acc);
    else {
        static const unsigned short width[4] = { 8, 16, 24, 32 };
        skylight_sh_sum(skylight_sh_rows, 10, phi, width[bands - 1], acc);
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

/* The basis of the first axis, `t` of 12, zero where the table has no term. */
static inline void skylight_sh_first(skylight_sh_real x, skylight_sh_real *t)
{
    const skylight_sh_real u = skylight_sh_map_0(x);
    const int n = 9;
    int i;
    for (i = 0; i < 12; ++i) t[i] = 0;
    t[0] = 1;
    if (n > 1) t[1] = u;
    for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
}

/* All products of the other axes' bases, `rest` of 6. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0, i;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 6;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    for (i1 = 0; i1 < 6; ++i1)
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[6], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
    for (i = 0; i < 6; ++i) rest[i] *= scale;
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
    skylight_sh_real line[12 * 32], known[SKYLIGHT_SH_AXES];
    int ready = 0;
    for (s = 0; s < count; ++s) {
        skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], acc[32], scale;
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
            skylight_sh_real rest[6];
            skylight_sh_rest(x[1], rest);
            for (i = 0; i < 12 * 32; ++i) line[i] = 0;
            for (i = 0; i < 288; ++i) line[i] += rest[0] * skylight_sh_rows[0 + i];
            for (i = 0; i < 288; ++i) line[i] += rest[1] * skylight_sh_rows[288 + i];
            for (i = 0; i < 256; ++i) line[i] += rest[2] * skylight_sh_rows[576 + i];
            for (i = 0; i < 224; ++i) line[i] += rest[3] * skylight_sh_rows[832 + i];
            for (i = 0; i < 160; ++i) line[i] += rest[4] * skylight_sh_rows[1056 + i];
            for (i = 0; i < 64; ++i) line[i] += rest[5] * skylight_sh_rows[1216 + i];
            for (i = 0; i < SKYLIGHT_SH_AXES; ++i) known[i] = x[i];
            ready = 1;
        }
        scale = skylight_sh_scale(x[0], x[1]) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
        skylight_sh_first(x[0], t0);
        for (i = 0; i < 12; ++i) t0[i] *= scale;
        skylight_sh_waves((skylight_sh_real)sun_azimuth[s], wave_cos, wave_sin);
        skylight_sh_sum(line, 3, t0, 32, acc);
        skylight_sh_spread(acc, wave_cos, wave_sin, SKYLIGHT_SH_BANDS, weights[s]);
        skylight_sh_finish(SKYLIGHT_SH_BANDS, wave_cos, wave_sin, weights[s]);
    }
    return worst;
}

/* Evaluates all bands and their derivatives after each axis (sun_zenith, turbidity), per unit of the axis; beyond a range, those at its edge. */
static inline int skylight_sh_weights_gradient(float sun_zenith, float sun_azimuth, float turbidity, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], float gradient[SKYLIGHT_SH_AXES][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const double low[SKYLIGHT_SH_AXES] = { 0.0, 2.5 }, high[SKYLIGHT_SH_AXES] = { 1.5707963267948966, 6.0 };
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[6], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
            skylight_sh_real d[12];
            d[0] = 0;
            d[1] = 1;
            for (i = 2; i < 9; ++i) d[i] = 2 * t0[i - 1] + 2 * t0[1] * d[i - 1] - d[i - 2];
            for (i = 0; i < 9; ++i) t0[i] = (skylight_sh_real)grown[0] * t0[i] + (skylight_sh_real)slope[0] * d[i];
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
            for (i = 2; i < 6; ++i) {
                t1[i] = 2 * t1[1] * t1[i - 1] - t1[i - 2];
                d1[i] = 2 * t1[i - 1] + 2 * t1[1] * d1[i - 1] - d1[i - 2];
            }
            if (a == 1)
                for (i = 0; i < 6; ++i) t1[i] = (skylight_sh_real)grown[1] * t1[i] + (skylight_sh_real)slope[1] * d1[i];
            for (i1 = 0; i1 < 6; ++i1)
                rest[r++] = t1[i1];
        }
        for (i = 0; i < 6; ++i) rest[i] *= scale;
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
