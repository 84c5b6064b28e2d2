function [u, status, self] = stage48_step(self, k, y) %#codegen
%STAGE48_STEP u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
%tick.
%
%   [u, status, self] = stage48_step(self, k, y), with self from stage48_init. Keep self: it is what
%   the next call needs.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

gamma1 = 9.364814153170347e-5; % prediction from u
late_gamma1 = 1.4515165236407059e-5; % prediction from u
gamma2 = 0.22442191668610964; % prediction from u
late_gamma2 = 0.08499166561536914; % prediction from u
gamma3 = 0.15880778157427425; % prediction from u
late_gamma3 = 0.21578270324225896; % prediction from u
observer_samples = uint32(50); % samples of the round of the observer
q1_1 = -96.0; % weight in the observer's gain l1
q1_2 = 96.0; % weight in the observer's gain l1
q1_3 = -48.0; % weight in the observer's gain l1
q1_4 = 16.0; % weight in the observer's gain l1
q2_1 = 859382.9277311233; % weight in the observer's gain l2
q2_2 = -513847.60335174634; % weight in the observer's gain l2
q2_3 = 125558.23800330989; % weight in the observer's gain l2
q2_4 = -9808.939721535125; % weight in the observer's gain l2
q3_1 = -620544.0922410007; % weight in the observer's gain l3
q3_2 = 289368.54342637886; % weight in the observer's gain l3
q3_3 = -49493.69520132396; % weight in the observer's gain l3
q3_4 = 3680.3758886140504; % weight in the observer's gain l3
q4_1 = 42644.35104284018; % weight in the observer's gain l4
e0_1 = 1.1314283505021951; % gain of the observer at its end
e0_2 = 219.51265205459217; % gain of the observer at its end
e0_3 = 75.63157806817; % gain of the observer at its end
e0_4 = -118.45653067455605; % gain of the observer at its end
e1_1 = 1.3092061282799727; % gain of the observer at its end
e1_2 = 248.77479213018773; % gain of the observer at its end
e1_3 = 58.354009083621726; % gain of the observer at its end
e1_4 = 789.7102044970403; % gain of the observer at its end
e2_1 = 1.531428350502195; % gain of the observer at its end
e2_2 = -7.605455274169628; % gain of the observer at its end
e2_3 = -864.4162017900436; % gain of the observer at its end
e2_4 = -1776.8479601183408; % gain of the observer at its end
e3_1 = 3.5314283505021953; % gain of the observer at its end
e3_2 = 3400.952825738043; % gain of the observer at its end
e3_3 = 1206.9697918675683; % gain of the observer at its end
e3_4 = 1776.8479601183408; % gain of the observer at its end
phi1_2 = 0.000996505559752715; % prediction of x1 from x2
phi1_3 = 0.0006188271646029575; % prediction of x1 from x3
phi1_4 = 0.00010816330676811052; % prediction of x1 from d
phi2_2 = 0.9902193397510792; % prediction of x2 from x2
phi2_3 = 1.1234620408672982; % prediction of x2 from x3
phi2_4 = 0.30941358230147875; % prediction of x2 from d
phi3_2 = -0.011234620408672982; % prediction of x3 from x2
phi3_3 = 0.5412090107511158; % prediction of x3 from x3
phi3_4 = 0.37459048481653323; % prediction of x3 from d
samples = uint32(100); % samples from the start to rest
u_max = 24.0; % bound of |u|
hold = 6.0; % samples to go at which the gains are held
% Gains of least energy of each state, a row for the samples to go of a node.
gains = [
    -1776.8479601183408, -3.433673119968826, -3.4085582810122124;
    -888.4239800591704, -2.2396226199294076, -2.668895474474135;
    -509.8205499917047, -1.5836352486541563, -2.156303199309816;
    -321.2435999059375, -1.1847458154993364, -1.7840105694740966;
    -216.68093346707525, -0.9242259566604598, -1.5043723951168144;
    -153.9422258341114, -0.7447029385976519, -1.2887857385166759;
    -113.93847902814913, -0.6156792469819268, -1.1190107322495595;
    -87.16471846485014, -0.5197354647522179, -0.9828886639258793;
    -68.52151427846083, -0.4463449878262189, -0.8720333492968331;
    -55.10393872697146, -0.3888498994276202, -0.7805015513958865;
    -45.17340922131986, -0.3428771962392912, -0.7039866926831448;
    -37.645338987867255, -0.3054615992281757, -0.6393092191236842;
    -31.81875620585758, -0.27453657915024465, -0.5840834223761374;
    -27.22654280812768, -0.2486271922797076, -0.5364934991038854;
    -23.548974074041762, -0.22665835728982042, -0.4951395241819548;
    -20.56197731368738, -0.20783163893706613, -0.45892943480696;
    -18.10517741827105, -0.1915440040702233, -0.4270020121187187;
    -16.06160501852228, -0.17733302260561387, -0.3986711637229456;
    -14.34448653985888, -0.16483914791668344, -0.3733850940635477;
    -12.888450440068087, -0.15377927419458942, -0.3506960346235246;
    -11.643553902420525, -0.14392788889388677, -0.3302375620042263;
    -10.57115019711518, -0.13510343327021376, -0.31170743224482;
    -9.640981134457023, -0.12715829319637273, -0.29485446816108246;
    -8.829099689315191, -0.11997135875672672, -0.27946845400384207;
    -8.116364548493685, -0.11344242686372868, -0.2653722821336554;
    -7.4873347145655345, -0.10748794327334095, -0.2524158008059736;
    -6.92944791969951, -0.10203772969328963, -0.24047095757682826;
    -6.432403034640657, -0.09703244352848328, -0.22942793730857275;
    -5.987690902669893, -0.0924215882293794, -0.21919206948913653;
    -5.588234402434218, -0.08816194151833531, -0.20968133494671454;
    -4.90232886736555, -0.08055249332977393, -0.19255867915280173;
    -4.337531609573391, -0.07396200145641044, -0.17758866382046176;
    -3.866962043305151, -0.06820607163189224, -0.1644055236605839;
    -3.470790749314056, -0.06314188514263996, -0.1527212184490728;
    -3.134134775751522, -0.058657163866628094, -0.14230591997800468;
    -2.845649743939376, -0.05466245582716187, -0.13297406684879373;
    -2.5965675236180417, -0.051085636807956664, -0.12457422819671518;
    -2.380025558008824, -0.04786792242488202, -0.11698162121891839;
    -2.1905911599741885, -0.044960929582640426, -0.11009250906350342;
    -2.02391866730071, -0.04232447977954594, -0.10381995183425959;
    -1.8764987244836007, -0.039924935245840495, -0.09809054528111931;
    -1.7454724729656579, -0.03773392339710073, -0.09284188997856772;
    -1.6284921470217775, -0.03572734808777426, -0.08802060737537329;
    -1.523615296707974, -0.03388461531195422, -0.08358076988701066;
    -1.4292236830261014, -0.03218802108556842, -0.07948264775619424;
    -1.3439604848291826, -0.03062226328182328, -0.07569170062633748;
    -1.1964152124156797, -0.02783177725314643, -0.06891436097083738;
    -1.0737303961538518, -0.025425601240773896, -0.06304865259045363;
    -0.970591182471621, -0.02333597818938725, -0.057938311673843924;
    -0.8830294618645727, -0.021509684264473847, -0.053459600787556544;
    -0.8080344337031824, -0.01990435940283023, -0.04951333308196541;
    -0.7432884532951157, -0.01848589655966577, -0.04601913572216292;
    -0.6869841398708345, -0.017226549374695407, -0.04291125081794763;
    -0.6376953878667164, -0.01610353745589099, -0.04013541272877522;
    -0.5942848639897524, -0.01509800278331475, -0.03764649228065479;
    -0.5558366565985665, -0.014194218062618705, -0.035406696215788895;
];
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
if ~isfinite(y(1))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = 0.0;
    x3 = 0.0;
    d = 0.0;
else
    s1 = (gamma1 * self.u3) + (late_gamma1 * self.u2);
    x1 = self.x1_next + s1;
    s2 = (gamma2 * self.u3) + (late_gamma2 * self.u2);
    x2 = self.x2_next + s2;
    s3 = (gamma3 * self.u3) + (late_gamma3 * self.u2);
    x3 = self.x3_next + s3;
    d = self.d_next;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
off1 = miss1;
left_o = observer_samples - elapsed;
o0 = double(left_o);
if o0 > 10.0
    o0f2 = o0 * (o0 - 1.0);
    o0f3 = o0f2 * (o0 - 2.0);
    r0 = 1.0 / (o0f3 * (o0 - 3.0));
    s4 = q1_1 + (q1_2 * o0) + (q1_3 * o0f2);
    l1 = ((s4 + (q1_4 * o0f3)) * r0) - 0.46857164949780494;
    s5 = q2_1 + (q2_2 * o0) + (q2_3 * o0f2);
    l2 = ((s5 + (q2_4 * o0f3)) * r0) + 264.4187821124759;
    s6 = q3_1 + (q3_2 * o0) + (q3_3 * o0f2);
    l3 = ((s6 + (q3_4 * o0f3)) * r0) - 98.64522377262374;
    l4 = q4_1 * r0;
elseif left_o == uint32(10)
    l1 = e0_1;
    l2 = e0_2;
    l3 = e0_3;
    l4 = e0_4;
elseif left_o == uint32(9)
    l1 = e1_1;
    l2 = e1_2;
    l3 = e1_3;
    l4 = e1_4;
elseif left_o == uint32(8)
    l1 = e2_1;
    l2 = e2_2;
    l3 = e2_3;
    l4 = e2_4;
else
    l1 = e3_1;
    l2 = e3_2;
    l3 = e3_3;
    l4 = e3_4;
end
s7 = x1 + (phi1_2 * x2) + (phi1_3 * x3);
x1_on = s7 + (phi1_4 * d) + (l1 * off1);
s8 = (phi2_2 * x2) + (phi2_3 * x3);
x2_on = s8 + (phi2_4 * d) + (l2 * off1);
s9 = (phi3_2 * x2) + (phi3_3 * x3);
x3_on = s9 + (phi3_4 * d) + (l3 * off1);
d_on = d + (l4 * off1);
left = samples - elapsed;
planned = left - uint32(2);
if planned > uint32(6)
    to_go = planned;
else
    to_go = uint32(6);
end

% Its place between the nodes of the table.
if to_go < uint32(32)
    row = uint32(mod(double(to_go) - double(uint32(3)), 4294967296));
    part = 0.0;
elseif to_go < uint32(64)
    row = bitshift(to_go, -1) + uint32(13);
    part = (0.5 * double(to_go)) - double(bitshift(to_go, -1));
else
    row = bitshift(to_go, -2) + uint32(29);
    part = (0.25 * double(to_go)) - double(bitshift(to_go, -2));
end

% The state from which this input acts.
s10 = x1 + (0.0014892124792996978 * x2);
s11 = 0.00010816330676811052 * (self.u1 + d);
s12 = s10 + (0.0012719952989597699 * x3) + s11;
p1 = s12 + (0.0002327420309725346 * (self.u2 + d));
s13 = (0.9801754642759536 * x2) + (1.4706215395736848 * x3);
s14 = s13 + (0.30941358230147875 * (self.u1 + d));
p2 = s14 + (0.32658406717840616 * (self.u2 + d));
s15 = ((-0.014706215395736848) * x2) + (0.39241705562633755 * x3);
s16 = s15 + (0.37459048481653323 * (self.u1 + d));
p3 = s16 + (0.11582869425785502 * (self.u2 + d));

% The law of least energy.
above = row + uint32(1);
s17 = part * (gains(above + 1, 1) - gains(row + 1, 1));
s18 = part * (gains(above + 1, 2) - gains(row + 1, 2));
s19 = (gains(row + 1, 1) + s17) * p1;
s20 = part * (gains(above + 1, 3) - gains(row + 1, 3));
s21 = s19 + ((gains(row + 1, 2) + s18) * p2);
v = (s21 + ((gains(row + 1, 3) + s20) * p3)) - d;
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on) && isfinite(d_on))
    status = int32(-3);
    return;
end
if v > u_max
    u_now = u_max;
elseif v < -u_max
    u_now = -u_max;
else
    u_now = v;
end
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.x3_hat = x3;
self.x3_next = x3_on;
self.d_hat = d;
self.d_next = d_on;
self.seen = uint32(1);
if (v > u_max) || (v < -u_max)
    u = u_now;
    status = int32(2);
elseif double(left) - 2.0 <= hold
    u = u_now;
    status = int32(1);
else
    u = u_now;
    status = int32(0);
end
end
