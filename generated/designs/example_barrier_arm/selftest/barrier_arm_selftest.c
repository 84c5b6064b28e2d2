/* Self-test of the prescribed-time controller barrier_arm: see barrier_arm_selftest.h. DO NOT EDIT. */
#include "barrier_arm_selftest.h"
#include "barrier_arm.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct barrier_arm_selftest_call {
    double t;
    double x[4];
    double u[2];
    double tolerance[2];
    ptc_status axes[2];
    ptc_status status;
} barrier_arm_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct barrier_arm_selftest_session {
    barrier_arm_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} barrier_arm_selftest_session;

static const barrier_arm_selftest_session barrier_arm_selftest_sessions[5] = {
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 30U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 30U, .count = 10U},
    {.params = {.t0 = 0.3}, .t0 = 1000.1, .is_armed_again = 1U, .first = 40U, .count = 4U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 44U, .count = 14U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 58U, .count = 1U},
};

/* The failures of what was returned for each input, and of the status of all. */
static uint32_t barrier_arm_selftest_differs(const barrier_arm_selftest_call *call, ptc_status status, const double u[2], const ptc_status axes[2])
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
static uint32_t barrier_arm_selftest_check(const barrier_arm *self, const barrier_arm_selftest_call *call)
{
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    ptc_status status = barrier_arm_step(self, call->t, call->x, u, axes);

    return barrier_arm_selftest_differs(call, status, u, axes);
}

/* Every session with its calls. */
static uint32_t barrier_arm_selftest_run(void)
{
    static const barrier_arm_selftest_call calls[59] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {16.01150216023978, -2.0627175639978512}, .tolerance = {7.261815536464603e-12, 3.2488906105687415e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 5.3, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {36.524108957489936, 25.236443659873615}, .tolerance = {1.6122752534358395e-11, 7.332729987330011e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 12.3, .x = {0.20038500429175882, -0.3339750071529313, 0.13359000286117254, 0.40077000858351763}, .u = {0.1479299221606206, 44.735265454417934}, .tolerance = {1.4751376105195034e-10, 5.670906227387745e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 18.3, .x = {-0.0006380676103642857, 0.0010634460172738096, -0.0004253784069095238, -0.0012761352207285713}, .u = {47.26854908112664, -24.03631295860505}, .tolerance = {1.4035998887347224e-10, 5.336070127240406e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {0.9926471787508765, 0.0, 0.0, 0.0}, .u = {-57.49851841684269, 4.020688565215729}, .tolerance = {1.2917080015523732e-10, 4.8269547453618166e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {0.0, 0.599483120611151, 0.0, 0.0}, .u = {26.67555327694339, -25.57405264211657}, .tolerance = {7.361909104315678e-11, 2.935098601239184e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {0.0, 0.0, 1.0, 0.0}, .u = {17.26988888888889, 7.495}, .tolerance = {1.5183633080717166e-11, 5.591737063820087e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 8.3, .x = {0.0, 0.0, 0.0, 1.0}, .u = {28.096, -3.6911111111111117}, .tolerance = {3.8830553626948374e-11, 1.4772197986370135e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 19.3, .x = {5.59916425964947e-5, 0.0, 0.0, 0.0}, .u = {1.0825114513442424, 7.357499988466883}, .tolerance = {3.755682149578165e-11, 1.3932059746148644e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 19.3, .x = {0.0, 2.6534284857354393e-5, 0.0, 0.0}, .u = {27.95849999740991, -5.378956748131659}, .tolerance = {4.6401939953291584e-11, 1.768131532335594e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 19.3, .x = {0.0, 0.0, 0.05514881530850884, 0.0}, .u = {-60.0, 7.44849554525904}, .tolerance = {1.1670738764104843e-10, 4.3378851114638404e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 19.3, .x = {0.0, 0.0, 0.0, 0.023359387212755982}, .u = {27.997042988901047, -30.0}, .tolerance = {1.2928214816756714e-10, 4.934608532074377e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 14.3, .x = {0.0, 0.0, 1.0, 0.0}, .u = {-15.640944444444452, 7.6325}, .tolerance = {5.905235656757677e-11, 2.1922036113471793e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 14.3, .x = {0.0, 0.0, 0.0, 0.842914446881855}, .u = {28.19030147289251, -29.999999999999996}, .tolerance = {1.295836682142666e-10, 4.946170489293727e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = (double)NAN, .x = {0.4221980710237144, -0.7036634517061907, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = (double)INFINITY, .x = {0.4221980710237144, -0.7036634517061907, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -(double)INFINITY, .x = {0.4221980710237144, -0.7036634517061907, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {(double)NAN, -0.7036634517061907, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, (double)NAN, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, -0.7036634517061907, (double)NAN, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, -0.7036634517061907, 0.2814653806824763, (double)NAN}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {(double)INFINITY, -0.7036634517061907, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, (double)INFINITY, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, -0.7036634517061907, (double)INFINITY, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, -0.7036634517061907, 0.2814653806824763, (double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {-(double)INFINITY, -0.7036634517061907, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, -(double)INFINITY, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, -0.7036634517061907, -(double)INFINITY, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.4221980710237144, -0.7036634517061907, 0.2814653806824763, -(double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -9.7, .x = {0.4221980710237144, -0.7036634517061907, 0.2814653806824763, 0.8443961420474289}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 18.3, .x = {0.0010526663359358727, -0.0017544438932264547, 0.0007017775572905818, 0.0021053326718717454}, .u = {-3.89872272506391, 59.15030352265152}, .tolerance = {2.3118200633054967e-10, 8.794165061241308e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 18.3, .x = {-0.0006380676103642857, 0.0010634460172738096, -0.0004253784069095238, -0.0012761352207285713}, .u = {47.26854908112664, -24.03631295860505}, .tolerance = {1.4035998887347224e-10, 5.336070127240406e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 19.8, .x = {6.692343123865402e-5, -0.00011153905206442336, 4.4615620825769345e-5, 0.00013384686247730804}, .u = {-4.235685092722809, 60.0}, .tolerance = {2.368814218373632e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 19.8, .x = {-4.056267983173963e-5, 6.760446638623272e-5, -2.7041786554493088e-5, -8.112535966347926e-5}, .u = {47.47158222162971, -24.962948987320516}, .tolerance = {1.4380542890846418e-10, 5.46746923363385e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 20.3, .x = {6.692343123865402e-5, -0.00011153905206442336, 4.4615620825769345e-5, 0.00013384686247730804}, .u = {-4.235685092722809, 60.0}, .tolerance = {2.368814218373632e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 20.3, .x = {-4.056267983173963e-5, 6.760446638623272e-5, -2.7041786554493088e-5, -8.112535966347926e-5}, .u = {47.47158222162971, -24.962948987320516}, .tolerance = {1.4380542890846418e-10, 5.46746923363385e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 25.3, .x = {6.692343123865402e-5, -0.00011153905206442336, 4.4615620825769345e-5, 0.00013384686247730804}, .u = {-4.235685092722809, 60.0}, .tolerance = {2.368814218373632e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 25.3, .x = {-4.056267983173963e-5, 6.760446638623272e-5, -2.7041786554493088e-5, -8.112535966347926e-5}, .u = {47.47158222162971, -24.962948987320516}, .tolerance = {1.4380542890846418e-10, 5.46746923363385e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 220.3, .x = {6.692343123865402e-5, -0.00011153905206442336, 4.4615620825769345e-5, 0.00013384686247730804}, .u = {-4.235685092722809, 60.0}, .tolerance = {2.368814218373632e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 220.3, .x = {-4.056267983173963e-5, 6.760446638623272e-5, -2.7041786554493088e-5, -8.112535966347926e-5}, .u = {47.47158222162971, -24.962948987320516}, .tolerance = {1.4380542890846418e-10, 5.46746923363385e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {27.049170013316225, 14.976344962214686}, .tolerance = {7.264266391062333e-12, 3.2517580118625276e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1014.1, .x = {-0.04391704514604183, 0.07319507524340306, -0.029278030097361223, -0.08783409029208367}, .u = {45.47528087782239, -16.099072881749315}, .tolerance = {1.0977167340599337e-10, 4.1717809398989296e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1020.1, .x = {-4.056267983173963e-5, 6.760446638623272e-5, -2.7041786554493088e-5, -8.112535966347926e-5}, .u = {47.47158222162971, -24.962948987320516}, .tolerance = {1.4380542890846418e-10, 5.46746923363385e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 10.3, .x = {0.19066176613776784, -0.31776961022961303, 0.12710784409184522, 0.38132353227553567}, .u = {16.227828910825032, 19.356311387095264}, .tolerance = {5.2881343280281765e-11, 2.0248434374355287e-11}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 10.3, .x = {1.143970596826607, -1.9066176613776784, 0.7626470645510713, 2.287941193653214}, .u = {-120.0, -50.6364516542096}, .tolerance = {0.0, 1.1129910335583879e-10}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK}},
        {.t = 10.3, .x = {-1.143970596826607, 1.9066176613776784, -0.7626470645510713, -2.287941193653214}, .u = {120.0, 60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 10.3, .x = {3.0505882582042854, -5.0843137636738085, 2.0337255054695236, 6.101176516408571}, .u = {-28.080023402427187, -60.0}, .tolerance = {1.3906398469229613e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_OK, PTC_SATURATED}},
        {.t = 20.3, .x = {2.68719563816099e-5, -4.4786593969349834e-5, 1.7914637587739934e-5, 5.37439127632198e-5}, .u = {15.031477006268668, 28.76914477814873}, .tolerance = {9.545327894327373e-11, 3.6273261849025544e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 20.3, .x = {0.0001612317382896594, -0.000268719563816099, 0.0001074878255264396, 0.0003224634765793188}, .u = {-49.603639579265085, 60.0}, .tolerance = {5.699147894600786e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 20.3, .x = {-0.0001612317382896594, 0.000268719563816099, -0.0001074878255264396, -0.0003224634765793188}, .u = {105.52063895872237, -60.0}, .tolerance = {5.699272055281144e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 20.3, .x = {0.0004299513021057584, -0.0007165855035095973, 0.00028663420140383894, 0.0008599026042115168}, .u = {-120.0, 60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 20.3, .x = {-0.0004299513021057584, 0.0007165855035095973, -0.00028663420140383894, -0.0008599026042115168}, .u = {120.0, -60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 30.3, .x = {2.68719563816099e-5, -4.4786593969349834e-5, 1.7914637587739934e-5, 5.37439127632198e-5}, .u = {15.031477006268668, 28.76914477814873}, .tolerance = {9.545327894327373e-11, 3.6273261849025544e-11}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 30.3, .x = {0.0001612317382896594, -0.000268719563816099, 0.0001074878255264396, 0.0003224634765793188}, .u = {-49.603639579265085, 60.0}, .tolerance = {5.699147894600786e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 30.3, .x = {-0.0001612317382896594, 0.000268719563816099, -0.0001074878255264396, -0.0003224634765793188}, .u = {105.52063895872237, -60.0}, .tolerance = {5.699272055281144e-10, 0.0}, .status = PTC_SATURATED, .axes = {PTC_HOLD, PTC_SATURATED}},
        {.t = 30.3, .x = {0.0004299513021057584, -0.0007165855035095973, 0.00028663420140383894, 0.0008599026042115168}, .u = {-120.0, 60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 30.3, .x = {-0.0004299513021057584, 0.0007165855035095973, -0.00028663420140383894, -0.0008599026042115168}, .u = {120.0, -60.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 19.900000000000002, .x = {-1.0, 1.0, -1.0, -1.7976931348623157e308}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const barrier_arm_selftest_session *session = &barrier_arm_selftest_sessions[i];
        barrier_arm self;
        ptc_status status = barrier_arm_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = barrier_arm_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += barrier_arm_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t barrier_arm_selftest_refuse(void)
{
    static const barrier_arm_params refused[3] = {
        {.t0 = (double)NAN},
        {.t0 = (double)INFINITY},
        {.t0 = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const barrier_arm_selftest_session *session = &barrier_arm_selftest_sessions[0];
    const barrier_arm_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {16.01150216023978, -2.0627175639978512}, .tolerance = {7.261815536464603e-12, 3.2488906105687415e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    barrier_arm self;

    if (barrier_arm_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (barrier_arm_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (barrier_arm_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += barrier_arm_selftest_check(&self, &call);
    if (barrier_arm_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (barrier_arm_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (barrier_arm_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0; u is lost for the next one. */
static uint32_t barrier_arm_selftest_refused(ptc_status status, double u[2])
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
static uint32_t barrier_arm_selftest_pointers(void)
{
    const barrier_arm_selftest_session *session = &barrier_arm_selftest_sessions[0];
    const barrier_arm_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {16.01150216023978, -2.0627175639978512}, .tolerance = {7.261815536464603e-12, 3.2488906105687415e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2];
    ptc_status status;
    barrier_arm self;

    if (barrier_arm_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = barrier_arm_step(NULL, call.t, call.x, u, axes);
    failures += barrier_arm_selftest_refused(status, u);
    status = barrier_arm_step(&self, call.t, NULL, u, axes);
    failures += barrier_arm_selftest_refused(status, u);
    status = barrier_arm_step(&self, call.t, call.x, u, NULL);
    failures += barrier_arm_selftest_refused(status, u);
    status = barrier_arm_step(&self, call.t, call.x, NULL, axes);
    if (status != PTC_E_INPUT) {
        failures++;
    }
    return failures;
}

uint32_t barrier_arm_selftest(void)
{
    uint32_t failures = barrier_arm_selftest_run();

    failures += barrier_arm_selftest_refuse();
    failures += barrier_arm_selftest_pointers();
    return failures;
}
