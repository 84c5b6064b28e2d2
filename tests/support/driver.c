/* Runs one controller on the records of standard input; see Record and Outcome in program.rs.
 * HEADER is its header, NAME its name, N its order, REAL its type, PARAMS its number of
 * run-time parameters. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include HEADER

#define JOIN(a, b) a##b
#define METHOD(name, method) JOIN(name, method)

/* What a call must overwrite. */
#define UNSET ((REAL)12345)

int main(void)
{
    REAL record[PARAMS + 1 + N];
    METHOD(NAME, _params) params;
    NAME self;
    METHOD(NAME, _gains) gains;

    memset(&params, 0, sizeof params);
    while (fread(record, sizeof record, 1, stdin) == 1) {
        const REAL t = record[PARAMS];
        const REAL *x = &record[PARAMS + 1];
        int32_t status[3] = { 0, 0, 0 };
        REAL u[2] = { UNSET, UNSET };

        memcpy(&params, record, PARAMS * sizeof(REAL));
        status[0] = METHOD(NAME, _init)(&self, &params);
        if (status[0] == 0) {
            status[1] = METHOD(NAME, _step)(&self, t, x, &u[0]);
            status[2] = METHOD(NAME, _tick)(&self, t, &gains);
            if (status[2] >= 0) {
                status[2] = METHOD(NAME, _axis)(&gains, x, &u[1]);
            } else {
                u[1] = (REAL)0;
            }
        }
        fwrite(status, sizeof status, 1, stdout);
        fwrite(u, sizeof u, 1, stdout);
    }
    return 0;
}
