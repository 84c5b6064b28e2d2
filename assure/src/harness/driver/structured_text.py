"""The subset of Structured Text that is emitted, as blark parses it, run with NumPy's numbers.

Each declaration becomes Python source, which is compiled once. Types are strict: a value is assigned
to a variable of its own type alone, a name that is not declared is an error, and a temporary variable
holds nothing until it is set. Capitals and small letters are one.
"""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
from blark import transform as st
from blark.parse import parse_source_code

REALS = {"lreal": np.float64, "real": np.float32}
TYPES = {**REALS, "bool": bool, "int": int, "dint": int, "udint": np.uint32}
OPERATORS = {"=": "==", "<>": "!=", "and": "and", "or": "or"}


def power(a: Any, b: Any) -> Any:
    return type(a)(np.power(a, b))


STANDARD = {
    "abs": np.abs, "sqrt": np.sqrt, "ln": np.log, "exp": np.exp, "sin": np.sin, "cos": np.cos,
    "tan": np.tan, "atan": np.arctan, "expt": power,
}


CONVERSIONS = {"udint_to_lreal": np.float64, "udint_to_real": np.float32}


class Wrong(Exception):
    """What the text does is outside the subset, or breaks its rules."""


def counted(operator: str, a: Any, b: Any) -> Any:
    """An operation where counts take part, which must not overflow: what becomes of them then depends
    on the controller."""
    if type(a) is not type(b):
        raise Wrong(f"{operator} of a {type(a).__name__} and a {type(b).__name__}")
    if isinstance(a, np.uint32):
        a, b = int(a), int(b)
        result = {"+": a + b, "-": a - b, "*": a * b, "/": a // max(b, 1)}[operator]
        if not 0 <= result < 2**32 or (operator == "/" and b == 0):
            raise Wrong(f"{a} {operator} {b} is no count")
        return np.uint32(result)
    return {"+": lambda: a + b, "-": lambda: a - b, "*": lambda: a * b, "/": lambda: a / b}[operator]()


def same_type(value: Any, kind: Any, name: str) -> Any:
    """The value, which must have the type of the variable `name`."""
    if kind is bool and isinstance(value, np.bool_):
        value = bool(value)
    if isinstance(kind, type) and type(value) is not kind:
        raise Wrong(f"{name} of type {kind.__name__} is given a {type(value).__name__}")
    if not isinstance(kind, type) and value is None:
        raise Wrong(f"{name} is given a value that was never set")
    return value


def element(kind: Any) -> Any:
    """The kind of the elements of an array: those of several dimensions are arrays in turn."""
    return kind[0] if len(kind) == 2 else (kind[0], *kind[2:])


def parsed(text: str) -> st.SourceCode:
    """The tree of a file; an error where it is no Structured Text."""
    result = parse_source_code(text)
    if result.exception is not None:
        raise result.exception
    return result.transform()


def number(literal: Any) -> Any:
    """The value of a literal, in the type that it names."""
    if isinstance(literal, st.Real):
        return REALS[str(literal.type_name).lower()](str(literal.value))
    if isinstance(literal, st.Integer):
        return TYPES[str(literal.type_name).lower()](int(literal.value))
    raise Wrong(f"a {type(literal).__name__} is no literal")


class Library:
    """The types, functions and function blocks of a file."""

    def __init__(self, text: str) -> None:
        self.structures: dict[str, dict[str, Any]] = {}
        self.arrays: dict[str, Any] = {}
        self.units: dict[str, Unit] = {}
        for item in parsed(text).items:
            if isinstance(item, st.DataTypeDeclaration):
                declaration = item.declaration
                if isinstance(declaration, st.ArrayTypeDeclaration):
                    self.arrays[str(declaration.name).lower()] = self.kind(declaration.init)
                    continue
                members = [m for m in declaration.declarations]
                self.structures[str(declaration.name).lower()] = {
                    str(v.variable.name).lower(): self.kind(m.init) for m in members for v in m.variables
                }
            elif isinstance(item, (st.Function, st.FunctionBlock)):
                self.units[str(item.name).lower()] = Unit(self, item)
            else:
                raise Wrong(f"a {type(item).__name__} is outside the subset")

    def kind(self, init: Any) -> Any:
        """The type of a declaration: a class of numbers, (class, length, ..), or a structure's name."""
        if isinstance(init, st.ArrayTypeInitialization):
            ranges = init.spec.subranges
            if any(str(bounds.start.value) != "1" for bounds in ranges):
                raise Wrong("an array begins at 1")
            lengths = (int(bounds.stop.value) for bounds in ranges)
            return (TYPES[str(init.spec.type.type_name).lower()], *lengths)
        word = str(init.spec.type).lower()
        if word in self.arrays:
            return self.arrays[word]
        if word not in TYPES and word not in self.structures:
            raise Wrong(f"no type {word}")
        return TYPES.get(word, word)

    def fresh(self, kind: Any, value: Any = 0) -> Any:
        """A variable of a kind, of the value that IEC 61131-3 gives at the start, or of none."""
        if isinstance(kind, str):
            return {name: self.fresh(member, value) for name, member in self.structures[kind].items()}
        if isinstance(kind, tuple):
            return [self.fresh(element(kind), value) for _ in range(kind[1])]
        return None if value is None else kind(value)


class Unit:
    """A function or a function block, as a Python function of its variables."""

    def __init__(self, library: Library, item: Any) -> None:
        self.library, self.name = library, str(item.name).lower()
        self.kinds: dict[str, Any] = {}
        self.initial: dict[str, Any] = {}
        self.inputs: list[str] = []
        self.temporary: list[str] = []
        if isinstance(item, st.Function):
            self.declare(self.name, TYPES[str(item.return_type.type.type).lower()])
        for block in item.declarations:
            for one in block.items:
                for variable in one.variables:
                    name = str(variable.variable.name).lower()
                    self.declare(name, library.kind(one.init))
                    if (value := getattr(one.init, "value", None)) is not None:
                        self.initial[name] = same_type(number(value), self.kinds[name], name)
                    if isinstance(block, st.InputDeclarations):
                        self.inputs.append(name)
                    if isinstance(block, st.TemporaryVariableDeclarations):
                        self.temporary.append(name)
        self.lines = ["def run(v, call, same_type, kinds):"]
        self.constants: dict[str, Any] = {}
        self.statements(item.body.statements, 1)
        space = dict(self.constants)
        exec(compile("\n".join(self.lines + ["    return"]), self.name, "exec"), space)
        self.run = space["run"]

    def declare(self, name: str, kind: Any) -> None:
        if name in self.kinds:
            raise Wrong(f"{name} is declared twice")
        self.kinds[name] = kind

    def memory(self) -> dict[str, Any]:
        fresh = {name: self.library.fresh(kind) for name, kind in self.kinds.items()}
        return fresh | self.initial

    def execute(self, memory: dict[str, Any]) -> None:
        for name in self.temporary:
            memory[name] = self.library.fresh(self.kinds[name], None)
        self.run(memory, self.call, same_type, self.kinds)

    def call(self, function: str, *arguments: Any) -> Any:
        if any(argument is None for argument in arguments):
            raise Wrong(f"{function} is given a value that was never set")
        if function in CONVERSIONS:
            (argument,) = arguments
            return CONVERSIONS[function](same_type(argument, np.uint32, function))
        if function in STANDARD:
            result = STANDARD[function](*arguments)
            if type(result) is not type(arguments[0]):
                raise Wrong(f"{function} of mixed types")
            return result
        unit = self.library.units[function]
        memory = unit.memory()
        for name, argument in zip(unit.inputs, arguments, strict=True):
            memory[name] = same_type(argument, unit.kinds[name], name)
        unit.execute(memory)
        return memory[function]

    def place(self, variable: Any) -> tuple[str, Any]:
        """A variable as Python, with its kind."""
        simple = isinstance(variable, st.SimpleVariable)
        name = str(variable.name if simple else variable.name.name).lower()
        if name not in self.kinds:
            raise Wrong(f"{name} is not declared")
        text, kind = f"v[{name!r}]", self.kinds[name]
        for selector in [] if simple else variable.elements:
            if isinstance(selector, st.FieldSelector):
                field = str(selector.field.name).lower()
                kind = self.library.structures[kind][field]
                text += f"[{field!r}]"
            else:
                for subscript in selector.subscripts:
                    kind = element(kind)
                    text += f"[{self.expression(subscript)} - 1]"
                if isinstance(kind, tuple):
                    raise Wrong(f"{text} is an array")
        return text, kind

    def expression(self, e: Any) -> str:
        if isinstance(e, (st.SimpleVariable, st.MultiElementVariable)):
            return self.place(e)[0]
        if isinstance(e, st.Integer) and e.type_name is None:
            return str(int(e.value))
        if isinstance(e, (st.Real, st.Integer)):
            name = f"number{len(self.constants)}"
            self.constants[name] = number(e)
            return name
        if isinstance(e, st.Boolean):
            return str(str(e.value).lower() in ("true", "1"))
        if isinstance(e, st.ParenthesizedExpression):
            return f"({self.expression(e.expr)})"
        if isinstance(e, st.UnaryOperation):
            operator = str(e.op).lower()
            return f"({'not ' if operator == 'not' else operator}{self.expression(e.expr)})"
        if isinstance(e, st.BinaryOperation):
            operator = OPERATORS.get(str(e.op).lower(), str(e.op).lower())
            left, right = self.expression(e.left), self.expression(e.right)
            if operator in ("+", "-", "*", "/") and np.uint32 in self.kinds.values():
                self.constants["counted"] = counted
                return f"counted({operator!r}, {left}, {right})"
            return f"({left} {operator} {right})"
        if isinstance(e, st.FunctionCall):
            function = str(e.name.name).lower()
            arguments = [self.expression(p.value) for p in e.parameters]
            if function == "sel":
                condition, no, yes = arguments
                return f"({yes} if {condition} else {no})"
            return f"call({function!r}, {', '.join(arguments)})"
        raise Wrong(f"a {type(e).__name__} is outside the subset")

    def statements(self, body: Any, depth: int) -> None:
        for statement in body:
            self.statement(statement, depth)

    def line(self, depth: int, text: str) -> None:
        self.lines.append("    " * depth + text)

    def statement(self, s: Any, depth: int) -> None:
        if isinstance(s, st.AssignmentStatement):
            (variable,) = s.variables
            text, kind = self.place(variable)
            value = self.expression(s.expression)
            if isinstance(kind, str):
                self.constants["copy"] = copy.deepcopy
                self.line(depth, f"{text} = copy({value})")
            else:
                self.constants[kind.__name__] = kind
                self.line(depth, f"{text} = same_type({value}, {kind.__name__}, {text!r})")
        elif isinstance(s, st.IfStatement):
            branches = [(s.if_expression, s.statements)]
            branches += [(other.if_expression, other.statements) for other in s.else_ifs]
            for word, (condition, body) in zip(["if"] + ["elif"] * len(branches), branches):
                self.line(depth, f"{word} {self.expression(condition)}:")
                self.statements(body.statements, depth + 1)
            if s.else_clause is not None:
                self.line(depth, "else:")
                self.statements(s.else_clause.statements.statements, depth + 1)
        elif isinstance(s, st.ForStatement):
            control, kind = self.place(s.control)
            if kind not in (int, np.uint32):
                raise Wrong("a loop counts with an integer")
            step = "1" if s.step is None else self.expression(s.step)
            ends = (self.expression(end) for end in (s.from_, s.to))
            first, last = (f"same_type({end}, kinds[{str(s.control.name).lower()!r}], 'an end')" for end in ends)
            each = f"type({first})(i) for i in range(int({first}), int({last}) + 1, {step})"
            self.line(depth, f"for {control} in ({each}):")
            self.statements(s.statements.statements, depth + 1)
        elif isinstance(s, st.WhileStatement):
            self.line(depth, f"while {self.expression(s.expression)}:")
            self.statements(s.statements.statements, depth + 1)
        elif isinstance(s, st.ExitStatement):
            self.line(depth, "break")
        elif isinstance(s, st.ReturnStatement):
            self.line(depth, "return")
        else:
            raise Wrong(f"a {type(s).__name__} is outside the subset")
