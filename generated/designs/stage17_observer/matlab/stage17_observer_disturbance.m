function d = stage17_observer_disturbance(self) %#codegen
%STAGE17_OBSERVER_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage17_observer_disturbance(self), with self from stage17_observer_init.

d = self.d_hat;
end
