function d = stage15_observer_disturbance(self) %#codegen
%STAGE15_OBSERVER_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage15_observer_disturbance(self), with self from stage15_observer_init.

d = self.d_hat;
end
