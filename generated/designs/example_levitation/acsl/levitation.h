/*
 * Prescribed-time controller levitation: order n = 3, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name levitation --eps=1e-3 --poles=-4,-5,-6 --states="z, v, i" --input=u --output="z" --dynamics="v, grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), (u - R*i)/L" --param grav=9.81 --param "i0=[0.1,5]" --param "z0=[5e-3,2e-2]" --x-max=2e-3,1,0.05
 * Version 0.1.0, design 44fd77ede031.
 *
 * Plant, with the input u: z' = v, v' = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), i' = (u -
 *       R*i)/L, output z. Time in s.
 * Goal: the output and its first 2 derivatives, x, are 0 at the deadline t0 + tau from any
 *       state at t0, up to the error that the hold at eps, sampling, what differs from the
 *       model and clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 *
 * SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
 *       sample periods below a limit that depends on eps and the gains. ptc-codegen check
 *       finds it once tau, eps, the gains and --sample-time are given.
 *
 * Parameters:
 *   eps = 1e-3 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gain of xi_1
 *   k_2 = 74 [1/s^2], fixed: gain of xi_2
 *   k_3 = 15 [1/s], fixed: gain of xi_3
 *   grav = 9.81, fixed: parameter of the model
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   L: parameter of the model, finite
 *   R: parameter of the model, finite
 *   i0: parameter of the model, from 0.1 to 5
 *   z0: parameter of the model, from 5e-3 to 2e-2
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 *   r_2 = -a^2*T
 *   r_3 = a^3*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = a*T
 *   B_{2,1} = -a^2*T
 *   B_{2,2} = a^2*T^2
 *   B_{3,1} = a^3*T
 *   B_{3,2} = -3*a^3*T^2
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   x_1 = z
 *   x_2 = v
 *   x_3 = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2)
 *   f = grav*-(2*((1 + i/i0)/(1 + z/z0))*((-R*i/L/i0*(1 + z/z0) - (1 + i/i0)*(v/z0))/(1 +
 *       z/z0)^2))
 *   g = -2*grav*z0^2*(i0 + i)/(L*i0^2*(z0 + z)^2)
 *   u = (sum_j gain_j x_j - f)/g
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = -1 - K2 + K3
 *   row_3 = 3 - K3
 *   inv_T = 1/T
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite, t >= t0 and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `tau` is left to run time without bounds.
 *   zeros: sound: none: the relative degree is 3, the number of states.
 *
 * Operations of one step, without input checks and clipping: 14 additions or comparisons, 15
 *       multiplications, 6 divisions.
 */
#ifndef LEVITATION_A0D4E68E_H
#define LEVITATION_A0D4E68E_H

#ifdef L
#error "a macro L takes the place of the parameter L: include this header before the one that defines it, or rename the parameter"
#endif

#ifdef R
#error "a macro R takes the place of the parameter R: include this header before the one that defines it, or rename the parameter"
#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PTC_STATUS_DEFINED
#define PTC_STATUS_DEFINED
/* Outcome of a call; a negative one leaves *u = 0. */
typedef enum ptc_status {
    PTC_OK = 0, /* tracking */
    PTC_HOLD = 1, /* time-to-go held at eps: the deadline is near or over, u is valid */
    PTC_SATURATED = 2, /* u clipped to its limits; wins over PTC_HOLD and PTC_AFTER */
    PTC_AFTER = 3, /* the deadline is over: u is 0 or that of the user-defined law */
    PTC_GATED = 4, /* a reading was not believed: u by prediction alone; wins over all above */
    PTC_LATE = 5, /* the deadline was put off, as a limit would have been exceeded: u is valid */
    PTC_INFEASIBLE = 6, /* nothing is known from here that keeps all limits or bounds: u is valid */
    PTC_E_PARAM = -1, /* a parameter outside its domain, or coefficients outside the range */
    PTC_E_INPUT = -2, /* x or t not finite, t before t0, or a NULL pointer */
    PTC_E_RANGE = -3, /* u not finite */
    PTC_E_SOON = -4 /* a deadline too soon for the limits, or none that keeps them */
} ptc_status;
#endif

/* Run-time parameters. */
typedef struct levitation_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double L; /* parameter of the model, finite */
    double R; /* parameter of the model, finite */
    double i0; /* parameter of the model, from 0.1 to 5 */
    double z0; /* parameter of the model, from 5e-3 to 2e-2 */
} levitation_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct levitation {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double p_i0; /* parameter of an expression of the design */
    double p_z0; /* parameter of an expression of the design */
    double f42; /* derived from the parameters */
    double f49; /* derived from the parameters */
    double f53; /* derived from the parameters */
    double p_R; /* parameter of an expression of the design */
    double f56; /* derived from the parameters */
    double f61; /* derived from the parameters */
    double u_max; /* bound of |u| */
} levitation;

/*@ predicate levitation_legal(levitation_params *p) =
      \is_finite(p->tau)
      && 1e-150 <= p->tau
      && p->tau <= 1e150
      && \is_finite(p->t0)
      && p->u_max > 0.0
      && \is_finite(p->L)
      && \is_finite(p->R)
      && \is_finite(p->i0)
      && 0.1 <= p->i0
      && p->i0 <= 5.0
      && \is_finite(p->z0)
      && 0.005 <= p->z0
      && p->z0 <= 0.02
      && 0.001 < p->tau;
 */
/*@ predicate levitation_set(levitation *c) =
      \is_finite(c->t0)
      && \is_finite(c->tau)
      && \is_finite(c->deadline)
      && \is_finite(c->p_R);
 */

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> levitation_set(self);
 */
ptc_status levitation_init(levitation *self, const levitation_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires self == \null || levitation_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> levitation_set(self);
 */
ptc_status levitation_arm(levitation *self, double t0);

/*
 * u at time t [s] and state x = (z, v, i). On a negative status u is 0 and nothing has changed. u
 * must not overlap x.
 */
/*@ requires self == \null || \valid_read(self);
    requires x == \null || \valid_read(x + (0 .. 2));
    requires u == \null || \valid(u);
    requires self == \null || levitation_set(self);
    assigns *u;
    ensures -3 <= \result <= 3;
 */
ptc_status levitation_step(const levitation *self, double t, const double x[3], double *u);

#ifdef __cplusplus
}
#endif

#endif
