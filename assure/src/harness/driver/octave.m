% Runs emitted functions on the records of each line of a manifest; see runtime.rs.
1;

function sum = user_law(xi, t)
    sum = zeros(1, 1, class(xi));
    for i = 1:numel(xi)
        sum = sum + (cast(-1.5, class(xi)) * xi(i));
    end
    sum = sum + (cast(0.125, class(xi)) * t);
end

function drive(line)
    words = strsplit(line, "\t", 'CollapseDelimiters', false);
    [folder, name] = words{1:2};
    n = str2double(words{4});
    real = ifelse(strcmp(words{5}, 'f64'), 'double', 'single');
    layout = {};
    if ~isempty(words{6})
        layout = cellfun(@(f) strsplit(f, ':'), strsplit(words{6}, ','), 'UniformOutput', false);
    end
    lengths = cellfun(@(f) str2double(f{2}), layout);
    count = sum(max(1, lengths));
    [latches, law, after, has_axis, is_rate, in_flight] = num2cell(strcmp(words(7:12), '1')){:};
    references = str2double(words{13});
    laws = {};
    if law
        laws{end + 1} = @user_law;
    end
    if after
        laws{end + 1} = @(x, t) -x(1);
    end
    addpath(folder);
    functions = cellfun(@(f) str2func([name f]), {'_init', '_step', '_tick', '_axis', '_rate', ifelse(in_flight, '_arm_for', '_arm')}, ...
        'UniformOutput', false);
    [init, step, tick, axis_of, rate, arm] = functions{:};
    file = fopen([folder '/records.bin'], 'r');
    records = fread(file, [count + (latches * n) + 1 + n + references, Inf], [real '=>' real]);
    fclose(file);
    file = fopen([folder '/outcomes.bin'], 'w');
    for record = records
        params = struct();
        at = 0;
        for k = 1:numel(layout)
            params.(layout{k}{1}) = record(at + (1:max(1, lengths(k))));
            at = at + max(1, lengths(k));
        end
        start = {};
        if latches
            start = {record(at + (1:n))};
            at = at + n;
        end
        t = record(at + 1);
        x = record(at + 1 + (1:n));
        given = {x};
        if references
            given{2} = record(at + 1 + n + (1:references));
        end
        status = int32([0 0 0 0]);
        u = cast([12345 12345 12345], real);
        if is_rate
            call = @(self) last(rate, self, t, x, 0.25, laws{:});
        else
            call = @(self) step(self, t, given{:}, laws{:});
        end
        [self, status(1)] = started(name, init, params, start{:});
        if status(1) == 0
            [u_step, status(2)] = call(self);
            if ~isa(u_step, real)
                error('%s: u is a %s', name, class(u_step));
            end
            u(1) = u_step;
            if has_axis
                [u(2), status(3)] = axis_of(tick(self, t), given{:});
            end
            again = {t};
            if in_flight
                again{end + 1} = cast(0.75, real) * record(1);
            end
            if latches
                again{end + 1} = x;
            end
            [self, status(4)] = started(name, arm, self, again{:});
            if status(4) == 0
                [u(3), status(4)] = call(self);
            end
        end
        fwrite(file, status, 'int32');
        fwrite(file, u, real);
    end
    fclose(file);
    rmpath(folder);
end

% What init or arm gives, or -1 where it refuses.
function [self, status] = started(name, function_of, varargin)
    self = [];
    status = 0;
    try
        self = function_of(varargin{:});
    catch wrong
        if ~strcmp(wrong.identifier, [name ':param'])
            rethrow(wrong);
        end
        status = -1;
    end
end

% The last rate of the infinite-time system.
function [u, status] = last(rate, varargin)
    [xi_dot, status] = rate(varargin{:});
    u = xi_dot(end);
end

function r = ifelse(condition, yes, no)
    if condition
        r = yes;
    else
        r = no;
    end
end

words = argv();
lines = strsplit(strtrim(fileread(words{end})), "\n");
cellfun(@drive, lines);
