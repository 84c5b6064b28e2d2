function xhat = masses_refuse_estimate(self) %#codegen
%MASSES_REFUSE_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = masses_refuse_estimate(self), with self from masses_refuse_init.

xhat = [self.x1_hat; self.x2_hat];
end
