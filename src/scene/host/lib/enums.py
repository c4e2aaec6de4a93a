import enum


class Facing(enum.IntEnum):
    X_POS = X_MAX = 0
    Y_POS = Y_MAX = 1
    X_NEG = X_MIN = 2
    Y_NEG = Y_MIN = 3


class Support(enum.IntEnum):
    STANDING = 0
    MOUNTED = WALL_MOUNTED = 1
    FLOATING = 2
