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
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .r = {0.25, -0.25, -0.75, -1.25}, .status = PTC_OK, .u = -0.154815603081518, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7202999999999999}, .r = {0.24009999999999998, -0.24009999999999998, -0.7202999999999999, -1.2005}, .status = PTC_OK, .u = -0.2636354126428115, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6912}, .r = {0.2304, -0.2304, -0.6912, -1.152}, .status = PTC_OK, .u = -0.40339004376981247, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471552294302725, -0.08426680101498212, 0.21145846954073236}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6627}, .r = {0.22089999999999999, -0.22089999999999999, -0.6627, -1.1044999999999998}, .status = PTC_OK, .u = -0.5727905618462643, .xhat = {0.7398349146938569, -0.20318672454312298, 0.43223535649515}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.43320000000000003}, .r = {0.1444, -0.1444, -0.43320000000000003, -0.722}, .status = PTC_OK, .u = -0.8322417201081952, .xhat = {0.727102709375812, -0.32786347442181885, 0.4854422218955695}},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.25229999999999997}, .r = {0.0841, -0.0841, -0.25229999999999997, -0.4205}, .status = PTC_OK, .u = -0.985685020557628, .xhat = {0.5716943499329844, -0.6646673843027099, -2.56594286447656}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2187}, .r = {0.0729, -0.0729, -0.2187, -0.36450000000000005}, .status = PTC_OK, .u = 23.724277755094406, .xhat = {-0.26496258520081345, -58.408500841398244, -116.79227638260163}},
    {.is_armed = 0U, .start = 0U, .k = 24U, .y = {0.20280000000000004}, .r = {0.06760000000000001, -0.06760000000000001, -0.20280000000000004, -0.338}, .status = PTC_OK, .u = 3.777384007137691, .xhat = {0.35941368117280004, 20.13753695199867, 102.91472421791156}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = 0.12358850615994872, .xhat = {0.20050309121765705, 0.7775987464651275, 24.504756905101893}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.1728}, .r = {0.0576, -0.0576, -0.1728, -0.288}, .status = PTC_OK, .u = -1.6623853122550716, .xhat = {0.1854557117697632, 0.505384971794649, 13.139389545574007}},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.05070000000000001}, .r = {0.016900000000000002, -0.016900000000000002, -0.05070000000000001, -0.0845}, .status = PTC_OK, .u = -3.5498974988340115, .xhat = {0.16323806613704434, -0.7457317400556805, 3.508649110670587}},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.0048000000000000004}, .r = {0.0016, -0.0016, -0.0048000000000000004, -0.008}, .status = PTC_OK, .u = 1096.1419000008907, .xhat = {-0.1349731776332186, -20.79901541157978, -39.54733758096916}},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.0012000000000000001}, .r = {0.0004, -0.0004, -0.0012000000000000001, -0.002}, .status = PTC_OK, .u = -2982.307587650761, .xhat = {0.003533692916439361, 1.3501467387079216, 23.722948082469824}},
    {.is_armed = 0U, .start = 0U, .k = 49U, .y = {0.00030000000000000003}, .r = {0.0001, -0.0001, -0.00030000000000000003, -0.0005}, .status = PTC_OK, .u = 2586.870140611809, .xhat = {0.18251115071928964, 49.311547890502425, 875.8241196906987}},
    {.is_armed = 0U, .start = 0U, .k = 50U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 1314.2172189373514, .xhat = {0.13255927104115806, -42.12817142887205, -1881.6777637110142}},
    {.is_armed = 0U, .start = 0U, .k = 51U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -1233.4959748057536, .xhat = {-1.0482070918167605, -102.93900988818197, 848.1908829877998}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -12891.534041996169, .xhat = {1.201741326220795, 209.0924605977693, 1925.4004934303846}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 29975.56463571099, .xhat = {0.7988100216239202, 88.70928556500597, -238.37133093582042}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .r = {0.25, -0.25, -0.75, -1.25}, .status = PTC_OK, .u = 33546.642691533736, .xhat = {-2.3926476298563837, -622.094544720037, -10573.884702282101}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7202999999999999}, .r = {0.24009999999999998, -0.24009999999999998, -0.7202999999999999, -1.2005}, .status = PTC_OK, .u = 34587.367000732826, .xhat = {-8.417189074979213, -160.60237867158799, 17143.37207098077}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6912}, .r = {0.2304, -0.2304, -0.6912, -1.152}, .status = PTC_OK, .u = 33560.312484196154, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.0757460375779093, 2630.712965327538, 36676.05375771641}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6627}, .r = {0.22089999999999999, -0.22089999999999999, -0.6627, -1.1044999999999998}, .status = PTC_OK, .u = 30871.98156635262, .xhat = {49.63448065560662, 6935.141713330744, 49408.48651685781}},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.43320000000000003}, .r = {0.1444, -0.1444, -0.43320000000000003, -0.722}, .status = PTC_OK, .u = 24554.150513963985, .xhat = {137.6642815235203, 12059.90700579511, 56566.28913161396}},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.25229999999999997}, .r = {0.0841, -0.0841, -0.25229999999999997, -0.4205}, .status = PTC_OK, .u = 12560.621878042119, .xhat = {215.09488306447565, 17501.102256000413, 57238.693336632496}},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.2187}, .r = {0.0729, -0.0729, -0.2187, -0.36450000000000005}, .status = PTC_OK, .u = 16238.534814069137, .xhat = {-140.4166787084724, -15854.5414800726, -23363.802173484015}},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.20280000000000004}, .r = {0.06760000000000001, -0.06760000000000001, -0.20280000000000004, -0.338}, .status = PTC_OK, .u = 6420.741809460015, .xhat = {58.75673073859167, 8346.772542911009, 46432.887287713595}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = 2492.8583910364805, .xhat = {11.943081741260162, 2035.0801979844982, 19765.27702566678}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.1728}, .r = {0.0576, -0.0576, -0.1728, -0.288}, .status = PTC_OK, .u = 33.23193253995459, .xhat = {11.01870374800616, 1715.3349121419162, 12775.536984415012}},
    {.is_armed = 0U, .start = 0U, .k = 34U, .y = {0.05070000000000001}, .r = {0.016900000000000002, -0.016900000000000002, -0.05070000000000001, -0.0845}, .status = PTC_OK, .u = -3477.5108457983483, .xhat = {5.727842189805006, 849.1817128544129, 5782.47140900535}},
    {.is_armed = 0U, .start = 0U, .k = 43U, .y = {0.0048000000000000004}, .r = {0.0016, -0.0016, -0.0048000000000000004, -0.008}, .status = PTC_OK, .u = -8710.806366951241, .xhat = {1.9025960800274433, 271.5530291694164, 1479.077262829856}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.0012000000000000001}, .r = {0.0004, -0.0004, -0.0012000000000000001, -0.002}, .status = PTC_OK, .u = 35669.16821911444, .xhat = {-0.20548383248668078, -105.0447752769378, -2524.7872277159668}},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.00030000000000000003}, .r = {0.0001, -0.0001, -0.00030000000000000003, -0.0005}, .status = PTC_OK, .u = -35800.17325378997, .xhat = {-3.0696676742437212, -634.0835509904734, -8306.348346103417}},
    {.is_armed = 0U, .start = 0U, .k = 47U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -21937.387649809214, .xhat = {0.31917914299978545, 790.1144566824648, 24139.449268320903}},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 48714.40635948255, .xhat = {12.323867579165643, 1092.8506857325938, -13666.13291856374}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 118659.35285468349, .xhat = {-17.821061852221803, -3138.8687609981494, -29975.472518761984}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .r = {0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -384584.48484734003, .xhat = {-8.34646706861673, -172.91318158153172, 26606.092016190883}},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {-0.4184869858837193}, .r = {0.3958962442832529, -0.3718227983378573, -0.5737328186357484, 0.29463498691783807}, .status = PTC_OK, .u = 0.5050646737780521, .xhat = {-0.4184869858837193, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {-0.8292409381343521}, .r = {-0.5250119877612838, -0.45400181013931795, -0.36527886689690436, 0.49147095196367724}, .status = PTC_OK, .u = 0.292900768876468, .xhat = {-0.4184869858837193, 0.0, 0.0}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967290U, .y = {5.398103476350059e153}, .r = {6.429154741389957e153, 1.149171731178575e154, -8.595195463877276e153, 1.059181016980802e154}, .status = PTC_OK, .u = 1.8577068351608915e153, .xhat = {-0.9562131525821821, -2.691929952972105, 167.63325758967108}},
    {.is_armed = 1U, .start = 4294967290U, .k = 18U, .y = {-9.811433711115302e153}, .r = {1.2346630850318382e154, 4.13770893468814e153, 6.79560003780808e153, -7.950435990783086e153}, .status = PTC_OK, .u = 4.471504485126618e154, .xhat = {-9.811433711115302e153, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {4.762510369200913e307}, .r = {1.222337168385354e308, 1.3380350065951717e308, 1.4854275734348078e308, 1.3623909902899295e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.49049771042733203}, .r = {-0.7248895088011285, 0.8932485059640947, 0.5231945213914934, 0.5214452029820315}, .status = PTC_SATURATED, .u = -1.0, .xhat = {0.49049771042733203, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 34U, .y = {0.8906576738018435}, .r = {0.870173419820952, 0.906667175486672, -0.30305505350937567, 0.6295414268117009}, .status = PTC_SATURATED, .u = 1.0, .xhat = {0.49049771042733203, 0.0, 0.0}},
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
