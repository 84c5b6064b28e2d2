/* Prescribed-time controller masses_refuse: see masses_refuse.h. DO NOT EDIT. */
#include "masses_refuse.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* What this file requires of its compiler. */
#if (defined(FLT_MANT_DIG) && (FLT_MANT_DIG != 24))
#error "float is not IEEE 754 binary32 here"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD > 0) && (FLT_EVAL_METHOD < 3)
#error "float is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
#endif
#endif
#if !defined(PTC_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#elif defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__ > 0
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#endif
#endif
#endif

#if !defined(PTC_FINITE_F32)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F32(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F32(x) (fabsf(x) <= FLT_MAX)
#endif
#endif

/* Numbers of the design, each rounded once. */
#define MASSES_REFUSE_GAMMA1 0.0019801282f /* prediction from u */
#define MASSES_REFUSE_GAMMA2 0.39339164f /* prediction from u */
#define MASSES_REFUSE_PHI1_1 0.98019874f /* prediction of x1 from x1 */
#define MASSES_REFUSE_PHI1_2 0.0098347915f /* prediction of x1 from x2 */
#define MASSES_REFUSE_PHI1_3 0.0019801282f /* prediction of x1 from d */
#define MASSES_REFUSE_PHI2_1 (-3.9339166f) /* prediction of x2 from x1 */
#define MASSES_REFUSE_PHI2_2 0.96052915f /* prediction of x2 from x2 */
#define MASSES_REFUSE_PHI2_3 0.39339164f /* prediction of x2 from d */
#define MASSES_REFUSE_U_MAX 10.0f /* bound of |u| */
#define MASSES_REFUSE_HOLD 4.0f /* samples to go at which the gains are held */

/* Gains of least energy of each state, a row for the samples to go of a node */
static const float masses_refuse_gains[72][2] = {
    {-243.35172f, -3.708417f},
    {-141.97978f, -2.940159f},
    {-91.20574f, -2.42074f},
    {-62.172104f, -2.0438325f},
    {-44.045025f, -1.7562149f},
    {-32.00454f, -1.5283414f},
    {-23.638628f, -1.3425357f},
    {-17.630842f, -1.1876156f},
    {-13.212915f, -1.0562031f},
    {-9.911793f, -0.94327444f},
    {-7.422871f, -0.84533006f},
    {-5.5421553f, -0.75989294f},
    {-4.127859f, -0.6851881f},
    {-3.0776107f, -0.619927f},
    {-2.3143728f, -0.5631508f},
    {-1.7775029f, -0.5141103f},
    {-1.4170575f, -0.47216737f},
    {-1.1902988f, -0.4367144f},
    {-1.059812f, -0.40711266f},
    {-0.9928262f, -0.38265345f},
    {-0.96136767f, -0.36254746f},
    {-0.9428456f, -0.34594363f},
    {-0.9206555f, -0.33197358f},
    {-0.88443464f, -0.31981143f},
    {-0.8297522f, -0.30873436f},
    {-0.7572071f, -0.29817086f},
    {-0.6710846f, -0.28772703f},
    {-0.57782114f, -0.27718824f},
    {-0.48453298f, -0.26649964f},
    {-0.39779902f, -0.255732f},
    {-0.32279754f, -0.24504048f},
    {-0.26281482f, -0.2346226f},
    {-0.21909139f, -0.22468027f},
    {-0.19094585f, -0.21538858f},
    {-0.17610927f, -0.2068729f},
    {-0.17120288f, -0.19919534f},
    {-0.17229171f, -0.19235064f},
    {-0.1754457f, -0.18627104f},
    {-0.1772414f, -0.18083896f},
    {-0.17514436f, -0.17590527f},
    {-0.1677301f, -0.17131026f},
    {-0.15472637f, -0.16690424f},
    {-0.13688827f, -0.16256464f},
    {-0.11574309f, -0.15820758f},
    {-0.09325821f, -0.15379284f},
    {-0.07149021f, -0.14932226f},
    {-0.052267715f, -0.1448327f},
    {-0.036947154f, -0.14038521f},
    {-0.026264861f, -0.13605227f},
    {-0.020292852f, -0.13190511f},
    {-0.018491715f, -0.12800251f},
    {-0.01984327f, -0.12438272f},
    {-0.023037573f, -0.121058784f},
    {-0.02668425f, -0.11801807f},
    {-0.02951691f, -0.1152254f},
    {-0.030562269f, -0.11262923f},
    {-0.029252268f, -0.110169716f},
    {-0.025467185f, -0.10778738f},
    {-0.019509016f, -0.105431035f},
    {-0.012015165f, -0.1030638f},
    {-0.0038306501f, -0.100666605f},
    {0.0041383314f, -0.098238796f},
    {0.011066225f, -0.09579603f},
    {0.019562796f, -0.090983264f},
    {0.020080505f, -0.086493276f},
    {0.01536057f, -0.08251945f},
    {0.010357261f, -0.07907682f},
    {0.009222333f, -0.07600829f},
    {0.013146717f, -0.073085256f},
    {0.020137876f, -0.07013505f},
    {0.02659536f, -0.06712104f},
    {0.029559942f, -0.06413745f},
};

/* U at 11 samples on the way to rest by the state, for each a row for the samples to go of a node */
static const float masses_refuse_bounds_u[374][2] = {
    {-63.908497f, -2.1009142f},
    {-45.27515f, -1.8052639f},
    {-32.898388f, -1.5710262f},
    {-24.298826f, -1.3800311f},
    {-18.123251f, -1.2207843f},
    {-13.581936f, -1.0857016f},
    {-10.188618f, -0.969619f},
    {-7.630183f, -0.8689391f},
    {-5.696941f, -0.78111583f},
    {-4.2431455f, -0.7043246f},
    {-3.1635647f, -0.6372408f},
    {-2.3790104f, -0.57887894f},
    {-2.4107165f, -0.5865939f},
    {-1.4760474f, -0.49182296f},
    {-1.1039302f, -0.4240601f},
    {-1.0013878f, -0.37763974f},
    {-0.9589809f, -0.34579313f},
    {-0.86429346f, -0.3215865f},
    {-0.6990208f, -0.29970464f},
    {-0.50470334f, -0.27759358f},
    {-0.33623508f, -0.25524113f},
    {-0.3301639f, -0.25063238f},
    {-0.18012814f, -0.2115938f},
    {-0.18128611f, -0.18496577f},
    {-0.1400121f, -0.16627441f},
    {-0.053460483f, -0.14813784f},
    {-0.018913703f, -0.13092357f},
    {-0.030190496f, -0.117854886f},
    {-0.019954218f, -0.10783701f},
    {0.011318761f, -0.09798212f},
    {0.011434309f, -0.09898239f},
    {0.010701763f, -0.08170707f},
    {0.027479973f, -0.06935361f},
    {0.027479973f, -0.06935361f},
    {-9.852644f, -0.9461501f},
    {11.317714f, -0.31776413f},
    {15.627179f, -0.037113816f},
    {15.077405f, 0.09609934f},
    {13.207906f, 0.16023542f},
    {11.137577f, 0.18960647f},
    {9.629814f, 0.13685694f},
    {8.574805f, 0.091907494f},
    {7.8069615f, 0.0544657f},
    {7.276275f, 0.024998942f},
    {6.923118f, 0.0030527199f},
    {6.692046f, -0.012240895f},
    {6.829336f, 0.06345791f},
    {6.57311f, 0.041723214f},
    {6.3775086f, 0.034136914f},
    {6.1000013f, 0.033269417f},
    {5.708217f, 0.03277027f},
    {5.25434f, 0.029251048f},
    {4.819917f, 0.02267333f},
    {4.463072f, 0.015104354f},
    {4.195939f, 0.008875246f},
    {4.1201754f, 0.008714991f},
    {3.7469923f, 0.00413436f},
    {3.3712885f, 0.0048378184f},
    {2.9774318f, 0.0028410254f},
    {2.6778972f, -0.0007723669f},
    {2.4611864f, -0.0016877226f},
    {2.244289f, -0.00089847273f},
    {2.025754f, -0.0014293694f},
    {1.8523662f, -0.0027313065f},
    {1.882033f, 0.016119104f},
    {1.6076154f, 0.0136083f},
    {1.3550723f, 0.01066653f},
    {1.3550723f, 0.01066653f},
    {35.18528f, 0.063280575f},
    {30.074492f, 0.24074553f},
    {23.594929f, 0.2912596f},
    {18.169014f, 0.2952634f},
    {13.965504f, 0.28162426f},
    {10.751859f, 0.2616331f},
    {8.278528f, 0.2398803f},
    {6.3487806f, 0.21820131f},
    {4.8192773f, 0.19724661f},
    {3.5882046f, 0.17715181f},
    {2.5839076f, 0.15784132f},
    {1.7562594f, 0.13917406f},
    {3.9579976f, -0.30685163f},
    {4.0084534f, -0.27593505f},
    {3.884136f, -0.245644f},
    {3.6019578f, -0.22130126f},
    {3.2497544f, -0.20454283f},
    {2.9256337f, -0.19377314f},
    {2.6884778f, -0.18574451f},
    {2.5414877f, -0.1775261f},
    {2.448959f, -0.16773207f},
    {3.5960634f, 0.116329454f},
    {3.2811058f, 0.10022301f},
    {3.0043368f, 0.09196387f},
    {2.6736908f, 0.08378302f},
    {2.3900928f, 0.07352315f},
    {2.1969695f, 0.065409526f},
    {2.0218637f, 0.060451776f},
    {1.8302581f, 0.05557643f},
    {1.664946f, 0.04984608f},
    {1.324021f, -0.061155688f},
    {1.2338281f, -0.04404242f},
    {1.1290443f, -0.032316945f},
    {1.1290443f, -0.032316945f},
    {-9.852644f, -0.9461501f},
    {11.317714f, -0.31776413f},
    {15.627179f, -0.037113816f},
    {10.133429f, -0.15387772f},
    {7.0734115f, -0.2322754f},
    {5.350204f, -0.28212222f},
    {4.430327f, -0.31132188f},
    {3.9873326f, -0.32561848f},
    {3.8191917f, -0.3291811f},
    {3.7987819f, -0.325091f},
    {3.8449986f, -0.31569016f},
    {3.9059415f, -0.30281588f},
    {5.9015803f, -0.14413868f},
    {6.2420173f, -0.07340424f},
    {6.2924743f, -0.01326896f},
    {6.089511f, 0.03751856f},
    {5.6508946f, 0.07781465f},
    {5.048922f, 0.10717797f},
    {4.3794303f, 0.12713924f},
    {3.7028143f, 0.13953677f},
    {3.054284f, 0.14646126f},
    {2.4047399f, -0.16470343f},
    {2.221648f, -0.14280826f},
    {1.9535441f, -0.12527047f},
    {1.7170742f, -0.114411846f},
    {1.5791874f, -0.10457231f},
    {1.4608198f, -0.09349118f},
    {1.3138874f, -0.0841476f},
    {1.1842071f, -0.07764007f},
    {1.0985332f, -0.071613856f},
    {1.6857659f, 0.049895953f},
    {1.2033837f, 0.057541214f},
    {0.7367569f, 0.059023138f},
    {0.7367569f, 0.059023138f},
    {-63.908497f, -2.1009142f},
    {-18.976639f, -1.1392865f},
    {-1.8490263f, -0.6431224f},
    {5.110296f, -0.36008158f},
    {7.909052f, -0.18583684f},
    {8.8693695f, -0.07182444f},
    {8.735655f, -0.0020745222f},
    {8.322191f, 0.04806911f},
    {7.783767f, 0.0855732f},
    {7.1881366f, 0.11447151f},
    {6.5630565f, 0.1371161f},
    {5.8708973f, 0.15088496f},
    {6.790253f, 0.0018200807f},
    {6.488776f, 0.05946337f},
    {5.9720926f, 0.1062262f},
    {5.2538166f, 0.14247301f},
    {4.3679323f, 0.16722979f},
    {3.3803058f, 0.18000613f},
    {2.3710818f, 0.18164413f},
    {1.4098015f, 0.17360704f},
    {0.5464836f, 0.15837318f},
    {3.9727356f, -0.030111026f},
    {3.7468307f, 0.0048110588f},
    {3.3813386f, 0.03465976f},
    {2.907688f, 0.055208374f},
    {2.442639f, 0.06764109f},
    {2.0265756f, 0.0763798f},
    {1.6176496f, 0.082942836f},
    {1.1964084f, 0.08578024f},
    {0.7985988f, 0.08430929f},
    {0.9395489f, -0.07856828f},
    {0.89135f, -0.061745144f},
    {0.83526033f, -0.049978185f},
    {0.83526033f, -0.049978185f},
    {-9.852644f, -0.9461501f},
    {-12.402011f, -0.97279215f},
    {-11.678813f, -0.95687246f},
    {-9.917433f, -0.91538286f},
    {-7.968791f, -0.86264426f},
    {-6.1423054f, -0.8056963f},
    {-4.541984f, -0.748177f},
    {-3.1913347f, -0.69205314f},
    {-2.082533f, -0.6384448f},
    {-1.1962979f, -0.5880357f},
    {-0.50978315f, -0.5412796f},
    {0.0006069261f, -0.49850005f},
    {6.294896f, -0.10250406f},
    {6.056175f, -0.10618217f},
    {5.812374f, -0.099057436f},
    {5.4623003f, -0.089577556f},
    {5.0220017f, -0.08298495f},
    {4.5685616f, -0.080763385f},
    {4.1778803f, -0.08140849f},
    {3.8837607f, -0.08228115f},
    {3.6732514f, -0.08136916f},
    {3.6069257f, -0.07989992f},
    {3.2864144f, -0.07192971f},
    {2.9254014f, -0.06288348f},
    {2.5739539f, -0.058666665f},
    {2.3296456f, -0.055759367f},
    {2.143364f, -0.050591055f},
    {1.9427214f, -0.045331933f},
    {1.7510395f, -0.042270128f},
    {1.6083347f, -0.039856624f},
    {1.7237681f, -0.028841756f},
    {1.5476234f, -0.012083174f},
    {1.3478181f, -0.000956773f},
    {1.3478181f, -0.000956773f},
    {-9.852644f, -0.9461501f},
    {11.317714f, -0.31776413f},
    {15.627179f, -0.037113816f},
    {15.077405f, 0.09609934f},
    {11.251614f, -8.259406e-5f},
    {8.8693695f, -0.07182444f},
    {7.3491573f, -0.12367274f},
    {6.411287f, -0.15934937f},
    {5.855502f, -0.1822122f},
    {5.541867f, -0.19507894f},
    {5.372882f, -0.20028101f},
    {5.2805624f, -0.19976482f},
    {0.0006150148f, -0.50514376f},
    {4.0084534f, -0.27593505f},
    {5.812374f, -0.099057436f},
    {6.1000013f, 0.033269417f},
    {5.341037f, 0.12254049f},
    {3.955257f, 0.1704248f},
    {2.3264847f, 0.18193422f},
    {0.7610623f, 0.16519785f},
    {-0.5374716f, 0.12954314f},
    {2.582197f, 0.15577883f},
    {2.3580372f, 0.13821632f},
    {2.190696f, 0.12756096f},
    {1.9601712f, 0.118142664f},
    {1.7389601f, 0.1064224f},
    {1.5960667f, 0.09582701f},
    {1.4801904f, 0.08852418f},
    {1.3420982f, 0.08207959f},
    {1.2131978f, 0.07480586f},
    {1.2255828f, 0.075569525f},
    {1.0562419f, 0.06403679f},
    {0.8840711f, 0.054758515f},
    {0.8840711f, 0.054758515f},
    {-63.908497f, -2.1009142f},
    {-24.355879f, -1.2755091f},
    {-7.210728f, -0.8142588f},
    {0.6998156f, -0.5355356f},
    {4.119657f, -0.36569592f},
    {5.990052f, -0.24388626f},
    {6.818461f, -0.15779077f},
    {7.1076427f, -0.094958045f},
    {7.2445083f, -0.042337503f},
    {7.1203065f, -0.0026177324f},
    {6.9362545f, 0.031231506f},
    {6.7395163f, 0.06262331f},
    {-2.4107165f, -0.5865939f},
    {-1.4760474f, -0.49182296f},
    {-1.1039302f, -0.4240601f},
    {2.2619412f, -0.28226244f},
    {4.2647123f, -0.14449506f},
    {5.0354185f, -0.02408201f},
    {4.8136206f, 0.06884027f},
    {3.9083161f, 0.12960231f},
    {2.6296794f, 0.15864336f},
    {1.5873615f, -0.20066103f},
    {1.5017395f, -0.17218089f},
    {1.3080208f, -0.15090662f},
    {1.1529604f, -0.13698474f},
    {1.0837638f, -0.12393605f},
    {1.0112038f, -0.110316165f},
    {0.90353507f, -0.0993243f},
    {0.8157803f, -0.09135232f},
    {0.7662556f, -0.083763644f},
    {1.8764274f, 0.0062811207f},
    {1.5821527f, 0.02105527f},
    {1.2617254f, 0.029825458f},
    {1.2617254f, 0.029825458f},
    {-63.908497f, -2.1009142f},
    {-12.402011f, -0.97279215f},
    {4.704165f, -0.43395564f},
    {10.133429f, -0.15387772f},
    {11.251614f, -8.259406e-5f},
    {10.735192f, 0.087080434f},
    {9.629814f, 0.13685694f},
    {8.3595705f, 0.16453211f},
    {7.0963264f, 0.17848949f},
    {5.9058013f, 0.18349588f},
    {4.8088512f, 0.18233599f},
    {3.8082888f, 0.17667617f},
    {-1.3055229f, -0.5492626f},
    {-0.35393503f, -0.45908478f},
    {0.06507242f, -0.39357242f},
    {0.20873643f, -0.34774223f},
    {0.26509273f, -0.31593317f},
    {0.34497336f, -0.2922105f},
    {0.48045805f, -0.27169496f},
    {0.6443553f, -0.25124696f},
    {0.793433f, -0.23034607f},
    {3.9272814f, 0.08591191f},
    {3.57842f, 0.07244071f},
    {3.2562397f, 0.06651249f},
    {2.8900175f, 0.059849944f},
    {2.5890176f, 0.051255327f},
    {2.3797784f, 0.045142908f},
    {2.1830559f, 0.04186146f},
    {1.9742272f, 0.038210116f},
    {1.799297f, 0.0337168f},
    {0.33687577f, -0.094537385f},
    {0.32249466f, -0.077703714f},
    {0.316617f, -0.065669626f},
    {0.316617f, -0.065669626f},
    {-9.852644f, -0.9461501f},
    {11.317714f, -0.31776413f},
    {4.704165f, -0.43395564f},
    {1.7615404f, -0.49755082f},
    {0.5751524f, -0.5258005f},
    {0.27495724f, -0.5318703f},
    {0.4109991f, -0.5238556f},
    {0.7427266f, -0.5069095f},
    {1.1381996f, -0.48444209f},
    {1.5240626f, -0.45880955f},
    {1.8599026f, -0.4317156f},
    {2.124807f, -0.40444553f},
    {6.4846487f, 0.1218059f},
    {6.3032413f, 0.098491706f},
    {6.1780095f, 0.08781096f},
    {5.9741144f, 0.08425915f},
    {5.645684f, 0.0819096f},
    {5.232277f, 0.07697861f},
    {4.8136206f, 0.06884027f},
    {4.4560604f, 0.059224032f},
    {4.1834054f, 0.050500706f},
    {4.1029873f, 0.05057055f},
    {3.5141358f, 0.0784477f},
    {2.85761f, 0.10030336f},
    {2.1214983f, 0.11218047f},
    {1.4098085f, 0.11388587f},
    {0.7928155f, 0.10940287f},
    {0.25852305f, 0.1009795f},
    {-0.2122413f, 0.08943863f},
    {-0.6079261f, 0.07457221f},
    {0.59425056f, 0.08805929f},
    {0.51431257f, 0.07497706f},
    {0.42197603f, 0.06484121f},
    {0.42197603f, 0.06484121f},
    {-9.852644f, -0.9461501f},
    {11.317714f, -0.31776413f},
    {15.627179f, -0.037113816f},
    {15.077405f, 0.09609934f},
    {13.207906f, 0.16023542f},
    {10.735192f, 0.087080434f},
    {9.082279f, 0.028325032f},
    {7.9432693f, -0.017688466f},
    {7.188263f, -0.052017827f},
    {6.7043905f, -0.0762622f},
    {6.4019656f, -0.09210404f},
    {6.212105f, -0.101155914f},
    {2.153125f, -0.40983573f},
    {2.448325f, -0.35786077f},
    {2.4513035f, -0.31455812f},
    {2.2619412f, -0.28226244f},
    {2.0089252f, -0.26006767f},
    {1.7979859f, -0.24459258f},
    {1.6760195f, -0.23177317f},
    {1.6304042f, -0.2186839f},
    {1.6165504f, -0.20435087f},
    {3.0855775f, -0.12378988f},
    {2.8234658f, -0.10885633f},
    {2.4991386f, -0.095471494f},
    {2.1965327f, -0.08790556f},
    {1.9996183f, -0.08150282f},
    {1.8429323f, -0.073285684f},
    {1.6646786f, -0.06588531f},
    {1.4999552f, -0.061041232f},
    {1.3828483f, -0.05676707f},
    {1.7681158f, 0.04000958f},
    {1.3356147f, 0.050074544f},
    {0.90182984f, 0.053947017f},
    {0.90182984f, 0.053947017f},
};
ptc_status masses_refuse_init(masses_refuse *self, const masses_refuse_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->last = 20U;
        self->u1 = 0.0f;
        self->u2 = 0.0f;
        self->seen = 0U;
        self->x1_hat = 0.0f;
        self->x1_next = 0.0f;
        self->x2_hat = 0.0f;
        self->x2_next = 0.0f;
        self->d_hat = 0.0f;
        self->d_next = 0.0f;
        status = PTC_OK;
    }
    return status;
}

ptc_status masses_refuse_arm(masses_refuse *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        self->last = 20U;
        const float size = fabsf(self->x1_next) + fabsf(self->x2_next) + fabsf(self->d_next);
        if (!(size <= 1e18f)) {
            self->seen = 0U;
            self->x1_hat = 0.0f;
            self->x1_next = 0.0f;
            self->x2_hat = 0.0f;
            self->x2_next = 0.0f;
            self->d_hat = 0.0f;
            self->d_next = 0.0f;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status masses_refuse_step(masses_refuse *self, uint32_t k, const float y[1], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            float x1;
            float x2;
            float d;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0f;
                d = 0.0f;
            } else {
                x1 = self->x1_next + (MASSES_REFUSE_GAMMA1 * self->u2);
                x2 = self->x2_next + (MASSES_REFUSE_GAMMA2 * self->u2);
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const float miss1 = y[0] - x1;
            const float off1 = miss1;
            const float l1 = 3.739163f;
            const float l2 = 356.91812f;
            const float l3 = 456.6237f;
            const float s1 = (MASSES_REFUSE_PHI1_1 * x1) + (MASSES_REFUSE_PHI1_2 * x2);
            const float x1_on = s1 + (MASSES_REFUSE_PHI1_3 * d) + (l1 * off1);
            const float s2 = (MASSES_REFUSE_PHI2_1 * x1) + (MASSES_REFUSE_PHI2_2 * x2);
            const float x2_on = s2 + (MASSES_REFUSE_PHI2_3 * d) + (l2 * off1);
            const float d_on = d + (l3 * off1);
            const uint32_t left = (elapsed < self->last) ? (self->last - elapsed) : 0U;
            const uint32_t planned = (1U < left) ? (left - 1U) : 0U;
            uint32_t to_go;
            if (planned > 4U) {
                to_go = planned;
            } else {
                to_go = 4U;
            }

            /* Its place between the nodes of the table. */
            uint32_t row;
            float part;
            if (to_go < 64U) {
                row = to_go - 2U;
                part = 0.0f;
            } else {
                row = (to_go / 2U) + 30U;
                part = (0.5f * ((float)to_go)) - ((float)(to_go / 2U));
            }

            /* The state from which this input acts. */
            const float s3 = (0.98019874f * x1) + (0.0098347915f * x2);
            const float p1 = s3 + (0.0019801282f * (self->u1 + d));
            const float s4 = ((-3.9339166f) * x1) + (0.96052915f * x2);
            const float p2 = s4 + (0.39339164f * (self->u1 + d));

            /* The law of least energy. */
            const uint32_t above = row + 1U;
            float v;
            const float s5 = part * (masses_refuse_gains[above][0] - masses_refuse_gains[row][0]);
            const float s6 = part * (masses_refuse_gains[above][1] - masses_refuse_gains[row][1]);
            const float s7 = (masses_refuse_gains[row][0] + s5) * p1;
            v = (s7 + ((masses_refuse_gains[row][1] + s6) * p2)) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F32(v)
                && PTC_FINITE_F32(x1_on)
                && PTC_FINITE_F32(x2_on)
                && PTC_FINITE_F32(d_on)) {
                float u_now;
                if (v > MASSES_REFUSE_U_MAX) {
                    u_now = MASSES_REFUSE_U_MAX;
                } else if (v < -MASSES_REFUSE_U_MAX) {
                    u_now = -MASSES_REFUSE_U_MAX;
                } else {
                    u_now = v;
                }
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->d_hat = d;
                self->d_next = d_on;
                self->seen = 1U;
                *u = u_now;
                if ((v > MASSES_REFUSE_U_MAX) || (v < -MASSES_REFUSE_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (((float)left) - 1.0f <= MASSES_REFUSE_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status masses_refuse_arm_for(masses_refuse *self, uint32_t k, uint32_t samples)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if ((samples > 2U) && (samples < 81U)) {
            const float x1 = self->x1_next + (MASSES_REFUSE_GAMMA1 * self->u2);
            const float x2 = self->x2_next + (MASSES_REFUSE_GAMMA2 * self->u2);
            const float d = self->d_next;

            /* The state from which this input acts. */
            const float s1 = (0.98019874f * x1) + (0.0098347915f * x2);
            const float q1 = s1 + (0.0019801282f * (self->u1 + d));
            const float s2 = ((-3.9339166f) * x1) + (0.96052915f * x2);
            const float q2 = s2 + (0.39339164f * (self->u1 + d));
            const float least = (0.8492245f * (-MASSES_REFUSE_U_MAX)) + d;
            const float most = (0.8492245f * MASSES_REFUSE_U_MAX) + d;
            const float within = (-least < most) ? -least : most;
            const uint32_t tried = (1U < samples) ? (samples - 1U) : 0U;
            status = PTC_E_SOON;
            if ((tried > 4U) && (tried < 81U)) {
                uint32_t fits = 0U;

                /* Its place between the nodes of the table. */
                uint32_t node;
                float beyond;
                if (tried < 16U) {
                    node = tried - 5U;
                    beyond = 0.0f;
                } else if (tried < 32U) {
                    node = (tried / 2U) + 4U;
                    beyond = (0.5f * ((float)tried)) - ((float)(tried / 2U));
                } else if (tried < 64U) {
                    node = (tried / 4U) + 13U;
                    beyond = (0.25f * ((float)tried)) - ((float)(tried / 4U));
                } else {
                    node = (tried / 8U) + 22U;
                    beyond = (0.125f * ((float)tried)) - ((float)(tried / 8U));
                }
                uint32_t bounded = 0U;
                uint32_t at;
                at = node;
                for (uint32_t bound = 0U; bound < 11U; bound++) {
                    const uint32_t next = at + 1U;
                    if (fabsf(((1.0f - beyond) * ((masses_refuse_bounds_u[at][0] * q1) + (masses_refuse_bounds_u[at][1] * q2))) + (beyond * ((masses_refuse_bounds_u[next][0] * q1) + (masses_refuse_bounds_u[next][1] * q2)))) <= within) {
                        bounded = bounded + 1U;
                        at = at + 34U;
                    } else {
                        break;
                    }
                }
                if (bounded == 11U) {
                    fits = 1U;
                }
                if (fits == 1U) {
                    self->start = k;
                    self->last = samples;
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status masses_refuse_soonest(const masses_refuse *self, uint32_t *samples)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (samples != NULL)) {
        const float x1 = self->x1_next + (MASSES_REFUSE_GAMMA1 * self->u2);
        const float x2 = self->x2_next + (MASSES_REFUSE_GAMMA2 * self->u2);
        const float d = self->d_next;

        /* The state from which this input acts. */
        const float s1 = (0.98019874f * x1) + (0.0098347915f * x2);
        const float q1 = s1 + (0.0019801282f * (self->u1 + d));
        const float s2 = ((-3.9339166f) * x1) + (0.96052915f * x2);
        const float q2 = s2 + (0.39339164f * (self->u1 + d));
        uint32_t low = 4U;
        uint32_t top = 81U;
        uint32_t kept = 0U;
        uint32_t tried = 5U;
        for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const float least = (0.8492245f * (-MASSES_REFUSE_U_MAX)) + d;
            const float most = (0.8492245f * MASSES_REFUSE_U_MAX) + d;
            const float within = (-least < most) ? -least : most;
            uint32_t fits = 0U;

            /* Its place between the nodes of the table. */
            uint32_t node;
            float beyond;
            if (tried < 16U) {
                node = tried - 5U;
                beyond = 0.0f;
            } else if (tried < 32U) {
                node = (tried / 2U) + 4U;
                beyond = (0.5f * ((float)tried)) - ((float)(tried / 2U));
            } else if (tried < 64U) {
                node = (tried / 4U) + 13U;
                beyond = (0.25f * ((float)tried)) - ((float)(tried / 4U));
            } else {
                node = (tried / 8U) + 22U;
                beyond = (0.125f * ((float)tried)) - ((float)(tried / 8U));
            }
            uint32_t bounded = 0U;
            uint32_t at;
            at = node;
            for (uint32_t bound = 0U; bound < 11U; bound++) {
                const uint32_t next = at + 1U;
                if (fabsf(((1.0f - beyond) * ((masses_refuse_bounds_u[at][0] * q1) + (masses_refuse_bounds_u[at][1] * q2))) + (beyond * ((masses_refuse_bounds_u[next][0] * q1) + (masses_refuse_bounds_u[next][1] * q2)))) <= within) {
                    bounded = bounded + 1U;
                    at = at + 34U;
                } else {
                    break;
                }
            }
            if (bounded == 11U) {
                fits = 1U;
            }
            if (fits == 1U) {
                kept = tried;
                top = tried;
            } else {
                low = tried;
            }
            const uint32_t gap = (low < top) ? (top - low) : 0U;
            if (gap < 2U) {
                break;
            }
            const uint32_t half = gap / 2U;
            if (low < half) {
                tried = low + low;
            } else {
                tried = low + half;
            }
        }
        if (PTC_FINITE_F32(q1) && PTC_FINITE_F32(q2)) {
            if (kept > 0U) {
                *samples = kept + 1U;
                status = PTC_OK;
            } else {
                status = PTC_E_SOON;
            }
        } else {
            status = PTC_E_RANGE;
        }
    }
    return status;
}

ptc_status masses_refuse_deadline(const masses_refuse *self, uint32_t *k)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (k != NULL)) {
        *k = self->start - (0U - self->last);
        status = PTC_OK;
    }
    return status;
}

ptc_status masses_refuse_assume(masses_refuse *self, const float xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        const float n1 = xhat[0] - (MASSES_REFUSE_GAMMA1 * self->u2);
        const float n2 = xhat[1] - (MASSES_REFUSE_GAMMA2 * self->u2);
        if (PTC_FINITE_F32(n1) && PTC_FINITE_F32(n2)) {
            self->x1_next = n1;
            self->x1_hat = xhat[0];
            self->x2_next = n2;
            self->x2_hat = xhat[1];
            self->seen = 1U;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status masses_refuse_assume_disturbance(masses_refuse *self, float d)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        if (PTC_FINITE_F32(d)) {
            self->d_hat = d;
            self->d_next = d;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status masses_refuse_applied(masses_refuse *self, float u)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        if (PTC_FINITE_F32(u)) {
            self->u1 = u;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status masses_refuse_estimate(const masses_refuse *self, float xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 2U; i++) {
            xhat[i] = 0.0f;
        }
    }
    return status;
}

ptc_status masses_refuse_disturbance(const masses_refuse *self, float *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
