/* FMI 2.0 co-simulation around the controller in duration_latched.c. DO NOT EDIT.
 *
 * The outputs are those of the communication point and of the inputs as they are when they are read:
 * set x1..x2, get u, give it to the plant, step. Linked statically, with other FMUs, it is
 * compiled with FMI2_FUNCTION_PREFIX=duration_latched_.
 */
#include "fmi2Functions.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "duration_latched.h"

/* The interface hands over more than this FMU has a use for. */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

/* The token of modelDescription.xml: a hash of the whole text of this FMU. */
#define TOKEN "{dcc316ed-5c25-81dd-3551-a6fb189a1d5a}"

/* Value references of outputs that are no inputs or parameters. */
#define U 4u
#define TIME_TO_GO 5u
#define STATUS 6u

enum phase { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED };

/* What the importer changes in flight. */
typedef struct Steering {
    double deadline;
} Steering;

/* What fmi2GetFMUstate keeps. */
typedef struct State {
    duration_latched controller;
    duration_latched_params params;
    double x[2];
    double x0[2]; /* the state at the start */
    int latch; /* x0 is still to be taken from x */
    double u;
    Steering steering;
    Steering steered; /* that which the controller has */
    double planned;
    double time_to_go;
    int status;
    double time;
    int armed; /* the controller has the parameters in params */
    int fresh; /* the outputs are those of time, x and params */
    enum phase phase;
} State;

typedef struct Instance {
    State state;
    char *name;
    void *environment;
    fmi2CallbackLogger logger;
} Instance;

static void tell(const Instance *instance, const char *format, ...)
{
    char text[512];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (instance->logger != NULL) {
        /* No text holds a percent sign, so that it may stand for its own format. */
        instance->logger(instance->environment, instance->name, fmi2Error, "logStatusError", text);
    }
}

/* Sets everything to its start value. */
static void reset(Instance *instance)
{
    State *state = &instance->state;

    memset(state, 0, sizeof *state);
    state->params.tau = 1.0;
    state->params.t0 = 0.0;
    state->params.eps = 0.01;
    state->params.u_max = 1e30;
    state->params.c = 0.5;
    state->latch = 1;
}

static Instance *instantiate(const char *name, const char *token, void *environment,
                             fmi2CallbackLogger logger)
{
    Instance *instance = calloc(1, sizeof *instance);
    const char *own = (name == NULL) ? "" : name;

    if (instance == NULL) {
        return NULL;
    }
    instance->environment = environment;
    instance->logger = logger;
    instance->name = malloc(strlen(own) + 1u);
    if (instance->name == NULL) {
        free(instance);
        return NULL;
    }
    strcpy(instance->name, own);
    if ((token == NULL) || (strcmp(token, TOKEN) != 0)) {
        tell(instance, "the token is not %s: binary and modelDescription.xml are of two FMUs", TOKEN);
        free(instance->name);
        free(instance);
        return NULL;
    }
    reset(instance);
    return instance;
}

static int refuse(const Instance *instance, const char *name, double value, const char *legal)
{
    tell(instance, "parameter %s = %.9g is not legal: %s", name, (double)value, legal);
    return 0;
}

static int parameters_are_legal(const Instance *instance)
{
    const double tau = instance->state.params.tau;
    const double t0 = instance->state.params.t0;
    const double eps = instance->state.params.eps;
    const double u_max = instance->state.params.u_max;
    const double p_c = instance->state.params.c;

    if (!((isfinite(tau) != 0) && (1e-150 <= tau) && (tau <= 1e150))) {
        return refuse(instance, "tau", (double)instance->state.params.tau, "prescribed settling time [s], from 1e-150 to 1e150");
    }
    if (!((isfinite(t0) != 0))) {
        return refuse(instance, "t0", (double)instance->state.params.t0, "start time [s], finite");
    }
    if (!(eps >= 1e-150)) {
        return refuse(instance, "eps", (double)instance->state.params.eps, "time-to-go at which the gains are held [s], >= 1e-150");
    }
    if (!(u_max > 0.0)) {
        return refuse(instance, "u_max", (double)instance->state.params.u_max, "bound of |u| [unit of u], > 0");
    }
    if (!((0.5 <= p_c) && (p_c <= 2.0))) {
        return refuse(instance, "c", (double)instance->state.params.c, "parameter of an expression of the design [as in its expression], from 0.5 to 2");
    }
    if (!(eps < tau)) {
        return refuse(instance, "eps", (double)instance->state.params.eps, "time-to-go at which the gains are held [s], < tau");
    }
    return 1;
}

static int states_are_legal(const Instance *instance)
{
    int j;

    for (j = 0; j < 2; j++) {
        if (!isfinite(instance->state.x[j])) {
            tell(instance, "input x%d = %g is not legal: finite", j + 1, (double)instance->state.x[j]);
            return 0;
        }
    }
    return 1;
}

/* Hands the parameters to the controller, as often as one of them is set. */
static int arm(Instance *instance)
{
    State *state = &instance->state;

    if (!parameters_are_legal(instance)) {
        return 0;
    }
    if (state->latch) {
        if (!states_are_legal(instance)) {
            return 0;
        }
        memcpy(state->x0, state->x, sizeof state->x0);
    }
    state->latch = state->phase != STEPPING;
    if (duration_latched_init(&state->controller, &state->params, state->x0) != PTC_OK) {
        tell(instance, "each parameter is legal, but what duration_latched_init forms from them leaves the range: "
                       "take values nearer to 1");
        return 0;
    }
    state->armed = 1;
    memset(&state->steered, 0, sizeof state->steered);
    return 1;
}

/* Gives the controller another duration, where the deadline asked for has changed. */
static int steer(Instance *instance, double t)
{
    State *state = &instance->state;
    const double deadline = state->steering.deadline;

    if (!isfinite(deadline)) {
        tell(instance, "input deadline = %g is not legal: finite", (double)deadline);
        return 0;
    }
    if ((deadline != state->steered.deadline) && (deadline != 0.0)) {
        memcpy(state->x0, state->x, sizeof state->x0);
        if (duration_latched_arm_for(&state->controller, t, deadline - (t - state->params.t0), state->x0) != PTC_OK) {
            tell(instance, "input deadline = %g s is not legal at time %.9g s: what is left until then is no legal tau", (double)deadline, state->time);
            return 0;
        }
    }
    state->steered = state->steering;
    return 1;
}

/* Brings the outputs to time, state and parameters as they are. */
static int evaluate(Instance *instance)
{
    State *state = &instance->state;
    const double t = (double)state->time;
    ptc_status status;

    if (state->fresh) {
        return 1;
    }
    if ((!state->armed && !arm(instance)) || !states_are_legal(instance)) {
        return 0;
    }
    if (!(t >= state->params.t0)) {
        tell(instance, "time %.9g s lies before the start time t0 = %.9g s", state->time, (double)state->params.t0);
        return 0;
    }
    if (!steer(instance, t)) {
        return 0;
    }
    status = duration_latched_step(&state->controller, t, state->x, &state->u);
    if (status < 0) {
        tell(instance, "u is not finite at time %.9g s: the states are too large for the gains", state->time);
        return 0;
    }
    state->time_to_go = -((t - state->controller.deadline) - state->controller.correction);
    if (state->time_to_go < 0.0) {
        state->time_to_go = 0.0;
    }
    state->planned = (state->controller.deadline - state->params.t0) + state->controller.correction;
    state->status = (int)status;
    state->fresh = 1;
    return 1;
}

static int end_initialization(Instance *instance)
{
    instance->state.phase = STEPPING;
    instance->state.armed = 0;
    instance->state.fresh = 0;
    return evaluate(instance);
}

static int advance(Instance *instance, double from, double by)
{
    State *state = &instance->state;

    if (state->phase != STEPPING) {
        tell(instance, "a step before the initialization has ended, or after the simulation has");
        return 0;
    }
    if (!isfinite(from) || !isfinite(by) || (by < 0.0)) {
        tell(instance, "a step of %g s from time %g s on is not legal: finite, >= 0", by, from);
        return 0;
    }
    state->time = from + by;
    state->fresh = 0;
    return evaluate(instance);
}

/* Where an input or a parameter is kept; NULL for any other variable. */
static double *place(State *state, unsigned int reference)
{
    switch (reference) {
    case 1u:
        return &state->x[0];
    case 2u:
        return &state->x[1];
    case 3u:
        return &state->steering.deadline;
    case 8u:
        return &state->params.tau;
    case 9u:
        return &state->params.t0;
    case 10u:
        return &state->params.eps;
    case 11u:
        return &state->params.u_max;
    case 12u:
        return &state->params.c;
    default:
        return NULL;
    }
}

static int get_number(Instance *instance, unsigned int reference, double *value)
{
    const double *kept = place(&instance->state, reference);

    if (kept != NULL) {
        *value = *kept;
        return 1;
    }
    switch (reference) {
    case U:
    case TIME_TO_GO:
        if (!evaluate(instance)) {
            return 0;
        }
        *value = (reference == U) ? instance->state.u : instance->state.time_to_go;
        return 1;
    case STATUS + 1u:
        if (!evaluate(instance)) {
            return 0;
        }
        *value = instance->state.planned;
        return 1;
    default:
        tell(instance, "no number has the value reference %u", reference);
        return 0;
    }
}

static int set_number(Instance *instance, unsigned int reference, double value)
{
    State *state = &instance->state;
    double *kept = place(state, reference);

    if (kept == NULL) {
        tell(instance, "the variable with the value reference %u cannot be set", reference);
        return 0;
    }
    *kept = value;
    state->fresh = 0;
    if (reference > 3u) {
        state->armed = 0;
    }
    if (reference == 9u) {
        state->latch = 1;
    }
    if (state->latch) {
        state->armed = 0;
    }
    return 1;
}

static int get_integer(Instance *instance, unsigned int reference, int *value)
{
    if (reference != STATUS) {
        tell(instance, "no integer has the value reference %u", reference);
        return 0;
    }
    if (!evaluate(instance)) {
        return 0;
    }
    *value = instance->state.status;
    return 1;
}

static int set_integer(Instance *instance, unsigned int reference, int value)
{
    tell(instance, "the integer with the value reference %u cannot be set to %d", reference, value);
    return 0;
}

static int no_such_type(const Instance *instance, const char *type, size_t count)
{
    if (count > 0u) {
        tell(instance, "no variable that could be accessed so is of type %s", type);
    }
    return count == 0u;
}

static int unsupported(const Instance *instance, const char *what)
{
    tell(instance, "%s is not supported, as modelDescription.xml says", what);
    return 0;
}

/* A copy of the state in *kept, which may be one that is to be written over. */
static int keep_state(const Instance *instance, void **kept)
{
    if (*kept == NULL) {
        *kept = malloc(sizeof(State));
    }
    if (*kept == NULL) {
        tell(instance, "no memory for a copy of the state");
        return 0;
    }
    memcpy(*kept, &instance->state, sizeof(State));
    return 1;
}

static void free_instance(Instance *instance)
{
    if (instance != NULL) {
        free(instance->name);
        free(instance);
    }
}

static fmi2Status done(int succeeded)
{
    return succeeded ? fmi2OK : fmi2Error;
}

const char *fmi2GetTypesPlatform(void)
{
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void)
{
    return fmi2Version;
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean loggingOn, size_t nCategories,
                               const fmi2String categories[])
{
    /* Errors are told in any case, and nothing else is. */
    return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID,
                              fmi2String fmuResourceLocation,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean loggingOn)
{
    if ((functions == NULL) || (fmuType != fmi2CoSimulation)) {
        return NULL;
    }
    return instantiate(instanceName, fmuGUID, functions->componentEnvironment, functions->logger);
}

void fmi2FreeInstance(fmi2Component c)
{
    free_instance(c);
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance,
                               fmi2Real startTime, fmi2Boolean stopTimeDefined, fmi2Real stopTime)
{
    ((Instance *)c)->state.time = startTime;
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    ((Instance *)c)->state.phase = INITIALIZING;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    return done(end_initialization(c));
}

fmi2Status fmi2Terminate(fmi2Component c)
{
    ((Instance *)c)->state.phase = TERMINATED;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component c)
{
    reset(c);
    return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[])
{
    size_t i;

    for (i = 0; i < nvr; i++) {
        double number;
        if (!get_number(c, vr[i], &number)) {
            return fmi2Error;
        }
        value[i] = number;
    }
    return fmi2OK;
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Real value[])
{
    size_t i;

    for (i = 0; i < nvr; i++) {
        if (!set_number(c, vr[i], value[i])) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Integer value[])
{
    size_t i;

    for (i = 0; i < nvr; i++) {
        if (!get_integer(c, vr[i], &value[i])) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer value[])
{
    size_t i;

    for (i = 0; i < nvr; i++) {
        if (!set_integer(c, vr[i], value[i])) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Boolean value[])
{
    return done(no_such_type(c, "Boolean", nvr));
}

fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Boolean value[])
{
    return done(no_such_type(c, "Boolean", nvr));
}

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2String value[])
{
    return done(no_such_type(c, "String", nvr));
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2String value[])
{
    return done(no_such_type(c, "String", nvr));
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    return done(keep_state(c, FMUstate));
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate FMUstate)
{
    memcpy(&((Instance *)c)->state, FMUstate, sizeof(State));
    return fmi2OK;
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    free(*FMUstate);
    *FMUstate = NULL;
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate FMUstate, size_t *size)
{
    return done(unsupported(c, "a state in bytes"));
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate FMUstate, fmi2Byte bytes[], size_t size)
{
    return done(unsupported(c, "a state in bytes"));
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *FMUstate)
{
    return done(unsupported(c, "a state in bytes"));
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference vUnknown_ref[],
                                        size_t nUnknown, const fmi2ValueReference vKnown_ref[],
                                        size_t nKnown, const fmi2Real dvKnown[], fmi2Real dvUnknown[])
{
    return done(unsupported(c, "a directional derivative"));
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                       const fmi2Integer order[], const fmi2Real value[])
{
    return done(unsupported(c, "a derivative of an input"));
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                        const fmi2Integer order[], fmi2Real value[])
{
    return done(unsupported(c, "a derivative of an output"));
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real currentCommunicationPoint,
                      fmi2Real communicationStepSize, fmi2Boolean noSetFMUStatePriorToCurrentPoint)
{
    return done(advance(c, currentCommunicationPoint, communicationStepSize));
}

fmi2Status fmi2CancelStep(fmi2Component c)
{
    return done(unsupported(c, "a step that can be cancelled"));
}

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind s, fmi2Status *value)
{
    return fmi2Discard;
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind s, fmi2Real *value)
{
    if (s == fmi2LastSuccessfulTime) {
        *value = ((Instance *)c)->state.time;
        return fmi2OK;
    }
    return fmi2Discard;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind s, fmi2Integer *value)
{
    return fmi2Discard;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind s, fmi2Boolean *value)
{
    if (s == fmi2Terminated) {
        *value = fmi2False;
        return fmi2OK;
    }
    return fmi2Discard;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind s, fmi2String *value)
{
    return fmi2Discard;
}
