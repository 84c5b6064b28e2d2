/* Statuses, errors and closed loops of generated controllers; `make` of behaviour.rs says which.
 * Every CHECK that fails is printed, and makes the exit code 1. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bare.h"
#include "bounded.h"
#include "exp_1.h"
#include "exp_2.h"
#include "power_2.h"
#include "rational_2.h"
#include "single.h"
#include "sum_2.h"

static int failures = 0;

static void check(int holds, const char *what, int line)
{
    if (!holds) {
        printf("line %d: %s\n", line, what);
        failures++;
    }
}

#define CHECK(condition) check((condition), #condition, __LINE__)

/* Whether two numbers are the same, without a comparison that -Wfloat-equal warns of. */
static int same(double a, double b)
{
    return (a <= b) && (a >= b);
}

static exp_2_params usual(void)
{
    const exp_2_params params = { 1.0, 0.0, 0.125, (double)INFINITY, 1.0, { 6.0, 5.0 } };
    return params;
}

static exp_2 armed(void)
{
    exp_2 self;
    const exp_2_params params = usual();
    CHECK(exp_2_init(&self, &params) == PTC_OK);
    return self;
}

static void statuses(void)
{
    const exp_2 self = armed();
    const double x[2] = { 1.0, 0.5 };
    /* The deadline is 1: time-to-go is at most eps from 0.875 on. */
    const double held[] = { 0.875, 0.9, 1.0, 1.5, 1e9, 1e300 };
    double u = 7.0;
    double first;
    size_t i;

    CHECK(exp_2_step(&self, 0.0, x, &u) == PTC_OK);
    CHECK(same(u, -8.0)); /* u = -k1 x1/T^2 + (1 - k2) x2/T */
    CHECK(exp_2_step(&self, nextafter(0.875, 0.0), x, &u) == PTC_OK);
    CHECK(exp_2_step(&self, 0.875, x, &first) == PTC_HOLD);
    CHECK(same(first, -6.0 * 64.0 - 4.0 * 0.5 * 8.0));
    for (i = 0; i < sizeof held / sizeof held[0]; i++) {
        CHECK(exp_2_step(&self, held[i], x, &u) == PTC_HOLD);
        CHECK(same(u, first));
    }
}

static void saturation(void)
{
    exp_2 self;
    exp_2_params params = usual();
    exp_2_gains gains;
    const double up[2] = { -1.0, 0.0 };
    const double down[2] = { 1.0, 0.0 };
    const double within[2] = { 0.01, 0.0 };
    double u = 7.0;

    params.u_max = 5.5;
    CHECK(exp_2_init(&self, &params) == PTC_OK);
    CHECK((exp_2_step(&self, 0.0, up, &u) == PTC_SATURATED) && same(u, 5.5));
    CHECK((exp_2_step(&self, 0.0, down, &u) == PTC_SATURATED) && same(u, -5.5));
    CHECK((exp_2_step(&self, 0.0, within, &u) == PTC_OK) && same(u, -0.06));
    /* It wins over PTC_HOLD, which is there where u is within the bound. */
    CHECK((exp_2_step(&self, 9.0, down, &u) == PTC_SATURATED) && same(u, -5.5));
    CHECK((exp_2_step(&self, 9.0, within, &u) == PTC_HOLD) && same(u, -3.84));
    /* The limits do not hide that a number on the way to u overflows, though u itself is 0 here. */
    {
        const double huge[2] = { -4e307, 4e307 * (6.0 / (4.0 * 0.5)) };
        const double large[2] = { -1e306, 0.0 };
        CHECK((exp_2_step(&self, 0.5, huge, &u) == PTC_E_RANGE) && same(u, 0.0));
        CHECK((exp_2_step(&self, 0.5, large, &u) == PTC_SATURATED) && same(u, 5.5));
        CHECK((exp_2_step(&self, 9.0, huge, &u) == PTC_E_RANGE) && same(u, 0.0));
    }
    CHECK(exp_2_tick(&self, 9.0, &gains) == PTC_HOLD);
    CHECK((exp_2_axis(&gains, down, &u) == PTC_SATURATED) && same(u, -5.5));
    CHECK((exp_2_axis(&gains, within, &u) == PTC_HOLD) && same(u, -3.84));
}

static void inputs(void)
{
    const exp_2 self = armed();
    const double x[2] = { 1.0, 0.5 };
    const double wrong[] = { (double)NAN, (double)INFINITY, -(double)INFINITY };
    exp_2_gains gains;
    double u = 7.0;
    size_t i;

    CHECK(exp_2_tick(&self, 0.0, &gains) == PTC_OK);
    for (i = 0; i < 3; i++) {
        const double first[2] = { wrong[i], 0.0 };
        const double second[2] = { 0.0, wrong[i] };
        u = 7.0;
        CHECK((exp_2_step(&self, wrong[i], x, &u) == PTC_E_INPUT) && same(u, 0.0));
        u = 7.0;
        CHECK((exp_2_step(&self, 0.5, first, &u) == PTC_E_INPUT) && same(u, 0.0));
        u = 7.0;
        CHECK((exp_2_step(&self, 0.5, second, &u) == PTC_E_INPUT) && same(u, 0.0));
        u = 7.0;
        CHECK((exp_2_axis(&gains, second, &u) == PTC_E_INPUT) && same(u, 0.0));
        CHECK(exp_2_tick(&self, wrong[i], &gains) == PTC_E_INPUT);
    }
    u = 7.0;
    CHECK((exp_2_step(&self, nextafter(0.0, -1.0), x, &u) == PTC_E_INPUT) && same(u, 0.0));
    CHECK(exp_2_tick(&self, -1.0, &gains) == PTC_E_INPUT);
    /* An overflow with no bound of u. */
    {
        const double huge[2] = { 1e308, 1e308 };
        u = 7.0;
        CHECK((exp_2_step(&self, 0.5, huge, &u) == PTC_E_RANGE) && same(u, 0.0));
        u = 7.0;
        CHECK((exp_2_axis(&gains, huge, &u) == PTC_E_RANGE) && same(u, 0.0));
    }
}

static void pointers(void)
{
    exp_2 self = armed();
    const exp_2_params params = usual();
    const double x[2] = { 1.0, 0.5 };
    exp_2_gains gains;
    double u = 7.0;

    CHECK(exp_2_init(NULL, &params) < 0);
    CHECK(exp_2_init(&self, NULL) < 0);
    CHECK(exp_2_arm(NULL, 0.0) < 0);
    CHECK((exp_2_step(NULL, 0.0, x, &u) < 0) && same(u, 0.0));
    u = 7.0;
    CHECK((exp_2_step(&self, 0.0, NULL, &u) < 0) && same(u, 0.0));
    CHECK(exp_2_step(&self, 0.0, x, NULL) < 0);
    CHECK(exp_2_tick(NULL, 0.0, &gains) < 0);
    CHECK(exp_2_tick(&self, 0.0, NULL) < 0);
    CHECK(exp_2_tick(&self, 0.0, &gains) == PTC_OK);
    u = 7.0;
    CHECK((exp_2_axis(NULL, x, &u) < 0) && same(u, 0.0));
    u = 7.0;
    CHECK((exp_2_axis(&gains, NULL, &u) < 0) && same(u, 0.0));
    CHECK(exp_2_axis(&gains, x, NULL) < 0);
}

/* `init` must refuse the parameters and leave *self alone. */
#define REFUSED(name, params)                                                                \
    do {                                                                                     \
        name self_;                                                                          \
        unsigned char before_[sizeof self_];                                                 \
        memset(&self_, 0x5a, sizeof self_);                                                  \
        memset(before_, 0x5a, sizeof before_);                                               \
        CHECK(name##_init(&self_, &(params)) == PTC_E_PARAM);                                \
        CHECK(memcmp(&self_, before_, sizeof before_) == 0);                                 \
    } while (0)

/* Each value must be refused for one field. */
#define FIELD(name, params, field, values)                                                   \
    do {                                                                                     \
        size_t i_;                                                                           \
        for (i_ = 0; i_ < sizeof(values) / sizeof((values)[0]); i_++) {                      \
            name##_params wrong_ = (params);                                                 \
            wrong_.field = (values)[i_];                                                     \
            REFUSED(name, wrong_);                                                           \
        }                                                                                    \
    } while (0)

static void parameters(void)
{
    const exp_2_params params = usual();
    const power_2_params power = { 1.0, 0.0, 0.125, (double)INFINITY, 1.0, 2.0, { 6.0, 5.0 } };
    const sum_2_params sum = { 1.0, 0.0, 0.125, (double)INFINITY, { 0.5, 1.5 }, { 6.0, 5.0 } };
    const double not_positive[] = { (double)NAN, (double)INFINITY, -(double)INFINITY, 0.0, -0.0, -1.0 };
    const double not_finite[] = { (double)NAN, (double)INFINITY, -(double)INFINITY };
    const double no_bound[] = { (double)NAN, -(double)INFINITY, 0.0, -1.0 };
    const double no_eps[] = { (double)NAN, (double)INFINITY, -(double)INFINITY, 0.0, -1.0, 1.0, 2.0 };
    power_2 power_self;
    sum_2 sum_self;

    CHECK(power_2_init(&power_self, &power) == PTC_OK);
    CHECK(sum_2_init(&sum_self, &sum) == PTC_OK);
    FIELD(exp_2, params, tau, not_positive);
    FIELD(exp_2, params, t0, not_finite);
    FIELD(exp_2, params, eps, no_eps);
    FIELD(exp_2, params, u_max, no_bound);
    FIELD(exp_2, params, a, not_positive);
    FIELD(exp_2, params, k[0], not_finite);
    FIELD(exp_2, params, k[1], not_finite);
    FIELD(power_2, power, m, not_positive);
    FIELD(sum_2, sum, rates[0], not_positive);
    FIELD(sum_2, sum, rates[1], not_positive);
    /* In their domains one by one, but a coefficient or the deadline overflows. */
    {
        exp_2_params wrong = usual();
        wrong.a = 1e-200;
        REFUSED(exp_2, wrong);
        wrong = usual();
        wrong.tau = 1e308;
        wrong.t0 = 1.7e308;
        REFUSED(exp_2, wrong);
    }
}

static void arming(void)
{
    exp_2 self = armed();
    exp_2 before;
    const double wrong[] = { (double)NAN, (double)INFINITY, -(double)INFINITY };
    const double x[2] = { 0.3, -0.7 };
    double first = 7.0;
    double u = 7.0;
    size_t i;

    CHECK(exp_2_step(&self, 0.25, x, &first) == PTC_OK);
    CHECK(exp_2_arm(&self, 1024.0) == PTC_OK);
    CHECK((exp_2_step(&self, 1024.25, x, &u) == PTC_OK) && same(u, first));
    CHECK(exp_2_step(&self, 0.25, x, &u) == PTC_E_INPUT);
    memcpy(&before, &self, sizeof self);
    for (i = 0; i < 3; i++) {
        CHECK(exp_2_arm(&self, wrong[i]) == PTC_E_PARAM);
        CHECK(memcmp(&before, &self, sizeof self) == 0);
    }
    CHECK((exp_2_step(&self, 1024.25, x, &u) == PTC_OK) && same(u, first));
}

/* Everything fixed (with u_max infinite), u_max fixed, and single precision. */
static void variants(void)
{
    bare all;
    bounded some;
    single narrow;
    const bare_params nothing = { 0 };
    const bounded_params few = { 0.0 };
    const single_params narrow_params = { 1.0F, 0.0F, 0.125F, INFINITY, 1.0F, { 6.0F, 5.0F } };
    const double x[2] = { 1.0, 0.5 };
    const float narrow_x[2] = { 1.0F, 0.5F };
    const float huge[2] = { 1e38F, 1e38F };
    double u = 7.0;
    float narrow_u = 7.0F;

    CHECK(bare_init(&all, &nothing) == PTC_OK);
    CHECK((bare_step(&all, 0.0, x, &u) == PTC_OK) && same(u, -8.0));
    CHECK((bare_step(&all, 3.0, x, &u) == PTC_HOLD) && same(u, -400.0));
    CHECK(bounded_init(&some, &few) == PTC_OK);
    CHECK((bounded_step(&some, 0.0, x, &u) == PTC_SATURATED) && same(u, -2.5));
    CHECK((bounded_step(&some, -1.0, x, &u) == PTC_E_INPUT) && same(u, 0.0));
    CHECK(single_init(&narrow, &narrow_params) == PTC_OK);
    CHECK((single_step(&narrow, 0.0F, narrow_x, &narrow_u) == PTC_OK) && same((double)narrow_u, -8.0));
    CHECK((single_step(&narrow, 2.0F, narrow_x, &narrow_u) == PTC_HOLD) && same((double)narrow_u, -400.0));
    CHECK((single_step(&narrow, 0.5F, huge, &narrow_u) == PTC_E_RANGE) && same((double)narrow_u, 0.0));
}

/* A closed loop of n = 1 or 2: the control and the exact state and u at time-to-go T. */
typedef struct plant {
    const char *name;
    int n;
    double tau;
    double input_gain; /* of the plant: xn' = input_gain * u */
    double (*control)(double t, const double *x);
    void (*exact)(double to_go, double *x, double *u);
} plant;

static exp_1 first_order;
static exp_2 second_order;
static rational_2 rational_order;

static double first_control(double t, const double *x)
{
    double u = (double)NAN;
    CHECK(exp_1_step(&first_order, t, x, &u) == PTC_OK);
    return u;
}

static double second_control(double t, const double *x)
{
    double u = (double)NAN;
    CHECK(exp_2_step(&second_order, t, x, &u) == PTC_OK);
    return u;
}

static double rational_control(double t, const double *x)
{
    double u = (double)NAN;
    CHECK(rational_2_step(&rational_order, t, x, &u) == PTC_OK);
    return u;
}

/* x = x0 (1 - t)^10. */
static void first_exact(double to_go, double *x, double *u)
{
    x[0] = pow(to_go, 10.0);
    *u = -10.0 * pow(to_go, 9.0);
}

/* Poles -2 and -3: x1 = 3T^2 - 2T^3, and x2' = 2u for g = 2. */
static void second_exact(double to_go, double *x, double *u)
{
    x[0] = to_go * to_go * (3.0 - 2.0 * to_go);
    x[1] = -6.0 * to_go * (1.0 - to_go);
    *u = 3.0 - 6.0 * to_go;
}

/* With s = kappa = t/(10 - t), s' = 10/T^2 and s'' = 20/T^3: x1 = -(1 + 11 s) e^-s, its derivative
 * by s is (11 s - 10) e^-s, its second (21 - 11 s) e^-s. */
static void rational_exact(double to_go, double *x, double *u)
{
    const double s = (10.0 - to_go) / to_go;
    const double slope = 10.0 / (to_go * to_go);
    const double first = (11.0 * s - 10.0) * exp(-s);
    const double second = (21.0 - 11.0 * s) * exp(-s);
    x[0] = -(1.0 + 11.0 * s) * exp(-s);
    x[1] = slope * first;
    *u = slope * slope * second + slope * 2.0 / to_go * first;
}

static void rate(const plant *p, double t, const double *x, double *dx)
{
    dx[0] = x[1];
    dx[p->n - 1] = p->input_gain * (p->control(t, x) / p->input_gain);
}

/* One step of the classical Runge-Kutta method. */
static void advance(const plant *p, double t, double h, double *x)
{
    double d[4][2] = { { 0.0 } };
    double at[2] = { 0.0, 0.0 };
    int i;

    rate(p, t, x, d[0]);
    for (i = 0; i < p->n; i++) {
        at[i] = x[i] + 0.5 * h * d[0][i];
    }
    rate(p, t + 0.5 * h, at, d[1]);
    for (i = 0; i < p->n; i++) {
        at[i] = x[i] + 0.5 * h * d[1][i];
    }
    rate(p, t + 0.5 * h, at, d[2]);
    for (i = 0; i < p->n; i++) {
        at[i] = x[i] + h * d[2][i];
    }
    rate(p, t + h, at, d[3]);
    for (i = 0; i < p->n; i++) {
        x[i] += h / 6.0 * (d[0][i] + 2.0 * d[1][i] + 2.0 * d[2][i] + d[3][i]);
    }
}

static void follow(const plant *p)
{
    double x[2] = { 0.0, 0.0 };
    double exact[2] = { 0.0, 0.0 };
    double u = 0.0;
    double most_u = 0.0;
    double law = 0.0;
    double most_x[2] = { 0.0, 0.0 };
    double wrong[2] = { 0.0, 0.0 };
    double t = 0.0;
    int steps = 0;
    int i;

    p->exact(p->tau, x, &u);
    while (p->tau - t > 1e-3 * p->tau) {
        /* Steps in proportion to the time-to-go resolve the loop all the way. */
        const double h = fmin(1e-3 * (p->tau - t), 1e-3);
        advance(p, t, h, x);
        t += h;
        p->exact(p->tau - t, exact, &u);
        most_u = fmax(most_u, fabs(u));
        law = fmax(law, fabs(p->control(t, exact) / p->input_gain - u));
        for (i = 0; i < p->n; i++) {
            most_x[i] = fmax(most_x[i], fabs(exact[i]));
            wrong[i] = fmax(wrong[i], fabs(x[i] - exact[i]));
        }
        steps++;
    }
    CHECK(steps > 1000);
    printf("%s: %d steps, u is wrong by %.1e, x by", p->name, steps, law / most_u);
    for (i = 0; i < p->n; i++) {
        printf(" %.1e", wrong[i] / most_x[i]);
        CHECK(wrong[i] <= SIMULATION * most_x[i]);
    }
    printf("\n");
    CHECK(law <= TRAJECTORY * most_u);
}

static void closed_loops(void)
{
    const exp_1_params first = { 1.0, 0.0, 1e-4, (double)INFINITY, 0.1, { 1.0 } };
    const exp_2_params second = { 1.0, 0.0, 1e-4, (double)INFINITY, 1.0, { 6.0, 5.0 } };
    const rational_2_params rational = { 10.0, 0.0, 1e-3, (double)INFINITY, 1.0, { 1.0, 2.0 } };
    const plant plants[] = {
        { "exp 1", 1, 1.0, 1.0, first_control, first_exact },
        { "exp 2", 2, 1.0, 2.0, second_control, second_exact },
        { "rational 2", 2, 10.0, 1.0, rational_control, rational_exact },
    };
    size_t i;

    CHECK(exp_1_init(&first_order, &first) == PTC_OK);
    CHECK(exp_2_init(&second_order, &second) == PTC_OK);
    CHECK(rational_2_init(&rational_order, &rational) == PTC_OK);
    for (i = 0; i < 3; i++) {
        follow(&plants[i]);
    }
}

int main(void)
{
    statuses();
    saturation();
    inputs();
    pointers();
    parameters();
    arming();
    variants();
    closed_loops();
    return failures == 0 ? 0 : 1;
}
