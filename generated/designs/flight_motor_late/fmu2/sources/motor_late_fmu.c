/* FMI 2.0 co-simulation around the controller in motor_late.c. DO NOT EDIT.
 *
 * The outputs are those of the communication point and of the inputs as they are when they are read:
 * set x1..x2, get u, give it to the plant, step. Linked statically, with other FMUs, it is
 * compiled with FMI2_FUNCTION_PREFIX=motor_late_.
 */
#include "fmi2Functions.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "motor_late.h"

/* The interface hands over more than this FMU has a use for. */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

/* The token of modelDescription.xml: a hash of the whole text of this FMU. */
#define TOKEN "{47b65297-2dbf-5b08-d886-93cdea5bcae7}"

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
    motor_late controller;
    motor_late next; /* what the sample makes of it */
    uint32_t k; /* samples since the start */
    motor_late_params params;
    double x[2]; /* what is measured */
    double u;
    double seen[2]; /* what is measured, from the target */
    Steering steering;
    Steering steered; /* that of the sample before */
    int refused; /* the deadline asked for at this sample is too soon */
    double planned;
    double soonest;
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

    for (j = 0; j < 2; j++) {
        if (!isfinite(instance->state.x[j])) {
            tell(instance, "input x%d = %g is not legal: finite", j + 1, (double)instance->state.x[j]);
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
    if (motor_late_init(&state->controller, &state->params) != PTC_OK) {
        tell(instance, "each parameter is legal, but what motor_late_init forms from them leaves the range: "
                       "take values nearer to 1");
        return 0;
    }
    state->armed = 1;
    memset(&state->steered, 0, sizeof state->steered);
    return 1;
}

/* Hands what has changed since the last sample to the controller, before its step. */
static int steer(Instance *instance)
{
    State *state = &instance->state;
    const Steering *now = &state->steering;
    const Steering *before = &state->steered;

    state->refused = 0;
    if (!isfinite(state->steering.deadline)) {
        tell(instance, "input deadline = %g is not legal: finite", (double)state->steering.deadline);
        return 0;
    }
    if ((now->deadline != before->deadline) && (now->deadline != 0)) {
        const double tick = floor((double)now->deadline / (double)(0.01) + 0.5);
        ptc_status status = PTC_E_PARAM;

        if ((tick > (double)state->k) && (tick - (double)state->k <= 2147483648.0)) {
            status = motor_late_arm_for(&state->next, state->k, (uint32_t)(tick - (double)state->k));
        }
        if (status == PTC_E_SOON) {
            state->refused = 1;
        } else if (status != PTC_OK) {
            tell(instance, "input deadline = %g s is not legal at sample %lu: too few samples to rest, or too many", (double)now->deadline,
                 (unsigned long)state->k);
            return 0;
        }
    }
    return 1;
}

/* The deadline as it is planned, and the soonest one, as times from the start. */
static void look_ahead(State *state, ptc_status found, uint32_t soonest)
{
    uint32_t tick = state->k;

    (void)motor_late_deadline(&state->next, &tick);
    state->time_to_go = 0.01 * (double)((tick - state->k <= 2147483648u) ? tick - state->k : 0u);
    state->planned = 0.01 * (double)tick;
    state->soonest = (found == PTC_OK) ? 0.01 * (double)(state->k + soonest) : -1;
}
/* Brings the outputs to sample, measurement and parameters as they are. The controller is changed
 * by advance alone, which ends the sample. */
static int evaluate(Instance *instance)
{
    State *state = &instance->state;
    ptc_status found = PTC_E_SOON;
    uint32_t soonest = 0u;
    ptc_status status;

    if (state->fresh) {
        return 1;
    }
    if ((!state->armed && !arm(instance)) || !states_are_legal(instance)) {
        return 0;
    }
    state->next = state->controller;
    memcpy(state->seen, state->x, sizeof state->seen);
    if (!steer(instance)) {
        return 0;
    }
    found = motor_late_soonest(&state->next, state->seen, &soonest);
    status = motor_late_step(&state->next, state->k, state->seen, &state->u);
    if (status < 0) {
        tell(instance, "u is not finite at sample %lu: the measurements are too large for the gains",
             (unsigned long)state->k);
        return 0;
    }
    look_ahead(state, found, soonest);
    state->status = state->refused ? (int)PTC_E_SOON : (int)status;
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
    const double period = (double)(0.01);

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
    state->steered = state->steering;
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
        return &state->x[1];
    case 3u:
        return &state->steering.deadline;
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
        if (!evaluate(instance)) {
            return 0;
        }
        *value = (reference == STATUS + 1u) ? instance->state.planned : instance->state.soonest;
        return 1;
    case 10u:
        *value = 0.01;
        return 1;
    case 11u:
        *value = 0.0;
        return 1;
    case 12u:
        *value = 10.0;
        return 1;
    case 13u:
        *value = 1.0;
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
    return 1;
}

static int get_integer(Instance *instance, unsigned int reference, int *value)
{
    if (reference == 9u) {
        *value = 20;
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
