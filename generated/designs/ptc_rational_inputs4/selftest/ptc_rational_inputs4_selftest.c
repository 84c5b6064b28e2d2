/* Self-test of the prescribed-time controller ptc_rational_inputs4: see ptc_rational_inputs4_selftest.h. DO NOT EDIT. */
#include "ptc_rational_inputs4_selftest.h"
#include "ptc_rational_inputs4.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct ptc_rational_inputs4_selftest_call {
    double t;
    double x[4];
    double u[4];
    double tolerance[4];
    ptc_status axes[4];
    ptc_status status;
} ptc_rational_inputs4_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct ptc_rational_inputs4_selftest_session {
    ptc_rational_inputs4_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} ptc_rational_inputs4_selftest_session;

static const ptc_rational_inputs4_selftest_session ptc_rational_inputs4_selftest_sessions[11] = {
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 2e-13, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 36U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 36U, .count = 10U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25}, .t0 = 1000.1, .is_armed_again = 1U, .first = 46U, .count = 4U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 4.248116531155197, .a = 0.75, .k = {1.5}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 50U, .count = 21U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {0.0}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 71U, .count = 1U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 72U, .count = 1U},
    {.params = {.tau = 8e-150, .t0 = -8e-150, .eps = 1e-150, .u_max = (double)INFINITY, .a = 0.75, .k = {0.0}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 73U, .count = 1U},
    {.params = {.tau = 1e150, .t0 = -1e150, .eps = 1e-150, .u_max = 1.0, .a = 0.75, .k = {0.0}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 74U, .count = 1U},
    {.params = {.tau = 3.0, .t0 = 1.738759194615119e179, .eps = 0.1875, .u_max = 1.3843635024616395e22, .a = 1e150, .k = {1.5}, .m = 1.25}, .t0 = 0.0, .is_armed_again = 0U, .first = 75U, .count = 1U},
    {.params = {.tau = 3.0, .t0 = -1.7976931348623157e308, .eps = 0.1875, .u_max = 1.7976931348623157e308, .a = 3.0576573464773697e30, .k = {1.5}, .m = -1.7976931348623157e308}, .t0 = 0.0, .is_armed_again = 0U, .first = 76U, .count = 1U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 2.601902636035274e-199, .a = 1e150, .k = {-3.0}, .m = 5.763320708496355e-103}, .t0 = 0.0, .is_armed_again = 0U, .first = 77U, .count = 1U},
};

/* The failures of what was returned for each input, and of the status of all. */
static uint32_t ptc_rational_inputs4_selftest_differs(const ptc_rational_inputs4_selftest_call *call, ptc_status status, const double u[4], const ptc_status axes[4])
{
    uint32_t failures = 0U;

    if (status != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        if (!((axes[i] == call->axes[i]) && (fabs(u[i] - call->u[i]) <= call->tolerance[i]))) {
            failures++;
        }
    }
    return failures;
}

/* The failures of one call. */
static uint32_t ptc_rational_inputs4_selftest_check(const ptc_rational_inputs4 *self, const ptc_rational_inputs4_selftest_call *call)
{
    double u[4] = {12345.0, 12345.0, 12345.0, 12345.0};
    ptc_status axes[4] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};
    ptc_status status = ptc_rational_inputs4_step(self, call->t, call->x, u, axes);

    return ptc_rational_inputs4_selftest_differs(call, status, u, axes);
}

/* Every session with its calls. */
static uint32_t ptc_rational_inputs4_selftest_run(void)
{
    static const ptc_rational_inputs4_selftest_call calls[78] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.8868209215235894, -0.14423364923355814, -0.19022962408912378, -0.632373284897608}, .tolerance = {4.3734865422885405e-14, 1.463535887558699e-14, 1.0851202017298545e-14, 2.522263556968441e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.8, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-1.8778064526431006, 0.17358948246487682, 0.5613442341191079, 1.030866235930109}, .tolerance = {7.705358406336514e-14, 2.2376501233857885e-14, 2.4965426189570413e-14, 4.323031077599747e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.5, .x = {0.75, -1.25, 0.5, 1.5}, .u = {6.769088238378902, -1.0383530749586896, -1.1813721431269533, -4.25752933643103}, .tolerance = {2.7550215242150734e-13, 9.783906042806804e-14, 7.191154716824592e-14, 1.6469882613156005e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.1, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-92.97507508294015, 10.871204439281964, 30.724938530462662, 54.982842796273324}, .tolerance = {3.858662035831557e-12, 1.2106388330924898e-12, 1.3510009819122136e-12, 2.254217471793591e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.28, .x = {0.75, -1.25, 0.5, 1.5}, .u = {11204.085087823463, -1703.058545615981, -1887.8919530258177, -6905.001013148138}, .tolerance = {4.4146108776050443e-10, 1.5848202808711232e-10, 1.1630463999521948e-10, 2.656675901456971e-10}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.2998, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-92746088.20087488, 10891236.926937466, 30709541.71977459, 54928482.9777068}, .tolerance = {3.850053862212765e-6, 1.209769343257751e-6, 1.3500362002279645e-6, 2.251005031394521e-6}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.299998, .x = {0.75, -1.25, 0.5, 1.5}, .u = {1120431869874.7278, -170308462042.51544, -188789051244.92468, -690505914576.3552}, .tolerance = {0.0441461499044107, 0.015848324105201577, 0.011630541933489742, 0.026566893440302785}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.29999998, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-9274608755481248.0, 1089123689799253.4, 3070954156627823.0, 5492848267633582.0}, .tolerance = {385.00538362910504, 120.9769336947978, 135.00361931921256, 225.10050180594018}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.2999999998, .x = {0.75, -1.25, 0.5, 1.5}, .u = {1.1204298185762326e20, -1.7030815023997587e19, -1.8878870560789594e19, -6.905046503907518e19}, .tolerance = {4414606.908116465, 1584829.508992041, 1163052.064016915, 2656684.480134963}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.299999999998, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-9.275534051237007e23, 1.0892323479167262e23, 3.071260535141696e23, 5.4933962701772e23}, .tolerance = {38504379428.9523, 12098900314.659286, 13501708816.50972, 22512295930.732178}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.1, .x = {1.0, 0.0, 0.0, 0.0}, .u = {0.1714677640603567, -0.0, -0.925925925925926, -0.2743484224965707}, .tolerance = {1.3310948561785402e-14, 0.0, 1.872411537493059e-14, 1.581054924892523e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.1, .x = {0.0, 1.0, 0.0, 0.0}, .u = {-1.6460905349794241, -0.0, -0.0, 0.41152263374485604}, .tolerance = {4.5480579444168646e-14, 0.0, 0.0, 1.960059753593928e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.1, .x = {0.0, 0.0, 1.0, 0.0}, .u = {0.0, -0.925925925925926, 0.0, -0.0}, .tolerance = {0.0, 2.798337463418985e-14, 0.0, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.1, .x = {0.0, 0.0, 0.0, 1.0}, .u = {0.5144032921810701, 0.0, -0.0, -0.8230452674897121}, .tolerance = {2.45007469199241e-14, 0.0, 0.0, 2.2740289722084323e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.1999999999999997, .x = {1.0, 0.0, 0.0, 0.0}, .u = {24.691358024691233, -0.0, -133.33333333333266, -39.50617283950597}, .tolerance = {1.9167765928970876e-12, 0.0, 2.6962726139899907e-12, 2.2767190918452213e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.1999999999999997, .x = {0.0, 1.0, 0.0, 0.0}, .u = {-237.03703703703582, -0.0, -0.0, 59.259259259258954}, .tolerance = {6.5492034399602496e-12, 0.0, 0.0, 2.822486045175242e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.1999999999999997, .x = {0.0, 0.0, 1.0, 0.0}, .u = {0.0, -133.33333333333266, 0.0, -0.0}, .tolerance = {0.0, 4.029605947323318e-12, 0.0, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.1999999999999997, .x = {0.0, 0.0, 0.0, 1.0}, .u = {74.07407407407369, 0.0, -0.0, -118.51851851851791}, .tolerance = {3.528107556469052e-12, 0.0, 0.0, 3.2746017199801248e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.7, .x = {0.0, 0.0, 1.0, 0.0}, .u = {0.0, -3.7037037037037033, 0.0, -0.0}, .tolerance = {0.0, 1.1193349853675939e-13, 0.0, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.7, .x = {0.0, 0.0, 0.0, 1.0}, .u = {2.05761316872428, 0.0, -0.0, -3.2921810699588474}, .tolerance = {9.800298767969639e-14, 0.0, 0.0, 9.096115888833725e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {(double)NAN, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, (double)NAN, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, (double)NAN, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, 0.5, (double)NAN}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {(double)INFINITY, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, (double)INFINITY, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, (double)INFINITY, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, 0.5, (double)INFINITY}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {-(double)INFINITY, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -(double)INFINITY, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, -(double)INFINITY, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.75, -1.25, 0.5, -(double)INFINITY}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -0.7, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 2.05, .x = {0.75, -1.25, 0.5, 1.5}, .u = {71.47402872378724, -10.873666757935121, -12.083939852543063, -44.134245903298606}, .tolerance = {2.8249423094063445e-12, 1.0130797775053585e-12, 7.435753438286661e-13, 1.69893692231219e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.05, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-59.58648341301214, 6.950359138367088, 19.669503516870634, 35.20858894383976}, .tolerance = {2.4726426485318968e-12, 7.751218698320844e-13, 8.64987950176763e-13, 1.4438556616468678e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.2375, .x = {0.75, -1.25, 0.5, 1.5}, .u = {286.59694774021017, -43.572891470168514, -48.33143769164084, -176.7113815022352}, .tolerance = {1.1301003091070238e-11, 4.055958005710381e-12, 2.9766393950633136e-12, 6.799780462860786e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.2375, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-237.65897231929407, 27.861534076579666, 78.63182358936116, 140.6712761568183}, .tolerance = {9.86474604746338e-12, 3.0978790072209018e-12, 3.4570574527658193e-12, 5.765785315762704e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {286.59694774021017, -43.572891470168514, -48.33143769164084, -176.7113815022352}, .tolerance = {1.1301003091070238e-11, 4.055958005710381e-12, 2.9766393950633136e-12, 6.799780462860786e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-237.65897231929407, 27.861534076579666, 78.63182358936116, 140.6712761568183}, .tolerance = {9.86474604746338e-12, 3.0978790072209018e-12, 3.4570574527658193e-12, 5.765785315762704e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.8, .x = {0.75, -1.25, 0.5, 1.5}, .u = {286.59694774021017, -43.572891470168514, -48.33143769164084, -176.7113815022352}, .tolerance = {1.1301003091070238e-11, 4.055958005710381e-12, 2.9766393950633136e-12, 6.799780462860786e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.8, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-237.65897231929407, 27.861534076579666, 78.63182358936116, 140.6712761568183}, .tolerance = {9.86474604746338e-12, 3.0978790072209018e-12, 3.4570574527658193e-12, 5.765785315762704e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 22.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {286.59694774021017, -43.572891470168514, -48.33143769164084, -176.7113815022352}, .tolerance = {1.1301003091070238e-11, 4.055958005710381e-12, 2.9766393950633136e-12, 6.799780462860786e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 22.3, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-237.65897231929407, 27.861534076579666, 78.63182358936116, 140.6712761568183}, .tolerance = {9.86474604746338e-12, 3.0978790072209018e-12, 3.4570574527658193e-12, 5.765785315762704e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-1.1564479906384866, 0.08887986176609905, 0.3224922430847134, 0.6036447020812379}, .tolerance = {4.710872075750845e-14, 1.296718412638004e-14, 1.4465144639730494e-14, 2.5722493890111564e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1001.5, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-10.534107996697687, 1.1901049308501181, 3.427568126531582, 6.157524642116101}, .tolerance = {4.36391943733613e-13, 1.3528830652358184e-13, 1.509688047876381e-13, 2.5332411340660936e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1002.1, .x = {-0.75, 1.25, -0.5, -1.5}, .u = {-237.65897231929407, 27.861534076579666, 78.63182358936116, 140.6712761568183}, .tolerance = {9.86474604746338e-12, 3.0978790072209018e-12, 3.4570574527658193e-12, 5.765785315762704e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.3, .x = {0.1875, -0.3125, 0.125, 0.375}, .u = {1.03231868063823, -0.1738977141865898, -0.2409719836506005, -0.6443752318931795}, .tolerance = {3.5948014026609444e-14, 8.737138766939581e-15, 7.182018725033826e-15, 2.233709180576397e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.3, .x = {1.125, -1.875, 0.75, 2.25}, .u = {4.248116531155197, -0.9273973820057652, -0.7782488153814463, -4.066760279905888}, .tolerance = {0.0, 1.000090810433451e-13, 7.725105144674481e-14, 1.650513963547458e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.3, .x = {-1.125, 1.875, -0.75, -2.25}, .u = {-4.248116531155197, 0.5195585745046543, 2.1127492501144496, 3.1119349319888525}, .tolerance = {0.0, 7.679802456149547e-14, 9.47400232818207e-14, 1.4477544571758715e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.3, .x = {3.0, -5.0, 2.0, 6.0}, .u = {4.248116531155197, -1.773548150645522, 2.01925590474276, -4.248116531155197}, .tolerance = {0.0, 2.2011623213972822e-13, 3.553154116411414e-13, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK, PTC_OK, PTC_SATURATED}},
        {.t = 1.3, .x = {-3.0, 5.0, -2.0, -6.0}, .u = {-4.248116531155197, 0.7720024178222922, 4.248116531155197, 4.248116531155197}, .tolerance = {0.0, 1.625158420207649e-13, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_OK, PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.3, .x = {75.0, -125.0, 50.0, 150.0}, .u = {-4.248116531155197, 4.248116531155197, -4.248116531155197, -4.248116531155197}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.3, .x = {-75.0, 125.0, -50.0, -150.0}, .u = {-4.248116531155197, -4.248116531155197, 4.248116531155197, -3.5030612736734534}, .tolerance = {0.0, 0.0, 0.0, 4.532546553720027e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED, PTC_OK}},
        {.t = 2.3, .x = {0.0027792405183380314, -0.004632067530563386, 0.0018528270122253542, 0.005558481036676063}, .u = {0.9665945756254987, -0.15826456178401918, -0.23703716469305272, -0.5975561260767595}, .tolerance = {3.1993413343368006e-14, 4.830676788943294e-15, 4.826491591324382e-15, 2.0033450044825747e-14}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {0.01667544311002819, -0.027792405183380314, 0.011116962073352126, 0.03335088622005638}, .u = {4.248116531155197, -0.9541659226331842, -1.4184946790313477, -3.593117523785206}, .tolerance = {0.0, 3.0558871848065307e-14, 2.9877419570793156e-14, 1.2071313278186694e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {-0.01667544311002819, 0.027792405183380314, -0.011116962073352126, -0.03335088622005638}, .u = {-4.248116531155197, 0.9428416541257812, 1.4274832375553335, 3.5744244027379186}, .tolerance = {0.0, 3.0319180477808973e-14, 2.9975776835015755e-14, 1.2028997579242047e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.3, .x = {0.0444678482934085, -0.07411308048901417, 0.029645232195605668, 0.088935696586817}, .u = {4.248116531155197, -2.5672084622304365, -3.762860504685713, -4.248116531155197}, .tolerance = {0.0, 8.993699670816754e-14, 8.457220476691189e-14, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
        {.t = 2.3, .x = {-0.0444678482934085, 0.07411308048901417, -0.029645232195605668, -0.088935696586817}, .u = {-4.248116531155197, 2.486810375765636, 3.826989962812441, 4.248116531155197}, .tolerance = {0.0, 8.810660228459149e-14, 8.53503746950481e-14, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
        {.t = 2.3, .x = {1.1116962073352126, -1.8528270122253543, 0.7411308048901417, 2.223392414670425}, .u = {4.248116531155197, -4.248116531155197, -4.248116531155197, -4.248116531155197}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 2.3, .x = {-1.1116962073352126, 1.8528270122253543, -0.7411308048901417, -2.223392414670425}, .u = {-4.248116531155197, 4.248116531155197, 4.248116531155197, 4.248116531155197}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 3.3, .x = {0.0027792405183380314, -0.004632067530563386, 0.0018528270122253542, 0.005558481036676063}, .u = {0.9665945756254987, -0.15826456178401918, -0.23703716469305272, -0.5975561260767595}, .tolerance = {3.1993413343368006e-14, 4.830676788943294e-15, 4.826491591324382e-15, 2.0033450044825747e-14}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 3.3, .x = {0.01667544311002819, -0.027792405183380314, 0.011116962073352126, 0.03335088622005638}, .u = {4.248116531155197, -0.9541659226331842, -1.4184946790313477, -3.593117523785206}, .tolerance = {0.0, 3.0558871848065307e-14, 2.9877419570793156e-14, 1.2071313278186694e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 3.3, .x = {-0.01667544311002819, 0.027792405183380314, -0.011116962073352126, -0.03335088622005638}, .u = {-4.248116531155197, 0.9428416541257812, 1.4274832375553335, 3.5744244027379186}, .tolerance = {0.0, 3.0319180477808973e-14, 2.9975776835015755e-14, 1.2028997579242047e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 3.3, .x = {0.0444678482934085, -0.07411308048901417, 0.029645232195605668, 0.088935696586817}, .u = {4.248116531155197, -2.5672084622304365, -3.762860504685713, -4.248116531155197}, .tolerance = {0.0, 8.993699670816754e-14, 8.457220476691189e-14, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
        {.t = 3.3, .x = {-0.0444678482934085, 0.07411308048901417, -0.029645232195605668, -0.088935696586817}, .u = {-4.248116531155197, 2.486810375765636, 3.826989962812441, 4.248116531155197}, .tolerance = {0.0, 8.810660228459149e-14, 8.53503746950481e-14, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
        {.t = 3.3, .x = {1.1116962073352126, -1.8528270122253543, 0.7411308048901417, 2.223392414670425}, .u = {4.248116531155197, -4.248116531155197, -4.248116531155197, -4.248116531155197}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 3.3, .x = {-1.1116962073352126, 1.8528270122253543, -0.7411308048901417, -2.223392414670425}, .u = {-4.248116531155197, 4.248116531155197, 4.248116531155197, 4.248116531155197}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {-0.23361094835361304, 0.026074812809324027, -0.0014405728438229026, 0.05813262968018647}, .tolerance = {9.773151874457923e-15, 2.2839774613677075e-15, 8.698453060088563e-16, 3.690059483217893e-15}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 2.26, .x = {-1.0, 1.0, -1.0, -1.7976931348623157e308}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 0.0, .x = {-1.0, 1.0, 1.3482698511467367e308, 0.0}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = -1.9999999999999967e148, .x = {1.0, 1.0, -1.7976931348623157e308, -1.7976931348623157e308}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.738759194615119e179, .x = {0.0, -1.0, 1.3482698511467367e308, 1.3482698511467367e308}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_OK, PTC_OK}},
        {.t = -1.7976931348623157e308, .x = {-1.7976931348623157e308, 1.3482698511467367e308, 0.0, 1.7976931348623157e308}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE, PTC_OK}},
        {.t = 2.3, .x = {-1.7976931348623157e308, -1.0, -1.0, -1.7976931348623157e308}, .u = {0.0, 0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_HOLD, PTC_HOLD}},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 11U; i++) {
        const ptc_rational_inputs4_selftest_session *session = &ptc_rational_inputs4_selftest_sessions[i];
        ptc_rational_inputs4 self;
        ptc_status status = ptc_rational_inputs4_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = ptc_rational_inputs4_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += ptc_rational_inputs4_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t ptc_rational_inputs4_selftest_refuse(void)
{
    static const ptc_rational_inputs4_params refused[35] = {
        {.tau = (double)NAN, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = (double)INFINITY, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 0.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = -1.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 7.5e-151, .t0 = 0.3, .eps = 4.6875e-152, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 1.25e150, .t0 = 0.3, .eps = 7.8125e148, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = (double)NAN, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = (double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = -(double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)NAN, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.0, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = -1.0, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 7.5e-151, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 2.0, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 4.0, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)NAN, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 0.0, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -1.0, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -(double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = (double)NAN, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = (double)INFINITY, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.0, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = -1.0, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 7.5e-151, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 1.25e150, .k = {1.5}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {(double)NAN}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {(double)INFINITY}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {-(double)INFINITY}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = (double)NAN},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = -(double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1e-323}, .m = 1.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.5}, .m = 1e-323},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .a = 0.75, .k = {1.7976931348623157e308}, .m = 1.25},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const ptc_rational_inputs4_selftest_session *session = &ptc_rational_inputs4_selftest_sessions[0];
    const ptc_rational_inputs4_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.8868209215235894, -0.14423364923355814, -0.19022962408912378, -0.632373284897608}, .tolerance = {4.3734865422885405e-14, 1.463535887558699e-14, 1.0851202017298545e-14, 2.522263556968441e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    ptc_rational_inputs4 self;

    if (ptc_rational_inputs4_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 35U; i++) {
        if (ptc_rational_inputs4_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (ptc_rational_inputs4_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += ptc_rational_inputs4_selftest_check(&self, &call);
    if (ptc_rational_inputs4_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (ptc_rational_inputs4_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (ptc_rational_inputs4_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    /* A deadline beyond the range, which no legal parameters need to reach. */
    self.tau = 1.7976931348623157e308;
    if (ptc_rational_inputs4_arm(&self, 1.7976931348623157e308) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0; u is lost for the next one. */
static uint32_t ptc_rational_inputs4_selftest_refused(ptc_status status, double u[4])
{
    uint32_t failures = 0U;

    if (status != PTC_E_INPUT) {
        failures = 1U;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        if (!(fabs(u[i]) <= 0.0)) {
            failures = 1U;
        }
        u[i] = 12345.0;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t ptc_rational_inputs4_selftest_pointers(void)
{
    const ptc_rational_inputs4_selftest_session *session = &ptc_rational_inputs4_selftest_sessions[0];
    const ptc_rational_inputs4_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5, 1.5}, .u = {0.8868209215235894, -0.14423364923355814, -0.19022962408912378, -0.632373284897608}, .tolerance = {4.3734865422885405e-14, 1.463535887558699e-14, 1.0851202017298545e-14, 2.522263556968441e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    double u[4] = {12345.0, 12345.0, 12345.0, 12345.0};
    ptc_status axes[4];
    ptc_status status;
    ptc_rational_inputs4 self;

    if (ptc_rational_inputs4_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = ptc_rational_inputs4_step(NULL, call.t, call.x, u, axes);
    failures += ptc_rational_inputs4_selftest_refused(status, u);
    status = ptc_rational_inputs4_step(&self, call.t, NULL, u, axes);
    failures += ptc_rational_inputs4_selftest_refused(status, u);
    status = ptc_rational_inputs4_step(&self, call.t, call.x, u, NULL);
    failures += ptc_rational_inputs4_selftest_refused(status, u);
    status = ptc_rational_inputs4_step(&self, call.t, call.x, NULL, axes);
    if (status != PTC_E_INPUT) {
        failures++;
    }
    return failures;
}

uint32_t ptc_rational_inputs4_selftest(void)
{
    uint32_t failures = ptc_rational_inputs4_selftest_run();

    failures += ptc_rational_inputs4_selftest_refuse();
    failures += ptc_rational_inputs4_selftest_pointers();
    return failures;
}
