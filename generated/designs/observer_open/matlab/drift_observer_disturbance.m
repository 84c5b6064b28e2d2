function d = drift_observer_disturbance(self) %#codegen
%DRIFT_OBSERVER_DISTURBANCE The estimate of the ramp that is added to u.
%
%   d = drift_observer_disturbance(self), with self from drift_observer_init.

d = self.d_hat;
end
