/* One controller behind `drive`: a record of numbers in, an outcome out; see Record and Outcome in
 * program.rs. HEADER is its header, NAME its name, DRIVE the name of its function, N its order, REAL
 * its type, PARAMS its number of run-time parameters, REFERENCES the numbers of the
 * reference that it is given. LATCHES, LAW, AFTER and AXIS are 1 where the
 * controller latches x0, calls pi0, calls a law after the deadline, has tick and axis. RATE is 1
 * for the infinite-time system, with f = 1/4; u is then the last of its rates. IN_FLIGHT is 1 where it
 * is armed again for three quarters of tau, the first of its parameters. */
#include <stdint.h>
#include <string.h>

#include HEADER

#define JOIN(a, b) a##b
#define METHOD(name, method) JOIN(name, method)
#define ARMED(name, method) METHOD(name, method)

/* What a call must overwrite. */
#define UNSET ((REAL)12345)

#if LATCHES
#define START , x0
#define STATE_AGAIN , x
#else
#define START
#define STATE_AGAIN
#endif
#if IN_FLIGHT
#define ARM _arm_for
#define START_AGAIN , (REAL)0.75 * record[0] STATE_AGAIN
#else
#define ARM _arm
#define START_AGAIN STATE_AGAIN
#endif
#if REFERENCES
#define REFERENCE , r
#else
#define REFERENCE
#endif
#if LAW
#define LAW_ARGUMENT , user_law
#else
#define LAW_ARGUMENT
#endif
#if AFTER
#define AFTER_ARGUMENT , user_after
#else
#define AFTER_ARGUMENT
#endif
#if LAW || AFTER
#define CONTEXT_ARGUMENT , NULL
#else
#define CONTEXT_ARGUMENT
#endif

void DRIVE(const void *bytes, int32_t status[4], void *out);

#if LAW
/* -1.5 (xi_1 + ... + xi_n) + t/8, for the user's law. */
static REAL user_law(void *context, const REAL xi[N], REAL t)
{
    REAL sum = (REAL)0;
    (void)context;
    for (int i = 0; i < N; i++) {
        sum = sum + ((REAL)-1.5 * xi[i]);
    }
    return sum + ((REAL)0.125 * t);
}
#endif

#if AFTER
/* -x_1, for the user's law after the deadline. */
static REAL user_after(void *context, const REAL x[N], REAL t)
{
    (void)context;
    (void)t;
    return -x[0];
}
#endif

void DRIVE(const void *bytes, int32_t status[4], void *out)
{
    REAL record[PARAMS + (LATCHES * N) + 1 + N + REFERENCES];
    REAL u[3] = { UNSET, UNSET, UNSET };
    METHOD(NAME, _params) params;
    NAME self;

    memcpy(record, bytes, sizeof record);
    memset(&params, 0, sizeof params);
    memcpy(&params, record, PARAMS * sizeof(REAL));
#if LATCHES
    const REAL *x0 = &record[PARAMS];
#endif
    const REAL t = record[PARAMS + (LATCHES * N)];
    const REAL *x = &record[PARAMS + (LATCHES * N) + 1];
#if REFERENCES
    const REAL *r = &x[N];
#endif

    status[1] = 0;
    status[2] = 0;
    status[3] = 0;
    status[0] = (int32_t)METHOD(NAME, _init)(&self, &params START);
    if (status[0] == 0) {
#if RATE
        REAL xi_dot[N] = { (REAL)0 };
        status[1] = (int32_t)METHOD(NAME, _rate)(&self, t, x, (REAL)0.25 LAW_ARGUMENT CONTEXT_ARGUMENT, xi_dot);
        u[0] = xi_dot[N - 1];
#else
        status[1] = (int32_t)METHOD(NAME, _step)(&self, t, x REFERENCE LAW_ARGUMENT AFTER_ARGUMENT CONTEXT_ARGUMENT, &u[0]);
#endif
#if AXIS
        METHOD(NAME, _gains) gains;
        status[2] = (int32_t)METHOD(NAME, _tick)(&self, t, &gains);
        if (status[2] >= 0) {
            status[2] = (int32_t)METHOD(NAME, _axis)(&gains, x REFERENCE, &u[1]);
        } else {
            u[1] = (REAL)0;
        }
#endif
        status[3] = (int32_t)ARMED(NAME, ARM)(&self, t START_AGAIN);
        if (status[3] == 0) {
#if RATE
            status[3] = (int32_t)METHOD(NAME, _rate)(&self, t, x, (REAL)0.25 LAW_ARGUMENT CONTEXT_ARGUMENT, xi_dot);
            u[2] = xi_dot[N - 1];
#else
            status[3] = (int32_t)METHOD(NAME, _step)(&self, t, x REFERENCE LAW_ARGUMENT AFTER_ARGUMENT CONTEXT_ARGUMENT, &u[2]);
#endif
        }
    }
    memcpy(out, u, sizeof u);
}
