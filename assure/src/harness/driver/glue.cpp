// One controller behind `drive`, as in glue.c, with the same macros; NAME is its class.
#include <array>
#include <cstdint>
#include <cstring>

#include HEADER

#define JOIN(a, b) a##b
#define OF(name, part) JOIN(name, part)

#if LATCHES
#define START , x0
#define STATE_AGAIN , x
#else
#define START
#define STATE_AGAIN
#endif
#if IN_FLIGHT
#define ARM arm_for
#define START_AGAIN , static_cast<REAL>(0.75) * record[0] STATE_AGAIN
#else
#define ARM arm
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

void DRIVE(const void* bytes, std::int32_t status[4], void* out);

using Numbers = std::array<REAL, PARAMS + (LATCHES * N) + 1 + N + REFERENCES>;
using State = std::array<REAL, N>;

void DRIVE(const void* bytes, std::int32_t status[4], void* out)
{
    Numbers record{};
    State x{};
    ptc::OF(NAME, Params) params{};
    ptc::NAME self{};
    // What a call must overwrite.
    constexpr REAL unset = 12345;
    REAL u[3] = {unset, unset, unset};

    std::memcpy(record.data(), bytes, sizeof record);
#if PARAMS
    static_assert(sizeof params == PARAMS * sizeof(REAL), "numbers alone, in the order of the record");
    std::memcpy(static_cast<void*>(&params), record.data(), sizeof params);
#endif
#if LATCHES
    State x0{};
    std::memcpy(x0.data(), &record[PARAMS], sizeof x0);
#endif
    const REAL t = record[PARAMS + (LATCHES * N)];
    std::memcpy(x.data(), &record[PARAMS + (LATCHES * N) + 1], sizeof x);
#if REFERENCES
    std::array<REAL, REFERENCES> r{};
    std::memcpy(r.data(), &record[PARAMS + (LATCHES * N) + 1 + N], sizeof r);
#endif
#if LAW
    const auto user_law = [](const State& xi, REAL time) {
        REAL sum{};
        for (const REAL one : xi) {
            sum = sum + (static_cast<REAL>(-1.5) * one);
        }
        return sum + (static_cast<REAL>(0.125) * time);
    };
#endif
#if AFTER
    const auto user_after = [](const State& state, REAL) { return -state[0]; };
#endif
    status[1] = 0;
    status[2] = 0;
    status[3] = 0;
    status[0] = static_cast<std::int32_t>(self.init(params START));
    if (status[0] == 0) {
#if RATE
        const auto rate = self.rate(t, x, static_cast<REAL>(0.25) LAW_ARGUMENT);
        status[1] = static_cast<std::int32_t>(rate.status);
        u[0] = rate.xi_dot[N - 1];
#else
        const auto step = self.step(t, x REFERENCE LAW_ARGUMENT AFTER_ARGUMENT);
        status[1] = static_cast<std::int32_t>(step.status);
        u[0] = step.u;
#endif
#if AXIS
        const auto axis = self.tick(t).axis(x REFERENCE);
        status[2] = static_cast<std::int32_t>(axis.status);
        u[1] = axis.u;
#endif
        status[3] = static_cast<std::int32_t>(self.ARM(t START_AGAIN));
        if (status[3] == 0) {
#if RATE
            const auto again = self.rate(t, x, static_cast<REAL>(0.25) LAW_ARGUMENT);
            u[2] = again.xi_dot[N - 1];
#else
            const auto again = self.step(t, x REFERENCE LAW_ARGUMENT AFTER_ARGUMENT);
            u[2] = again.u;
#endif
            status[3] = static_cast<std::int32_t>(again.status);
        }
    }
    std::memcpy(out, u, sizeof u);
}
