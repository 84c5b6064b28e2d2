/* Self-test of the prescribed-time controller stage23: see stage23_selftest.h. DO NOT EDIT. */
#include "stage23_selftest.h"
#include "stage23.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage23_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    double r[4]; /* the reference and its derivatives */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
} stage23_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage23_selftest_session {
    stage23_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage23_selftest_session;

static const stage23_selftest_session stage23_selftest_sessions[4] = {
    {.params = {.u_max = (double)INFINITY}, .first = 0U, .count = 66U},
    {.params = {.u_max = (double)INFINITY}, .first = 66U, .count = 4U},
    {.params = {.u_max = (double)INFINITY}, .first = 70U, .count = 1U},
    {.params = {.u_max = 1.0}, .first = 71U, .count = 2U},
};

static const stage23_selftest_call stage23_selftest_calls[73] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .r = {0.25, -0.25, -0.75, -1.25}, .status = PTC_OK, .u = -0.1771457068759387, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7202999999999999}, .r = {0.24009999999999998, -0.24009999999999998, -0.7202999999999999, -1.2005}, .status = PTC_OK, .u = -0.31028941179333525, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6912}, .r = {0.2304, -0.2304, -0.6912, -1.152}, .status = PTC_OK, .u = -0.4727972264549133, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471519387961455, -0.08521489387323455, 0.19389186447646276}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6627}, .r = {0.22089999999999999, -0.22089999999999999, -0.6627, -1.1044999999999998}, .status = PTC_OK, .u = -0.6604376099025765, .xhat = {0.7398082438425195, -0.20747252596916366, 0.38487645004184995}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.43320000000000003}, .r = {0.1444, -0.1444, -0.43320000000000003, -0.722}, .status = PTC_OK, .u = -0.9787812322956818, .xhat = {0.7270068174066369, -0.338705773465889, 0.4020316551680079}},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.25229999999999997}, .r = {0.0841, -0.0841, -0.25229999999999997, -0.4205}, .status = PTC_OK, .u = -1.2905113289561407, .xhat = {0.5714919575980101, -0.6855247596929973, -2.684466517342388}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2187}, .r = {0.0729, -0.0729, -0.2187, -0.36450000000000005}, .status = PTC_OK, .u = 30.629723980705837, .xhat = {-0.2649191567178655, -58.4081827098298, -116.90641737500354}},
    {.is_armed = 0U, .start = 0U, .k = 24U, .y = {0.20280000000000004}, .r = {0.06760000000000001, -0.06760000000000001, -0.20280000000000004, -0.338}, .status = PTC_OK, .u = 3.0161489553815652, .xhat = {0.3592541943914363, 20.108158175170505, 102.59018965108187}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = -2.0470964680509782, .xhat = {0.2013450548727727, 1.0450559276239444, 29.79819480904887}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.1728}, .r = {0.0576, -0.0576, -0.1728, -0.288}, .status = PTC_OK, .u = -4.128392713766376, .xhat = {0.188908536954879, 1.0001932062985526, 15.441101272756509}},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.05070000000000001}, .r = {0.016900000000000002, -0.016900000000000002, -0.05070000000000001, -0.0845}, .status = PTC_OK, .u = -6.440752601486161, .xhat = {0.16331010966532844, -0.7901025022174561, 1.9488621228865421}},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.0048000000000000004}, .r = {0.0016, -0.0016, -0.0048000000000000004, -0.008}, .status = PTC_OK, .u = 1126.461539066335, .xhat = {-0.13655510805009144, -21.082625029361683, -42.45738275467496}},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.0012000000000000001}, .r = {0.0004, -0.0004, -0.0012000000000000001, -0.002}, .status = PTC_OK, .u = -3033.408036253817, .xhat = {0.0015742129690535073, 1.0040335993050715, 20.257844903646962}},
    {.is_armed = 0U, .start = 0U, .k = 49U, .y = {0.00030000000000000003}, .r = {0.0001, -0.0001, -0.00030000000000000003, -0.0005}, .status = PTC_OK, .u = 2598.74277003769, .xhat = {0.18519046710943657, 50.338216813914876, 898.2851631586866}},
    {.is_armed = 0U, .start = 0U, .k = 50U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 1365.9109693907767, .xhat = {0.1405044292230051, -42.00726558500311, -1909.2475676995737}},
    {.is_armed = 0U, .start = 0U, .k = 51U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -1194.0876639977523, .xhat = {-1.0696330790693236, -105.9031948541734, 837.9762245118761}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -13239.028655105469, .xhat = {1.2097114933686313, 211.41414904754333, 1967.612358834806}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 30427.598590129026, .xhat = {0.8329215143289254, 94.54667440937295, -184.69312649180267}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .r = {0.25, -0.25, -0.75, -1.25}, .status = PTC_OK, .u = 33410.88877073154, .xhat = {-2.4174073282842437, -633.0167925914229, -10827.062234803232}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7202999999999999}, .r = {0.24009999999999998, -0.24009999999999998, -0.7202999999999999, -1.2005}, .status = PTC_OK, .u = 33767.23814323676, .xhat = {-8.58961861344142, -171.94954106288992, 17345.441756341283}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6912}, .r = {0.2304, -0.2304, -0.6912, -1.152}, .status = PTC_OK, .u = 32019.68735032329, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {2.872616902795424, 2629.9861159734764, 36689.91812753129}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6627}, .r = {0.22089999999999999, -0.22089999999999999, -0.6627, -1.1044999999999998}, .status = PTC_OK, .u = 28627.02688829914, .xhat = {49.33286740783184, 6901.140860009771, 48769.867460579684}},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.43320000000000003}, .r = {0.1444, -0.1444, -0.43320000000000003, -0.722}, .status = PTC_OK, .u = 21247.15767870889, .xhat = {136.56864506752484, 11911.455024718012, 54965.85941189812}},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.25229999999999997}, .r = {0.0841, -0.0841, -0.25229999999999997, -0.4205}, .status = PTC_OK, .u = 7019.875838403351, .xhat = {212.07986697552872, 17135.03349969471, 54514.40164749558}},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.2187}, .r = {0.0729, -0.0729, -0.2187, -0.36450000000000005}, .status = PTC_OK, .u = 13459.709020559596, .xhat = {-140.89306075141195, -16027.295181082303, -26528.28199371728}},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.20280000000000004}, .r = {0.06760000000000001, -0.06760000000000001, -0.20280000000000004, -0.338}, .status = PTC_OK, .u = 2429.525674620162, .xhat = {55.63806880838538, 7778.81994610226, 40330.645767946786}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = -576.3720268288425, .xhat = {8.26745254439326, 1439.4095094151712, 15010.238613089034}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.1728}, .r = {0.0576, -0.0576, -0.1728, -0.288}, .status = PTC_OK, .u = -1929.1621269873042, .xhat = {8.34906240735414, 1246.4750034658482, 8083.153582532387}},
    {.is_armed = 0U, .start = 0U, .k = 34U, .y = {0.05070000000000001}, .r = {0.016900000000000002, -0.016900000000000002, -0.05070000000000001, -0.0845}, .status = PTC_OK, .u = -2035.863989309324, .xhat = {2.877519118566607, 368.65837509827867, 1490.4346989096175}},
    {.is_armed = 0U, .start = 0U, .k = 43U, .y = {0.0048000000000000004}, .r = {0.0016, -0.0016, -0.0048000000000000004, -0.008}, .status = PTC_OK, .u = 15686.694728423636, .xhat = {-0.44246931458523464, -109.65302601460492, -1634.6925397781852}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.0012000000000000001}, .r = {0.0004, -0.0004, -0.0012000000000000001, -0.002}, .status = PTC_OK, .u = -21393.320991463406, .xhat = {-1.3666120786285827, -242.26965797346963, -2429.6968354451706}},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.00030000000000000003}, .r = {0.0001, -0.0001, -0.00030000000000000003, -0.0005}, .status = PTC_OK, .u = -3807.8633502965677, .xhat = {1.0530085426479445, 482.5738693180005, 11362.981204064332}},
    {.is_armed = 0U, .start = 0U, .k = 47U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 30178.42218012896, .xhat = {4.793399644488469, 268.5549659237506, -10331.07719920962}},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 31316.1021985455, .xhat = {-9.921682532527523, -1567.5268269077512, -10978.247250899343}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -178614.1143795862, .xhat = {0.018727972169930496, 658.3864473709934, 20674.222348830637}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 173542.3918054441, .xhat = {19.91196022707578, 3595.1447758216814, 37143.358603386805}},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {-0.4184869858837193}, .r = {0.3958962442832529, -0.3718227983378573, -0.5737328186357484, 0.29463498691783807}, .status = PTC_OK, .u = 0.7606834762984129, .xhat = {-0.4184869858837193, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {-0.8292409381343521}, .r = {-0.5250119877612838, -0.45400181013931795, -0.36527886689690436, 0.49147095196367724}, .status = PTC_OK, .u = 0.4182899474298861, .xhat = {-0.4184869858837193, 0.0, 0.0}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967290U, .y = {5.398103476350059e153}, .r = {6.429154741389957e153, 1.149171731178575e154, -8.595195463877276e153, 1.059181016980802e154}, .status = PTC_OK, .u = 2.2115143935760808e153, .xhat = {-0.9561754837937694, -2.6810768748433245, 167.83434732002863}},
    {.is_armed = 1U, .start = 4294967290U, .k = 18U, .y = {-9.811433711115302e153}, .r = {1.2346630850318382e154, 4.13770893468814e153, 6.79560003780808e153, -7.950435990783086e153}, .status = PTC_OK, .u = 6.98847159795749e154, .xhat = {-9.811433711115302e153, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {4.762510369200913e307}, .r = {1.222337168385354e308, 1.3380350065951717e308, 1.4854275734348078e308, 1.3623909902899295e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.643431834156915}, .r = {-0.9983017033611402, -0.9102730401086383, -0.6995953855917312, 0.29242747596827645}, .status = PTC_SATURATED, .u = -1.0, .xhat = {0.643431834156915, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 34U, .y = {0.8906576738018435}, .r = {0.870173419820952, 0.906667175486672, -0.30305505350937567, 0.6295414268117009}, .status = PTC_SATURATED, .u = 1.0, .xhat = {0.643431834156915, 0.0, 0.0}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage23_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage23_selftest_check(stage23 *self, const stage23_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};

    if (call->is_armed != 0U) {
        if (stage23_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage23_step(self, call->k, call->y, call->r, &u) != call->status) {
        failures++;
    }
    failures += stage23_selftest_differs(u, call->u);
    if (stage23_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage23_selftest_differs(xhat[i], call->xhat[i]);
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage23_selftest_calls_of(stage23 *self, const stage23_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage23_selftest_check(self, &stage23_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage23_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage23_selftest_session *session = &stage23_selftest_sessions[i];
        stage23 self;

        if (stage23_init(&self, &session->params) == PTC_OK) {
            failures += stage23_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage23_selftest_refuse(void)
{
    static const stage23_params refused[5] = {
        {.u_max = (double)NAN},
        {.u_max = -(double)INFINITY},
        {.u_max = 0.0},
        {.u_max = -1.0},
        {.u_max = -1.7976931348623157e308},
    };
    const stage23_selftest_session *session = &stage23_selftest_sessions[0];
    uint32_t failures = 0U;
    stage23 self;

    if (stage23_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 5U; i++) {
        if (stage23_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage23_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage23_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage23_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage23_selftest_pointers(void)
{
    const stage23_selftest_session *session = &stage23_selftest_sessions[0];
    const stage23_selftest_call *call = &stage23_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    stage23 self;

    if (stage23_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage23_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage23_step(NULL, call->k, call->y, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage23_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage23_step(&self, call->k, NULL, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage23_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage23_step(&self, call->k, call->y, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage23_selftest_differs(u, 0.0);
    if (stage23_step(&self, call->k, call->y, call->r, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage23_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage23_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage23_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage23_selftest(void)
{
    uint32_t failures = stage23_selftest_run();

    failures += stage23_selftest_refuse();
    failures += stage23_selftest_pointers();
    return failures;
}
