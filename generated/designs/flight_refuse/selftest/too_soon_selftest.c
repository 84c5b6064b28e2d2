/* Self-test of the prescribed-time controller too_soon: see too_soon_selftest.h. DO NOT EDIT. */
#include "too_soon_selftest.h"
#include "too_soon.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct too_soon_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 soonest, 3 deadline */
    uint32_t samples;
    ptc_status told; /* its status */
    uint32_t found; /* its result */
    uint32_t k;
    float y[3]; /* what is measured */
    ptc_status status;
    float u;
} too_soon_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct too_soon_selftest_session {
    too_soon_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} too_soon_selftest_session;

static const too_soon_selftest_session too_soon_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 54U},
    {.params = {.none = (char)0}, .first = 54U, .count = 3U},
    {.params = {.none = (char)0}, .first = 57U, .count = 53U},
};

static const too_soon_selftest_call too_soon_selftest_calls[110] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f, -0.25f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7400333f, 0.24667777f, -0.24667777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.73013335f, 0.24337777f, -0.24337777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, -(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7203f, 0.2401f, -0.2401f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.42563334f, 0.14187777f, -0.14187777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {0.20803334f, 0.069344446f, -0.069344446f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {0.19763333f, 0.06587778f, -0.06587778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 74U, .y = {0.19253333f, 0.06417778f, -0.06417778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.1875f, 0.0625f, -0.0625f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 76U, .y = {0.18253334f, 0.060844444f, -0.060844444f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 112U, .y = {0.048133332f, 0.016044445f, -0.016044445f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.00053333334f, 0.00017777778f, -0.00017777778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.00013333333f, 4.4444445e-5f, -4.4444445e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {3.3333334e-5f, 1.1111111e-5f, -1.1111111e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f, -0.25f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7400333f, 0.24667777f, -0.24667777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.73013335f, 0.24337777f, -0.24337777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, -(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7203f, 0.2401f, -0.2401f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 34U, .y = {0.42563334f, 0.14187777f, -0.14187777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 68U, .y = {0.20803334f, 0.069344446f, -0.069344446f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 70U, .y = {0.19763333f, 0.06587778f, -0.06587778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {0.19253333f, 0.06417778f, -0.06417778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.1875f, 0.0625f, -0.0625f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {0.18253334f, 0.060844444f, -0.060844444f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 109U, .y = {0.048133332f, 0.016044445f, -0.016044445f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {0.00053333334f, 0.00017777778f, -0.00017777778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {0.00013333333f, 4.4444445e-5f, -4.4444445e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {3.3333334e-5f, 1.1111111e-5f, -1.1111111e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.64230037f, -0.8454974f, -0.70406526f}, .status = PTC_OK, .u = 5.2550616f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.6475592f, -0.37527624f, 0.86151296f}, .status = PTC_SATURATED, .u = 20.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967291U, .y = {1.982879e32f, 1.7438583e32f, 1.6788332e32f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.command = 1U, .samples = 1024U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.086671725f, 0.00018606952f, -0.03697804f}, .status = PTC_OK, .u = 0.05270986f},
    {.command = 2U, .samples = 1024U, .told = PTC_OK, .found = 236U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {0.40514335f, -0.001966038f, 0.05976629f}, .status = PTC_OK, .u = -0.13001177f},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 1026U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.0556211f, -37.46714f, -0.4725417f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 1U, .samples = 1U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.063648395f, 0.08384613f, 0.9188291f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {33.73378f, -0.010477498f, -77.635704f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 2U, .samples = 40U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {3.4028235e38f, -0.00064344896f, 21.230122f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.0008528494f, -0.0008062152f, 3.4028235e38f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {-55.365173f, -0.33593047f, 0.00052386295f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {-0.00016879027f, -6.557109f, -69.461426f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 1U, .samples = 10U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {0.00036904358f, (float)INFINITY, -0.044282276f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.command = 2U, .samples = 1U, .told = PTC_OK, .found = 14U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {3.8856713e-5f, -0.008613044f, -0.00026786444f}, .status = PTC_OK, .u = 0.0052129645f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.55993164f, -0.03725448f, -38.684605f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 2U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.08693747f, 0.03656279f, 31.952244f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.0002491685f, 0.10984567f, 53.728737f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 2U, .samples = 0U, .told = PTC_OK, .found = 602U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {-0.97051597f, -0.0006774817f, -0.09769118f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 2U, .samples = 200U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-49.553467f, (float)INFINITY, -0.29706463f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.command = 1U, .samples = 3U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.62792575f, 3.4028235e38f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.command = 2U, .samples = 1U, .told = PTC_OK, .found = 8U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.00013671248f, -0.00058214384f, -0.0002666347f}, .status = PTC_OK, .u = 0.0006630727f},
    {.command = 2U, .samples = 3000U, .told = PTC_OK, .found = 20991U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-32.006935f, -0.0008350926f, -0.004591817f}, .status = PTC_OK, .u = 3.5620177f},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {-54.90437f, 0.008577145f, 99.8061f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 2U, .samples = 2147483648U, .told = PTC_OK, .found = 31U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {0.0006678056f, -0.054341424f, 0.23030351f}, .status = PTC_OK, .u = -0.27209973f},
    {.command = 1U, .samples = 4294967295U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.5899565f, -84.372154f, -0.042588864f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 2U, .samples = 0U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.08741397f, 3.4028235e38f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.command = 2U, .samples = 40U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.37492698f, 0.5468493f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.command = 2U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {0.00066082383f, 0.8700905f, -0.6397674f}, .status = PTC_OK, .u = 0.19634372f},
    {.command = 1U, .samples = 40U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.9961977f, -25.26053f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {0.404315f, 0.99810654f, 0.0008580999f}, .status = PTC_OK, .u = -0.84882385f},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.09955501f, 0.09005061f, -82.74068f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.00051548565f, 0.31255805f, 0.028224409f}, .status = PTC_OK, .u = -0.21290578f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {-0.00078807224f, 0.08428373f, 87.19381f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-13.072129f, 0.27467418f, 0.084042594f}, .status = PTC_OK, .u = 1.1978416f},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {0.2608215f, 0.6084159f, -0.51202893f}, .status = PTC_OK, .u = 0.222566f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.021363527f, -0.08684499f, -91.73954f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 2U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {0.09418065f, -0.92797965f, -0.00067587395f}, .status = PTC_OK, .u = 0.7056745f},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {-0.124280885f, -0.5207559f, -0.0001860362f}, .status = PTC_OK, .u = 0.36113676f},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.6472216f, 37.649403f, -61.98166f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 2U, .samples = 0U, .told = PTC_OK, .found = 2852U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {5.0124335f, -0.007183153f, 0.00021157454f}, .status = PTC_OK, .u = -0.561254f},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.7421477f, -0.00049732707f, 0.045397013f}, .status = PTC_OK, .u = -0.1366665f},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {-0.0005020909f, -0.4975255f, 0.7810068f}, .status = PTC_OK, .u = -0.67872816f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {0.1341446f, 0.013917128f, -0.46923193f}, .status = PTC_OK, .u = 0.56213635f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.09377667f, -0.0017872148f, -0.26958603f}, .status = PTC_OK, .u = 0.32628176f},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.22282876f, 0.9074303f, -0.41618782f}, .status = PTC_OK, .u = -0.008221951f},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {0.51927364f, -0.00044998902f, -0.00044110272f}, .status = PTC_OK, .u = -0.07114297f},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {77.642975f, 0.00935289f, 92.65203f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {11.004916f, 0.70725805f, -73.07145f}, .status = PTC_SATURATED, .u = 20.0f},
    {.command = 2U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-13.78919f, -8.356652e-5f, 46.43948f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.66042286f, -0.9856679f, 0.76507306f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {-0.054701593f, 0.30750504f, 0.1438705f}, .status = PTC_OK, .u = -0.42566738f},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {-0.633855f, 0.0006672873f, 18.710844f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {87.61217f, 0.006126002f, -77.600685f}, .status = PTC_SATURATED, .u = -20.0f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {26.320978f, -0.99230295f, -0.8860823f}, .status = PTC_OK, .u = -1.3245542f},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.07989627f, 0.7394883f, -0.14761117f}, .status = PTC_OK, .u = -0.23981062f},
    {.command = 2U, .samples = 10U, .told = PTC_OK, .found = 51U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.0002697003f, -0.0002998647f, 0.91011775f}, .status = PTC_OK, .u = -1.0679055f},
};

/* 1 where a number is not the one that must come. */
static uint32_t too_soon_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of what is called before a call. */
static uint32_t too_soon_selftest_command(too_soon *self, const too_soon_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = too_soon_arm_for(self, call->k, call->samples, call->y);
        break;
    case 2U:
        told = too_soon_soonest(self, call->y, &found);
        break;
    case 3U:
        told = too_soon_deadline(self, &found);
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
static uint32_t too_soon_selftest_check(too_soon *self, const too_soon_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (too_soon_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    failures += too_soon_selftest_command(self, call);
    if (too_soon_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += too_soon_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t too_soon_selftest_calls_of(too_soon *self, const too_soon_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += too_soon_selftest_check(self, &too_soon_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t too_soon_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const too_soon_selftest_session *session = &too_soon_selftest_sessions[i];
        too_soon self;

        if (too_soon_init(&self, &session->params) == PTC_OK) {
            failures += too_soon_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t too_soon_selftest_refuse(void)
{
    const too_soon_selftest_session *session = &too_soon_selftest_sessions[0];
    uint32_t failures = 0U;
    too_soon self;

    if (too_soon_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (too_soon_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += too_soon_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t too_soon_selftest_pointers(void)
{
    const too_soon_selftest_session *session = &too_soon_selftest_sessions[0];
    const too_soon_selftest_call *call = &too_soon_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    too_soon self;

    if (too_soon_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (too_soon_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (too_soon_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += too_soon_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (too_soon_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += too_soon_selftest_differs(u, 0.0f);
    if (too_soon_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += too_soon_selftest_calls_of(&self, session);
    return failures;
}

uint32_t too_soon_selftest(void)
{
    uint32_t failures = too_soon_selftest_run();

    failures += too_soon_selftest_refuse();
    failures += too_soon_selftest_pointers();
    return failures;
}
