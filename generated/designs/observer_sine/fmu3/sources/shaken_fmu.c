/* FMI 3.0 co-simulation around the controller in shaken.c. DO NOT EDIT.
 *
 * The outputs are those of the communication point and of the inputs as they are when they are read:
 * set y1..y1, get u, give it to the plant, step. Linked statically, with other FMUs, it is
 * compiled with FMI3_FUNCTION_PREFIX=shaken_.
 */
#include "fmi3Functions.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shaken.h"

/* The interface hands over more than this FMU has a use for. */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

/* The token of modelDescription.xml: a hash of the whole text of this FMU. */
#define TOKEN "{a0a1e041-8cb4-fa53-4f9e-35fdeae835f0}"

/* Value references of outputs that are no inputs or parameters. */
#define U 2u
#define TIME_TO_GO 3u
#define STATUS 4u

enum phase { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED };

/* What fmi3GetFMUState keeps. */
typedef struct State {
    shaken controller;
    shaken next; /* what the sample makes of it */
    uint32_t k; /* samples since the start */
    shaken_params params;
    double x[1]; /* what is measured */
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
    fmi3LogMessageCallback logger;
} Instance;

static void tell(const Instance *instance, const char *format, ...)
{
    char text[512];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (instance->logger != NULL) {
        instance->logger(instance->environment, fmi3Error, "logStatusError", text);
    }
}

/* Sets everything to its start value. */
static void reset(Instance *instance)
{
    State *state = &instance->state;

    memset(state, 0, sizeof *state);
}

static Instance *instantiate(const char *name, const char *token, void *environment,
                             fmi3LogMessageCallback logger)
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
    return 1;
}

/* Hands the parameters to the controller, as often as one of them is set; it begins anew then. */
static int arm(Instance *instance)
{
    State *state = &instance->state;

    if (!parameters_are_legal(instance)) {
        return 0;
    }
    if (shaken_init(&state->controller, &state->params) != PTC_OK) {
        tell(instance, "each parameter is legal, but what shaken_init forms from them leaves the range: "
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
    const uint32_t samples = 600u;
    ptc_status status;

    if (state->fresh) {
        return 1;
    }
    if ((!state->armed && !arm(instance)) || !states_are_legal(instance)) {
        return 0;
    }
    state->next = state->controller;
    status = shaken_step(&state->next, state->k, state->x, &state->u);
    if (status < 0) {
        tell(instance, "u is not finite at sample %lu: the measurements are too large for the gains",
             (unsigned long)state->k);
        return 0;
    }
    (void)shaken_estimate(&state->next, state->estimates);
    (void)shaken_disturbance(&state->next, &state->estimates[2]);
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
    case 9u:
        *value = 0.001;
        return 1;
    case 10u:
        *value = 0.01;
        return 1;
    case 11u:
        *value = 8.0;
        return 1;
    case 12u:
        *value = 1.0;
        return 1;
    case 13u:
        *value = 12.0;
        return 1;
    case 14u:
        *value = 7.0;
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
    if (reference > 1u) {
        state->armed = 0;
    }
    return 1;
}

static int get_integer(Instance *instance, unsigned int reference, int *value)
{
    if (reference == 8u) {
        *value = 600;
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

static fmi3Status done(int succeeded)
{
    return succeeded ? fmi3OK : fmi3Error;
}

const char*fmi3GetVersion(void)
{
    return fmi3Version;
}

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean loggingOn, size_t nCategories,
        const fmi3String categories[])
{
    /* Errors are told in any case, and nothing else is. */
    return fmi3OK;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String instanceName, fmi3String instantiationToken,
        fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
        fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage)
{
    return NULL;
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String instanceName, fmi3String instantiationToken,
        fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
        fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
        const fmi3ValueReference requiredIntermediateVariables[],
        size_t nRequiredIntermediateVariables, fmi3InstanceEnvironment instanceEnvironment,
        fmi3LogMessageCallback logMessage, fmi3IntermediateUpdateCallback intermediateUpdate)
{
    return instantiate(instanceName, instantiationToken, instanceEnvironment, logMessage);
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String instanceName,
        fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible,
        fmi3Boolean loggingOn, fmi3InstanceEnvironment instanceEnvironment,
        fmi3LogMessageCallback logMessage, fmi3ClockUpdateCallback clockUpdate,
        fmi3LockPreemptionCallback lockPreemption, fmi3UnlockPreemptionCallback unlockPreemption)
{
    return NULL;
}

void fmi3FreeInstance(fmi3Instance instance)
{
    free_instance(instance);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean toleranceDefined,
        fmi3Float64 tolerance, fmi3Float64 startTime, fmi3Boolean stopTimeDefined,
        fmi3Float64 stopTime)
{
    State *state = &((Instance *)instance)->state;

    state->phase = INITIALIZING;
    state->time = startTime;
    state->fresh = 0;
    return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance)
{
    return done(end_initialization(instance));
}

fmi3Status fmi3EnterEventMode(fmi3Instance instance)
{
    return done(unsupported(instance, "event mode"));
}

fmi3Status fmi3Terminate(fmi3Instance instance)
{
    ((Instance *)instance)->state.phase = TERMINATED;
    return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance instance)
{
    reset(instance);
    return fmi3OK;
}

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, fmi3Float64 values[], size_t nValues)
{
    size_t i;

    if (nValues != nValueReferences) {
        return fmi3Error;
    }
    for (i = 0; i < nValueReferences; i++) {
        if (valueReferences[i] == 0u) {
            values[i] = ((Instance *)instance)->state.time;
        } else
        if (!get_number(instance, valueReferences[i], &values[i])) {
            return fmi3Error;
        }
    }
    return fmi3OK;
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, const fmi3Float64 values[], size_t nValues)
{
    size_t i;

    if (nValues != nValueReferences) {
        return fmi3Error;
    }
    for (i = 0; i < nValueReferences; i++) {
        if (!set_number(instance, valueReferences[i], values[i])) {
            return fmi3Error;
        }
    }
    return fmi3OK;
}

/* Types of which there is no variable. */
#define NO_VARIABLE_OF(type) \
    fmi3Status fmi3Get##type(fmi3Instance instance, const fmi3ValueReference valueReferences[], \
                             size_t nValueReferences, fmi3##type values[], size_t nValues) \
    { \
        return done(no_such_type(instance, #type, nValueReferences)); \
    } \
    fmi3Status fmi3Set##type(fmi3Instance instance, const fmi3ValueReference valueReferences[], \
                             size_t nValueReferences, const fmi3##type values[], size_t nValues) \
    { \
        return done(no_such_type(instance, #type, nValueReferences)); \
    }

NO_VARIABLE_OF(Float32)
NO_VARIABLE_OF(Int8)
NO_VARIABLE_OF(UInt8)
NO_VARIABLE_OF(Int16)
NO_VARIABLE_OF(UInt16)
NO_VARIABLE_OF(UInt32)
NO_VARIABLE_OF(Int64)
NO_VARIABLE_OF(UInt64)
NO_VARIABLE_OF(Boolean)
NO_VARIABLE_OF(String)

fmi3Status fmi3GetInt32(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, fmi3Int32 values[], size_t nValues)
{
    size_t i;

    if (nValues != nValueReferences) {
        return fmi3Error;
    }
    for (i = 0; i < nValueReferences; i++) {
        int status;
        if (!get_integer(instance, valueReferences[i], &status)) {
            return fmi3Error;
        }
        values[i] = (fmi3Int32)status;
    }
    return fmi3OK;
}

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, size_t valueSizes[], fmi3Binary values[], size_t nValues)
{
    return done(no_such_type(instance, "Binary", nValueReferences));
}

fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, fmi3Clock values[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3SetInt32(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, const fmi3Int32 values[], size_t nValues)
{
    size_t i;

    if (nValues != nValueReferences) {
        return fmi3Error;
    }
    for (i = 0; i < nValueReferences; i++) {
        if (!set_integer(instance, valueReferences[i], (int)values[i])) {
            return fmi3Error;
        }
    }
    return fmi3OK;
}

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, const size_t valueSizes[], const fmi3Binary values[],
        size_t nValues)
{
    return done(no_such_type(instance, "Binary", nValueReferences));
}

fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, const fmi3Clock values[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance,
        fmi3ValueReference valueReference, size_t* nDependencies)
{
    return done(unsupported(instance, "the run-time query of dependencies"));
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
        size_t elementIndicesOfDependent[], fmi3ValueReference independents[],
        size_t elementIndicesOfIndependents[], fmi3DependencyKind dependencyKinds[],
        size_t nDependencies)
{
    return done(unsupported(instance, "the run-time query of dependencies"));
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* FMUState)
{
    return done(keep_state(instance, FMUState));
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState FMUState)
{
    memcpy(&((Instance *)instance)->state, FMUState, sizeof(State));
    return fmi3OK;
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* FMUState)
{
    free(*FMUState);
    *FMUState = NULL;
    return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState FMUState, size_t* size)
{
    return done(unsupported(instance, "a state in bytes"));
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState FMUState,
        fmi3Byte serializedState[], size_t size)
{
    return done(unsupported(instance, "a state in bytes"));
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte serializedState[],
        size_t size, fmi3FMUState* FMUState)
{
    return done(unsupported(instance, "a state in bytes"));
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
        size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,
        const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[], size_t nSensitivity)
{
    return done(unsupported(instance, "a directional derivative"));
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
        size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,
        const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[], size_t nSensitivity)
{
    return done(unsupported(instance, "an adjoint derivative"));
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance)
{
    return done(unsupported(instance, "configuration mode"));
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance)
{
    return done(unsupported(instance, "configuration mode"));
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance,
        const fmi3ValueReference valueReferences[], size_t nValueReferences, fmi3UInt64 counters[],
        fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, fmi3Float64 shifts[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3GetShiftFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, const fmi3Float64 intervals[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance instance,
        const fmi3ValueReference valueReferences[], size_t nValueReferences,
        const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, const fmi3Float64 shifts[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3SetShiftFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
        size_t nValueReferences, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
{
    return done(no_such_type(instance, "Clock", nValueReferences));
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance)
{
    return done(unsupported(instance, "event mode"));
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean* discreteStatesNeedUpdate,
        fmi3Boolean* terminateSimulation, fmi3Boolean* nominalsOfContinuousStatesChanged,
        fmi3Boolean* valuesOfContinuousStatesChanged, fmi3Boolean* nextEventTimeDefined,
        fmi3Float64* nextEventTime)
{
    return done(unsupported(instance, "event mode"));
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance,
        fmi3Boolean noSetFMUStatePriorToCurrentPoint, fmi3Boolean* enterEventMode,
        fmi3Boolean* terminateSimulation)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 continuousStates[],
        size_t nContinuousStates)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[],
        size_t nContinuousStates)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 eventIndicators[],
        size_t nEventIndicators)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 continuousStates[],
        size_t nContinuousStates)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[],
        size_t nContinuousStates)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t* nEventIndicators)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t* nContinuousStates)
{
    return done(unsupported(instance, "model exchange"));
}

fmi3Status fmi3EnterStepMode(fmi3Instance instance)
{
    return fmi3OK;
}

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance,
        const fmi3ValueReference valueReferences[], size_t nValueReferences,
        const fmi3Int32 orders[], fmi3Float64 values[], size_t nValues)
{
    return done(unsupported(instance, "a derivative of an output"));
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 currentCommunicationPoint,
        fmi3Float64 communicationStepSize, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
        fmi3Boolean* eventHandlingNeeded, fmi3Boolean* terminateSimulation,
        fmi3Boolean* earlyReturn, fmi3Float64* lastSuccessfulTime)
{
    const int succeeded = advance(instance, currentCommunicationPoint, communicationStepSize);

    *eventHandlingNeeded = fmi3False;
    *terminateSimulation = fmi3False;
    *earlyReturn = fmi3False;
    *lastSuccessfulTime = ((Instance *)instance)->state.time;
    return done(succeeded);
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clockReference,
        fmi3Float64 activationTime)
{
    return done(unsupported(instance, "scheduled execution"));
}
