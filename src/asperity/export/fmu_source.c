/* A traction-drive joint as an FMI 2.0 co-simulation unit: angles of motor and output in, torques out.
 *
 * The angle by which the output lies behind the motor, motor_angle/reduction - output_angle, is made of
 *     reversible wind-up    a table over the torque
 *     play                  angle/2 tanh(torque/take_up_torque)
 *     slip                  elements in series, each a spring beside a slider that moves beyond a threshold of the
 *                           torque: z follows the torque within +-threshold, its angle is compliance * z
 *     drift                 grows by drift(torque)/(2 pi) with every angle that the motor turns the output
 * Each of them grows with the torque, so that one torque belongs to every angle; it is found by halving an interval,
 * the slip and the drift of the step included. joint_data.h has the sizes and the start values.
 */

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "joint_data.h"

/* ---- what FMI 2.0 lays down ---- */

#if defined(_WIN32)
#define EXPORTED __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif
#ifdef FMI2_FUNCTION_PREFIX
#define JOIN_AGAIN(a, b) a##b
#define JOIN(a, b) JOIN_AGAIN(a, b)
#define NAME(name) JOIN(FMI2_FUNCTION_PREFIX, name)
#else
#define NAME(name) name
#endif

typedef void *Component;
typedef void *State;
typedef double Real;
typedef int Integer;
typedef int Boolean;
typedef const char *String;
typedef char Byte;
typedef unsigned int Reference;
typedef enum { OK, WARNING, DISCARD, ERROR, FATAL, PENDING } Status;
typedef struct {
    void (*logger)(void *, String, Status, String, String, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*finished)(void *, Status);
    void *environment;
} Callbacks;

/* ---- variables: their places are the value references ---- */

enum {
    MOTOR_ANGLE,
    OUTPUT_ANGLE,
    MOTOR_SPEED,
    OUTPUT_SPEED,
    OUTPUT_TORQUE,
    MOTOR_TORQUE,
    WINDUP,
    DRIFT,
    OUT_OF_RANGE,
    REDUCTION,
    STIFFNESS_FACTOR,
    SLIP_FACTOR,
    DRIFT_FACTOR,
    DAMPING,
    FRICTION,
    FRICTION_SPEED,
    PLAY_ANGLE,
    TAKE_UP_TORQUE,
    TORQUES,
    REVERSIBLE = TORQUES + POINTS,
    DRIVING = REVERSIBLE + POINTS,
    BRAKING = DRIVING + POINTS,
    THRESHOLDS = BRAKING + POINTS,
    COMPLIANCES = THRESHOLDS + ELEMENTS,
    VARIABLES = COMPLIANCES + ELEMENTS
};

typedef struct {
    Real value[VARIABLES];
    Real slip[ELEMENTS + 1]; /* where the slider of each element lies, a torque */
    Real drift;
    Real last_motor_angle;
    int started;
} Joint;

static const Real start[VARIABLES] = {START};

/* A table over the torque; beyond its ends it goes on as a straight line. */
static Real interpolated(const Joint *joint, int column, Real torque) {
    const Real *x = joint->value + TORQUES, *y = joint->value + column;
    int low = 0, high = POINTS - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (torque < x[middle]) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return y[low] + (y[high] - y[low]) * (torque - x[low]) / (x[high] - x[low]);
}

static Real slider(const Joint *joint, int element, Real torque) {
    Real threshold = joint->value[THRESHOLDS + element], place = joint->slip[element];
    if (place < torque - threshold) {
        return torque - threshold;
    }
    return place > torque + threshold ? torque + threshold : place;
}

static Real windup(const Joint *joint, Real torque) {
    const Real *value = joint->value;
    Real angle = interpolated(joint, REVERSIBLE, torque), play = 0.5 * value[PLAY_ANGLE];
    int element;
    for (element = 0; element < ELEMENTS; ++element) {
        angle += value[SLIP_FACTOR] * value[COMPLIANCES + element] * slider(joint, element, torque);
    }
    angle /= value[STIFFNESS_FACTOR];
    if (value[TAKE_UP_TORQUE] > 0.0) {
        return angle + play * tanh(torque / value[TAKE_UP_TORQUE]);
    }
    return angle + (torque > 0.0 ? play : torque < 0.0 ? -play : 0.0);
}

/* What the drift grows by while the motor turns under a torque; turned: its angle at the output, without the drift.
 * The table counts turns of the output, which are fewer by the drift, or more where the torque brakes. */
static Real drifted(const Joint *joint, Real torque, Real turned) {
    int brakes = torque * turned < 0.0;
    Real per_angle = joint->value[DRIFT_FACTOR] * interpolated(joint, brakes ? BRAKING : DRIVING, torque);
    per_angle /= 6.283185307179586;
    return per_angle * fabs(turned) / (1.0 + (brakes ? -1.0 : 1.0) * fabs(per_angle));
}

static void settle(Joint *joint) {
    Real *value = joint->value, largest = value[TORQUES + POINTS - 1], damper, speed, low, high, behind, turned;
    int element, halving;
    turned = joint->started ? (value[MOTOR_ANGLE] - joint->last_motor_angle) / value[REDUCTION] : 0.0;
    behind = value[MOTOR_ANGLE] / value[REDUCTION] - value[OUTPUT_ANGLE] - joint->drift;
    low = value[TORQUES] < -largest ? value[TORQUES] : -largest;
    high = -low;
    for (halving = 0; halving < 60 && windup(joint, low) + drifted(joint, low, turned) > behind; ++halving) {
        low *= 2.0;
    }
    for (halving = 0; halving < 60 && windup(joint, high) + drifted(joint, high, turned) < behind; ++halving) {
        high *= 2.0;
    }
    for (halving = 0; halving < 100; ++halving) {
        Real middle = 0.5 * (low + high);
        if (windup(joint, middle) + drifted(joint, middle, turned) < behind) {
            low = middle;
        } else {
            high = middle;
        }
    }
    high = 0.5 * (low + high);
    joint->drift += drifted(joint, high, turned);
    value[WINDUP] = behind - drifted(joint, high, turned); /* also within the play, where there is no torque */
    for (element = 0; element < ELEMENTS; ++element) {
        joint->slip[element] = slider(joint, element, high);
    }
    speed = value[MOTOR_SPEED] / value[REDUCTION] - value[OUTPUT_SPEED];
    damper = value[DAMPING] * speed;
    value[OUTPUT_TORQUE] = high + damper;
    value[MOTOR_TORQUE] = value[OUTPUT_TORQUE] / value[REDUCTION];
    if (value[FRICTION] != 0.0) {
        value[MOTOR_TORQUE] += value[FRICTION] * tanh(value[MOTOR_SPEED] / value[FRICTION_SPEED]);
    }
    value[DRIFT] = joint->drift;
    value[OUT_OF_RANGE] = high < value[TORQUES] || high > largest ? 1.0 : 0.0;
    joint->last_motor_angle = value[MOTOR_ANGLE];
    joint->started = 1;
}

static void reset(Joint *joint) {
    memset(joint, 0, sizeof *joint);
    memcpy(joint->value, start, sizeof start);
}

/* ---- functions of FMI 2.0 ---- */

EXPORTED String NAME(fmi2GetTypesPlatform)(void) { return "default"; }
EXPORTED String NAME(fmi2GetVersion)(void) { return "2.0"; }

EXPORTED Component NAME(fmi2Instantiate)(String name, int kind, String guid, String resources,
                                         const Callbacks *callbacks, Boolean visible, Boolean logging) {
    Joint *joint;
    (void)name, (void)resources, (void)callbacks, (void)visible, (void)logging;
    if (kind != 1 || guid == NULL || strcmp(guid, GUID) != 0) { /* 1: co-simulation */
        return NULL;
    }
    joint = malloc(sizeof *joint);
    if (joint != NULL) {
        reset(joint);
    }
    return joint;
}

EXPORTED void NAME(fmi2FreeInstance)(Component joint) { free(joint); }

EXPORTED Status NAME(fmi2SetDebugLogging)(Component joint, Boolean on, size_t count, const String names[]) {
    (void)joint, (void)on, (void)count, (void)names;
    return OK;
}

EXPORTED Status NAME(fmi2SetupExperiment)(Component joint, Boolean has_tolerance, Real tolerance, Real begin,
                                          Boolean has_end, Real end) {
    (void)joint, (void)has_tolerance, (void)tolerance, (void)begin, (void)has_end, (void)end;
    return OK;
}

EXPORTED Status NAME(fmi2EnterInitializationMode)(Component joint) {
    (void)joint;
    return OK;
}

EXPORTED Status NAME(fmi2ExitInitializationMode)(Component joint) {
    settle(joint);
    return OK;
}

EXPORTED Status NAME(fmi2Terminate)(Component joint) {
    (void)joint;
    return OK;
}

EXPORTED Status NAME(fmi2Reset)(Component joint) {
    reset(joint);
    return OK;
}

EXPORTED Status NAME(fmi2GetReal)(Component component, const Reference at[], size_t count, Real value[]) {
    size_t each;
    for (each = 0; each < count; ++each) {
        if (at[each] >= VARIABLES) {
            return ERROR;
        }
        value[each] = ((Joint *)component)->value[at[each]];
    }
    return OK;
}

EXPORTED Status NAME(fmi2SetReal)(Component component, const Reference at[], size_t count, const Real value[]) {
    size_t each;
    for (each = 0; each < count; ++each) {
        if (at[each] >= VARIABLES) {
            return ERROR;
        }
        ((Joint *)component)->value[at[each]] = value[each];
    }
    return OK;
}

EXPORTED Status NAME(fmi2DoStep)(Component joint, Real now, Real step, Boolean keep) {
    (void)now, (void)step, (void)keep;
    settle(joint);
    return OK;
}

EXPORTED Status NAME(fmi2GetFMUstate)(Component component, State *state) {
    if (*state == NULL) {
        *state = malloc(sizeof(Joint));
    }
    if (*state == NULL) {
        return ERROR;
    }
    memcpy(*state, component, sizeof(Joint));
    return OK;
}

EXPORTED Status NAME(fmi2SetFMUstate)(Component component, State state) {
    memcpy(component, state, sizeof(Joint));
    return OK;
}

EXPORTED Status NAME(fmi2FreeFMUstate)(Component component, State *state) {
    (void)component;
    free(*state);
    *state = NULL;
    return OK;
}

/* What this unit has none of. */
#define NONE(name, arguments, answer) \
    EXPORTED Status NAME(name) arguments { return answer; }
NONE(fmi2GetInteger, (Component c, const Reference r[], size_t n, Integer v[]), n > 0 ? ERROR : OK)
NONE(fmi2GetBoolean, (Component c, const Reference r[], size_t n, Boolean v[]), n > 0 ? ERROR : OK)
NONE(fmi2GetString, (Component c, const Reference r[], size_t n, String v[]), n > 0 ? ERROR : OK)
NONE(fmi2SetInteger, (Component c, const Reference r[], size_t n, const Integer v[]), n > 0 ? ERROR : OK)
NONE(fmi2SetBoolean, (Component c, const Reference r[], size_t n, const Boolean v[]), n > 0 ? ERROR : OK)
NONE(fmi2SetString, (Component c, const Reference r[], size_t n, const String v[]), n > 0 ? ERROR : OK)
NONE(fmi2SerializedFMUstateSize, (Component c, State s, size_t *n), ERROR)
NONE(fmi2SerializeFMUstate, (Component c, State s, Byte b[], size_t n), ERROR)
NONE(fmi2DeSerializeFMUstate, (Component c, const Byte b[], size_t n, State *s), ERROR)
NONE(fmi2GetDirectionalDerivative,
     (Component c, const Reference u[], size_t n, const Reference k[], size_t m, const Real d[], Real v[]), ERROR)
NONE(fmi2SetRealInputDerivatives,
     (Component c, const Reference r[], size_t n, const Integer o[], const Real v[]), ERROR)
NONE(fmi2GetRealOutputDerivatives,
     (Component c, const Reference r[], size_t n, const Integer o[], Real v[]), ERROR)
NONE(fmi2CancelStep, (Component c), ERROR)
NONE(fmi2GetStatus, (Component c, int k, Status *v), DISCARD)
NONE(fmi2GetRealStatus, (Component c, int k, Real *v), DISCARD)
NONE(fmi2GetIntegerStatus, (Component c, int k, Integer *v), DISCARD)
NONE(fmi2GetBooleanStatus, (Component c, int k, Boolean *v), DISCARD)
NONE(fmi2GetStringStatus, (Component c, int k, String *v), DISCARD)
