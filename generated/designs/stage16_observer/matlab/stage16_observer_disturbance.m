function d = stage16_observer_disturbance(self) %#codegen
%STAGE16_OBSERVER_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage16_observer_disturbance(self), with self from stage16_observer_init.

d = self.d_hat;
end
