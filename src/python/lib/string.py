"""Constants, templates and the formatter behind `str.format`."""

__all__ = [
    "ascii_letters", "ascii_lowercase", "ascii_uppercase", "capwords", "digits", "hexdigits", "octdigits", "printable",
    "punctuation", "whitespace", "Formatter", "Template",
]

whitespace = " \t\n\r\v\f"
ascii_lowercase = "abcdefghijklmnopqrstuvwxyz"
ascii_uppercase = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
ascii_letters = ascii_lowercase + ascii_uppercase
digits = "0123456789"
hexdigits = digits + "abcdef" + "ABCDEF"
octdigits = "01234567"
punctuation = r"""!"#$%&'()*+,-./:;<=>?@[\]^_`{|}~"""
printable = digits + ascii_letters + punctuation + whitespace


def capwords(s, sep=None):
    return (sep or " ").join([word.capitalize() for word in s.split(sep)])


_ABSENT = object()
_FIRST = frozenset(ascii_letters + "_")
_REST = frozenset(ascii_letters + digits + "_")


class Template:
    delimiter = "$"

    def __init__(self, template):
        self.template = template

    def _pieces(self):
        """The template in pieces: (text before, kind, name, where it begins, the text of the placeholder)."""
        text = self.template
        mark = self.delimiter
        done = 0
        while True:
            start = text.find(mark, done)
            if start < 0:
                yield text[done:], None, None, len(text), ""
                return
            kind, name, end = self._placeholder(start + len(mark))
            yield text[done:start], kind, name, start, text[start:end]
            done = end

    def _placeholder(self, at):
        """What follows a delimiter: its kind, its name and where it ends."""
        text = self.template
        if text.startswith(self.delimiter, at):
            return "escaped", None, at + len(self.delimiter)
        if text.startswith("{", at):
            end = self._identifier(at + 1)
            if end > at + 1 and text.startswith("}", end):
                return "braced", text[at + 1:end], end + 1
            return "invalid", None, at
        end = self._identifier(at)
        return ("named", text[at:end], end) if end > at else ("invalid", None, at)

    def _identifier(self, at):
        text = self.template
        end = at
        if end < len(text) and text[end] in _FIRST:
            end += 1
            while end < len(text) and text[end] in _REST:
                end += 1
        return end

    def _fail(self, start):
        lines = self.template[:start].splitlines(keepends=True)
        column = start - len("".join(lines[:-1])) if lines else 1
        raise ValueError(f"Invalid placeholder in string: line {len(lines) or 1}, col {column}")

    def substitute(self, mapping=_ABSENT, /, **kws):
        values = _values(mapping, kws)
        result = []
        for before, kind, name, start, shown in self._pieces():
            result.append(before)
            if kind == "escaped":
                result.append(self.delimiter)
            elif kind == "invalid":
                self._fail(start + len(self.delimiter))
            elif kind:
                result.append(str(values[name]))
        return "".join(result)

    def safe_substitute(self, mapping=_ABSENT, /, **kws):
        values = _values(mapping, kws)
        result = []
        for before, kind, name, start, shown in self._pieces():
            result.append(before)
            if kind == "escaped":
                result.append(self.delimiter)
            elif kind in ("named", "braced"):
                try:
                    result.append(str(values[name]))
                except KeyError:
                    result.append(shown)
            else:
                result.append(shown)
        return "".join(result)

    def is_valid(self):
        return all(kind != "invalid" for _, kind, _, _, _ in self._pieces())

    def get_identifiers(self):
        names = []
        for _, kind, name, start, _ in self._pieces():
            if kind == "invalid":
                raise ValueError("Unrecognized named group in pattern")
            if name is not None and name not in names:
                names.append(name)
        return names


class _Layered:
    """Keywords before the mapping."""

    def __init__(self, kws, mapping):
        self.kws = kws
        self.mapping = mapping

    def __getitem__(self, name):
        return self.kws[name] if name in self.kws else self.mapping[name]


def _values(mapping, kws):
    if mapping is _ABSENT:
        return kws
    return _Layered(kws, mapping) if kws else mapping


def _split_field(name):
    """A field name as its first part (an int or a string) and the attributes and items that follow."""
    end = min([i for i in (name.find("."), name.find("[")) if i >= 0], default=len(name))
    first, rest = name[:end], name[end:]
    steps = []
    while rest:
        if rest[0] == ".":
            end = min([i for i in (rest.find(".", 1), rest.find("[", 1)) if i >= 0], default=len(rest))
            step, rest = rest[1:end], rest[end:]
            if not step:
                raise ValueError("Empty attribute in format string")
            steps.append((True, step))
        elif rest[0] == "[":
            end = rest.find("]")
            if end < 0:
                raise ValueError("Missing ']' in format string")
            step, rest = rest[1:end], rest[end + 1:]
            if not step:
                raise ValueError("Empty attribute in format string")
            steps.append((False, int(step) if step.isdecimal() else step))
        else:
            raise ValueError("Only '.' or '[' may follow ']' in format field specifier")
    return int(first) if first.isdecimal() else first, steps


def _parse(text):
    """The literal text, field name, format specification and conversion of each replacement field."""
    at = 0
    literal = []
    while at < len(text):
        char = text[at]
        at += 1
        if char not in "{}":
            literal.append(char)
        elif text.startswith(char, at):
            at += 1
            yield "".join(literal) + char, None, None, None
            literal = []
        elif char == "}":
            raise ValueError("Single '}' encountered in format string")
        elif at == len(text):
            raise ValueError("Single '{' encountered in format string")
        else:
            end = _field_end(text, at)
            name, conversion, spec = _field_parts(text[at:end])
            yield "".join(literal), name, spec, conversion
            literal = []
            at = end + 1
    if literal:
        yield "".join(literal), None, None, None


def _field_end(text, at):
    depth = 1
    in_brackets = False
    for index in range(at, len(text)):
        char = text[index]
        if in_brackets:
            in_brackets = char != "]"
        elif char == "[" and depth == 1 and ":" not in text[at:index]:
            in_brackets = True
        elif char == "{":
            depth += 1
        elif char == "}":
            depth -= 1
            if not depth:
                return index
    raise ValueError("expected '}' before end of string")


def _field_parts(field):
    in_brackets = False
    for index, char in enumerate(field):
        if char == "[":
            in_brackets = True
        elif char == "]":
            in_brackets = False
        elif char == "{" and not in_brackets:
            raise ValueError("unexpected '{' in field name")
        elif char == ":" and not in_brackets:
            return field[:index], None, field[index + 1:]
        elif char == "!" and not in_brackets:
            rest = field[index + 1:]
            if not rest:
                raise ValueError("end of string while looking for conversion specifier")
            if len(rest) > 1 and rest[1] != ":":
                raise ValueError("expected ':' after conversion specifier")
            return field[:index], rest[0], rest[2:]
    return field, None, ""


class Formatter:
    def format(self, format_string, /, *args, **kwargs):
        return self.vformat(format_string, args, kwargs)

    def vformat(self, format_string, args, kwargs):
        used_args = set()
        result, _ = self._vformat(format_string, args, kwargs, used_args, 2)
        self.check_unused_args(used_args, args, kwargs)
        return result

    def _vformat(self, format_string, args, kwargs, used_args, depth, auto=0):
        if depth < 0:
            raise ValueError("Max string recursion exceeded")
        result = []
        for literal, name, spec, conversion in self.parse(format_string):
            if literal:
                result.append(literal)
            if name is None:
                continue
            if name == "":
                if auto is False:
                    raise ValueError("cannot switch from manual field specification to automatic field numbering")
                name = str(auto)
                auto += 1
            elif name.isdigit():
                if auto:
                    raise ValueError("cannot switch from manual field specification to automatic field numbering")
                auto = False
            obj, first = self.get_field(name, args, kwargs)
            used_args.add(first)
            obj = self.convert_field(obj, conversion)
            spec, auto = self._vformat(spec, args, kwargs, used_args, depth - 1, auto)
            result.append(self.format_field(obj, spec))
        return "".join(result), auto

    def get_value(self, key, args, kwargs):
        return args[key] if isinstance(key, int) else kwargs[key]

    def check_unused_args(self, used_args, args, kwargs):
        pass

    def format_field(self, value, format_spec):
        return format(value, format_spec)

    def convert_field(self, value, conversion):
        if conversion is None:
            return value
        if conversion == "s":
            return str(value)
        if conversion == "r":
            return repr(value)
        if conversion == "a":
            return ascii(value)
        raise ValueError(f"Unknown conversion specifier {conversion!s}")

    def parse(self, format_string):
        return _parse(format_string)

    def get_field(self, field_name, args, kwargs):
        first, steps = _split_field(field_name)
        obj = self.get_value(first, args, kwargs)
        for is_attribute, step in steps:
            obj = getattr(obj, step) if is_attribute else obj[step]
        return obj, first
