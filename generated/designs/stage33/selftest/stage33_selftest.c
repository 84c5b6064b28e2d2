/* Self-test of the prescribed-time controller stage33: see stage33_selftest.h. DO NOT EDIT. */
#include "stage33_selftest.h"
#include "stage33.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage33_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[3][2]; /* what is measured */
    ptc_status status;
    float u[3];
    ptc_status axes[3];
} stage33_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage33_selftest_session {
    stage33_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage33_selftest_session;

static const stage33_selftest_session stage33_selftest_sessions[3] = {
    {.params = {.size = 0.0f}, .first = 0U, .count = 72U},
    {.params = {.size = 0.0f}, .first = 72U, .count = 2U},
    {.params = {.size = 0.0f}, .first = 74U, .count = 6U},
};

static const stage33_selftest_call stage33_selftest_calls[80] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.75f, 0.25f}, {-0.25f, -0.75f}, {-1.25f, -1.75f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.7008333f, 0.2336111f}, {-0.2336111f, -0.7008333f}, {-1.1680555f, -1.6352777f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.6533333f, 0.21777777f}, {-0.21777777f, -0.6533333f}, {-1.0888889f, -1.5244445f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(float)NAN, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, (float)NAN}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {(float)NAN, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, (float)NAN}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {(float)NAN, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, (float)NAN}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(float)INFINITY, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, (float)INFINITY}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {(float)INFINITY, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, (float)INFINITY}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {(float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, (float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{-(float)INFINITY, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, -(float)INFINITY}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {-(float)INFINITY, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, -(float)INFINITY}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {-(float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, -(float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {{0.6075f, 0.2025f}, {-0.2025f, -0.6075f}, {-1.0125f, -1.4175f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.44083333f, 0.14694445f}, {-0.14694445f, -0.44083333f}, {-0.7347222f, -1.0286111f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {{0.30083334f, 0.10027778f}, {-0.10027778f, -0.30083334f}, {-0.5013889f, -0.7019445f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {{0.24083333f, 0.08027778f}, {-0.08027778f, -0.24083333f}, {-0.40138888f, -0.5619444f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {{0.21333334f, 0.07111111f}, {-0.07111111f, -0.21333334f}, {-0.35555556f, -0.4977778f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {{0.1875f, 0.0625f}, {-0.0625f, -0.1875f}, {-0.3125f, -0.4375f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {{0.16333333f, 0.054444443f}, {-0.054444443f, -0.16333333f}, {-0.27222222f, -0.38111112f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {{0.053333335f, 0.017777778f}, {-0.017777778f, -0.053333335f}, {-0.08888889f, -0.12444445f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {{0.013333334f, 0.0044444446f}, {-0.0044444446f, -0.013333334f}, {-0.022222223f, -0.031111112f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {{0.0033333334f, 0.0011111111f}, {-0.0011111111f, -0.0033333334f}, {-0.0055555557f, -0.007777778f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {{0.00083333335f, 0.00027777778f}, {-0.00027777778f, -0.00083333335f}, {-0.0013888889f, -0.0019444445f}}, .status = PTC_SATURATED, .u = {1.0f, 1.451389f, -3.0f}, .axes = {PTC_SATURATED, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {1.0f, 0.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {1.0f, 0.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {4.3368087e-11f, 0.0f, -3.0f}, .axes = {PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {1.0842022e-11f, 0.0f, -3.0f}, .axes = {PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {{0.75f, 0.25f}, {-0.25f, -0.75f}, {-1.25f, -1.75f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {{0.7008333f, 0.2336111f}, {-0.2336111f, -0.7008333f}, {-1.1680555f, -1.6352777f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.6533333f, 0.21777777f}, {-0.21777777f, -0.6533333f}, {-1.0888889f, -1.5244445f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(float)NAN, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, (float)NAN}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {(float)NAN, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, (float)NAN}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {(float)NAN, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, (float)NAN}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(float)INFINITY, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, (float)INFINITY}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {(float)INFINITY, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, (float)INFINITY}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {(float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, (float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{-(float)INFINITY, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, -(float)INFINITY}, {0.5f, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {-(float)INFINITY, 0.5f}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, -(float)INFINITY}, {0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {-(float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, -(float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.6075f, 0.2025f}, {-0.2025f, -0.6075f}, {-1.0125f, -1.4175f}}, .status = PTC_SATURATED, .u = {-1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {{0.44083333f, 0.14694445f}, {-0.14694445f, -0.44083333f}, {-0.7347222f, -1.0286111f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {{0.30083334f, 0.10027778f}, {-0.10027778f, -0.30083334f}, {-0.5013889f, -0.7019445f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {{0.24083333f, 0.08027778f}, {-0.08027778f, -0.24083333f}, {-0.40138888f, -0.5619444f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {{0.21333334f, 0.07111111f}, {-0.07111111f, -0.21333334f}, {-0.35555556f, -0.4977778f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {{0.1875f, 0.0625f}, {-0.0625f, -0.1875f}, {-0.3125f, -0.4375f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {{0.16333333f, 0.054444443f}, {-0.054444443f, -0.16333333f}, {-0.27222222f, -0.38111112f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {{0.053333335f, 0.017777778f}, {-0.017777778f, -0.053333335f}, {-0.08888889f, -0.12444445f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {{0.013333334f, 0.0044444446f}, {-0.0044444446f, -0.013333334f}, {-0.022222223f, -0.031111112f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {{0.0033333334f, 0.0011111111f}, {-0.0011111111f, -0.0033333334f}, {-0.0055555557f, -0.007777778f}}, .status = PTC_SATURATED, .u = {1.0f, 2.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {{0.00083333335f, 0.00027777778f}, {-0.00027777778f, -0.00083333335f}, {-0.0013888889f, -0.0019444445f}}, .status = PTC_SATURATED, .u = {1.0f, 1.451389f, -3.0f}, .axes = {PTC_SATURATED, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {1.0f, 0.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {1.0f, 0.0f, -3.0f}, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {4.3368087e-11f, 0.0f, -3.0f}, .axes = {PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {{0.0f, 0.0f}, {-0.0f, -0.0f}, {-0.0f, -0.0f}}, .status = PTC_SATURATED, .u = {1.0842022e-11f, 0.0f, -3.0f}, .axes = {PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{-0.6358609f, -0.9782226f}, {0.4229818f, -0.39332882f}, {0.87548417f, 0.8248544f}}, .status = PTC_SATURATED, .u = {1.0f, -2.0f, 3.0f}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {{-2.664828e38f, 1.4963084e38f}, {-2.1127146e38f, 2.5243148e38f}, {-1.8897486e38f, -2.6037574e38f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 15U, .y = {{-0.00075690565f, 0.00037241096f}, {-0.00095807086f, -0.0005346084f}, {0.0005767425f, 0.00088875555f}}, .status = PTC_SATURATED, .u = {1.0f, 0.6801772f, -3.0f}, .axes = {PTC_SATURATED, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967291U, .y = {{0.0005677f, -0.0004630992f}, {0.00084425835f, -0.0003714625f}, {0.0008061908f, 0.00046815476f}}, .status = PTC_SATURATED, .u = {1.0f, -0.04878409f, -0.9793273f}, .axes = {PTC_SATURATED, PTC_OK, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 16U, .y = {{-1.0f, -1.5822332e38f}, {0.5f, -9.93876e31f}, {1.666623e38f, -0.00026344843f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 21U, .y = {{-1.0f, 0.0f}, {2.852286e32f, 574.6236f}, {-1.3059921e38f, -1.876849e32f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967290U, .y = {{0.5f, 3.2823238e38f}, {0.0f, -0.0f}, {0.0f, 2.2421276e32f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {{-1.0f, 2.0f}, {-1.606556e38f, -0.0f}, {-750.27246f, -0.79377645f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_E_RANGE, PTC_HOLD}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage33_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage33_selftest_check(stage33 *self, const stage33_selftest_call *call)
{
    uint32_t failures = 0U;
    float u[3] = {12345.0f, 12345.0f, 12345.0f};
    ptc_status axes[3] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage33_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage33_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage33_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage33_selftest_calls_of(stage33 *self, const stage33_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage33_selftest_check(self, &stage33_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage33_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage33_selftest_session *session = &stage33_selftest_sessions[i];
        stage33 self;

        if (stage33_init(&self, &session->params) == PTC_OK) {
            failures += stage33_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage33_selftest_refuse(void)
{
    static const stage33_params refused[5] = {
        {.size = (float)NAN},
        {.size = (float)INFINITY},
        {.size = -(float)INFINITY},
        {.size = 3.4028235e38f},
        {.size = -3.4028235e38f},
    };
    const stage33_selftest_session *session = &stage33_selftest_sessions[0];
    uint32_t failures = 0U;
    stage33 self;

    if (stage33_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 5U; i++) {
        if (stage33_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage33_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage33_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage33_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage33_selftest_pointers(void)
{
    const stage33_selftest_session *session = &stage33_selftest_sessions[0];
    const stage33_selftest_call *call = &stage33_selftest_calls[0];
    uint32_t failures = 0U;
    float u[3] = {12345.0f, 12345.0f, 12345.0f};
    ptc_status axes[3] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};
    stage33 self;

    if (stage33_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage33_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage33_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage33_selftest_differs(u[i], 0.0f);
        u[i] = 12345.0f;
    }
    if (stage33_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage33_selftest_differs(u[i], 0.0f);
        u[i] = 12345.0f;
    }
    if (stage33_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage33_selftest_differs(u[i], 0.0f);
    }
    if (stage33_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage33_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage33_selftest(void)
{
    uint32_t failures = stage33_selftest_run();

    failures += stage33_selftest_refuse();
    failures += stage33_selftest_pointers();
    return failures;
}
