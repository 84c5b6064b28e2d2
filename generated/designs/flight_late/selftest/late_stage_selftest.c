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
    {.params = {.none = (char)0}, .first = 42U, .count = 4U},
    {.params = {.none = (char)0}, .first = 46U, .count = 3U},
    {.params = {.none = (char)0}, .first = 49U, .count = 12U},
    {.params = {.none = (char)0}, .first = 61U, .count = 19U},
};

static const late_stage_selftest_call late_stage_selftest_calls[80] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_LATE, .u = -3.625406851213303, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7481261718750001}, .status = PTC_OK, .u = -3.6033299363236715, .xhat = {0.7498887115858045, -0.0017033497552366565}, .d = -0.008690559975697227},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7462546875}, .status = PTC_OK, .u = -3.56512389481134, .xhat = {0.7496690695144652, -0.007460260690827083}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496690695144652, -0.007460260690827083}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496690695144652, -0.007460260690827083}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496690695144652, -0.007460260690827083}, .d = -0.02578891550457462},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.744385546875}, .status = PTC_OK, .u = -3.5114181360607404, .xhat = {0.7493439899338437, -0.014772475425259998}, .d = -0.05100954522904584},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.57421875}, .status = PTC_INFEASIBLE, .u = 5.55255472609642, .xhat = {0.7289473298767895, -0.6474466233272298}, .d = -6.548570290334985},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6201350622665925, -12.655631200427385}, .d = -451.04775244401},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.5416529602669968, -20.240183840541953}, .d = -720.9572280601567},
    {.is_armed = 0U, .start = 0U, .k = 199U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.4859719027213375, -24.622858876084624}, .d = -865.6252607824741},
    {.is_armed = 0U, .start = 0U, .k = 200U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.4469704446892396, -26.75958162929479}, .d = -923.5378254499501},
    {.is_armed = 0U, .start = 0U, .k = 201U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.42010816020803776, -27.34873297829428}, .d = -922.7029908338832},
    {.is_armed = 0U, .start = 0U, .k = 500U, .y = {0.10546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2892523177024492, -39.41099829313101}, .d = -1346.8189163010736},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.15971742916340714, -50.25533373392351}, .d = -1715.35432975509},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.06973567769643753, -55.73968036856391}, .d = -1876.2719994391766},
    {.is_armed = 0U, .start = 0U, .k = 799U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.008564138322772773, -57.52006704685895}, .d = -1896.0326912417293},
    {.is_armed = 0U, .start = 0U, .k = 800U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03175454261454028, -56.801536570421824}, .d = -1822.752977515867},
    {.is_armed = 0U, .start = 0U, .k = 801U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.057098602248296035, -54.455023082012936}, .d = -1690.9869723274917},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07179796746342047, -51.104782065202755}, .d = -1525.2993551042136},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.0790305110547235, -47.19343953622151}, .d = -1342.9212526702363},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07485971309310666, -47.295757788289436}, .d = -1338.9163664618832},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7481261718750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07088654357956359, -47.39286023006279}, .d = -1334.8780579455504},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06709511377759048, -47.48453444763983}, .d = -1330.805009290576},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709511377759048, -47.48453444763983}, .d = -1330.805009290576},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709511377759048, -47.48453444763983}, .d = -1330.805009290576},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709511377759048, -47.48453444763983}, .d = -1330.805009290576},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.744385546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06347012810737537, -47.570576672296035}, .d = -1326.6959313788707},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.57421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03167346548429964, -45.98303062226627}, .d = -1301.2525292728672},
    {.is_armed = 0U, .start = 0U, .k = 193U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10373101796327393, -26.67206592769833}, .d = -554.0500707265762},
    {.is_armed = 0U, .start = 0U, .k = 195U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2019529291415107, -13.15906346687172}, .d = -40.03639759160103},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.2731100710542648, -3.8248617705382646}, .d = 306.5151812254801},
    {.is_armed = 0U, .start = 0U, .k = 197U, .y = {0.421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.32422411099213905, 2.4678832294864685}, .d = 531.8633866282362},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.3605273446261423, 6.553342479923868}, .d = 670.1924110486773},
    {.is_armed = 0U, .start = 0U, .k = 497U, .y = {0.10546875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.273145269679478, -3.451399574790643}, .d = 283.246596403728},
    {.is_armed = 0U, .start = 0U, .k = 793U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.17277628513688104, -14.030691853665617}, .d = -115.42463852753599},
    {.is_armed = 0U, .start = 0U, .k = 795U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10163550532010744, -20.44402333839836}, .d = -349.95729503547625},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.051918982208763426, -23.916207153320606}, .d = -469.7676265749303},
    {.is_armed = 0U, .start = 0U, .k = 797U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.017833813596334902, -25.3365693412704}, .d = -510.9225810280109},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.004912503573166643, -25.36709763419177}, .d = -499.5860343207032},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.01949624081335217, -24.481389216650552}, .d = -454.5947093668136},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.02825877343829022, -23.01971339584265}, .d = -389.3821552784516},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.8221707939338208}, .status = PTC_LATE, .u = 3.6210647307787176, .xhat = {-0.8221707939338208, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 77U, .y = {-0.9983109194024815}, .status = PTC_LATE, .u = 5.20850846161893, .xhat = {-0.8389349573387014, -0.41907498269266097}, .d = -3.4922915224388413},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-0.604116101175212}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.754761054223642, 8.967350248361235}, .d = 344.1499078200921},
    {.is_armed = 0U, .start = 0U, .k = 94U, .y = {6.260933143287877e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-0.754761054223642, 8.967350248361235}, .d = 344.1499078200921},
    {.is_armed = 1U, .start = 0U, .k = 763U, .y = {0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 108U, .y = {7.1200186866681e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {8.983084573305412e152, 3.027623808473296e154}, .d = 3.4018245039025797e155},
    {.is_armed = 1U, .start = 4294967290U, .k = 703U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {8.967500654424333e153, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 700U, .y = {0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 792U, .y = {-0.0}, .status = PTC_HOLD, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 688U, .y = {0.0006173528109680926}, .status = PTC_OK, .u = -2.4463839499718096, .xhat = {0.0002220037202003486, 0.024633289501682514}, .d = 0.912344055617871},
    {.is_armed = 0U, .start = 0U, .k = 750U, .y = {0.0008613322193409756}, .status = PTC_LATE, .u = -5.380262469651503, .xhat = {0.0004678797940011431, 0.049756631527883996}, .d = 1.8203111910174847},
    {.is_armed = 0U, .start = 0U, .k = 789U, .y = {-0.0}, .status = PTC_LATE, .u = -4.4170017949419735, .xhat = {0.0003313576625577283, 0.02869311840613804}, .d = 1.0556396620381117},
    {.is_armed = 1U, .start = 4294967290U, .k = 747U, .y = {0.00036670820192989163}, .status = PTC_LATE, .u = -4.309859828201002, .xhat = {0.000361521674603554, 0.026133197083190667}, .d = 1.067608571252737},
    {.is_armed = 1U, .start = 4294967290U, .k = 774U, .y = {-0.000987867785875774}, .status = PTC_LATE, .u = 4.581817973603336, .xhat = {-0.00010770618434818342, -0.03094056998162896}, .d = -0.9635335861186265},
    {.is_armed = 1U, .start = 4294967290U, .k = 103U, .y = {-0.0}, .status = PTC_OK, .u = 1.2325277299146888, .xhat = {-0.00012250220606252127, -0.03384593713888036}, .d = -0.9565991718880013},
    {.is_armed = 1U, .start = 4294967290U, .k = 764U, .y = {0.0}, .status = PTC_LATE, .u = 3.8985321332696703, .xhat = {-9.935057045044934e-5, -0.025238819830183168}, .d = -0.7273286246946566},
    {.is_armed = 0U, .start = 0U, .k = 133U, .y = {-0.0007605301658143444}, .status = PTC_OK, .u = 1.0928172951791542, .xhat = {-0.00024337110864876166, -0.031052784332841997}, .d = -0.8333762782487748},
    {.is_armed = 1U, .start = 4294967290U, .k = 748U, .y = {-0.0002524655297099524}, .status = PTC_LATE, .u = 4.288897770135539, .xhat = {-0.000265873233182516, -0.028173944033640125}, .d = -0.8024354240813203},
    {.is_armed = 0U, .start = 0U, .k = 772U, .y = {-0.000998536974891105}, .status = PTC_LATE, .u = 5.3831426969835325, .xhat = {-0.0005473238866538755, -0.05609440238666382}, .d = -1.8436963969364655},
    {.command = 1U, .samples = 1024U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.03957940037256842}, .status = PTC_OK, .u = -0.3400447933402025, .xhat = {0.03957940037256842, 0.0}, .d = 0.0},
    {.command = 2U, .samples = 1024U, .told = PTC_OK, .found = 302U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.9728666113673947}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.3245021703516548, -40.398092094057645}, .d = -1496.2256331132462},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 1031U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.5828280052597419}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.02441103898205621, -3.560139020160257}, .d = -94.90476178601966},
    {.command = 4U, .samples = 1024U, .told = PTC_OK, .given = {-0.0006470851784951246}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.35507933540131353}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.14520579355200522, -16.696144930423223}, .d = -579.2283198998082},
    {.command = 5U, .samples = 1024U, .told = PTC_OK, .given = {0.6166624028512053, 0.3670304664935049}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.03151915608260474}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.40624143233835885, -22.981049823288103}, .d = -1443.9720343361641},
    {.command = 6U, .samples = 1024U, .told = PTC_OK, .given = {-0.0}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {0.000929440430266613}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.24577319644516582, -38.23269923652413}, .d = -565.0240523420752},
    {.command = 7U, .samples = 1024U, .told = PTC_OK, .given = {-0.00016096713749881708}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 400U, .y = {-0.9440983356923232}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.2067175282956535, -84.55787839895493}, .d = -2266.672069411313},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 400U, .y = {-0.03306843631202501}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.19890650829750403, -75.73600565703508}, .d = -1883.9688263678995},
    {.command = 1U, .samples = 40U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {-0.08788054344360532}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.20788268539219645, -69.51092833781684}, .d = -1607.0408064865353},
    {.command = 7U, .samples = 200U, .told = PTC_E_INPUT, .given = {(double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.09279846541452788}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.21135387288231533, -63.19137502555854}, .d = -1333.451404637795},
    {.command = 1U, .samples = 4294967295U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {6.063542673396971e-5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.17607871298558125, -53.10150630449844}, .d = -926.9759852247597},
    {.command = 1U, .samples = 1U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.0004254067623468774}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.14711523231882473, -44.5755857792062}, .d = -588.4610031713491},
    {.command = 3U, .samples = 2147483648U, .told = PTC_OK, .found = 41U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {0.08456181302576178}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.09247307378653942, -33.93325785942577}, .d = -179.9189566814233},
    {.command = 2U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.8294368582460572}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.3792573904140912, -62.09884759546152}, .d = -1218.794651678268},
    {.command = 5U, .samples = 4294967295U, .told = PTC_E_INPUT, .given = {(double)NAN, -0.22012336710328917}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 800U, .y = {-0.2042169967447207}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.35633845388429813, -53.42904041839644}, .d = -867.7451352023202},
    {.command = 1U, .samples = 2147483648U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {31.542470443763527}, .status = PTC_SATURATED, .u = -6.0, .xhat = {11.080262196286675, 1220.9494382445134}, .d = 46352.73543589811},
    {.command = 2U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 400U, .y = {-1.7976931348623157e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {11.080262196286675, 1220.9494382445134}, .d = 46352.73543589811},
    {.command = 6U, .samples = 2147483648U, .told = PTC_E_INPUT, .given = {(double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {1.7976931348623157e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {11.080262196286675, 1220.9494382445134}, .d = 46352.73543589811},
    {.command = 4U, .samples = 1048576U, .told = PTC_E_INPUT, .given = {(double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {72.79929465463223}, .status = PTC_SATURATED, .u = -6.0, .xhat = {34.066575866072725, 3665.2015863863844}, .d = 135735.9326402662},
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
