/* Self-test of the prescribed-time controller late_stage: see late_stage_selftest.h. DO NOT EDIT. */
#include "late_stage_selftest.h"
#include "late_stage.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct late_stage_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 soonest, 3 deadline, 4 move, 5 assume, 6 assume_disturbance, 7 applied */
    uint32_t samples;
    double given[2];
    ptc_status told; /* its status */
    uint32_t found; /* its result */
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} late_stage_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct late_stage_selftest_session {
    late_stage_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} late_stage_selftest_session;

static const late_stage_selftest_session late_stage_selftest_sessions[5] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 5U},
    {.params = {.none = (char)0}, .first = 47U, .count = 1U},
    {.params = {.none = (char)0}, .first = 48U, .count = 16U},
    {.params = {.none = (char)0}, .first = 64U, .count = 18U},
};

static const late_stage_selftest_call late_stage_selftest_calls[82] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_LATE, .u = -3.625406851213303, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7481261718750001}, .status = PTC_OK, .u = -3.6033299363236715, .xhat = {0.7498887115858045, -0.0017033497552366567}, .d = -0.008690559975697227},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7462546875}, .status = PTC_OK, .u = -3.5651238948113395, .xhat = {0.7496690695144652, -0.007460260690827082}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496690695144652, -0.007460260690827082}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496690695144652, -0.007460260690827082}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496690695144652, -0.007460260690827082}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.744385546875}, .status = PTC_OK, .u = -3.51141813606074, .xhat = {0.7493439899338437, -0.014772475425259998}, .d = -0.05100954522904584},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.57421875}, .status = PTC_INFEASIBLE, .u = 5.552554726096419, .xhat = {0.7289473298767895, -0.6474466233272298}, .d = -6.548570290334984},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6201350622665925, -12.655631200427385}, .d = -451.0477524440099},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.5416529602669968, -20.240183840541953}, .d = -720.9572280601566},
    {.is_armed = 0U, .start = 0U, .k = 199U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.48597190272133756, -24.622858876084624}, .d = -865.625260782474},
    {.is_armed = 0U, .start = 0U, .k = 200U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.44697044468923963, -26.759581629294793}, .d = -923.53782544995},
    {.is_armed = 0U, .start = 0U, .k = 201U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.42010816020803776, -27.348732978294287}, .d = -922.7029908338831},
    {.is_armed = 0U, .start = 0U, .k = 500U, .y = {0.10546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2892523177024492, -39.410998293131016}, .d = -1346.8189163010734},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.15971742916340714, -50.255333733923514}, .d = -1715.3543297550898},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.06973567769643754, -55.73968036856392}, .d = -1876.2719994391764},
    {.is_armed = 0U, .start = 0U, .k = 799U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.00856413832277278, -57.520067046858955}, .d = -1896.032691241729},
    {.is_armed = 0U, .start = 0U, .k = 800U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03175454261454029, -56.80153657042183}, .d = -1822.7529775158669},
    {.is_armed = 0U, .start = 0U, .k = 801U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.05709860224829605, -54.45502308201294}, .d = -1690.9869723274915},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.0717979674634205, -51.10478206520276}, .d = -1525.2993551042134},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07903051105472352, -47.19343953622152}, .d = -1342.921252670236},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07485971309310668, -47.29575778828944}, .d = -1338.916366461883},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7481261718750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07088654357956363, -47.392860230062794}, .d = -1334.8780579455502},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06709511377759055, -47.48453444763984}, .d = -1330.8050092905758},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709511377759055, -47.48453444763984}, .d = -1330.8050092905758},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709511377759055, -47.48453444763984}, .d = -1330.8050092905758},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709511377759055, -47.48453444763984}, .d = -1330.8050092905758},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.744385546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06347012810737546, -47.57057667229604}, .d = -1326.6959313788705},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.57421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03167346548429974, -45.98303062226627}, .d = -1301.252529272867},
    {.is_armed = 0U, .start = 0U, .k = 193U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10373101796327384, -26.672065927698327}, .d = -554.0500707265759},
    {.is_armed = 0U, .start = 0U, .k = 195U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.20195292914151064, -13.159063466871713}, .d = -40.036397591600576},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.27311007105426477, -3.8248617705382557}, .d = 306.51518122548055},
    {.is_armed = 0U, .start = 0U, .k = 197U, .y = {0.421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.324224110992139, 2.46788322948648}, .d = 531.8633866282366},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.3605273446261423, 6.553342479923883}, .d = 670.1924110486777},
    {.is_armed = 0U, .start = 0U, .k = 497U, .y = {0.10546875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.27314526967947805, -3.4513995747906305}, .d = 283.2465964037284},
    {.is_armed = 0U, .start = 0U, .k = 793U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.1727762851368811, -14.030691853665607}, .d = -115.42463852753559},
    {.is_armed = 0U, .start = 0U, .k = 795U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10163550532010751, -20.444023338398353}, .d = -349.95729503547597},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.05191898220876348, -23.916207153320602}, .d = -469.76762657493015},
    {.is_armed = 0U, .start = 0U, .k = 797U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.017833813596334944, -25.336569341270398}, .d = -510.92258102801077},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.004912503573166615, -25.367097634191765}, .d = -499.5860343207032},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.019496240813352154, -24.48138921665055}, .d = -454.5947093668136},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.02825877343829021, -23.01971339584265}, .d = -389.3821552784516},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.8221707939338208}, .status = PTC_LATE, .u = 3.6210647307787176, .xhat = {-0.8221707939338208, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 77U, .y = {-0.9983109194024815}, .status = PTC_LATE, .u = 5.208508461618929, .xhat = {-0.8389349573387014, -0.41907498269266097}, .d = -3.4922915224388413},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-0.604116101175212}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.754761054223642, 8.967350248361235}, .d = 344.14990782009204},
    {.is_armed = 0U, .start = 0U, .k = 108U, .y = {7.1200186866681e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {8.983084573305414e152, 3.0276238084732956e154}, .d = 3.40182450390258e155},
    {.is_armed = 1U, .start = 4294967290U, .k = 703U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {8.967500654424333e153, 0.004}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 138U, .y = {1.6834135823229552e302}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 700U, .y = {0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 792U, .y = {-0.0}, .status = PTC_HOLD, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 688U, .y = {0.0006173528109680926}, .status = PTC_OK, .u = -2.4463839499718096, .xhat = {0.00022200372020034855, 0.024633289501682514}, .d = 0.9123440556178708},
    {.is_armed = 0U, .start = 0U, .k = 750U, .y = {0.0008613322193409756}, .status = PTC_LATE, .u = -5.380262469651502, .xhat = {0.000467879794001143, 0.049756631527883996}, .d = 1.8203111910174843},
    {.is_armed = 0U, .start = 0U, .k = 789U, .y = {-0.0}, .status = PTC_LATE, .u = -4.417001794941974, .xhat = {0.00033135766255772825, 0.028693118406138047}, .d = 1.0556396620381117},
    {.is_armed = 1U, .start = 4294967290U, .k = 747U, .y = {0.00036670820192989163}, .status = PTC_LATE, .u = -4.309859828201003, .xhat = {0.00036152167460355396, 0.026133197083190673}, .d = 1.067608571252737},
    {.is_armed = 1U, .start = 4294967290U, .k = 774U, .y = {-0.000987867785875774}, .status = PTC_LATE, .u = 4.581817973603335, .xhat = {-0.00010770618434818348, -0.030940569981628953}, .d = -0.963533586118626},
    {.is_armed = 1U, .start = 4294967290U, .k = 103U, .y = {-0.0}, .status = PTC_OK, .u = 1.2325277299146884, .xhat = {-0.00012250220606252132, -0.03384593713888035}, .d = -0.9565991718880008},
    {.is_armed = 1U, .start = 4294967290U, .k = 764U, .y = {0.0}, .status = PTC_LATE, .u = 3.8985321332696685, .xhat = {-9.935057045044937e-5, -0.025238819830183154}, .d = -0.7273286246946562},
    {.is_armed = 0U, .start = 0U, .k = 740U, .y = {-0.000762049959664616}, .status = PTC_LATE, .u = 5.389181316824363, .xhat = {-0.00035371613709740386, -0.05034435860204481}, .d = -1.6696374460036072},
    {.is_armed = 1U, .start = 4294967290U, .k = 748U, .y = {0.000885364327597553}, .status = PTC_OK, .u = -1.9806567929112426, .xhat = {6.0100083301188264e-5, 0.002561881795623999}, .d = 0.2348185023726186},
    {.is_armed = 1U, .start = 4294967290U, .k = 673U, .y = {-0.000715310439307447}, .status = PTC_OK, .u = 2.3960780393057926, .xhat = {-0.00021590098496564612, -0.024805835608259448}, .d = -0.9176648538007679},
    {.is_armed = 0U, .start = 0U, .k = 745U, .y = {0.0009904176923577039}, .status = PTC_LATE, .u = -4.140863577505169, .xhat = {0.0002013941425097559, 0.022424186528048264}, .d = 0.9031587227714193},
    {.is_armed = 1U, .start = 4294967290U, .k = 701U, .y = {0.0007532588683442364}, .status = PTC_OK, .u = -5.0183958190665106, .xhat = {0.0004149125472433521, 0.04570525617135997}, .d = 1.6839579253119215},
    {.is_armed = 0U, .start = 0U, .k = 793U, .y = {-0.0006584024068272549}, .status = PTC_HOLD, .u = -0.6074672404843036, .xhat = {5.768705829521149e-5, -0.0005505629877327889}, .d = 0.03144377502930684},
    {.is_armed = 1U, .start = 4294967290U, .k = 765U, .y = {-0.00047633469247182237}, .status = PTC_LATE, .u = 4.02457299920929, .xhat = {-0.0001357674355453813, -0.025095157538405067}, .d = -0.7544806640317108},
    {.command = 1U, .samples = 1024U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.03957940037256842}, .status = PTC_OK, .u = -0.3400447933402025, .xhat = {0.03957940037256842, 0.0}, .d = 0.0},
    {.command = 2U, .samples = 1024U, .told = PTC_OK, .found = 302U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.9728666113673947}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.32450217035165474, -40.398092094057645}, .d = -1496.225633113246},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 1031U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.5828280052597419}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.02441103898205621, -3.560139020160257}, .d = -94.90476178601966},
    {.command = 4U, .samples = 1024U, .told = PTC_OK, .given = {-0.0006470851784951246}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.35507933540131353}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.1452057935520052, -16.696144930423223}, .d = -579.2283198998082},
    {.command = 5U, .samples = 1024U, .told = PTC_OK, .given = {0.6166624028512053, 0.3670304664935049}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.03151915608260474}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.40624143233835885, -22.981049823288103}, .d = -1443.972034336164},
    {.command = 6U, .samples = 1024U, .told = PTC_OK, .given = {-0.0}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {0.000929440430266613}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.24577319644516585, -38.23269923652413}, .d = -565.024052342075},
    {.command = 7U, .samples = 1024U, .told = PTC_OK, .given = {-0.00016096713749881708}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 400U, .y = {-0.9440983356923232}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.2067175282956534, -84.55787839895493}, .d = -2266.672069411313},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 400U, .y = {-0.03306843631202501}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.19890650829750395, -75.73600565703508}, .d = -1883.9688263679},
    {.command = 1U, .samples = 40U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {-0.08788054344360532}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.20788268539219643, -69.51092833781685}, .d = -1607.040806486536},
    {.command = 7U, .samples = 200U, .told = PTC_E_INPUT, .given = {(double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.09279846541452788}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.21135387288231533, -63.19137502555856}, .d = -1333.4514046377958},
    {.command = 1U, .samples = 4294967295U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {6.063542673396971e-5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.17607871298558128, -53.10150630449847}, .d = -926.9759852247607},
    {.command = 1U, .samples = 1U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.0004254067623468774}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.14711523231882478, -44.57558577920623}, .d = -588.4610031713503},
    {.command = 3U, .samples = 2147483648U, .told = PTC_OK, .found = 41U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {0.08456181302576178}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.09247307378653948, -33.9332578594258}, .d = -179.91895668142433},
    {.command = 2U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.8294368582460572}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.37925739041409123, -62.09884759546155}, .d = -1218.7946516782688},
    {.command = 5U, .samples = 4294967295U, .told = PTC_E_INPUT, .given = {(double)NAN, -0.22012336710328917}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.2042169967447207}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.35633845388429825, -53.42904041839647}, .d = -867.7451352023207},
    {.command = 6U, .samples = 2147483648U, .told = PTC_E_INPUT, .given = {(double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {1.7976931348623157e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-0.35633845388429825, -53.42904041839647}, .d = -867.7451352023207},
    {.command = 4U, .samples = 1048576U, .told = PTC_E_INPUT, .given = {(double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {72.79929465463223}, .status = PTC_SATURATED, .u = -6.0, .xhat = {25.916460065219756, 2867.157694934349}, .d = 107323.4116095957},
    {.command = 2U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 400U, .y = {-0.09036191990712793}, .status = PTC_SATURATED, .u = -6.0, .xhat = {18.423275023825433, 1785.1686418209995}, .d = 64599.63404713596},
};

/* 1 where a number is not the one that must come. */
static uint32_t late_stage_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of what is called before a call. */
static uint32_t late_stage_selftest_command(late_stage *self, const late_stage_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = late_stage_arm_for(self, call->k, call->samples);
        break;
    case 2U:
        told = late_stage_soonest(self, &found);
        break;
    case 3U:
        told = late_stage_deadline(self, &found);
        break;
    case 4U:
        told = late_stage_move(self, call->given[0]);
        break;
    case 5U:
        told = late_stage_assume(self, &call->given[0]);
        break;
    case 6U:
        told = late_stage_assume_disturbance(self, call->given[0]);
        break;
    case 7U:
        told = late_stage_applied(self, call->given[0]);
        break;
    default:
        break;
    }
    if (told != call->told) {
        failures++;
    }
    if (found != call->found) {
        failures++;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t late_stage_selftest_check(late_stage *self, const late_stage_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (late_stage_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    failures += late_stage_selftest_command(self, call);
    if (late_stage_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += late_stage_selftest_differs(u, call->u);
    if (late_stage_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += late_stage_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (late_stage_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += late_stage_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t late_stage_selftest_calls_of(late_stage *self, const late_stage_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += late_stage_selftest_check(self, &late_stage_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t late_stage_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const late_stage_selftest_session *session = &late_stage_selftest_sessions[i];
        late_stage self;

        if (late_stage_init(&self, &session->params) == PTC_OK) {
            failures += late_stage_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t late_stage_selftest_refuse(void)
{
    const late_stage_selftest_session *session = &late_stage_selftest_sessions[0];
    uint32_t failures = 0U;
    late_stage self;

    if (late_stage_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (late_stage_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += late_stage_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t late_stage_selftest_pointers(void)
{
    const late_stage_selftest_session *session = &late_stage_selftest_sessions[0];
    const late_stage_selftest_call *call = &late_stage_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    late_stage self;

    if (late_stage_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (late_stage_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (late_stage_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += late_stage_selftest_differs(u, 0.0);
    u = 12345.0;
    if (late_stage_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += late_stage_selftest_differs(u, 0.0);
    if (late_stage_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (late_stage_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (late_stage_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (late_stage_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (late_stage_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += late_stage_selftest_calls_of(&self, session);
    return failures;
}

uint32_t late_stage_selftest(void)
{
    uint32_t failures = late_stage_selftest_run();

    failures += late_stage_selftest_refuse();
    failures += late_stage_selftest_pointers();
    return failures;
}
