/* Self-test of the prescribed-time controller mix_fixed: see mix_fixed_selftest.h. DO NOT EDIT. */
#include "mix_fixed_selftest.h"
#include "mix_fixed.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct mix_fixed_selftest_call {
    double t;
    double x[3];
    double u[2];
    double tolerance[2];
    ptc_status axes[2];
    ptc_status status;
} mix_fixed_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct mix_fixed_selftest_session {
    mix_fixed_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} mix_fixed_selftest_session;

static const mix_fixed_selftest_session mix_fixed_selftest_sessions[6] = {
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 14U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 14U, .count = 10U},
    {.params = {.t0 = 0.3}, .t0 = 1000.1, .is_armed_again = 1U, .first = 24U, .count = 3U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 27U, .count = 14U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 41U, .count = 1U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 42U, .count = 1U},
};

/* The failures of what was returned for each input, and of the status of all. */
static uint32_t mix_fixed_selftest_differs(const mix_fixed_selftest_call *call, ptc_status status, const double u[2], const ptc_status axes[2])
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
static uint32_t mix_fixed_selftest_check(const mix_fixed *self, const mix_fixed_selftest_call *call)
{
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    ptc_status status = mix_fixed_step(self, call->t, call->x, u, axes);

    return mix_fixed_selftest_differs(call, status, u, axes);
}

/* Every session with its calls. */
static uint32_t mix_fixed_selftest_run(void)
{
    static const mix_fixed_selftest_call calls[43] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {-2.355763634022027, 0.13461414089378376}, .tolerance = {1.9643632521893035e-13, 5.017598640161566e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 0.55, .x = {-0.75, 1.25, -0.5}, .u = {12.562986165028361, 3.9584413700063026}, .tolerance = {9.717403260656718e-13, 2.9472274621680395e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 0.8999999999999999, .x = {0.5563466654960325, -0.9272444424933874, 0.370897776997355}, .u = {-20.90434598883087, 2.486733564357778}, .tolerance = {1.066981042815521e-12, 1.8541151844723916e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.2, .x = {-0.012891340114443345, 0.021485566857405575, -0.00859422674296223}, .u = {12.121567836843795, 0.18108679069451042}, .tolerance = {5.086077822714799e-13, 7.40866997634654e-15}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 0.7, .x = {1.0, 0.0, 0.0}, .u = {-19.551688492540247, -0.0}, .tolerance = {7.864088866485533e-13, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 0.7, .x = {0.0, 1.0, 0.0}, .u = {-6.166666666666666, -0.0}, .tolerance = {2.747026083970377e-13, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 0.7, .x = {0.0, 0.0, 1.0}, .u = {1.0, -2.0}, .tolerance = {5.222204460492503e-14, 1.0444408920985006e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.25, .x = {0.007103677462019738, 0.0, 0.0}, .u = {-28.314143422641113, -0.0}, .tolerance = {1.1388527396957157e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.25, .x = {0.0, 0.2515723270440251, 0.0}, .u = {-20.0, -0.0}, .tolerance = {8.57271080777746e-13, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.25, .x = {0.0, 0.0, 0.3124999999999999}, .u = {1.429933269780743, -9.151572926596758}, .tolerance = {5.95595489152132e-14, 3.811811130573646e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.0, .x = {0.0, 0.0, 1.0}, .u = {2.0, -4.0}, .tolerance = {1.0444408920985007e-13, 2.0888817841970015e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 1.28, .x = {0.0010425362803053778, -0.0017375604671756295, 0.0006950241868702518}, .u = {-25.7033503487995, -0.043193974671374875}, .tolerance = {1.0416572260561623e-12, 2.0973733611123094e-15}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.28, .x = {-0.0004891870105334462, 0.0008153116842224103, -0.0003261246736889641}, .u = {12.069977129583553, 0.026427640744323893}, .tolerance = {4.892080436553568e-13, 1.0638225167287578e-15}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1.295, .x = {0.0002588334431156196, -0.0004313890718593659, 0.00017255562874374637}, .u = {-25.707675332540113, -0.023665304699659922}, .tolerance = {1.0378973678172793e-12, 1.0409230867710562e-15}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1.295, .x = {-0.00012150693249846691, 0.00020251155416411152, -8.100462166564461e-5}, .u = {12.070523722044303, 0.012639585514268907}, .tolerance = {4.87338527277898e-13, 5.08494003514142e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1.3, .x = {0.0002588334431156196, -0.0004313890718593659, 0.00017255562874374637}, .u = {-25.707675332540113, -0.023665304699659922}, .tolerance = {1.0378973678172793e-12, 1.0409230867710562e-15}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1.3, .x = {-0.00012150693249846691, 0.00020251155416411152, -8.100462166564461e-5}, .u = {12.070523722044303, 0.012639585514268907}, .tolerance = {4.87338527277898e-13, 5.08494003514142e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1.55, .x = {0.0002588334431156196, -0.0004313890718593659, 0.00017255562874374637}, .u = {-25.707675332540113, -0.023665304699659922}, .tolerance = {1.0378973678172793e-12, 1.0409230867710562e-15}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1.55, .x = {-0.00012150693249846691, 0.00020251155416411152, -8.100462166564461e-5}, .u = {12.070523722044303, 0.012639585514268907}, .tolerance = {4.87338527277898e-13, 5.08494003514142e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 11.3, .x = {0.0002588334431156196, -0.0004313890718593659, 0.00017255562874374637}, .u = {-25.707675332540113, -0.023665304699659922}, .tolerance = {1.0378973678172793e-12, 1.0409230867710562e-15}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 11.3, .x = {-0.00012150693249846691, 0.00020251155416411152, -8.100462166564461e-5}, .u = {12.070523722044303, 0.012639585514268907}, .tolerance = {4.87338527277898e-13, 5.08494003514142e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5}, .u = {5.5682099852323494, 2.1818244411627443}, .tolerance = {5.073755345475718e-13, 1.7819012400102155e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1000.8000000000001, .x = {-0.13331596515075267, 0.22219327525125443, -0.08887731010050177}, .u = {12.861602196946242, 1.0217772250448047}, .tolerance = {6.093289677093555e-13, 4.659391131321371e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1001.1, .x = {-0.00012150693249846691, 0.00020251155416411152, -8.100462166564461e-5}, .u = {12.070523722044303, 0.012639585514268907}, .tolerance = {4.87338527277898e-13, 5.08494003514142e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 0.8, .x = {0.47342596535218284, -0.7890432755869714, 0.31561731023478856}, .u = {-10.708433918203164, 0.8263893878609014}, .tolerance = {5.719739242208132e-13, 8.759718649625512e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 0.8, .x = {2.840555792113097, -4.734259653521828, 1.8937038614087314}, .u = {-40.0, 15.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 0.8, .x = {-2.840555792113097, 4.734259653521828, -1.8937038614087314}, .u = {40.0, 15.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 0.8, .x = {956.5421064115174, -994.7932469947675, -478.69704244951004}, .u = {-40.0, -15.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.3, .x = {0.0001294167215578098, -0.00021569453592968295, 8.627781437187319e-5}, .u = {-12.854669849697968, -0.012387126395298409}, .tolerance = {5.18982253539926e-13, 5.205010262096008e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1.3, .x = {0.0007765003293468588, -0.001294167215578098, 0.0005176668862312392}, .u = {-40.0, -0.057692838978964295}, .tolerance = {0.0, 3.1218219685459222e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 1.3, .x = {-0.0007765003293468588, 0.001294167215578098, -0.0005176668862312392}, .u = {40.0, 0.09762271900798904}, .tolerance = {0.0, 3.9309665597702654e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 1.3, .x = {0.05176668862312391, -0.08627781437187318, 0.034511125748749275}, .u = {-40.0, 15.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.3, .x = {0.7848136919994366, 0.7182342990099322, -0.01645147234566502}, .u = {-40.0, -15.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.8, .x = {0.0001294167215578098, -0.00021569453592968295, 8.627781437187319e-5}, .u = {-12.854669849697968, -0.012387126395298409}, .tolerance = {5.18982253539926e-13, 5.205010262096008e-16}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1.8, .x = {0.0007765003293468588, -0.001294167215578098, 0.0005176668862312392}, .u = {-40.0, -0.057692838978964295}, .tolerance = {0.0, 3.1218219685459222e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 1.8, .x = {-0.0007765003293468588, 0.001294167215578098, -0.0005176668862312392}, .u = {40.0, 0.09762271900798904}, .tolerance = {0.0, 3.9309665597702654e-15}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 1.8, .x = {0.05176668862312391, -0.08627781437187318, 0.034511125748749275}, .u = {-40.0, 15.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.8, .x = {0.7848136919994366, 0.7182342990099322, -0.01645147234566502}, .u = {-40.0, -15.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.3, .x = {1.3482698511467367e308, -1.0, -1.0}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 1.3, .x = {-1.0, 1.3482698511467367e308, 1.3482698511467367e308}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const mix_fixed_selftest_session *session = &mix_fixed_selftest_sessions[i];
        mix_fixed self;
        ptc_status status = mix_fixed_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = mix_fixed_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += mix_fixed_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t mix_fixed_selftest_refuse(void)
{
    static const mix_fixed_params refused[3] = {
        {.t0 = (double)NAN},
        {.t0 = (double)INFINITY},
        {.t0 = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const mix_fixed_selftest_session *session = &mix_fixed_selftest_sessions[0];
    const mix_fixed_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {-2.355763634022027, 0.13461414089378376}, .tolerance = {1.9643632521893035e-13, 5.017598640161566e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    mix_fixed self;

    if (mix_fixed_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (mix_fixed_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (mix_fixed_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += mix_fixed_selftest_check(&self, &call);
    if (mix_fixed_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (mix_fixed_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (mix_fixed_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

uint32_t mix_fixed_selftest(void)
{
    uint32_t failures = mix_fixed_selftest_run();

    failures += mix_fixed_selftest_refuse();
    return failures;
}
