/* Self-test of the prescribed-time controller two_link: see two_link_selftest.h. DO NOT EDIT. */
#include "two_link_selftest.h"
#include "two_link.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct two_link_selftest_call {
    double t;
    double x[4];
    double u[2];
    double tolerance[2];
    ptc_status axes[2];
    ptc_status status;
} two_link_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct two_link_selftest_session {
    two_link_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} two_link_selftest_session;

static const two_link_selftest_session two_link_selftest_sessions[5] = {
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 30U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 30U, .count = 10U},
    {.params = {.t0 = 0.3}, .t0 = 1000.1, .is_armed_again = 1U, .first = 40U, .count = 4U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 44U, .count = 15U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 59U, .count = 1U},
};

/* The failures of what was returned for each input, and of the status of all. */
static uint32_t two_link_selftest_differs(const two_link_selftest_call *call, ptc_status status, const double u[2], const ptc_status axes[2])
{
    uint32_t failures = 0U;

    if (status != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        if (!((axes[i] == call->axes[i]) && (fabs(u[i] - call->u[i]) <= call->tolerance[i]))) {
            failures++;
        }
    }
    return failures;
}

/* The failures of one call. */
static uint32_t two_link_selftest_check(const two_link *self, const two_link_selftest_call *call)
{
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    ptc_status status = two_link_step(self, call->t, call->x, u, axes);

    return two_link_selftest_differs(call, status, u, axes);
}

/* Every session with its calls. */
static uint32_t two_link_selftest_run(void)
{
    static const two_link_selftest_call calls[60] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {17.778916604819127, 4.501396907774865}, .tolerance = {6.978248831280408e-13, 2.0547400165299908e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 5.3, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {31.166854370287755, 9.718397384586206}, .tolerance = {9.340279038656202e-13, 2.8176018056624324e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 12.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {-50.003150443169865, -1.521310132144467}, .tolerance = {4.728710672193963e-12, 1.5025378360359672e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 18.3, .x = {-0.0019508116355167913, 0.003251352725861319, -0.0013005410903445275, -0.0039016232710335826}, .u = {63.5249619514743, 13.841336041696628}, .tolerance = {3.7322699123553405e-12, 1.1373552557515312e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {1.0, 0.0, 0.0, 0.0}, .u = {-14.234235759163395, -5.573336895686274}, .tolerance = {1.2262892762847686e-12, 3.459570548061618e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {0.0, 1.0, 0.0, 0.0}, .u = {17.421921927917165, -0.3650035623529402}, .tolerance = {7.0446607317524e-13, 1.8855057248884384e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {0.0, 0.0, 1.0, 0.0}, .u = {10.776833333333334, 1.7658333333333334}, .tolerance = {1.0600462710331764e-12, 2.9262542709819686e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {0.0, 0.0, 0.0, 1.0}, .u = {22.366833333333332, 4.815833333333334}, .tolerance = {7.092197680042575e-13, 2.0030266314321819e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 19.3, .x = {0.00014457041734843146, 0.0, 0.0, 0.0}, .u = {-59.99814220696047, -21.26744271187753}, .tolerance = {3.0810781397690677e-12, 8.80507222813057e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 19.3, .x = {0.0, 0.00041506773496893833, 0.0, 0.0}, .u = {-54.224908296176984, -29.99859678098399}, .tolerance = {2.6631516040640088e-12, 9.00932936839037e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 19.3, .x = {0.0, 0.0, 0.03476716747103675, 0.0}, .u = {-60.0, -21.26804733727811}, .tolerance = {3.0846569428167104e-12, 8.816700675530653e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 19.3, .x = {0.0, 0.0, 0.0, 0.09981963927855712}, .u = {-54.228, -30.0}, .tolerance = {2.6665250829320675e-12, 9.024586327369294e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 14.3, .x = {0.0, 0.0, 1.0, 0.0}, .u = {-41.61316666666668, -15.28416666666667}, .tolerance = {2.5695433124855133e-12, 7.323771000824419e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 14.3, .x = {0.0, 0.0, 0.0, 1.0}, .u = {5.316833333333331, -2.9341666666666684}, .tolerance = {1.1421839074902858e-12, 3.5613484921161765e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {(double)NAN, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, (double)NAN, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, -1.25, (double)NAN, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, -1.25, 0.5, (double)NAN}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {(double)INFINITY, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, (double)INFINITY, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, -1.25, (double)INFINITY, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, -1.25, 0.5, (double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {-(double)INFINITY, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, -(double)INFINITY, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, -1.25, -(double)INFINITY, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.75, -1.25, 0.5, -(double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -9.7, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 18.3, .x = {0.005349673710653991, -0.008916122851089985, 0.0035664491404359937, 0.010699347421307981}, .u = {-69.57471515648231, -10.42180614579198}, .tolerance = {9.237327811118676e-12, 2.8564187281474373e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 18.3, .x = {-0.0019508116355167913, 0.003251352725861319, -0.0013005410903445275, -0.0039016232710335826}, .u = {63.5249619514743, 13.841336041696628}, .tolerance = {3.7322699123553405e-12, 1.1373552557515312e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 19.8, .x = {0.0003434987979153211, -0.0005724979965255352, 0.00022899919861021407, 0.0006869975958306422}, .u = {-68.81655605001244, -9.57609173693985}, .tolerance = {9.43371480551755e-12, 2.9158236951389347e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 19.8, .x = {-0.0001251380317803478, 0.0002085633863005797, -8.342535452023188e-5, -0.0002502760635606956}, .u = {63.214052862774345, 13.526479287530618}, .tolerance = {3.800673216170543e-12, 1.1580181836663805e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 20.3, .x = {0.0003434987979153211, -0.0005724979965255352, 0.00022899919861021407, 0.0006869975958306422}, .u = {-68.81655605001244, -9.57609173693985}, .tolerance = {9.43371480551755e-12, 2.9158236951389347e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 20.3, .x = {-0.0001251380317803478, 0.0002085633863005797, -8.342535452023188e-5, -0.0002502760635606956}, .u = {63.214052862774345, 13.526479287530618}, .tolerance = {3.800673216170543e-12, 1.1580181836663805e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 25.3, .x = {0.0003434987979153211, -0.0005724979965255352, 0.00022899919861021407, 0.0006869975958306422}, .u = {-68.81655605001244, -9.57609173693985}, .tolerance = {9.43371480551755e-12, 2.9158236951389347e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 25.3, .x = {-0.0001251380317803478, 0.0002085633863005797, -8.342535452023188e-5, -0.0002502760635606956}, .u = {63.214052862774345, 13.526479287530618}, .tolerance = {3.800673216170543e-12, 1.1580181836663805e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 220.3, .x = {0.0003434987979153211, -0.0005724979965255352, 0.00022899919861021407, 0.0006869975958306422}, .u = {-68.81655605001244, -9.57609173693985}, .tolerance = {9.43371480551755e-12, 2.9158236951389347e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 220.3, .x = {-0.0001251380317803478, 0.0002085633863005797, -8.342535452023188e-5, -0.0002502760635606956}, .u = {63.214052862774345, 13.526479287530618}, .tolerance = {3.800673216170543e-12, 1.1580181836663805e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {25.281755568736877, 8.41223049044197}, .tolerance = {6.994908480416001e-13, 2.0634238115078994e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1014.1, .x = {-0.12890413638291112, 0.2148402273048519, -0.08593609092194075, -0.25780827276582224}, .u = {67.05193379635912, 16.432945157552393}, .tolerance = {3.2455168219836337e-12, 9.924657275479607e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1020.1, .x = {-0.0001251380317803478, 0.0002085633863005797, -8.342535452023188e-5, -0.0002502760635606956}, .u = {63.214052862774345, 13.526479287530618}, .tolerance = {3.800673216170543e-12, 1.1580181836663805e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {1.744179043844433, -2.906965073074055, 1.162786029229622, 3.488358087688866}, .u = {-41.198915013236345, 19.45840946292999}, .tolerance = {4.456704862418216e-12, 1.5971063784106407e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 10.3, .x = {10.465074263066597, -17.44179043844433, 6.976716175377732, 20.930148526133195}, .u = {-120.0, -35.834816254073495}, .tolerance = {0.0, 3.3439270306909593e-11}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK}},
        {.t = 10.3, .x = {-10.465074263066597, 17.44179043844433, -6.976716175377732, -20.930148526133195}, .u = {120.0, 47.15055830243158}, .tolerance = {0.0, 3.344178290638216e-11}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK}},
        {.t = 10.3, .x = {27.906864701510926, -46.51144116918488, 18.60457646767395, 55.81372940302185}, .u = {120.0, 60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 10.3, .x = {-27.906864701510926, 46.51144116918488, -18.60457646767395, -55.81372940302185}, .u = {-120.0, -60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 20.3, .x = {0.00011717417130410632, -0.00019529028550684384, 7.811611420273754e-5, 0.00023434834260821263}, .u = {-5.053368379834689, 1.581118227089646}, .tolerance = {3.582360998296035e-12, 1.0912246589269252e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 20.3, .x = {0.0007030450278246379, -0.0011717417130410633, 0.00046869668521642527, 0.0014060900556492758}, .u = {-120.0, -27.30074049408541}, .tolerance = {0.0, 5.815551925088172e-12}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 20.3, .x = {-0.0007030450278246379, 0.0011717417130410633, -0.00046869668521642527, -0.0014060900556492758}, .u = {120.0, 42.01573887781498}, .tolerance = {0.0, 5.818819311090759e-12}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 20.3, .x = {0.001874786740865701, -0.0031246445681095015, 0.0012498578272438006, 0.003749573481731402}, .u = {-120.0, -60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 20.3, .x = {-0.001874786740865701, 0.0031246445681095015, -0.0012498578272438006, -0.003749573481731402}, .u = {120.0, 60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 30.3, .x = {0.00011717417130410632, -0.00019529028550684384, 7.811611420273754e-5, 0.00023434834260821263}, .u = {-5.053368379834689, 1.581118227089646}, .tolerance = {3.582360998296035e-12, 1.0912246589269252e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 30.3, .x = {0.0007030450278246379, -0.0011717417130410633, 0.00046869668521642527, 0.0014060900556492758}, .u = {-120.0, -27.30074049408541}, .tolerance = {0.0, 5.815551925088172e-12}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 30.3, .x = {-0.0007030450278246379, 0.0011717417130410633, -0.00046869668521642527, -0.0014060900556492758}, .u = {120.0, 42.01573887781498}, .tolerance = {0.0, 5.818819311090759e-12}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 30.3, .x = {0.001874786740865701, -0.0031246445681095015, 0.0012498578272438006, 0.003749573481731402}, .u = {-120.0, -60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 30.3, .x = {-0.001874786740865701, 0.0031246445681095015, -0.0012498578272438006, -0.003749573481731402}, .u = {120.0, 60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 19.900000000000002, .x = {-1.0, 1.0, -1.0, -1.7976931348623157e308}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const two_link_selftest_session *session = &two_link_selftest_sessions[i];
        two_link self;
        ptc_status status = two_link_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = two_link_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += two_link_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t two_link_selftest_refuse(void)
{
    static const two_link_params refused[3] = {
        {.t0 = (double)NAN},
        {.t0 = (double)INFINITY},
        {.t0 = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const two_link_selftest_session *session = &two_link_selftest_sessions[0];
    const two_link_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {17.778916604819127, 4.501396907774865}, .tolerance = {6.978248831280408e-13, 2.0547400165299908e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    two_link self;

    if (two_link_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (two_link_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (two_link_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += two_link_selftest_check(&self, &call);
    if (two_link_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (two_link_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (two_link_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0; u is lost for the next one. */
static uint32_t two_link_selftest_refused(ptc_status status, double u[2])
{
    uint32_t failures = 0U;

    if (status != PTC_E_INPUT) {
        failures = 1U;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        if (!(fabs(u[i]) <= 0.0)) {
            failures = 1U;
        }
        u[i] = 12345.0;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t two_link_selftest_pointers(void)
{
    const two_link_selftest_session *session = &two_link_selftest_sessions[0];
    const two_link_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {17.778916604819127, 4.501396907774865}, .tolerance = {6.978248831280408e-13, 2.0547400165299908e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2];
    ptc_status status;
    two_link self;

    if (two_link_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = two_link_step(NULL, call.t, call.x, u, axes);
    failures += two_link_selftest_refused(status, u);
    status = two_link_step(&self, call.t, NULL, u, axes);
    failures += two_link_selftest_refused(status, u);
    status = two_link_step(&self, call.t, call.x, u, NULL);
    failures += two_link_selftest_refused(status, u);
    status = two_link_step(&self, call.t, call.x, NULL, axes);
    if (status != PTC_E_INPUT) {
        failures++;
    }
    return failures;
}

uint32_t two_link_selftest(void)
{
    uint32_t failures = two_link_selftest_run();

    failures += two_link_selftest_refuse();
    failures += two_link_selftest_pointers();
    return failures;
}
