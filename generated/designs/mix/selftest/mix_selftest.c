/* Self-test of the prescribed-time controller mix: see mix_selftest.h. DO NOT EDIT. */
#include "mix_selftest.h"
#include "mix.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct mix_selftest_call {
    double t;
    double x[3];
    double u[2];
    double tolerance[2];
    ptc_status axes[2];
    ptc_status status;
} mix_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct mix_selftest_session {
    mix_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} mix_selftest_session;

static const mix_selftest_session mix_selftest_sessions[6] = {
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 2e-13, .u_max = (double)INFINITY}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 30U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY}, .t0 = 0.0, .is_armed_again = 0U, .first = 30U, .count = 10U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY}, .t0 = 1000.1, .is_armed_again = 1U, .first = 40U, .count = 4U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 2.3557636340220274}, .t0 = 0.0, .is_armed_again = 0U, .first = 44U, .count = 14U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.0002, .u_max = 1.0}, .t0 = 0.0, .is_armed_again = 0U, .first = 58U, .count = 1U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY}, .t0 = 0.0, .is_armed_again = 0U, .first = 59U, .count = 1U},
};

/* The failures of what was returned for each input, and of the status of all. */
static uint32_t mix_selftest_differs(const mix_selftest_call *call, ptc_status status, const double u[2], const ptc_status axes[2])
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
static uint32_t mix_selftest_check(const mix *self, const mix_selftest_call *call)
{
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    ptc_status status = mix_step(self, call->t, call->x, u, axes);

    return mix_selftest_differs(call, status, u, axes);
}

/* Every session with its calls. */
static uint32_t mix_selftest_run(void)
{
    static const mix_selftest_call calls[60] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {0.010806255201935903, -0.0579569456004302}, .tolerance = {4.5852131502011235e-14, 2.0917706130960462e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 0.8, .x = {-0.75, 1.25, -0.5}, .u = {1.3345296658821335, 1.0187843701960297}, .tolerance = {2.018301104509387e-13, 9.626894248125755e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.5, .x = {0.75, -1.25, 0.5}, .u = {-4.633181917830019, 0.4740404261844486}, .tolerance = {3.203621502928427e-13, 7.662636444639789e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.1, .x = {-0.75, 1.25, -0.5}, .u = {271.7378509322071, 63.99730020715713}, .tolerance = {1.6561831282581586e-11, 3.860936676527622e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.28, .x = {0.75, -1.25, 0.5}, .u = {-14387.988488617291, 3164.2752196927318}, .tolerance = {6.408979773395784e-10, 1.3877311986800079e-10}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.2998, .x = {-0.75, 1.25, -0.5}, .u = {310583249.560183, 69021833.513374}, .tolerance = {1.7865806357169688e-5, 3.893718003254032e-6}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.299998, .x = {0.75, -1.25, 0.5}, .u = {-1458842442295.5017, 324186876065.9448}, .tolerance = {0.06451194910173046, 0.01397577962610193}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.29999998, .x = {-0.75, 1.25, -0.5}, .u = {3.1062327889925388e16, 6902739564427865.0}, .tolerance = {1786.717861728673, 389.37870538751054}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.2999999998, .x = {0.75, -1.25, 0.5}, .u = {-1.4588417811893055e20, 3.2418706245317902e19}, .tolerance = {6451187.344052519, 1397576.4028359754}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.299999999998, .x = {-0.75, 1.25, -0.5}, .u = {3.106542727169875e24, 6.903428282603055e23}, .tolerance = {178689613013.8255, 38941755305.0283}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.1, .x = {1.0, 0.0, 0.0}, .u = {-4.887922123135063, -0.0}, .tolerance = {1.9660222166213838e-13, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.1, .x = {0.0, 1.0, 0.0}, .u = {-2.8333333333333335, -0.0}, .tolerance = {1.3229579304728763e-13, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.1, .x = {0.0, 0.0, 1.0}, .u = {0.5, -1.0}, .tolerance = {2.611102230246252e-14, 5.222204460492504e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.1999999999999997, .x = {1.0, 0.0, 0.0}, .u = {-703.8607857314453, -0.0}, .tolerance = {2.8310719919347776e-11, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.1999999999999997, .x = {0.0, 1.0, 0.0}, .u = {-39.4999999999999, -0.0}, .tolerance = {1.6987707618945348e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.1999999999999997, .x = {0.0, 0.0, 1.0}, .u = {5.999999999999985, -11.99999999999997}, .tolerance = {3.1333226762954946e-13, 6.266645352590989e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.7, .x = {0.0, 0.0, 1.0}, .u = {1.0, -2.0}, .tolerance = {5.222204460492503e-14, 1.0444408920985006e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {(double)NAN, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, (double)NAN, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, (double)NAN}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {(double)INFINITY, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, (double)INFINITY, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, (double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {-(double)INFINITY, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -(double)INFINITY, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, -(double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -0.7, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 2.05, .x = {0.75, -1.25, 0.5}, .u = {-77.82664996434227, 14.905922214298283}, .tolerance = {3.812441947392759e-12, 8.287815802806239e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.05, .x = {-0.75, 1.25, -0.5}, .u = {167.92064657944474, 40.26014368432105}, .tolerance = {1.0404155885383253e-11, 2.4729955889997188e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 2.2375, .x = {0.75, -1.25, 0.5}, .u = {-341.8450770580404, 70.91001712400897}, .tolerance = {1.5859125831022456e-11, 3.4322108091575397e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 2.2375, .x = {-0.75, 1.25, -0.5}, .u = {732.2886404545651, 168.34192010101447}, .tolerance = {4.3611103314935656e-11, 9.893777736696296e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {0.75, -1.25, 0.5}, .u = {-341.8450770580404, 70.91001712400897}, .tolerance = {1.5859125831022456e-11, 3.4322108091575397e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {-0.75, 1.25, -0.5}, .u = {732.2886404545651, 168.34192010101447}, .tolerance = {4.3611103314935656e-11, 9.893777736696296e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 2.8, .x = {0.75, -1.25, 0.5}, .u = {-341.8450770580404, 70.91001712400897}, .tolerance = {1.5859125831022456e-11, 3.4322108091575397e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 2.8, .x = {-0.75, 1.25, -0.5}, .u = {732.2886404545651, 168.34192010101447}, .tolerance = {4.3611103314935656e-11, 9.893777736696296e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 22.3, .x = {0.75, -1.25, 0.5}, .u = {-341.8450770580404, 70.91001712400897}, .tolerance = {1.5859125831022456e-11, 3.4322108091575397e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 22.3, .x = {-0.75, 1.25, -0.5}, .u = {732.2886404545651, 168.34192010101447}, .tolerance = {4.3611103314935656e-11, 9.893777736696296e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5}, .u = {0.2531004538741977, 0.6673556564164884}, .tolerance = {1.0861466118567216e-13, 6.82876419823824e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1001.5, .x = {-0.75, 1.25, -0.5}, .u = {22.31885820526805, 6.348635156726191}, .tolerance = {1.5949244850051045e-12, 4.458668091285726e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1002.1, .x = {-0.75, 1.25, -0.5}, .u = {732.2886404545651, 168.34192010101447}, .tolerance = {4.3611103314935656e-11, 9.893777736696296e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.1875, -0.3125, 0.125}, .u = {-0.7076243110010699, -0.12278298846504994}, .tolerance = {5.490803721207795e-14, 8.929303209129079e-15}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.3, .x = {1.125, -1.875, 0.75}, .u = {-2.3557636340220274, 0.6665824786293278}, .tolerance = {0.0, 9.945539631369028e-14}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK}},
        {.t = 1.3, .x = {-1.125, 1.875, -0.75}, .u = {2.3557636340220274, 2.3557636340220274}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.3, .x = {956.5421064115174, -994.7932469947675, -478.69704244951004}, .u = {-2.3557636340220274, -2.3557636340220274}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 2.3, .x = {0.0012921223999494218, -0.002153537333249036, 0.0008614149332996145}, .u = {-0.7586274792462339, -0.01000930142163973}, .tolerance = {3.206328359935572e-14, 4.163598393394752e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {0.007752734399696531, -0.012921223999494219, 0.005168489599797687}, .u = {-2.3557636340220274, -0.05026305583472369}, .tolerance = {0.0, 2.5156541519553647e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 2.3, .x = {-0.007752734399696531, 0.012921223999494219, -0.005168489599797687}, .u = {2.3557636340220274, 0.07387112051199812}, .tolerance = {0.0, 3.006325367655583e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 2.3, .x = {0.5168489599797687, -0.8614149332996145, 0.3445659733198458}, .u = {-2.3557636340220274, 2.3557636340220274}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 2.3, .x = {0.7848136919994366, 0.7182342990099322, -0.01645147234566502}, .u = {-2.3557636340220274, -2.3557636340220274}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 3.3, .x = {0.0012921223999494218, -0.002153537333249036, 0.0008614149332996145}, .u = {-0.7586274792462339, -0.01000930142163973}, .tolerance = {3.206328359935572e-14, 4.163598393394752e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 3.3, .x = {0.007752734399696531, -0.012921223999494219, 0.005168489599797687}, .u = {-2.3557636340220274, -0.05026305583472369}, .tolerance = {0.0, 2.5156541519553647e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 3.3, .x = {-0.007752734399696531, 0.012921223999494219, -0.005168489599797687}, .u = {2.3557636340220274, 0.07387112051199812}, .tolerance = {0.0, 3.006325367655583e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 3.3, .x = {0.5168489599797687, -0.8614149332996145, 0.3445659733198458}, .u = {-2.3557636340220274, 2.3557636340220274}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 3.3, .x = {0.7848136919994366, 0.7182342990099322, -0.01645147234566502}, .u = {-2.3557636340220274, -2.3557636340220274}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 2.3, .x = {1.3482698511467367e308, -1.0, -1.0}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 2.3, .x = {-1.0, 1.3482698511467367e308, 1.3482698511467367e308}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const mix_selftest_session *session = &mix_selftest_sessions[i];
        mix self;
        ptc_status status = mix_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = mix_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += mix_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t mix_selftest_refuse(void)
{
    static const mix_params refused[20] = {
        {.tau = (double)NAN, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = (double)INFINITY, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY},
        {.tau = 0.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = -1.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 7.5e-151, .t0 = 0.3, .eps = 4.6875e-152, .u_max = (double)INFINITY},
        {.tau = 1.25e150, .t0 = 0.3, .eps = 7.8125e148, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = (double)NAN, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = (double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = -(double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)NAN, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = -1.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 7.5e-151, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 2.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 4.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)NAN},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 0.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const mix_selftest_session *session = &mix_selftest_sessions[0];
    const mix_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {0.010806255201935903, -0.0579569456004302}, .tolerance = {4.5852131502011235e-14, 2.0917706130960462e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    mix self;

    if (mix_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 20U; i++) {
        if (mix_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (mix_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += mix_selftest_check(&self, &call);
    if (mix_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (mix_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (mix_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    /* A deadline beyond the range, which no legal parameters need to reach. */
    self.tau = 1.7976931348623157e308;
    if (mix_arm(&self, 1.7976931348623157e308) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0; u is lost for the next one. */
static uint32_t mix_selftest_refused(ptc_status status, double u[2])
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
static uint32_t mix_selftest_pointers(void)
{
    const mix_selftest_session *session = &mix_selftest_sessions[0];
    const mix_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {0.010806255201935903, -0.0579569456004302}, .tolerance = {4.5852131502011235e-14, 2.0917706130960462e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2];
    ptc_status status;
    mix self;

    if (mix_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = mix_step(NULL, call.t, call.x, u, axes);
    failures += mix_selftest_refused(status, u);
    status = mix_step(&self, call.t, NULL, u, axes);
    failures += mix_selftest_refused(status, u);
    status = mix_step(&self, call.t, call.x, u, NULL);
    failures += mix_selftest_refused(status, u);
    status = mix_step(&self, call.t, call.x, NULL, axes);
    if (status != PTC_E_INPUT) {
        failures++;
    }
    return failures;
}

uint32_t mix_selftest(void)
{
    uint32_t failures = mix_selftest_run();

    failures += mix_selftest_refuse();
    failures += mix_selftest_pointers();
    return failures;
}
