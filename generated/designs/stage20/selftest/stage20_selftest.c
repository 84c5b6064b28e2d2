/* Self-test of the prescribed-time controller stage20: see stage20_selftest.h. DO NOT EDIT. */
#include "stage20_selftest.h"
#include "stage20.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage20_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    double r[3]; /* the reference and its derivatives */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} stage20_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage20_selftest_session {
    stage20_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage20_selftest_session;

static const stage20_selftest_session stage20_selftest_sessions[6] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 0U, .count = 60U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 0.0}, .deadbeat = 0.0}, .first = 60U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 1.7976931348623157e308}, .first = 61U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 62U, .count = 3U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 65U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 67U, .count = 2U},
};

static const stage20_selftest_call stage20_selftest_calls[69] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .r = {0.25, -0.25, -0.75}, .status = PTC_OK, .u = -1.7920346804068787, .xhat = {0.75, 0.00390625}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .r = {0.2417361111111111, -0.2417361111111111, -0.7252083333333332}, .status = PTC_OK, .u = -2.2481061776604827, .xhat = {0.7408710056437865, -0.06017711754241954}, .d = -0.22314541142127436},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .r = {0.2336111111111111, -0.2336111111111111, -0.7008333333333333}, .status = PTC_OK, .u = -2.8243357963379654, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7249611791335613, -0.18295476961170687}, .d = -0.6137685592384037},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .r = {0.225625, -0.225625, -0.676875}, .status = PTC_OK, .u = -3.4218627431550974, .xhat = {0.7041789955463184, -0.34260176566735245}, .d = -1.1189618545866578},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .r = {0.140625, -0.140625, -0.421875}, .status = PTC_OK, .u = -1.0658192214528341, .xhat = {0.5222370904985703, -3.1712165529240206}, .d = -21.050264772508786},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .r = {0.08027777777777777, -0.08027777777777777, -0.2408333333333333}, .status = PTC_OK, .u = 205.26056257148107, .xhat = {0.2408333333333333, -25.476337674460392}, .d = -1908.5387699576395},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .r = {0.07111111111111111, -0.07111111111111111, -0.21333333333333332}, .status = PTC_OK, .u = 88.66286290722844, .xhat = {0.21333333333333332, 6.370886951334576}, .d = 2082.2201314832096},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .r = {0.06673611111111112, -0.06673611111111112, -0.20020833333333338}, .status = PTC_OK, .u = 0.1028473346880413, .xhat = {0.20020833333333338, 0.14920044692057033}, .d = 60.37015070224288},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875}, .status = PTC_OK, .u = -32.92213169269547, .xhat = {0.1875, -1.0737091444282723}, .d = -163.106426776548},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .r = {0.058402777777777776, -0.058402777777777776, -0.17520833333333333}, .status = PTC_OK, .u = -39.14717547470038, .xhat = {0.17520833333333333, -1.0145879752629678}, .d = -64.48570330862549},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .r = {0.015625, -0.015625, -0.046875}, .status = PTC_OK, .u = 7521.365138512432, .xhat = {0.046875, -12.022135975156363}, .d = -944.6954058032118},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .r = {0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333}, .status = PTC_OK, .u = -17665.889642635357, .xhat = {0.003333333333333327, -0.09332245667922123}, .d = 727.7542279951117},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .r = {0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333}, .status = PTC_OK, .u = 29566.198901423108, .xhat = {0.0008333333333333526, 20.533769557692196}, .d = -1751.7281121190344},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .r = {6.944444444444444e-5, -6.944444444444444e-5, -0.00020833333333333332}, .status = PTC_OK, .u = -24465.25392241071, .xhat = {0.00020833333333333814, -63.624023204359915}, .d = -186.323721502519},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -25165.45947467866, .xhat = {0.0, 118.00373591846677}, .d = 3597.6763610413764},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 160246.23401405796, .xhat = {0.0, -132.73606047645484}, .d = -12892.643361051349},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -385021.749795818, .xhat = {0.0, -8.390596853205636}, .d = 22973.203833241263},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 596338.3160206579, .xhat = {0.0, 475.21305636123043}, .d = -27003.960742536896},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .r = {0.25, -0.25, -0.75}, .status = PTC_OK, .u = 1348569.7492102277, .xhat = {-1.7556014864609266, -1668.7658023173005}, .d = -26972.382454264454},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .r = {0.2417361111111111, -0.2417361111111111, -0.7252083333333332}, .status = PTC_OK, .u = 1896046.8460600637, .xhat = {-11.869430000974518, 917.3622636026612}, .d = -26792.94718950854},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .r = {0.2336111111111111, -0.2336111111111111, -0.7008333333333333}, .status = PTC_OK, .u = 2262081.7556279926, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {39.2233484554984, 9591.829930945705}, .d = -27416.616050933},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .r = {0.225625, -0.225625, -0.676875}, .status = PTC_OK, .u = 2469149.3394567645, .xhat = {174.96251018869128, 22214.261807519833}, .d = -30641.3431507992},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .r = {0.140625, -0.140625, -0.421875}, .status = PTC_OK, .u = 2478538.0028238716, .xhat = {235.43287418140994, 32369.265735449942}, .d = -77313.10327914126},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .r = {0.08027777777777777, -0.08027777777777777, -0.2408333333333333}, .status = PTC_OK, .u = 2962762.342327386, .xhat = {0.24083333333328483, -33965.12864046042}, .d = -7297894.650170445},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .r = {0.07111111111111111, -0.07111111111111111, -0.21333333333333332}, .status = PTC_OK, .u = 3003555.455370132, .xhat = {0.21333333333336668, 7572.849730299844}, .d = -538851.6204066696},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .r = {0.06673611111111112, -0.06673611111111112, -0.20020833333333338}, .status = PTC_OK, .u = 2983851.6770422547, .xhat = {0.20020833333333599, 1242.0638223804708}, .d = -2614315.442579014},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875}, .status = PTC_OK, .u = 2968866.9005581825, .xhat = {0.1875, 162.88160563979636}, .d = -2959100.481427839},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .r = {0.058402777777777776, -0.058402777777777776, -0.17520833333333333}, .status = PTC_OK, .u = 2963660.8978551785, .xhat = {0.17520833333333297, -46.30387921256602}, .d = -2996736.069599497},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .r = {0.015625, -0.015625, -0.046875}, .status = PTC_OK, .u = 3042688.547677121, .xhat = {0.046875, -52.74503635580095}, .d = -2981204.0650621885},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .r = {0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333}, .status = PTC_OK, .u = 2823807.3298158557, .xhat = {0.0033333333333334103, -15.247995594947213}, .d = -2967176.8732297565},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .r = {0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333}, .status = PTC_OK, .u = 3200640.3135688966, .xhat = {0.0008333333333334636, 203.10336306450617}, .d = -2985714.3986187354},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .r = {6.944444444444444e-5, -6.944444444444444e-5, -0.00020833333333333332}, .status = PTC_OK, .u = 2830362.2956218687, .xhat = {0.0002083333333333659, -551.4299420489028}, .d = -2978643.7310967045},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 2645274.3360987827, .xhat = {0.0, 939.2836231631527}, .d = -2936628.73122123},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 4448464.124304364, .xhat = {0.0, -903.1922338624499}, .d = -3084722.383612345},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -249476.59327583062, .xhat = {0.0, -519.6685996010547}, .d = -2789877.9950668453},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 7507693.291027291, .xhat = {0.0, 4599.841014745379}, .d = -3158205.9627666986},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .r = {0.0, 0.0, 0.0}, .status = PTC_OK, .u = -0.02395250829043921, .xhat = {0.0, 0.00390625}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .r = {0.0, 0.0, 0.0}, .status = PTC_OK, .u = -3.203125, .xhat = {0.0, 0.00390625}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.848777075081289}, .r = {-0.2574043310789601, 0.8038724357084645, 0.619551077038064}, .status = PTC_OK, .u = -1.228209783802238, .xhat = {0.848777075081289, 0.00390625}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {-0.5394443453822192}, .r = {-0.29978843416492973, 0.9667719280209335, 0.8346155160974523}, .status = PTC_OK, .u = -166.07408949396327, .xhat = {-0.5394443453822192, -76.15107060114102}, .d = 3249.4456789820165},
    {.is_armed = 1U, .start = 4294967290U, .k = 37U, .y = {1.5956250322646197e302}, .r = {-8.835435194688349e301, 1.0853200721551672e302, 7.236780503001228e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-0.5394443453822192, -76.15107060114102}, .d = 3249.4456789820165},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {6.934706200815667e153}, .r = {7.254012678704029e153, -3.555293132098338e153, 7.05344441988137e153}, .status = PTC_OK, .u = 5.1245949286245e151, .xhat = {6.934706200815667e153, 0.00390625}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 15U, .y = {-9.921247990295325e153}, .r = {-1.2335022506071407e154, 4.775426651090837e153, -1.241483445109339e154}, .status = PTC_OK, .u = -4.952120059833868e154, .xhat = {-9.921247990295325e153, 0.00390625}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.25651864234512545}, .r = {0.6246033109171112, -0.5197410453143261, 0.44609843361329055}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-0.25651864234512545, 0.00390625}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {-0.39202133136894945}, .r = {-0.6442172505072369, 0.6473731833694953, -0.8361845599908263}, .status = PTC_SATURATED, .u = -1.0, .xhat = {-0.32017399287889076, -0.6345872323817012}, .d = -2.8851637103458865},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage20_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage20_selftest_check(stage20 *self, const stage20_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage20_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage20_step(self, call->k, call->y, call->r, &u) != call->status) {
        failures++;
    }
    failures += stage20_selftest_differs(u, call->u);
    if (stage20_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage20_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage20_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage20_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage20_selftest_calls_of(stage20 *self, const stage20_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage20_selftest_check(self, &stage20_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage20_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const stage20_selftest_session *session = &stage20_selftest_sessions[i];
        stage20 self;

        if (stage20_init(&self, &session->params) == PTC_OK) {
            failures += stage20_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage20_selftest_refuse(void)
{
    static const stage20_params refused[45] = {
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 7U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)NAN, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.0, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.0, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 5e-324, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 7.5e-151, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e-150, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.25e150, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)NAN, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -(double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = 0.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.7976931348623157e308, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {(double)NAN, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {-(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {-1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, (double)NAN, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, (double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, -(double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, -1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, (double)NAN, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, (double)INFINITY, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, -(double)INFINITY, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 1.7976931348623157e308, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, -1.7976931348623157e308, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, (double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, (double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, -(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, -1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.7976931348623157e308},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .k = {625.0, -1.7976931348623157e308, -1.1156296291813806e-137, 1.7976931348623157e308}, .deadbeat = 5.453881758726523e-119},
    };
    const stage20_selftest_session *session = &stage20_selftest_sessions[0];
    uint32_t failures = 0U;
    stage20 self;

    if (stage20_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 45U; i++) {
        if (stage20_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage20_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage20_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage20_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage20_selftest_pointers(void)
{
    const stage20_selftest_session *session = &stage20_selftest_sessions[0];
    const stage20_selftest_call *call = &stage20_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    stage20 self;

    if (stage20_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage20_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage20_step(NULL, call->k, call->y, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage20_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage20_step(&self, call->k, NULL, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage20_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage20_step(&self, call->k, call->y, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage20_selftest_differs(u, 0.0);
    if (stage20_step(&self, call->k, call->y, call->r, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage20_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage20_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage20_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage20_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage20_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage20_selftest(void)
{
    uint32_t failures = stage20_selftest_run();

    failures += stage20_selftest_refuse();
    failures += stage20_selftest_pointers();
    return failures;
}
