//! Equations of one resonance: two inertias, motor and load, joined by a spring with a damper.
//!
//! With r = J_load/J_motor, d the twist (the motor's position less the load's), w = 2 pi `frequency` and the pull of
//! the spring s = 2 `damping` w d' + w^2 d: the motor accelerates by (1 + r) u - r/(1 + r) s, the load by s/(1 + r), and
//! d' ' is their difference. A force f on one side adds (1 + r) f to the motor, or (1 + r)/r f to the load. With a rigid
//! joint both accelerate by f + u.

use crate::expression::Quantity;

/// A side of the spring: u acts on the motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The side on which u acts.
    Motor,
    /// The other one.
    Load,
}

impl Side {
    /// The side as a design spells it.
    pub(crate) fn text(self) -> &'static str {
        match self {
            Self::Motor => "motor",
            Self::Load => "load",
        }
    }
}

/// Constants of a resonance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Joint<T> {
    /// Frequency of the free resonance, Hz.
    pub(crate) frequency: T,
    /// Damping ratio.
    pub(crate) damping: T,
    /// Inertia of the load over that of the motor.
    pub(crate) inertia_ratio: T,
}

/// State of a spring, or a direction of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Twist<T> {
    pub(crate) angle: T,
    pub(crate) rate: T,
}

/// A spring between two inertias.
#[derive(Clone, Debug)]
pub(crate) struct Spring<T> {
    ratio: T,
    /// 1 + r.
    whole: T,
    /// Pull by the angle, and by its rate.
    stiffness: T,
    drag: T,
    /// Rate of the angle in its unit, by the rate of the twist.
    turn: T,
}

impl<T: Quantity> Spring<T> {
    /// Returns the spring of a joint, with the twist as its angle.
    pub(crate) fn new(joint: Joint<T>) -> Self {
        let omega = angular(&joint);
        let stiffness = omega.clone().times(omega.clone());
        Self::with(joint, omega, stiffness, T::whole(1))
    }

    /// Returns the spring of a joint with w d as its angle, which is of the size of d'.
    pub(crate) fn scaled(joint: Joint<T>) -> Self {
        let omega = angular(&joint);
        Self::with(joint, omega.clone(), omega.clone(), omega)
    }

    fn with(joint: Joint<T>, omega: T, stiffness: T, turn: T) -> Self {
        let Joint { damping, inertia_ratio: ratio, .. } = joint;
        let drag = T::whole(2).times(damping).times(omega);
        Self { whole: T::whole(1).plus(ratio.clone()), ratio, stiffness, drag, turn }
    }

    /// Returns the pull of the spring.
    pub(crate) fn pull(&self, twist: Twist<T>) -> T {
        let damped = self.drag.clone().times(twist.rate);
        damped.plus(self.stiffness.clone().times(twist.angle))
    }

    /// Returns the acceleration of the motor by an input.
    pub(crate) fn driven(&self, input: T) -> T {
        self.whole.clone().times(input)
    }

    /// Returns the acceleration of a side by a force on it.
    pub(crate) fn forced(&self, side: Side, force: T) -> T {
        match side {
            Side::Motor => self.whole.clone().times(force),
            Side::Load => self.whole.clone().over(self.ratio.clone()).times(force),
        }
    }

    /// Returns the acceleration of a side by an input and the pull.
    pub(crate) fn moved(&self, side: Side, input: T, pull: T) -> T {
        match side {
            Side::Motor => {
                let back = self.ratio.clone().over(self.whole.clone()).negated();
                self.driven(input).plus(back.times(pull))
            }
            Side::Load => pull.over(self.whole.clone()),
        }
    }

    /// Returns the rates of the angle and of its rate, where all but the pull accelerates the twist by `drive`.
    pub(crate) fn rates(&self, twist: Twist<T>, drive: T) -> [T; 2] {
        let turned = self.turn.clone().times(twist.rate.clone());
        [turned, drive.minus(self.pull(twist))]
    }
}

fn angular<T: Quantity>(joint: &Joint<T>) -> T {
    T::whole(2).times(T::pi()).times(joint.frequency.clone())
}
