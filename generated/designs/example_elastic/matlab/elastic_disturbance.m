function d = elastic_disturbance(self) %#codegen
%ELASTIC_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = elastic_disturbance(self), with self from elastic_init.

d = self.d_hat;
end
