/* Self-test of the prescribed-time controller stage30: see stage30_selftest.h. DO NOT EDIT. */
#include "stage30_selftest.h"
#include "stage30.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage30_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[2][3]; /* what is measured */
    ptc_status status;
    float u[2];
    ptc_status axes[2];
} stage30_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage30_selftest_session {
    stage30_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage30_selftest_session;

static const stage30_selftest_session stage30_selftest_sessions[4] = {
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f}, .first = 0U, .count = 72U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f}, .first = 72U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f}, .first = 73U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = 1.0f, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f}, .first = 75U, .count = 2U},
};

static const stage30_selftest_call stage30_selftest_calls[77] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.75f, 0.25f, -0.25f}, {-0.75f, -1.25f, -1.75f}}, .status = PTC_OK, .u = {-23.213058f, 43.94445f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.72520834f, 0.24173611f, -0.24173611f}, {-0.72520834f, -1.2086805f, -1.6921527f}}, .status = PTC_OK, .u = {-23.592072f, 44.22209f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.7008333f, 0.2336111f, -0.2336111f}, {-0.7008333f, -1.1680555f, -1.6352777f}}, .status = PTC_OK, .u = {-23.984362f, 44.51319f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(float)NAN, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, (float)NAN, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, (float)NAN}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {(float)NAN, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, (float)NAN, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, (float)NAN}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(float)INFINITY, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, (float)INFINITY, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, (float)INFINITY}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {(float)INFINITY, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, (float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, (float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{-(float)INFINITY, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, -(float)INFINITY, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, -(float)INFINITY}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {-(float)INFINITY, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, -(float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, -(float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {{0.676875f, 0.225625f, -0.225625f}, {-0.676875f, -1.128125f, -1.579375f}}, .status = PTC_OK, .u = {-24.390661f, 44.8185f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {{0.421875f, 0.140625f, -0.140625f}, {-0.421875f, -0.703125f, -0.984375f}}, .status = PTC_OK, .u = {-30.721888f, 49.958202f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {{0.24083333f, 0.08027778f, -0.08027778f}, {-0.24083333f, -0.40138888f, -0.5619444f}}, .status = PTC_OK, .u = {-40.70449f, 58.905876f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {{0.21333334f, 0.07111111f, -0.07111111f}, {-0.21333334f, -0.35555556f, -0.4977778f}}, .status = PTC_OK, .u = {-43.31685f, 61.340767f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {{0.20020834f, 0.06673611f, -0.06673611f}, {-0.20020834f, -0.33368057f, -0.46715277f}}, .status = PTC_OK, .u = {-44.760685f, 62.6977f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {{0.1875f, 0.0625f, -0.0625f}, {-0.1875f, -0.3125f, -0.4375f}}, .status = PTC_OK, .u = {-46.309784f, 64.16127f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {{0.17520833f, 0.058402777f, -0.058402777f}, {-0.17520833f, -0.29201388f, -0.40881944f}}, .status = PTC_OK, .u = {-47.97617f, 65.74367f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {{0.046875f, 0.015625f, -0.015625f}, {-0.046875f, -0.078125f, -0.109375f}}, .status = PTC_OK, .u = {-99.660835f, 116.604256f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {{0.0033333334f, 0.0011111111f, -0.0011111111f}, {-0.0033333334f, -0.0055555557f, -0.007777778f}}, .status = PTC_OK, .u = {-781.97797f, 803.6536f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {{0.00083333335f, 0.00027777778f, -0.00027777778f}, {-0.00083333335f, -0.0013888889f, -0.0019444445f}}, .status = PTC_OK, .u = {-73.56544f, 76.686424f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {{0.00020833334f, 6.9444446e-5f, -6.9444446e-5f}, {-0.00020833334f, -0.00034722223f, -0.00048611112f}}, .status = PTC_HOLD, .u = {-18.39136f, 19.171606f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {{0.75f, 0.25f, -0.25f}, {-0.75f, -1.25f, -1.75f}}, .status = PTC_OK, .u = {-23.213058f, 43.94445f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {{0.72520834f, 0.24173611f, -0.24173611f}, {-0.72520834f, -1.2086805f, -1.6921527f}}, .status = PTC_OK, .u = {-23.592072f, 44.22209f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.7008333f, 0.2336111f, -0.2336111f}, {-0.7008333f, -1.1680555f, -1.6352777f}}, .status = PTC_OK, .u = {-23.984362f, 44.51319f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(float)NAN, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, (float)NAN, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, (float)NAN}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {(float)NAN, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, (float)NAN, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, (float)NAN}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(float)INFINITY, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, (float)INFINITY, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, (float)INFINITY}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {(float)INFINITY, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, (float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, (float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{-(float)INFINITY, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, -(float)INFINITY, 0.5f}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, -(float)INFINITY}, {0.5f, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {-(float)INFINITY, 0.5f, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, -(float)INFINITY, 0.5f}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, -(float)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.676875f, 0.225625f, -0.225625f}, {-0.676875f, -1.128125f, -1.579375f}}, .status = PTC_OK, .u = {-24.390661f, 44.8185f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {{0.421875f, 0.140625f, -0.140625f}, {-0.421875f, -0.703125f, -0.984375f}}, .status = PTC_OK, .u = {-30.721888f, 49.958202f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {{0.24083333f, 0.08027778f, -0.08027778f}, {-0.24083333f, -0.40138888f, -0.5619444f}}, .status = PTC_OK, .u = {-40.70449f, 58.905876f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {{0.21333334f, 0.07111111f, -0.07111111f}, {-0.21333334f, -0.35555556f, -0.4977778f}}, .status = PTC_OK, .u = {-43.31685f, 61.340767f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {{0.20020834f, 0.06673611f, -0.06673611f}, {-0.20020834f, -0.33368057f, -0.46715277f}}, .status = PTC_OK, .u = {-44.760685f, 62.6977f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {{0.1875f, 0.0625f, -0.0625f}, {-0.1875f, -0.3125f, -0.4375f}}, .status = PTC_OK, .u = {-46.309784f, 64.16127f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {{0.17520833f, 0.058402777f, -0.058402777f}, {-0.17520833f, -0.29201388f, -0.40881944f}}, .status = PTC_OK, .u = {-47.97617f, 65.74367f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {{0.046875f, 0.015625f, -0.015625f}, {-0.046875f, -0.078125f, -0.109375f}}, .status = PTC_OK, .u = {-99.660835f, 116.604256f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {{0.0033333334f, 0.0011111111f, -0.0011111111f}, {-0.0033333334f, -0.0055555557f, -0.007777778f}}, .status = PTC_OK, .u = {-781.97797f, 803.6536f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {{0.00083333335f, 0.00027777778f, -0.00027777778f}, {-0.00083333335f, -0.0013888889f, -0.0019444445f}}, .status = PTC_OK, .u = {-73.56544f, 76.686424f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {{0.00020833334f, 6.9444446e-5f, -6.9444446e-5f}, {-0.00020833334f, -0.00034722223f, -0.00048611112f}}, .status = PTC_HOLD, .u = {-18.39136f, 19.171606f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {{0.0f, 0.0f, -0.0f}, {-0.0f, -0.0f, -0.0f}}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967290U, .k = 11U, .y = {{3.192984e32f, 2.051861e32f, 3.366554e32f}, {-3.2549664e32f, -1.6552427e32f, -1.0255518e32f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 0U, .k = 32U, .y = {{2.0f, -0.5f, -2.9247332e38f}, {-0.5f, 1.5752364e32f, 0.0f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_OK}},
    {.is_armed = 1U, .start = 0U, .k = 45U, .y = {{2.0f, -833.30994f, 0.0f}, {1.696317e32f, 0.0f, -1.0f}}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{-0.39603972f, 0.8351083f, -0.7838285f}, {-0.7028812f, -0.66822857f, -0.9511729f}}, .status = PTC_SATURATED, .u = {1.0f, 1.0f}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.5398926f, -0.76409155f, -0.3955761f}, {0.33254087f, 0.6737334f, -0.75530386f}}, .status = PTC_SATURATED, .u = {-1.0f, -1.0f}, .axes = {PTC_SATURATED, PTC_SATURATED}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage30_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage30_selftest_check(stage30 *self, const stage30_selftest_call *call)
{
    uint32_t failures = 0U;
    float u[2] = {12345.0f, 12345.0f};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage30_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage30_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage30_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage30_selftest_calls_of(stage30 *self, const stage30_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage30_selftest_check(self, &stage30_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage30_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage30_selftest_session *session = &stage30_selftest_sessions[i];
        stage30 self;

        if (stage30_init(&self, &session->params) == PTC_OK) {
            failures += stage30_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage30_selftest_refuse(void)
{
    static const stage30_params refused[52] = {
        {.samples = 0U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 2U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)NAN, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)INFINITY, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -(float)INFINITY, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.0f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -1.0f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 3.4028235e38f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -3.4028235e38f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-45f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 7.5e-19f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1.25e18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)NAN, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -(float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = 0.0f, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -1.0f, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -3.4028235e38f, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = (float)NAN, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = (float)INFINITY, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -(float)INFINITY, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 0.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 3.4028235e38f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -3.4028235e38f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e-45f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 7.5e-19f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e-18f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.25e18f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)NAN, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)INFINITY, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {-(float)INFINITY, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {3.4028235e38f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {-3.4028235e38f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, (float)NAN, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, (float)INFINITY, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, -(float)INFINITY, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 3.4028235e38f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, -3.4028235e38f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, (float)NAN}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, (float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, -(float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, -3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = (float)NAN},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = (float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = -(float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = -1.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = -3.4028235e38f},
        {.samples = 60U, .h = 0.015625f, .u_max = 3.4028235e38f, .a = 1.0f, .k = {64.0f, -3.4028235e38f, -3.4028235e38f}, .deadbeat = 2.4522263e38f},
        {.samples = 60U, .h = 5.5219978e-11f, .u_max = (float)INFINITY, .a = 1e18f, .k = {-3.4028235e38f, 3.4028235e38f, 6.1398556e30f}, .deadbeat = 3.4028235e38f},
    };
    const stage30_selftest_session *session = &stage30_selftest_sessions[0];
    uint32_t failures = 0U;
    stage30 self;

    if (stage30_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 52U; i++) {
        if (stage30_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage30_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage30_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage30_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage30_selftest_pointers(void)
{
    const stage30_selftest_session *session = &stage30_selftest_sessions[0];
    const stage30_selftest_call *call = &stage30_selftest_calls[0];
    uint32_t failures = 0U;
    float u[2] = {12345.0f, 12345.0f};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    stage30 self;

    if (stage30_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage30_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage30_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage30_selftest_differs(u[i], 0.0f);
        u[i] = 12345.0f;
    }
    if (stage30_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage30_selftest_differs(u[i], 0.0f);
        u[i] = 12345.0f;
    }
    if (stage30_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage30_selftest_differs(u[i], 0.0f);
    }
    if (stage30_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage30_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage30_selftest(void)
{
    uint32_t failures = stage30_selftest_run();

    failures += stage30_selftest_refuse();
    failures += stage30_selftest_pointers();
    return failures;
}
