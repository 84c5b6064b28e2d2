function d = stage47_disturbance(self) %#codegen
%STAGE47_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage47_disturbance(self), with self from stage47_init.

d = self.d_hat;
end
