#include "own.h"
#include "plain.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define UNUSED __attribute__((unused))

static uint64_t seed = 7;
static real x[GIVEN], x0[STATES];
UNUSED static real *r = x + STATES;

static double unit(void)
{
    uint64_t z = (seed += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

static double between(double low, double high)
{
    return low + (high - low) * unit();
}

/* A number that few think of, or one of any size. */
static real odd(void)
{
    const double all[] = { NAN, 0.0, -0.0, -1.0, INFINITY, -INFINITY, 5e-324, 1e-310, 1e-45, 1e-40, 1e-18, 0.99e-18,
        1e-150, 0.99e-150, 1e150, 1.01e150, 1e18, 1.01e18, 1e30, 1e300, 1.7e308, 3.4e38, 0.04, 0.05, 0.02, 0.1, 3.0 };
    const unsigned count = sizeof all / sizeof *all, at = (unsigned)(unit() * 2.0 * count);

    return (real)((at < count) ? all[at] : between(-1, 1) * pow(10.0, between(-160, 160)));
}

static real duration(void)
{
    return (unit() < 0.6) ? (real)exp(between(log(0.05), log(40.0))) : odd();
}

static real start(void)
{
    return (unit() < 0.6) ? (real)between(-100, 100) : (unit() < 0.5) ? (real)(between(-1, 1) * 1e15) : odd();
}

UNUSED static real law(void *context, const real xi[], real t)
{
    (void)context;
    return (real)0.125 * t - xi[0] - (real)2 * xi[1];
}

UNUSED static real rest(void *context, const real y[], real t)
{
    (void)context;
    return (real)0.125 * t - y[0];
}

static void fail(const char *what, int i, real t0, real tau)
{
    printf("%s: call %d, t0 = %.17g, tau = %.17g\n", what, i, (double)t0, (double)tau);
    exit(1);
}

/* init and arm of a fresh controller. */
static ptc_status begin(own *c, real tau, real t0)
{
    own_params params, *p = &params;
    ptc_status status;

    memset(p, 0, sizeof params);
    memset(c, 0x5a, sizeof *c);
    FILL(p, tau)
    status = own_init(c, p LATCHED);
    return (status == PTC_OK) ? own_arm(c, t0 LATCHED) : status;
}

static ptc_status begin_plain(plain *c, real tau, real t0)
{
    plain_params params, *p = &params;
    ptc_status status;

    memset(p, 0, sizeof params);
    FILL(p, tau)
    status = plain_init(c, p LATCHED);
    return (status == PTC_OK) ? plain_arm(c, t0 LATCHED) : status;
}

int main(void)
{
    static own c, fresh, before;
    static plain known;
    unsigned armed = 0, refused = 0, steps = 0;
    real tau = 2, t0 = 0;

    if ((begin(&c, tau, t0) != PTC_OK) || (begin_plain(&known, tau, t0) != PTC_OK)) {
        fail("no start", 0, t0, tau);
    }
    for (int i = 1; i < 20000; i++) {
        const int of_duration = unit() < 0.5;
        const real next = of_duration ? duration() : tau;
        const real at = start();
        ptc_status status, wanted;

        for (int j = 0; j < STATES; j++) {
            x0[j] = (unit() < 0.99) ? (real)between(-2, 2) : odd();
        }
        before = c;
        status = of_duration ? own_arm_for(&c, at, next LATCHED) : own_arm(&c, at LATCHED);
        wanted = begin(&fresh, next, at);
        if (status != wanted) {
            fail("another status", i, at, next);
        }
        if (memcmp(&c, (status == PTC_OK) ? &fresh : &before, sizeof c) != 0) {
            fail((status == PTC_OK) ? "another controller" : "a change", i, at, next);
        }
        if (status != PTC_OK) {
            refused++;
            continue;
        }
        armed++;
        tau = next;
        t0 = at;
        if (begin_plain(&known, tau, t0) != PTC_OK) {
            fail("refused without the key", i, t0, tau);
        }
        for (int k = 0; k < 3; k++) {
            const real t = (unit() < 0.95) ? (real)(t0 + between(0, 1.1) * tau) : TRUSTS ? t0 : odd();
            real u[INPUTS], other[INPUTS];
            ptc_status axes[INPUTS];

            (void)axes;
            for (int j = 0; j < GIVEN; j++) {
                x[j] = (TRUSTS || (unit() < 0.99)) ? (real)between(-3, 3) : odd();
            }
            status = STEP(own_step, &c, t);
            memcpy(other, u, sizeof u);
            if (STEP(plain_step, &known, t) != status) {
                fail("another status of step", i, t0, tau);
            }
            if (memcmp(other, u, sizeof u) != 0) {
                fail("another u", i, t0, tau);
            }
            steps += status >= 0;
        }
    }
    printf("%u %u %u\n", armed, refused, steps);
    return 0;
}
