function xhat = a_name_that_fills_half_of_a_line_alone_4_estimate(self) %#codegen
%A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = a_name_that_fills_half_of_a_line_alone_4_estimate(self), with self from
%   a_name_that_fills_half_of_a_line_alone_4_init.

xhat = [self.x1_hat; self.x2_hat];
end
