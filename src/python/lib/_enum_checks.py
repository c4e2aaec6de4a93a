"""Less used parts of enum: combined flags, boundaries, `verify`, and enumerations shown as globals."""

from enum import Enum, StrEnum, Flag, auto


class FlagBoundary(StrEnum):
    STRICT = auto()
    CONFORM = auto()
    EJECT = auto()
    KEEP = auto()


STRICT, CONFORM, EJECT, KEEP = FlagBoundary


class EnumCheck(StrEnum):
    CONTINUOUS = "no skipped integer values"
    NAMED_FLAGS = "multi-flag aliases may not contain unnamed flags"
    UNIQUE = "one name per value"


CONTINUOUS, NAMED_FLAGS, UNIQUE = EnumCheck


def _bits_text(number, width):
    """Two's complement, the sign bit first: `0b0 1010`."""
    sign = "0b0" if number >= 0 else "0b1"
    digits = max(width, number.bit_length())
    return f"{sign} {number & (1 << digits) - 1:0{digits}b}" if digits else f"{sign} "


def pseudo_member(cls, value):
    """The member that stands for a combination of flags; it is kept, so that equal values are identical."""
    if not isinstance(value, int):
        raise ValueError(f"{value!r} is not a valid {cls.__qualname__}")
    mask, all_bits = cls._flag_mask_, cls._all_bits_
    boundary = cls._boundary_
    if not ~all_bits <= value <= all_bits or value & (all_bits ^ mask):
        if boundary == "strict":
            width = max(value.bit_length(), mask.bit_length())
            raise ValueError(
                f"{cls!r} invalid value {value!r}\n    given {_bits_text(value, width)}\n  allowed {_bits_text(mask, width)}"
            )
        if boundary == "conform":
            value &= mask
        elif boundary == "eject":
            return value
        elif value < 0:
            value = max(all_bits + 1, 2 ** value.bit_length()) + value
    negative = None
    if value < 0:
        negative = value
        value += all_bits + 1
    if value & ~mask and boundary != "keep":
        raise ValueError(f"{cls.__name__}({value!r}) -->  unknown values {value & ~mask!r} [{_bits_text(value & ~mask, 0)}]")
    found = cls._value2member_map_.get(value)
    if found is None:
        found = _combine(cls, value)
        cls._value2member_map_[value] = found
    if negative is not None:
        cls._value2member_map_[negative] = found
    return found


def _combine(cls, value):
    made = object.__new__(cls) if cls._member_type_ is object else cls._member_type_.__new__(cls, value)
    if not hasattr(made, "_value_"):
        made._value_ = value
    singles = value & cls._singles_mask_
    members = list(cls._iter_member_(singles)) if singles else []
    combined = 0
    for m in members:
        combined |= m._value_
    if value & ~cls._singles_mask_:
        for m in cls._member_map_.values():
            if m not in members and m._value_ and m._value_ & value == m._value_:
                members.append(m)
                combined |= m._value_
    unknown = value ^ combined
    made._name_ = "|".join([m._name_ for m in members]) if combined else None
    if combined and unknown:
        if cls._boundary_ == "strict":
            raise ValueError(f"{cls!r}: no members with value {unknown!r}")
        made._name_ += f"|{cls._numeric_repr_(unknown)}"
    return made


class verify:
    def __init__(self, *checks):
        self.checks = checks

    def __call__(self, enumeration):
        is_flag = issubclass(enumeration, Flag)
        for check in self.checks:
            if check is UNIQUE:
                aliases = [(name, m.name) for name, m in enumeration.__members__.items() if name != m.name]
                if aliases:
                    shown = ", ".join([f"{alias} -> {name}" for alias, name in aliases])
                    raise ValueError(f"aliases found in {enumeration!r}: {shown}")
            elif check is CONTINUOUS:
                _check_continuous(enumeration, is_flag)
            elif check is NAMED_FLAGS:
                _check_named(enumeration)
        return enumeration


def _check_continuous(enumeration, is_flag):
    values = {m.value for m in enumeration}
    if len(values) < 2:
        return
    low, high = min(values), max(values)
    if is_flag:
        wanted = [2 ** i for i in range(low.bit_length(), high.bit_length() - 1)]
    else:
        wanted = range(low + 1, high)
    missing = [value for value in wanted if value not in values]
    if missing:
        kind = "flag" if is_flag else "enum"
        raise ValueError(f"invalid {kind} {enumeration.__name__!r}: missing values {', '.join([str(m) for m in missing])}")


def _check_named(enumeration):
    names = enumeration._member_names_
    values = [m.value for m in enumeration]
    missing_names = []
    missing_value = 0
    for name, alias in enumeration._member_map_.items():
        if name in names or alias.value < 0:
            continue
        bits = [1 << i for i in range(alias.value.bit_length()) if alias.value >> i & 1]
        missed = [bit for bit in bits if bit not in values]
        if missed:
            missing_names.append(name)
            for bit in missed:
                missing_value |= bit
    if missing_names:
        if len(missing_names) == 1:
            shown = f"alias {missing_names[0]} is missing"
        else:
            shown = f"aliases {', '.join(missing_names[:-1])} and {missing_names[-1]} are missing"
        single = missing_value & (missing_value - 1) == 0
        value = f"value 0x{missing_value:x}" if single else f"combined values of 0x{missing_value:x}"
        raise ValueError(f"invalid Flag {enumeration.__name__!r}: {shown} {value} [use enum.show_flag_values(value) for details]")


def global_enum_repr(self):
    return f"{self.__class__.__module__.split('.')[-1]}.{self._name_}"


def global_flag_repr(self):
    module = self.__class__.__module__.split(".")[-1]
    if self._name_ is None:
        return f"{module}.{self.__class__.__name__}({self._value_!r})"
    if self._name_[0] not in "0123456789" and "|" not in self._name_:
        return f"{module}.{self._name_}"
    return "|".join([name if name[0] in "0123456789" else f"{module}.{name}" for name in self._name_.split("|")])


def global_str(self):
    return repr(self) if self._name_ is None else self._name_


def global_enum(cls, update_str=False):
    raise NotImplementedError("global_enum needs the module that the enumeration is defined in")


def pickle_by_global_name(self, proto):
    return self.name


def pickle_by_enum_name(self, proto):
    return getattr, (self.__class__, self._name_)
