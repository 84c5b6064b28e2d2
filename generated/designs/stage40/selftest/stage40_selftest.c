/* Self-test of the prescribed-time controller stage40: see stage40_selftest.h. DO NOT EDIT. */
#include "stage40_selftest.h"
#include "stage40.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage40_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    double r[3]; /* the reference and its derivatives */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} stage40_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage40_selftest_session {
    stage40_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage40_selftest_session;

static const stage40_selftest_session stage40_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 70U},
    {.params = {.none = (char)0}, .first = 70U, .count = 3U},
    {.params = {.none = (char)0}, .first = 73U, .count = 2U},
};

static const stage40_selftest_call stage40_selftest_calls[75] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .r = {0.25, -0.25, -0.75}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7129687499999999}, .r = {0.23765624999999999, -0.23765624999999999, -0.7129687499999999}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7303570046439628, -3.6687306501548056}, .d = -152.86377708978358},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.676875}, .r = {0.225625, -0.225625, -0.676875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.6990601942724458, -9.312944659442726}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_GATED, .u = 6.0, .xhat = {0.6895459210526316, -9.71560178018576}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6895459210526316, -9.71560178018576}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6895459210526316, -9.71560178018576}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6895459210526316, -9.71560178018576}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_GATED, .u = 6.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6796289907120744, -10.118258900928796}, .d = -396.65712074303406},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.5755279494893158, -29.183409027271914}, .d = -1226.6345876585933},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_GATED, .u = 6.0, .xhat = {0.5457342231682146, -30.404043614930508}, .d = -1226.6345876585933},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_GATED, .u = 6.0, .xhat = {0.5147198622594548, -31.624678202589102}, .d = -1226.6345876585933},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.5147198622594548, -31.624678202589102}, .d = -1226.6345876585933},
    {.is_armed = 1U, .start = 0U, .k = 2U, .y = {0.25}, .r = {0.5, 0.5, 0.5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.25, 0.006}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6417187500000001}, .r = {0.21390625000000002, -0.21390625000000002, -0.6417187500000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.4769702375, 48.399675000000016}, .d = 2304.1750000000006},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.421875}, .r = {0.140625, -0.140625, -0.421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.43931666666666663, 14.082350000000048}, .d = -1184.1583333333301},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.27}, .r = {0.09, -0.09, -0.27}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.27, -261.3137145833334}, .d = -183988.09583333338},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.22687500000000005}, .r = {0.07562500000000001, -0.07562500000000001, -0.22687500000000005}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.22687500000000005, 19.970833333333417}, .d = 126197.66666666674},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.20671875}, .r = {0.06890625, -0.06890625, -0.20671875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.20671875, -8.668875000000014}, .d = 22968.749999999956},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.1875, -18.75300000000002}, .d = 937.4999999999818},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.16921875}, .r = {0.05640625, -0.05640625, -0.16921875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.16921875, -17.81249999999999}, .d = 943.5000000000156},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.046875}, .r = {0.015625, -0.015625, -0.046875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.046875, -174.37200000000004}, .d = -104062.50000000003},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0075000000000000015}, .r = {0.0025000000000000005, -0.0025000000000000005, -0.0075000000000000015}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.007500000000000007, 2.109375}, .d = 82962.75000000003},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0018750000000000004}, .r = {0.0006250000000000001, -0.0006250000000000001, -0.0018750000000000004}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0018750000000000017, 11.25}, .d = 33744.00000000001},
    {.is_armed = 0U, .start = 0U, .k = 39U, .y = {0.0004687500000000001}, .r = {0.00015625000000000003, -0.00015625000000000003, -0.0004687500000000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0004687500000000004, 0.7001249999999999}, .d = 4218.750000000004},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0, 0.0}, .d = 943.5000000000014},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0, 0.23437500000000033}, .d = 474.75000000000074},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0, 1.1102230246251565e-16}, .d = 6.000000000000057},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -5.99999999999965, .xhat = {0.0, -4.073720256524832e-17}, .d = 5.999999999999917},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .r = {0.25, -0.25, -0.75}, .status = PTC_GATED, .u = 6.0, .xhat = {-8.216219588366713e-20, -1.231653667943533e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7129687499999999}, .r = {0.23765624999999999, -0.23765624999999999, -0.7129687499999999}, .status = PTC_GATED, .u = 6.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.676875}, .r = {0.225625, -0.225625, -0.676875}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.157428404298838e-20, 1.43982048506075e-16}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.2769634607843137, 55.15839705882353}, .d = 2456.950980392157},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_GATED, .u = -6.0, .xhat = {0.3333533333333333, 57.62134803921569}, .d = 2456.950980392157},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_GATED, .u = -6.0, .xhat = {0.39220015686274506, 60.07229901960785}, .d = 2456.950980392157},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.39220015686274506, 60.07229901960785}, .d = 2456.950980392157},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967295U, .y = {0.25}, .r = {0.5, 0.5, 0.5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.25, -0.006}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6417187500000001}, .r = {0.21390625000000002, -0.21390625000000002, -0.6417187500000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.47696266691176475, 48.37789852941178}, .d = 2304.280882352942},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.421875}, .r = {0.140625, -0.140625, -0.421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.43931178431372553, 14.07093235294115}, .d = -1183.07598039216},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.27}, .r = {0.09, -0.09, -0.27}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.27, -261.3004116421569}, .d = -183971.2546568628},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.22687500000000005}, .r = {0.07562500000000001, -0.07562500000000001, -0.22687500000000005}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.22687500000000005, 19.968392156862876}, .d = 126192.78431372557},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.20671875}, .r = {0.06890625, -0.06890625, -0.20671875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.20671875, -8.668875000000071}, .d = 22968.749999999898},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.1875}, .r = {0.0625, -0.0625, -0.1875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.1875, -18.752999999999968}, .d = 937.5000000000364},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.16921875}, .r = {0.05640625, -0.05640625, -0.16921875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.16921875, -17.812500000000007}, .d = 943.4999999999868},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.046875}, .r = {0.015625, -0.015625, -0.046875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.046875, -174.372}, .d = -104062.5},
    {.is_armed = 0U, .start = 0U, .k = 33U, .y = {0.0075000000000000015}, .r = {0.0025000000000000005, -0.0025000000000000005, -0.0075000000000000015}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.007500000000000007, 2.109375}, .d = 82962.75000000003},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {0.0018750000000000004}, .r = {0.0006250000000000001, -0.0006250000000000001, -0.0018750000000000004}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0018750000000000017, 11.25}, .d = 33744.00000000001},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0004687500000000001}, .r = {0.00015625000000000003, -0.00015625000000000003, -0.0004687500000000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0004687500000000004, 0.7001249999999999}, .d = 4218.750000000004},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0, 0.0}, .d = 943.5000000000014},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0, 0.23437500000000033}, .d = 474.75000000000074},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.0, 1.1102230246251565e-16}, .d = 6.000000000000057},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .r = {0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -5.99999999999965, .xhat = {0.0, -4.073720256524832e-17}, .d = 5.999999999999917},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.8828533589315051}, .r = {-0.4815132714359819, 0.6916431151885172, 0.6125966836353886}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.8828533589315051, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {-0.9927258021785783}, .r = {0.27198801085932767, 0.9323197379375774, -0.361914932020557}, .status = PTC_GATED, .u = -6.0, .xhat = {0.8828533589315051, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 29U, .y = {-1.108556885770991e302}, .r = {-1.1011473149436144e302, -1.0103088587593598e302, 4.531060549573787e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.8828533589315051, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 41U, .y = {-0.0}, .r = {0.0, -0.0, 0.0}, .status = PTC_HOLD, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.0}, .r = {0.0, -0.0, 0.0}, .status = PTC_OK, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage40_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage40_selftest_check(stage40 *self, const stage40_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage40_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage40_step(self, call->k, call->y, call->r, &u) != call->status) {
        failures++;
    }
    failures += stage40_selftest_differs(u, call->u);
    if (stage40_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage40_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage40_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage40_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage40_selftest_calls_of(stage40 *self, const stage40_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage40_selftest_check(self, &stage40_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage40_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage40_selftest_session *session = &stage40_selftest_sessions[i];
        stage40 self;

        if (stage40_init(&self, &session->params) == PTC_OK) {
            failures += stage40_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage40_selftest_refuse(void)
{
    const stage40_selftest_session *session = &stage40_selftest_sessions[0];
    uint32_t failures = 0U;
    stage40 self;

    if (stage40_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage40_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage40_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage40_selftest_pointers(void)
{
    const stage40_selftest_session *session = &stage40_selftest_sessions[0];
    const stage40_selftest_call *call = &stage40_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    stage40 self;

    if (stage40_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage40_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage40_step(NULL, call->k, call->y, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage40_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage40_step(&self, call->k, NULL, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage40_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage40_step(&self, call->k, call->y, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage40_selftest_differs(u, 0.0);
    if (stage40_step(&self, call->k, call->y, call->r, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage40_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage40_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage40_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage40_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage40_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage40_selftest(void)
{
    uint32_t failures = stage40_selftest_run();

    failures += stage40_selftest_refuse();
    failures += stage40_selftest_pointers();
    return failures;
}
