/* FMI 2.0 co-simulation around the controller in stage40.c. DO NOT EDIT.
 *
 * The outputs are those of the communication point and of the inputs as they are when they are read:
 * set y1..y1, r0..r2, get u, give it to the plant, step. Linked statically, with other FMUs, it is
 * compiled with FMI2_FUNCTION_PREFIX=stage40_.
 */
#include "fmi2Functions.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stage40.h"

/* The interface hands over more than this FMU has a use for. */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

/* The token of modelDescription.xml: a hash of the whole text of this FMU. */
#define TOKEN "{a0c15b33-3f22-eab3-f77c-83fba76c032e}"

/* Value references of outputs that are no inputs or parameters. */
#define U 5u
#define TIME_TO_GO 6u
#define STATUS 7u

enum phase { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED };

/* What fmi2GetFMUstate keeps. */
typedef struct State {
    stage40 controller;
    stage40 next; /* what the sample makes of it */
    uint32_t k; /* samples since the start */
    stage40_params params;
    double x[1]; /* what is measured */
    double r[3]; /* the reference and its derivatives */
    double u;
    double estimates[3]; /* behind the sample, that of d last */
    double time_to_go;
    int status;
    double time;
    int armed; /* the controller has the parameters in params */
    int fresh; /* the outputs are those of sample, x and params, or held */
    int held; /* the outputs are those of the sample that the last step ended */
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

static int parameters_are_legal(const Instance *instance)
{

    (void)instance;
    return 1;
}

static int states_are_legal(const Instance *instance)
{
    int j;

    for (j = 0; j < 1; j++) {
        if (!isfinite(instance->state.x[j])) {
            tell(instance, "input y%d = %g is not legal: finite", j + 1, (double)instance->state.x[j]);
            return 0;
        }
    }
    for (j = 0; j < 3; j++) {
        if (!isfinite(instance->state.r[j])) {
            tell(instance, "input r%d = %g is not legal: finite", j, (double)instance->state.r[j]);
            return 0;
        }
    }
    return 1;
}

/* Hands the parameters to the controller, as often as one of them is set; it begins anew then. */
static int arm(Instance *instance)
{
    State *state = &instance->state;

    if (!parameters_are_legal(instance)) {
        return 0;
    }
    if (stage40_init(&state->controller, &state->params) != PTC_OK) {
        tell(instance, "each parameter is legal, but what stage40_init forms from them leaves the range: "
                       "take values nearer to 1");
        return 0;
    }
    state->armed = 1;
    return 1;
}

/* Brings the outputs to sample, measurement and parameters as they are. The controller is changed
 * by advance alone, which ends the sample. */
static int evaluate(Instance *instance)
{
    State *state = &instance->state;
    const uint32_t samples = 40u;
    ptc_status status;

    if (state->fresh) {
        return 1;
    }
    if ((!state->armed && !arm(instance)) || !states_are_legal(instance)) {
        return 0;
    }
    state->next = state->controller;
    status = stage40_step(&state->next, state->k, state->x, state->r, &state->u);
    if (status < 0) {
        tell(instance, "u is not finite at sample %lu: the measurements are too large for the gains",
             (unsigned long)state->k);
        return 0;
    }
    (void)stage40_estimate(&state->next, state->estimates);
    (void)stage40_disturbance(&state->next, &state->estimates[2]);
    state->time_to_go = 0.001 * (double)((state->k < samples) ? samples - state->k : 0u);
    state->status = (int)status;
    state->fresh = 1;
    state->held = 0;
    return 1;
}

static int end_initialization(Instance *instance)
{
    instance->state.phase = STEPPING;
    instance->state.armed = 0;
    instance->state.fresh = 0;
    instance->state.held = 0;
    instance->state.k = 0u;
    return evaluate(instance);
}

/* Ends the sample, with the u that the importer has read or else computes now, and begins the next.
 * The outputs are held until an input is set: an importer that reads u after the step reads the u
 * of the sample that has ended, which the controller remembers. */
static int advance(Instance *instance, double from, double by)
{
    State *state = &instance->state;
    const double period = (double)(0.001);

    if (state->phase != STEPPING) {
        tell(instance, "a step before the initialization has ended, or after the simulation has");
        return 0;
    }
    if (!isfinite(from) || !(fabs(by - period) <= 1e-6 * period)) {
        tell(instance, "a step of %g s from time %g s on is not legal: the sample period, %g s", by, from, period);
        return 0;
    }
    if (state->held) {
        state->fresh = 0; /* no input was set since the last step */
    }
    if (!evaluate(instance)) {
        return 0;
    }
    state->controller = state->next;
    state->k++;
    state->time = from + by;
    state->held = 1;
    return 1;
}

/* Where an input or a parameter is kept; NULL for any other variable. */
static double *place(State *state, unsigned int reference)
{
    switch (reference) {
    case 1u:
        return &state->x[0];
    case 2u:
        return &state->r[0];
    case 3u:
        return &state->r[1];
    case 4u:
        return &state->r[2];
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
    case STATUS + 2u:
    case STATUS + 3u:
        if (!evaluate(instance)) {
            return 0;
        }
        *value = instance->state.estimates[reference - STATUS - 1u];
        return 1;
    case 12u:
        *value = 0.001;
        return 1;
    case 13u:
        *value = 0.0;
        return 1;
    case 14u:
        *value = 6.0;
        return 1;
    case 15u:
        *value = 1.0;
        return 1;
    case 16u:
        *value = 120.0;
        return 1;
    case 17u:
        *value = 74.0;
        return 1;
    case 18u:
        *value = 15.0;
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
    if (reference > 4u) {
        state->armed = 0;
    }
    return 1;
}

static int get_integer(Instance *instance, unsigned int reference, int *value)
{
    if (reference == 11u) {
        *value = 40;
        return 1;
    }
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
