function xhat = elastic_estimate(self) %#codegen
%ELASTIC_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = elastic_estimate(self), with self from elastic_init.

xhat = [self.x1_hat; self.x2_hat];
end
